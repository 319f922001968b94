//! The trims are those of Table 5.1 as reproduced by physics.md §8 ("this aircraft"), to 1 %.

use flexible_aircraft::simulation::{Fidelity, Settings, Simulation};

use crate::support::{eight_symmetric, jet, up};

/// A row of physics.md §8: 127 m/s, 7620 m, 8 symmetric modes.
struct Row {
    fidelity: Fidelity,
    stiffness_scale: f64,
    wing_tip: f64,
    htail_tip: f64,
    pitch: f64,
    elevator: f64,
}

const TABLE: [Row; 5] = [
    Row {
        fidelity: Fidelity::Exact,
        stiffness_scale: 1.0,
        wing_tip: 0.5577,
        htail_tip: 0.0244,
        pitch: 0.13818,
        elevator: -0.2353,
    },
    Row {
        fidelity: Fidelity::Exact,
        stiffness_scale: 0.1,
        wing_tip: 2.831,
        htail_tip: 0.1594,
        pitch: 0.13632,
        elevator: -0.1798,
    },
    Row {
        fidelity: Fidelity::ConsistentlyLinearised,
        stiffness_scale: 0.1,
        wing_tip: 4.992,
        htail_tip: 0.2904,
        pitch: 0.15807,
        elevator: -0.2754,
    },
    Row {
        fidelity: Fidelity::Inconsistent,
        stiffness_scale: 0.1,
        wing_tip: 4.986,
        htail_tip: 0.2878,
        pitch: 0.15813,
        elevator: -0.2812,
    },
    Row {
        fidelity: Fidelity::RuthlesslyLinearised,
        stiffness_scale: 0.1,
        wing_tip: 5.009,
        htail_tip: 0.2490,
        pitch: 0.15934,
        elevator: -0.3735,
    },
];

fn assert_percent(name: &str, found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 0.01, "{name}: {found}, expected {expected}");
}

#[test]
fn deflections_pitch_and_elevator_of_the_trimmed_jet_are_those_of_table_5_1() {
    for row in TABLE {
        let settings =
            Settings { fidelity: row.fidelity, stiffness_scale: row.stiffness_scale, ..eight_symmetric() };
        let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
        let trim = *flight.trim();
        let outputs = flight.outputs();
        let name = |quantity| format!("{:?} × {}: {quantity}", row.fidelity, row.stiffness_scale);
        assert_percent(&name("wing tip"), up(outputs, "wing_tip_right"), row.wing_tip);
        assert_percent(&name("left wing tip"), up(outputs, "wing_tip_left"), row.wing_tip);
        assert_percent(&name("h-tail tip"), up(outputs, "htail_tip_right"), row.htail_tip);
        assert_percent(&name("pitch"), trim.pitch, row.pitch);
        assert_percent(&name("elevator"), trim.elevator, row.elevator);
    }
}

#[test]
fn the_nominal_exact_jet_trims_at_the_thrust_of_physics_md() {
    // physics.md §8: thrust 23 965 N per engine.
    let flight = Simulation::new(jet(), &eight_symmetric(), 0.0).unwrap();
    assert_percent("thrust", flight.trim().thrust, 23_965.0);
}

#[test]
fn every_level_inflow_and_stiffness_has_a_trim_and_the_inflow_does_not_change_it() {
    for fidelity in Fidelity::ALL {
        for stiffness_scale in [0.1, 1.0, 10.0] {
            let trim = |inflow_states| {
                let settings = Settings { fidelity, stiffness_scale, inflow_states, ..Settings::default() };
                *Simulation::new(jet(), &settings, 0.0).unwrap().trim()
            };
            let steady = trim(0);
            for inflow_states in 1..=8 {
                assert_eq!(
                    trim(inflow_states),
                    steady,
                    "{fidelity:?} × {stiffness_scale}, N = {inflow_states}"
                );
            }
        }
    }
}

#[test]
fn a_speed_at_which_nothing_balances_is_refused_with_what_remained() {
    let settings = Settings { airspeed: 3.0, ..Settings::default() };
    let message = Simulation::new(jet(), &settings, 0.0).unwrap_err().to_string();
    assert!(message.contains("no steady level flight found at 3 m/s"), "{message}");
    assert!(message.contains("imbalance"), "{message}");
}

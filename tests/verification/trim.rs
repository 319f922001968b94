//! The trims are those of Table 5.1 as independent implementations found them for the shipped jet.
//!
//! [theory: thesis-runs.trims; thesis table 5.1]

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;

use crate::support::{eight_symmetric, jet, up};

use super::record::Record;

/// A row of [theory: thesis-runs.trims]: 127 m/s, 7620 m, 8 symmetric modes.
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
        elevator: -0.2343,
    },
    Row {
        fidelity: Fidelity::Exact,
        stiffness_scale: 0.1,
        wing_tip: 2.831,
        htail_tip: 0.1597,
        pitch: 0.13632,
        elevator: -0.1786,
    },
    Row {
        fidelity: Fidelity::ConsistentlyLinearised,
        stiffness_scale: 0.1,
        wing_tip: 4.992,
        htail_tip: 0.2908,
        pitch: 0.15806,
        elevator: -0.2735,
    },
    Row {
        fidelity: Fidelity::Inconsistent,
        stiffness_scale: 0.1,
        wing_tip: 4.986,
        htail_tip: 0.2883,
        pitch: 0.15812,
        elevator: -0.2793,
    },
    Row {
        fidelity: Fidelity::RuthlesslyLinearised,
        stiffness_scale: 0.1,
        wing_tip: 5.009,
        htail_tip: 0.2497,
        pitch: 0.15932,
        elevator: -0.3709,
    },
];

#[test]
fn deflections_pitch_and_elevator_of_the_trimmed_jet_are_those_of_table_5_1() {
    let mut record = Record::new(
        "trim",
        "Steady level flight at 127 m/s, 7620 m, 8 symmetric modes: deflections (m), pitch and elevator (rad), thrust (N)",
        "[theory: thesis-runs.trims], which reproduces Table 5.1 of the thesis; the tolerance is 0.6 units of the last digit, of 2.831 m and the like",
    );
    for row in TABLE {
        let settings = Settings::from(PlantSettings {
            fidelity: row.fidelity,
            stiffness_scale: row.stiffness_scale,
            ..eight_symmetric().plant
        });
        let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
        let trim = *flight.trim();
        let outputs = flight.outputs();
        let name = |quantity| format!("{:?} × {}: {quantity}", row.fidelity, row.stiffness_scale);
        record.absolute(&name("wing tip"), row.wing_tip, 6e-4, up(outputs, "wing_tip_right"));
        record.absolute(&name("left wing tip"), row.wing_tip, 6e-4, up(outputs, "wing_tip_left"));
        record.absolute(&name("h-tail tip"), row.htail_tip, 6e-5, up(outputs, "htail_tip_right"));
        record.absolute(&name("pitch"), row.pitch, 6e-6, trim.pitch);
        record.absolute(&name("elevator"), row.elevator, 6e-5, trim.pitch_control);
    }
    let flight = Simulation::new(jet(), &eight_symmetric(), 0.0).unwrap();
    record.relative("Exact × 1: thrust per engine", 23_716.0, 1e-4, flight.trim().thrust);
    record.finish();
}

#[test]
fn every_level_inflow_and_stiffness_has_a_trim_and_the_inflow_does_not_change_it() {
    for fidelity in Fidelity::ALL {
        for stiffness_scale in [0.1, 1.0, 10.0] {
            let trim = |inflow_states| {
                let settings = Settings::from(PlantSettings {
                    fidelity,
                    stiffness_scale,
                    inflow_states,
                    ..PlantSettings::of(&jet())
                });
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
    let settings = Settings::from(PlantSettings { airspeed: 3.0, ..PlantSettings::of(&jet()) });
    let message = Simulation::new(jet(), &settings, 0.0).unwrap_err().to_string();
    assert!(message.contains("no steady level flight found at 3 m/s"), "{message}");
    assert!(message.contains("imbalance"), "{message}");
    assert!(
        message.contains("too slow: at 15° of incidence the wings carry 0.1 % of the weight"),
        "{message}"
    );
}

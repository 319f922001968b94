//! Symmetric motion: half the aircraft flies for the whole until something acts on one side alone.

use std::sync::Arc;

use flexible_aircraft::aircraft::Support;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};
use flexible_aircraft::structure::ReducedModel;

use crate::support::{AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, fly, jet, two_three_one_one, up};

use super::record::Record;

/// An aileron so small that it moves nothing, but not zero: the whole aircraft flies.
const NOTHING: f64 = 1e-14;

/// A symmetric manoeuvre, flown by half the aircraft or by all of it.
fn manoeuvre(settings: &Settings, aileron: f64) -> Vec<Outputs> {
    fly(settings, 6.0, two_three_one_one, |inputs, angle| {
        (inputs.controls[ELEVATOR], inputs.controls[AILERON]) = (angle, aileron);
        (inputs.controls[AILERON_SYMMETRIC], inputs.wind.z) = (-angle, 20.0 * angle);
    })
}

#[test]
fn half_the_aircraft_flies_as_the_whole_one_does() {
    let mut record = Record::new(
        "half",
        "A symmetric manoeuvre flown by half the aircraft and by all of it: largest differences over 6 s at the tolerance \
         1e-8, heading 1 rad",
        "the whole aircraft, kept from using its symmetry by an aileron of 1e-14 rad",
    );
    // The bounds are about ten times the most that any level shows: 4e-14, 1.2e-11, 7e-13, 3e-12, 5e-12.
    for fidelity in Fidelity::ALL {
        let settings = Settings {
            tolerance: 1e-8,
            ..PlantSettings { fidelity, stiffness_scale: 0.3, heading: 1.0, ..PlantSettings::of(&jet()) }
                .into()
        };
        let (half, whole) = (manoeuvre(&settings, 0.0), manoeuvre(&settings, NOTHING));
        let largest = |difference: fn(&Outputs, &Outputs) -> f64| {
            half.iter()
                .zip(&whole)
                .fold(0.0_f64, |largest, (half, whole)| largest.max(difference(half, whole)))
        };
        record.rounding(
            &format!("{fidelity:?}: pitch, rad"),
            5e-13,
            largest(|half, whole| (half.attitude.y - whole.attitude.y).abs()),
        );
        record.rounding(
            &format!("{fidelity:?}: position, m"),
            1e-10,
            largest(|half, whole| (half.position - whole.position).norm()),
        );
        record.rounding(
            &format!("{fidelity:?}: left wing tip, m"),
            5e-12,
            largest(|half, whole| (up(half, "wing_tip_left") - up(whole, "wing_tip_left")).abs()),
        );
        record.rounding(
            &format!("{fidelity:?}: load factor"),
            3e-11,
            largest(|half, whole| (half.load_factor - whole.load_factor).norm()),
        );
        let aside = |outputs: &Outputs| outputs.velocity.y.abs() + outputs.attitude.x.abs();
        record.rounding(
            &format!("{fidelity:?}: sideways, m/s and rad"),
            5e-11,
            whole.iter().map(aside).fold(0.0, f64::max),
        );
        assert!(
            half.iter().all(|outputs| aside(outputs) == 0.0),
            "{fidelity:?}: half an aircraft goes straight"
        );
        assert!(whole.iter().any(|outputs| aside(outputs) > 0.0), "{fidelity:?}: the whole aircraft flew");
    }
    record.finish();
}

fn set(flight: &mut Simulation, change: impl FnOnce(&mut Inputs)) {
    let mut inputs = Inputs::zero(&jet());
    change(&mut inputs);
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
}

#[test]
fn whatever_acts_on_one_side_alone_makes_the_whole_aircraft_fly() {
    let flies_as_half = |change: fn(&mut Inputs)| {
        let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
        set(&mut flight, change);
        flight.advance_to(0.02).unwrap();
        flight.is_symmetric()
    };
    assert!(flies_as_half(|inputs| inputs.controls[ELEVATOR] = 0.01));
    assert!(flies_as_half(|inputs| inputs.controls[AILERON_SYMMETRIC] = 0.01));
    assert!(flies_as_half(|inputs| inputs.thrust.fill(500.0)));
    assert!(flies_as_half(|inputs| (inputs.wind.x, inputs.wind.z) = (2.0, -1.0)));
    assert!(!flies_as_half(|inputs| inputs.controls[AILERON] = 0.01));
    assert!(!flies_as_half(|inputs| inputs.controls[RUDDER] = 0.01));
    assert!(!flies_as_half(|inputs| inputs.thrust[1] = 500.0));
    assert!(!flies_as_half(|inputs| inputs.wind.y = 1.0));
}

#[test]
fn reading_what_one_side_would_do_changes_nothing_of_what_follows() {
    let flight = |looks: bool| {
        let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
        flight.advance_to(0.015).unwrap();
        set(&mut flight, |inputs| inputs.controls[AILERON] = 0.1);
        if looks {
            let rolling = flight.outputs().sensors.clone();
            assert_ne!(rolling[0].specific_force.z, rolling[1].specific_force.z);
        }
        set(&mut flight, |inputs| inputs.controls[ELEVATOR] = 0.02);
        flight.advance_to(0.1).unwrap();
        assert!(flight.is_symmetric());
        flight.outputs().clone()
    };
    assert_eq!(flight(true), flight(false));
}

#[test]
fn the_whole_aircraft_goes_on_where_the_half_stood() {
    let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
    set(&mut flight, |inputs| (inputs.controls[ELEVATOR], inputs.wind.z) = (-0.03, -2.0));
    flight.advance_to(0.777).unwrap();
    let half = flight.outputs().clone();
    set(&mut flight, |inputs| {
        (inputs.controls[ELEVATOR], inputs.wind.z, inputs.controls[AILERON]) = (-0.03, -2.0, NOTHING);
    });
    let seen = flight.outputs().clone();
    flight.advance_to(0.777 + 1e-5).unwrap();
    assert!(!flight.is_symmetric());
    let whole = flight.outputs().clone();
    let distances = |outputs: &Outputs| {
        let rates = half.modal_q_dot.iter().zip(&outputs.modal_q_dot).map(|(a, b)| (a - b).abs());
        [
            (outputs.load_factor - half.load_factor).norm(),
            (up(outputs, "wing_tip_left") - up(&half, "wing_tip_left")).abs(),
            rates.fold(0.0, f64::max),
        ]
    };
    // Found: 2.4e-16, 0, 0; and after 10 µs of flight 8.7e-6, 1.4e-6 m, 6.0e-4.
    for (outputs, bounds) in [(&seen, [5e-15; 3]), (&whole, [1e-4, 1.5e-5, 6e-3])] {
        let found = distances(outputs);
        assert!(found.iter().zip(bounds).all(|(found, bound)| *found < bound), "{found:?} of {bounds:?}");
    }
}

#[test]
fn a_snapshot_of_the_half_brings_it_back_when_the_whole_aircraft_flies() {
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        let settings = PlantSettings { fidelity, ..PlantSettings::of(&jet()) };
        bring_the_half_back(&settings.into(), true);
    }
    // Half and whole have as many states.
    let settings = Settings::from(PlantSettings {
        fidelity: Fidelity::Rigid,
        inflow_states: 0,
        ..PlantSettings::of(&jet())
    });
    bring_the_half_back(&settings, false);
}

/// `grows` says whether snapshots of the whole aircraft are longer.
fn bring_the_half_back(settings: &Settings, grows: bool) {
    let mut flight = Simulation::new(jet(), settings, 0.0).unwrap();
    flight.advance_to(0.505).unwrap();
    let mut bytes = Vec::new();
    flight.snapshot(&mut bytes);
    let go_on = |flight: &mut Simulation| {
        set(flight, |inputs| inputs.controls[ELEVATOR] = 0.02);
        flight.advance_to(1.0).unwrap();
        flight.outputs().clone()
    };
    let straight = go_on(&mut flight);
    set(&mut flight, |inputs| inputs.controls[RUDDER] = 0.05);
    flight.advance_to(1.505).unwrap();
    assert!(!flight.is_symmetric());
    assert_eq!(flight.snapshot_size() > bytes.len(), grows);
    flight.restore(&bytes).unwrap();
    assert!(flight.is_symmetric());
    assert_eq!(go_on(&mut flight), straight);
}

#[test]
fn half_of_a_clamped_aircraft_swings_as_the_whole_one_does() {
    [Fidelity::Exact, Fidelity::GeometricallyExact]
        .into_iter()
        .for_each(half_of_a_clamped_aircraft_swings_at);
}

fn half_of_a_clamped_aircraft_swings_at(fidelity: Fidelity) {
    let model = Arc::new(ReducedModel { support: Support::Clamped, ..(*jet()).clone() });
    let settings = Settings {
        tolerance: 1e-8,
        ..PlantSettings { fidelity, airspeed: 60.0, heading: 2.0, ..PlantSettings::of(&jet()) }.into()
    };
    let swing = |aileron: f64| {
        let mut flight = Simulation::new(Arc::clone(&model), &settings, 0.0).unwrap();
        set(&mut flight, |inputs| (inputs.wind.z, inputs.controls[AILERON]) = (-3.0, aileron));
        flight.advance_to(1.0).unwrap();
        assert_eq!(flight.is_symmetric(), aileron == 0.0);
        flight.outputs().clone()
    };
    let (half, whole) = (swing(0.0), swing(NOTHING));
    for tip in ["wing_tip_left", "htail_tip_right"] {
        // Found: 4.0e-15 m, of a swing of 0.075 m.
        let difference = (up(&half, tip) - up(&whole, tip)).abs();
        assert!(difference < 4e-14 && up(&half, tip).abs() > 1e-3, "{fidelity:?}, {tip}: {difference:e}");
    }
    assert!((half.attitude - whole.attitude).norm() < 1e-15 && (half.attitude.z - 2.0).abs() < 1e-15);
}

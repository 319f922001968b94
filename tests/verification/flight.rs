//! Flights of the whole jet: symmetry, steadiness, determinism, wind.

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{InputReference, Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};
use nalgebra::Vector3;

use crate::support::{
    AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, angles, doublet, fly, jet, two_three_one_one, up,
};

use super::record::Record;

/// One level of each kind of kinematics.
const KINDS: [Fidelity; 2] = [Fidelity::Exact, Fidelity::GeometricallyExact];

#[test]
fn a_mirrored_rudder_gives_the_mirrored_flight() {
    let mut record = Record::new(
        "mirror",
        "A mirrored rudder doublet flies the mirrored flight: largest difference over 8 s, one-tenth stiffness",
        "symmetry of the aircraft",
    );
    // About ten times what is found.
    let positions = [1e-11, 1e-10];
    for (fidelity, position_bound) in KINDS.into_iter().zip(positions) {
        let flight = |sign: f64| {
            let plant = PlantSettings { fidelity, stiffness_scale: 0.1, ..PlantSettings::of(&jet()) };
            fly(&plant.into(), 8.0, doublet, |inputs, angle| inputs.controls[RUDDER] = sign * angle)
        };
        let [velocity, rate, attitude, deflection, position] = unlike_images(&flight(1.0), &flight(-1.0));
        record.rounding(&format!("{fidelity:?}: velocity, m/s"), 1e-12, velocity);
        record.rounding(&format!("{fidelity:?}: angular velocity, rad/s"), 5e-14, rate);
        record.rounding(&format!("{fidelity:?}: attitude, rad"), 2e-13, attitude);
        record.rounding(&format!("{fidelity:?}: wing-tip deflection, m"), 2e-13, deflection);
        record.rounding(&format!("{fidelity:?}: position, m"), position_bound, position);
    }
    record.finish();
}

/// How far two flights are from being each other's images: velocity, angular velocity, attitude, wing tips, position.
fn unlike_images(right: &[Outputs], left: &[Outputs]) -> [f64; 5] {
    let polar = |v: Vector3<f64>| Vector3::new(v.x, -v.y, v.z);
    let axial = |v: Vector3<f64>| Vector3::new(-v.x, v.y, -v.z);
    let mut largest = [0.0_f64; 5];
    for (right, left) in right.iter().zip(left) {
        let differences = [
            (right.velocity - polar(left.velocity)).norm(),
            (right.rate - axial(left.rate)).norm(),
            (right.attitude - axial(left.attitude)).norm(),
            (up(right, "wing_tip_right") - up(left, "wing_tip_left")).abs(),
            (right.position - polar(left.position)).norm(),
        ];
        largest = std::array::from_fn(|i| largest[i].max(differences[i]));
    }
    largest
}

#[test]
fn both_ailerons_down_bend_both_wings_up_alike() {
    let settings = Settings::of(&jet());
    let neutral = Simulation::new(jet(), &settings, 0.0).unwrap().outputs().clone();
    let lifted = fly(&settings, 0.5, |_| 0.05, |inputs, angle| inputs.controls[AILERON_SYMMETRIC] = angle);
    let last = lifted.last().unwrap();
    for tip in ["wing_tip_right", "wing_tip_left"] {
        assert!(up(last, tip) > up(&neutral, tip), "{tip}");
    }
    assert!(
        last.attitude.x.abs() < 1e-9 && (up(last, "wing_tip_right") - up(last, "wing_tip_left")).abs() < 1e-9
    );
}

#[test]
fn a_rudder_to_the_right_yaws_and_an_aileron_to_the_right_rolls_right() {
    let settings = Settings::of(&jet());
    let yawed = fly(&settings, 2.0, |_| 0.02, |inputs, angle| inputs.controls[RUDDER] = angle);
    assert!(yawed[199].attitude.z > 1e-3, "{:?}", yawed[199].attitude);
    let rolled = fly(&settings, 2.0, |_| 0.02, |inputs, angle| inputs.controls[AILERON] = angle);
    assert!(rolled[199].attitude.x > 1e-3, "{:?}", rolled[199].attitude);
    let pitched = fly(&settings, 2.0, |_| 0.02, |inputs, angle| inputs.controls[ELEVATOR] = angle);
    assert!(pitched[199].attitude.y < pitched[0].attitude.y - 1e-3, "{:?}", pitched[199].attitude);
}

#[test]
fn without_input_every_level_stays_trimmed_for_a_minute() {
    let mut record = Record::new(
        "steadiness",
        "Without input every level stays trimmed for a minute: changes of pitch (rad), load factor and distance (m)",
        "steady level flight is a solution",
    );
    for fidelity in Fidelity::ALL {
        let settings = Settings::from(PlantSettings { fidelity, ..PlantSettings::of(&jet()) });
        let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
        let pitch = flight.trim().pitch;
        flight.advance_to(60.0).unwrap();
        let outputs = flight.outputs();
        record.rounding(&format!("{fidelity:?}: pitch"), 1e-14, outputs.attitude.y - pitch);
        let load_factor = outputs.load_factor.z - libm::cos(pitch);
        record.rounding(&format!("{fidelity:?}: load factor"), 1e-13, load_factor);
        record.rounding(&format!("{fidelity:?}: distance"), 1e-7, outputs.position.x - 60.0 * 127.0);
    }
    record.finish();
}

#[test]
fn absolute_inputs_at_the_trim_values_are_the_trimmed_flight() {
    let settings = Settings { input_reference: InputReference::Absolute, ..Settings::of(&jet()) };
    let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
    let trim = *flight.trim();
    let mut inputs = Inputs::zero(&jet());
    inputs.controls[ELEVATOR] = trim.pitch_control;
    inputs.thrust.fill(trim.thrust);
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    flight.advance_to(10.0).unwrap();
    assert!((flight.outputs().attitude.y - trim.pitch).abs() < 1e-9);
}

#[test]
fn the_heading_only_turns_the_flight() {
    let mut record = Record::new(
        "heading",
        "A heading of 2 rad only turns the flight: largest difference over 4 s of an elevator 2-3-1-1",
        "isotropy",
    );
    let (sin, cos) = libm::sincos(2.0);
    for fidelity in KINDS {
        let [north, turned] = [0.0, 2.0].map(|heading| {
            let plant = PlantSettings { fidelity, heading, ..PlantSettings::of(&jet()) };
            fly(&plant.into(), 4.0, two_three_one_one, |inputs, angle| inputs.controls[ELEVATOR] = angle)
        });
        let (mut position, mut velocity) = (0.0_f64, 0.0_f64);
        for (north, turned) in north.iter().zip(&turned) {
            let back = Vector3::new(
                cos * turned.position.x + sin * turned.position.y,
                cos * turned.position.y - sin * turned.position.x,
                turned.position.z,
            );
            position = position.max((back - north.position).norm());
            velocity = velocity.max((turned.velocity - north.velocity).norm());
        }
        record.rounding(&format!("{fidelity:?}: position, m"), 1e-12, position);
        record.rounding(&format!("{fidelity:?}: velocity, m/s"), 1e-12, velocity);
    }
    record.finish();
}

#[test]
fn one_long_step_and_many_short_ones_give_the_same_bits() {
    let flight = |fidelity: Fidelity, steps_per_centisecond: u32| {
        let settings = Settings::from(PlantSettings { fidelity, ..PlantSettings::of(&jet()) });
        let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
        let (mut inputs, rates) = (Inputs::zero(&jet()), Inputs::zero(&jet()));
        for centisecond in 0..300 {
            let time = f64::from(centisecond) * 0.01;
            inputs.controls[ELEVATOR] = two_three_one_one(time);
            for step in 1..=steps_per_centisecond {
                flight.set_inputs(&inputs, &rates);
                flight.advance_to(time + 0.01 * f64::from(step) / f64::from(steps_per_centisecond)).unwrap();
            }
        }
        flight.outputs().clone()
    };
    for fidelity in KINDS {
        let reference = flight(fidelity, 1);
        assert_eq!(flight(fidelity, 10), reference);
        assert_eq!(flight(fidelity, 3), reference);
    }
}

#[test]
fn a_restored_snapshot_continues_with_the_same_bits_and_damage_is_refused() {
    KINDS.into_iter().for_each(a_restored_snapshot_continues_at);
}

fn a_restored_snapshot_continues_at(fidelity: Fidelity) {
    let settings = Settings::from(PlantSettings { fidelity, ..PlantSettings::of(&jet()) });
    let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
    let mut inputs = Inputs::zero(&jet());
    inputs.controls[RUDDER] = 0.02;
    inputs.wind = Vector3::new(1.0, 2.0, -3.0);
    flight.set_inputs(&inputs, &angles(&jet(), &[(RUDDER, 0.001)]));
    flight.advance_to(1.2345).unwrap();
    let mut bytes = Vec::new();
    flight.snapshot(&mut bytes);
    assert_eq!(bytes.len(), flight.snapshot_size());

    let mut other = Simulation::new(jet(), &settings, 0.0).unwrap();
    other.restore(&bytes).unwrap();
    for flight in [&mut flight, &mut other] {
        flight.advance_to(2.5).unwrap();
    }
    assert_eq!(flight.outputs(), other.outputs());

    let before = other.outputs().clone();
    for place in [3, 20, 26, 100, bytes.len() - 1] {
        let mut damaged = bytes.clone();
        damaged[place] ^= 1;
        assert!(other.restore(&damaged).is_err(), "byte {place}");
    }
    assert!(other.restore(&bytes[..bytes.len() - 1]).is_err());
    let mut stiffer = Simulation::new(
        jet(),
        &Settings::from(PlantSettings { stiffness_scale: 2.0, ..settings.plant }),
        0.0,
    )
    .unwrap();
    assert!(stiffer.restore(&bytes).unwrap_err().to_string().contains("other parameters"));
    assert_eq!(*other.outputs(), before);
}

#[test]
fn a_steady_wind_carries_the_trimmed_flight_along() {
    // The wind builds up so slowly that the aircraft follows it.
    let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
    let mut inputs = Inputs::zero(&jet());
    inputs.wind.z = -5.0;
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    let hit = flight.outputs().clone();
    assert!((hit.air.angle_of_attack - hit.attitude.y - libm::atan(5.0 / 127.0)).abs() < 1e-3);
    flight.advance_to(0.3).unwrap();
    // An updraught lifts: more load, wings bent further up.
    let lifted = flight.outputs().clone();
    assert!(
        lifted.load_factor.z > hit.load_factor.z && lifted.load_factor.z > 1.05,
        "{}",
        lifted.load_factor
    );
    assert!(up(&lifted, "wing_tip_right") > up(&hit, "wing_tip_right"));
}

#[test]
fn leaving_the_models_validity_is_an_error_and_leaves_the_flight_as_it_was() {
    let mut flight = Simulation::new(jet(), &Settings::of(&jet()), 0.0).unwrap();
    let mut inputs = Inputs::zero(&jet());
    flight.advance_to(0.5).unwrap();
    inputs.wind.x = 300.0;
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    let before: Outputs = flight.outputs().clone();
    let snapshot = |flight: &Simulation| {
        let mut bytes = Vec::new();
        flight.snapshot(&mut bytes);
        bytes
    };
    let bytes = snapshot(&flight);
    // Within the present cell of time, and beyond it.
    for end in [0.505, 0.51, 1.0] {
        let message = flight.advance_to(end).unwrap_err().to_string();
        assert!(message.contains("from behind"), "{message}");
        assert_eq!(flight.time(), 0.5);
        assert_eq!(*flight.outputs(), before);
        assert_eq!(snapshot(&flight), bytes);
    }
    flight.set_inputs(&Inputs::zero(&jet()), &Inputs::zero(&jet()));
    flight.advance_to(1.0).unwrap();
    assert!(flight.is_symmetric());

    // Where the whole aircraft takes over in the refused step, and where the step begins inside a cell.
    inputs.controls[AILERON] = 0.05;
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    let bytes = snapshot(&flight);
    flight.advance_to(1.01).unwrap_err();
    assert!(flight.is_symmetric());
    assert_eq!(snapshot(&flight), bytes);
    let mut rates = Inputs::zero(&jet());
    rates.wind.x = 3e4;
    flight.set_inputs(&Inputs::zero(&jet()), &rates);
    flight.advance_to(1.001).unwrap();
    let bytes = snapshot(&flight);
    flight.advance_to(1.01).unwrap_err();
    assert_eq!(snapshot(&flight), bytes);
}

#[test]
fn every_number_of_inflow_states_flies_and_they_converge() {
    KINDS.into_iter().for_each(every_number_of_inflow_states_flies_at);
}

fn every_number_of_inflow_states_flies_at(fidelity: Fidelity) {
    let flight = |inflow_states| {
        let settings = Settings::from(PlantSettings { fidelity, inflow_states, ..PlantSettings::of(&jet()) });
        let history =
            fly(&settings, 4.0, two_three_one_one, |inputs, angle| inputs.controls[ELEVATOR] = angle);
        history.iter().map(|outputs| outputs.load_factor.z).fold(0.0, f64::max)
    };
    let peaks: Vec<f64> = (0..=8).map(flight).collect();
    let spread = |range: std::ops::Range<usize>| {
        let range = &peaks[range];
        range.iter().copied().fold(0.0, f64::max) - range.iter().copied().fold(f64::INFINITY, f64::min)
    };
    assert!(spread(0..9) > 1e-4, "unsteadiness changes nothing: {peaks:?}");
    assert!(spread(5..9) < spread(0..9) / 2.0, "{peaks:?}");
}

#[test]
fn pitch_wing_tip_and_load_factor_are_as_close_as_the_tolerance_asks() {
    KINDS.into_iter().for_each(flights_are_as_close_as_the_tolerance_asks_at);
}

fn flights_are_as_close_as_the_tolerance_asks_at(fidelity: Fidelity) {
    let flight = |tolerance| {
        let plant = PlantSettings { fidelity, ..PlantSettings::of(&jet()) };
        let settings = Settings { tolerance, ..plant.into() };
        fly(&settings, 5.0, two_three_one_one, |inputs, angle| inputs.controls[ELEVATOR] = angle)
    };
    let tight = flight(1e-10);
    let peak = |quantity: fn(&Outputs) -> f64| {
        tight.iter().fold(0.0_f64, |peak, outputs| peak.max(quantity(outputs).abs()))
    };
    let quantities: [fn(&Outputs) -> f64; 3] =
        [|o| o.attitude.y, |o| up(o, "wing_tip_right"), |o| o.load_factor.z];
    for tolerance in [1e-5, 1e-6, 1e-7] {
        for (loose, tight) in flight(tolerance).iter().zip(&tight) {
            for quantity in quantities {
                let error = (quantity(loose) - quantity(tight)).abs() / peak(quantity);
                assert!(error < tolerance, "tolerance {tolerance:e}: {error:e}");
            }
        }
    }
}

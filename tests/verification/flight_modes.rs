//! The modes of the jet in flight by their names, and its flying qualities, against an independent computation
//! [theory: stability.modes, linearisation.load-factor-slope].

use std::f64::consts::PI;

use flexible_aircraft::plant::{ConditionSettings, ManoeuvreChoice, Plant, PlantSettings};
use flexible_aircraft::stability::FlightModes;
use flexible_aircraft::{Aircraft, Inflow, flight_modes};

use crate::support::jet;

use super::linear_model::{self, SOURCE, level, linearised, settings};
use super::record::Record;

fn modes(stiffness_scale: f64, condition: ConditionSettings, inflow: Inflow) -> FlightModes {
    flight_modes(jet(), &settings(stiffness_scale, condition), inflow).unwrap()
}

fn turn(bank_angle: f64) -> ConditionSettings {
    ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, bank_angle, ..level() }
}

/// Of rigid motion, in symmetric flight and carried into turns.
#[test]
fn modes_have_the_names_of_the_independent_computation() {
    let mut record = Record::new(
        "flight-modes",
        "Modes of the jet by their names, 127 m/s, 7620 m, twelve modes, 1/s (to the digits of the reference)",
        SOURCE,
    );
    let cases = [
        ("nominal, N = 5", modes(1.0, level(), Inflow::Kept), linear_model::NOMINAL, 1.2e-5),
        ("nominal, N = 0", modes(1.0, level(), Inflow::Steady), linear_model::NOMINAL_STEADY, 1.2e-5),
        ("tenth, N = 5", modes(0.1, level(), Inflow::Kept), linear_model::TENTH, 1.2e-5),
        ("tenth, N = 0", modes(0.1, level(), Inflow::Steady), linear_model::TENTH_STEADY, 1.2e-5),
        ("nominal, N = 5, turn φ 30°", modes(1.0, turn(PI / 6.0), Inflow::Kept), linear_model::TURN, 6e-5),
    ];
    for (case, modes, roots, printed) in cases {
        for &(name, re, im) in roots.iter().filter(|(name, ..)| !name.contains("symmetric")) {
            let mode = modes.named(name).unwrap_or_else(|| panic!("{case}: no {name}"));
            assert!(!mode.is_quasi_steady, "{case}, {name}");
            // The roll of the first column has four digits.
            let tolerance = if re == -3.2610 { 6e-5 } else { printed };
            let found = mode.eigenvalue();
            record.absolute(&format!("{case}, {name}: real part"), re, tolerance, found.re);
            record.absolute(&format!("{case}, {name}: imaginary part"), im, tolerance, found.im);
        }
    }
    record.finish();
}

#[test]
fn elastic_modes_come_by_frequency_with_their_family() {
    let modes = modes(1.0, level(), Inflow::Kept);
    let is = |name: &str, aside: bool, frequency: f64| {
        let mode = modes.named(name).unwrap();
        let share = mode.share_aside.unwrap();
        assert!(if aside { share > 1.0 - 1e-6 } else { share < 1e-6 }, "{name}: {share}");
        assert!((mode.eigenvalue().im - frequency).abs() < 1e-4, "{name}: {:?}", mode.eigenvalue());
    };
    // The reference tables of `linear_model`.
    is("elastic 1", false, 15.5731);
    is("elastic 2", true, 26.09579);
    is("elastic 3", false, 26.63184);
    is("elastic 4", true, 28.09516);
    is("elastic 5", false, 37.13746);
    assert_eq!(modes.modes.iter().filter(|mode| mode.is_quasi_steady).count(), 0);
}

/// The prototype has the roll at −6.629 with the inflow residualised, and finds it lost among the wake's roots; at 127 m/s and 7620 m it is not.
#[test]
fn a_mode_that_is_lost_among_the_wakes_is_given_with_an_inflow_that_follows_at_once() {
    let low = PlantSettings { airspeed: 150.0, altitude: 3000.0, ..settings(1.0, level()).plant };
    let low = flight_modes(jet(), &low.into(), Inflow::Kept).unwrap();
    let roll = low.named("roll").unwrap();
    assert!(roll.is_quasi_steady && (roll.eigenvalue().re + 6.629).abs() < 5e-4, "{roll:?}");
    let lost: Vec<String> =
        low.modes.iter().filter(|mode| mode.is_quasi_steady).map(|mode| mode.name.to_string()).collect();
    assert_eq!(lost, ["roll"]);
}

/// A wing so light that the air's own mass counts: with an inflow that follows at once its heave would grow at 4 1/s, which it does not.
#[test]
fn modes_of_a_light_aircraft_are_its_own_and_have_names_of_their_own_at_every_airspeed() {
    let wing = Aircraft::read("tests/data/flying-wing.toml").unwrap().reduce().unwrap();
    let mut before: Option<FlightModes> = None;
    for airspeed in [11.6, 12.1, 12.6, 13.1, 13.6] {
        let settings = PlantSettings { airspeed, ..PlantSettings::of(&wing) };
        let plant = Plant::under(&wing, &settings).unwrap();
        let trim = plant.trim(&settings.trim_condition()).unwrap();
        let own = FlightModes::new(&plant.linearise(&trim));
        let modes = match before {
            Some(before) => own.named_after(&before),
            None => own,
        };
        let mut names: Vec<String> = modes.modes.iter().map(|mode| mode.name.to_string()).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), modes.modes.len(), "{airspeed} m/s: {names:?}");
        for mode in &modes.modes {
            let decays = mode.eigenvalue().re < 1e-3;
            assert!(decays || !mode.is_quasi_steady, "{airspeed} m/s, {}: {}", mode.name, mode.eigenvalue());
        }
        before = Some(modes);
    }
}

#[test]
fn an_elevator_gives_the_load_factor_of_the_independent_computation() {
    let mut record = Record::new(
        "flying-qualities",
        "n/α of the steady response to the elevator (1/rad) and the control anticipation parameter ω²/(n/α) of the jet, 127 m/s, 7620 m, \
         twelve modes, N = 5 (n/α to 2e-4 of it, as gains, CAP to the digits of the reference)",
        SOURCE,
    );
    for (name, stiffness, slope, anticipation) in
        [("nominal", 1.0, 7.1830, 0.2398), ("tenth", 0.1, 6.0862, 0.2667)]
    {
        let found = linearised(stiffness, Inflow::Kept).load_factor_slope("elevator").unwrap();
        record.absolute(&format!("{name}: n/α"), slope, 2e-4 * slope, found);
        let modes = modes(stiffness, level(), Inflow::Kept);
        let frequency = modes.named("short period").unwrap().eigenvalue().norm();
        record.absolute(&format!("{name}: CAP"), anticipation, 6e-5, frequency * frequency / found);
    }
    record.finish();
}

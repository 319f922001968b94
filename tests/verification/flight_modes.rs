//! The modes of the jet in flight by their names, and its flying qualities, against an independent computation
//! [theory: stability.modes, linearisation.load-factor-slope].

use std::f64::consts::PI;

use flexible_aircraft::plant::{ConditionSettings, ManoeuvreChoice, Plant, PlantSettings};
use flexible_aircraft::stability::{FlightMode, FlightModes};
use flexible_aircraft::{Aircraft, Inflow, flight_modes};

use crate::support::jet;

use super::linear_model::{self, FOUR_DIGITS, SOURCE, level, linearised, settings};
use super::record::Record;

fn modes(stiffness_scale: f64, condition: ConditionSettings, inflow: Inflow) -> FlightModes {
    flight_modes(jet(), &settings(stiffness_scale, condition), inflow).unwrap()
}

fn turn(bank_angle: f64) -> ConditionSettings {
    ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, bank_angle, ..level() }
}

/// The mode that the reference calls so: by its name, or the so manieth of a family by frequency.
fn called<'m>(modes: &'m FlightModes, name: &str) -> Option<&'m FlightMode> {
    let Some((family, number)) = name.split_once("symmetric ") else { return modes.named(name) };
    let elastic = modes.modes.iter().filter(|mode| mode.name.to_string().starts_with("elastic"));
    let of_family =
        elastic.filter(|mode| mode.share_aside.is_some_and(|share| (share > 0.5) == (family == "anti")));
    of_family.into_iter().nth(number.parse::<usize>().ok()? - 1)
}

/// In symmetric flight, and carried into a turn.
#[test]
fn modes_have_the_names_of_the_independent_computation() {
    let mut record = Record::new(
        "flight-modes",
        "Modes of the jet by their names, those of the structure by family and frequency, 127 m/s, 7620 m, twelve modes, 1/s (to the \
         digits of the reference)",
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
        assert!(modes.modes.iter().all(|mode| !mode.is_quasi_steady), "{case}");
        for &(name, re, im) in roots {
            let mode = called(&modes, name).unwrap_or_else(|| panic!("{case}: no {name}"));
            let tolerance = if FOUR_DIGITS.contains(&re) { 6e-5 } else { printed };
            let found = mode.eigenvalue();
            record.absolute(&format!("{case}, {name}: real part"), re, tolerance, found.re);
            record.absolute(&format!("{case}, {name}: imaginary part"), im, tolerance, found.im);
        }
    }
    record.finish();
}

#[test]
fn families_are_those_of_symmetric_flight_and_elastic_modes_are_numbered_by_frequency() {
    let modes = modes(1.0, level(), Inflow::Kept);
    for mode in &modes.modes {
        let share = mode.share_aside.unwrap();
        assert!(!(1e-6..=1.0 - 1e-6).contains(&share), "{}: {share}", mode.name);
    }
    // The reference tables of `linear_model`, both families together.
    for (name, frequency) in [("elastic 1", 15.5731), ("elastic 2", 26.09579), ("elastic 3", 26.63184)] {
        let found = modes.named(name).unwrap().eigenvalue().im;
        assert!((found - frequency).abs() < 1e-4, "{name}: {found}");
    }
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
         twelve modes, N = 5 (to the digits of the reference; n/α of a tenth to 5e-5 of it, for the reference's coarser differences)",
        SOURCE,
    );
    for (name, stiffness, slope, printed, anticipation) in
        [("nominal", 1.0, 7.1830, 6e-5, 0.2398), ("tenth", 0.1, 6.0862, 5e-5 * 6.0862, 0.2667)]
    {
        let linear = linearised(stiffness, Inflow::Kept);
        let found = linear.load_factor_slope("elevator").unwrap();
        record.absolute(&format!("{name}: n/α"), slope, printed, found);
        assert_eq!(linear.load_factor_slope("rudder"), None, "what moves nothing in the plane has no slope");
        let modes = modes(stiffness, level(), Inflow::Kept);
        let frequency = modes.named("short period").unwrap().eigenvalue().norm();
        record.absolute(&format!("{name}: CAP"), anticipation, 6e-5, frequency * frequency / found);
    }
    record.finish();
}

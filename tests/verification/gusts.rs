//! Gusts that the aircraft flies into, against an independent computation [theory: gusts.field, gusts.strip].

use std::f64::consts::FRAC_PI_2;

use flexible_aircraft::air::{GustSettings, GustShape, Spectrum, TurbulenceComponents, TurbulenceSettings};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};

use crate::support::jet;

use super::record::Record;

const SOURCE: &str = "prototype in numpy that shares nothing with this program; fourth-order steps of 5 ms";

/// An upward gust of 10 m/s that the nose meets after half a second.
pub fn gust(gradient: f64) -> GustSettings {
    GustSettings { shape: GustShape::OneMinusCosine, gradient, start: 0.5, ..GustSettings::default() }
}

/// The jet at a stiffness with twelve modes of both families before a gust and turbulence.
pub fn flight(stiffness_scale: f64, gust: GustSettings, turbulence: TurbulenceSettings) -> Settings {
    let plant = PlantSettings { fidelity: Fidelity::Exact, stiffness_scale, ..PlantSettings::of(&jet()) };
    Settings { gust, turbulence, ..plant.into() }
}

/// Steps of the independent computation, s.
pub const STEP: f64 = 0.005;

/// Outputs at every step without a hand on the controls.
fn hands_off(settings: &Settings, seconds: f64) -> Vec<Outputs> {
    let mut simulation = Simulation::new(jet(), settings, 0.0).unwrap();
    let mut history = vec![simulation.outputs().clone()];
    for step in 1..=(seconds / STEP).round() as usize {
        simulation.advance_to(step as f64 * STEP).unwrap();
        history.push(simulation.outputs().clone());
    }
    history
}

/// The value at a time, s.
fn at(flight: &[Outputs], time: f64, value: impl Fn(&Outputs) -> f64) -> f64 {
    value(&flight[(time / STEP).round() as usize])
}

/// Largest value with its time, and least value.
fn extremes(flight: &[Outputs], value: impl Fn(&Outputs) -> f64) -> [f64; 3] {
    let values: Vec<f64> = flight.iter().map(value).collect();
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let when = values.iter().position(|value| *value == largest).unwrap() as f64 * STEP;
    [largest, when, values.iter().copied().fold(f64::INFINITY, f64::min)]
}

#[test]
fn a_gust_loads_the_jet_as_the_independent_computation_has_it() {
    let mut record = Record::new(
        "gust",
        "1-cosine gusts upwards, 10 m/s, met by the nose after 0.5 s: load factor at O (1e-3 of the increment; time within a step)",
        SOURCE,
    );
    // Gradient, m; largest load factor, its time, s; least within 3 s: nominal, then one-tenth stiffness.
    let cases = [
        (1.0, 15.0, [1.42236, 0.802, 0.79705]),
        (1.0, 30.0, [1.52756, 0.888, 0.79579]),
        (1.0, 60.0, [1.47208, 1.057, 0.76586]),
        (1.0, 107.0, [1.42758, 1.398, 0.64373]),
        (0.1, 15.0, [1.34085, 0.868, 0.79616]),
        (0.1, 30.0, [1.42315, 0.986, 0.76067]),
        (0.1, 60.0, [1.47424, 1.145, 0.74018]),
        (0.1, 107.0, [1.39050, 1.399, 0.64131]),
    ];
    for (stiffness, gradient, [largest, when, least]) in cases {
        let flown = hands_off(&flight(stiffness, gust(gradient), TurbulenceSettings::default()), 3.0);
        let [found_largest, found_when, found_least] = extremes(&flown, |outputs| outputs.load_factor.z);
        let name = format!("stiffness {stiffness}, H = {gradient} m");
        record.absolute(&format!("{name}: largest"), largest, 5e-4, found_largest);
        record.absolute(&format!("{name}: at, s"), when, STEP, found_when);
        record.absolute(&format!("{name}: least"), least, 5e-4, found_least);
    }
    let flown = hands_off(&flight(1.0, gust(30.0), TurbulenceSettings::default()), 3.0);
    for (time, load_factor) in
        [(0.7, 1.08935), (0.9, 1.52398), (1.2, 0.85609), (2.0, 0.85083), (3.0, 0.97480)]
    {
        let found = at(&flown, time, |outputs| outputs.load_factor.z);
        record.absolute(&format!("nominal, H = 30 m, {time} s"), load_factor, 5e-4, found);
    }
    record.finish();
}

#[test]
fn a_gust_from_the_side_and_turbulence_fly_as_the_independent_computation_has_them() {
    let mut record = Record::new(
        "gust-other",
        "A gust to the right (H = 60 m) and vertical turbulence (von Kármán, 1.5 m/s, seed 1), nominal stiffness",
        SOURCE,
    );
    let lateral = GustSettings { direction: FRAC_PI_2, ..gust(60.0) };
    let flown = hands_off(&flight(1.0, lateral, TurbulenceSettings::default()), 4.0);
    let [largest, when, least] = extremes(&flown, |outputs| outputs.load_factor.y);
    record.absolute("lateral gust: largest load_factor.y", 0.0474, 5e-5, largest);
    record.absolute("lateral gust: at, s", 1.13, STEP, when);
    record.absolute("lateral gust: least load_factor.y", -0.0398, 5e-5, least);
    let [roll, when, _] = extremes(&flown[..500], |outputs| outputs.attitude.x);
    record.absolute("lateral gust: largest roll, rad", 0.0543, 5e-5, roll);
    record.absolute("lateral gust: at, s", 1.653, STEP, when);
    let turbulence = TurbulenceSettings {
        spectrum: Spectrum::VonKarman,
        intensity: 1.5,
        components: TurbulenceComponents::Vertical,
        ..TurbulenceSettings::default()
    };
    let flown = hands_off(&flight(1.0, GustSettings::default(), turbulence), 10.0);
    for (time, load_factor) in
        [(1.0, 1.02808), (2.0, 0.97262), (3.0, 1.00771), (5.0, 0.95288), (10.0, 1.09291)]
    {
        let found = at(&flown, time, |outputs| outputs.load_factor.z);
        record.absolute(&format!("turbulence: load factor at {time} s"), load_factor, 2e-4, found);
    }
    record.finish();
}

//! Gusts that the aircraft flies into, against an independent computation [theory: gusts.field, gusts.strip].

use std::f64::consts::FRAC_PI_2;

use std::sync::Arc;

use flexible_aircraft::air::{
    Extent, FrozenGust, GustSettings, GustShape, Spectrum, Track, TurbulenceComponents, TurbulenceSettings,
};
use flexible_aircraft::devices::{Actuator, EngineLag};
use flexible_aircraft::equations::{Controls, Fidelity};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Outputs, Plant, PlantSettings};
use flexible_aircraft::symmetry::Plants;
use nalgebra::Vector3;

use crate::support::encounter::Encounter;
use crate::support::{ELEVATOR, jet, random};

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

/// The jet before a gust of 0.2 m/s, integrated finely: it answers a fiftieth of what it would linearly to one of 10 m/s.
pub fn weak_gust() -> Settings {
    let weak = GustSettings { peak: 0.2, ..gust(30.0) };
    Settings { tolerance: 1e-9, ..flight(1.0, weak, TurbulenceSettings::default()) }
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
        let allowed = 1e-3 * (largest - 1.0);
        record.absolute(&format!("{name}: largest"), largest, allowed, found_largest);
        record.absolute(&format!("{name}: at, s"), when, STEP, found_when);
        record.absolute(&format!("{name}: least"), least, allowed, found_least);
    }
    let flown = hands_off(&flight(1.0, gust(30.0), TurbulenceSettings::default()), 3.0);
    for (time, load_factor) in
        [(0.7, 1.08935), (0.9, 1.52398), (1.2, 0.85609), (2.0, 0.85083), (3.0, 0.97480)]
    {
        let found = at(&flown, time, |outputs| outputs.load_factor.z);
        record.absolute(&format!("nominal, H = 30 m, {time} s"), load_factor, 5e-4, found);
    }
    // What matters: without lag of the wake, and without flexibility.
    let base = flight(1.0, gust(30.0), TurbulenceSettings::default());
    let without_wake = PlantSettings { inflow_states: 0, ..base.plant };
    let rigid = PlantSettings { fidelity: Fidelity::Rigid, ..base.plant };
    for (name, plant, largest) in [("N = 0", without_wake, 1.626), ("rigid", rigid, 1.421)] {
        let flown = hands_off(&Settings { plant, ..base.clone() }, 1.5);
        let [found, ..] = extremes(&flown, |outputs| outputs.load_factor.z);
        record.absolute(&format!("nominal, H = 30 m, {name}: largest"), largest, 5e-4, found);
    }
    record.finish();
}

#[test]
fn a_weak_gust_is_answered_as_the_linear_response_has_it() {
    let mut record = Record::new(
        "gust-weak",
        "A 1-cosine gust upwards of 0.2 m/s, H = 30 m, nominal stiffness: 50 times the largest increment of the load factor at O",
        "prototype in numpy that shares nothing with this program: fourth-order steps of 5 ms; by Fourier transforms of its linear \
         response 0.5331",
    );
    let flown = hands_off(&weak_gust(), 1.5);
    let [largest, ..] = extremes(&flown, |outputs| outputs.load_factor.z);
    let increment = largest - flown[0].load_factor.z;
    record.relative("50 (largest − at the trim)", 0.5333, 1e-3, 50.0 * increment);
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

/// A flight with sections turned and everything moving, at a state of a plant; what is across the mirror plane rests if it
/// flies by half.
fn disturbed(plant: &Plant, is_half: bool, seed: u64) -> Vec<f64> {
    let layout = plant.layout();
    let mut next = random(seed);
    let mut state: Vec<f64> = (0..layout.len()).map(|_| next()).collect();
    state[layout.position().end - 1] = -7620.0;
    state[layout.velocity().start] = 127.0;
    state[layout.coordinates()].iter_mut().for_each(|q| *q *= 20.0);
    state[layout.coordinate_rates()].iter_mut().for_each(|rate| *rate *= 60.0);
    let [velocity, rate, attitude] =
        [layout.velocity(), layout.rate(), layout.attitude()].map(|part| part.start);
    if is_half {
        for aside in [layout.position().start + 1, velocity + 1, rate, rate + 2, attitude + 1, attitude + 3] {
            state[aside] = 0.0;
        }
    }
    let norm = state[layout.attitude()].iter().map(|x| x * x).sum::<f64>().sqrt();
    state[layout.attitude()].iter_mut().for_each(|x| *x /= norm);
    state
}

/// Rates of all states but position, with the inertial acceleration of O in the place of that of v.
fn inertial_rates(plant: &Plant, state: &[f64], controls: &Controls) -> Vec<f64> {
    let (mut rates, layout) = (vec![0.0; state.len()], plant.layout());
    plant.rates(state, controls, &mut rates, &mut plant.workspace());
    let motion = plant.equations().motion(state);
    let turning = motion.rate.cross(&motion.velocity);
    for (acceleration, turning) in rates[layout.velocity()].iter_mut().zip(turning.iter()) {
        *acceleration += turning;
    }
    rates[layout.position()].fill(0.0);
    rates
}

#[test]
fn an_aircraft_that_moves_with_a_gust_that_is_the_same_everywhere_accelerates_as_in_still_air() {
    let mut record = Record::new(
        "gust-constant",
        "A gust that is the same all along the aircraft, and velocities to match: largest difference of the rates to those in still air, over the largest",
        "the principle of relativity; ten random states",
    );
    // At the peak of a gust of a million kilometres, 25 m/s in the mirror plane, with a part to the right for the whole.
    const GRADIENT: f64 = 1e9;
    // The consistently linearised level has the deformation in its forces and not in its mass: it is not the same in all frames.
    for fidelity in Fidelity::ALL.into_iter().filter(|&level| level != Fidelity::ConsistentlyLinearised) {
        let plants = Plants::under(&jet(), &PlantSettings { fidelity, ..PlantSettings::of(&jet()) }).unwrap();
        for (name, still, aside) in [("whole", plants.whole(), 0.6), ("half", plants.half().unwrap(), 0.0)] {
            let single = GustSettings {
                shape: GustShape::OneMinusCosine,
                gradient: GRADIENT,
                peak: 25.0,
                direction: aside,
                inclination: 0.3,
                start: 0.0,
                ..GustSettings::default()
            };
            let mut largest = 0.0_f64;
            for seed in 0..10 {
                let mut state = disturbed(still, name == "half", seed);
                let controls = still.neutral_controls();
                let expected = inertial_rates(still, &state, &controls);
                let layout = *still.layout();
                let start = Vector3::from_column_slice(&state[layout.position()]) - Vector3::x() * GRADIENT;
                let track = Track::new(&start, &Vector3::x(), Extent { nose: 0.0, reach: 100.0 });
                let gust =
                    FrozenGust::new(track, (&single, &TurbulenceSettings::default()), 0.0, 1.0).unwrap();
                let carried = Vector3::from(gust.velocity(GRADIENT));
                let to_body = Attitude::from_quaternion(&state[layout.attitude()]).body_from_inertial;
                for (speed, carried) in state[layout.velocity()].iter_mut().zip((to_body * carried).iter()) {
                    *speed += carried;
                }
                let found = inertial_rates(&still.clone().in_gust(&Arc::new(gust)), &state, &controls);
                let size = expected.iter().fold(0.0_f64, |size, rate| size.max(rate.abs()));
                let apart =
                    found.iter().zip(&expected).map(|(found, expected)| (found - expected).abs() / size);
                largest = apart.fold(largest, f64::max);
            }
            record.rounding(&format!("{fidelity:?}, {name}"), 1e-12, largest);
        }
    }
    record.finish();
}

#[test]
fn the_width_of_the_vectors_changes_no_bit_in_a_gust() {
    for fidelity in Fidelity::ALL {
        let plants = Plants::under(&jet(), &PlantSettings { fidelity, ..PlantSettings::of(&jet()) }).unwrap();
        for (plant, is_half) in [(plants.whole(), false), (plants.half().unwrap(), true)] {
            let state = disturbed(plant, is_half, 3);
            let position = Vector3::from_column_slice(&state[plant.layout().position()]);
            let controls = plant.neutral_controls();
            let wide = plant.clone().in_gust(&Encounter::around(&position, &controls.air_travel).gust);
            let [wide, narrow] = [wide.clone(), wide.one_strip_at_a_time()].map(|plant| {
                let mut rates = vec![0.0; state.len()];
                plant.rates(&state, &controls, &mut rates, &mut plant.workspace());
                rates.into_iter().map(f64::to_bits).collect::<Vec<_>>()
            });
            assert_eq!(wide, narrow, "{fidelity:?}, half {is_half}");
        }
    }
}

/// Everything is on: a gust, turbulence and a wind that changes, an actuator at its rate limit, an engine that lags, sampled
/// sensors with noise.
fn stormy(fidelity: Fidelity) -> (Settings, Inputs, Inputs) {
    let turbulence = TurbulenceSettings { spectrum: Spectrum::Dryden, ..TurbulenceSettings::default() };
    let oblique = GustSettings { direction: 0.4, inclination: 0.2, start: 0.1, ..gust(20.0) };
    let mut settings = flight(0.1, oblique, turbulence);
    settings.plant.fidelity = fidelity;
    settings.actuators.set(ELEVATOR, Actuator { frequency: 40.0, rate_limit: 0.05, ..Actuator::default() });
    settings.engines.set(0, EngineLag { time_constant: 0.3, ..EngineLag::default() });
    (settings.sensors.enabled, settings.sensors.delay) = (true, 2);
    settings.sensors.noise = [0.01; 7];
    let (mut inputs, mut rates) = (Inputs::zero(&jet()), Inputs::zero(&jet()));
    (inputs.controls[ELEVATOR], rates.controls[ELEVATOR], inputs.thrust[0]) = (-0.03, 0.02, 2e3);
    (inputs.wind, inputs.wind_rate) = (Vector3::new(-3.0, 2.0, 1.0), Vector3::new(1.0, 0.5, -2.0));
    rates.wind_rate = Vector3::new(0.3, -0.1, 0.2);
    (settings, inputs, rates)
}

#[test]
fn a_flight_through_everything_that_blows_has_the_same_bits_in_any_steps_and_from_any_snapshot() {
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact, Fidelity::RuthlesslyLinearised] {
        let (settings, inputs, rates) = stormy(fidelity);
        let begin = || {
            let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
            flight.set_inputs(&inputs, &rates);
            flight
        };
        let (mut whole, mut split, mut restored) = (begin(), begin(), begin());
        whole.advance_to(0.5).unwrap();
        (1..=500).for_each(|step| split.advance_to(f64::from(step) * 1e-3).unwrap());
        assert_eq!(whole.instant(), split.instant(), "{fidelity:?}");
        let mut bytes = Vec::new();
        whole.snapshot(&mut bytes);
        whole.advance_to(0.9).unwrap();
        restored.restore(&bytes).unwrap();
        restored.advance_to(0.9).unwrap();
        assert_eq!(whole.instant(), restored.instant(), "{fidelity:?}");
    }
}

#[test]
fn half_the_aircraft_flies_through_a_gust_in_its_plane_as_the_whole_does() {
    let mut record = Record::new(
        "gust-half",
        "A gust upwards and forwards and vertical turbulence, H = 20 m, one-tenth stiffness: largest difference of half and whole over 2 s",
        "symmetry of the aircraft",
    );
    for fidelity in Fidelity::ALL {
        let turbulence = TurbulenceSettings {
            spectrum: Spectrum::Dryden,
            components: TurbulenceComponents::Vertical,
            ..TurbulenceSettings::default()
        };
        let forwards = GustSettings { inclination: 0.5, start: 0.2, ..gust(20.0) };
        let mut settings = flight(0.1, forwards, turbulence);
        settings.plant.fidelity = fidelity;
        let fly = |side_wind: f64| {
            let mut flight = Simulation::new(jet(), &settings, 0.0).unwrap();
            let (mut inputs, rates) = (Inputs::zero(&jet()), Inputs::zero(&jet()));
            inputs.wind.y = side_wind;
            flight.set_inputs(&inputs, &rates);
            let outputs = |step| {
                flight.advance_to(0.01 * f64::from(step)).unwrap();
                assert_eq!(flight.is_symmetric(), side_wind == 0.0);
                flight.outputs().clone()
            };
            (1..=200).map(outputs).collect::<Vec<_>>()
        };
        let (half, whole) = (fly(0.0), fly(1e-12));
        let apart = half.iter().zip(&whole).map(|(half, whole)| {
            let tips = half.deflections.iter().zip(&whole.deflections);
            let tips = tips.map(|(half, whole)| (half.displacement - whole.displacement).norm());
            tips.fold((half.load_factor - whole.load_factor).norm(), f64::max)
        });
        let case = format!("{fidelity:?}: load factor, deflections (m)");
        record.rounding(&case, 1e-11, apart.fold(0.0, f64::max));
    }
    record.finish();
}

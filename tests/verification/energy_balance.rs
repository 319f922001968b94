//! Energy balance in air: along a flight the work of aerodynamic forces, thrust and gravity is the change of kinetic
//! and strain energy, for the models that follow from a Lagrangian.
//!
//! [theory: equations-of-motion.conservation, air-loads.distribution; thesis §2.2, §4]
//!
//! The work is summed strip by strip as the theory writes the loads, apparent mass included
//! (`support/plain_loads.rs`).

use flexible_aircraft::equations::{EquationsOfMotion, Fidelity, Mechanics};
use flexible_aircraft::math::Attitude;
use flexible_aircraft::plant::{Manoeuvre, Plant, TrimCondition};
use flexible_aircraft::structure::{BeamSection, ReducedEngine, ReducedModel};
use nalgebra::{DVector, Vector3};

use crate::support::encounter::Encounter;
use crate::support::plain_loads::{Instant, PlainGust};
use crate::support::plain_points::{Fixed, Moving};
use crate::support::plain_sections::moving_point;
use crate::support::{AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, derivative, jet, random, soft};

use super::record::Record;

/// Power of all loads, W.
fn power(model: &ReducedModel, instant: &Instant) -> f64 {
    let Instant { equations, moving, controls, state, .. } = *instant;
    let air: f64 = model
        .strips
        .iter()
        .map(|strip| {
            let load = instant.load(strip);
            let at = Fixed::from(strip).point(moving, equations, state);
            load.force.dot(&at.velocity) + load.moment * load.span.dot(&at.spin)
        })
        .sum();
    let engine = |(engine, thrust): (&ReducedEngine, &f64)| {
        let at = Fixed::from(engine).point(moving, equations, state);
        thrust * (at.turn * engine.direction).dot(&at.velocity)
    };
    let thrust: f64 = model.engines.iter().zip(&controls.thrust).map(engine).sum();

    let attitude = Attitude::from_quaternion(&state[equations.layout().attitude()]);
    let gravity = attitude.body_from_inertial * Vector3::new(0.0, 0.0, model.gravity);
    air + thrust + gravity.dot(&momentum(model, instant))
}

/// Of all mass, body axes, kg·m/s.
fn momentum(model: &ReducedModel, instant: &Instant) -> Vector3<f64> {
    let Instant { equations, state, .. } = *instant;
    let layout = equations.layout();
    let motion = equations.motion(state);
    let (q, q_dot) = (&state[layout.coordinates()], &state[layout.coordinate_rates()]);
    match instant.moving {
        Moving::Superposed => {
            let p = |amounts: &[f64]| -> Vector3<f64> {
                model.integrals.momentum.iter().zip(amounts).map(|(p, amount)| p * *amount).sum()
            };
            motion.velocity * model.integrals.mass
                + motion.rate.cross(&(model.integrals.first_moment + p(q)))
                + p(q_dot)
        }
        Moving::Exactly(sections) => {
            let of_section = |(section, at): (usize, &BeamSection)| {
                let centre = moving_point(sections, [q, q_dot], section, &at.body.offset);
                let velocity = motion.velocity + motion.rate.cross(&centre.place) + centre.velocity;
                velocity * at.body.mass
            };
            sections.iter().enumerate().map(of_section).sum()
        }
    }
}

/// The jet with twelve modes of both families at one-tenth stiffness in steady inflow.
fn soft_jet(fidelity: Fidelity) -> (ReducedModel, Plant) {
    let model = jet().select(&(0..12).collect::<Vec<_>>());
    let plant = Plant::new(&model, &soft(fidelity)).unwrap();
    (model, plant)
}

/// T + U.
fn energy(equations: &EquationsOfMotion, state: &[f64]) -> f64 {
    let mechanics = Mechanics::new(equations, state);
    mechanics.kinetic_energy + mechanics.strain_energy
}

/// Controls that shake the aircraft in all axes: the largest
/// change of energy along 4 s, J, and the largest difference to the work.
fn balance(fidelity: Fidelity) -> (f64, f64) {
    const STEP: f64 = 1e-3;
    let (model, plant) = soft_jet(fidelity);
    let equations = plant.equations();
    let condition =
        TrimCondition { airspeed: 127.0, altitude: 7620.0, heading: 0.0, manoeuvre: Manoeuvre::LEVEL };
    let trim = plant.trim(&condition).unwrap();
    let mut workspace = plant.workspace();
    let moving = Moving::at(&model, fidelity);
    let mut slope = |time: f64, state: &DVector<f64>| {
        let wave = libm::sin(std::f64::consts::TAU * 0.5 * time);
        let mut controls = equations.neutral_controls();
        (controls.angles[ELEVATOR], controls.angles[AILERON], controls.angles[RUDDER]) =
            (trim.point.pitch_control - 0.05 * wave, 0.03 * wave, 0.02 * wave);
        controls.thrust.fill(trim.point.thrust * (1.0 + 0.3 * wave));
        let mut rates = vec![0.0; state.len()];
        // The last entry is the work.
        let aircraft = &state.as_slice()[..state.len() - 1];
        equations.rates(aircraft, &controls, &mut rates[..aircraft.len()], &mut workspace);
        let work = rates.len() - 1;
        let instant = Instant {
            equations,
            moving,
            controls: &controls,
            state: aircraft,
            rates: &rates[..work],
            gust: None,
        };
        rates[work] = power(&model, &instant);
        DVector::from_vec(rates)
    };
    let energy = |state: &DVector<f64>| energy(equations, &state.as_slice()[..state.len() - 1]);
    let mut state = DVector::from_vec([trim.state.as_slice(), &[0.0]].concat());
    let start = energy(&state);
    let (mut largest, mut difference) = (0.0_f64, 0.0_f64);
    for index in 0..4000 {
        let t = f64::from(index) * STEP;
        let k1 = slope(t, &state);
        let k2 = slope(t + 0.5 * STEP, &(&state + &k1 * (0.5 * STEP)));
        let k3 = slope(t + 0.5 * STEP, &(&state + &k2 * (0.5 * STEP)));
        let k4 = slope(t + STEP, &(&state + &k3 * STEP));
        state += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (STEP / 6.0);
        let change = energy(&state) - start;
        largest = largest.max(change.abs());
        difference = difference.max((change - state[state.len() - 1]).abs());
    }
    (largest, difference)
}

/// The largest difference of power and d(T + U)/dt over ten random states, in a gust or not, relative to the power.
fn instantaneous(fidelity: Fidelity, in_gust: bool) -> f64 {
    let (model, plant) = soft_jet(fidelity);
    let equations = plant.equations();
    let layout = *equations.layout();
    let mut workspace = plant.workspace();
    let step = if fidelity == Fidelity::GeometricallyExact { 2e-4 } else { 1e-2 };
    let mut largest = 0.0_f64;
    for seed in 0..10 {
        let mut next = random(seed);
        let mut state: Vec<f64> = (0..layout.len()).map(|_| next()).collect();
        state[layout.position().end - 1] = -7620.0;
        state[layout.velocity().start] = 127.0;
        for (range, scale) in [
            (layout.velocity().end - 1..layout.velocity().end, 15.0),
            (layout.coordinates(), 20.0),
            (layout.coordinate_rates(), 60.0),
        ] {
            state[range].iter_mut().for_each(|x| *x *= scale);
        }
        let mut controls = equations.neutral_controls();
        (controls.angles[ELEVATOR], controls.angles[AILERON], controls.angles[RUDDER]) =
            (0.2 * next(), 0.2 * next(), 0.2 * next());
        controls.angles[AILERON_SYMMETRIC] = 0.2 * next();
        controls.thrust.fill(3e4 * next());
        let position = Vector3::from_column_slice(&state[layout.position()]);
        let Encounter { gust, along, start } = Encounter::around(&position, &controls.air_travel);
        let plant = if in_gust { plant.clone().in_gust(&gust) } else { plant.clone() };
        let mut rates = vec![0.0; state.len()];
        plant.rates(&state, &controls, &mut rates, &mut workspace);
        let velocity = |ahead| gust.velocity(ahead);
        let gust = PlainGust { velocity: &velocity, along, origin: start };
        let gust = in_gust.then_some(&gust);
        let moving = Moving::at(&model, fidelity);
        let instant = Instant { equations, moving, controls: &controls, state: &state, rates: &rates, gust };
        let expected = power(&model, &instant);
        // T + U of superposed displacements is quartic along a straight line, that of strains smooth.
        let moved = |s: f64| state.iter().zip(&rates).map(|(x, rate)| x + s * rate).collect::<Vec<_>>();
        let found = derivative(step, |s| energy(equations, &moved(s)));
        largest = largest.max((found / expected - 1.0).abs());
    }
    largest
}

#[test]
fn the_work_of_air_thrust_and_gravity_is_the_change_of_energy() {
    let mut record = Record::new(
        "energy-balance",
        "Jet at one-tenth stiffness in air, all controls and thrust moving: energy and work over 4 s, and at random states",
        "work of the loads of [theory: air-loads.distribution, gravity-and-thrust.gravity, gravity-and-thrust.thrust], summed here; Runge–Kutta steps of 1 ms",
    );
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent] {
        let (largest, difference) = balance(fidelity);
        record.at_least(&format!("{fidelity:?}: largest change of T + U, J"), 1e6, largest);
        record.rounding(
            &format!("{fidelity:?}: largest difference to the work, over that"),
            1e-10,
            difference / largest,
        );
    }
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent, Fidelity::GeometricallyExact] {
        let case = format!("{fidelity:?}: power against d(T + U)/dt, ten random states, relative");
        record.rounding(&case, 1e-9, instantaneous(fidelity, false));
        let case = format!("{fidelity:?}: the same in an oblique gust and turbulence");
        record.rounding(&case, 1e-9, instantaneous(fidelity, true));
    }
    record.finish();
}

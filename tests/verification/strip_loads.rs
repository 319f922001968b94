//! The loads of all strips are those of the formulas, summed plainly, and ẇ and Ω̇ in them are the true rates of w and Ω
//! [theory: air-loads.distribution, air-loads.rates; thesis §4.1].

use std::sync::Arc;

use flexible_aircraft::equations::{Controls, EquationsOfMotion, Fidelity, Workspace};
use flexible_aircraft::structure::{ReducedModel, ReducedStrip};
use nalgebra::Vector3;

use crate::support::encounter::Encounter;
use crate::support::plain_loads::{Instant, PlainGust};
use crate::support::plain_points::{Fixed, Moving};
use crate::support::{AILERON, AILERON_SYMMETRIC, ELEVATOR, RUDDER, derivative, jet, random, soft};

use super::record::Record;

/// The jet with twelve modes; `altered` gives its strips camber, moments at zero lift and by incidence, suction, and flaps that
/// drag, that all controls turn, some with a moment of their own.
fn aircraft(altered: bool) -> ReducedModel {
    let mut model = jet().select(&(0..12).collect::<Vec<_>>());
    if altered {
        let mut next = random(7);
        for strip in &mut model.strips {
            strip.zero_lift_offset = 0.05 * next();
            strip.zero_lift_moment = 0.1 * next();
            strip.moment_slope = 0.5 * next();
            strip.leading_edge_suction = 0.5 + 0.5 * next();
            if let Some(flap) = &mut strip.flap {
                flap.drag = 0.5 + 0.5 * next();
                flap.moment_slope = (next() > 0.0).then(&mut next);
                for control in [ELEVATOR, AILERON, RUDDER] {
                    flap.gains[control] = next();
                }
            }
        }
    }
    model
}

/// The equations of a model in steady inflow at one-tenth stiffness.
fn equations(model: &ReducedModel, fidelity: Fidelity) -> EquationsOfMotion {
    EquationsOfMotion::new(model, &soft(fidelity)).unwrap()
}

/// A flight with sections turned by up to about 1 rad, and controls and wind that act everywhere.
pub fn disturbed(equations: &EquationsOfMotion, seed: u64) -> (Vec<f64>, Controls) {
    let layout = equations.layout();
    let mut next = random(seed);
    let mut state: Vec<f64> = (0..layout.len()).map(|_| next()).collect();
    state[layout.position().end - 1] = -7620.0;
    state[layout.velocity().start] = 127.0;
    state[layout.coordinates()].iter_mut().for_each(|q| *q *= 40.0);
    state[layout.coordinate_rates()].iter_mut().for_each(|rate| *rate *= 60.0);
    let attitude = &mut state[layout.attitude()];
    let norm = attitude.iter().map(|x| x * x).sum::<f64>().sqrt();
    attitude.iter_mut().for_each(|x| *x /= norm);
    let mut controls = equations.neutral_controls();
    (controls.angles[ELEVATOR], controls.angles[AILERON], controls.angles[RUDDER]) =
        (0.3 * next(), 0.3 * next(), 0.3 * next());
    controls.angles[AILERON_SYMMETRIC] = 0.3 * next();
    controls.wind = Vector3::new(next(), next(), next()) * 10.0;
    controls.wind_rate = Vector3::new(next(), next(), next()) * 20.0;
    (state, controls)
}

/// All rates at a state, and the generalised forces there.
fn evaluate(equations: &EquationsOfMotion, state: &[f64], controls: &Controls) -> (Vec<f64>, Vec<f64>) {
    let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(equations));
    equations.rates(state, controls, &mut rates, &mut workspace);
    (rates, workspace.forces().to_vec())
}

/// Largest difference of the strips' generalised forces without accelerations to the plain sum, in a gust or not, over the
/// largest force.
fn difference(model: &ReducedModel, fidelity: Fidelity, in_gust: bool, seed: u64) -> f64 {
    let mut with_strips = equations(model, fidelity);
    let without = equations(&ReducedModel { strips: Vec::new(), ..model.clone() }, fidelity);
    let (state, mut controls) = disturbed(&with_strips, seed);
    controls.air_travel = controls.wind * 0.3;
    let position = Vector3::from_column_slice(&state[with_strips.layout().position()]);
    let Encounter { gust, along, start } = Encounter::around(&position, &controls.air_travel);
    if in_gust {
        with_strips.take_gust(Arc::clone(&gust));
    }
    let (mut rates, forces) = evaluate(&with_strips, &state, &controls);
    let (_, others) = evaluate(&without, &state, &controls);
    let layout = *with_strips.layout();
    for accelerations in [layout.velocity(), layout.rate(), layout.coordinate_rates()] {
        rates[accelerations].fill(0.0);
    }
    let velocity = |ahead| gust.velocity(ahead);
    let gust = PlainGust { velocity: &velocity, along, origin: start + controls.air_travel };
    let instant = Instant {
        equations: &with_strips,
        moving: Moving::at(model, fidelity),
        controls: &controls,
        state: &state,
        rates: &rates,
        gust: in_gust.then_some(&gust),
    };
    let mut plain = vec![0.0; forces.len()];
    for strip in &model.strips {
        add(&mut plain, &instant, strip, fidelity);
    }
    let found = forces.iter().zip(&others).map(|(all, others)| all - others);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |max, x| max.max(x.abs()));
    let size = largest(&mut plain.iter().copied());
    largest(&mut found.zip(&plain).map(|(found, plain)| found - plain)) / size
}

/// Adds what a strip's loads do on every component of ν.
fn add(forces: &mut [f64], instant: &Instant, strip: &ReducedStrip, fidelity: Fidelity) {
    let load = instant.load(strip);
    let (fixed, moving) = (Fixed::from(strip), instant.moving);
    let place = fixed.point(moving, instant.equations, instant.state).place;
    // RL distributes forces where the undeformed strip is.
    let arm = if fidelity == Fidelity::RuthlesslyLinearised { strip.position } else { place };
    let couple = load.span * load.moment;
    let moment = arm.cross(&load.force) + couple;
    for axis in 0..3 {
        forces[axis] += load.force[axis];
        forces[3 + axis] += moment[axis];
    }
    let q = &instant.state[instant.equations.layout().coordinates()];
    for mode in 0..q.len() {
        let mut unit = vec![0.0; q.len()];
        unit[mode] = 1.0;
        let [translation, rotation] = fixed.rows_times(moving, q, &unit);
        forces[6 + mode] += translation.dot(&load.force) + rotation.dot(&couple);
    }
}

#[test]
fn the_loads_of_all_strips_are_the_plain_sum_of_the_formulas_at_every_level() {
    let mut record = Record::new(
        "strip-loads",
        "Generalised forces of all strips at ten random states, sections turned by up to 1 rad, in a changing wind: largest difference to the plain sum, over the largest force",
        "[theory: air-loads.distribution], summed strip by strip in `support/plain_loads.rs`; the altered jet has camber, moments at zero lift, suction, and flaps that all controls turn",
    );
    for (name, model) in [("jet", aircraft(false)), ("altered jet", aircraft(true))] {
        for fidelity in Fidelity::ALL.into_iter().filter(|fidelity| *fidelity != Fidelity::Rigid) {
            for (air, in_gust) in [("", false), (", in an oblique gust and turbulence", true)] {
                let differences = (0..10).map(|seed| difference(&model, fidelity, in_gust, seed));
                let case = format!("{name}, {fidelity:?}{air}");
                record.rounding(&case, 1e-12, differences.fold(0.0, f64::max));
            }
        }
    }
    record.finish();
}

#[test]
fn the_rates_of_the_flow_at_a_strip_are_the_true_ones() {
    let mut record = Record::new(
        "flow-rates",
        "ẇ (m/s²) and Ω̇ (rad/s²) of all strips at ten random states, sections turned by up to 1 rad, in a changing wind: largest difference to differences of w and Ω along the motion, over the largest rate",
        "five-point differences of w and Ω, whose own error is below 1e-9",
    );
    let aircraft = [("jet", aircraft(false)), ("altered jet", aircraft(true))];
    let levels = [Fidelity::Exact, Fidelity::GeometricallyExact];
    for ((name, model), fidelity) in
        aircraft.iter().flat_map(|aircraft| levels.map(|level| (aircraft, level)))
    {
        let (equations, moving) = (equations(model, fidelity), Moving::at(model, fidelity));
        let (mut largest, mut differences) = ([0.0_f64; 2], [0.0_f64; 2]);
        for seed in 0..10 {
            let (state, controls) = disturbed(&equations, seed);
            let (rates, _) = evaluate(&equations, &state, &controls);
            let instant = Instant {
                equations: &equations,
                moving,
                controls: &controls,
                state: &state,
                rates: &rates,
                gust: None,
            };
            for strip in &model.strips {
                let found = instant.flow_rates(strip, &instant.flow_after(strip, 0.0));
                let expected = [
                    derivative(1e-4, |time| instant.flow_after(strip, time).upwash),
                    derivative(1e-4, |time| instant.flow_after(strip, time).pitch_rate),
                ];
                for i in 0..2 {
                    largest[i] = largest[i].max(expected[i].abs());
                    differences[i] = differences[i].max((found[i] - expected[i]).abs());
                }
            }
        }
        for (i, rate) in ["ẇ", "Ω̇"].into_iter().enumerate() {
            record.rounding(&format!("{name}, {fidelity:?}: {rate}"), 1e-9, differences[i] / largest[i]);
        }
    }
    record.finish();
}

//! In vacuum and without gravity E, I and GE conserve energy and momentum, CL and RL do not.
//!
//! [theory: equations-of-motion.conservation, geometrically-exact.conservation]

use flexible_aircraft::equations::{EquationsOfMotion, Fidelity, Mechanics, Workspace};
use flexible_aircraft::plant::Plant;
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

use crate::support::{jet, soft, station};

use super::record::Record;

/// The jet with twelve modes, without air and gravity.
fn in_vacuum(fidelity: Fidelity) -> Plant {
    let jet = jet();
    let model = ReducedModel { gravity: 0.0, strips: Vec::new(), ..jet.select(&(0..12).collect::<Vec<_>>()) };
    Plant::new(&model, &soft(fidelity)).unwrap()
}

/// Tip motions of metres, `size` times as fast and far, rates of half a radian per second.
fn violent_state(equations: &EquationsOfMotion, size: f64) -> Vec<f64> {
    let layout = equations.layout();
    let mut state = vec![0.0; layout.len()];
    state[layout.position()].copy_from_slice(&[100.0, -50.0, 20.0]);
    state[layout.attitude()].copy_from_slice(&[1.0, 0.0, 0.0, 0.0]);
    state[layout.velocity()].copy_from_slice(&[5.0, -2.0, 1.0]);
    state[layout.rate()].copy_from_slice(&[0.5, -0.4, 0.3]);
    for (mode, q) in state[layout.coordinates()].iter_mut().enumerate() {
        *q = size * 40.0 * libm::cos(1.0 + 2.0 * mode as f64) / (1.0 + mode as f64);
    }
    for (mode, q_dot) in state[layout.coordinate_rates()].iter_mut().enumerate() {
        *q_dot = size * 60.0 * libm::sin(2.0 + 3.0 * mode as f64) / (1.0 + mode as f64);
    }
    state
}

/// Plain Runge–Kutta steps over 5 s, whose error is below 1e-9: real axial stiffness makes E stiff. Returns the largest
/// displacement of a wing tip, m.
fn fly(plant: &Plant, state: &mut [f64], steps: usize) -> f64 {
    let length = 5.0 / steps as f64;
    let equations = plant.equations();
    let (mut workspace, controls) = (Workspace::new(equations), equations.neutral_controls());
    let mut slopes: [Vec<f64>; 4] = std::array::from_fn(|_| vec![0.0; state.len()]);
    let mut largest = 0.0_f64;
    for step in 0..steps {
        let mut stage = state.to_vec();
        for (index, weight) in [0.0, 0.5, 0.5, 1.0].into_iter().enumerate() {
            for i in 0..state.len() {
                stage[i] = state[i] + if index > 0 { weight * length * slopes[index - 1][i] } else { 0.0 };
            }
            equations.rates(&stage, &controls, &mut slopes[index], &mut workspace);
        }
        for i in 0..state.len() {
            let [k1, k2, k3, k4] = &slopes;
            state[i] += length / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
        if step % 10 == 0 {
            let outputs = plant.outputs_at(state, &controls, &mut workspace);
            largest = largest.max(outputs.deflections[station("wing_tip_right")].displacement.norm());
        }
    }
    largest
}

/// Relative drifts of energy, linear and angular momentum over 5 s, and the largest wing-tip motion (m).
fn drifts(fidelity: Fidelity, size: f64, steps: usize) -> ([f64; 3], f64) {
    let plant = in_vacuum(fidelity);
    let equations = plant.equations();
    let mut state = violent_state(equations, size);
    let before = Mechanics::new(equations, &state);
    let tip = fly(&plant, &mut state, steps);
    let after = Mechanics::new(equations, &state);
    let energy = |mechanics: &Mechanics| mechanics.kinetic_energy + mechanics.strain_energy;
    let relative = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() / b.norm();
    let drifts = [
        (energy(&after) / energy(&before) - 1.0).abs(),
        relative(after.linear_momentum, before.linear_momentum),
        relative(after.angular_momentum, before.angular_momentum),
    ];
    (drifts, tip)
}

#[test]
fn models_that_follow_from_a_lagrangian_conserve_energy_and_momentum_at_large_amplitude() {
    let mut record = Record::new(
        "conservation-kept",
        "Relative drifts over 5 s of violent motion, models that follow from a Lagrangian",
        "[theory: equations-of-motion.conservation]; Runge–Kutta steps of 0.2 ms (GE: 0.5 ms), one-tenth stiffness, 12 modes, no air, no gravity",
    );
    for (fidelity, size, steps, far) in [
        (Fidelity::Exact, 1.0, 25_000, 1.0),
        (Fidelity::Inconsistent, 1.0, 25_000, 1.0),
        (Fidelity::GeometricallyExact, 4.0, 10_000, 8.0),
    ] {
        let ([energy, linear, angular], tip) = drifts(fidelity, size, steps);
        record.at_least(&format!("{fidelity:?}: largest wing-tip motion, m"), far, tip);
        record.rounding(&format!("{fidelity:?}: energy"), 1e-9, energy);
        record.rounding(&format!("{fidelity:?}: linear momentum"), 1e-10, linear);
        record.rounding(&format!("{fidelity:?}: angular momentum"), 1e-10, angular);
    }
    record.finish();
}

#[test]
fn linearised_models_conserve_neither() {
    let mut record = Record::new(
        "conservation-lost",
        "The same for the linearised models, which conserve neither",
        "[theory: equations-of-motion.conservation]",
    );
    for fidelity in [Fidelity::ConsistentlyLinearised, Fidelity::RuthlesslyLinearised] {
        let ([energy, linear, angular], _) = drifts(fidelity, 1.0, 25_000);
        record.at_least(&format!("{fidelity:?}: energy"), 1e-4, energy);
        record.at_least(&format!("{fidelity:?}: linear momentum"), 1e-4, linear);
        record.at_least(&format!("{fidelity:?}: angular momentum"), 1e-4, angular);
    }
    record.finish();
}

//! The accelerations of the exact and the inconsistent model in vacuum satisfy the Boltzmann–Hamel equations of
//! the particles' Lagrangian, row by row [theory: equations-of-motion.lagrange; thesis §2.2]:
//!
//! ```text
//! d/dt ∂L/∂v + ω × ∂L/∂v = 0
//! d/dt ∂L/∂ω + ω × ∂L/∂ω + v × ∂L/∂v = 0
//! d/dt ∂L/∂q̇ − ∂L/∂q = 0
//! ```
//!
//! with L = Σ ½ m |v + ω×R + ψq̇|² − U(q) differentiated numerically. T is quadratic in ν and in q, U quartic in
//! q, so five-point differences are exact but for rounding; U itself is checked in `strain_energy.rs`.

use flexible_aircraft::equations::{EquationsOfMotion, Fidelity, Workspace};
use nalgebra::Vector3;

use crate::support::derivative;

use super::modal_integrals::{Particles, jet_and_particles, random_state, velocities};
use super::record::Record;

/// `x + s·direction`.
fn along(x: &[f64], direction: &[f64], s: f64) -> Vec<f64> {
    x.iter().zip(direction).map(|(x, d)| x + s * d).collect()
}

/// `x` with one entry moved by s.
fn moved(x: &[f64], index: usize, s: f64) -> Vec<f64> {
    let mut x = x.to_vec();
    x[index] += s;
    x
}

/// ∂T/∂ν.
fn momentum(particles: &Particles, q: &[f64], nu: &[f64], row: usize) -> f64 {
    let step = nu.iter().fold(1.0_f64, |max, nu| max.max(nu.abs()));
    derivative(step, |s| particles.kinetic_energy(q, &moved(nu, row, s)))
}

/// What is left of each row, relative to the largest of the row's terms.
fn residuals(equations: &EquationsOfMotion, particles: &Particles, state: &[f64]) -> Vec<f64> {
    let mut workspace = Workspace::new(equations);
    let controls = equations.neutral_controls();
    equations.rates(state, &controls, &mut vec![0.0; state.len()], &mut workspace);
    let (nu, nu_dot) = (velocities(equations, state), workspace.accelerations().to_vec());
    let (q, q_dot) = (state[equations.layout().coordinates()].to_vec(), nu[6..].to_vec());

    let changes: Vec<f64> = (0..nu.len())
        .map(|row| {
            derivative(1e-2, |s| momentum(particles, &along(&q, &q_dot, s), &along(&nu, &nu_dot, s), row))
        })
        .collect();
    let vector = |first: usize| Vector3::from_fn(|i, _| momentum(particles, &q, &nu, first + i));
    let (p_v, p_omega) = (vector(0), vector(3));
    let (v, omega) = (Vector3::from_column_slice(&nu[0..3]), Vector3::from_column_slice(&nu[3..6]));
    let mut rows = Vec::new();
    for (change, turning) in changes[0..3].iter().zip(&omega.cross(&p_v)) {
        rows.push(vec![*change, *turning]);
    }
    for (change, (turning, moving)) in
        changes[3..6].iter().zip(omega.cross(&p_omega).iter().zip(&v.cross(&p_v)))
    {
        rows.push(vec![*change, *turning, *moving]);
    }
    for mode in 0..q.len() {
        let kinetic = derivative(1.0, |s| particles.kinetic_energy(&moved(&q, mode, s), &nu));
        let elastic = derivative(20.0, |s| equations.strain_energy(&moved(&q, mode, s)));
        rows.push(vec![changes[6 + mode], -kinetic, elastic]);
    }
    rows.iter()
        .map(|terms| {
            let largest = terms.iter().fold(0.0_f64, |max, term| max.max(term.abs()));
            terms.iter().sum::<f64>().abs() / largest
        })
        .collect()
}

#[test]
fn every_row_is_that_of_the_lagrangian() {
    let mut record = Record::new(
        "equations-of-motion",
        "Jet with 12 modes at one-tenth stiffness, 10 random states: what is left of a row, relative to its largest term",
        "Boltzmann–Hamel equations of the Lagrangian T − U [thesis §2.2], differentiated numerically",
    );
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent] {
        let (equations, particles) = jet_and_particles(fidelity);
        let all: Vec<Vec<f64>> =
            (0..10).map(|seed| residuals(&equations, &particles, &random_state(&equations, seed))).collect();
        for (name, range) in [("force", 0..3), ("moment", 3..6), ("generalised", 6..18)] {
            let largest =
                all.iter().flat_map(|rows| &rows[range.clone()]).fold(0.0_f64, |max, &r| max.max(r));
            record.rounding(&format!("{fidelity:?}: {name} rows"), 1e-7, largest);
        }
    }
    record.finish();
}

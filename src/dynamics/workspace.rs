//! Scratch memory of the equations of motion, allocated once.

use super::equations::EquationsOfMotion;
use super::inertia::DeformedInertia;
use super::linear_solve::Cholesky;
use super::strip_sums::StripSums;
use crate::structure::PairProducts;

/// Everything that evaluating the equations of motion overwrites.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Integrals at the present q.
    pub(super) inertia: DeformedInertia,
    /// Generalised forces on ν.
    pub(super) force: Vec<f64>,
    /// ∂U/∂q.
    pub(super) elastic_force: Vec<f64>,
    /// For the strain energy.
    pub(super) pairs: PairProducts,
    /// Mass matrix with apparent mass, row-major.
    pub(super) mass: Vec<f64>,
    /// Room for its factor.
    pub(super) factor: Vec<f64>,
    /// Loads and apparent mass of the strips.
    pub(super) strip_sums: StripSums,
    /// ν̇ of the last evaluation.
    pub(super) accelerations: Vec<f64>,
}

impl Workspace {
    /// For the given equations.
    pub fn new(equations: &EquationsOfMotion) -> Self {
        let size = equations.layout().velocities();
        Workspace {
            inertia: DeformedInertia::undeformed(equations.integrals()),
            force: vec![0.0; size],
            elastic_force: vec![0.0; size - 6],
            pairs: equations.pair_products(),
            mass: vec![0.0; size * size],
            factor: vec![0.0; Cholesky::room(size)],
            strip_sums: equations.strip_sums(),
            accelerations: vec![0.0; size],
        }
    }

    /// ν̇ = [v̇; ω̇; q̈] of the last evaluation.
    pub fn accelerations(&self) -> &[f64] {
        &self.accelerations
    }

    /// Generalised forces on ν of the last evaluation.
    pub fn forces(&self) -> &[f64] {
        &self.force
    }

    /// The first lifting strip that met the air backwards at the last evaluation.
    pub fn reversed_strip(&self) -> Option<usize> {
        self.strip_sums.reversed
    }
}

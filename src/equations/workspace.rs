//! Scratch memory of the equations of motion, allocated once.

use crate::kinematics::{AnyInertia, AnyMemory};
use crate::math::LinearSystem;
use crate::strips::{GustAtStrips, StripSums};
use crate::structure::ElasticScratch;

use super::controls::Controls;
use super::forces::GeneralisedForces;
use super::of_motion::EquationsOfMotion;

/// Everything that evaluating the equations of motion overwrites.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// What kinematics wrote at the last evaluation.
    pub(crate) memory: AnyMemory,
    /// Of the aircraft as it was deformed then.
    pub(crate) inertia: AnyInertia,
    /// On ν.
    pub(crate) forces: GeneralisedForces,
    /// ∂U/∂q.
    pub(crate) elastic_force: Vec<f64>,
    /// For evaluating it.
    pub(crate) elastic_scratch: ElasticScratch,
    /// Of the components of ν that move: mass matrix with apparent mass, then its factor.
    pub(crate) system: LinearSystem,
    /// Whether it has one.
    pub(crate) regular: bool,
    /// Forces on them, then their accelerations.
    pub(crate) solution: Vec<f64>,
    /// What a gust was at the strips.
    pub(crate) gust: GustAtStrips,
    /// Loads and apparent mass of the strips.
    pub(crate) strip_sums: StripSums,
    /// ν̇ of the last evaluation.
    pub(crate) accelerations: Vec<f64>,
}

impl Workspace {
    /// For the given equations.
    pub fn new(equations: &EquationsOfMotion) -> Self {
        let (components, moving) = (equations.layout().velocities(), equations.moving().len());
        let engines = equations.engine_count();
        Workspace {
            memory: equations.kinematics.memory(),
            inertia: equations.undeformed_inertia(),
            forces: GeneralisedForces::new(components, equations.flap_factors(), engines),
            elastic_force: vec![0.0; equations.layout().modes()],
            elastic_scratch: equations.elastic_scratch(),
            system: equations.linear_system(),
            regular: false,
            solution: vec![0.0; moving],
            gust: equations.gust_at_strips(),
            strip_sums: equations.strip_sums(),
            accelerations: vec![0.0; components],
        }
    }

    /// Sums the forces under given controls on the components of ν that move.
    pub(crate) fn collect_forces(&mut self, controls: &Controls) {
        self.forces.sum(controls);
        for (force, &component) in self.solution.iter_mut().zip(self.strip_sums.moving()) {
            *force = self.forces.total()[component];
        }
    }

    /// ν̇ = [v̇; ω̇; q̈] of the last evaluation.
    pub fn accelerations(&self) -> &[f64] {
        &self.accelerations
    }

    /// Generalised forces on ν of the last evaluation; those of the air on components that cannot move are left out.
    pub fn forces(&self) -> &[f64] {
        self.forces.total()
    }

    /// What kinematics wrote at the last evaluation, for the sections there.
    pub(crate) fn kinematics(&self) -> &AnyMemory {
        &self.memory
    }

    /// The first lifting strip that met the air backwards at the last evaluation.
    pub(crate) fn reversed_strip(&self) -> Option<usize> {
        self.strip_sums.reversed
    }
}

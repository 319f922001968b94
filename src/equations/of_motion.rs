//! The equations of motion [2.2–2.4, 4; physics.md §2, §4, §5].
//!
//! One Cholesky factor of the mass matrix with apparent mass gives the accelerations (LU where the apparent
//! mass is not symmetric: RL, or zero-lift lines off the chord); the inflow rates need none. Components of ν that
//! support or symmetry hold are left out of the matrix.

use std::cell::Cell;

use nalgebra::{DMatrix, Vector3};
use pulp::Arch;

use crate::air::Air;
use crate::aircraft::Support;
use crate::kinematics::{RigidFreedom, RigidMotion};
use crate::math::{Attitude, Counting, LinearSystem, Machine, quaternion_rate};
use crate::strips::{FlapFactor, InflowLayout, PetersInflow, StripSums, Strips, SumLoads};
use crate::structure::{
    ElasticForces, ElasticScratch, ModalIntegrals, ReducedModel, ReducedStrip, StrainEnergy,
};

use super::controls::Controls;
use super::fidelity::{Fidelity, Terms};
use super::inertia::{DeformedInertia, add};
use super::layout::StateLayout;
use super::propulsion::Engines;
use super::structural_forces::StructuralForces;
use super::workspace::Workspace;

/// What distinguishes one set of equations of the same reduced model from another.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// Fidelity level; `Rigid` leaves out the model's modes.
    pub fidelity: Fidelity,
    /// Factor on all elastic properties.
    pub stiffness_scale: f64,
    /// ζ of every mode.
    pub structural_damping: f64,
    /// Inflow states per strip; more than [`PetersInflow::MAX_STATES`] count as that many.
    pub inflow_states: usize,
    /// Steady flow of a wind tunnel around a clamped model, north-east-down, m/s; zero in free flight.
    pub tunnel_flow: Vector3<f64>,
}

/// The equations of motion of one aircraft at one fidelity level: an [example](crate::equations).
#[derive(Clone, Debug)]
pub struct EquationsOfMotion {
    pub(crate) layout: StateLayout,
    pub(crate) terms: Terms,
    support: Support,
    pub(crate) freedom: RigidFreedom,
    pub(crate) gravity: f64,
    pub(crate) integrals: ModalIntegrals,
    strain_energy: StrainEnergy,
    /// ∂U/∂q of the orders that the level keeps.
    pub(crate) elastic_forces: ElasticForces,
    pub(crate) stiffness_scale: f64,
    /// 2ζω_k.
    pub(crate) damping: Vec<f64>,
    pub(crate) strips: Strips,
    engines: Engines,
    pub(crate) inflow: PetersInflow,
    pub(crate) tunnel_flow: Vector3<f64>,
    /// `None`: the standard atmosphere.
    pub(crate) tunnel_air: Option<Air>,
    /// Roll, pitch and yaw in the tunnel, rad.
    pub(crate) mount: Vector3<f64>,
    symmetric: bool,
    /// How wide this machine's vectors are.
    arch: Arch,
}

impl EquationsOfMotion {
    /// The equations for a reduced model, all of whose modes take part unless it is to be rigid.
    pub fn new(model: &ReducedModel, configuration: &Configuration) -> Self {
        EquationsOfMotion::with_freedom(model, &[], configuration, RigidFreedom::All)
    }

    /// The equations of motion in the mirror plane, of a model that stays its own mirror image, and of strips that such
    /// motion meets edge-on: a third of the work.
    pub fn in_plane(model: &ReducedModel, edge_on: &[ReducedStrip], configuration: &Configuration) -> Self {
        EquationsOfMotion::with_freedom(model, edge_on, configuration, RigidFreedom::InPlane)
    }

    /// The equations with what a free support leaves free.
    fn with_freedom(
        model: &ReducedModel,
        edge_on: &[ReducedStrip],
        configuration: &Configuration,
        free: RigidFreedom,
    ) -> Self {
        if configuration.fidelity == Fidelity::Rigid && !model.modes.is_empty() {
            return EquationsOfMotion::with_freedom(&model.select(&[]), edge_on, configuration, free);
        }
        let strips = Strips::new(model, edge_on, free);
        let inflow = PetersInflow::new(configuration.inflow_states);
        let scale = libm::sqrt(configuration.stiffness_scale);
        let damping = |frequency: f64| 2.0 * configuration.structural_damping * scale * frequency;
        let terms = configuration.fidelity.terms();
        let families: Vec<_> = model.modes.iter().map(|mode| mode.family).collect();
        EquationsOfMotion {
            layout: StateLayout::new(
                model.modes.len(),
                InflowLayout::new(strips.groups(), inflow.real_lags(), inflow.lag_pairs()),
            ),
            terms,
            support: model.support,
            freedom: match model.support {
                Support::Free => free,
                Support::Clamped => RigidFreedom::Held,
            },
            gravity: model.gravity,
            integrals: model.integrals.clone(),
            strain_energy: model.strain_energy.clone(),
            elastic_forces: ElasticForces::new(
                &model.strain_energy,
                &families,
                configuration.stiffness_scale,
                terms.cubic_energy,
                terms.quartic_energy,
            ),
            stiffness_scale: configuration.stiffness_scale,
            damping: model.modes.iter().map(|mode| damping(mode.angular_frequency)).collect(),
            symmetric: strips.zero_lift_lines_are_chords()
                && configuration.fidelity != Fidelity::RuthlesslyLinearised,
            strips,
            engines: Engines::new(model),
            inflow,
            tunnel_flow: configuration.tunnel_flow,
            tunnel_air: model.tunnel_air.as_ref().map(Air::of_tunnel),
            mount: model.mount,
            arch: Arch::new(),
        }
    }

    /// The same equations with steady aerodynamics: the same trim, fewer states.
    pub fn with_steady_inflow(&self) -> Self {
        EquationsOfMotion {
            layout: StateLayout::new(self.layout.modes(), InflowLayout::new(self.strips.groups(), 0, 0)),
            inflow: PetersInflow::new(0),
            ..self.clone()
        }
    }

    /// The same equations in another flow of the tunnel (m/s), with all elastic properties multiplied by a factor.
    pub fn varied(&self, tunnel_flow: Vector3<f64>, stiffness: f64) -> Self {
        let mut varied = self.clone();
        varied.tunnel_flow = tunnel_flow;
        varied.stiffness_scale *= stiffness;
        varied.elastic_forces.scale(stiffness);
        let damping = libm::sqrt(stiffness);
        varied.damping.iter_mut().for_each(|rate| *rate *= damping);
        varied
    }

    /// The same equations without wide vectors: slower, with the same bits. For comparisons.
    pub fn one_strip_at_a_time(mut self) -> Self {
        self.take_arch(Arch::Scalar);
        self
    }

    /// Computes with vectors of a given width.
    pub(crate) fn take_arch(&mut self, arch: Arch) {
        self.arch = arch;
    }

    /// Where each part of the state stands.
    pub fn layout(&self) -> &StateLayout {
        &self.layout
    }

    /// The integrals over the mass.
    pub fn integrals(&self) -> &ModalIntegrals {
        &self.integrals
    }

    /// Free flight or wind tunnel.
    pub fn support(&self) -> Support {
        self.support
    }

    /// Number of engines.
    pub fn engine_count(&self) -> usize {
        self.engines.len()
    }

    /// Number of strips.
    pub fn strip_count(&self) -> usize {
        self.strips.count()
    }

    /// A coordinate that moves or turns some strip by about 1 m or 1 rad.
    pub(crate) fn coordinate_magnitude(&self) -> f64 {
        let shape = self.strips.largest_shape();
        if shape > 0.0 { 1.0 / shape } else { 1.0 }
    }

    /// Rates of all states; accelerations stay in the workspace. States beyond the model's validity give NaN.
    pub fn rates(&self, state: &[f64], controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        self.rates_by(self.arch, state, controls, rates, workspace);
    }

    /// How many multiplications of numbers in registers [`rates`](Self::rates) takes at a state.
    pub fn multiplications(&self, state: &[f64], controls: &Controls) -> usize {
        let multiplications = Cell::new(0);
        let counting = Counting { multiplications: &multiplications };
        let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(self));
        self.rates_by(counting, state, controls, &mut rates, &mut workspace);
        multiplications.get()
    }

    /// The rates as a machine computes them.
    #[inline(always)]
    fn rates_by(
        &self,
        machine: impl Machine,
        state: &[f64],
        controls: &Controls,
        rates: &mut [f64],
        workspace: &mut Workspace,
    ) {
        #[cfg(test)]
        super::evaluations::count();
        let layout = &self.layout;
        let attitude = Attitude::from_quaternion(&state[layout.attitude()]);
        self.assemble(machine, (state, &attitude), controls, rates, workspace);
        workspace.collect_forces(controls);
        workspace.regular = workspace.system.solve(machine, &mut workspace.solution);
        self.write_accelerations(rates, workspace);

        let motion = self.motion(state);
        let velocity = attitude.body_from_inertial.tr_mul(&motion.velocity);
        rates[layout.position()].copy_from_slice(velocity.as_slice());
        let quaternion = quaternion_rate(&state[layout.attitude()], &motion.rate);
        rates[layout.attitude()].copy_from_slice(&quaternion);
        rates[layout.coordinates()].copy_from_slice(&state[layout.coordinate_rates()]);
    }

    /// Writes the accelerations under given surface angles and thrusts at the state and in the wind of the last
    /// evaluation into its rates: the same bits as a new evaluation, for next to nothing.
    pub fn steer(&self, controls: &Controls, rates: &mut [f64], workspace: &mut Workspace) {
        workspace.collect_forces(controls);
        if workspace.regular {
            workspace.system.solve_again(&mut workspace.solution);
        }
        self.write_accelerations(rates, workspace);
    }

    /// Writes what was solved for into the accelerations and the rates.
    fn write_accelerations(&self, rates: &mut [f64], workspace: &mut Workspace) {
        let Workspace { regular, solution, strip_sums, accelerations, .. } = workspace;
        for (&component, &acceleration) in strip_sums.moving().iter().zip(&*solution) {
            accelerations[component] = if *regular { acceleration } else { f64::NAN };
        }
        let layout = &self.layout;
        rates[layout.velocity()].copy_from_slice(&accelerations[0..3]);
        rates[layout.rate()].copy_from_slice(&accelerations[3..6]);
        rates[layout.coordinate_rates()].copy_from_slice(&accelerations[6..]);
    }

    /// Sets the inflow states to a wake long at rest in the present flow.
    pub fn settle_inflow(&self, state: &mut [f64], controls: &Controls) {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let (q, q_dot) =
            (state[self.layout.coordinates()].to_vec(), state[self.layout.coordinate_rates()].to_vec());
        let around = self.surroundings(state, (&q, &q_dot), &attitude, controls);
        self.strips.settle_inflow(&around, self.layout.inflow_layout(), state);
    }

    /// Writes the linear part of the inflow's rates at a constant airspeed (m/s) into a vector of the state's
    /// layout, 1/s; of complex states its real and imaginary part.
    pub fn inflow_linear_part(&self, airspeed: f64, linear: &mut [f64]) {
        self.strips.inflow_linear_part(&self.inflow, airspeed, self.layout.inflow_layout(), linear);
    }

    /// Strain energy at q, J, of the orders that the level keeps. Allocates.
    pub fn strain_energy(&self, q: &[f64]) -> f64 {
        let gradient = &mut vec![0.0; q.len()];
        let mut energy = self.strain_energy.add_quadratic(q, gradient);
        if self.terms.cubic_energy {
            energy += self.strain_energy.add_cubic(q, gradient);
        }
        if self.terms.quartic_energy {
            energy += self.strain_energy.add_quartic(q, gradient);
        }
        energy * self.stiffness_scale
    }

    /// v and ω of a state.
    pub fn motion(&self, state: &[f64]) -> RigidMotion {
        RigidMotion {
            velocity: Vector3::from_column_slice(&state[self.layout.velocity()]),
            rate: Vector3::from_column_slice(&state[self.layout.rate()]),
        }
    }

    /// (A⁻¹)_qq: how the generalised coordinates answer forces on themselves, symmetrised. Allocates.
    pub(crate) fn elastic_mobility(
        &self,
        state: &[f64],
        controls: &Controls,
        workspace: &mut Workspace,
    ) -> Option<DMatrix<f64>> {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        self.assemble(self.arch, (state, &attitude), controls, &mut vec![0.0; state.len()], workspace);
        let (rigid, size) = (self.freedom.components().len(), self.moving().len());
        let matrix = &workspace.system.matrix;
        let mut mass = DMatrix::from_fn(size, size, |row, column| matrix[(row, column)]);
        if self.symmetric {
            mass.fill_lower_triangle_with_upper_triangle();
        }
        let inverse = mass.try_inverse()?;
        let elastic = inverse.view_range(rigid.., rigid..);
        Some((elastic + elastic.transpose()) * 0.5)
    }

    /// Places in ν of all that moves.
    pub(crate) fn moving(&self) -> Vec<usize> {
        self.freedom.moving(self.layout.modes())
    }

    /// Room for the mass matrix.
    pub(crate) fn linear_system(&self) -> LinearSystem {
        LinearSystem::new(self.symmetric, self.moving().len())
    }

    /// Room for evaluating the elastic forces.
    pub(crate) fn elastic_scratch(&self) -> ElasticScratch {
        self.elastic_forces.scratch()
    }

    /// The inertia without deformation.
    pub(crate) fn undeformed_inertia(&self) -> DeformedInertia {
        DeformedInertia::undeformed(&self.integrals, self.freedom)
    }

    /// Room for the loads of the strips of these equations.
    pub(crate) fn strip_sums(&self) -> StripSums {
        StripSums::new(&self.strips, self.freedom, self.layout.modes(), self.symmetric)
    }

    /// What the loads of the flaps are proportional to.
    pub(crate) fn flap_factors(&self) -> &[FlapFactor] {
        &self.strips.factors
    }

    /// Writes the mass matrix and the generalised forces into the workspace, the inflow rates into `rates`.
    #[inline(always)]
    fn assemble(
        &self,
        machine: impl Machine,
        (state, attitude): (&[f64], &Attitude),
        controls: &Controls,
        rates: &mut [f64],
        workspace: &mut Workspace,
    ) {
        let q = &state[self.layout.coordinates()];
        let q_dot = &state[self.layout.coordinate_rates()];
        let motion = self.motion(state);
        workspace.forces.clear();
        machine.run(StructuralForces { equations: self, motion: &motion, q, q_dot, workspace });
        let Workspace { inertia, forces, elastic_force, system, strip_sums, .. } = workspace;
        let force = forces.passive_mut();
        for (mode, force) in force[6..].iter_mut().enumerate() {
            *force -= elastic_force[mode] + self.damping[mode] * q_dot[mode];
        }
        let gravity = attitude.body_from_inertial * Vector3::new(0.0, 0.0, self.gravity);
        let arm =
            if self.terms.deformed_forcing { &inertia.first_moment } else { &self.integrals.first_moment };
        add(&mut force[0..3], &(gravity * self.integrals.mass));
        add(&mut force[3..6], &arm.cross(&gravity));
        for (force, momentum) in force[6..].iter_mut().zip(&self.integrals.momentum) {
            *force += momentum.dot(&gravity);
        }
        self.engines.write_effects(q, self.terms.deformed_forcing, forces.of_thrust_mut());

        let around = self.surroundings(state, (q, q_dot), attitude, controls);
        let (strips, layout) = (&self.strips, self.layout.inflow_layout());
        let mass = &mut system.matrix;
        let (passive, effects) = forces.of_air_mut();
        machine.run(SumLoads {
            strips,
            around: &around,
            layout,
            state,
            rates,
            sums: strip_sums,
            passive,
            effects,
            mass,
        });
    }
}

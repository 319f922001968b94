//! What the equations of motion of an aircraft consist of [theory: equations-of-motion.rows; thesis eq. 2.3, 2.4].

use std::sync::Arc;

use nalgebra::Vector3;
use pulp::Arch;

use crate::air::{Atmosphere, FrozenGust};
use crate::aircraft::{Control, Support};
use crate::kinematics::{AnyInertia, AnyKind, RigidFreedom, RigidMotion};
use crate::math::LinearSystem;
use crate::strips::{FlapFactor, GustAtStrips, InflowLayout, PetersInflow, StripSums, Strips};
use crate::structure::{
    ElasticForces, ElasticScratch, ModalIntegrals, ReducedModel, ReducedStrip, StrainEnergy,
};

use super::cuts::Cuts;
use super::fidelity::{ClosesLoop, Fidelity, Terms};
use super::layout::StateLayout;
use super::propulsion::Engines;
use super::station_loads::StationLoads;

/// What distinguishes one set of equations of the same reduced model from another.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// Fidelity level; `Rigid` leaves out the model's modes.
    pub fidelity: Fidelity,
    /// Factor on all elastic properties [theory: strain-energy.scale].
    pub stiffness_scale: f64,
    /// ζ of every mode [theory: strain-energy.damping].
    pub structural_damping: f64,
    /// Inflow states per strip; more than [`PetersInflow::MAX_STATES`] count as that many.
    pub inflow_states: usize,
    /// By how much the air is warmer than the standard atmosphere, K; of no account where the model has air of its own.
    pub temperature_offset: f64,
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
    /// Where all that hangs on the structure is.
    pub(crate) kinematics: AnyKind,
    pub(crate) strips: Strips,
    pub(super) controls: Vec<Control>,
    pub(super) engines: Engines,
    pub(super) station_loads: StationLoads,
    pub(super) cuts: Cuts,
    pub(crate) inflow: PetersInflow,
    pub(crate) tunnel_flow: Vector3<f64>,
    pub(super) atmosphere: Atmosphere,
    /// What blows beside wind and tunnel.
    pub(super) gust: Option<Arc<FrozenGust>>,
    /// Roll, pitch and yaw in the tunnel, rad.
    pub(crate) mount: Vector3<f64>,
    /// Whether the mass matrix is.
    pub(super) self_adjoint: bool,
    /// How wide this machine's vectors are.
    pub(super) arch: Arch,
}

impl EquationsOfMotion {
    /// The equations for a reduced model, all of whose modes take part unless it is to be rigid.
    ///
    /// # Errors
    /// When the level is geometrically exact and the model's joints close loops.
    pub fn new(model: &ReducedModel, configuration: &Configuration) -> Result<Self, ClosesLoop> {
        configuration.fidelity.flies(&model.joints)?;
        Ok(EquationsOfMotion::of_chosen(model, configuration))
    }

    /// The same, of a level that is known to fly the model.
    pub(crate) fn of_chosen(model: &ReducedModel, configuration: &Configuration) -> Self {
        EquationsOfMotion::with_freedom(model, &[], configuration, RigidFreedom::All)
    }

    /// The equations of motion in the mirror plane, of a model that stays its own mirror image, and of strips that such
    /// motion meets edge-on: a third of the work.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn in_plane(
        model: &ReducedModel,
        edge_on: &[ReducedStrip],
        configuration: &Configuration,
    ) -> Result<Self, ClosesLoop> {
        configuration.fidelity.flies(&model.joints)?;
        Ok(EquationsOfMotion::with_freedom(model, edge_on, configuration, RigidFreedom::InPlane))
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
        let strain_energy = if terms.superposed_strains {
            StrainEnergy::of_superposed_strains(model.modes.iter().map(|mode| mode.angular_frequency))
        } else {
            model.strain_energy.clone()
        };
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
            elastic_forces: ElasticForces::new(
                &strain_energy,
                &families,
                configuration.stiffness_scale,
                terms.cubic_energy,
                terms.quartic_energy,
            ),
            strain_energy,
            stiffness_scale: configuration.stiffness_scale,
            damping: model.modes.iter().map(|mode| damping(mode.angular_frequency)).collect(),
            self_adjoint: strips.zero_lift_lines_are_chords()
                && configuration.fidelity != Fidelity::RuthlesslyLinearised,
            kinematics: AnyKind::new(model, edge_on, terms.superposed_strains),
            strips,
            controls: model.controls.clone(),
            engines: Engines::new(model, !terms.deformed_forcing),
            station_loads: StationLoads::default(),
            cuts: Cuts::new(model),
            inflow,
            tunnel_flow: configuration.tunnel_flow,
            atmosphere: Atmosphere::new(model.tunnel_air.as_ref(), configuration.temperature_offset),
            gust: None,
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

    /// From now on the standard atmosphere is warmer by so many K.
    pub(crate) fn take_temperature_offset(&mut self, offset: f64) {
        if let Atmosphere::Standard { temperature_offset } = &mut self.atmosphere {
            *temperature_offset = offset;
        }
    }

    /// From now on these loads act on the stations.
    pub(crate) fn take_loads(&mut self, loads: StationLoads) {
        self.station_loads = loads;
    }

    /// From now on the aircraft flies into this.
    pub fn take_gust(&mut self, gust: Arc<FrozenGust>) {
        self.gust = Some(gust);
    }

    /// Whether loads act on stations.
    pub(crate) fn has_point_loads(&self) -> bool {
        !self.station_loads.are_none()
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

    /// Number of strips.
    pub fn strip_count(&self) -> usize {
        self.strips.count()
    }

    /// Writes the linear part of the inflow's rates at a constant airspeed (m/s) into a vector of the state's
    /// layout, 1/s; of complex states its real and imaginary part.
    pub fn inflow_linear_part(&self, airspeed: f64, linear: &mut [f64]) {
        self.strips.inflow_linear_part(&self.inflow, airspeed, self.layout.inflow_layout(), linear);
    }

    /// Strain energy at q, J, of the orders that the level keeps. Allocates.
    ///
    /// [theory: strain-energy.energy, equations-of-motion.levels]
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

    /// Places in ν of all that moves.
    pub(crate) fn moving(&self) -> Vec<usize> {
        self.freedom.moving(self.layout.modes())
    }

    /// Room for the mass matrix.
    pub(crate) fn linear_system(&self) -> LinearSystem {
        LinearSystem::new(self.self_adjoint, self.moving().len())
    }

    /// Room for evaluating the elastic forces.
    pub(crate) fn elastic_scratch(&self) -> ElasticScratch {
        self.elastic_forces.scratch()
    }

    /// The inertia without deformation.
    pub(crate) fn undeformed_inertia(&self) -> AnyInertia {
        self.kinematics.inertia(&self.integrals, self.freedom)
    }

    /// Room for the loads of the strips of these equations.
    pub(crate) fn strip_sums(&self) -> StripSums {
        self.strips.sums(self.freedom, self.layout.modes(), self.self_adjoint)
    }

    /// Room for what a gust is at the strips.
    pub(crate) fn gust_at_strips(&self) -> GustAtStrips {
        self.strips.gust()
    }

    /// What the loads of the flaps are proportional to.
    pub(crate) fn flap_factors(&self) -> &[FlapFactor] {
        &self.strips.factors
    }
}

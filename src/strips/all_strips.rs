//! All strips of an aircraft: groups of eight, and those that flow in the mirror plane meets edge-on.

use pulp::Scalar;

use crate::air::MetAir;
use crate::kinematics::{RigidFreedom, Sections};
use crate::math::{Eight, LANES, Window};
use crate::structure::{ReducedModel, ReducedStrip};

use super::edge_on::EdgeOnStrips;
use super::flap_factor::FlapFactor;
use super::group::{Group, drags_by_flap};
use super::gust_at_strips::GustAtStrips;
use super::inflow::PetersInflow;
use super::inflow_layout::InflowLayout;
use super::sums::StripSums;
use super::surroundings::Surroundings;

/// All strips of an aircraft.
#[derive(Clone, Debug)]
pub struct Strips {
    /// Number of strips.
    pub(crate) count: usize,
    pub(crate) groups: Vec<Group>,
    /// What the loads of any flap are proportional to.
    pub(crate) factors: Vec<FlapFactor>,
    /// Those that only drag.
    pub(crate) edge_on: EdgeOnStrips,
}

impl Strips {
    /// The strips of a model, and others that flow in the mirror plane meets edge-on; `free` says whether motion is in that
    /// plane.
    pub fn new(model: &ReducedModel, edge_on: &[ReducedStrip], free: RigidFreedom) -> Self {
        let flaps =
            model.strips.iter().filter_map(|strip| Some((strip.flap.as_ref()?, drags_by_flap(strip))));
        let factors = FlapFactor::of_flaps(flaps);
        let group = |strips| Group::new(strips, &factors, free);
        Strips {
            count: model.strips.len(),
            groups: model.strips.chunks(LANES).map(group).collect(),
            factors,
            edge_on: EdgeOnStrips::new(edge_on),
        }
    }

    /// Number of strips, without those edge-on.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of groups of strips.
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// Whether ẇ and the loads are linear in the same rows, so that apparent mass is self-adjoint.
    pub fn zero_lift_lines_are_chords(&self) -> bool {
        self.groups.iter().all(|group| group.zero_lift_offset == Eight::ZERO)
    }

    /// Room for the sums over them; of the generalised forces and masses those of the components of ν that move, `equal_rows`
    /// where accelerations are distributed as loads are.
    pub fn sums(&self, freedom: RigidFreedom, modes: usize, equal_rows: bool) -> StripSums {
        StripSums::new([self.groups.len(), self.factors.len()], freedom, modes, equal_rows)
    }

    /// Room for what a gust is at them.
    pub fn gust(&self) -> GustAtStrips {
        GustAtStrips::new([self.groups.len(), self.edge_on.groups().count()])
    }

    /// Writes the inflow's linear part at a constant airspeed (m/s) into a vector of the state's layout, 1/s.
    pub fn inflow_linear_part(
        &self,
        inflow: &PetersInflow,
        airspeed: f64,
        layout: &InflowLayout,
        linear: &mut [f64],
    ) {
        for (index, group) in self.groups.iter().enumerate() {
            let passing = Eight(group.aerofoil.semichord.0.map(|semichord| airspeed / semichord));
            inflow.linear_part(&passing, &mut layout.of_group(index).write(linear));
        }
    }

    /// Sets the inflow states of every strip to a wake long at rest.
    pub fn settle_inflow(
        &self,
        sections: &impl Sections,
        around: &Surroundings<impl MetAir>,
        layout: &InflowLayout,
        state: &mut [f64],
    ) {
        for (index, group) in self.groups.iter().enumerate() {
            let sections = sections.of_strips(index);
            for window in Window::all(Scalar::new()) {
                let w3 = group.deform::<Scalar, false>(window, (index, &sections), around).flow.w3;
                around.inflow.settle(window, w3, &mut layout.of_group(index).write(state));
            }
        }
    }
}

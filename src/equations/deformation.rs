//! How the structure is deformed in a state, and what is read of it there.
//!
//! [theory: kinematics.sections]

use nalgebra::Vector3;
use pulp::Scalar;

use crate::kinematics::{Coordinates, Kinematics, OfKind, Sections, by_kind};
use crate::math::Attitude;

use super::controls::Controls;
use super::of_motion::EquationsOfMotion;

impl EquationsOfMotion {
    /// q and q̇ of a state.
    #[inline(always)]
    pub(crate) fn coordinates<'a>(&self, state: &'a [f64]) -> Coordinates<'a> {
        Coordinates { q: &state[self.layout.coordinates()], q_dot: &state[self.layout.coordinate_rates()] }
    }

    /// Sets the inflow states to a wake long at rest in the present flow. Allocates.
    pub fn settle_inflow(&self, state: &mut [f64], controls: &Controls) {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let around = self.surroundings(state, &attitude, controls);
        let present = state.to_vec();
        let (strips, layout) = (&self.strips, self.layout.inflow_layout());
        by_kind!(&self.kinematics, |kinematics| {
            let (at, memory) = self.evaluated(kinematics, &present);
            strips.settle_inflow(&kinematics.sections(at, &memory), &around, layout, state);
        });
    }

    /// How far each strip is in a state from where it is on the undeformed aircraft, without those edge-on, m. Allocates.
    pub(crate) fn strip_displacements(&self, state: &[f64]) -> Vec<Vector3<f64>> {
        by_kind!(&self.kinematics, |kinematics| {
            let (at, memory) = self.evaluated(kinematics, state);
            kinematics.sections(at, &memory).strip_displacements().collect()
        })
    }

    /// Where a kind is evaluated in a state, and what it writes, if there is no workspace that has been there. Allocates.
    pub(super) fn evaluated<'a, K: Kinematics>(
        &self,
        kinematics: &K,
        state: &'a [f64],
    ) -> (Coordinates<'a>, K::Memory) {
        let (at, mut memory) = (self.coordinates(state), kinematics.memory());
        kinematics.evaluate(Scalar::new(), at, &mut memory);
        (at, memory)
    }

    /// A coordinate that moves or turns some strip by about 1 m or 1 rad.
    pub(crate) fn coordinate_magnitude(&self) -> f64 {
        reciprocal(self.kinematics.largest_shape())
    }

    /// The coordinate (√kg m) by which the most moving strip is displaced by a metre.
    pub(crate) fn metre_of_displacement(&self) -> f64 {
        reciprocal(self.kinematics.largest_displacement())
    }
}

/// 1/x, or 1 where nothing moves.
fn reciprocal(shape: f64) -> f64 {
    if shape > 0.0 { 1.0 / shape } else { 1.0 }
}

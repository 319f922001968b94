//! How the structure is deformed in a state, and what is read of it there.
//!
//! [theory: kinematics.sections]

use pulp::Scalar;

use crate::kinematics::{Coordinates, Kinematics, Memory, Sections};
use crate::math::Attitude;

use super::controls::Controls;
use super::of_motion::EquationsOfMotion;

impl EquationsOfMotion {
    /// q and q̇ of a state.
    #[inline(always)]
    pub(crate) fn coordinates<'a>(&self, state: &'a [f64]) -> Coordinates<'a> {
        Coordinates { q: &state[self.layout.coordinates()], q_dot: &state[self.layout.coordinate_rates()] }
    }

    /// What kinematics writes in a state, where there is no workspace that has been there. Allocates.
    pub(crate) fn evaluate_kinematics(&self, state: &[f64]) -> Memory {
        let mut memory = self.kinematics.memory();
        self.kinematics.evaluate(Scalar::new(), self.coordinates(state), &mut memory);
        memory
    }

    /// The sections in a state in which kinematics has been evaluated.
    pub(crate) fn sections<'a>(&'a self, state: &'a [f64], memory: &'a Memory) -> impl Sections + 'a {
        self.kinematics.sections(self.coordinates(state), memory)
    }

    /// Sets the inflow states to a wake long at rest in the present flow. Allocates.
    pub fn settle_inflow(&self, state: &mut [f64], controls: &Controls) {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let around = self.surroundings(state, &attitude, controls);
        let (present, memory) = (state.to_vec(), self.evaluate_kinematics(state));
        let sections = self.sections(&present, &memory);
        self.strips.settle_inflow(&sections, &around, self.layout.inflow_layout(), state);
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

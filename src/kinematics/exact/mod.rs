//! Geometrically exact kinematics: the strains of the modes are superposed, and where sections are and how they are turned
//! follows from them by finite kinematics along the tree of beams.
//!
//! [theory: geometrically-exact.sections, geometrically-exact.recursion, geometrically-exact.inertia]
//!
//! Everything that an evaluation writes is found once, for all sections; what hangs on them then reads it.

mod attached;
mod bodies;
mod cut;
mod eight;
mod helix;
mod in_plane;
mod inertia;
mod instant;
mod moving;
mod series;
mod strands;
mod sums;
#[cfg(test)]
mod tests;
mod tree;
mod twists;

use pulp::Scalar;

use crate::math::Arithmetic;
use crate::structure::{ModalIntegrals, ReducedModel, ReducedStrip};

use super::freedom::RigidFreedom;
use super::kind::{Coordinates, Kinematics};
use inertia::ExactInertia;
pub use instant::GeometricallyExact;
use instant::{ExactMemory, Instant};

impl Kinematics for GeometricallyExact {
    type Memory = ExactMemory;
    type Instant<'a> = Instant<'a>;
    type Inertia = ExactInertia;

    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        GeometricallyExact::of(model, edge_on)
    }

    fn memory(&self) -> ExactMemory {
        let mut memory = self.room();
        let zero = vec![0.0; self.modes()];
        self.write(Scalar::new(), Coordinates { q: &zero, q_dot: &zero }, &mut memory);
        memory
    }

    /// The bodies on the sections have all mass: no integral is needed.
    fn inertia(&self, _: &ModalIntegrals, freedom: RigidFreedom) -> ExactInertia {
        ExactInertia::new(Scalar::new(), self.modes(), freedom, &self.at(&self.memory()))
    }

    #[inline(always)]
    fn evaluate<S: Arithmetic>(&self, simd: S, at: Coordinates, memory: &mut ExactMemory) {
        self.write(simd, at, memory);
    }

    #[inline(always)]
    fn sections<'a>(&'a self, _: Coordinates<'a>, memory: &'a ExactMemory) -> Instant<'a> {
        self.at(memory)
    }

    fn largest_displacement(&self) -> f64 {
        self.largest()[0]
    }

    fn largest_shape(&self) -> f64 {
        self.largest()[1]
    }
}

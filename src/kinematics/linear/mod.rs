//! The thesis' kinematics: displacements and rotation vectors are sums of mode shapes, u = Ψᵘq and φ = Ψᵠq.
//!
//! [theory: kinematics.superposition, frames.displacement, frames.rotation, frames.spin; thesis eq. 2.1]
//!
//! The rows are constants, J = Ψᵘ and S = Ψᵠ: nothing is left of the rates of Jq̇ and Sq̇ at q̈ = 0, and nothing is to be
//! written at an instant. But a section turns by exp(φ×), and its spin σ is the true rate of that, which for finite φ is not
//! quite Ψᵠq̇.

mod eight;
mod inertia;
mod section;
mod superposition;

use crate::math::Arithmetic;
use crate::structure::{ModalIntegrals, ReducedModel, ReducedStrip};

use super::freedom::RigidFreedom;
use super::kind::{Coordinates, Kinematics};
use inertia::SuperposedInertia;
use superposition::Instant;
pub use superposition::Superposition;

/// Nothing: whatever superposition needs is constant.
#[derive(Clone, Debug)]
pub struct NoMemory;

impl Kinematics for Superposition {
    type Memory = NoMemory;
    type Instant<'a> = Instant<'a>;
    type Inertia = SuperposedInertia;

    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        Superposition::of(model, edge_on)
    }

    fn memory(&self) -> NoMemory {
        NoMemory
    }

    fn inertia(&self, integrals: &ModalIntegrals, freedom: RigidFreedom) -> SuperposedInertia {
        SuperposedInertia::undeformed(integrals, freedom)
    }

    #[inline(always)]
    fn evaluate<S: Arithmetic>(&self, _: S, _: Coordinates, _: &mut NoMemory) {}

    #[inline(always)]
    fn sections<'a>(&'a self, at: Coordinates<'a>, _: &'a NoMemory) -> Instant<'a> {
        self.at(at)
    }

    fn largest_displacement(&self) -> f64 {
        self.largest(0..3)
    }

    fn largest_shape(&self) -> f64 {
        self.largest(0..6)
    }
}

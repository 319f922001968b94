//! What a kind of kinematics is: how sections follow from q and q̇, and what the mass on them does.
//!
//! [theory: kinematics.kinds, kinematics.inertia]
//!
//! A kind is evaluated once at an instant, before anything reads it: what it has to write goes to its memory. Sections and
//! inertia then read that; a kind whose rows are constants writes nothing. Its inertia alone knows where the mass is and asks
//! the kind's own sections for what it needs there.

use std::fmt::Debug;

use nalgebra::Vector3;

use crate::math::{Arithmetic, SquareMatrix};
use crate::structure::{ModalIntegrals, ReducedModel, ReducedStrip};

use super::freedom::RigidFreedom;
use super::rigid_motion::RigidMotion;
use super::sections::Sections;

/// The generalised coordinates of an instant.
#[derive(Clone, Copy, Debug)]
pub struct Coordinates<'a> {
    /// q.
    pub q: &'a [f64],
    /// q̇.
    pub q_dot: &'a [f64],
}

/// A kind of kinematics: what of an aircraft says where its sections are and how they move.
pub trait Kinematics: Clone + Debug {
    /// What an evaluation writes.
    type Memory: Clone + Debug;

    /// All sections at an instant.
    type Instant<'a>: Sections + Copy
    where
        Self: 'a;

    /// What the mass does that moves so.
    type Inertia: Inertia<Self>;

    /// Of a model, and of other strips with the same modes that flow in the mirror plane meets edge-on.
    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self;

    /// Room for an evaluation.
    fn memory(&self) -> Self::Memory;

    /// The inertia of the undeformed aircraft, whose integrals over the mass these are.
    fn inertia(&self, integrals: &ModalIntegrals, freedom: RigidFreedom) -> Self::Inertia;

    /// Writes what the sections at some q and q̇ need.
    fn evaluate<S: Arithmetic>(&self, simd: S, at: Coordinates, memory: &mut Self::Memory);

    /// The sections at the q and q̇ of the last evaluation.
    fn sections<'a>(&'a self, at: Coordinates<'a>, memory: &'a Self::Memory) -> Self::Instant<'a>;

    /// The largest displacement of any strip, without those edge-on, by a small unit coordinate, m.
    fn largest_displacement(&self) -> f64;

    /// The largest displacement or rotation, m or rad.
    fn largest_shape(&self) -> f64;
}

/// What the mass of an aircraft does that moves by a kind of kinematics, on those components of ν that move.
pub trait Inertia<K: Kinematics>: Clone + Debug {
    /// Follows the deformation; who never asks for that has the undeformed aircraft.
    fn deform<S: Arithmetic>(&mut self, simd: S, sections: &K::Instant<'_>);

    /// Writes the mass matrix [[m1, −c×, P], [c×, J, H], [Pᵀ, Hᵀ, M]] of the present deformation, or of the undeformed
    /// aircraft, without the rows and columns that do not move.
    fn write_mass_matrix(&self, sections: &K::Instant<'_>, deformed: bool, matrix: &mut SquareMatrix);

    /// Adds the inertial forces on ν in a motion of the body axes that no acceleration makes; those that q̇ makes only
    /// `with_rates`.
    fn add_forces<S: Arithmetic>(
        &mut self,
        simd: S,
        sections: &K::Instant<'_>,
        motion: &RigidMotion,
        with_rates: bool,
        force: &mut [f64],
    );

    /// Adds the generalised forces of gravity, body axes, m/s².
    fn add_gravity(&self, sections: &K::Instant<'_>, gravity: &Vector3<f64>, force: &mut [f64]);
}

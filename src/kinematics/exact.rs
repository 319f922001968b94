//! Geometrically exact kinematics: for now no more than the place where it will stand, with superposition in it.
//!
//! [theory: kinematics.kinds]

use nalgebra::Vector3;

use crate::math::{Arithmetic, SquareMatrix};
use crate::structure::{ModalIntegrals, ReducedModel, ReducedStrip};

use super::freedom::RigidFreedom;
use super::kind::{Coordinates, Inertia, Kinematics};
use super::linear::Superposition;
use super::rigid_motion::RigidMotion;

type Memory = <Superposition as Kinematics>::Memory;
type Instant<'a> = <Superposition as Kinematics>::Instant<'a>;

/// The sections of an aircraft.
#[derive(Clone, Debug)]
pub struct GeometricallyExact(Superposition);

/// What its mass does.
#[derive(Clone, Debug)]
pub struct ExactInertia(<Superposition as Kinematics>::Inertia);

impl Kinematics for GeometricallyExact {
    type Memory = Memory;
    type Instant<'a> = Instant<'a>;
    type Inertia = ExactInertia;

    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        GeometricallyExact(Superposition::new(model, edge_on))
    }

    fn memory(&self) -> Memory {
        self.0.memory()
    }

    fn inertia(&self, integrals: &ModalIntegrals, freedom: RigidFreedom) -> ExactInertia {
        ExactInertia(self.0.inertia(integrals, freedom))
    }

    fn evaluate<S: Arithmetic>(&self, simd: S, at: Coordinates, memory: &mut Memory) {
        self.0.evaluate(simd, at, memory);
    }

    fn sections<'a>(&'a self, at: Coordinates<'a>, memory: &'a Memory) -> Instant<'a> {
        self.0.sections(at, memory)
    }

    fn largest_displacement(&self) -> f64 {
        self.0.largest_displacement()
    }

    fn largest_shape(&self) -> f64 {
        self.0.largest_shape()
    }
}

impl Inertia<GeometricallyExact> for ExactInertia {
    fn deform<S: Arithmetic>(&mut self, simd: S, sections: &Instant<'_>) {
        self.0.deform(simd, sections);
    }

    fn write_mass_matrix(&self, sections: &Instant<'_>, deformed: bool, matrix: &mut SquareMatrix) {
        self.0.write_mass_matrix(sections, deformed, matrix);
    }

    fn add_forces<S: Arithmetic>(
        &mut self,
        simd: S,
        sections: &Instant<'_>,
        motion: &RigidMotion,
        with_rates: bool,
        force: &mut [f64],
    ) {
        self.0.add_forces(simd, sections, motion, with_rates, force);
    }

    fn add_gravity(&self, sections: &Instant<'_>, gravity: &Vector3<f64>, force: &mut [f64]) {
        self.0.add_gravity(sections, gravity, force);
    }
}

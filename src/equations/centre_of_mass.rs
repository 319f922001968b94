//! Where the centre of mass of the deformed aircraft is and how it moves [theory: outputs.centre-of-mass].

use nalgebra::Vector3;

use crate::kinematics::{Carried, CarriesMass, GeneralisedVector, Kinematics, OfKind, Section, Sections};
use crate::structure::ModalIntegrals;

use super::of_motion::EquationsOfMotion;
use super::workspace::Workspace;

/// Relative to the body axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CentreOfMass {
    /// m.
    pub position: Vector3<f64>,
    /// m/s.
    pub velocity: Vector3<f64>,
    /// m/s².
    pub acceleration: Vector3<f64>,
}

impl EquationsOfMotion {
    /// In the state of the last evaluation.
    pub(crate) fn centre_of_mass(&self, state: &[f64], workspace: &Workspace) -> CentreOfMass {
        let GeneralisedVector { modal: q_ddot, .. } = GeneralisedVector::of(workspace.accelerations());
        let at = self.coordinates(state);
        match self.kinematics.as_ref().with(workspace.kinematics().as_ref()) {
            OfKind::Superposition(_) => {
                let ModalIntegrals { mass, first_moment, momentum, .. } = &self.integrals;
                let sum = |numbers: &[f64]| {
                    let products = momentum.iter().zip(numbers).map(|(p, number)| p * *number);
                    products.sum::<Vector3<f64>>() / *mass
                };
                CentreOfMass {
                    position: first_moment / *mass + sum(at.q),
                    velocity: sum(at.q_dot),
                    acceleration: sum(q_ddot),
                }
            }
            OfKind::GeometricallyExact((kinematics, memory)) => {
                self.centre_of_masses(&kinematics.sections(at, memory), q_ddot)
            }
        }
    }

    /// Mass by mass.
    fn centre_of_masses(&self, sections: &impl Sections, q_ddot: &[f64]) -> CentreOfMass {
        let zero = Vector3::zeros();
        let mut sum = CentreOfMass { position: zero, velocity: zero, acceleration: zero };
        for (body, section) in self.cuts.bodies().iter().zip(sections.masses()) {
            let Carried { now, rate, acceleration } = section.carried(q_ddot);
            let share = body.mass / self.integrals.mass;
            sum.position += (section.at_rest() + section.displacement() + now * body.offset) * share;
            sum.velocity += (section.velocity() + rate * body.offset) * share;
            sum.acceleration += (section.acceleration(q_ddot) + acceleration * body.offset) * share;
        }
        sum
    }
}

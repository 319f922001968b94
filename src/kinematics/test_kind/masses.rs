//! Masses on the sections of the kind of kinematics for tests: sums over bodies, of which nothing is integrated beforehand.

use nalgebra::{Matrix3, Vector3};

use crate::math::{Arithmetic, SquareMatrix};

use super::super::freedom::RigidFreedom;
use super::super::kind::Inertia;
use super::super::rigid_motion::RigidMotion;
use super::super::sections::Section;
use super::{Curved, Memory, Written};

/// Of each mass, kg and kg·m².
const MASS: f64 = 70.0;
const INERTIA: [f64; 3] = [20.0, 30.0, 45.0];

/// Equal masses at all stations [theory: kinematics.inertia].
#[derive(Clone, Debug)]
pub struct Masses {
    freedom: RigidFreedom,
}

impl Masses {
    /// With what moves of the rigid motion.
    pub fn new(freedom: RigidFreedom) -> Self {
        Masses { freedom }
    }

    /// Of a mass: its translation and its rotation by a unit of each component of ν.
    fn motions(section: &Written) -> Vec<[Vector3<f64>; 2]> {
        let axes = [0, 1, 2].map(|axis| Vector3::ith(axis, 1.0));
        let translations = axes.iter().map(|axis| [*axis, Vector3::zeros()]);
        let rotations = axes.iter().map(|axis| [axis.cross(&section.position), *axis]);
        let rows = section
            .rows
            .iter()
            .map(|[a, b, c, d, e, f]| [Vector3::new(*a, *b, *c), Vector3::new(*d, *e, *f)]);
        translations.chain(rotations).chain(rows).collect()
    }

    /// I, body axes.
    fn inertia(section: &Written) -> Matrix3<f64> {
        let columns = [0, 1, 2].map(|axis| section.turned(&Vector3::ith(axis, 1.0)));
        let turn = Matrix3::from_columns(&columns);
        turn * Matrix3::from_diagonal(&INERTIA.into()) * turn.transpose()
    }
}

impl Inertia<Curved> for Masses {
    fn deform<S: Arithmetic>(&mut self, _: S, _: &&Memory) {}

    fn write_mass_matrix(&self, sections: &&Memory, _: bool, matrix: &mut SquareMatrix) {
        let moving = self.freedom.moving(matrix.size() - self.freedom.components().len());
        for (row, &i) in moving.iter().enumerate() {
            for (column, &j) in moving.iter().enumerate() {
                let product = |section: &Written| {
                    let motions = Masses::motions(section);
                    let ([translation, rotation], [other, turn]) = (motions[i], motions[j]);
                    MASS * translation.dot(&other) + rotation.dot(&(Masses::inertia(section) * turn))
                };
                matrix[(row, column)] = sections.stations.iter().map(product).sum();
            }
        }
    }

    fn add_forces<S: Arithmetic>(
        &mut self,
        _: S,
        sections: &&Memory,
        RigidMotion { velocity, rate }: &RigidMotion,
        _: bool,
        force: &mut [f64],
    ) {
        for section in &sections.stations {
            let Written { position, velocity: relative, acceleration, angular_acceleration, spin, .. } =
                section;
            let (inertia, spin) = (Masses::inertia(section), Vector3::y() * *spin);
            let along = rate.cross(&(velocity + rate.cross(position) + relative * 2.0)) + acceleration;
            let (turning, alpha) = (rate + spin, Vector3::y() * *angular_acceleration);
            let about = inertia * (rate.cross(&spin) + alpha) + turning.cross(&(inertia * turning));
            for (force, [translation, rotation]) in force.iter_mut().zip(Masses::motions(section)) {
                *force -= MASS * along.dot(&translation) + about.dot(&rotation);
            }
        }
    }

    fn add_gravity(&self, sections: &&Memory, gravity: &Vector3<f64>, force: &mut [f64]) {
        for section in &sections.stations {
            for (force, [translation, _]) in force.iter_mut().zip(Masses::motions(section)) {
                *force += MASS * gravity.dot(&translation);
            }
        }
    }
}

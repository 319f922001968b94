//! The shape and attitude in which an aircraft is in equilibrium, to be compared with others.
//!
//! [theory: stability.losses]

use nalgebra::Vector3;

use crate::plant::{Plant, Trim};

/// The shape and attitude of an aircraft in trim.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Equilibrium {
    /// Of the strips, m.
    displacements: Vec<Vector3<f64>>,
    /// The quaternion of the attitude, angles of the controls, rad.
    angles: Vec<f64>,
}

impl Equilibrium {
    pub fn new(plant: &Plant, trim: &Trim) -> Self {
        let layout = plant.layout();
        let mut angles = trim.state[layout.attitude()].to_vec();
        angles.extend(&trim.controls.angles);
        let displacements = plant.strip_displacements(&trim.state);
        Equilibrium { displacements, angles }
    }

    /// How far from another one: the greatest difference, of shapes as shares of a length (m), or of angles.
    pub fn distance(&self, other: &Equilibrium, size: f64) -> f64 {
        let angles = self.angles.iter().zip(&other.angles).map(|(a, b)| (a - b).abs());
        let farthest = self.farthest(other).map_or(0.0, |(_, displacement)| displacement / size);
        angles.fold(farthest, f64::max)
    }

    /// The strip that differs most in place, and by how much, m.
    pub fn farthest(&self, other: &Equilibrium) -> Option<(usize, f64)> {
        let differences = self.displacements.iter().zip(&other.displacements).map(|(a, b)| (a - b).norm());
        differences.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))
    }
}

//! Four strips side by side: the numbers of a group of strips, computed together.
//!
//! Every lane is computed by the same IEEE operations in the same order whatever the width of the machine's
//! vectors, so results do not depend on it.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::Vector3;

/// One number for each of four strips.
pub type Lanes = wide::f64x4;

/// How many strips a group has.
pub const LANES: usize = 4;

/// One vector for each of four strips.
#[derive(Clone, Copy, Debug)]
pub struct LaneVector {
    /// x components.
    pub x: Lanes,
    /// y components.
    pub y: Lanes,
    /// z components.
    pub z: Lanes,
}

impl LaneVector {
    /// The same vector in every lane.
    pub fn splat(vector: &Vector3<f64>) -> Self {
        LaneVector { x: Lanes::splat(vector.x), y: Lanes::splat(vector.y), z: Lanes::splat(vector.z) }
    }

    /// A vector for each lane.
    pub fn new(vectors: [Vector3<f64>; LANES]) -> Self {
        let component = |axis: usize| Lanes::new(vectors.map(|vector| vector[axis]));
        LaneVector { x: component(0), y: component(1), z: component(2) }
    }

    /// Scalar products.
    pub fn dot(&self, other: &LaneVector) -> Lanes {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Vector products.
    pub fn cross(&self, other: &LaneVector) -> LaneVector {
        LaneVector {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

impl Add for LaneVector {
    type Output = LaneVector;

    fn add(self, other: LaneVector) -> LaneVector {
        LaneVector { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl Sub for LaneVector {
    type Output = LaneVector;

    fn sub(self, other: LaneVector) -> LaneVector {
        LaneVector { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl Mul<Lanes> for LaneVector {
    type Output = LaneVector;

    fn mul(self, factor: Lanes) -> LaneVector {
        LaneVector { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

impl Neg for LaneVector {
    type Output = LaneVector;

    fn neg(self) -> LaneVector {
        LaneVector { x: -self.x, y: -self.y, z: -self.z }
    }
}

/// Reads four consecutive numbers.
pub fn load(numbers: &[f64]) -> Lanes {
    Lanes::new([numbers[0], numbers[1], numbers[2], numbers[3]])
}

/// Sum over the lanes, in a fixed order.
pub fn sum(lanes: Lanes) -> f64 {
    let [a, b, c, d] = lanes.to_array();
    (a + b) + (c + d)
}

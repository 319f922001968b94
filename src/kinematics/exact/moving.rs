//! Eight sections side by side at an instant, and a single one of them.
//!
//! [theory: geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.attached]
//!
//! What sections add to those before them is summed along the strands in its own place.

use nalgebra::{Matrix3, Vector3};

use crate::math::{Eight, EightVectors, LANES};

use super::strands::Part;

/// No turn.
pub const AT_REST: [Eight; 4] = [Eight([1.0; 8]), Eight::ZERO, Eight::ZERO, Eight::ZERO];

/// Eight sections relative to the body axes.
#[derive(Clone, Debug)]
pub struct EightMoving {
    /// Columns of R.
    pub turn: [EightVectors; 3],
    /// x, m.
    pub position: EightVectors,
    /// w, m/s.
    pub velocity: EightVectors,
    /// σ, rad/s.
    pub spin: EightVectors,
    /// a, m/s².
    pub acceleration: EightVectors,
    /// α, rad/s².
    pub angular_acceleration: EightVectors,
    /// w° about O, m/s.
    pub velocity_about_origin: EightVectors,
    /// a° about O, m/s².
    pub acceleration_about_origin: EightVectors,
    /// R as unit quaternions, scalar first.
    pub quaternion: [Eight; 4],
}

/// A section at an instant, relative to the body axes.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    /// R.
    pub turn: Matrix3<f64>,
    /// x, m.
    pub position: Vector3<f64>,
    /// w, m/s.
    pub velocity: Vector3<f64>,
    /// σ, rad/s.
    pub spin: Vector3<f64>,
    /// a, m/s².
    pub acceleration: Vector3<f64>,
    /// α, rad/s².
    pub angular_acceleration: Vector3<f64>,
}

impl EightMoving {
    /// At rest at O.
    pub fn resting() -> Self {
        let of = |vector: Vector3<f64>| EightVectors::new([vector; LANES]);
        let (none, axes) = (of(Vector3::zeros()), [Vector3::x(), Vector3::y(), Vector3::z()].map(of));
        EightMoving {
            turn: axes,
            position: none,
            velocity: none,
            spin: none,
            acceleration: none,
            angular_acceleration: none,
            velocity_about_origin: none,
            acceleration_about_origin: none,
            quaternion: AT_REST,
        }
    }

    /// One of the sections.
    pub fn single(&self, lane: usize) -> Moving {
        Moving {
            turn: Matrix3::from_columns(&self.turn.each_ref().map(|column| column.of_lane(lane))),
            position: self.position.of_lane(lane),
            velocity: self.velocity.of_lane(lane),
            spin: self.spin.of_lane(lane),
            acceleration: self.acceleration.of_lane(lane),
            angular_acceleration: self.angular_acceleration.of_lane(lane),
        }
    }
}

impl Moving {
    /// What is fixed to the section at an offset [theory: geometrically-exact.attached].
    #[inline(always)]
    pub fn with_offset(&self, offset: &Vector3<f64>) -> Self {
        let arm = self.turn * offset;
        let circling = self.spin.cross(&arm);
        Moving {
            position: self.position + arm,
            velocity: self.velocity + circling,
            acceleration: self.acceleration
                + self.angular_acceleration.cross(&arm)
                + self.spin.cross(&circling),
            ..*self
        }
    }
}

/// Sums what each section of a part of a group adds to those before it, in its place.
#[inline(always)]
pub fn add_up<const N: usize>(
    part: &Part,
    eights: &mut [EightMoving],
    index: usize,
    summed: impl Fn(&mut EightMoving) -> [&mut Eight; N],
) {
    let [eight, lane] = part.parent;
    let mut sums = summed(&mut eights[eight]).map(|own| own.0[lane]);
    let mut own = summed(&mut eights[index]);
    for lane in part.lanes.clone().map(|lane| lane % LANES) {
        for (own, sum) in own.iter_mut().zip(&mut sums) {
            *sum += own.0[lane];
            own.0[lane] = *sum;
        }
    }
}

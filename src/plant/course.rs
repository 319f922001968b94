//! The initial heading: a plant is computed in axes forward, right, down along it [theory: frames.course].
//!
//! Nothing depends on where north is but the wind and what one reads. Along the course, symmetric flight is exactly
//! symmetric whatever the heading.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use crate::math::{Attitude, ROUNDING, quaternion_product};

/// A turn about the vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    sin: f64,
    cos: f64,
    /// Scalar and vertical part of its quaternion.
    quaternion: [f64; 2],
}

impl Course {
    /// To the north.
    pub const NORTH: Course = Course { sin: 0.0, cos: 1.0, quaternion: [1.0, 0.0] };

    /// Along a heading, rad from north to east.
    pub fn new(heading: f64) -> Self {
        let (sin, cos) = libm::sincos(heading);
        let (half_sin, half_cos) = libm::sincos(0.5 * libm::remainder(heading, TAU));
        Course { sin, cos, quaternion: [half_cos, half_sin] }
    }

    /// The same, on which an aircraft begins at an attitude along it: its quaternion has a scalar part there that is not
    /// negative.
    pub(crate) fn from(self, attitude: &[f64]) -> Self {
        let [scalar, vertical] = self.quaternion;
        let is_negative = self.quaternion(attitude)[0] < 0.0;
        if is_negative { Course { quaternion: [-scalar, -vertical], ..self } } else { self }
    }

    /// By how much the yaw angle of an attitude along it is greater than that from it, rad; between half turns at that attitude.
    pub(crate) fn yaw_beyond(self, attitude: &[f64]) -> f64 {
        let along = Attitude::from_quaternion(attitude);
        let from_north = Attitude { body_from_inertial: along.body_from_inertial * self.matrix() };
        from_north.euler_angles().z - along.euler_angles().z
    }

    /// The same with that of its two quaternions which is nearer to another course's.
    pub(crate) fn beside(self, other: Course) -> Self {
        let [scalar, vertical] = self.quaternion;
        let is_far = scalar * other.quaternion[0] + vertical * other.quaternion[1] < 0.0;
        if is_far { Course { quaternion: [-scalar, -vertical], ..self } } else { self }
    }

    /// The unit quaternion (scalar first) that turns body components into north, east, down, of an attitude along the course.
    pub(crate) fn quaternion(self, attitude: &[f64]) -> [f64; 4] {
        let [scalar, vertical] = self.quaternion;
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| attitude[part]);
        let length = libm::sqrt(w * w + x * x + y * y + z * z);
        quaternion_product([scalar, 0.0, 0.0, vertical], [w, x, y, z]).map(|part| part / length)
    }

    /// North, east, down from forward, right, down.
    pub fn north_east_down(self, vector: &Vector3<f64>) -> Vector3<f64> {
        let Course { sin, cos, .. } = self;
        Vector3::new(cos * vector.x - sin * vector.y, sin * vector.x + cos * vector.y, vector.z)
    }

    /// Forward, right, down from north, east, down; what is along the course but for rounding is along it.
    pub fn along(self, vector: &Vector3<f64>) -> Vector3<f64> {
        let Course { sin, cos, .. } = self;
        let right = cos * vector.y - sin * vector.x;
        let is_rounding = right.abs() <= ROUNDING * vector.x.abs().max(vector.y.abs());
        let right = if is_rounding { 0.0 } else { right };
        Vector3::new(cos * vector.x + sin * vector.y, right, vector.z)
    }

    /// The matrix of [`along`](Self::along), without its regard for rounding.
    pub fn matrix(self) -> Matrix3<f64> {
        let Course { sin, cos, .. } = self;
        Matrix3::new(cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_course_to_the_east_has_east_ahead_and_south_to_the_right() {
        let course = Course::new(std::f64::consts::FRAC_PI_2);
        assert!((course.north_east_down(&Vector3::x()) - Vector3::y()).norm() < 1e-15);
        assert!((course.north_east_down(&Vector3::y()) + Vector3::x()).norm() < 1e-15);
        let arrow = Vector3::new(0.3, -2.0, 0.7);
        assert!((course.along(&course.north_east_down(&arrow)) - arrow).norm() < 1e-15);
        assert!((course.matrix() * arrow - course.along(&arrow)).norm() < 1e-15);
    }

    #[test]
    fn what_is_along_a_course_has_nothing_to_the_right() {
        for degrees in 0..360 {
            let heading = f64::from(degrees).to_radians();
            let ahead = Vector3::new(libm::cos(heading), libm::sin(heading), 0.0);
            for along in [ahead * 9.7, ahead * -3.1e-5, ahead / 3.0] {
                assert_eq!(Course::new(heading).along(&along).y, 0.0, "{degrees} degrees");
            }
            let beside = Course::new(heading + 1e-14).along(&ahead).y;
            assert!((beside + 1e-14).abs() < 2e-15, "{degrees} degrees: {beside:e}");
        }
    }

    #[test]
    fn a_course_to_the_north_changes_no_bit() {
        let arrow = Vector3::new(0.1, -2.3, 0.7);
        let course = Course::new(0.0);
        assert_eq!((course.north_east_down(&arrow), course.along(&arrow)), (arrow, arrow));
    }
}

//! Attitude: a unit quaternion inside, 3-2-1 Euler angles outside [theory: frames.attitude; thesis §2.1].

use nalgebra::{Matrix3, Vector3};

/// Rotation from inertial (north-east-down) to body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude {
    /// C_bI: turns inertial into body components.
    pub body_from_inertial: Matrix3<f64>,
}

impl Attitude {
    /// From a quaternion (scalar first) of any length but zero.
    pub fn from_quaternion(quaternion: &[f64]) -> Self {
        let (w, x, y, z) = (quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
        let s = 2.0 / (w * w + x * x + y * y + z * z);
        let inertial_from_body = Matrix3::new(
            1.0 - s * (y * y + z * z),
            s * (x * y - w * z),
            s * (x * z + w * y),
            s * (x * y + w * z),
            1.0 - s * (x * x + z * z),
            s * (y * z - w * x),
            s * (x * z - w * y),
            s * (y * z + w * x),
            1.0 - s * (x * x + y * y),
        );
        Attitude { body_from_inertial: inertial_from_body.transpose() }
    }

    /// Roll, pitch, yaw, rad.
    pub fn euler_angles(&self) -> Vector3<f64> {
        let c = &self.body_from_inertial;
        Vector3::new(
            libm::atan2(c[(1, 2)], c[(2, 2)]),
            -libm::asin(c[(0, 2)].clamp(-1.0, 1.0)),
            libm::atan2(c[(0, 1)], c[(0, 0)]),
        )
    }
}

/// The quaternion (scalar first) of roll, pitch, yaw.
pub fn quaternion_of_euler_angles(angles: &Vector3<f64>) -> [f64; 4] {
    let half = angles * 0.5;
    let (sr, cr) = libm::sincos(half.x);
    let (sp, cp) = libm::sincos(half.y);
    let (sy, cy) = libm::sincos(half.z);
    [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
}

/// Rate of a quaternion under the body-axis angular velocity [theory: frames.kinematics].
pub fn quaternion_rate(quaternion: &[f64], rate: &Vector3<f64>) -> [f64; 4] {
    let (w, x, y, z) = (quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
    [
        -0.5 * (x * rate.x + y * rate.y + z * rate.z),
        0.5 * (w * rate.x + y * rate.z - z * rate.y),
        0.5 * (w * rate.y + z * rate.x - x * rate.z),
        0.5 * (w * rate.z + x * rate.y - y * rate.x),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn euler_angles_survive_the_quaternion() {
        let angles = Vector3::new(0.4, -1.2, 2.8);
        let attitude = Attitude::from_quaternion(&quaternion_of_euler_angles(&angles));
        assert!((attitude.euler_angles() - angles).norm() < 1e-14);
    }

    #[test]
    fn a_body_pitched_up_sees_gravity_pull_backwards() {
        let attitude = Attitude::from_quaternion(&quaternion_of_euler_angles(&Vector3::new(0.0, 0.1, 0.0)));
        let gravity = attitude.body_from_inertial * Vector3::z();
        assert!((gravity - Vector3::new(-libm::sin(0.1), 0.0, libm::cos(0.1))).norm() < 1e-15);
    }
}

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

/// Rates of roll, pitch and yaw angle at an angular velocity in body axes [theory: linearisation.unknowns].
pub fn euler_angle_rates(angles: &Vector3<f64>, rate: &Vector3<f64>) -> Vector3<f64> {
    let ((sin, cos), tan) = (libm::sincos(angles.x), libm::tan(angles.y));
    let downwards = rate.y * sin + rate.z * cos;
    Vector3::new(rate.x + downwards * tan, rate.y * cos - rate.z * sin, downwards / libm::cos(angles.y))
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

/// The quaternion (scalar first) of two turns, that on the right first.
pub fn quaternion_product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The quaternion (scalar first, not negative) of a turn, from whichever of its parts is largest.
pub fn quaternion_of_turn(turn: &Matrix3<f64>) -> [f64; 4] {
    let [x, y, z] = [turn[(0, 0)], turn[(1, 1)], turn[(2, 2)]];
    // Four times the square of each part.
    let squares = [1.0 + x + y + z, 1.0 + x - y - z, 1.0 - x + y - z, 1.0 - x - y + z];
    let largest = (1..4).fold(0, |best, part| if squares[part] > squares[best] { part } else { best });
    let sum = |row: usize, column: usize| turn[(row, column)] + turn[(column, row)];
    let difference = |row: usize, column: usize| turn[(row, column)] - turn[(column, row)];
    let (wx, wy, wz) = (difference(2, 1), difference(0, 2), difference(1, 0));
    let (xy, xz, yz) = (sum(0, 1), sum(0, 2), sum(1, 2));
    let own = squares[largest];
    // Four times the products of each part with the largest.
    let products = [[own, wx, wy, wz], [wx, own, xy, xz], [wy, xy, own, yz], [wz, xz, yz, own]][largest];
    let scale = 0.5 / libm::sqrt(own);
    let scale = if products[0] < 0.0 { -scale } else { scale };
    products.map(|product| product * scale)
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
    fn quaternions_of_turns_turn_so_whichever_part_is_largest() {
        for angles in [[0.4, -1.2, 2.8], [3.0, 0.1, 0.2], [0.1, 1.5, -0.3], [0.1, -0.2, 3.1], [0.0, 0.0, 0.0]]
        {
            let quaternion = quaternion_of_euler_angles(&Vector3::from(angles));
            let turn = Attitude::from_quaternion(&quaternion).body_from_inertial.transpose();
            let found = quaternion_of_turn(&turn);
            assert!(found[0] >= 0.0);
            let again = Attitude::from_quaternion(&found).body_from_inertial.transpose();
            assert!((again - turn).norm() < 1e-14, "{angles:?}");
            let twice = Attitude::from_quaternion(&quaternion_product(found, quaternion));
            assert!((twice.body_from_inertial.transpose() - turn * turn).norm() < 1e-14, "{angles:?}");
        }
    }

    #[test]
    fn a_body_pitched_up_sees_gravity_pull_backwards() {
        let attitude = Attitude::from_quaternion(&quaternion_of_euler_angles(&Vector3::new(0.0, 0.1, 0.0)));
        let gravity = attitude.body_from_inertial * Vector3::z();
        assert!((gravity - Vector3::new(-libm::sin(0.1), 0.0, libm::cos(0.1))).norm() < 1e-15);
    }
}

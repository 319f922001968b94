//! From body axes to those of glTF: x to the left, y up, z forward, as the front of a model faces +z there.
//!
//! The same turn takes north, east, down to x west, y up, z north: one matrix for vectors, rotation vectors and quaternions alike.

use nalgebra::{UnitQuaternion, Vector3};

/// A vector or a rotation vector.
pub fn vector(v: &Vector3<f64>) -> [f32; 3] {
    turned(v).map(single).into()
}

/// x, y, z, w.
pub fn quaternion(turn: &UnitQuaternion<f64>) -> [f32; 4] {
    let [x, y, z] = vector(&turn.imag());
    [x, y, z, single(turn.w)]
}

/// The same vector in the axes of glTF.
pub fn turned(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.y, -v.z, v.x)
}

/// Not −0.
fn single(number: f64) -> f32 {
    number as f32 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_turned_and_not_mirrored() {
        let [forward, right, down] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turned(&axis));
        assert_eq!([forward, right, down], [Vector3::z(), -Vector3::x(), -Vector3::y()]);
        assert_eq!(forward.cross(&right), down);
    }

    #[test]
    fn quaternions_turn_as_they_did() {
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.7, 0.2));
        let v = Vector3::new(1.0, 2.0, -0.5);
        let [x, y, z, w] = quaternion(&turn).map(f64::from);
        let there = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        assert!((there * turned(&v) - turned(&(turn * v))).norm() < 1e-6);
    }
}

//! The motion of the body axes [theory: frames.velocity, frames.rates].

use nalgebra::Vector3;

/// v and ω, body axes.
#[derive(Clone, Copy, Debug)]
pub struct RigidMotion {
    /// v, m/s.
    pub velocity: Vector3<f64>,
    /// ω, rad/s.
    pub rate: Vector3<f64>,
}

//! What sensors fixed to a section of the deformed structure read [theory: outputs.sensors; thesis eq. 2.1].
//!
//! Their axes are those of the body, turned with the section.

use nalgebra::Vector3;

use crate::kinematics::{RigidMotion, Section};

/// How the aircraft moves and deforms at an instant; vectors in body axes.
#[derive(Clone, Copy, Debug)]
pub struct BodyMotion<'a> {
    /// v and ω.
    pub motion: RigidMotion,
    /// v̇: rates of change of the components of v, m/s².
    pub acceleration: Vector3<f64>,
    /// ω̇, rad/s².
    pub angular_acceleration: Vector3<f64>,
    /// m/s².
    pub gravity: Vector3<f64>,
    /// q̈.
    pub q_ddot: &'a [f64],
}

/// Readings of sensors on the elastic axis, in the axes of the deformed section: x forward, y right, z down
/// while it is undeformed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensors {
    /// Of an accelerometer: inertial acceleration less gravity, m/s²; z is −g at rest.
    pub specific_force: Vector3<f64>,
    /// Of a rate gyro, rad/s.
    pub rate: Vector3<f64>,
}

impl Sensors {
    /// The readings at a section.
    pub(crate) fn read(section: &impl Section, body: &BodyMotion) -> Self {
        let BodyMotion { motion: RigidMotion { velocity, rate }, q_ddot, .. } = *body;
        let place = section.at_rest() + section.displacement();
        let acceleration = body.acceleration
            + rate.cross(&velocity)
            + body.angular_acceleration.cross(&place)
            + rate.cross(&(rate.cross(&place) + section.velocity() * 2.0))
            + section.acceleration(q_ddot);
        Sensors {
            specific_force: section.turned_back(&(acceleration - body.gravity)),
            rate: section.turned_back(&section.spin(&rate)),
        }
    }
}

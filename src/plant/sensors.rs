//! What sensors fixed to a section of the deformed structure read [theory: outputs.sensors; thesis eq. 2.1].
//!
//! Symbols: R = r + Ψᵘq the place of the section, φ = Ψᵠq its rotation vector. Its axes are the body axes turned
//! by exp(φ×); it spins at ω plus the true rate of that rotation, which for finite φ is not quite Ψᵠq̇.

use nalgebra::Vector3;
use pulp::Scalar;

use crate::kinematics::{RigidMotion, combine};
use crate::math::{LaneVector, Rotation};
use crate::structure::ReducedStation;

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
    /// q̇.
    pub q_dot: &'a [f64],
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
    /// The readings at a station whose shapes are those of the modes in use, Ψᵘq and Ψᵠq there being known.
    pub fn read(
        station: &ReducedStation,
        [displacement, turned]: [&Vector3<f64>; 2],
        body: &BodyMotion,
    ) -> Self {
        let BodyMotion { motion: RigidMotion { velocity, rate }, q_dot, q_ddot, .. } = *body;
        let (translation, rotation) = (&station.shapes.translation, &station.shapes.rotation);
        let place = station.position + displacement;
        let acceleration = body.acceleration
            + rate.cross(&velocity)
            + body.angular_acceleration.cross(&place)
            + rate.cross(&(rate.cross(&place) + combine(translation, q_dot) * 2.0))
            + combine(translation, q_ddot);

        let turn = Rotation::<Scalar>::new(LaneVector::single(turned));
        let turn_rate = LaneVector::single(&combine(rotation, q_dot));
        let spin = LaneVector::single(&rate) + turn_rate + turn.excess_spin(&turn_rate);
        let specific_force = LaneVector::single(&(acceleration - body.gravity));
        Sensors {
            specific_force: turn.apply_inverse(&specific_force).vector(),
            rate: turn.apply_inverse(&spin).vector(),
        }
    }
}

//! What sensors fixed to a section of the deformed structure read [theory: outputs.sensors, kinematics.biases; thesis eq. 2.1].
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
            rate: section.turned_back(&section.angular_velocity(&rate)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    use crate::kinematics::test_kind::Curved;
    use crate::kinematics::{Coordinates, Kinematics, Sections};
    use crate::structure::test_jet::jet;

    #[test]
    fn on_sections_whose_rows_depend_on_q_sensors_read_the_differences_of_their_path() {
        let model = jet().select(&[0, 1, 2, 3, 4]);
        let kinematics = Curved::new(&model, &[]);
        let [q, q_dot, q_ddot] = [
            [20.0, -15.0, 30.0, 10.0, -25.0],
            [30.0, 20.0, -10.0, 15.0, 25.0],
            [-80.0, 50.0, 70.0, -20.0, 10.0],
        ];
        let at = |time: f64| -> Vec<f64> {
            (0..q.len()).map(|i| q[i] + (q_dot[i] + 0.5 * q_ddot[i] * time) * time).collect()
        };
        let mut memory = kinematics.memory();
        let present = Coordinates { q: &q, q_dot: &q_dot };
        kinematics.evaluate(Scalar::new(), present, &mut memory);
        let held = RigidMotion { velocity: Vector3::zeros(), rate: Vector3::zeros() };
        let gravity = Vector3::new(0.0, 0.0, 9.8);
        let zero = Vector3::zeros();
        let body = BodyMotion {
            motion: held,
            acceleration: zero,
            angular_acceleration: zero,
            gravity,
            q_ddot: &q_ddot,
        };
        // Exact for paths of the fourth order in time.
        let (sections, step) = (kinematics.sections(present, &memory), 0.1);
        let times = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| steps * step);
        for (section, place) in sections.stations().zip(&kinematics.stations) {
            let sensors = Sensors::read(&section, &body);
            let [a, b, c, d, e] = times.map(|time| place.position(&at(time)));
            let acceleration = ((b + d) * 16.0 - (a + e) - c * 30.0) / (12.0 * step * step);
            let expected = section.turned_back(&(acceleration - gravity));
            assert!((sensors.specific_force - expected).norm() < 1e-10, "{sensors:?} {expected}");
            let [a, b, _, d, e] = times.map(|time| place.angle(&at(time)));
            let expected = Vector3::y() * (((d - b) * 8.0 - (e - a)) / (12.0 * step));
            assert!((sensors.rate - expected).norm() < 1e-12, "{sensors:?} {expected}");
        }
    }
}

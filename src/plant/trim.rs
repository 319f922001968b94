//! Trim: steady straight flight, without sideslip where the controls for roll and yaw can hold it, or another manoeuvre, or the
//! static deformation in a wind tunnel.
//!
//! [theory: trim.steady-flight, trim.unknowns, trim.lateral, trim.manoeuvres, trim.glide, trim.tunnel; thesis §5.1]
//!
//! Pitch, its control and thrust balance a symmetric aircraft. Where another one would go aside, bank angle and the controls for
//! roll and yaw are unknowns too, sideslip instead of a control that it has not. Without engines the climb angle takes the place
//! of thrust: the aircraft glides, in balance where it is, in denser and denser air.

use crate::aircraft::{Control, TrimRole};
use crate::equations::Controls;

use super::manoeuvre::Manoeuvre;

/// The flight condition to be trimmed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrimCondition {
    /// m/s; in a wind tunnel the equations' tunnel flow replaces it.
    pub airspeed: f64,
    /// m.
    pub altitude: f64,
    /// Yaw angle, rad.
    pub heading: f64,
    /// Straight, a turn or a pull-up; of no account where the aircraft is clamped.
    pub manoeuvre: Manoeuvre,
}

/// What holds an aircraft in steady flight, and how it flies then.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrimPoint {
    /// θ, rad.
    pub pitch: f64,
    /// φ, rad.
    pub roll: f64,
    /// β, rad, positive with the wind from the right.
    pub sideslip: f64,
    /// γ of the path, rad, positive upwards; an aircraft without engines finds its own.
    pub climb_angle: f64,
    /// ψ̇, rad/s, positive to the right.
    pub turn_rate: f64,
    /// About the body's y axis beside what turning has about it, rad/s.
    pub pitch_rate: f64,
    /// Across the flow at O; 0 of a clamped aircraft.
    pub load_factor: f64,
    /// Of the control with the role of pitch, rad.
    pub pitch_control: f64,
    /// Of the control with the role of roll, rad.
    pub roll_control: f64,
    /// Of the control with the role of yaw, rad.
    pub yaw_control: f64,
    /// N per engine that runs; of engines with shares per unit of share [theory: trim.shares].
    pub thrust: f64,
}

/// A trimmed flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    /// What holds it.
    pub point: TrimPoint,
    /// Under which it flies, in still air.
    pub controls: Controls,
    /// The complete state, wake at rest.
    pub state: Vec<f64>,
    /// What the search changed, in its own units and order.
    pub unknowns: Vec<f64>,
}

impl TrimPoint {
    /// α, rad: the angle of attack at which the path climbs at γ [theory: trim.steady-flight].
    ///
    /// With v = V (cos α cos β, sin β, sin α cos β) in body axes, sin γ = a cos α − b sin α − sin β sin φ cos θ, where
    /// a = cos β sin θ and b = cos β cos φ cos θ.
    pub fn angle_of_attack(&self) -> f64 {
        let TrimPoint { pitch, roll, sideslip, climb_angle, .. } = *self;
        let ((sin_pitch, cos_pitch), (sin_roll, cos_roll)) = (libm::sincos(pitch), libm::sincos(roll));
        let (sin_sideslip, cos_sideslip) = libm::sincos(sideslip);
        let [a, b] = [cos_sideslip * sin_pitch, cos_sideslip * cos_roll * cos_pitch];
        let climb = libm::sin(climb_angle) + sin_sideslip * sin_roll * cos_pitch;
        let upright = if roll == 0.0 { pitch } else { libm::atan2(a, b) };
        upright - libm::asin((climb / libm::hypot(a, b)).clamp(-1.0, 1.0))
    }

    /// v of a given airspeed in still air, body axes.
    pub fn velocity(&self, airspeed: f64) -> [f64; 3] {
        let (sin, cos) = libm::sincos(self.angle_of_attack());
        let (sin_sideslip, cos_sideslip) = libm::sincos(self.sideslip);
        [airspeed * cos * cos_sideslip, airspeed * sin_sideslip, airspeed * sin * cos_sideslip]
    }

    /// The angle of the control with a role, rad.
    pub fn control(&self, role: TrimRole) -> f64 {
        match role {
            TrimRole::Pitch => self.pitch_control,
            TrimRole::Roll => self.roll_control,
            TrimRole::Yaw => self.yaw_control,
        }
    }

    /// The angles of some controls: those without a role are neutral, rad.
    pub fn angles(&self, controls: &[Control]) -> impl Iterator<Item = f64> {
        controls.iter().map(|control| control.role.map_or(0.0, |role| self.control(role)))
    }

    /// For people, without what is 0, by the names of some controls; `engines` says whether there are any.
    pub fn describe(&self, controls: &[Control], engines: bool) -> String {
        let TrimPoint { pitch, roll, sideslip, climb_angle, turn_rate, pitch_rate, thrust, .. } = *self;
        let with_role = |role| {
            let control = controls.iter().find(|control| control.role == Some(role));
            control.map(|control| (control.name.as_str(), self.control(role)))
        };
        let mut text = format!("pitch {pitch:.5} rad");
        if let Some((name, angle)) = with_role(TrimRole::Pitch) {
            text += &format!(", {name} {angle:.5} rad");
        }
        let aside = [("bank angle", roll), ("sideslip", sideslip)].into_iter();
        let aside = aside.chain([TrimRole::Roll, TrimRole::Yaw].into_iter().filter_map(with_role));
        for (name, angle) in aside.filter(|(_, angle)| angle.abs() >= 5e-6) {
            text += &format!(", {name} {angle:.5} rad");
        }
        for (name, rate) in [("turn rate", turn_rate), ("pitch rate", pitch_rate)] {
            if rate.abs() >= 5e-6 {
                text += &format!(", {name} {rate:.5} rad/s");
            }
        }
        if !engines || climb_angle != 0.0 {
            text += &format!(", climb angle {climb_angle:.5} rad");
        }
        if engines {
            text += &format!(", thrust {thrust:.0} N per engine");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::math::{Attitude, quaternion_of_euler_angles};

    #[test]
    fn the_angle_of_attack_makes_the_path_climb_as_it_should() {
        let points = [
            TrimPoint { pitch: 0.14, ..TrimPoint::default() },
            TrimPoint { pitch: -0.02, climb_angle: -0.11, ..TrimPoint::default() },
            TrimPoint { pitch: 0.1, roll: 0.3, ..TrimPoint::default() },
            TrimPoint { pitch: 0.1, roll: -0.2, sideslip: 0.15, climb_angle: 0.05, ..TrimPoint::default() },
        ];
        for point in points {
            let quaternion = quaternion_of_euler_angles(&Vector3::new(point.roll, point.pitch, 0.7));
            let velocity = Vector3::from(point.velocity(50.0));
            let path = Attitude::from_quaternion(&quaternion).body_from_inertial.tr_mul(&velocity);
            assert!((velocity.norm() - 50.0).abs() < 1e-12, "{point:?}");
            assert!((libm::asin(-path.z / 50.0) - point.climb_angle).abs() < 1e-14, "{point:?}");
            assert!((libm::asin(velocity.y / 50.0) - point.sideslip).abs() < 1e-14, "{point:?}");
        }
    }
}

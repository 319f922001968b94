//! The air around the aircraft: the standard atmosphere, or that of a wind tunnel, which may stand still.

use nalgebra::Vector3;

use crate::air::Air;
use crate::aircraft::Support;
use crate::kinematics::RigidMotion;
use crate::math::Attitude;
use crate::strips::Surroundings;

use super::controls::Controls;
use super::of_motion::EquationsOfMotion;
use super::workspace::Workspace;

/// Slower air around a clamped aircraft does not stream, m/s.
const STILL_AIR: f64 = 1.0;

impl EquationsOfMotion {
    /// Altitude of O, m.
    pub fn altitude(&self, state: &[f64]) -> f64 {
        -state[self.layout.position().end - 1]
    }

    /// Speed of O relative to the air, m/s.
    pub fn airspeed(&self, state: &[f64], controls: &Controls) -> f64 {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        (self.motion(state).velocity - attitude.body_from_inertial * self.air_motion(controls)).norm()
    }

    /// Velocity of the air at the aircraft, north-east-down, m/s.
    pub fn air_motion(&self, controls: &Controls) -> Vector3<f64> {
        controls.wind + self.tunnel_flow
    }

    /// The air around O.
    pub fn air(&self, state: &[f64]) -> Air {
        self.tunnel_air.unwrap_or_else(|| Air::at(self.altitude(state)))
    }

    /// The first lifting strip that met the air from behind at the last evaluation. Where a clamped aircraft swings in
    /// still air none does: nothing lifts there.
    pub fn reversed_strip(&self, state: &[f64], controls: &Controls, workspace: &Workspace) -> Option<usize> {
        let in_still_air =
            || self.support() == Support::Clamped && self.airspeed(state, controls) < STILL_AIR;
        workspace.reversed_strip().filter(|_| !in_still_air())
    }

    /// What all strips share in a state.
    pub(crate) fn surroundings<'a>(
        &'a self,
        state: &[f64],
        attitude: &Attitude,
        controls: &Controls,
    ) -> Surroundings<'a> {
        let RigidMotion { velocity, rate } = self.motion(state);
        let wind = attitude.body_from_inertial * self.air_motion(controls);
        Surroundings {
            air_velocity: velocity - wind,
            rate,
            air_transport: rate.cross(&wind) - attitude.body_from_inertial * controls.wind_rate,
            density: self.air(state).density,
            inflow: &self.inflow,
            deformed_arms: self.terms.deformed_forcing,
            freedom: self.freedom,
        }
    }
}

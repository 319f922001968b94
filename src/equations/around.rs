//! The air around the aircraft: the standard atmosphere, or that of a wind tunnel, which may stand still.
//!
//! [theory: air.atmosphere, air.tunnel, air.wind]

use nalgebra::Vector3;

use crate::air::{Air, FrozenGust, TrackSeen, UniformFlow, UniformlyMet};
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
        self.air_velocity(state, controls).norm()
    }

    /// Velocity of O relative to the air, body axes, m/s.
    pub fn air_velocity(&self, state: &[f64], controls: &Controls) -> Vector3<f64> {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let uniform = self.air_met(state, &attitude, controls).at_origin().velocity;
        match self.gust_seen(state, &attitude, controls) {
            None => uniform,
            Some((gust, seen)) => uniform - gust.at_origin(&seen),
        }
    }

    /// Velocity of the air at O, all of it, in the axes of the state's position, m/s.
    pub fn air_motion(&self, state: &[f64], controls: &Controls) -> Vector3<f64> {
        let attitude = Attitude::from_quaternion(&state[self.layout.attitude()]);
        let uniform = self.air_flow(controls).velocity;
        match self.gust_seen(state, &attitude, controls) {
            None => uniform,
            Some((gust, seen)) => uniform + attitude.body_from_inertial.tr_mul(&gust.at_origin(&seen)),
        }
    }

    /// Of the single gust into which the aircraft flies, m/s; 0 where there is none.
    pub fn gust_peak_velocity(&self) -> f64 {
        self.gust.as_ref().map_or(0.0, |gust| gust.peak_velocity())
    }

    /// The gust in which the aircraft flies, and its track as seen in a state; `None` where nothing blows.
    #[inline(always)]
    pub(super) fn gust_seen(
        &self,
        state: &[f64],
        attitude: &Attitude,
        controls: &Controls,
    ) -> Option<(&FrozenGust, TrackSeen)> {
        let gust = self.gust.as_deref()?;
        let position = Vector3::from_column_slice(&state[self.layout.position()]);
        let seen = gust.seen_by(attitude, [&position, &controls.air_travel]);
        (!gust.is_calm(seen.origin)).then_some((gust, seen))
    }

    /// How the air moves: the wind, and the tunnel's flow.
    fn air_flow(&self, controls: &Controls) -> UniformFlow {
        UniformFlow { velocity: controls.wind + self.tunnel_flow, rate: controls.wind_rate }
    }

    /// How the aircraft meets it.
    fn air_met(&self, state: &[f64], attitude: &Attitude, controls: &Controls) -> UniformlyMet {
        let RigidMotion { velocity, rate } = self.motion(state);
        self.air_flow(controls).met_by(attitude, [&velocity, &rate])
    }

    /// The air around O.
    pub fn air(&self, state: &[f64]) -> Air {
        self.atmosphere.at(self.altitude(state))
    }

    /// The first lifting strip that met the air from behind at the last evaluation. Where a clamped aircraft swings in
    /// still air none does: nothing lifts there [theory: air-loads.reverse-flow].
    pub fn reversed_strip(&self, state: &[f64], controls: &Controls, workspace: &Workspace) -> Option<usize> {
        let in_still_air =
            || self.support() == Support::Clamped && self.airspeed(state, controls) < STILL_AIR;
        workspace.reversed_strip().filter(|_| !in_still_air())
    }

    /// What all strips share in a state, but for a gust.
    pub(crate) fn surroundings<'a>(
        &'a self,
        state: &[f64],
        attitude: &Attitude,
        controls: &Controls,
    ) -> Surroundings<'a, UniformlyMet> {
        Surroundings {
            air: self.air_met(state, attitude, controls),
            gust: None,
            rate: self.motion(state).rate,
            density: self.air(state).density,
            inflow: &self.inflow,
            deformed_arms: self.terms.deformed_forcing,
            freedom: self.freedom,
        }
    }
}

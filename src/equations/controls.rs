//! What acts on the aircraft at an instant: absolute angles of its controls, thrust, wind [theory: frames.signs].

use nalgebra::Vector3;

/// Absolute control positions and the motion of the air.
#[derive(Clone, Debug, PartialEq)]
pub struct Controls {
    /// rad, one per control in the order of [`ReducedModel::controls`](crate::structure::ReducedModel).
    pub angles: Vec<f64>,
    /// N per engine.
    pub thrust: Vec<f64>,
    /// Velocity of the air mass, north-east-down, m/s.
    pub wind: Vector3<f64>,
    /// Its rate, m/s².
    pub wind_rate: Vector3<f64>,
    /// D: how far the air has gone since the flight began, with it what is frozen in it; north-east-down, m.
    ///
    /// [theory: gusts.field]
    pub air_travel: Vector3<f64>,
}

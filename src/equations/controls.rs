//! What acts on the aircraft at an instant: absolute surface angles, thrust, wind [theory: frames.signs].

use nalgebra::Vector3;

use crate::strips::SURFACES;

/// Absolute control positions and the motion of the air.
#[derive(Clone, Debug, PartialEq)]
pub struct Controls {
    /// rad, trailing edge down.
    pub elevator: f64,
    /// rad, rolls right.
    pub aileron: f64,
    /// rad, both ailerons' trailing edges down.
    pub aileron_symmetric: f64,
    /// rad, yaws right.
    pub rudder: f64,
    /// N per engine.
    pub thrust: Vec<f64>,
    /// Velocity of the air mass, north-east-down, m/s.
    pub wind: Vector3<f64>,
    /// Its rate, m/s².
    pub wind_rate: Vector3<f64>,
}

impl Controls {
    /// Everything at zero.
    pub fn neutral(engines: usize) -> Self {
        Controls {
            elevator: 0.0,
            aileron: 0.0,
            aileron_symmetric: 0.0,
            rudder: 0.0,
            thrust: vec![0.0; engines],
            wind: Vector3::zeros(),
            wind_rate: Vector3::zeros(),
        }
    }

    /// The angles of the kinds of surfaces, rad.
    pub(crate) fn angles(&self) -> [f64; SURFACES] {
        [self.elevator, self.aileron, self.aileron_symmetric, self.rudder]
    }
}

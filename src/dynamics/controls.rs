//! What acts on the aircraft at an instant: absolute surface angles, thrust, wind.

use nalgebra::Vector3;

use crate::aircraft::ControlGains;

/// Kinds of surfaces: elevator, aileron, both ailerons together, rudder.
pub(super) const SURFACES: usize = 4;

/// A kind of surfaces that balances an aircraft sideways; its place among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SurfaceKind {
    Aileron = 1,
    Rudder = 3,
}

/// How far the surfaces of each kind turn a flap.
pub(super) fn gains_of_kinds(gains: &ControlGains) -> [f64; SURFACES] {
    [gains.elevator, gains.aileron, gains.aileron_symmetric, gains.rudder]
}

/// What the loads of flaps are proportional to: the angle of a kind of surfaces, or the product of two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FlapFactor {
    Angle(usize),
    Product([usize; 2]),
}

impl FlapFactor {
    /// How many there can be.
    pub(super) const MOST: usize = SURFACES + SURFACES * (SURFACES + 1) / 2;

    /// All there can be.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        let products = (0..SURFACES).flat_map(|j| (j..SURFACES).map(move |k| FlapFactor::Product([j, k])));
        (0..SURFACES).map(FlapFactor::Angle).chain(products)
    }

    /// Under given angles of the kinds, rad or rad².
    pub(super) fn value(self, angles: &[f64; SURFACES]) -> f64 {
        match self {
            FlapFactor::Angle(kind) => angles[kind],
            FlapFactor::Product([j, k]) => angles[j] * angles[k],
        }
    }

    /// Its coefficient in the angle δ, or in δ², of a flap that the kinds turn with given gains.
    pub(super) fn coefficient(self, gains: &[f64; SURFACES]) -> f64 {
        match self {
            FlapFactor::Angle(kind) => gains[kind],
            FlapFactor::Product([j, k]) if j == k => gains[j] * gains[j],
            FlapFactor::Product([j, k]) => 2.0 * gains[j] * gains[k],
        }
    }
}

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
    pub(super) fn angles(&self) -> [f64; SURFACES] {
        [self.elevator, self.aileron, self.aileron_symmetric, self.rudder]
    }
}

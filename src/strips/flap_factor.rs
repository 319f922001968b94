//! What the loads of flaps are proportional to [theory: air-loads.flap-products; thesis §4.1].

use crate::aircraft::ControlGains;

/// Kinds of surfaces: elevator, aileron, both ailerons together, rudder.
pub(crate) const SURFACES: usize = 4;

/// A kind of surfaces that balances an aircraft sideways; its place among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SurfaceKind {
    Aileron = 1,
    Rudder = 3,
}

/// How far the surfaces of each kind turn a flap.
pub(crate) fn gains_of_kinds(gains: &ControlGains) -> [f64; SURFACES] {
    [gains.elevator, gains.aileron, gains.aileron_symmetric, gains.rudder]
}

/// What the loads of flaps are proportional to: the angle of a kind of surfaces, or the product of two.
///
/// [theory: air-loads.flap-products]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FlapFactor {
    Angle(usize),
    Product([usize; 2]),
}

impl FlapFactor {
    /// How many there can be.
    pub(crate) const MOST: usize = SURFACES + SURFACES * (SURFACES + 1) / 2;

    /// All there can be.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let products = (0..SURFACES).flat_map(|j| (j..SURFACES).map(move |k| FlapFactor::Product([j, k])));
        (0..SURFACES).map(FlapFactor::Angle).chain(products)
    }

    /// Under given angles of the kinds, rad or rad².
    pub(crate) fn value(self, angles: &[f64; SURFACES]) -> f64 {
        match self {
            FlapFactor::Angle(kind) => angles[kind],
            FlapFactor::Product([j, k]) => angles[j] * angles[k],
        }
    }

    /// Its coefficient in the angle δ, or in δ², of a flap that the kinds turn with given gains.
    pub(crate) fn coefficient(self, gains: &[f64; SURFACES]) -> f64 {
        match self {
            FlapFactor::Angle(kind) => gains[kind],
            FlapFactor::Product([j, k]) if j == k => gains[j] * gains[j],
            FlapFactor::Product([j, k]) => 2.0 * gains[j] * gains[k],
        }
    }
}

//! What loads and apparent mass of whole strips do on each component of ν [4.1; physics.md §4].
//!
//! A component of ν moves the attachment of a strip by δu and turns it by δθ about s. Its entries are then
//!
//! ```text
//! generalised force   F·δu + M δθ,
//! heave (G_w − dG_Ω)  n·δu − d δθ,      of accelerations (G_m − dG_Ω)  m·δu − d δθ,      pitch G_Ω  δθ,
//! ```
//!
//! heave and pitch times the root of their apparent mass or inertia.

use pulp::Simd;

use crate::aerodynamics::{FlapLoads, SectionLoads};
use crate::lanes::{LaneVector, Lanes};

use super::strip_sums::RowEntry;

/// Resultants on whole strips; `SYMMETRIC` where accelerations are distributed as loads are.
pub struct StripLoads<S: Simd, const SYMMETRIC: bool> {
    /// F, N.
    pub force: LaneVector<S>,
    /// M, N·m.
    pub moment: Lanes<S>,
    /// √(πb²Δy) n.
    pub heave: LaneVector<S>,
    /// √(πb²Δy) m.
    pub acceleration: LaneVector<S>,
    /// −d √(πb²Δy).
    heave_by_turn: Lanes<S>,
    /// √(πb⁴Δy/8).
    pitch_by_turn: Lanes<S>,
}

/// Resultants of the flaps per radian, the force in parts of `StripLoads::heave`.
pub struct FlapResultants<S: Simd> {
    /// N per √kg.
    force: Lanes<S>,
    /// N·m.
    moment: Lanes<S>,
}

/// Properties of whole strips that distributing their loads needs.
pub struct StripSizes<S: Simd> {
    /// Δy, m.
    pub width: Lanes<S>,
    /// d, m.
    pub elastic_axis_aft_of_midchord: Lanes<S>,
    /// √(πb²Δy), for air of unit density.
    pub root_mass: Lanes<S>,
    /// √(πb⁴Δy/8).
    pub root_inertia: Lanes<S>,
}

/// How a component of ν moves strips.
pub struct Displacement<S: Simd> {
    /// `StripLoads::heave`·δu.
    pub heave: Lanes<S>,
    /// F·δu.
    pub force: Lanes<S>,
    /// `StripLoads::acceleration`·δu.
    pub acceleration: Lanes<S>,
    /// δθ.
    pub turn: Lanes<S>,
}

impl<S: Simd, const SYMMETRIC: bool> StripLoads<S, SYMMETRIC> {
    /// Of strips with their axes n, f and m.
    #[inline(always)]
    pub fn new(
        loads: &SectionLoads<S>,
        sizes: &StripSizes<S>,
        normal: &LaneVector<S>,
        forward: &LaneVector<S>,
        zero_lift_normal: &LaneVector<S>,
    ) -> Self {
        let heave = *normal * sizes.root_mass;
        StripLoads {
            force: *normal * (loads.down * sizes.width) + *forward * (loads.forward * sizes.width),
            moment: loads.pitching * sizes.width,
            heave,
            acceleration: if SYMMETRIC { heave } else { *zero_lift_normal * sizes.root_mass },
            heave_by_turn: -(sizes.elastic_axis_aft_of_midchord * sizes.root_mass),
            pitch_by_turn: sizes.root_inertia,
        }
    }

    /// Of a component of ν that moves the attachment along a vector and turns the strip.
    #[inline(always)]
    pub fn displaced(&self, translation: &LaneVector<S>, turn: Lanes<S>) -> Displacement<S> {
        let heave = self.heave.dot(translation);
        Displacement {
            heave,
            force: self.force.dot(translation),
            acceleration: if SYMMETRIC { heave } else { self.acceleration.dot(translation) },
            turn,
        }
    }

    /// The entries of a component of ν, flaps neutral.
    #[inline(always)]
    pub fn on(&self, displacement: &Displacement<S>) -> RowEntry<S> {
        let Displacement { heave, force, acceleration, turn } = *displacement;
        let by_turn = turn * self.heave_by_turn;
        let heave = heave + by_turn;
        RowEntry {
            heave,
            pitch: turn * self.pitch_by_turn,
            acceleration: if SYMMETRIC { heave } else { acceleration + by_turn },
            force: force + turn * self.moment,
        }
    }
}

impl<S: Simd> FlapResultants<S> {
    /// Of the flaps of strips.
    #[inline(always)]
    pub fn new(loads: &FlapLoads<S>, sizes: &StripSizes<S>, per_root_mass: Lanes<S>) -> Self {
        FlapResultants {
            force: loads.down * sizes.width * per_root_mass,
            moment: loads.pitching * sizes.width,
        }
    }

    /// The generalised force along a component of ν, per radian.
    #[inline(always)]
    pub fn on(&self, displacement: &Displacement<S>) -> Lanes<S> {
        displacement.heave * self.force + displacement.turn * self.moment
    }
}

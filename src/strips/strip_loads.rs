//! What loads and apparent mass of whole strips do on each component of ν.
//!
//! [theory: kinematics.rows, air-loads.distribution, air-loads.apparent-mass; thesis §4.1]
//!
//! A component of ν moves the attachment of a strip by δu and turns it by δθ about s. Its entries are then
//!
//! ```text
//! generalised force   F·δu + M δθ,
//! heave (G_w − dG_Ω)  n·δu − d δθ,      of accelerations (G_m − dG_Ω)  m·δu − d δθ,      pitch G_Ω  δθ,
//! ```
//!
//! heave and pitch times the root of their apparent mass or inertia.

use crate::math::{Arithmetic, Arrow, LaneVector, Lanes, PlaneVector};

use super::aerofoil::{SectionFlapLoads, SectionLoads};
use super::sums::RowEntry;

/// Resultants on whole strips, vectors of kind `V`; `EQUAL_ROWS` where accelerations are distributed as loads are.
pub struct StripLoads<S: Arithmetic, V, const EQUAL_ROWS: bool> {
    /// What translations meet.
    pub resultants: Resultants<V, EQUAL_ROWS>,
    /// M, N·m.
    moment: Lanes<S>,
    /// −d √(πb²Δy).
    heave_by_turn: Lanes<S>,
    /// √(πb⁴Δy/8).
    pitch_by_turn: Lanes<S>,
}

/// Vectors whose products with a translation are its entries.
pub struct Resultants<V, const EQUAL_ROWS: bool> {
    /// √(πb²Δy) n.
    heave: V,
    /// F, N.
    force: V,
    /// √(πb²Δy) m.
    acceleration: V,
    /// f, along which flaps drag.
    forward: V,
}

/// Resultants of the flaps: forces in parts of the heave and of the forward axis of [`Resultants`].
pub struct StripFlapLoads<S: Arithmetic> {
    /// Per radian: N per √kg along heave, N along f, N·m.
    heave: Lanes<S>,
    forward: Lanes<S>,
    moment: Lanes<S>,
    /// Per radian squared: N along −f.
    drag: Lanes<S>,
    /// Per radian squared: N per √kg along −heave, where there is any.
    drag_across: Option<Lanes<S>>,
}

/// Properties of whole strips that distributing their loads needs.
pub struct StripSizes<S: Arithmetic> {
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
pub struct Displacement<S: Arithmetic> {
    /// √(πb²Δy) n·δu.
    heave: Lanes<S>,
    /// F·δu.
    force: Lanes<S>,
    /// √(πb²Δy) m·δu.
    acceleration: Lanes<S>,
    /// f·δu.
    forward: Lanes<S>,
    /// δθ.
    turn: Lanes<S>,
}

impl<S: Arithmetic, V: Arrow<S>, const EQUAL_ROWS: bool> StripLoads<S, V, EQUAL_ROWS> {
    /// Of strips with their axes n, f and m.
    #[inline(always)]
    pub fn new(
        loads: &SectionLoads<S>,
        sizes: &StripSizes<S>,
        [normal, forward, zero_lift_normal]: [&V; 3],
    ) -> Self {
        let heave = *normal * sizes.root_mass;
        StripLoads {
            resultants: Resultants {
                heave,
                force: *normal * (loads.down * sizes.width) + *forward * (loads.forward * sizes.width),
                acceleration: if EQUAL_ROWS { heave } else { *zero_lift_normal * sizes.root_mass },
                forward: *forward,
            },
            moment: loads.pitching * sizes.width,
            heave_by_turn: -(sizes.elastic_axis_aft_of_midchord * sizes.root_mass),
            pitch_by_turn: sizes.root_inertia,
        }
    }

    /// The entries of a component of ν, flaps neutral.
    #[inline(always)]
    pub fn on(&self, displacement: &Displacement<S>) -> RowEntry<S> {
        let Displacement { heave, force, acceleration, turn, .. } = *displacement;
        let by_turn = turn * self.heave_by_turn;
        let heave = heave + by_turn;
        RowEntry {
            heave,
            pitch: turn * self.pitch_by_turn,
            acceleration: if EQUAL_ROWS { heave } else { acceleration + by_turn },
            force: force + turn * self.moment,
        }
    }
}

impl<V, const EQUAL_ROWS: bool> Resultants<V, EQUAL_ROWS> {
    /// Of a component of ν that moves the attachment along a vector and turns the strips.
    #[inline(always)]
    pub fn displaced<S: Arithmetic>(&self, translation: &V, turn: Lanes<S>) -> Displacement<S>
    where
        V: Arrow<S>,
    {
        let heave = self.heave.dot(translation);
        Displacement {
            heave,
            force: self.force.dot(translation),
            acceleration: if EQUAL_ROWS { heave } else { self.acceleration.dot(translation) },
            forward: self.forward.dot(translation),
            turn,
        }
    }
}

impl<S: Arithmetic, const EQUAL_ROWS: bool> Resultants<LaneVector<S>, EQUAL_ROWS> {
    /// Those that rotations about O meet: of forces at `arm`, of accelerations at `position`.
    #[inline(always)]
    pub fn about(&self, [arm, position]: [&LaneVector<S>; 2]) -> Self {
        let heave = arm.cross(&self.heave);
        Resultants {
            heave,
            force: arm.cross(&self.force),
            acceleration: if EQUAL_ROWS { heave } else { position.cross(&self.acceleration) },
            forward: arm.cross(&self.forward),
        }
    }

    /// Of a unit of motion along or about an axis, which turns the strips by `turn`.
    #[inline(always)]
    pub fn component(&self, axis: usize, turn: Lanes<S>) -> Displacement<S> {
        Displacement {
            heave: self.heave.component(axis),
            force: self.force.component(axis),
            acceleration: self.acceleration.component(axis),
            forward: self.forward.component(axis),
            turn,
        }
    }
}

impl<S: Arithmetic, const EQUAL_ROWS: bool> Resultants<PlaneVector<S>, EQUAL_ROWS> {
    /// Of units of motion in the mirror plane: along x, along z, and about y through O, which turns the strips by
    /// `turn`; loads act at `arm`, accelerations at `position`.
    #[inline(always)]
    pub fn in_plane(&self, [arm, position]: [&PlaneVector<S>; 2], turn: Lanes<S>) -> [Displacement<S>; 3] {
        let Resultants { heave, force, acceleration, forward } = self;
        let along = |component: fn(&PlaneVector<S>) -> Lanes<S>| Displacement {
            heave: component(heave),
            force: component(force),
            acceleration: component(acceleration),
            forward: component(forward),
            turn: turn.splat(0.0),
        };
        let heave_about = arm.cross(heave);
        let about = Displacement {
            heave: heave_about,
            force: arm.cross(force),
            acceleration: if EQUAL_ROWS { heave_about } else { position.cross(acceleration) },
            forward: arm.cross(forward),
            turn,
        };
        [along(|vector| vector.x), along(|vector| vector.z), about]
    }
}

impl<S: Arithmetic> StripFlapLoads<S> {
    /// Of the flaps of strips.
    #[expect(clippy::manual_map, reason = "registers do not go through a closure")]
    #[inline(always)]
    pub fn new(loads: &SectionFlapLoads<S>, sizes: &StripSizes<S>, per_root_mass: Lanes<S>) -> Self {
        StripFlapLoads {
            heave: loads.down * sizes.width * per_root_mass,
            forward: loads.forward * sizes.width,
            moment: loads.pitching * sizes.width,
            drag: loads.drag * sizes.width,
            drag_across: match loads.drag_across {
                Some(across) => Some(across * sizes.width * per_root_mass),
                None => None,
            },
        }
    }

    /// The generalised force along a component of ν, per radian.
    #[inline(always)]
    pub fn on(&self, Displacement { heave, forward, turn, .. }: &Displacement<S>) -> Lanes<S> {
        *heave * self.heave + *forward * self.forward + *turn * self.moment
    }

    /// The generalised force along a component of ν, per radian squared.
    #[inline(always)]
    pub fn drag_on(&self, displacement: &Displacement<S>) -> Lanes<S> {
        let along = -(displacement.forward * self.drag);
        match self.drag_across {
            Some(across) => along - displacement.heave * across,
            None => along,
        }
    }
}

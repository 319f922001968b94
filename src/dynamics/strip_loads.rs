//! Loads of whole strips and the work they do on each component of ν [4.1; physics.md §4].
//!
//! Symbols: G_w, G_f, G_Ω and G_m are rows of the strip's kinematics, see [`strips`](super::strips).

use pulp::Simd;

use crate::aerodynamics::{LocalFlow, Section};
use crate::lanes::{LaneVector, Lanes};

use super::strip_sums::RowEntry;

/// Loads of whole strips, and the roots of their apparent mass and inertia.
pub struct StripLoads<S: Simd> {
    /// N.
    along: Lanes<S>,
    /// N.
    across: Lanes<S>,
    /// N·m.
    pitching: Lanes<S>,
    /// N per radian of the flap.
    flap_across: Lanes<S>,
    /// N·m per radian of the flap.
    flap_pitching: Lanes<S>,
    root_mass: Lanes<S>,
    root_inertia: Lanes<S>,
}

impl<S: Simd> StripLoads<S> {
    /// Of strips of a width (m) in a flow; the roots are for air of unit density.
    #[inline(always)]
    pub fn new(
        section: &Section<Lanes<S>>,
        flow: &LocalFlow<S>,
        width: Lanes<S>,
        [root_mass, root_inertia]: [Lanes<S>; 2],
    ) -> Self {
        let (loads, flap) = (section.loads(flow), section.flap_loads(flow));
        StripLoads {
            along: loads.forward * width,
            across: loads.down * width,
            pitching: loads.pitching * width,
            flap_across: flap.down * width,
            flap_pitching: flap.pitching * width,
            root_mass,
            root_inertia,
        }
    }

    /// What they contribute to one component of ν, flaps neutral.
    #[inline(always)]
    pub fn on(&self, section: &Section<Lanes<S>>, work: &Work<S>) -> RowEntry<S> {
        let Work { down, ahead, nose_up, moving_down } = *work;
        let about_midchord = nose_up * section.elastic_axis_aft_of_midchord;
        RowEntry {
            heave: (down - about_midchord) * self.root_mass,
            pitch: nose_up * self.root_inertia,
            acceleration: (moving_down - about_midchord) * self.root_mass,
            force: down * self.across + ahead * self.along + nose_up * self.pitching,
        }
    }

    /// The generalised force of the flaps along one component of ν, per radian.
    #[inline(always)]
    pub fn of_flaps_on(&self, work: &Work<S>) -> Lanes<S> {
        work.down * self.flap_across + work.nose_up * self.flap_pitching
    }
}

/// Work of unit loads of a strip per unit of one component of ν.
pub struct Work<S: Simd> {
    /// G_w: of a force along n.
    pub down: Lanes<S>,
    /// G_f: of a force along f.
    pub ahead: Lanes<S>,
    /// G_Ω: of a moment about s.
    pub nose_up: Lanes<S>,
    /// G_m: velocity along m, where the strip is.
    pub moving_down: Lanes<S>,
}

impl<S: Simd> Work<S> {
    /// On the three axes of v or of ω.
    #[inline(always)]
    pub fn on_axes(
        down: &LaneVector<S>,
        ahead: &LaneVector<S>,
        nose_up: &LaneVector<S>,
        moving_down: &LaneVector<S>,
    ) -> [Work<S>; 3] {
        [
            Work { down: down.x, ahead: ahead.x, nose_up: nose_up.x, moving_down: moving_down.x },
            Work { down: down.y, ahead: ahead.y, nose_up: nose_up.y, moving_down: moving_down.y },
            Work { down: down.z, ahead: ahead.z, nose_up: nose_up.z, moving_down: moving_down.z },
        ]
    }
}

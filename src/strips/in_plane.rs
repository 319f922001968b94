//! Strips in the mirror plane while all motion is in it [4.1; physics.md §4].
//!
//! Everything is in x and z but rates and turns, which are about y. Symbols as in `in_space`.

use crate::air::{MetAir, MetAt};
use crate::kinematics::{Bias, RigidFreedom, SectionMotion, SectionsInPlane, Turn};
use crate::math::{Arithmetic, Arrow, Lanes, Place, PlaneVector};

use super::group::{Group, Loads, MovingSections};
use super::sums::StripSums;
use super::surroundings::Surroundings;

/// How sections in the mirror plane stand.
pub(crate) struct PlaneSections<S: Arithmetic> {
    /// X.
    position: PlaneVector<S>,
    forward: PlaneVector<S>,
    /// s.
    span: Lanes<S>,
    normal: PlaneVector<S>,
    /// m.
    zero_lift_normal: PlaneVector<S>,
}

/// How sections move relative to the air: V, and the part of its rate that no acceleration makes.
#[inline(always)]
pub(crate) fn flow_past<S: Arithmetic, T>(
    place: Place<S>,
    motion: &SectionMotion<PlaneVector<S>, Lanes<S>, T>,
    around: &Surroundings<impl MetAir>,
) -> MetAt<PlaneVector<S>> {
    let SectionMotion { position, velocity, .. } = motion;
    let body_rate = place.splat(around.rate.y);
    let air = around.air.at(place, [position, velocity]);
    MetAt {
        velocity: air.velocity + position.turned_by(body_rate) + *velocity,
        drift: air.drift + velocity.turned_by(body_rate),
    }
}

impl Group {
    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    #[inline(always)]
    pub(crate) fn deform_in_plane<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        sections: &impl SectionsInPlane,
        around: &Surroundings<impl MetAir>,
    ) -> MovingSections<S, PlaneSections<S>> {
        let motion = sections.motion(place);
        let MetAt { velocity, mut drift } = flow_past(place, &motion, around);
        let SectionMotion { position, turn, rate, spin, bias, .. } = motion;
        let forward = turn.apply(&PlaneVector::load(place, [&self.forward.x, &self.forward.z]));
        let span = place.load(&self.span.y);
        let normal = forward.turned_by(-span);
        let zero_lift_normal = self.zero_lift_normal::<S, _, SYMMETRIC>(place, [normal, forward]);

        let body_rate = place.splat(around.rate.y);
        let mut pitch_drift = place.splat(0.0);
        if let Some(Bias { acceleration, angular_acceleration }) = bias {
            drift = drift + acceleration;
            pitch_drift += span * angular_acceleration;
        }
        let upwash_drift = zero_lift_normal.dot(&drift) + spin * zero_lift_normal.cross(&velocity);
        let flow = self.flow::<S, SYMMETRIC>(
            place,
            around.density,
            [forward.dot(&velocity), normal.dot(&velocity), span * (body_rate + rate)],
            [upwash_drift, pitch_drift],
        );
        let motion = PlaneSections { position, forward, span, normal, zero_lift_normal };
        MovingSections { motion, flow }
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    #[inline(always)]
    pub(crate) fn distribute_in_plane<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        (index, sections): (usize, &impl SectionsInPlane),
        around: &Surroundings<impl MetAir>,
        moving: &MovingSections<S, PlaneSections<S>>,
        sums: &mut StripSums,
    ) {
        let PlaneSections { position, forward, span, normal, zero_lift_normal } = &moving.motion;
        let loads: Loads<_, _, SYMMETRIC> =
            self.loads(place, &moving.flow, [normal, forward, zero_lift_normal]);
        let resultants = &loads.0.resultants;
        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let arm = if around.deformed_arms { *position } else { sections.at_rest(place) };
            for (displacement, row) in resultants.in_plane([&arm, position], *span).iter().zip(&mut rows) {
                self.add_row(place, index, displacement, &loads, row);
            }
        }
        for ([x, z, about_y], row) in sections.rows().zip(rows) {
            let displacement =
                resultants.displaced(&PlaneVector::load(place, [x, z]), place.load(about_y) * *span);
            self.add_row(place, index, &displacement, &loads, row);
        }
    }
}

//! Strips in the mirror plane while all motion is in it [theory: symmetry.in-plane; thesis §4.1].
//!
//! Everything is in x and z but rates and turns, which are about y. Symbols as in `in_space`.

use crate::air::{MetAir, MetAt};
use crate::kinematics::{Bias, RigidFreedom, SectionMotion, SectionsInPlane, Turn};
use crate::math::{Arithmetic, Arrow, Lanes, PlaneVector, Window};

use super::group::{Group, MovingSections, StripLoadsWithFlaps};
use super::gust_at_strips::EightGusts;
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
    window: Window<S>,
    motion: &SectionMotion<PlaneVector<S>, Lanes<S>, T>,
    around: &Surroundings<impl MetAir>,
    gust: Option<&EightGusts>,
) -> MetAt<PlaneVector<S>> {
    let SectionMotion { position, velocity, .. } = motion;
    let body_rate = window.splat(around.rate.y);
    let air = around.air.at(window, [position, velocity]);
    let mut met = MetAt {
        velocity: air.velocity + position.turned_by(body_rate) + *velocity,
        drift: air.drift + velocity.turned_by(body_rate),
    };
    if let Some(gust) = gust {
        let mean = PlaneVector::load(window, [&gust.mean.x, &gust.mean.z]);
        met.velocity = met.velocity - mean;
        met.drift = met.drift + mean.turned_by(body_rate);
    }
    met
}

impl Group {
    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    #[inline(always)]
    pub(crate) fn deform_in_plane<S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        (index, sections): (usize, &impl SectionsInPlane),
        around: &Surroundings<impl MetAir>,
    ) -> MovingSections<S, PlaneSections<S>> {
        let motion = sections.motion(window);
        let gust = around.gust.map(|gust| gust.of_group(index));
        let MetAt { velocity, mut drift } = flow_past(window, &motion, around, gust);
        let SectionMotion { position, turn, rate, spin, bias, .. } = motion;
        let forward = turn.apply(&PlaneVector::load(window, [&self.forward.x, &self.forward.z]));
        let span = window.load(&self.span.y);
        let normal = forward.turned_by(-span);
        let zero_lift_normal = self.zero_lift_normal::<S, _, EQUAL_ROWS>(window, [normal, forward]);

        let body_rate = window.splat(around.rate.y);
        let mut pitch_drift = window.splat(0.0);
        if let Some(Bias { acceleration, angular_acceleration }) = bias {
            drift = drift + acceleration;
            pitch_drift += span * angular_acceleration;
        }
        let upwash_drift = zero_lift_normal.dot(&drift) + spin * zero_lift_normal.cross(&velocity);
        let flow = self.flow::<S, EQUAL_ROWS>(
            window,
            around.density,
            [forward.dot(&velocity), normal.dot(&velocity), span * (body_rate + rate)],
            [upwash_drift, pitch_drift],
            gust.map(|gust| {
                -zero_lift_normal.dot(&PlaneVector::load(window, [&gust.change.x, &gust.change.z]))
            }),
        );
        let motion = PlaneSections { position, forward, span, normal, zero_lift_normal };
        MovingSections { motion, flow }
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    ///
    /// [theory: air-loads.distribution, air-loads.apparent-mass]
    #[inline(always)]
    pub(crate) fn distribute_in_plane<S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        (index, sections): (usize, &impl SectionsInPlane),
        around: &Surroundings<impl MetAir>,
        moving: &MovingSections<S, PlaneSections<S>>,
        sums: &mut StripSums,
    ) {
        let PlaneSections { position, forward, span, normal, zero_lift_normal } = &moving.motion;
        let loads: StripLoadsWithFlaps<_, _, EQUAL_ROWS> =
            self.loads(window, &moving.flow, [normal, forward, zero_lift_normal]);
        let resultants = &loads.0.resultants;
        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let arm = if around.deformed_arms { *position } else { sections.at_rest(window) };
            for (displacement, row) in resultants.in_plane([&arm, position], *span).iter().zip(&mut rows) {
                self.add_row(window, index, displacement, &loads, row);
            }
        }
        for ([x, z, about_y], row) in sections.rows(rows) {
            let displacement =
                resultants.displaced(&PlaneVector::load(window, [x, z]), window.load(about_y) * *span);
            self.add_row(window, index, &displacement, &loads, row);
        }
    }
}

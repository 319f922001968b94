//! How strips move with the deformed aircraft and where their loads go.
//!
//! [theory: kinematics.sections, air-loads.triad, air-loads.flow, air-loads.rows, air-loads.rates, gusts.strip; thesis §4.1]
//!
//! Symbols: f, s, n the deformed triad, X the place of its section, J and S the section's rows, V the velocity relative to the
//! air, m = n + α0 f, and the rows G_w = nᵀ[1, −X×, J], G_Ω = sᵀ[0, 1, S] on ν = [v; ω; q̇]. ẇ and Ω̇ are the rates of w and
//! Ω with the true spin σ of the triad.

use crate::air::MetAir;
use crate::kinematics::{Bias, RigidFreedom, SectionMotion, SectionsInSpace, Turn};
use crate::math::{Arithmetic, Arrow, LaneVector, Window};

use super::group::{Group, MovingSections, StripLoadsWithFlaps};
use super::sums::{Row, StripSums};
use super::surroundings::Surroundings;

/// How sections stand.
pub(crate) struct SpaceMotion<S: Arithmetic> {
    pub(super) forward: LaneVector<S>,
    pub(super) span: LaneVector<S>,
    pub(super) normal: LaneVector<S>,
    /// m.
    pub(super) zero_lift_normal: LaneVector<S>,
    /// X.
    pub(super) position: LaneVector<S>,
}

impl Group {
    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    ///
    /// [theory: air-loads.flow, air-loads.rates]
    #[inline(always)]
    pub(crate) fn deform<S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        (index, sections): (usize, &impl SectionsInSpace),
        around: &Surroundings<impl MetAir>,
    ) -> MovingSections<S, SpaceMotion<S>> {
        let SectionMotion { position, turn, velocity, rate, spin, bias } = sections.motion(window);
        let forward = turn.apply(&LaneVector::load(window, &self.forward));
        let span = turn.apply(&LaneVector::load(window, &self.span));
        let normal = forward.cross(&span);
        let zero_lift_normal = self.zero_lift_normal::<S, _, EQUAL_ROWS>(window, [normal, forward]);

        let body_rate = LaneVector::splat(window, &around.rate);
        let air = around.air.at(window, [&position, &velocity]);
        let mut air_velocity = air.velocity + body_rate.cross(&position) + velocity;
        let mut drift = air.drift + body_rate.cross(&velocity);
        let mut gust_gradient = None;
        if let Some(gust) = around.gust {
            let gust = gust.of_group(index);
            let mean = LaneVector::load(window, &gust.mean);
            air_velocity = air_velocity - mean;
            drift = drift + body_rate.cross(&mean);
            gust_gradient = Some(-zero_lift_normal.dot(&LaneVector::load(window, &gust.change)));
        }
        let turning = body_rate + rate;
        // (σ × m)·V = σ·(m × V): how w and Ω change with the spin of the triad.
        let mut pitch_drift = spin.dot(&span.cross(&turning));
        if let Some(Bias { acceleration, angular_acceleration }) = bias {
            drift = drift + acceleration;
            pitch_drift += span.dot(&angular_acceleration);
        }
        let upwash_drift = zero_lift_normal.dot(&drift) + spin.dot(&zero_lift_normal.cross(&air_velocity));
        let flow = self.flow::<S, EQUAL_ROWS>(
            window,
            around.density,
            [forward.dot(&air_velocity), normal.dot(&air_velocity), span.dot(&turning)],
            [upwash_drift, pitch_drift],
            gust_gradient,
        );
        let motion = SpaceMotion { forward, span, normal, zero_lift_normal, position };
        MovingSections { motion, flow }
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    ///
    /// [theory: air-loads.distribution, air-loads.apparent-mass]
    #[inline(always)]
    pub(crate) fn distribute<S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        (index, sections): (usize, &impl SectionsInSpace),
        around: &Surroundings<impl MetAir>,
        moving: &MovingSections<S, SpaceMotion<S>>,
        sums: &mut StripSums,
    ) {
        let SpaceMotion { forward, span, normal, zero_lift_normal, position } = &moving.motion;
        let loads: StripLoadsWithFlaps<_, _, EQUAL_ROWS> =
            self.loads(window, &moving.flow, [normal, forward, zero_lift_normal]);
        let arm = if around.deformed_arms { *position } else { sections.at_rest(window) };
        let rigid = RigidRows { index, arms: [&arm, position], span };
        let mut rows = sums.rows();
        // Known to the compiler, so that nothing is computed about or along other axes.
        let [all, in_plane] = const { [RigidFreedom::All.motions(), RigidFreedom::InPlane.motions()] };
        match around.freedom {
            RigidFreedom::All => self.add_rigid_rows(window, &rigid, all, &loads, &mut rows),
            RigidFreedom::InPlane => self.add_rigid_rows(window, &rigid, in_plane, &loads, &mut rows),
            RigidFreedom::Held => {}
        }
        for (section, row) in sections.rows(rows) {
            let [jx, jy, jz, sx, sy, sz] = [0, 1, 2, 3, 4, 5].map(|row| window.load(&section[row]));
            let turn = LaneVector { x: sx, y: sy, z: sz }.dot(span);
            let displacement = loads.0.resultants.displaced(&LaneVector { x: jx, y: jy, z: jz }, turn);
            self.add_row(window, index, &displacement, &loads, row);
        }
    }

    /// Adds the rows of translations along axes and of rotations about axes.
    #[inline(always)]
    fn add_rigid_rows<'a, S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        RigidRows { index, arms, span }: &RigidRows<S>,
        [along, about]: [&[usize]; 2],
        loads: &StripLoadsWithFlaps<S, LaneVector<S>, EQUAL_ROWS>,
        rows: &mut impl Iterator<Item = &'a mut Row>,
    ) {
        let resultants = &loads.0.resultants;
        for (&axis, row) in along.iter().zip(&mut *rows) {
            let displacement = resultants.component(axis, window.splat(0.0));
            self.add_row(window, *index, &displacement, loads, row);
        }
        let moments = resultants.about(*arms);
        for (&axis, row) in about.iter().zip(rows) {
            let displacement = moments.component(axis, span.component(axis));
            self.add_row(window, *index, &displacement, loads, row);
        }
    }
}

/// What the rows of the rigid motion of a group of strips need.
struct RigidRows<'a, S: Arithmetic> {
    /// The group.
    index: usize,
    /// At which loads act, and at which accelerations.
    arms: [&'a LaneVector<S>; 2],
    /// s.
    span: &'a LaneVector<S>,
}

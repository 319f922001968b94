//! Strips in the mirror plane while all motion is in it [theory: symmetry.in-plane; thesis §4.1].
//!
//! Everything is in x and z but rates and turns, which are about y. The triad turns about a fixed axis: Ψᵠq̇ is its
//! spin in the body. Symbols as in `in_space`.

use crate::kinematics::RigidFreedom;
use crate::math::{Arithmetic, Arrow, Eight, Lanes, Place, PlaneVector, turned_about_y};

use super::group::{Group, Loads, MovingSections, Surroundings};
use super::sums::StripSums;

/// Where strips in the mirror plane are and how they move.
pub(crate) struct PlaneMotion<S: Arithmetic> {
    /// R.
    pub(crate) position: PlaneVector<S>,
    pub(crate) forward: PlaneVector<S>,
    /// V.
    pub(crate) velocity: PlaneVector<S>,
    /// Ψᵘq̇.
    elastic_velocity: PlaneVector<S>,
    /// Ψᵠq̇.
    elastic_rate: Lanes<S>,
}

/// How sections in the mirror plane stand.
pub(crate) struct PlaneSections<S: Arithmetic> {
    motion: PlaneMotion<S>,
    /// s.
    span: Lanes<S>,
    normal: PlaneVector<S>,
    /// m.
    zero_lift_normal: PlaneVector<S>,
}

impl<S: Arithmetic> PlaneMotion<S> {
    /// Of strips with their undeformed places and axes f, and the x and z components of Ψᵘ and the y component of Ψᵠ of
    /// each mode.
    #[inline(always)]
    pub(crate) fn new<'a>(
        place: Place<S>,
        [at_rest, forward]: [PlaneVector<S>; 2],
        shapes: impl Iterator<Item = [&'a Eight; 3]>,
        around: &Surroundings,
    ) -> Self {
        let zero = place.splat(0.0);
        let (mut x, mut z, mut turn) = (zero, zero, zero);
        let (mut x_rate, mut z_rate, mut turn_rate) = (zero, zero, zero);
        for (shape, (&q, &q_dot)) in shapes.zip(around.q.iter().zip(around.q_dot)) {
            let [along_x, along_z, about_y] = shape.map(|shape| place.load(shape));
            x += along_x * q;
            z += along_z * q;
            turn += about_y * q;
            x_rate += along_x * q_dot;
            z_rate += along_z * q_dot;
            turn_rate += about_y * q_dot;
        }
        let position = at_rest + PlaneVector { x, z };
        let elastic_velocity = PlaneVector { x: x_rate, z: z_rate };
        let air_velocity = PlaneVector::splat(place, &around.air_velocity);
        PlaneMotion {
            position,
            forward: turned_about_y(turn, forward),
            velocity: air_velocity + position.turned_by(place.splat(around.rate.y)) + elastic_velocity,
            elastic_velocity,
            elastic_rate: turn_rate,
        }
    }
}

impl Group {
    /// Where the undeformed strips are.
    #[inline(always)]
    fn place_in_plane<S: Arithmetic>(&self, place: Place<S>) -> PlaneVector<S> {
        PlaneVector::load(place, [&self.position.x, &self.position.z])
    }

    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    #[inline(always)]
    pub(crate) fn deform_in_plane<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        around: &Surroundings,
    ) -> MovingSections<S, PlaneSections<S>> {
        let forward = PlaneVector::load(place, [&self.forward.x, &self.forward.z]);
        let shapes = self.shapes.iter().map(|[x, _, z, _, about_y, _]| [x, z, about_y]);
        let motion = PlaneMotion::new(place, [self.place_in_plane(place), forward], shapes, around);
        let PlaneMotion { forward, velocity, elastic_velocity, elastic_rate, .. } = motion;
        let span = place.load(&self.span.y);
        let normal = forward.turned_by(-span);
        let zero_lift_normal = self.zero_lift_normal::<S, _, SYMMETRIC>(place, [normal, forward]);

        let rate = place.splat(around.rate.y);
        let transport = PlaneVector::splat(place, &around.air_transport) + elastic_velocity.turned_by(rate);
        let upwash_drift =
            zero_lift_normal.dot(&transport) + elastic_rate * zero_lift_normal.cross(&velocity);
        let flow = self.flow::<S, SYMMETRIC>(
            place,
            around.density,
            [forward.dot(&velocity), normal.dot(&velocity), span * (rate + elastic_rate)],
            [upwash_drift, place.splat(0.0)],
        );
        let motion = PlaneSections { motion, span, normal, zero_lift_normal };
        MovingSections { motion, flow }
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    ///
    /// [theory: air-loads.distribution, air-loads.apparent-mass]
    #[inline(always)]
    pub(crate) fn distribute_in_plane<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        index: usize,
        around: &Surroundings,
        moving: &MovingSections<S, PlaneSections<S>>,
        sums: &mut StripSums,
    ) {
        let PlaneSections { motion: PlaneMotion { position, forward, .. }, span, normal, zero_lift_normal } =
            &moving.motion;
        let loads: Loads<_, _, SYMMETRIC> =
            self.loads(place, &moving.flow, [normal, forward, zero_lift_normal]);
        let resultants = &loads.0.resultants;
        let mut rows = sums.rows();
        if around.freedom == RigidFreedom::InPlane {
            let arm = if around.deformed_arms { *position } else { self.place_in_plane(place) };
            for (displacement, row) in resultants.in_plane([&arm, position], *span).iter().zip(&mut rows) {
                self.add_row(place, index, displacement, &loads, row);
            }
        }
        for ([x, _, z, _, about_y, _], row) in self.shapes.iter().zip(rows) {
            let displacement =
                resultants.displaced(&PlaneVector::load(place, [x, z]), place.load(about_y) * *span);
            self.add_row(place, index, &displacement, &loads, row);
        }
    }
}

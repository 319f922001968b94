//! How strips move with the deformed aircraft and where their loads go.
//!
//! [theory: air-loads.triad, air-loads.flow, air-loads.rows, air-loads.rates; thesis §4.1]
//!
//! Symbols: f, s, n the deformed triad, R = r + Ψᵘq, V the velocity relative to the air, m = n + α0 f, and
//! the rows G_w = nᵀ[1, −R×, Ψᵘ], G_Ω = sᵀ[0, 1, Ψᵠ] on ν = [v; ω; q̇]. The triad turns by the finite rotation
//! exp((Ψᵠq)×) and spins accordingly: ẇ and Ω̇ are the rates of w and Ω.

use crate::kinematics::RigidFreedom;
use crate::math::{Arithmetic, Arrow, LaneVector, Place, Rotation};

use super::group::{Group, Loads, MovingSections, Surroundings};
use super::sums::{Row, StripSums};

/// How sections stand.
pub(crate) struct SpaceMotion<S: Arithmetic> {
    forward: LaneVector<S>,
    span: LaneVector<S>,
    normal: LaneVector<S>,
    /// m.
    zero_lift_normal: LaneVector<S>,
    /// R.
    position: LaneVector<S>,
}

impl Group {
    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    ///
    /// [theory: air-loads.flow, air-loads.rates]
    #[inline(always)]
    pub(crate) fn deform<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        around: &Surroundings,
    ) -> MovingSections<S, SpaceMotion<S>> {
        let [displacement, rotation, elastic_velocity, elastic_rate] =
            self.combine(place, around.q, around.q_dot);

        let turn = Rotation::new(rotation);
        let forward = turn.apply(&LaneVector::load(place, &self.forward));
        let span = turn.apply(&LaneVector::load(place, &self.span));
        let normal = forward.cross(&span);
        let position = LaneVector::load(place, &self.position) + displacement;
        let rate = LaneVector::splat(place, &around.rate);
        let air_velocity =
            LaneVector::splat(place, &around.air_velocity) + rate.cross(&position) + elastic_velocity;
        let transport = LaneVector::splat(place, &around.air_transport) + rate.cross(&elastic_velocity);
        let spin = rate + elastic_rate;
        let zero_lift_normal = self.zero_lift_normal::<S, _, SYMMETRIC>(place, [normal, forward]);

        // (σ × m)·V = σ·(m × V): how w and Ω change with the spin of the triad.
        let triad_spin = elastic_rate + turn.excess_spin(&elastic_rate);
        let upwash_drift =
            zero_lift_normal.dot(&transport) + triad_spin.dot(&zero_lift_normal.cross(&air_velocity));
        let flow = self.flow::<S, SYMMETRIC>(
            place,
            around.density,
            [forward.dot(&air_velocity), normal.dot(&air_velocity), span.dot(&spin)],
            [upwash_drift, triad_spin.dot(&span.cross(&spin))],
        );
        let motion = SpaceMotion { forward, span, normal, zero_lift_normal, position };
        MovingSections { motion, flow }
    }

    /// Ψᵘq, Ψᵠq, Ψᵘq̇ and Ψᵠq̇.
    #[inline(always)]
    fn combine<S: Arithmetic>(&self, place: Place<S>, q: &[f64], q_dot: &[f64]) -> [LaneVector<S>; 4] {
        let (mut sums, mut rates) = ([place.splat(0.0); 6], [place.splat(0.0); 6]);
        for (shape, (&q, &q_dot)) in self.shapes.iter().zip(q.iter().zip(q_dot)) {
            for row in 0..6 {
                let shape = place.load(&shape[row]);
                sums[row] += shape * q;
                rates[row] += shape * q_dot;
            }
        }
        let [ux, uy, uz, rx, ry, rz] = sums;
        let [vx, vy, vz, wx, wy, wz] = rates;
        [
            LaneVector { x: ux, y: uy, z: uz },
            LaneVector { x: rx, y: ry, z: rz },
            LaneVector { x: vx, y: vy, z: vz },
            LaneVector { x: wx, y: wy, z: wz },
        ]
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    ///
    /// [theory: air-loads.distribution, air-loads.apparent-mass]
    #[inline(always)]
    pub(crate) fn distribute<S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        index: usize,
        around: &Surroundings,
        moving: &MovingSections<S, SpaceMotion<S>>,
        sums: &mut StripSums,
    ) {
        let SpaceMotion { forward, span, normal, zero_lift_normal, position } = &moving.motion;
        let loads: Loads<_, _, SYMMETRIC> =
            self.loads(place, &moving.flow, [normal, forward, zero_lift_normal]);
        let arm = if around.deformed_arms { *position } else { LaneVector::load(place, &self.position) };
        let rigid = RigidRows { index, arms: [&arm, position], span };
        let mut rows = sums.rows();
        // Axes written out, so that nothing is computed about or along others.
        match around.freedom {
            RigidFreedom::All => self.add_rigid_rows(place, &rigid, [&[0, 1, 2]; 2], &loads, &mut rows),
            RigidFreedom::InPlane => self.add_rigid_rows(place, &rigid, [&[0, 2], &[1]], &loads, &mut rows),
            RigidFreedom::Held => {}
        }
        for (shape, row) in self.shapes.iter().zip(rows) {
            let [ux, uy, uz, rx, ry, rz] = [0, 1, 2, 3, 4, 5].map(|row| place.load(&shape[row]));
            let turn = LaneVector { x: rx, y: ry, z: rz }.dot(span);
            let displacement = loads.0.resultants.displaced(&LaneVector { x: ux, y: uy, z: uz }, turn);
            self.add_row(place, index, &displacement, &loads, row);
        }
    }

    /// Adds the rows of translations along axes and of rotations about axes.
    #[inline(always)]
    fn add_rigid_rows<'a, S: Arithmetic, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        RigidRows { index, arms, span }: &RigidRows<S>,
        [along, about]: [&[usize]; 2],
        loads: &Loads<S, LaneVector<S>, SYMMETRIC>,
        rows: &mut impl Iterator<Item = &'a mut Row>,
    ) {
        let resultants = &loads.0.resultants;
        for (&axis, row) in along.iter().zip(&mut *rows) {
            let displacement = resultants.component(axis, place.splat(0.0));
            self.add_row(place, *index, &displacement, loads, row);
        }
        let moments = resultants.about(*arms);
        for (&axis, row) in about.iter().zip(rows) {
            let displacement = moments.component(axis, span.component(axis));
            self.add_row(place, *index, &displacement, loads, row);
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

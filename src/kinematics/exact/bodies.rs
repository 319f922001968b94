//! The rigid bodies on eight sections side by side.
//!
//! [theory: geometrically-exact.attached, geometrically-exact.inertia, kinematics.inertia]

use nalgebra::Vector3;

use crate::math::{Arithmetic, Arrow, Eight, EightVectors, LANES, LaneVector, Lanes, PlaneVector, Window};
use crate::structure::{BeamSection, RigidBody};

use super::super::rigid_motion::RigidMotion;
use super::in_plane;
use super::moving::EightMoving;
use super::strands::Strands;

/// All bodies.
#[derive(Clone, Debug)]
pub struct Bodies {
    /// kg.
    pub mass: f64,
    /// Those groups of sections that have any.
    pub eights: Vec<(usize, EightBodies)>,
    /// How many groups, the first, are of sections in the mirror plane alone.
    pub in_plane: usize,
}

impl Bodies {
    /// On sections in their order.
    pub fn new(sections: &[&BeamSection], order: &Strands) -> Self {
        let body =
            |section: &Option<usize>| section.map_or(RigidBody::NONE, |section| sections[section].body);
        let bodies: Vec<RigidBody> = order.sections.iter().map(body).collect();
        let has_mass = |bodies: &&[RigidBody]| bodies.iter().any(|body| body.mass > 0.0);
        let eights = bodies.chunks(LANES).enumerate().filter(|(_, bodies)| has_mass(bodies));
        Bodies {
            mass: bodies.iter().map(|body| body.mass).sum(),
            eights: eights.map(|(index, bodies)| (index, EightBodies::new(bodies))).collect(),
            in_plane: order.in_plane,
        }
    }
}

/// The bodies on eight sections; of no mass where there is none.
#[derive(Clone, Debug)]
pub struct EightBodies {
    /// kg.
    pub mass: Eight,
    /// From the section to the centre of mass, undeformed, m.
    offset: EightVectors,
    /// About the centre of mass, undeformed: xx, yy, zz, yz, zx, xy, kg·m².
    inertia: [Eight; 6],
}

/// The bodies where their sections have taken them; inertia as xx, yy, zz, yz, zx, xy.
#[derive(Clone, Debug)]
pub struct EightCarried {
    /// From the section to the centre of mass, m.
    arm: EightVectors,
    /// About the centre of mass, kg·m².
    inertia: [Eight; 6],
    /// m X, kg·m.
    pub first_moment: EightVectors,
    /// About O, kg·m².
    pub about_origin: [Eight; 6],
}

/// A force, N, and its moment about O, N·m, on each of eight sections.
#[derive(Clone, Debug)]
pub struct EightWrenches {
    pub force: EightVectors,
    pub moment: EightVectors,
}

impl EightCarried {
    /// Of no mass.
    pub fn none() -> Self {
        let none = EightVectors::new([Vector3::zeros(); 8]);
        EightCarried {
            arm: none,
            inertia: [Eight::ZERO; 6],
            first_moment: none,
            about_origin: [Eight::ZERO; 6],
        }
    }
}

impl EightWrenches {
    /// Nothing acts.
    pub fn none() -> Self {
        let none = EightVectors::new([Vector3::zeros(); 8]);
        EightWrenches { force: none, moment: none }
    }
}

impl EightBodies {
    /// Of up to eight bodies.
    pub fn new(bodies: &[RigidBody]) -> Self {
        let inertia =
            |(row, column): (usize, usize)| Eight::of(bodies, |body| body.inertia[(row, column)], 0.0);
        EightBodies {
            mass: Eight::of(bodies, |body| body.mass, 0.0),
            offset: EightVectors::of(bodies, |body| body.offset, Vector3::zeros()),
            inertia: [(0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)].map(inertia),
        }
    }

    /// Writes where the sections take them, and adds to the sums of first moments and inertia about O, lane by lane.
    #[inline(always)]
    pub fn carry<S: Arithmetic>(
        &self,
        simd: S,
        moving: &EightMoving,
        carried: &mut EightCarried,
        (first_moment, about_origin): (&mut EightVectors, &mut [Eight; 6]),
    ) {
        for window in Window::all(simd) {
            let [x, y, z] = moving.turn.each_ref().map(|column| LaneVector::load(window, column));
            let LaneVector { x: along_x, y: along_y, z: along_z } = LaneVector::load(window, &self.offset);
            let arm = x * along_x + y * along_y + z * along_z;
            arm.store(window, &mut carried.arm);
            // R I Rᵀ.
            let [xx, yy, zz, yz, zx, xy] = self.inertia.each_ref().map(|entry| window.load(entry));
            let [of_x, of_y, of_z] =
                [x * xx + y * xy + z * zx, x * xy + y * yy + z * yz, x * zx + y * yz + z * zz];
            let entry = |row: usize, column: usize| {
                let part =
                    |of: &LaneVector<S>, axis: &LaneVector<S>| of.component(row) * axis.component(column);
                part(&of_x, &x) + part(&of_y, &y) + part(&of_z, &z)
            };
            let inertia = [entry(0, 0), entry(1, 1), entry(2, 2), entry(1, 2), entry(2, 0), entry(0, 1)];
            // −m X×X×.
            let position = LaneVector::load(window, &moving.position) + arm;
            let moment = position * window.load(&self.mass);
            let [xx, yy, zz] = [moment.x * position.x, moment.y * position.y, moment.z * position.z];
            let (yz, zx, xy) = (moment.y * position.z, moment.z * position.x, moment.x * position.y);
            let about = [yy + zz, zz + xx, xx + yy, -yz, -zx, -xy];
            moment.store(window, &mut carried.first_moment);
            (LaneVector::load(window, first_moment) + moment).store(window, first_moment);
            for (entry, (inertia, about)) in inertia.into_iter().zip(about).enumerate() {
                window.store(&mut carried.inertia[entry], inertia);
                window.store(&mut carried.about_origin[entry], inertia + about);
                let sum = window.load(&about_origin[entry]) + (inertia + about);
                window.store(&mut about_origin[entry], sum);
            }
        }
    }

    /// Writes the inertial forces in a motion of the body axes that no acceleration makes, and adds them to their sums, lane by
    /// lane; those that the motion of the sections makes only `with_rates`.
    #[inline(always)]
    pub fn write_wrenches<S: Arithmetic>(
        &self,
        simd: S,
        (moving, carried): (&EightMoving, &EightCarried),
        (motion, with_rates): (&RigidMotion, bool),
        wrenches: &mut EightWrenches,
        sums: &mut EightWrenches,
    ) {
        for window in Window::all(simd) {
            let load = |vectors: &EightVectors| LaneVector::load(window, vectors);
            let (rate, arm) = (LaneVector::splat(window, &motion.rate), load(&carried.arm));
            let position = load(&moving.position) + arm;
            let mut along =
                rate.cross(&(LaneVector::splat(window, &motion.velocity) + rate.cross(&position)));
            let mut turning = rate;
            let inertia = carried.inertia.each_ref().map(|entry| window.load(entry));
            let mut about = LaneVector::splat(window, &Vector3::zeros());
            if with_rates {
                let (spin, spin_bias) = (load(&moving.spin), load(&moving.angular_acceleration));
                let circling = spin.cross(&arm);
                let velocity = load(&moving.velocity) + circling;
                let acceleration = load(&moving.acceleration) + spin_bias.cross(&arm) + spin.cross(&circling);
                along = along + rate.cross(&velocity) * window.splat(2.0) + acceleration;
                turning = turning + spin;
                about = symmetric_times(&inertia, &(rate.cross(&spin) + spin_bias));
            }
            about = about + turning.cross(&symmetric_times(&inertia, &turning));
            let force = along * -window.load(&self.mass);
            let moment = position.cross(&force) - about;
            force.store(window, &mut wrenches.force);
            moment.store(window, &mut wrenches.moment);
            (load(&sums.force) + force).store(window, &mut sums.force);
            (load(&sums.moment) + moment).store(window, &mut sums.moment);
        }
    }
}

impl EightBodies {
    /// The same of sections that stay in the mirror plane, as far as it counts in motion in that plane.
    #[inline(always)]
    pub fn carry_in_plane<S: Arithmetic>(
        &self,
        simd: S,
        moving: &EightMoving,
        carried: &mut EightCarried,
        (first_moment, about_origin): (&mut EightVectors, &mut [Eight; 6]),
    ) {
        for window in Window::all(simd) {
            let [x, _, z] = moving.turn.each_ref().map(|column| in_plane::load(window, column));
            let PlaneVector { x: along_x, z: along_z } = in_plane::load(window, &self.offset);
            let arm = x * along_x + z * along_z;
            let position = in_plane::load(window, &moving.position) + arm;
            let moment = position * window.load(&self.mass);
            let about = window.load(&self.inertia[YY]) + moment.dot(&position);
            in_plane::store(window, &mut carried.arm, arm);
            in_plane::store(window, &mut carried.first_moment, moment);
            window.store(&mut carried.about_origin[YY], about);
            let sum = in_plane::load(window, first_moment) + moment;
            in_plane::store(window, first_moment, sum);
            let sum = window.load(&about_origin[YY]) + about;
            window.store(&mut about_origin[YY], sum);
        }
    }

    /// The same of sections that stay in the mirror plane, as far as it counts in motion in that plane: inertia about y makes
    /// no moment.
    #[inline(always)]
    pub fn write_wrenches_in_plane<S: Arithmetic>(
        &self,
        simd: S,
        (moving, carried): (&EightMoving, &EightCarried),
        (motion, with_rates): (&RigidMotion, bool),
        wrenches: &mut EightWrenches,
        sums: &mut EightWrenches,
    ) {
        for window in Window::all(simd) {
            let load = |vectors: &EightVectors| in_plane::load(window, vectors);
            let (rate, arm) = (window.splat(motion.rate.y), load(&carried.arm));
            let position = load(&moving.position) + arm;
            let velocity = PlaneVector::splat(window, &motion.velocity);
            let mut along = (velocity + position.turned_by(rate)).turned_by(rate);
            if with_rates {
                let spin = window.load(&moving.spin.y);
                let circling = arm.turned_by(spin);
                let velocity = load(&moving.velocity) + circling;
                along = along
                    + velocity.turned_by(rate + rate)
                    + load(&moving.acceleration)
                    + circling.turned_by(spin);
            }
            let force = along * -window.load(&self.mass);
            let moment = position.cross(&force);
            in_plane::store(window, &mut wrenches.force, force);
            window.store(&mut wrenches.moment.y, moment);
            let sum = load(&sums.force) + force;
            in_plane::store(window, &mut sums.force, sum);
            let sum = window.load(&sums.moment.y) + moment;
            window.store(&mut sums.moment.y, sum);
        }
    }
}

/// The place of an inertia about y.
const YY: usize = 1;

/// Matrices of the entries xx, yy, zz, yz, zx, xy times vectors.
#[inline(always)]
pub fn symmetric_times<S: Arithmetic>(
    [xx, yy, zz, yz, zx, xy]: &[Lanes<S>; 6],
    LaneVector { x, y, z }: &LaneVector<S>,
) -> LaneVector<S> {
    LaneVector {
        x: *xx * *x + *xy * *y + *zx * *z,
        y: *xy * *x + *yy * *y + *yz * *z,
        z: *zx * *x + *yz * *y + *zz * *z,
    }
}

//! Sections that stay in the mirror plane: vectors are in x and z, rotations about y.
//!
//! [theory: geometrically-exact.in-plane]
//!
//! Turns are products of complex numbers there. Symbols as in `helix`; J turns by a quarter, so that a rotation at a unit rate
//! about y moves what is at x as Jx.

use crate::math::{Arithmetic, Eight, EightVectors, LANES, Lanes, PlaneVector, Window};

use super::super::kind::Coordinates;
use super::helix::{EightConstants, EightHelices};
use super::moving::{AT_REST, EightMoving, add_up};
use super::series::{Series, half_angle};
use super::strands::Part;
use super::twists::EightTwists;

/// x and z.
#[inline(always)]
pub fn load<S: Arithmetic>(window: Window<S>, vectors: &EightVectors) -> PlaneVector<S> {
    PlaneVector::load(window, [&vectors.x, &vectors.z])
}

#[inline(always)]
pub fn store<S: Arithmetic>(window: Window<S>, vectors: &mut EightVectors, plane: PlaneVector<S>) {
    window.store(&mut vectors.x, plane.x);
    window.store(&mut vectors.z, plane.z);
}

/// Jx.
#[inline(always)]
fn quarter_turn<S: Arithmetic>(PlaneVector { x, z }: PlaneVector<S>) -> PlaneVector<S> {
    PlaneVector { x: z, z: -x }
}

impl EightConstants {
    /// Writes the helices at some q and q̇, and how they turn the sections.
    #[inline(always)]
    pub fn write_in_plane<S: Arithmetic>(
        &self,
        simd: S,
        at: Coordinates,
        helices: &mut EightHelices,
        turns: &mut [Eight; 4],
    ) {
        helices.turn_before = AT_REST;
        let Coordinates { q, q_dot } = at;
        for window in Window::all(simd) {
            let (mut sums, mut rates) = ([window.splat(0.0); 3], [window.splat(0.0); 3]);
            for (mode, [x, _, z, _, about_y, _]) in &self.steps {
                let (q, q_dot) = (window.splat(q[*mode]), window.splat(q_dot[*mode]));
                for (row, step) in [x, z, about_y].into_iter().enumerate() {
                    let step = window.load(step);
                    sums[row] += step * q;
                    rates[row] += step * q_dot;
                }
            }
            let [x, z, rotation] = sums;
            let [x_rate, z_rate, rotation_rate] = rates;
            let [cosine, sine] = half_angle(rotation * rotation);
            window.store(&mut turns[0], cosine);
            window.store(&mut turns[2], rotation * sine);
            window.store(&mut helices.rotation.y, rotation);
            window.store(&mut helices.rotation_rate.y, rotation_rate);
            store(window, &mut helices.slide, load(window, &self.arm) + PlaneVector { x, z });
            store(window, &mut helices.slide_rate, PlaneVector { x: x_rate, z: z_rate });
        }
    }
}

/// Turns each section of a part by all turns before it.
#[inline(always)]
pub fn turn_along(part: &Part, eights: &mut [EightMoving], index: usize, helices: &mut EightHelices) {
    let ([eight, lane], parts) = (part.parent, [0, 2]);
    let mut before = parts.map(|part| eights[eight].quaternion[part].0[lane]);
    let turn = &mut eights[index].quaternion;
    for lane in part.lanes.clone().map(|lane| lane % LANES) {
        let ([w, y], [own_w, own_y]) = (before, parts.map(|part| turn[part].0[lane]));
        let turned = [w * own_w - y * own_y, w * own_y + y * own_w];
        for (place, part) in parts.into_iter().enumerate() {
            helices.turn_before[part].0[lane] = before[place];
            turn[part].0[lane] = turned[place];
        }
        before = turned;
    }
}

/// cos θ and sin θ of unit quaternions about y.
#[inline(always)]
fn cosine_and_sine<S: Arithmetic>(window: Window<S>, turn: &[Eight; 4]) -> [Lanes<S>; 2] {
    let [w, y] = [&turn[0], &turn[2]].map(|part| window.load(part));
    let twice = y + y;
    [window.splat(1.0) - y * twice, w * twice]
}

/// c v + s Jv.
#[inline(always)]
fn turned<S: Arithmetic>([c, s]: [Lanes<S>; 2], vector: PlaneVector<S>) -> PlaneVector<S> {
    vector * c + quarter_turn(vector) * s
}

impl EightHelices {
    /// Writes what the helices make where they begin, as in space.
    #[inline(always)]
    pub fn unroll_in_plane<S: Arithmetic>(&mut self, simd: S, moving: &mut EightMoving) {
        for window in Window::all(simd) {
            let [cosine, sine] = cosine_and_sine(window, &moving.quaternion);
            let [x_axis, _, z_axis] = &mut moving.turn;
            store(window, x_axis, PlaneVector { x: cosine, z: -sine });
            store(window, z_axis, PlaneVector { x: sine, z: cosine });
            let before = cosine_and_sine(window, &self.turn_before);
            let lambda = turned(before, load(window, &self.slide));
            let lambda_dot = turned(before, load(window, &self.slide_rate));
            let [phi, phi_dot] = [&self.rotation, &self.rotation_rate].map(|vectors| window.load(&vectors.y));

            // t = sin φ/φ λ + (1 − cos φ)/φ Jλ.
            let (two, square) = (window.splat(2.0), phi * phi);
            let [b, c] = Series::both(square);
            let (square_rate, square_acceleration) = (phi * phi_dot * two, phi_dot * phi_dot * two);
            let (b_dot, c_dot) = (b.rate(square_rate), c.rate(square_rate));
            let b_ddot = b.acceleration(square_rate, square_acceleration);
            let c_ddot = c.acceleration(square_rate, square_acceleration);
            let straight = [window.splat(1.0) - c.value * square, b.value * phi];
            let straight_rate = [-(c_dot * square + c.value * square_rate), b_dot * phi + b.value * phi_dot];
            let straight_acceleration = [
                -(c_ddot * square + c_dot * square_rate * two + c.value * square_acceleration),
                b_ddot * phi + b_dot * phi_dot * two,
            ];
            let distance = turned(straight, lambda);
            store(window, &mut self.distance, distance);
            store(window, &mut moving.position, distance);
            store(window, &mut moving.velocity, turned(straight, lambda_dot) + turned(straight_rate, lambda));
            let bias = turned(straight_rate, lambda_dot) * two + turned(straight_acceleration, lambda);
            store(window, &mut moving.acceleration, bias);
            window.store(&mut self.turning.y, phi_dot);
            window.store(&mut moving.spin.y, phi_dot);

            // A, and the part of C that does not depend on where the section is: the derivative of t by φ.
            let [x_axis, _, z_axis] = &mut self.tangent;
            let [cosine, sine] = before;
            store(window, x_axis, turned(straight, PlaneVector { x: cosine, z: -sine }));
            store(window, z_axis, turned(straight, PlaneVector { x: sine, z: cosine }));
            let slope = [-(c.slope * square + c.value) * phi * two, b.value + b.slope * square * two];
            store(window, &mut self.bend[1], turned(slope, lambda));
        }
    }
}

impl EightMoving {
    /// As soon as x and σ are known, as in space.
    #[inline(always)]
    pub fn carry_in_plane<S: Arithmetic>(
        &mut self,
        simd: S,
        (constants, helices): (&EightConstants, &EightHelices),
        twists: &mut EightTwists,
    ) {
        for window in Window::all(simd) {
            // A rotation about y moves O's point of the section against Jx.
            let against = quarter_turn(load(window, &self.position)) * window.splat(-1.0);
            let bend = load(window, &helices.bend[1]) + against;
            let [of_x, _, of_z] = helices.tangent.each_ref().map(|column| load(window, column));
            for ((_, step), (_, twist)) in constants.steps.iter().zip(&mut *twists) {
                let [slide_x, slide_z, turn] = [0, 2, 4].map(|row| window.load(&step[row]));
                let along = bend * turn + (of_x * slide_x + of_z * slide_z);
                for (row, lanes) in [(0, along.x), (2, along.z), (4, turn)] {
                    window.store(&mut twist[row], lanes);
                }
            }
            let (stretching, turning) = (load(window, &self.velocity), window.load(&helices.turning.y));
            store(window, &mut self.velocity_about_origin, stretching + against * turning);
            let spin_before = window.load(&self.spin.y) - turning;
            let circling =
                load(window, &helices.distance).turned_by(spin_before) + stretching * window.splat(2.0);
            let bias = load(window, &self.acceleration) + circling.turned_by(spin_before);
            store(window, &mut self.acceleration_about_origin, bias);
        }
    }

    /// Turns twists about O into w and a at the sections; no bias turns them.
    #[inline(always)]
    pub fn settle_in_plane<S: Arithmetic>(&mut self, simd: S) {
        for window in Window::all(simd) {
            let circling = load(window, &self.position).turned_by(window.load(&self.spin.y));
            let velocity = load(window, &self.velocity_about_origin) + circling;
            store(window, &mut self.velocity, velocity);
            let acceleration = load(window, &self.acceleration_about_origin);
            store(window, &mut self.acceleration, acceleration);
        }
    }
}

/// Sums x and σ along a part.
#[inline(always)]
pub fn add_positions(part: &Part, eights: &mut [EightMoving], index: usize) {
    add_up(part, eights, index, |EightMoving { position, spin, .. }| {
        [&mut position.x, &mut position.z, &mut spin.y]
    });
}

/// Sums the twists of w and a about O.
#[inline(always)]
pub fn add_motion(part: &Part, eights: &mut [EightMoving], index: usize) {
    add_up(
        part,
        eights,
        index,
        |EightMoving { velocity_about_origin: w, acceleration_about_origin: a, .. }| {
            [&mut w.x, &mut w.z, &mut a.x, &mut a.z]
        },
    );
}

//! From the sections before them to eight sections side by side: the helices that lead there.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.jacobians]
//!
//! Symbols: φ and λ are rotation and displacement along a helix, in the axes of the section before. As soon as it is known how
//! that is turned, all four of φ, λ and their rates are turned with it, and what follows is in body axes.

use nalgebra::Vector3;

use crate::math::{Arithmetic, Arrow, Eight, EightVectors, LANES, LaneVector, Lanes, Window};
use crate::structure::BeamSection;

use super::super::kind::Coordinates;
use super::moving::{AT_REST, EightMoving};
use super::series::{Series, half_angle};
use super::twists::{LaneMatrix, Steps, times};

/// What of eight sections is constant.
#[derive(Clone, Debug)]
pub struct EightConstants {
    /// L.
    pub arm: EightVectors,
    /// Dλ and Dφ of each mode that moves any of them.
    pub steps: Steps,
}

/// The helices to eight sections, and what comes of them on the way.
#[derive(Clone, Debug)]
pub struct EightHelices {
    /// φ.
    pub rotation: EightVectors,
    /// λ.
    pub slide: EightVectors,
    /// φ̇.
    pub rotation_rate: EightVectors,
    /// λ̇.
    pub slide_rate: EightVectors,
    /// How the sections before are turned: unit quaternions, scalar first.
    pub turn_before: [Eight; 4],
    /// Columns of A.
    pub tangent: [EightVectors; 3],
    /// Columns of C − x×A.
    pub bend: [EightVectors; 3],
    /// d, m.
    pub distance: EightVectors,
    /// Aφ̇, rad/s.
    pub turning: EightVectors,
}

impl EightHelices {
    /// Of sections that rest where those before them are.
    pub fn resting() -> Self {
        let of = |vector: Vector3<f64>| EightVectors::new([vector; LANES]);
        let none = of(Vector3::zeros());
        EightHelices {
            rotation: none,
            slide: none,
            rotation_rate: none,
            slide_rate: none,
            turn_before: AT_REST,
            tangent: [Vector3::x(), Vector3::y(), Vector3::z()].map(of),
            bend: [none; 3],
            distance: none,
            turning: none,
        }
    }
}

impl EightConstants {
    /// Of up to eight sections with their L, where there are any, by the modes that move any of them; which move which, is said.
    pub fn new(
        sections: &[Option<(&BeamSection, Vector3<f64>)>],
        modes: Vec<usize>,
        moves: impl Fn(usize, usize) -> bool,
    ) -> Self {
        let lanes: Vec<usize> = (0..sections.len()).collect();
        let step = |mode: usize, row: usize| {
            let of = |&lane: &usize| match sections[lane] {
                Some((section, _)) if moves(mode, lane) => section.steps.row(row)[mode],
                _ => 0.0,
            };
            Eight::of(&lanes, of, 0.0)
        };
        let steps = modes.into_iter().map(|mode| (mode, std::array::from_fn(|row| step(mode, row))));
        let arm = |place: &Option<(_, Vector3<f64>)>| place.map_or(Vector3::zeros(), |(_, arm)| arm);
        EightConstants { arm: EightVectors::of(sections, arm, Vector3::zeros()), steps: steps.collect() }
    }

    /// Writes the helices at some q and q̇, and how they turn the sections.
    #[inline(always)]
    pub fn write<S: Arithmetic>(
        &self,
        simd: S,
        Coordinates { q, q_dot }: Coordinates,
        helices: &mut EightHelices,
        turns: &mut [Eight; 4],
    ) {
        helices.turn_before = AT_REST;
        for window in Window::all(simd) {
            let (mut sums, mut rates) = ([window.splat(0.0); 6], [window.splat(0.0); 6]);
            for (mode, step) in &self.steps {
                let (q, q_dot) = (window.splat(q[*mode]), window.splat(q_dot[*mode]));
                for row in 0..6 {
                    let step = window.load(&step[row]);
                    sums[row] += step * q;
                    rates[row] += step * q_dot;
                }
            }
            let [lx, ly, lz, fx, fy, fz] = sums;
            let [mx, my, mz, gx, gy, gz] = rates;
            let rotation = LaneVector { x: fx, y: fy, z: fz };
            let slide = LaneVector::load(window, &self.arm) + LaneVector { x: lx, y: ly, z: lz };
            let [cosine, sine] = half_angle(rotation.dot(&rotation));
            let vector = rotation * sine;
            for (turn, part) in turns.iter_mut().zip([cosine, vector.x, vector.y, vector.z]) {
                window.store(turn, part);
            }
            rotation.store(window, &mut helices.rotation);
            slide.store(window, &mut helices.slide);
            LaneVector { x: gx, y: gy, z: gz }.store(window, &mut helices.rotation_rate);
            LaneVector { x: mx, y: my, z: mz }.store(window, &mut helices.slide_rate);
        }
    }
}

/// The matrix of d 1 + v× + abᵀ.
#[inline(always)]
fn matrix<S: Arithmetic>(
    diagonal: Lanes<S>,
    LaneVector { x, y, z }: LaneVector<S>,
    [column, row]: [&LaneVector<S>; 2],
) -> LaneMatrix<S> {
    [
        *column * row.x + LaneVector { x: diagonal, y: z, z: -y },
        *column * row.y + LaneVector { x: -z, y: diagonal, z: x },
        *column * row.z + LaneVector { x: y, y: -x, z: diagonal },
    ]
}

/// The matrices of unit quaternions.
#[inline(always)]
fn turned_axes<S: Arithmetic>(window: Window<S>, turn: &[Eight; 4]) -> LaneMatrix<S> {
    let [w, x, y, z] = turn.each_ref().map(|part| window.load(part));
    let (one, twice_x, twice_y, twice_z) = (window.splat(1.0), x + x, y + y, z + z);
    let (xx, xy, xz) = (x * twice_x, x * twice_y, x * twice_z);
    let (yy, yz, zz) = (y * twice_y, y * twice_z, z * twice_z);
    let (wx, wy, wz) = (w * twice_x, w * twice_y, w * twice_z);
    [
        LaneVector { x: one - (yy + zz), y: xy + wz, z: xz - wy },
        LaneVector { x: xy - wz, y: one - (xx + zz), z: yz + wx },
        LaneVector { x: xz + wy, y: yz - wx, z: one - (xx + yy) },
    ]
}

impl EightHelices {
    /// Writes what the helices make where they begin: how sections are turned, and in the place of sums along the strands what
    /// each section adds.
    #[inline(always)]
    pub fn unroll<S: Arithmetic>(&mut self, simd: S, moving: &mut EightMoving) {
        for window in Window::all(simd) {
            for (axis, column) in turned_axes(window, &moving.quaternion).iter().zip(&mut moving.turn) {
                axis.store(window, column);
            }
            let before = turned_axes(window, &self.turn_before);
            let phi = times(&before, &LaneVector::load(window, &self.rotation));
            let lambda = times(&before, &LaneVector::load(window, &self.slide));
            let phi_dot = times(&before, &LaneVector::load(window, &self.rotation_rate));
            let lambda_dot = times(&before, &LaneVector::load(window, &self.slide_rate));
            let square = phi.dot(&phi);
            let [b, c] = Series::both(square);
            let helix = Helix { phi, lambda, b, c };
            helix.write_matrices(window, square, &before, self);
            helix.write_motion(window, [phi_dot, lambda_dot], self, moving);
        }
    }
}

/// φ and λ in body axes, b and c.
struct Helix<S: Arithmetic> {
    phi: LaneVector<S>,
    lambda: LaneVector<S>,
    b: Series<S>,
    c: Series<S>,
}

impl<S: Arithmetic> Helix<S> {
    /// A, and the part of C that does not depend on where the section is.
    #[inline(always)]
    fn write_matrices(
        &self,
        window: Window<S>,
        square: Lanes<S>,
        before: &LaneMatrix<S>,
        helices: &mut EightHelices,
    ) {
        let Helix { phi, lambda, b, c } = self;
        let (by_b, by_c) = (*phi * b.value, *phi * c.value);
        let tangent = matrix(window.splat(1.0) - c.value * square, by_b, [&by_c, phi]);

        let (once, two) = (phi.cross(lambda), window.splat(2.0));
        let along = (once * b.slope + phi.cross(&once) * c.slope) * two - *lambda * c.value;
        let axis = (*lambda * b.value + once * c.value) * window.splat(-1.0);
        let bend = matrix(phi.dot(lambda) * c.value, axis, [&along, phi]);
        for (axis, column) in before.iter().enumerate() {
            times(&tangent, column).store(window, &mut helices.tangent[axis]);
            times(&bend, column).store(window, &mut helices.bend[axis]);
        }
    }

    /// d, Aφ̇, R_pṫ, R_pṪφ̇ and R_p(2Ṫλ̇ + T̈λ).
    #[inline(always)]
    fn write_motion(
        &self,
        window: Window<S>,
        [phi_dot, lambda_dot]: [LaneVector<S>; 2],
        helices: &mut EightHelices,
        moving: &mut EightMoving,
    ) {
        let Helix { phi, lambda, b, c } = self;
        let two = window.splat(2.0);
        let square_rate = phi.dot(&phi_dot) * two;
        let square_acceleration = phi_dot.dot(&phi_dot) * two;
        let (b_dot, c_dot) = (b.rate(square_rate), c.rate(square_rate));
        let b_ddot = b.acceleration(square_rate, square_acceleration);
        let c_ddot = c.acceleration(square_rate, square_acceleration);
        let (b, c) = (b.value, c.value);

        // φ×λ and φ×(φ×λ) with their first and second rates.
        let once = phi.cross(lambda);
        let once_rate = phi_dot.cross(lambda) + phi.cross(&lambda_dot);
        let once_acceleration = phi_dot.cross(&lambda_dot) * two;
        let twice = phi.cross(&once);
        let twice_rate = phi_dot.cross(&once) + phi.cross(&once_rate);
        let twice_acceleration = phi_dot.cross(&once_rate) * two + phi.cross(&once_acceleration);
        let distance = *lambda + once * b + twice * c;
        distance.store(window, &mut helices.distance);
        distance.store(window, &mut moving.position);
        let stretching = lambda_dot + once * b_dot + once_rate * b + twice * c_dot + twice_rate * c;
        stretching.store(window, &mut moving.velocity);
        let bias = once * b_ddot
            + once_rate * (b_dot * two)
            + once_acceleration * b
            + twice * c_ddot
            + twice_rate * (c_dot * two)
            + twice_acceleration * c;
        bias.store(window, &mut moving.acceleration);

        let spin = phi.cross(&phi_dot);
        let spin_twice = phi.cross(&spin);
        let turning = phi_dot + spin * b + spin_twice * c;
        turning.store(window, &mut helices.turning);
        turning.store(window, &mut moving.spin);
        let spin_bias = spin * b_dot + spin_twice * c_dot + phi_dot.cross(&spin) * c;
        spin_bias.store(window, &mut moving.angular_acceleration);
    }
}

//! From the section before to eight sections side by side, in the axes of the former.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.rates, geometrically-exact.biases, geometrically-exact.jacobians]
//!
//! Symbols: φ and λ are rotation and displacement along a helix, R_p E(φ) the turn of the section, R_p T(φ)λ its distance.

use nalgebra::Vector3;

use crate::math::{Arithmetic, Arrow, Eight, EightVectors, LaneVector, Lanes, Window};
use crate::structure::BeamSection;

use super::super::kind::Coordinates;
use super::series::Series;

/// What of eight sections is constant.
#[derive(Clone, Debug)]
pub struct EightConstants {
    /// L.
    arm: EightVectors,
    /// Dλ and Dφ of each mode.
    steps: Vec<[Eight; 6]>,
}

/// Columns of a matrix for each of eight sections.
pub type EightMatrices = [[Eight; 3]; 3];

/// What an evaluation writes of eight sections, in the axes of those before them.
#[derive(Clone, Debug)]
pub struct EightSteps {
    /// E.
    pub turn: EightMatrices,
    /// T.
    pub tangent: EightMatrices,
    /// ∂(Tλ)/∂φ.
    pub bend: EightMatrices,
    /// t = Tλ, m.
    pub distance: [Eight; 3],
    /// ṫ, m/s.
    pub velocity: [Eight; 3],
    /// Tφ̇, rad/s.
    pub spin: [Eight; 3],
    /// 2Ṫλ̇ + T̈λ, m/s².
    pub bias: [Eight; 3],
    /// Ṫφ̇, rad/s².
    pub spin_bias: [Eight; 3],
}

impl EightSteps {
    /// Of sections that rest where those before them are.
    pub const NONE: EightSteps = EightSteps {
        turn: [[Eight::ZERO; 3]; 3],
        tangent: [[Eight::ZERO; 3]; 3],
        bend: [[Eight::ZERO; 3]; 3],
        distance: [Eight::ZERO; 3],
        velocity: [Eight::ZERO; 3],
        spin: [Eight::ZERO; 3],
        bias: [Eight::ZERO; 3],
        spin_bias: [Eight::ZERO; 3],
    };
}

impl EightConstants {
    /// Of up to eight sections, each with its L.
    pub fn new(sections: &[(&BeamSection, Vector3<f64>)], modes: usize) -> Self {
        let steps = |mode: usize| {
            std::array::from_fn(|row| Eight::of(sections, |(section, _)| section.steps.row(row)[mode], 0.0))
        };
        EightConstants {
            arm: EightVectors::of(sections, |(_, arm)| *arm, Vector3::zeros()),
            steps: (0..modes).map(steps).collect(),
        }
    }

    /// Writes the steps at some q and q̇.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, at: Coordinates, steps: &mut EightSteps) {
        for window in Window::all(simd) {
            let helix = self.helix(window, at);
            helix.write_turns(window, steps);
            helix.write_motion(window, steps);
        }
    }

    #[inline(always)]
    fn helix<S: Arithmetic>(&self, window: Window<S>, Coordinates { q, q_dot }: Coordinates) -> Helix<S> {
        let (mut sums, mut rates) = ([window.splat(0.0); 6], [window.splat(0.0); 6]);
        for (step, (&q, &q_dot)) in self.steps.iter().zip(q.iter().zip(q_dot)) {
            for row in 0..6 {
                let step = window.load(&step[row]);
                sums[row] += step * q;
                rates[row] += step * q_dot;
            }
        }
        let [lx, ly, lz, fx, fy, fz] = sums;
        let [mx, my, mz, gx, gy, gz] = rates;
        let rotation = LaneVector { x: fx, y: fy, z: fz };
        let square = rotation.dot(&rotation);
        Helix {
            rotation,
            slide: LaneVector::load(window, &self.arm) + LaneVector { x: lx, y: ly, z: lz },
            rotation_rate: LaneVector { x: gx, y: gy, z: gz },
            slide_rate: LaneVector { x: mx, y: my, z: mz },
            square,
            b: Series::versine(square),
            c: Series::sine_deficit(square),
        }
    }
}

/// φ and λ with their rates; s = φ·φ, b and c.
struct Helix<S: Arithmetic> {
    rotation: LaneVector<S>,
    slide: LaneVector<S>,
    rotation_rate: LaneVector<S>,
    slide_rate: LaneVector<S>,
    square: Lanes<S>,
    b: Series<S>,
    c: Series<S>,
}

impl<S: Arithmetic> Helix<S> {
    /// E, T, the derivative of Tλ, and Tλ itself.
    #[inline(always)]
    fn write_turns(&self, window: Window<S>, steps: &mut EightSteps) {
        let Helix { rotation, slide, square, b, c, .. } = self;
        let (b, c) = (b.value, c.value);
        let one = window.splat(1.0);
        let a = one - c * *square;
        // φ×φ× = φφᵀ − s 1.
        store_matrix(
            window,
            &mut steps.turn,
            one - b * *square,
            &(*rotation * a),
            [&(*rotation * b), rotation],
        );
        store_matrix(window, &mut steps.tangent, a, &(*rotation * b), [&(*rotation * c), rotation]);

        let once = rotation.cross(slide);
        let twice = rotation.cross(&once);
        let two = window.splat(2.0);
        let along = once * (self.b.slope * two) + twice * (self.c.slope * two);
        let axis = *slide * b + once * c;
        let minus = window.splat(-1.0);
        let diagonal = c * rotation.dot(slide);
        store_matrix(window, &mut steps.bend, diagonal, &(axis * minus), [&(along - *slide * c), rotation]);
        store(window, &mut steps.distance, &(*slide + once * b + twice * c));
    }

    /// Rates of what the turns make, and what remains of their rates at q̈ = 0.
    #[inline(always)]
    fn write_motion(&self, window: Window<S>, steps: &mut EightSteps) {
        let Helix { rotation: phi, slide, rotation_rate: phi_dot, slide_rate, .. } = self;
        let two = window.splat(2.0);
        let square_rate = phi.dot(phi_dot) * two;
        let square_acceleration = phi_dot.dot(phi_dot) * two;
        let [b_dot, c_dot] = [self.b, self.c].map(|series| series.rate(square_rate));
        let [b_ddot, c_ddot] =
            [self.b, self.c].map(|series| series.acceleration(square_rate, square_acceleration));
        let (b, c) = (self.b.value, self.c.value);

        let once = phi.cross(slide);
        let twice = phi.cross(&once);
        let turning = phi_dot.cross(slide);
        // φ̇×(φ×λ) + φ×(φ̇×λ).
        let turning_twice = phi_dot.cross(&once) + phi.cross(&turning);
        let sliding = phi.cross(slide_rate);
        let sliding_twice = phi.cross(&sliding);
        let own_rate = once * b_dot + turning * b + twice * c_dot + turning_twice * c;
        store(window, &mut steps.velocity, &(*slide_rate + sliding * b + sliding_twice * c + own_rate));

        let spin = phi.cross(phi_dot);
        let spin_twice = phi.cross(&spin);
        store(window, &mut steps.spin, &(*phi_dot + spin * b + spin_twice * c));
        store(window, &mut steps.spin_bias, &(spin * b_dot + spin_twice * c_dot + phi_dot.cross(&spin) * c));

        let both = phi_dot.cross(slide_rate);
        let tangent_rate = sliding * b_dot
            + both * b
            + sliding_twice * c_dot
            + (phi_dot.cross(&sliding) + phi.cross(&both)) * c;
        let tangent_acceleration = once * b_ddot
            + turning * (b_dot * two)
            + twice * c_ddot
            + turning_twice * (c_dot * two)
            + phi_dot.cross(&turning) * (c * two);
        store(window, &mut steps.bias, &(tangent_rate * two + tangent_acceleration));
    }
}

#[inline(always)]
fn store<S: Arithmetic>(window: Window<S>, eight: &mut [Eight; 3], vectors: &LaneVector<S>) {
    for (axis, eight) in eight.iter_mut().enumerate() {
        window.store(eight, vectors.component(axis));
    }
}

/// Writes d 1 + v× + abᵀ by columns.
#[inline(always)]
fn store_matrix<S: Arithmetic>(
    window: Window<S>,
    matrix: &mut EightMatrices,
    diagonal: Lanes<S>,
    cross: &LaneVector<S>,
    [column, row]: [&LaneVector<S>; 2],
) {
    let LaneVector { x, y, z } = *cross;
    let rest = [
        LaneVector { x: diagonal, y: z, z: -y },
        LaneVector { x: -z, y: diagonal, z: x },
        LaneVector { x: y, y: -x, z: diagonal },
    ];
    for (axis, (eight, rest)) in matrix.iter_mut().zip(rest).enumerate() {
        store(window, eight, &(*column * row.component(axis) + rest));
    }
}

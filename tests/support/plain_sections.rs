//! Sections of geometrically exact kinematics as the theory writes them, from one section outward, with vectors and matrices
//! that carry their first two derivatives by time: nothing of the program's rates, biases and rows is used.
//!
//! [theory: geometrically-exact.recursion, geometrically-exact.attached]

use flexible_aircraft::structure::BeamSection;
use nalgebra::{Matrix3, Vector3};

/// A vector or matrix with its first and second derivative.
#[derive(Clone, Copy)]
struct Jet<T>([T; 3]);

impl Jet<Matrix3<f64>> {
    const ONE: Self = Jet([
        Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ]);

    /// A product, by Leibniz' rule.
    fn times<const N: usize>(&self, Jet([b, b_dot, b_ddot]): &Jet<Columns<N>>) -> Jet<Columns<N>> {
        let Jet([a, a_dot, a_ddot]) = self;
        Jet([a * b, a_dot * b + a * b_dot, a_ddot * b + a_dot * b_dot * 2.0 + a * b_ddot])
    }
}

type Columns<const N: usize> = nalgebra::SMatrix<f64, 3, N>;

impl<const N: usize> Jet<Columns<N>> {
    fn plus(&self, other: &Self) -> Self {
        Jet([0, 1, 2].map(|order| self.0[order] + other.0[order]))
    }

    fn over(&self, number: f64) -> Self {
        Jet(self.0.map(|order| order / number))
    }
}

/// What does not move.
fn constant(vector: &Vector3<f64>) -> Jet<Vector3<f64>> {
    Jet([*vector, Vector3::zeros(), Vector3::zeros()])
}

/// A point fixed to a section, while q moves at constant q̇; relative to the body axes.
#[derive(Clone, Debug)]
pub struct MovingPoint {
    /// R.
    pub turn: Matrix3<f64>,
    /// X, m.
    pub place: Vector3<f64>,
    /// w, m/s.
    pub velocity: Vector3<f64>,
    /// σ, rad/s.
    pub spin: Vector3<f64>,
    /// a, m/s².
    pub acceleration: Vector3<f64>,
    /// α, rad/s².
    pub angular_acceleration: Vector3<f64>,
}

/// The point at an offset (body axes, undeformed, m) from one of the sections, at some q and q̇.
pub fn moving_point(
    sections: &[BeamSection],
    motion: [&[f64]; 2],
    section: usize,
    offset: &Vector3<f64>,
) -> MovingPoint {
    let (turn, place) = pose(sections, motion, section);
    let Jet([place, velocity, acceleration]) = place.plus(&turn.times(&constant(offset)));
    let Jet([turn, turn_dot, turn_ddot]) = turn;
    MovingPoint {
        turn,
        place,
        velocity,
        spin: axis(&(turn_dot * turn.transpose())),
        acceleration,
        angular_acceleration: axis(&(turn_ddot * turn.transpose())),
    }
}

/// The vector of the antisymmetric part.
fn axis(matrix: &Matrix3<f64>) -> Vector3<f64> {
    let m = (matrix - matrix.transpose()) * 0.5;
    Vector3::new(m[(2, 1)], m[(0, 2)], m[(1, 0)])
}

/// R and x of a section.
fn pose(
    sections: &[BeamSection],
    motion: [&[f64]; 2],
    section: usize,
) -> (Jet<Matrix3<f64>>, Jet<Vector3<f64>>) {
    let BeamSection { parent, position, steps, .. } = &sections[section];
    if section == 0 {
        return (Jet::ONE, constant(position));
    }
    let (turn, place) = pose(sections, motion, *parent);
    let modes = steps.modes();
    let sum = |rows: &[f64], numbers: &[f64]| {
        Vector3::from_fn(|axis, _| {
            rows[axis * modes..][..modes].iter().zip(numbers).map(|(a, b)| a * b).sum()
        })
    };
    let along = |rows: &[f64]| Jet([sum(rows, motion[0]), sum(rows, motion[1]), Vector3::zeros()]);
    let phi = along(&steps.rotation);
    let lambda = along(&steps.translation).plus(&constant(&(position - sections[*parent].position)));
    let [rotation, tangent] = [0, 1].map(|from| exponential(&phi, from));
    (turn.times(&rotation), place.plus(&turn.times(&tangent.times(&lambda))))
}

/// Σ (φ×)ⁿ/(n + from)!: E from 0, T from 1.
fn exponential(phi: &Jet<Vector3<f64>>, from: u32) -> Jet<Matrix3<f64>> {
    let cross = Jet(phi.0.map(|vector| vector.cross_matrix()));
    let mut term = Jet::ONE;
    let mut sum = term;
    for n in 1..25 {
        term = term.times(&cross).over(f64::from(n + from));
        sum = sum.plus(&term);
    }
    sum
}

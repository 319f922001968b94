//! The rotation exp(φ×) of a section by its elastic rotation vector (Rodrigues).
//!
//! [theory: frames.rotation, frames.spin]

use super::arithmetic::Arithmetic;
use super::lane_vectors::{Arrow, LaneVector, PlaneVector};
use super::lanes::Lanes;

/// Below this φ² the series are exact to rounding, and cheaper than a sine [theory: frames.rotation].
const SERIES_LIMIT: f64 = 0.25;

/// The first term left out is below 1e-17 of the sum.
const TERMS: usize = 7;

/// (−1)^k / (2k + 2)!: (1 − cos φ)/φ² in powers of φ².
const VERSINE: [f64; TERMS] = taylor(2);

/// (−1)^k / (2k + 3)!: (1 − sin φ/φ)/φ² in powers of φ².
const SINE_DEFICIT: [f64; TERMS] = taylor(3);

/// (−1)^k / (2k + first)!.
const fn taylor(first: usize) -> [f64; TERMS] {
    let mut coefficients = [0.0; TERMS];
    let (mut factorial, mut sign, mut k) = (1.0, 1.0, 0);
    let mut factor = 2;
    while k < TERMS {
        while factor <= 2 * k + first {
            factorial *= factor as f64;
            factor += 1;
        }
        coefficients[k] = sign / factorial;
        sign = -sign;
        k += 1;
    }
    coefficients
}

/// exp(φ×) = 1 + (sin φ/φ) φ× + ((1 − cos φ)/φ²) φ×φ×, ready to be applied.
#[derive(Clone, Copy, Debug)]
pub struct Rotation<S: Arithmetic> {
    vector: LaneVector<S>,
    /// sin φ/φ.
    sine: Lanes<S>,
    /// (1 − cos φ)/φ².
    versine: Lanes<S>,
    /// (1 − sin φ/φ)/φ².
    sine_deficit: Lanes<S>,
}

impl<S: Arithmetic> Rotation<S> {
    /// By the vectors φ, rad.
    #[inline(always)]
    pub fn new(vector: LaneVector<S>) -> Self {
        let [sine, versine, sine_deficit] = functions(vector.dot(&vector));
        Rotation { vector, sine, versine, sine_deficit }
    }

    /// The turned vectors.
    #[inline(always)]
    pub fn apply(&self, vectors: &LaneVector<S>) -> LaneVector<S> {
        let once = self.vector.cross(vectors);
        let twice = self.vector.cross(&once);
        *vectors + once * self.sine + twice * self.versine
    }

    /// The vectors turned back.
    #[inline(always)]
    pub fn apply_inverse(&self, vectors: &LaneVector<S>) -> LaneVector<S> {
        let once = self.vector.cross(vectors);
        let twice = self.vector.cross(&once);
        *vectors - once * self.sine + twice * self.versine
    }

    /// How far the spin of the turning section exceeds the rate of its rotation vector, rad/s: the left
    /// Jacobian of the exponential less one, times φ̇ [theory: frames.spin].
    #[inline(always)]
    pub fn excess_spin(&self, vector_rate: &LaneVector<S>) -> LaneVector<S> {
        let once = self.vector.cross(vector_rate);
        let twice = self.vector.cross(&once);
        once * self.versine + twice * self.sine_deficit
    }
}

/// Rotation of the mirror plane, about y.
#[derive(Clone, Copy, Debug)]
pub struct PlaneRotation<S: Arithmetic> {
    cosine: Lanes<S>,
    sine: Lanes<S>,
}

impl<S: Arithmetic> PlaneRotation<S> {
    /// By angles, rad.
    #[inline(always)]
    pub fn new(angle: Lanes<S>) -> Self {
        let square = angle * angle;
        let [sine, versine, _] = functions(square);
        PlaneRotation { cosine: square.splat(1.0) - square * versine, sine: angle * sine }
    }

    /// Those that take the z axis to unit vectors.
    #[inline(always)]
    pub fn to(z_axis: PlaneVector<S>) -> Self {
        PlaneRotation { cosine: z_axis.z, sine: z_axis.x }
    }

    /// The turned vectors.
    #[inline(always)]
    pub fn apply(&self, vectors: &PlaneVector<S>) -> PlaneVector<S> {
        *vectors * self.cosine + vectors.turned_by(self.sine)
    }
}

/// sin φ/φ, (1 − cos φ)/φ² and (1 − sin φ/φ)/φ² of φ².
#[inline(always)]
fn functions<S: Arithmetic>(square: Lanes<S>) -> [Lanes<S>; 3] {
    let (mut versine, mut sine_deficit) = (polynomial(square, &VERSINE), polynomial(square, &SINE_DEFICIT));
    let mut sine = square.splat(1.0) - square * sine_deficit;
    if square.largest() >= SERIES_LIMIT {
        [sine, versine, sine_deficit] = closed_forms([square, sine, versine, sine_deficit]);
    }
    [sine, versine, sine_deficit]
}

/// φ² and the series of the [`functions`]; returns these, replaced where the angle is too large for the series.
#[cold]
fn closed_forms<S: Arithmetic>(
    [square, mut sine, mut versine, mut sine_deficit]: [Lanes<S>; 4],
) -> [Lanes<S>; 3] {
    for (lane, &square) in square.numbers().iter().enumerate().filter(|(_, square)| **square >= SERIES_LIMIT)
    {
        let angle = libm::sqrt(square);
        let (sin, cos) = libm::sincos(angle);
        sine.numbers_mut()[lane] = sin / angle;
        versine.numbers_mut()[lane] = (1.0 - cos) / square;
        sine_deficit.numbers_mut()[lane] = (1.0 - sin / angle) / square;
    }
    [sine, versine, sine_deficit]
}

/// c₀ + c₁x + c₂x² + …, in pairs: a shorter way from x to the sum.
#[inline(always)]
fn polynomial<S: Arithmetic>(x: Lanes<S>, [c0, c1, c2, c3, c4, c5, c6]: &[f64; TERMS]) -> Lanes<S> {
    let pair = |low: &f64, high: &f64| x * *high + x.splat(*low);
    let square = x * x;
    let (first, second, third) = (pair(c0, c1), pair(c2, c3), pair(c4, c5));
    first + square * (second + square * (third + square * *c6))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use pulp::Scalar;

    use super::*;
    use crate::math::{Eight, EightVectors, LANES, Window};

    /// A single vector turned by a single rotation vector.
    fn turned(rotation: &Vector3<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
        Rotation::<Scalar>::new(LaneVector::single(rotation)).apply(&LaneVector::single(vector)).vector()
    }

    #[test]
    fn the_exponential_is_a_rotation_about_the_vector_on_both_sides_of_the_series_limit() {
        let arm = Vector3::new(0.3, -1.0, 0.7);
        for length in [0.0, 1e-9, 0.3, 0.499_999, 0.500_001, 2.0] {
            let vector = Vector3::new(0.6, -0.48, 0.64) * length;
            let reference = nalgebra::Rotation3::new(vector) * arm;
            assert!((turned(&vector, &arm) - reference).norm() < 1e-15 * 4.0, "{length}");
        }
    }

    #[test]
    fn in_the_plane_the_rotation_is_the_same() {
        let arm = Vector3::new(0.3, 0.0, 0.7);
        for angle in [0.0, -0.2, 0.499_999, 0.500_001, 2.0] {
            let turned = turned(&Vector3::new(0.0, angle, 0.0), &arm);
            let window = Window::single();
            let in_plane = PlaneRotation::new(window.splat(angle)).apply(&PlaneVector::splat(window, &arm));
            let [x, z] = [in_plane.x, in_plane.z].map(|lanes| lanes.numbers()[0]);
            assert!((Vector3::new(x, 0.0, z) - turned).norm() < 1e-15, "{angle}");
        }
    }

    #[test]
    fn spin_is_the_rate_of_turned_vectors() {
        let (arm, rate) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(-0.4, 0.9, 0.2));
        for vector in [Vector3::new(0.1, 0.2, -0.1), Vector3::new(0.7, -1.0, 0.5)] {
            let step = 1e-5;
            let [ahead, behind] = [step, -step].map(|step| turned(&(vector + rate * step), &arm));
            let rotation = Rotation::<Scalar>::new(LaneVector::single(&vector));
            let spin = rate + rotation.excess_spin(&LaneVector::single(&rate)).vector();
            let back = rotation.apply_inverse(&LaneVector::single(&turned(&vector, &arm))).vector();
            assert!((back - arm).norm() < 1e-15 * 4.0);
            let error = (ahead - behind) / (2.0 * step) - spin.cross(&turned(&vector, &arm));
            assert!(error.norm() < 1e-9, "{error}");
        }
    }

    #[test]
    fn a_lane_does_not_depend_on_its_neighbours() {
        let small = Vector3::new(0.1, 0.2, -0.1);
        let mut mixed = [small; LANES];
        (mixed[1], mixed[2]) = (small * 10.0, Vector3::zeros());
        let mixed = EightVectors::new(mixed);
        let mut turned_x = Eight::ZERO;
        for window in Window::all(Scalar::new()) {
            let turned = Rotation::new(LaneVector::load(window, &mixed))
                .apply(&LaneVector::splat(window, &Vector3::y()));
            window.store(&mut turned_x, turned.x);
        }
        assert_eq!(turned_x.0[3], turned(&small, &Vector3::y()).x);
    }
}

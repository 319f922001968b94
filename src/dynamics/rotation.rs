//! The rotation exp(φ×) of a section by its elastic rotation vector (Rodrigues).

use nalgebra::Vector3;

use crate::lanes::{LANES, LaneVector, Lanes};

/// Below this φ² the series are exact to rounding, and cheaper than a sine.
const SERIES_LIMIT: f64 = 0.25;

/// 1/(k(k+1)) for k = 2, 4, … 16: the ratios of successive terms of sin φ/φ in φ².
const SINE: [f64; 8] =
    [1.0 / 6.0, 1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0, 1.0 / 110.0, 1.0 / 156.0, 1.0 / 210.0, 1.0 / 272.0];

/// 1/(k(k+1)) for k = 3, 5, … 17: the ratios of successive terms of 2(1 − cos φ)/φ² in φ².
const VERSINE: [f64; 8] =
    [1.0 / 12.0, 1.0 / 30.0, 1.0 / 56.0, 1.0 / 90.0, 1.0 / 132.0, 1.0 / 182.0, 1.0 / 240.0, 1.0 / 306.0];

/// 1/(k(k+1)) for k = 4, 6, … 18: the ratios of successive terms of 6(1 − sin φ/φ)/φ² in φ².
const SINE_DEFICIT: [f64; 8] =
    [1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0, 1.0 / 110.0, 1.0 / 156.0, 1.0 / 210.0, 1.0 / 272.0, 1.0 / 342.0];

/// exp(φ×) = 1 + (sin φ/φ) φ× + ((1 − cos φ)/φ²) φ×φ×, ready to be applied.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    vector: LaneVector,
    /// sin φ/φ.
    sine: Lanes,
    /// (1 − cos φ)/φ².
    versine: Lanes,
    /// (1 − sin φ/φ)/φ².
    sine_deficit: Lanes,
}

impl Rotation {
    /// By the vectors φ, rad.
    pub fn new(vector: LaneVector) -> Self {
        let square = vector.dot(&vector);
        let mut sine = alternating_series(square, &SINE);
        let mut versine = alternating_series(square, &VERSINE) * Lanes::splat(0.5);
        let mut sine_deficit = alternating_series(square, &SINE_DEFICIT) * Lanes::splat(1.0 / 6.0);
        let squares = square.to_array();
        if squares.iter().any(|&square| square >= SERIES_LIMIT) {
            let (mut sines, mut versines) = (sine.to_array(), versine.to_array());
            let mut deficits = sine_deficit.to_array();
            for lane in (0..LANES).filter(|&lane| squares[lane] >= SERIES_LIMIT) {
                let angle = libm::sqrt(squares[lane]);
                let (sin, cos) = libm::sincos(angle);
                (sines[lane], versines[lane]) = (sin / angle, (1.0 - cos) / squares[lane]);
                deficits[lane] = (1.0 - sines[lane]) / squares[lane];
            }
            (sine, versine) = (Lanes::new(sines), Lanes::new(versines));
            sine_deficit = Lanes::new(deficits);
        }
        Rotation { vector, sine, versine, sine_deficit }
    }

    /// The turned vectors.
    pub fn apply(&self, vectors: &LaneVector) -> LaneVector {
        let once = self.vector.cross(vectors);
        let twice = self.vector.cross(&once);
        *vectors + once * self.sine + twice * self.versine
    }

    /// How far the spin of the turning section exceeds the rate of its rotation vector, rad/s: the left
    /// Jacobian of the exponential less one, times φ̇.
    pub fn excess_spin(&self, vector_rate: &LaneVector) -> LaneVector {
        let once = self.vector.cross(vector_rate);
        let twice = self.vector.cross(&once);
        once * self.versine + twice * self.sine_deficit
    }
}

/// A single vector turned by a single rotation vector.
pub fn turned(rotation: &Vector3<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    first_lane(&Rotation::new(LaneVector::splat(rotation)).apply(&LaneVector::splat(vector)))
}

/// The vector of the first lane.
pub fn first_lane(vectors: &LaneVector) -> Vector3<f64> {
    Vector3::new(vectors.x.to_array()[0], vectors.y.to_array()[0], vectors.z.to_array()[0])
}

/// 1 − r₀x (1 − r₁x (1 − …)).
fn alternating_series(x: Lanes, ratios: &[f64; 8]) -> Lanes {
    let one = Lanes::splat(1.0);
    ratios.iter().rev().fold(one, |tail, &ratio| one - Lanes::splat(ratio) * x * tail)
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn spin_is_the_rate_of_turned_vectors() {
        let (arm, rate) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(-0.4, 0.9, 0.2));
        for vector in [Vector3::new(0.1, 0.2, -0.1), Vector3::new(0.7, -1.0, 0.5)] {
            let step = 1e-5;
            let [ahead, behind] = [step, -step].map(|step| turned(&(vector + rate * step), &arm));
            let excess = Rotation::new(LaneVector::splat(&vector)).excess_spin(&LaneVector::splat(&rate));
            let spin = rate + first_lane(&excess);
            let error = (ahead - behind) / (2.0 * step) - spin.cross(&turned(&vector, &arm));
            assert!(error.norm() < 1e-9, "{error}");
        }
    }

    #[test]
    fn a_lane_does_not_depend_on_its_neighbours() {
        let small = Vector3::new(0.1, 0.2, -0.1);
        let mixed = LaneVector::new([small, small * 10.0, Vector3::zeros(), small]);
        let arm = LaneVector::splat(&Vector3::y());
        let together = Rotation::new(mixed).apply(&arm);
        assert_eq!(together.x.to_array()[3], turned(&small, &Vector3::y()).x);
    }
}

//! The rotation exp(φ×) of a section by its elastic rotation vector (Rodrigues).

use nalgebra::{Matrix3, Vector3};

/// Below this φ² the series are exact to rounding, and cheaper than a sine.
const SERIES_LIMIT: f64 = 0.25;

/// exp(φ×) = 1 + (sin φ/φ) φ× + ((1 − cos φ)/φ²) φ×φ×.
pub fn exponential(rotation: &Vector3<f64>) -> Matrix3<f64> {
    let square = rotation.norm_squared();
    let (sine, versine) = if square < SERIES_LIMIT {
        (alternating_series(square, &SINE), alternating_series(square, &VERSINE) * 0.5)
    } else {
        let angle = libm::sqrt(square);
        let (sin, cos) = libm::sincos(angle);
        (sin / angle, (1.0 - cos) / square)
    };
    let cross = rotation.cross_matrix();
    Matrix3::identity() * (1.0 - versine * square) + cross * sine + rotation * rotation.transpose() * versine
}

/// 1/(k(k+1)) for k = 2, 4, … 16: the ratios of successive terms of sin φ/φ in φ².
const SINE: [f64; 8] =
    [1.0 / 6.0, 1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0, 1.0 / 110.0, 1.0 / 156.0, 1.0 / 210.0, 1.0 / 272.0];

/// 1/(k(k+1)) for k = 3, 5, … 17: the ratios of successive terms of 2(1 − cos φ)/φ² in φ².
const VERSINE: [f64; 8] =
    [1.0 / 12.0, 1.0 / 30.0, 1.0 / 56.0, 1.0 / 90.0, 1.0 / 132.0, 1.0 / 182.0, 1.0 / 240.0, 1.0 / 306.0];

/// 1 − r₀x (1 − r₁x (1 − …)).
fn alternating_series(x: f64, ratios: &[f64; 8]) -> f64 {
    ratios.iter().rev().fold(1.0, |tail, ratio| 1.0 - ratio * x * tail)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponential_is_a_rotation_about_the_vector_on_both_sides_of_the_series_limit() {
        for length in [0.0, 1e-9, 0.3, 0.499_999, 0.500_001, 2.0] {
            let vector = Vector3::new(0.6, -0.48, 0.64) * length;
            let matrix = exponential(&vector);
            let reference = nalgebra::Rotation3::new(vector);
            assert!((matrix - reference.matrix()).norm() < 1e-15 * 4.0, "{length}");
            assert!((matrix * matrix.transpose() - Matrix3::identity()).norm() < 1e-15 * 4.0);
        }
    }
}

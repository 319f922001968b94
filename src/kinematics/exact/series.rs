//! (1 − cos φ)/φ² and (1 − sin φ/φ)/φ² with their derivatives by φ², by series, without a branch and without trigonometry.
//!
//! [theory: geometrically-exact.series]

use crate::math::{Arithmetic, Lanes};

/// Good to 1e-14 up to 1 rad from section to section, and to 1e-10 up to 2 rad.
const TERMS: usize = 8;

/// (−1)ⁿ / (2n + 2)!.
const VERSINE: [f64; TERMS] = coefficients(2);

/// (−1)ⁿ / (2n + 3)!.
const SINE_DEFICIT: [f64; TERMS] = coefficients(3);

/// (−1)ⁿ / (2n + first)!.
const fn coefficients(first: usize) -> [f64; TERMS] {
    let mut coefficients = [0.0; TERMS];
    let (mut factorial, mut sign, mut factor, mut n) = (1.0, 1.0, 2, 0);
    while n < TERMS {
        while factor <= 2 * n + first {
            factorial *= factor as f64;
            factor += 1;
        }
        coefficients[n] = sign / factorial;
        sign = -sign;
        n += 1;
    }
    coefficients
}

/// (−1)ⁿ / (4ⁿ (2n)!).
const HALF_COSINE: [f64; TERMS] = halved(coefficients(0), 1.0);

/// (−1)ⁿ / (2·4ⁿ (2n + 1)!).
const HALF_SINE: [f64; TERMS] = halved(coefficients(1), 0.5);

/// Coefficients for a quarter of the argument, times a factor.
const fn halved(mut coefficients: [f64; TERMS], mut factor: f64) -> [f64; TERMS] {
    let mut n = 0;
    while n < TERMS {
        coefficients[n] *= factor;
        factor *= 0.25;
        n += 1;
    }
    coefficients
}

/// cos(φ/2) and sin(φ/2)/φ of φ².
#[inline(always)]
pub fn half_angle<S: Arithmetic>(square: Lanes<S>) -> [Lanes<S>; 2] {
    [polynomial(square, &HALF_COSINE), polynomial(square, &HALF_SINE)]
}

/// Horner's scheme.
#[inline(always)]
fn polynomial<S: Arithmetic>(square: Lanes<S>, [rest @ .., last]: &[f64; TERMS]) -> Lanes<S> {
    let sum = square.splat(*last);
    rest.iter().rev().fold(sum, |sum, &coefficient| sum * square + square.splat(coefficient))
}

/// A function of s = φ².
#[derive(Clone, Copy, Debug)]
pub struct Series<S: Arithmetic> {
    /// Its value.
    pub value: Lanes<S>,
    /// Its derivative.
    pub slope: Lanes<S>,
    /// Its second derivative.
    pub curvature: Lanes<S>,
}

impl<S: Arithmetic> Series<S> {
    /// b = (1 − cos φ)/φ².
    #[inline(always)]
    pub fn versine(square: Lanes<S>) -> Self {
        Series::sum(square, &VERSINE)
    }

    /// c = (1 − sin φ/φ)/φ².
    #[inline(always)]
    pub fn sine_deficit(square: Lanes<S>) -> Self {
        Series::sum(square, &SINE_DEFICIT)
    }

    /// Horner's scheme, carried on to the derivatives.
    #[inline(always)]
    fn sum(square: Lanes<S>, coefficients: &[f64; TERMS]) -> Self {
        let zero = square.splat(0.0);
        let (mut value, mut slope, mut half_curvature) = (zero, zero, zero);
        for &coefficient in coefficients.iter().rev() {
            half_curvature = half_curvature * square + slope;
            slope = slope * square + value;
            value = value * square + square.splat(coefficient);
        }
        Series { value, slope, curvature: half_curvature + half_curvature }
    }

    /// How fast it changes with s.
    #[inline(always)]
    pub fn rate(&self, square_rate: Lanes<S>) -> Lanes<S> {
        self.slope * square_rate
    }

    /// How fast that changes.
    #[inline(always)]
    pub fn acceleration(&self, square_rate: Lanes<S>, square_acceleration: Lanes<S>) -> Lanes<S> {
        self.curvature * square_rate * square_rate + self.slope * square_acceleration
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Window, derivative};

    fn numbers(series: Series<pulp::Scalar>) -> [f64; 3] {
        [series.value, series.slope, series.curvature].map(|lanes| lanes.numbers()[0])
    }

    #[test]
    fn the_series_are_the_functions_of_the_angle() {
        for (angle, bound) in [(0.1_f64, 1e-13), (0.5, 1e-14), (1.0, 1e-14), (2.0, 1e-10)] {
            let square = Window::single().splat(angle * angle);
            let [versine, ..] = numbers(Series::versine(square));
            let [deficit, ..] = numbers(Series::sine_deficit(square));
            let (sin, cos) = libm::sincos(angle);
            assert!((versine - (1.0 - cos) / (angle * angle)).abs() < bound, "{angle}");
            assert!((deficit - (1.0 - sin / angle) / (angle * angle)).abs() < bound, "{angle}");
            let (sin, cos) = libm::sincos(0.5 * angle);
            let [half_cosine, half_sine] = half_angle(square).map(|lanes| lanes.numbers()[0]);
            assert!((half_cosine - cos).abs() < bound && (half_sine - sin / angle).abs() < bound, "{angle}");
        }
    }

    #[test]
    fn slopes_and_curvatures_are_those_of_the_series() {
        let at = |square: f64| {
            let square = Window::single().splat(square);
            [numbers(Series::versine(square)), numbers(Series::sine_deficit(square))]
        };
        for square in [0.0, 0.3, 1.0] {
            let values = [-0.02, -0.01, 0.01, 0.02].map(|step| at(square + step));
            for (function, [_, slope, curvature]) in at(square).into_iter().enumerate() {
                let by_differences =
                    |order: usize| derivative(values.map(|value| value[function][order]), 0.01);
                assert!((slope - by_differences(0)).abs() < 1e-12);
                assert!((curvature - by_differences(1)).abs() < 1e-12);
            }
        }
    }
}

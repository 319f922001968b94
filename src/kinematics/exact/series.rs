//! (1 − cos φ)/φ² and (1 − sin φ/φ)/φ² with their derivatives by φ², by series, without a branch and without trigonometry.
//!
//! [theory: geometrically-exact.series]

use crate::math::{Arithmetic, Lanes};

/// Good to 1e-14 up to 1 rad from section to section, and to 1e-10 up to 2 rad.
const TERMS: usize = 8;

/// (−1)ⁿ / (2n + 2)!, and those of the derivatives.
const VERSINE: [[f64; TERMS]; 3] = with_derivatives(coefficients(2));

/// (−1)ⁿ / (2n + 3)!, and those of the derivatives.
const SINE_DEFICIT: [[f64; TERMS]; 3] = with_derivatives(coefficients(3));

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

/// With the coefficients of the first and of the second derivative.
const fn with_derivatives(value: [f64; TERMS]) -> [[f64; TERMS]; 3] {
    let slope = derivative_of(value);
    [value, slope, derivative_of(slope)]
}

/// Coefficients of the derivative.
const fn derivative_of(coefficients: [f64; TERMS]) -> [f64; TERMS] {
    let (mut derivative, mut n) = ([0.0; TERMS], 1);
    while n < TERMS {
        derivative[n - 1] = n as f64 * coefficients[n];
        n += 1;
    }
    derivative
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
    let powers = Powers::of(square);
    [powers.sum(&HALF_COSINE), powers.sum(&HALF_SINE)]
}

/// s, s² and s⁴.
#[derive(Clone, Copy, Debug)]
struct Powers<S: Arithmetic> {
    first: Lanes<S>,
    second: Lanes<S>,
    fourth: Lanes<S>,
}

impl<S: Arithmetic> Powers<S> {
    #[inline(always)]
    fn of(first: Lanes<S>) -> Self {
        let second = first * first;
        Powers { first, second, fourth: second * second }
    }

    /// c₀ + c₁s + …, in pairs and pairs of pairs: a shorter way from s to the sum.
    #[inline(always)]
    fn sum(&self, [c0, c1, c2, c3, c4, c5, c6, c7]: &[f64; TERMS]) -> Lanes<S> {
        let pair = |low: &f64, high: &f64| self.first * *high + self.first.splat(*low);
        let (low, high) =
            (pair(c0, c1) + self.second * pair(c2, c3), pair(c4, c5) + self.second * pair(c6, c7));
        low + self.fourth * high
    }
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
    /// b = (1 − cos φ)/φ² and c = (1 − sin φ/φ)/φ².
    #[inline(always)]
    pub fn both(square: Lanes<S>) -> [Self; 2] {
        let powers = Powers::of(square);
        [Series::sum(&powers, &VERSINE), Series::sum(&powers, &SINE_DEFICIT)]
    }

    #[inline(always)]
    fn sum(powers: &Powers<S>, coefficients: &[[f64; TERMS]; 3]) -> Self {
        let [value, slope, curvature] = coefficients;
        Series { value: powers.sum(value), slope: powers.sum(slope), curvature: powers.sum(curvature) }
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
            let [[versine, ..], [deficit, ..]] = Series::both(square).map(numbers);
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
            Series::both(square).map(numbers)
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

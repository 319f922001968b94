//! The weights of exponential integrators with a diagonal linear part.
//!
//! [theory: integration.method, integration.phi, integration.stages]
//!
//! S. Krogstad, "Generalized integrating factor methods for stiff PDEs", J. Comput. Phys. 203 (2005), whose last
//! stage is that of S. M. Cox, P. C. Matthews, J. Comput. Phys. 176 (2002): the linear part L is integrated exactly,
//! the rest with the weights of a fourth-order Runge–Kutta method; with L = 0 it is the classical one.

use std::ops::{Add, Div, Mul, Range, Sub};

use nalgebra::Complex;

use crate::math::zeros;
use crate::plant::{Diagonal, Spectrum};

/// The series of the φ are used up to this |z|; beyond, the closed form loses less.
const SERIES_RADIUS: f64 = 1.0;

/// Terms of the series: |z|²⁰/23! is below rounding.
const SERIES_TERMS: i32 = 20;

/// The weights of one step of given width: functions of hL.
#[derive(Clone, Debug)]
pub struct ExponentialWeights {
    /// h, s; zero when the weights have never been computed.
    pub width: f64,
    /// (h/2) φ₁(hL/2): to the middle of the step.
    pub half: Diagonal,
    /// h (½φ₁ − φ₂) at hL/2: of the first slope in the third stage.
    pub third_first: Diagonal,
    /// h φ₂(hL/2): of the second slope in the third stage.
    pub third_second: Diagonal,
    /// h (φ₁ − 2φ₂): of the first slope in the fourth stage.
    pub fourth_first: Diagonal,
    /// 2h φ₂: of the third slope in the fourth stage.
    pub fourth_third: Diagonal,
    /// h (φ₁ − 3φ₂ + 4φ₃): of the first slope.
    pub first: Diagonal,
    /// h (2φ₂ − 4φ₃): of the second and the third.
    pub middle: Diagonal,
    /// h (4φ₃ − φ₂): of the fourth.
    pub last: Diagonal,
}

impl ExponentialWeights {
    /// Room for weights of so many states, not yet computed.
    pub fn empty(states: usize) -> Self {
        let zeros = || zeros(states);
        ExponentialWeights {
            width: 0.0,
            half: zeros(),
            third_first: zeros(),
            third_second: zeros(),
            fourth_first: zeros(),
            fourth_third: zeros(),
            first: zeros(),
            middle: zeros(),
            last: zeros(),
        }
    }

    /// Computes the weights of a step of `width` seconds with the linear part L (1/s).
    pub fn compute(&mut self, spectrum: &Spectrum, linear: &[f64], width: f64) {
        self.width = width;
        for place in spectrum.real.iter().flat_map(Range::clone) {
            for (diagonal, weight) in self.diagonals().into_iter().zip(weights(linear[place], width)) {
                diagonal[place] = weight;
            }
        }
        for (re, im) in spectrum.complex.iter().flat_map(|(re, im)| re.clone().zip(im.clone())) {
            let weights = weights(Complex::new(linear[re], linear[im]), width);
            for (diagonal, weight) in self.diagonals().into_iter().zip(weights) {
                (diagonal[re], diagonal[im]) = (weight.re, weight.im);
            }
        }
    }

    /// In the order of [`weights`].
    fn diagonals(&mut self) -> [&mut Diagonal; 8] {
        let ExponentialWeights {
            half,
            third_first,
            third_second,
            fourth_first,
            fourth_third,
            first,
            middle,
            last,
            ..
        } = self;
        [half, third_first, third_second, fourth_first, fourth_third, first, middle, last]
    }
}

/// The weights of one state with the linear part l, in the order of their fields.
fn weights<T: ExponentialNumber>(l: T, h: f64) -> [T; 8] {
    let z = l * h;
    let [[half1, half2, _], [phi1, phi2, phi3]] = if z.is_small() {
        [phi_series(z * 0.5), phi_series(z)]
    } else {
        let half_exp = (z * 0.5).exp();
        [phi(z * 0.5, half_exp), phi(z, half_exp * half_exp)]
    };
    [
        half1 * (0.5 * h),
        (half1 * 0.5 - half2) * h,
        half2 * h,
        (phi1 - phi2 * 2.0) * h,
        phi2 * (2.0 * h),
        (phi1 - phi2 * 3.0 + phi3 * 4.0) * h,
        (phi2 * 2.0 - phi3 * 4.0) * h,
        (phi3 * 4.0 - phi2) * h,
    ]
}

/// A real or complex number with the platform-independent exponential function.
trait ExponentialNumber:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + Div<Output = Self>
{
    /// e^z.
    fn exp(self) -> Self;

    /// Whether the series of the φ are to be used.
    fn is_small(self) -> bool;
}

impl ExponentialNumber for f64 {
    fn exp(self) -> Self {
        libm::exp(self)
    }

    fn is_small(self) -> bool {
        self.abs() < SERIES_RADIUS
    }
}

impl ExponentialNumber for Complex<f64> {
    fn exp(self) -> Self {
        let (sin, cos) = libm::sincos(self.im);
        Complex::new(cos, sin) * libm::exp(self.re)
    }

    fn is_small(self) -> bool {
        self.norm_sqr() < SERIES_RADIUS * SERIES_RADIUS
    }
}

/// φ₁, φ₂, φ₃: φ_k(z) = Σ z^j / (j + k)!, from e^z by φ_k = (φ_{k−1} − 1/(k−1)!) / z [theory: integration.phi].
fn phi<T: ExponentialNumber>(z: T, exp: T) -> [T; 3] {
    let per_z = T::from(1.0) / z;
    let phi1 = (exp - T::from(1.0)) * per_z;
    let phi2 = (phi1 - T::from(1.0)) * per_z;
    [phi1, phi2, (phi2 - T::from(0.5)) * per_z]
}

/// The same near zero: φ₃ by its series, the others by φ_{k−1} = z φ_k + 1/(k−1)!.
fn phi_series<T: ExponentialNumber>(z: T) -> [T; 3] {
    let mut tail = T::from(1.0);
    for term in (1..SERIES_TERMS).rev() {
        tail = tail * z * (1.0 / f64::from(term + 3)) + T::from(1.0);
    }
    let phi3 = tail * (1.0 / 6.0);
    let phi2 = z * phi3 + T::from(0.5);
    [z * phi2 + T::from(1.0), phi2, phi3]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::StateLayout;
    use crate::strips::InflowLayout;

    #[test]
    fn phi_functions_meet_where_series_and_closed_form_meet() {
        for angle in [0.0, 1.0, 2.0, 3.0] {
            let z = Complex::new(libm::cos(angle), libm::sin(angle));
            for (a, b) in phi_series(z).into_iter().zip(phi(z, z.exp())) {
                assert!((a - b).norm() < 4e-15);
            }
        }
    }

    #[test]
    fn phi_functions_have_their_known_values() {
        // φ₁(1) = e − 1, φ₂(1) = e − 2, φ₃(1) = e − 5/2.
        let e = std::f64::consts::E;
        for (value, expected) in phi_series(1.0).into_iter().zip([e - 1.0, e - 2.0, e - 2.5]) {
            assert!((value - expected).abs() < 2e-15);
        }
        for (value, expected) in phi_series(0.0).into_iter().zip([1.0, 0.5, 1.0 / 6.0]) {
            assert!((value - expected).abs() < 1e-16);
        }
    }

    #[test]
    fn real_and_complex_weights_of_a_real_number_agree() {
        for l in [-3.0, -150.0, -2000.0] {
            for (real, complex) in weights(l, 0.01).into_iter().zip(weights(Complex::from(l), 0.01)) {
                assert!((real - complex.re).abs() < 1e-15 && complex.im == 0.0);
            }
        }
    }

    #[test]
    fn without_a_linear_part_the_weights_are_those_of_the_classical_method() {
        let layout = StateLayout::new(1, InflowLayout::new(1, 1, 1));
        let mut weights = ExponentialWeights::empty(layout.len());
        weights.compute(&Spectrum::new(&layout), &vec![0.0; layout.len()], 0.3);
        for (diagonal, expected) in [
            (&weights.half, 0.15),
            (&weights.third_first, 0.0),
            (&weights.third_second, 0.15),
            (&weights.fourth_first, 0.0),
            (&weights.fourth_third, 0.3),
            (&weights.first, 0.05),
            (&weights.middle, 0.1),
            (&weights.last, 0.05),
        ] {
            for (i, weight) in diagonal.iter().enumerate() {
                let imaginary = layout.coordinates().contains(&i) || layout.inflow_layout().im().contains(&i);
                let expected = if imaginary { 0.0 } else { expected };
                assert!((weight - expected).abs() < 1e-16, "{i}");
            }
        }
    }
}

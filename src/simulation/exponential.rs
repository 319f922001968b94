//! The functions of exponential integrators, and the inflow's diagonal linear part in them.
//!
//! S. M. Cox, P. C. Matthews, "Exponential time differencing for stiff systems", J. Comput. Phys. 176 (2002):
//! the stiff linear part L is integrated exactly, the rest with the weights of a fourth-order Runge–Kutta
//! method; with L = 0 it is the classical one.

use std::ops::Range;

use nalgebra::Complex;

/// Taylor series of φ₁ are used up to this |z|; beyond, the closed form loses less.
const SERIES_RADIUS: f64 = 1.0;

/// Terms of the series: |z|²⁰/23! is below rounding.
const SERIES_TERMS: i32 = 20;

/// Where the linear part acts in the state: real states, then real and imaginary parts of complex ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StiffStates {
    /// Real states.
    pub real: Range<usize>,
    /// Real parts.
    pub re: Range<usize>,
    /// Imaginary parts.
    pub im: Range<usize>,
}

/// A number for each real and each complex stiff state: a diagonal matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagonal {
    /// For the real states.
    pub real: Vec<f64>,
    /// Real parts, for the complex states.
    pub re: Vec<f64>,
    /// Imaginary parts, for the complex states.
    pub im: Vec<f64>,
}

impl Diagonal {
    /// Room for a diagonal on the given states.
    pub fn zeros(states: &StiffStates) -> Self {
        let zeros = |range: &Range<usize>| vec![0.0; range.len()];
        Diagonal { real: zeros(&states.real), re: zeros(&states.re), im: zeros(&states.im) }
    }

    /// Overwrites this diagonal with a function of another.
    fn set(&mut self, source: &Diagonal, function: impl Fn(Complex<f64>) -> Complex<f64>) {
        for (target, &value) in self.real.iter_mut().zip(&source.real) {
            *target = function(Complex::new(value, 0.0)).re;
        }
        let complex = self.re.iter_mut().zip(&mut self.im).zip(source.re.iter().zip(&source.im));
        for ((re, im), (&source_re, &source_im)) in complex {
            let value = function(Complex::new(source_re, source_im));
            (*re, *im) = (value.re, value.im);
        }
    }

    /// target += scale · D · vector, on the stiff states of both.
    pub fn add_product(&self, states: &StiffStates, scale: f64, vector: &[f64], target: &mut [f64]) {
        let real = vector[states.real.clone()].iter().zip(&mut target[states.real.clone()]);
        for (d, (x, y)) in self.real.iter().zip(real) {
            *y += scale * (d * x);
        }
        let (re, im) = (&vector[states.re.clone()], &vector[states.im.clone()]);
        let target_re = &mut target[states.re.clone()];
        for (y, ((d_re, d_im), (x_re, x_im))) in
            target_re.iter_mut().zip(self.re.iter().zip(&self.im).zip(re.iter().zip(im)))
        {
            *y += scale * (d_re * x_re - d_im * x_im);
        }
        let target_im = &mut target[states.im.clone()];
        for (y, ((d_re, d_im), (x_re, x_im))) in
            target_im.iter_mut().zip(self.re.iter().zip(&self.im).zip(re.iter().zip(im)))
        {
            *y += scale * (d_im * x_re + d_re * x_im);
        }
    }
}

/// The weights of one step of given width: functions of hL.
#[derive(Clone, Debug)]
pub struct ExponentialWeights {
    /// h, s; zero when the weights have never been computed.
    pub width: f64,
    /// e^{hL/2}.
    pub half_decay: Diagonal,
    /// e^{hL}.
    pub decay: Diagonal,
    /// (h/2) φ₁(hL/2).
    pub half: Diagonal,
    /// h (φ₁ − 3φ₂ + 4φ₃): of the first stage.
    pub first: Diagonal,
    /// h (2φ₂ − 4φ₃): of the second and the third.
    pub middle: Diagonal,
    /// h (4φ₃ − φ₂): of the fourth.
    pub last: Diagonal,
}

impl ExponentialWeights {
    /// Room for weights, not yet computed.
    pub fn empty(states: &StiffStates) -> Self {
        let zeros = || Diagonal::zeros(states);
        ExponentialWeights {
            width: 0.0,
            half_decay: zeros(),
            decay: zeros(),
            half: zeros(),
            first: zeros(),
            middle: zeros(),
            last: zeros(),
        }
    }

    /// Computes the weights of a step of `width` seconds with the linear part L (1/s).
    pub fn compute(&mut self, linear: &Diagonal, width: f64) {
        self.width = width;
        let (h, half) = (width, 0.5 * width);
        self.half_decay.set(linear, |l| exp(l * half));
        self.decay.set(linear, |l| exp(l * h));
        self.half.set(linear, |l| phi(l * half)[0] * half);
        self.first.set(linear, |l| {
            let [phi1, phi2, phi3] = phi(l * h);
            (phi1 - phi2 * 3.0 + phi3 * 4.0) * h
        });
        self.middle.set(linear, |l| {
            let [_, phi2, phi3] = phi(l * h);
            (phi2 * 2.0 - phi3 * 4.0) * h
        });
        self.last.set(linear, |l| {
            let [_, phi2, phi3] = phi(l * h);
            (phi3 * 4.0 - phi2) * h
        });
    }
}

/// φ₁, φ₂, φ₃: φ_k(z) = Σ z^j / (j + k)!.
fn phi(z: Complex<f64>) -> [Complex<f64>; 3] {
    if z.norm_sqr() < SERIES_RADIUS * SERIES_RADIUS {
        // φ₃ by its series, the others by φ_{k−1} = z φ_k + 1/(k−1)!.
        let series = (1..SERIES_TERMS)
            .rev()
            .fold(Complex::new(1.0, 0.0), |tail, term| tail * z / f64::from(term + 3) + 1.0);
        let phi3 = series / 6.0;
        let phi2 = z * phi3 + 0.5;
        return [z * phi2 + 1.0, phi2, phi3];
    }
    let phi1 = (exp(z) - 1.0) / z;
    let phi2 = (phi1 - 1.0) / z;
    [phi1, phi2, (phi2 - 0.5) / z]
}

/// e^z with the platform-independent elementary functions.
fn exp(z: Complex<f64>) -> Complex<f64> {
    let (sin, cos) = libm::sincos(z.im);
    Complex::new(cos, sin) * libm::exp(z.re)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phi_functions_meet_where_series_and_closed_form_meet() {
        for angle in [0.0, 1.0, 2.0, 3.0] {
            let direction = Complex::new(libm::cos(angle), libm::sin(angle));
            let (inside, outside) = (phi(direction * 0.999_999_999), phi(direction * 1.000_000_001));
            for (a, b) in inside.into_iter().zip(outside) {
                assert!((a - b).norm() < 1e-8);
            }
        }
    }

    #[test]
    fn phi_functions_have_their_known_values() {
        // φ₁(1) = e − 1, φ₂(1) = e − 2, φ₃(1) = e − 5/2.
        let e = std::f64::consts::E;
        for (value, expected) in
            phi(Complex::new(1.0 - 1e-16, 0.0)).into_iter().zip([e - 1.0, e - 2.0, e - 2.5])
        {
            assert!((value.re - expected).abs() < 2e-15 && value.im == 0.0);
        }
        for (value, expected) in phi(Complex::new(0.0, 0.0)).into_iter().zip([1.0, 0.5, 1.0 / 6.0]) {
            assert!((value.re - expected).abs() < 1e-16);
        }
    }

    #[test]
    fn without_stiffness_the_weights_are_those_of_the_classical_method() {
        let states = StiffStates { real: 0..1, re: 1..2, im: 2..3 };
        let mut weights = ExponentialWeights::empty(&states);
        weights.compute(&Diagonal::zeros(&states), 0.3);
        for (diagonal, expected) in [
            (&weights.decay, 1.0),
            (&weights.half_decay, 1.0),
            (&weights.half, 0.15),
            (&weights.first, 0.05),
            (&weights.middle, 0.1),
            (&weights.last, 0.05),
        ] {
            assert!((diagonal.real[0] - expected).abs() < 1e-16);
            assert!((diagonal.re[0] - expected).abs() < 1e-16 && diagonal.im[0] == 0.0);
        }
    }
}

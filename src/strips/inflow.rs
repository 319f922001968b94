//! Peters' finite-state inflow in its eigenbasis.
//!
//! [theory: inflow.equations, inflow.eigenbasis, inflow.state; thesis eq. 4.1]
//!
//! A λ̇ + (U/b) λ = c ẇ₃ with w₃ = w + (b/2 − d)Ω and λ₀ = ½ bᵀλ is, in the eigenbasis of A⁻¹ and with each
//! eigenvector scaled so that ẇ₃ enters with unit gain, a sum of independent lags: with η = η̃ + w₃,
//!
//! ```text
//! η̃' = −(U/b) μ (η̃ + w₃),      λ₀ = Σ weight · (η̃ + w₃).
//! ```
//!
//! The state is η̃: no acceleration on the right-hand side, and a jump of the flow makes no impulse.
//! Complex eigenvalues come in pairs; the real and the imaginary part of one of them are stored.

use nalgebra::{Complex, DMatrix, DVector, Schur};

use crate::aircraft::MOST_INFLOW_STATES;
use crate::math::{Arithmetic, Eight, LANES, Lanes, Window};

/// A real eigenvalue.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lag {
    /// μ: decay per semichord travelled.
    rate: f64,
    /// Its share of λ₀.
    weight: f64,
}

/// A pair of complex eigenvalues μ = decay ± i·frequency [theory: inflow.complex].
#[derive(Clone, Copy, Debug, PartialEq)]
struct LagPair {
    decay: f64,
    frequency: f64,
    /// λ₀ has twice the real part of weight·η.
    weight: Complex<f64>,
}

/// The inflow of a strip with N states.
///
/// ```
/// use flexible_aircraft::strips::PetersInflow;
///
/// let inflow = PetersInflow::new(6);
/// assert_eq!(inflow.real_lags() + 2 * inflow.lag_pairs(), 6);
/// assert_eq!(PetersInflow::new(0).real_lags(), 0); // steady aerodynamics
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PetersInflow {
    lags: Vec<Lag>,
    pairs: Vec<LagPair>,
}

impl PetersInflow {
    /// Largest N for which the eigenbasis is well conditioned.
    pub const MAX_STATES: usize = MOST_INFLOW_STATES;

    /// The inflow with `states` states, at most [`MAX_STATES`](Self::MAX_STATES); 0 is steady aerodynamics.
    pub fn new(states: usize) -> Self {
        let states = states.min(Self::MAX_STATES);
        let mut inflow = PetersInflow { lags: Vec::new(), pairs: Vec::new() };
        if states == 0 {
            return inflow;
        }
        let (a, b, c) = peters_matrices(states);
        // PROOF: A is regular for every N ≤ 8 (the tests construct each); the solver only fails on a singular A.
        let a_inverse = a.try_inverse().expect("Peters' A is regular");
        let forcing = (&a_inverse * c).map(Complex::from);
        let readout = (b * 0.5).map(Complex::from);
        for eigenvalue in Schur::new(a_inverse.clone()).complex_eigenvalues().iter() {
            if eigenvalue.im < -1e-9 {
                continue;
            }
            let right = null_vector(&a_inverse, *eigenvalue);
            let left = null_vector(&a_inverse.transpose(), *eigenvalue);
            let weight = readout.dot(&right) * left.dot(&forcing) / left.dot(&right);
            if eigenvalue.im > 1e-9 {
                inflow.pairs.push(LagPair { decay: eigenvalue.re, frequency: eigenvalue.im, weight });
            } else {
                inflow.lags.push(Lag { rate: eigenvalue.re, weight: weight.re });
            }
        }
        inflow
    }

    /// Number of real states of a strip.
    pub fn real_lags(&self) -> usize {
        self.lags.len()
    }

    /// Number of complex states of a strip, each of which stands for a conjugate pair.
    pub fn lag_pairs(&self) -> usize {
        self.pairs.len()
    }

    /// λ₀, m/s, of strips from their states and w₃ = w + (b/2 − d)Ω [theory: inflow.state, inflow.complex].
    #[inline(always)]
    pub fn induced_velocity<S: Arithmetic>(
        &self,
        window: Window<S>,
        states: &InflowStates<&[f64]>,
        w3: Lanes<S>,
    ) -> Lanes<S> {
        let mut induced = window.splat(0.0);
        for (lag, state) in self.lags.iter().zip(states.real.chunks_exact(LANES)) {
            induced += (window.load_slice(state) + w3) * lag.weight;
        }
        let complex = states.re.chunks_exact(LANES).zip(states.im.chunks_exact(LANES));
        for (pair, (re, im)) in self.pairs.iter().zip(complex) {
            let (re, im) = (window.load_slice(re) + w3, window.load_slice(im));
            induced += re * (2.0 * pair.weight.re) - im * (2.0 * pair.weight.im);
        }
        induced
    }

    /// Rates of the states of strips, m/s². Air that comes from behind, as it may where a wing swings in still air, carries
    /// no wake away [theory: inflow.state].
    #[inline(always)]
    pub fn write_rates<S: Arithmetic>(
        &self,
        window: Window<S>,
        states: &InflowStates<&[f64]>,
        wake: &WakeFlow<S>,
        rates: &mut InflowStates<&mut [f64]>,
    ) {
        let WakeFlow { w3, passing } = *wake;
        let passing = (passing + passing.abs()) * 0.5;
        let real = states.real.chunks_exact(LANES).zip(rates.real.chunks_exact_mut(LANES));
        for (lag, (state, rate)) in self.lags.iter().zip(real) {
            window.store_slice(rate, -(passing * lag.rate * (window.load_slice(state) + w3)));
        }
        let complex = states.re.chunks_exact(LANES).zip(states.im.chunks_exact(LANES));
        let complex_rates = rates.re.chunks_exact_mut(LANES).zip(rates.im.chunks_exact_mut(LANES));
        for ((pair, (re, im)), (re_rate, im_rate)) in self.pairs.iter().zip(complex).zip(complex_rates) {
            let (re, im) = (window.load_slice(re) + w3, window.load_slice(im));
            let (decay, frequency) = (pair.decay, pair.frequency);
            window.store_slice(re_rate, -(passing * (re * decay - im * frequency)));
            window.store_slice(im_rate, -(passing * (re * frequency + im * decay)));
        }
    }

    /// The coefficients L of η̃' = Lη̃ + … of a group of strips at a constant U/b, 1/s.
    ///
    /// [theory: integration.linear-part]
    pub fn linear_part(&self, passing: &Eight, linear: &mut InflowStates<&mut [f64]>) {
        let write = |rate: f64, coefficients: &mut [f64]| {
            for (coefficient, passing) in coefficients.iter_mut().zip(passing.0) {
                *coefficient = -passing * rate;
            }
        };
        for (lag, coefficients) in self.lags.iter().zip(linear.real.chunks_exact_mut(LANES)) {
            write(lag.rate, coefficients);
        }
        let complex = linear.re.chunks_exact_mut(LANES).zip(linear.im.chunks_exact_mut(LANES));
        for (pair, (re, im)) in self.pairs.iter().zip(complex) {
            write(pair.decay, re);
            write(pair.frequency, im);
        }
    }

    /// Sets the states of strips to a wake long at rest: λ = 0 [theory: inflow.state].
    pub fn settle<S: Arithmetic>(
        &self,
        window: Window<S>,
        w3: Lanes<S>,
        states: &mut InflowStates<&mut [f64]>,
    ) {
        for state in states.real.chunks_exact_mut(LANES).chain(states.re.chunks_exact_mut(LANES)) {
            window.store_slice(state, -w3);
        }
        for state in states.im.chunks_exact_mut(LANES) {
            window.store_slice(state, window.splat(0.0));
        }
    }
}

/// The flow that drives the wakes of strips.
#[derive(Clone, Copy, Debug)]
pub struct WakeFlow<S: Arithmetic> {
    /// w₃, m/s.
    pub w3: Lanes<S>,
    /// U/b, 1/s.
    pub passing: Lanes<S>,
}

/// The inflow states of a group of strips, or something that stands for each of them.
#[derive(Clone, Debug)]
pub struct InflowStates<T> {
    /// Real states, lane by lane.
    pub real: T,
    /// Real parts of the complex states.
    pub re: T,
    /// Imaginary parts of the complex states.
    pub im: T,
}

/// A, b, c for N states [theory: inflow.matrices; thesis §4.1].
fn peters_matrices(states: usize) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
    let factorial = |k: usize| (1..=k).map(|i| i as f64).product::<f64>();
    let d_matrix = DMatrix::from_fn(states, states, |row, column| {
        let n = (row + 1) as f64;
        if row == column + 1 {
            0.5 / n
        } else if row + 1 == column {
            -0.5 / n
        } else {
            0.0
        }
    });
    let b = DVector::from_fn(states, |index, _| {
        let n = index + 1;
        let sign = if n % 2 == 1 { 1.0 } else { -1.0 };
        if n == states {
            sign
        } else {
            sign * factorial(states + n - 1) / (factorial(states - n - 1) * factorial(n) * factorial(n))
        }
    });
    let c = DVector::from_fn(states, |index, _| 2.0 / (index + 1) as f64);
    let d = DVector::from_fn(states, |index, _| if index == 0 { 0.5 } else { 0.0 });
    let a = d_matrix + &d * b.transpose() + &c * d.transpose() + &c * b.transpose() * 0.5;
    (a, b, c)
}

/// The vector that (matrix − eigenvalue·1) maps to zero.
fn null_vector(matrix: &DMatrix<f64>, eigenvalue: Complex<f64>) -> DVector<Complex<f64>> {
    let size = matrix.nrows();
    let shifted = matrix.map(Complex::from) - DMatrix::identity(size, size) * eigenvalue;
    let svd = shifted.svd(false, true);
    // PROOF: `svd(_, true)` computes Vᵀ.
    let v_t = svd.v_t.expect("right singular vectors were asked for");
    v_t.row(svd.singular_values.imin()).adjoint()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lift deficiency C(k) = 1 − λ₀/w₃ for harmonic w₃ [theory: inflow.lift-deficiency].
    fn lift_deficiency(inflow: &PetersInflow, k: f64) -> Complex<f64> {
        let s = Complex::new(0.0, k);
        let lags = inflow.lags.iter().map(|lag| s / (s + lag.rate) * lag.weight).sum::<Complex<f64>>();
        let pairs = inflow
            .pairs
            .iter()
            .map(|pair| {
                let mu = Complex::new(pair.decay, pair.frequency);
                s * pair.weight / (s + mu) + s * pair.weight.conj() / (s + mu.conj())
            })
            .sum::<Complex<f64>>();
        Complex::from(1.0) - lags - pairs
    }

    /// C(k) straight from A, b, c.
    fn lift_deficiency_of_matrices(states: usize, k: f64) -> Complex<f64> {
        let (a, b, c) = peters_matrices(states);
        let s = Complex::new(0.0, k);
        let system = a.map(|x| s * x) + DMatrix::identity(states, states);
        let lambda = system.lu().solve(&c.map(|x| s * x)).unwrap();
        Complex::from(1.0) - lambda.dot(&b.map(Complex::from)) * 0.5
    }

    #[test]
    fn the_eigenbasis_is_the_same_filter_as_the_matrices_for_every_n() {
        for states in 0..=PetersInflow::MAX_STATES {
            let inflow = PetersInflow::new(states);
            assert_eq!(inflow.real_lags() + 2 * inflow.lag_pairs(), states);
            for k in [0.01, 0.1, 0.5, 2.0] {
                let expected =
                    if states == 0 { Complex::from(1.0) } else { lift_deficiency_of_matrices(states, k) };
                let error = (lift_deficiency(&inflow, k) - expected).norm();
                assert!(error < 1e-9, "N = {states}, k = {k}: {error:e}");
            }
        }
    }

    #[test]
    fn five_states_have_the_lift_deficiency_of_the_theory() {
        // [theory: inflow.lift-deficiency]: C(0.1) = 0.7987 − 0.1872i, C(0.3) = 0.6594 − 0.1577i for N = 5.
        let inflow = PetersInflow::new(5);
        for (k, expected) in [(0.1, Complex::new(0.7987, -0.1872)), (0.3, Complex::new(0.6594, -0.1577))] {
            assert!((lift_deficiency(&inflow, k) - expected).norm() < 1e-4);
        }
    }

    #[test]
    fn every_lag_decays() {
        for states in 1..=PetersInflow::MAX_STATES {
            let inflow = PetersInflow::new(states);
            assert!(
                inflow.lags.iter().all(|lag| lag.rate > 0.0)
                    && inflow.pairs.iter().all(|pair| pair.decay > 0.0)
            );
        }
    }

    #[test]
    fn a_settled_wake_induces_nothing_and_stays_settled() {
        let inflow = PetersInflow::new(5);
        let window = Window::all(pulp::Scalar::new()).next().unwrap();
        let w3 = window.splat(3.5);
        let wake = WakeFlow { w3, passing: window.splat(100.0) };
        let (mut states, mut rates) = ([[0.0; 3 * LANES]; 3], [[1.0; 3 * LANES]; 3]);
        let [real, re, im] = &mut states;
        inflow.settle(window, w3, &mut InflowStates { real, re: &mut re[..LANES], im: &mut im[..LANES] });
        let [real, re, im] = &states;
        let states = InflowStates { real: real.as_slice(), re: &re[..LANES], im: &im[..LANES] };
        let [real_rates, re_rates, im_rates] = &mut rates;
        let mut slopes = InflowStates {
            real: real_rates.as_mut_slice(),
            re: &mut re_rates[..LANES],
            im: &mut im_rates[..LANES],
        };
        inflow.write_rates(window, &states, &wake, &mut slopes);
        assert_eq!(inflow.induced_velocity(window, &states, w3).numbers(), [0.0]);
        let first = |rates: &[f64]| rates.chunks(LANES).map(|lanes| lanes[0]).collect::<Vec<_>>();
        for rates in [&*slopes.real, &*slopes.re, &*slopes.im] {
            assert!(first(rates).iter().all(|&rate| rate == 0.0));
        }
    }
}

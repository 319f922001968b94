//! Responses of a linear model: to harmonic inputs, and to steps.

use flexible_aircraft::{LinearModel, LinearName};
use nalgebra::{Complex, DMatrix, DVector};

/// The place of a name.
pub fn place(names: &[LinearName], name: &str) -> usize {
    names.iter().position(|other| other.name == name).unwrap_or_else(|| panic!("no {name}"))
}

/// Amplitudes of all outputs, a row each, under each input at an amplitude of 1 and ω, rad/s [theory: linearisation.wind-rates].
pub fn frequency_response(model: &LinearModel, frequency: f64) -> DMatrix<Complex<f64>> {
    let (rate, n) = (Complex::new(0.0, frequency), model.states.len());
    let acting = |direct: &DMatrix<f64>, by_rate: &DMatrix<f64>| {
        direct.map(Complex::from) + by_rate.map(Complex::from) * rate
    };
    let resolvent = DMatrix::<Complex<f64>>::identity(n, n) * rate - model.a.map(Complex::from);
    let states = resolvent.lu().solve(&acting(&model.b, &model.bd)).unwrap();
    model.c.map(Complex::from) * states + acting(&model.d, &model.dd)
}

/// Departures of all outputs at 0, `step`, 2 `step`, … (s) under an input that jumps at 0: exact but for rounding.
pub fn step_response(
    model: &LinearModel,
    input: &str,
    jump: f64,
    step: f64,
    steps: usize,
) -> Vec<DVector<f64>> {
    let (column, n) = (place(&model.inputs, input), model.states.len());
    // The input as a further state that stays.
    let mut with_input = DMatrix::zeros(n + 1, n + 1);
    with_input.view_mut((0, 0), (n, n)).copy_from(&model.a);
    with_input.view_mut((0, n), (n, 1)).copy_from(&model.b.column(column));
    let over_a_step = exponential(&(with_input * step));
    let mut state = DVector::zeros(n + 1);
    state[n] = jump;
    let mut history = Vec::with_capacity(steps + 1);
    for _ in 0..=steps {
        history.push(&model.c * state.rows(0, n) + model.d.column(column) * jump);
        state = &over_a_step * state;
    }
    history
}

/// e^M by its series for a part of M, then squared.
fn exponential(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let size = matrix.column_iter().map(|column| column.abs().sum()).fold(0.0, f64::max);
    let squarings = (libm::log2(size.max(1.0)).ceil() + 1.0) as i32;
    let part = matrix * libm::exp2(-f64::from(squarings));
    let n = matrix.nrows();
    let mut sum = DMatrix::identity(n, n);
    // From the last term on: 0.5^16/16! is below rounding.
    for term in (1..=16).rev() {
        sum = DMatrix::identity(n, n) + &part * sum / f64::from(term);
    }
    for _ in 0..squarings {
        sum = &sum * &sum;
    }
    sum
}

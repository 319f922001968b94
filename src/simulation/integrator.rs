//! Fourth-order exponential Runge–Kutta steps with error control (Cox–Matthews ETDRK4).
//!
//! The inflow decays hundreds of times a second; its linear part is integrated exactly, so that the step is
//! bound by the structure and the flight alone. All other states see the classical Runge–Kutta method. A
//! cell of time is flown in 1, 2, 4 … equal sub-steps. The estimate h/6 (f(y₁) − k₄), the difference to an
//! embedded third-order solution, costs nothing, since f(y₁) begins the next sub-step.

use crate::dynamics::StateLayout;

use super::exponential::{Diagonal, ExponentialWeights, StiffStates};

/// Most sub-steps of a cell: a jet a million times stiffer takes 256, its 26 modes 1024.
pub const MAX_SUBSTEPS: u32 = 4096;

/// Below this error (of 1 allowed) the next cell tries half as many sub-steps; a halving multiplies the
/// estimate by at most 2⁴.
const COARSEN: f64 = 1.0 / 32.0;

/// How many step widths have their weights kept: the widths of full and of cut cells recur.
const KEPT_WEIGHTS: usize = 8;

/// How large an error of each group of states is in proportion to the tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorScale {
    /// Relative tolerance.
    pub tolerance: f64,
    /// Smallest magnitude to which the tolerance is relative, in the order of [`StateLayout::groups`].
    pub floors: [f64; 7],
}

/// The integrator of one flight: its scratch memory and the weights of recent step widths.
#[derive(Clone, Debug)]
pub struct Integrator {
    layout: StateLayout,
    scale: ErrorScale,
    stiff: StiffStates,
    linear: Diagonal,
    weights: Vec<ExponentialWeights>,
    /// Which weights are overwritten next.
    oldest: usize,
    slopes: [Vec<f64>; 4],
    stage: Vec<f64>,
    /// The second stage, which the fourth is built on.
    first_half: Vec<f64>,
    /// State at the beginning of the cell.
    start: Vec<f64>,
}

/// How a cell went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CellEnd {
    /// Within tolerance; the number of sub-steps to try in the next cell.
    Accepted {
        /// Sub-steps for the next cell.
        next: u32,
    },
    /// Not within tolerance even with the most sub-steps.
    Failed,
}

impl Integrator {
    /// For states of the given layout, with no linear part yet.
    pub fn new(layout: &StateLayout, scale: ErrorScale) -> Self {
        let zeros = || vec![0.0; layout.len()];
        let stiff =
            StiffStates { real: layout.inflow_real(), re: layout.inflow_re(), im: layout.inflow_im() };
        Integrator {
            layout: *layout,
            scale,
            linear: Diagonal::zeros(&stiff),
            weights: vec![ExponentialWeights::empty(&stiff); KEPT_WEIGHTS],
            oldest: 0,
            stiff,
            slopes: [zeros(), zeros(), zeros(), zeros()],
            stage: zeros(),
            first_half: zeros(),
            start: zeros(),
        }
    }

    /// The relative tolerance.
    pub fn tolerance(&self) -> f64 {
        self.scale.tolerance
    }

    /// Has `write` write the linear part (1/s) into a vector of the state's layout.
    pub fn set_linear_part(&mut self, write: impl FnOnce(&mut [f64])) {
        write(&mut self.stage);
        self.linear.real.copy_from_slice(&self.stage[self.stiff.real.clone()]);
        self.linear.re.copy_from_slice(&self.stage[self.stiff.re.clone()]);
        self.linear.im.copy_from_slice(&self.stage[self.stiff.im.clone()]);
        for weights in &mut self.weights {
            weights.width = 0.0;
        }
    }

    /// Flies `state` from `begin` to `end` (s) in at least `substeps` sub-steps. `slope` holds f at the
    /// beginning and is left with f at the end; `rates(t, y, f)` evaluates f.
    pub fn fly_cell(
        &mut self,
        (begin, end): (f64, f64),
        substeps: u32,
        state: &mut [f64],
        slope: &mut [f64],
        mut rates: impl FnMut(f64, &[f64], &mut [f64]),
    ) -> CellEnd {
        self.start.copy_from_slice(state);
        let mut count = substeps;
        loop {
            let step = (end - begin) / f64::from(count);
            let weights = self.prepare_weights(step);
            let mut error = 0.0_f64;
            for index in 0..count {
                let time = begin + f64::from(index) * step;
                let next = if index + 1 == count { end } else { begin + f64::from(index + 1) * step };
                self.substep((time, next), weights, state, slope, &mut rates);
                error = nan_max(error, self.error(weights, step, state, slope));
                if error.is_nan() || error > 1.0 {
                    break;
                }
            }
            if error <= 1.0 {
                let next = if error < COARSEN { (count / 2).max(1) } else { count };
                return CellEnd::Accepted { next };
            }
            if count >= MAX_SUBSTEPS {
                return CellEnd::Failed;
            }
            count *= 2;
            state.copy_from_slice(&self.start);
            rates(begin, state, slope);
        }
    }

    /// Finds or computes the weights of a step width; returns their place.
    fn prepare_weights(&mut self, step: f64) -> usize {
        if let Some(place) = self.weights.iter().position(|weights| weights.width == step) {
            return place;
        }
        let place = self.oldest;
        self.oldest = (place + 1) % KEPT_WEIGHTS;
        self.weights[place].compute(&self.linear, step);
        place
    }

    /// One step. The stages' slopes keep their stiff parts without the linear part: k − Ly.
    fn substep(
        &mut self,
        (time, next): (f64, f64),
        weights: usize,
        state: &mut [f64],
        slope: &mut [f64],
        rates: &mut impl FnMut(f64, &[f64], &mut [f64]),
    ) {
        let Integrator { stiff, linear, slopes: [k1, k2, k3, k4], stage, first_half, .. } = self;
        let w = &self.weights[weights];
        let plain = 0..stiff.real.start;
        let (step, middle) = (next - time, 0.5 * (time + next));

        k1.copy_from_slice(slope);
        linear.add_product(stiff, -1.0, state, k1);
        offset(&mut first_half[plain.clone()], state, 0.5 * step, k1);
        combine(stiff, first_half, &[(&w.half_decay, state, 1.0), (&w.half, k1, 1.0)]);
        rates(middle, first_half, k2);
        linear.add_product(stiff, -1.0, first_half, k2);

        offset(&mut stage[plain.clone()], state, 0.5 * step, k2);
        combine(stiff, stage, &[(&w.half_decay, state, 1.0), (&w.half, k2, 1.0)]);
        rates(middle, stage, k3);
        linear.add_product(stiff, -1.0, stage, k3);

        offset(&mut stage[plain.clone()], state, step, k3);
        combine(stiff, stage, &[(&w.half_decay, first_half, 1.0), (&w.half, k3, 2.0), (&w.half, k1, -1.0)]);
        rates(next, stage, k4);
        linear.add_product(stiff, -1.0, stage, k4);

        stage.copy_from_slice(state);
        for (i, y) in state[plain].iter_mut().enumerate() {
            *y += step / 6.0 * ((k1[i] + k4[i]) + 2.0 * (k2[i] + k3[i]));
        }
        combine(
            stiff,
            state,
            &[
                (&w.decay, stage, 1.0),
                (&w.first, k1, 1.0),
                (&w.middle, k2, 1.0),
                (&w.middle, k3, 1.0),
                (&w.last, k4, 1.0),
            ],
        );
        normalise(&mut state[self.layout.attitude()]);
        rates(next, state, slope);
    }

    /// The estimated error of the last step in units of the allowed one; NaN when it is not finite.
    fn error(&mut self, weights: usize, step: f64, state: &[f64], slope: &[f64]) -> f64 {
        let Integrator { stiff, linear, slopes: [.., k4], stage, .. } = self;
        for (difference, (slope, k4)) in stage.iter_mut().zip(slope.iter().zip(&*k4)) {
            *difference = step / 6.0 * (slope - k4);
        }
        let mut remainder = std::mem::take(k4);
        for (k4, slope) in remainder.iter_mut().zip(slope) {
            *k4 = slope - *k4;
        }
        linear.add_product(stiff, -1.0, state, &mut remainder);
        combine(stiff, stage, &[(&self.weights[weights].last, &remainder, 1.0)]);
        *k4 = remainder;

        let mut worst = 0.0;
        for (group, floor) in self.layout.groups().into_iter().zip(self.scale.floors) {
            let size = largest(&state[group.clone()], floor);
            worst = nan_max(worst, largest(&self.stage[group], 0.0) / (self.scale.tolerance * size));
        }
        worst
    }
}

/// The stiff part of target = Σ scale · D · vector.
fn combine(states: &StiffStates, target: &mut [f64], terms: &[(&Diagonal, &[f64], f64)]) {
    target[states.real.start..states.im.end].fill(0.0);
    for (diagonal, vector, scale) in terms {
        diagonal.add_product(states, *scale, vector, target);
    }
}

/// target = state + step · slope.
fn offset(target: &mut [f64], state: &[f64], step: f64, slope: &[f64]) {
    for ((target, y), slope) in target.iter_mut().zip(state).zip(slope) {
        *target = y + step * slope;
    }
}

fn normalise(quaternion: &mut [f64]) {
    let norm = libm::sqrt(quaternion.iter().map(|x| x * x).sum());
    for component in quaternion {
        *component /= norm;
    }
}

/// Largest magnitude, at least `floor`; NaN when any value is.
fn largest(values: &[f64], floor: f64) -> f64 {
    values.iter().fold(floor, |largest, value| nan_max(largest, value.abs()))
}

/// The larger of two numbers, NaN when either is.
fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of a stiff lag y' = −800 (y − cos ωt) beside an oscillator x'' = −ω²x.
    fn fly(frequency: f64, tolerance: f64, width: f64, cells: usize) -> ([f64; 2], u32) {
        let layout = StateLayout::new(0, 1, 1, 0);
        let mut integrator = Integrator::new(&layout, ErrorScale { tolerance, floors: [1.0; 7] });
        let decay = -800.0;
        integrator.set_linear_part(|linear| linear[layout.inflow_real()].fill(decay));
        let lag = layout.inflow_real().start;
        let mut rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            rates.fill(0.0);
            rates[0] = state[1];
            rates[1] = -frequency * frequency * state[0];
            rates[lag] = decay * (state[lag] - libm::cos(frequency * time));
        };
        let (mut state, mut slope) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
        (state[0], state[3]) = (1.0, 1.0);
        let forced = |time: f64| {
            let (sin, cos) = libm::sincos(frequency * time);
            decay * (decay * cos - frequency * sin) / (decay * decay + frequency * frequency)
        };
        state[lag] = forced(0.0);
        rates(0.0, &state, &mut slope);
        let mut substeps = 1;
        for cell in 0..cells {
            let times = (cell as f64 * width, (cell + 1) as f64 * width);
            match integrator.fly_cell(times, substeps, &mut state, &mut slope, &mut rates) {
                CellEnd::Accepted { next } => substeps = next,
                CellEnd::Failed => panic!("failed"),
            }
        }
        let end = cells as f64 * width;
        let oscillator = libm::cos(frequency * end);
        ([(state[0] - oscillator).abs(), (state[lag] - forced(end)).abs()], substeps)
    }

    #[test]
    fn the_error_follows_the_tolerance() {
        let errors = [1e-4, 1e-6, 1e-8].map(|tolerance| fly(150.0, tolerance, 5e-3, 20).0[0]);
        assert!(errors[0] < 1e-2 && errors[1] < 1e-4 && errors[2] < 1e-6, "{errors:?}");
        assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    }

    #[test]
    fn a_stiff_lag_does_not_bound_the_step() {
        let ([oscillator, lag], substeps) = fly(1.0, 1e-6, 10e-3, 100);
        assert_eq!(substeps, 1);
        assert!(oscillator < 1e-9 && lag < 1e-7, "{oscillator:e} {lag:e}");
    }

    #[test]
    fn the_method_is_of_fourth_order() {
        let [coarse, fine] = [10e-3, 5e-3].map(|width| fly(10.0, 1e-2, width, (1.0 / width) as usize).0[0]);
        let order = libm::log2(coarse / fine);
        assert!((3.8..4.2).contains(&order), "{order}");
    }

    #[test]
    fn a_state_that_explodes_is_reported() {
        let layout = StateLayout::new(0, 0, 0, 0);
        let mut integrator = Integrator::new(&layout, ErrorScale { tolerance: 1e-6, floors: [1.0; 7] });
        let (mut state, mut slope) = (vec![1.0; layout.len()], vec![f64::NAN; layout.len()]);
        let end = integrator.fly_cell((0.0, 1e-3), 1, &mut state, &mut slope, |_, _, f| f.fill(f64::NAN));
        assert_eq!(end, CellEnd::Failed);
    }
}

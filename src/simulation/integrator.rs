//! Classical Runge–Kutta steps on an absolute time grid, with error control inside each cell.
//!
//! The grid makes one step of 10 ms and ten of 1 ms the same computation. A cell is flown in 1, 2, 4 …
//! equal sub-steps; the estimate h/6 (f(y₁) − k₄) is the difference to an embedded third-order solution and
//! costs nothing, since f(y₁) begins the next sub-step.

use crate::dynamics::StateLayout;

/// Width of a grid cell, s.
pub const CELL: f64 = 1e-3;

/// Most sub-steps of a cell.
pub const MAX_SUBSTEPS: u32 = 64;

/// Below this error (of 1 allowed) the next cell tries half as many sub-steps; a halving multiplies the
/// estimate by at most 2⁴.
const COARSEN: f64 = 1.0 / 32.0;

/// How large an error of each group of states is in proportion to the tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorScale {
    /// Relative tolerance.
    pub tolerance: f64,
    /// Smallest magnitude to which the tolerance is relative, in the order of [`StateLayout::groups`].
    pub floors: [f64; 7],
}

/// Scratch memory of the Runge–Kutta steps.
#[derive(Clone, Debug)]
pub struct Stages {
    slopes: [Vec<f64>; 4],
    stage: Vec<f64>,
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

impl Stages {
    /// For a state of the given length.
    pub fn new(states: usize) -> Self {
        let zeros = || vec![0.0; states];
        Stages { slopes: [zeros(), zeros(), zeros(), zeros()], stage: zeros(), start: zeros() }
    }

    /// Flies `state` over one cell of `width` seconds from `time`, in at least `substeps` sub-steps.
    /// `slope` holds f at the beginning and is left with f at the end; `rates(t, y, f)` evaluates f.
    #[expect(
        clippy::too_many_arguments,
        reason = "one call site; a struct of them would only rename the arguments"
    )]
    pub fn fly_cell(
        &mut self,
        layout: &StateLayout,
        scale: &ErrorScale,
        (time, width): (f64, f64),
        substeps: u32,
        state: &mut [f64],
        slope: &mut [f64],
        mut rates: impl FnMut(f64, &[f64], &mut [f64]),
    ) -> CellEnd {
        self.start.copy_from_slice(state);
        let mut count = substeps;
        loop {
            let step = width / f64::from(count);
            let mut error = 0.0_f64;
            for index in 0..count {
                let begin = time + f64::from(index) * step;
                self.substep((begin, step), state, slope, &mut rates);
                normalise(&mut state[layout.attitude()]);
                rates(begin + step, state, slope);
                error = nan_max(error, self.error(layout, scale, step, state, slope));
                if error.is_nan() || error > 1.0 {
                    break;
                }
            }
            if error <= 1.0 {
                let next = if error < COARSEN { (count / 2).max(1) } else { count };
                return CellEnd::Accepted { next };
            }
            if count == MAX_SUBSTEPS {
                return CellEnd::Failed;
            }
            count *= 2;
            state.copy_from_slice(&self.start);
            rates(time, state, slope);
        }
    }

    /// One classical Runge–Kutta step; k₄ stays in the stages for the error estimate.
    fn substep(
        &mut self,
        (time, step): (f64, f64),
        state: &mut [f64],
        slope: &[f64],
        rates: &mut impl FnMut(f64, &[f64], &mut [f64]),
    ) {
        let [k1, k2, k3, k4] = &mut self.slopes;
        k1.copy_from_slice(slope);
        offset(&mut self.stage, state, 0.5 * step, k1);
        rates(time + 0.5 * step, &self.stage, k2);
        offset(&mut self.stage, state, 0.5 * step, k2);
        rates(time + 0.5 * step, &self.stage, k3);
        offset(&mut self.stage, state, step, k3);
        rates(time + step, &self.stage, k4);
        for ((((y, k1), k2), k3), k4) in state.iter_mut().zip(k1).zip(k2).zip(k3).zip(k4) {
            *y += step / 6.0 * ((*k1 + *k4) + 2.0 * (*k2 + *k3));
        }
    }

    /// The estimated error of the last sub-step in units of the allowed one; NaN when it is not finite.
    fn error(
        &self,
        layout: &StateLayout,
        scale: &ErrorScale,
        step: f64,
        state: &[f64],
        slope: &[f64],
    ) -> f64 {
        let mut worst = 0.0;
        for (group, floor) in layout.groups().into_iter().zip(scale.floors) {
            let mut size = floor;
            let mut difference = 0.0;
            for ((y, slope), k4) in
                state[group.clone()].iter().zip(&slope[group.clone()]).zip(&self.slopes[3][group])
            {
                size = nan_max(size, y.abs());
                difference = nan_max(difference, (slope - k4).abs());
            }
            worst = nan_max(worst, step / 6.0 * difference / (scale.tolerance * size));
        }
        worst
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

/// The larger of two numbers, NaN when either is.
fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rigid aircraft's layout, of which only the position moves: x' = y, y' = −ω²x.
    fn oscillator(frequency: f64) -> impl FnMut(f64, &[f64], &mut [f64]) {
        move |_, state, rates| {
            rates.fill(0.0);
            rates[0] = state[1];
            rates[1] = -frequency * frequency * state[0];
        }
    }

    fn fly(frequency: f64, tolerance: f64, cells: usize) -> (f64, u32) {
        let layout = StateLayout::new(0, 0, 0);
        let mut stages = Stages::new(layout.len());
        let scale = ErrorScale { tolerance, floors: [1.0; 7] };
        let (mut state, mut slope) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
        (state[0], state[3]) = (1.0, 1.0);
        let mut rates = oscillator(frequency);
        rates(0.0, &state, &mut slope);
        let mut substeps = 1;
        for cell in 0..cells {
            let times = (cell as f64 * CELL, CELL);
            match stages.fly_cell(&layout, &scale, times, substeps, &mut state, &mut slope, &mut rates) {
                CellEnd::Accepted { next } => substeps = next,
                CellEnd::Failed => panic!("failed"),
            }
        }
        let exact = libm::cos(frequency * cells as f64 * CELL);
        ((state[0] - exact).abs(), substeps)
    }

    #[test]
    fn the_error_follows_the_tolerance() {
        let errors = [1e-4, 1e-6, 1e-8].map(|tolerance| fly(600.0, tolerance, 50).0);
        assert!(errors[0] < 1e-2 && errors[1] < 1e-4 && errors[2] < 1e-6, "{errors:?}");
        assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    }

    #[test]
    fn slow_motion_takes_one_step_a_cell_and_fast_motion_more() {
        assert_eq!(fly(1.0, 1e-6, 20).1, 1);
        assert!(fly(2000.0, 1e-6, 20).1 >= 8);
    }

    #[test]
    fn a_state_that_explodes_is_reported() {
        let layout = StateLayout::new(0, 0, 0);
        let mut stages = Stages::new(layout.len());
        let scale = ErrorScale { tolerance: 1e-6, floors: [1.0; 7] };
        let (mut state, mut slope) = (vec![1.0; layout.len()], vec![f64::NAN; layout.len()]);
        let end = stages
            .fly_cell(&layout, &scale, (0.0, CELL), 1, &mut state, &mut slope, |_, _, f| f.fill(f64::NAN));
        assert_eq!(end, CellEnd::Failed);
    }
}

//! Fourth-order exponential Runge–Kutta steps with error control (Krogstad's ETDRK4).
//!
//! [theory: integration.stages, integration.error, integration.grid]
//!
//! What decays or swings fast is the plant's linear part L and integrated exactly, so that the step is bound by what couples
//! and bends it; where L is zero this is the classical Runge–Kutta method. A cell of time is flown in 1, 2, 4 … equal sub-steps. The estimate, the last weight
//! times the difference of f(y₁) and the fourth slope, costs nothing, since f(y₁) begins the next sub-step.

use pulp::{Arch, Simd, WithSimd};

use crate::equations::StateLayout;
use crate::math::{AlignedNumbers, zeros};
use crate::plant::{LinearPart, Plant};

use super::diagonal::{Combine, TakeOff};
use super::exponential::ExponentialWeights;

/// Most sub-steps of a cell.
pub const MAX_SUBSTEPS: u32 = 4096;

/// Below this error (of 1 allowed) the next cell tries half as many sub-steps; a halving multiplies the
/// estimate by at most 2⁴.
const COARSEN: f64 = 1.0 / 32.0;

/// How many step widths have their weights kept: the widths of full and of cut cells recur.
const KEPT_WEIGHTS: usize = 16;

/// Widths are rounded to this many parts of a second, so that rounding of the times makes no new ones.
const PARTS: f64 = (1_u64 << 44) as f64;

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
    arch: Arch,
    linear: LinearPart,
    weights: Vec<ExponentialWeights>,
    /// Which weights are overwritten next.
    oldest: usize,
    /// At the stages and at the end, in the coordinates of L; L times what happened since the beginning of the step is taken
    /// off.
    slopes: [AlignedNumbers; 5],
    /// The state at the beginning of the step and at the present stage, in the coordinates of L.
    stages: [AlignedNumbers; 2],
    /// What differs in a stage while it stands in the state's coordinates.
    kept: Vec<f64>,
}

/// Weights, and the slopes that they weigh.
type Term<'a> = (&'a [f64], &'a [f64]);

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
    /// For states of the given layout, of whose rates this is the linear part.
    pub fn new(layout: &StateLayout, scale: ErrorScale, linear: LinearPart) -> Self {
        let zeros = || zeros(layout.len());
        Integrator {
            layout: *layout,
            scale,
            arch: Arch::new(),
            weights: vec![ExponentialWeights::empty(layout.len()); KEPT_WEIGHTS],
            oldest: 0,
            slopes: [zeros(), zeros(), zeros(), zeros(), zeros()],
            stages: [zeros(), zeros()],
            kept: vec![0.0; linear.changed().len()],
            linear,
        }
    }

    /// The relative tolerance.
    pub fn tolerance(&self) -> f64 {
        self.scale.tolerance
    }

    /// The airspeed at which the linear part was taken, m/s.
    pub fn reference_airspeed(&self) -> f64 {
        self.linear.airspeed()
    }

    /// Takes the linear part of a plant at an airspeed, m/s.
    pub fn take_reference_airspeed(&mut self, plant: &Plant, airspeed: f64) {
        if self.linear.take_airspeed(plant, airspeed) {
            for weights in &mut self.weights {
                weights.width = 0.0;
            }
        }
    }

    /// Flies over a cell of some width (s) in at least `substeps` sub-steps: from a state and f there to a state and f at
    /// the end; `rates(t, y, f)` evaluates f at t (s) from the beginning of the cell. After a failure the state is the one
    /// that was refused.
    pub fn fly_cell(
        &mut self,
        width: f64,
        substeps: u32,
        from: (&[f64], &[f64]),
        (to, to_slope): (&mut [f64], &mut [f64]),
        mut rates: impl FnMut(f64, &[f64], &mut [f64]),
    ) -> CellEnd {
        let mut count = substeps;
        loop {
            let step = width / f64::from(count);
            let weights = self.prepare_weights(step);
            let mut worst = 0.0;
            for index in 0..count {
                let time = f64::from(index) * step;
                let next = if index + 1 == count { width } else { f64::from(index + 1) * step };
                let start: (&[f64], &[f64]) = if index == 0 { from } else { (to, to_slope) };
                self.begin_step(start);
                worst = nan_max(worst, self.step((time, next), weights, (to, to_slope), &mut rates));
                if worst.is_nan() || worst > 1.0 {
                    break;
                }
            }
            if worst <= 1.0 {
                let next = if worst < COARSEN { (count / 2).max(1) } else { count };
                return CellEnd::Accepted { next };
            }
            if count >= MAX_SUBSTEPS {
                return CellEnd::Failed;
            }
            count *= 2;
        }
    }

    /// Takes state and slope where a step begins.
    fn begin_step(&mut self, (state, slope): (&[f64], &[f64])) {
        let Integrator { linear, slopes: [k1, ..], stages: [y, _], .. } = self;
        y.copy_from_slice(state);
        k1.copy_from_slice(slope);
        linear.enter(y);
        linear.enter(k1);
    }

    /// Finds or computes the weights of a step width; returns their place.
    fn prepare_weights(&mut self, step: f64) -> usize {
        let step = libm::round(step * PARTS) / PARTS;
        if let Some(place) = self.weights.iter().position(|weights| weights.width == step) {
            return place;
        }
        let place = self.oldest;
        self.oldest = (place + 1) % KEPT_WEIGHTS;
        self.weights[place].compute(self.linear.spectrum(), self.linear.diagonal(), step);
        place
    }

    /// One step to a state and f there; returns its estimated error in units of the allowed one, NaN when it is not
    /// finite. As e^{hL}y = y + hφ₁(hL)Ly, every stage of Krogstad's is y plus weights times the slopes
    /// n_i = f_i − L(y_i − y), without any power of e [theory: integration.stages].
    fn step(
        &mut self,
        (time, next): (f64, f64),
        weights: usize,
        (state, slope): (&mut [f64], &mut [f64]),
        rates: &mut impl FnMut(f64, &[f64], &mut [f64]),
    ) -> f64 {
        let Integrator { arch, linear, slopes, stages, kept, .. } = self;
        let ([k1, k2, k3, k4, k5], [y, stage]) = (slopes, stages);
        let w = &self.weights[weights];
        let middle = 0.5 * (time + next);
        let changed = linear.changed();
        let mut evaluate = |linear: &mut LinearPart, time: f64, stage: &mut [f64], k: &mut [f64]| {
            kept.copy_from_slice(&stage[changed.clone()]);
            linear.leave(stage);
            rates(time, stage, k);
            linear.enter(k);
            stage[changed.clone()].copy_from_slice(kept);
            arch.dispatch(TakeOff::new(linear, stage, y, k));
        };
        arch.dispatch(Combine {
            spectrum: linear.spectrum(),
            target: stage,
            base: y,
            terms: [(&w.half, k1)],
        });
        evaluate(linear, middle, stage, k2);
        let terms: [Term; 2] = [(&w.third_first, k1), (&w.third_second, k2)];
        arch.dispatch(Combine { spectrum: linear.spectrum(), target: stage, base: y, terms });
        evaluate(linear, middle, stage, k3);
        let terms: [Term; 2] = [(&w.fourth_first, k1), (&w.fourth_third, k3)];
        arch.dispatch(Combine { spectrum: linear.spectrum(), target: stage, base: y, terms });
        evaluate(linear, next, stage, k4);
        let terms: [Term; 4] = [(&w.first, k1), (&w.middle, k2), (&w.middle, k3), (&w.last, k4)];
        arch.dispatch(Combine { spectrum: linear.spectrum(), target: stage, base: y, terms });
        state.copy_from_slice(stage);
        linear.leave(state);
        normalise(&mut state[self.layout.attitude()]);
        rates(next, state, slope);
        k5.copy_from_slice(slope);
        linear.enter(k5);
        arch.dispatch(TakeOff::new(linear, stage, y, k5));
        self.error(weights, state)
    }

    /// The estimated error −w₄ (f(y₁) − n₄) of the last step in units of the allowed one; NaN when it is not finite.
    ///
    /// [theory: integration.error]
    fn error(&mut self, weights: usize, state: &[f64]) -> f64 {
        let Integrator { arch, linear, slopes: [_, _, _, k4, k5], stages, .. } = self;
        let [_, difference] = stages;
        let last = &self.weights[weights].last;
        difference.fill(0.0);
        let spectrum = linear.spectrum();
        arch.dispatch(TakeOff { spectrum, linear: last, to: k5, from: k4, slope: difference });
        linear.leave(difference);
        let mut worst = 0.0;
        for (group, floor) in self.layout.groups().into_iter().zip(self.scale.floors) {
            let [size, error] = arch.dispatch(Largest {
                values: [&state[group.clone()], &difference[group.clone()]],
                floors: [floor, 0.0],
            });
            worst = nan_max(worst, error / (self.scale.tolerance * size));
        }
        worst
    }
}

fn normalise(quaternion: &mut [f64]) {
    let norm = libm::sqrt(quaternion.iter().map(|x| x * x).sum());
    for component in quaternion {
        *component /= norm;
    }
}

/// The largest magnitudes of two vectors, each at least its floor.
struct Largest<'a> {
    values: [&'a [f64]; 2],
    floors: [f64; 2],
}

impl WithSimd for Largest<'_> {
    type Output = [f64; 2];

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> [f64; 2] {
        let Largest { values: [first, second], floors } = self;
        [largest(first, floors[0]), largest(second, floors[1])]
    }
}

/// Largest magnitude, at least `floor`; NaN when any value is. Without their signs, numbers have the order of their
/// bits, and not-a-number comes last.
#[inline(always)]
fn largest(values: &[f64], floor: f64) -> f64 {
    f64::from_bits(values.iter().fold(floor.to_bits(), |largest, value| largest.max(value.abs().to_bits())))
}

/// The larger of two numbers, NaN when either is.
fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strips::InflowLayout;

    /// Steps of a stiff lag y' = −800 (y − cos ωt) beside an oscillator x'' = −ω²x.
    fn fly(frequency: f64, tolerance: f64, width: f64, cells: usize) -> ([f64; 2], u32) {
        let layout = StateLayout::new(0, InflowLayout::new(1, 1, 0));
        let scale = ErrorScale { tolerance, floors: [1.0; 7] };
        let decay = -800.0;
        let linear = LinearPart::new(&layout, None)
            .with_diagonal(|linear| linear[layout.inflow_layout().real()].fill(decay));
        let mut integrator = Integrator::new(&layout, scale, linear);
        let (lag, x, w) =
            (layout.inflow_layout().real().start, layout.position().start, layout.attitude().start);
        let rates = |time: f64, state: &[f64], rates: &mut [f64]| {
            rates.fill(0.0);
            rates[x] = state[x + 1];
            rates[x + 1] = -frequency * frequency * state[x];
            rates[lag] = decay * (state[lag] - libm::cos(frequency * time));
        };
        let (mut state, mut slope) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
        (state[x], state[w]) = (1.0, 1.0);
        let forced = |time: f64| {
            let (sin, cos) = libm::sincos(frequency * time);
            decay * (decay * cos - frequency * sin) / (decay * decay + frequency * frequency)
        };
        state[lag] = forced(0.0);
        rates(0.0, &state, &mut slope);
        let mut substeps = 1;
        for cell in 0..cells {
            let begin = cell as f64 * width;
            let (from, from_slope) = (state.clone(), slope.clone());
            let (from, to) = ((&from[..], &from_slope[..]), (&mut state[..], &mut slope[..]));
            let rates = |time: f64, state: &[f64], slope: &mut [f64]| rates(begin + time, state, slope);
            match integrator.fly_cell(width, substeps, from, to, rates) {
                CellEnd::Accepted { next } => substeps = next,
                CellEnd::Failed => panic!("failed"),
            }
        }
        let end = cells as f64 * width;
        let oscillator = libm::cos(frequency * end);
        ([(state[x] - oscillator).abs(), (state[lag] - forced(end)).abs()], substeps)
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
        let layout = StateLayout::new(0, InflowLayout::new(0, 0, 0));
        let scale = ErrorScale { tolerance: 1e-6, floors: [1.0; 7] };
        let mut integrator = Integrator::new(&layout, scale, LinearPart::new(&layout, None));
        let (state, slope) = (vec![1.0; layout.len()], vec![f64::NAN; layout.len()]);
        let (mut to, mut to_slope) = (state.clone(), slope.clone());
        let end = integrator.fly_cell(1e-3, 1, (&state, &slope), (&mut to, &mut to_slope), |_, _, f| {
            f.fill(f64::NAN);
        });
        assert_eq!(end, CellEnd::Failed);
        assert!(to.iter().any(|state| state.is_nan()));
    }
}

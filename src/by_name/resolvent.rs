//! (iω − A)⁻¹ of a linear model: its wake is eliminated, so that a small system is left [theory: linearisation.harmonic-gusts].
//!
//! With x all states but the inflow η, ẋ = F x + B η and η̇ = C x + D η. D is diagonal but for the 2 × 2 blocks of complex inflow
//! states, so that (iω − D)⁻¹ is cheap [theory: stability.condensed].

use std::ops::Range;

use nalgebra::{Complex, DMatrix, DVector};

use crate::plant::{WakeBlocks, product};

/// A linear model's A, sorted.
#[derive(Clone, Debug)]
pub(super) struct Resolvent {
    wake: Range<usize>,
    /// Of x their places among all states.
    others: Vec<usize>,
    /// F.
    motion: DMatrix<f64>,
    /// B.
    wake_on_motion: DMatrix<f64>,
    /// C.
    motion_on_wake: DMatrix<f64>,
    /// D.
    blocks: WakeBlocks,
}

impl Resolvent {
    /// Of A, of whose states these are the wake's.
    pub fn new(a: &DMatrix<f64>, wake: Range<usize>) -> Self {
        let others: Vec<usize> = (0..a.nrows()).filter(|state| !wake.contains(state)).collect();
        let of_wake: Vec<usize> = wake.clone().collect();
        let part = |rows: &[usize], columns: &[usize]| a.select_rows(rows).select_columns(columns);
        Resolvent {
            motion: part(&others, &others),
            wake_on_motion: part(&others, &of_wake),
            motion_on_wake: part(&of_wake, &others),
            blocks: WakeBlocks::of(&part(&of_wake, &of_wake)),
            wake,
            others,
        }
    }

    /// x of (iω − A) x = f for ω, rad/s; `None` where that has no solution.
    pub fn solve(&self, frequency: f64, forcing: &DVector<Complex<f64>>) -> Option<DVector<Complex<f64>>> {
        let rate = Complex::new(0.0, frequency);
        let forced_wake = forcing.rows(self.wake.start, self.wake.len()).into_owned();
        let forced_wake = self.blocks.answered(rate, forced_wake);
        let forced: DVector<Complex<f64>> = forcing.select_rows(&self.others);
        let motion =
            self.condensed(rate).lu().solve(&(forced + product(&self.wake_on_motion, &forced_wake)))?;
        let wake = self.blocks.answered(rate, product(&self.motion_on_wake, &motion)) + forced_wake;
        let mut states = DVector::zeros(forcing.len());
        states.rows_mut(self.wake.start, self.wake.len()).copy_from(&wake);
        for (&place, value) in self.others.iter().zip(motion.iter()) {
            states[place] = *value;
        }
        Some(states)
    }

    /// iω − F − B (iω − D)⁻¹ C.
    fn condensed(&self, rate: Complex<f64>) -> DMatrix<Complex<f64>> {
        let by_wake = self.blocks.eliminated(rate, &self.wake_on_motion, &self.motion_on_wake);
        DMatrix::from_fn(self.others.len(), self.others.len(), |i, j| {
            let diagonal = if i == j { rate } else { Complex::from(0.0) };
            diagonal - self.motion[(i, j)] - by_wake[(i, j)]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two states, a pair and a lag of the wake, another state behind them.
    #[test]
    fn what_is_found_solves_the_whole_system() {
        let mut a = DMatrix::from_fn(6, 6, |i, j| libm::sin((7 * i + 3 * j) as f64));
        for (i, j) in [(2, 4), (3, 4), (4, 2), (4, 3)] {
            a[(i, j)] = 0.0;
        }
        let forcing = DVector::from_fn(6, |i, _| Complex::new(libm::cos(i as f64), 0.3 * i as f64));
        let found = Resolvent::new(&a, 2..5).solve(1.7, &forcing).unwrap();
        let left = &found * Complex::new(0.0, 1.7) - product(&a, &found) - &forcing;
        assert!(left.norm() < 1e-13, "{left}");
        assert!(Resolvent::new(&DMatrix::zeros(2, 2), 2..2).solve(0.0, &DVector::zeros(2)).is_none());
    }
}

//! (iω − A)⁻¹ of a linear model: its wake is eliminated, so that a small system is left [theory: linearisation.harmonic-gusts].
//!
//! With x all states but the inflow η, ẋ = F x + B η and η̇ = C x + D η. D is diagonal but for the 2 × 2 blocks of complex inflow
//! states, so that (iω − D)⁻¹ is cheap [theory: stability.condensed].

use std::ops::Range;

use nalgebra::{Complex, DMatrix, DVector};

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
    /// Of D, with the row where it begins.
    blocks: Vec<(usize, WakeBlock)>,
}

/// A diagonal block of D.
#[derive(Clone, Copy, Debug)]
enum WakeBlock {
    Lag(f64),
    Pair([[f64; 2]; 2]),
}

impl Resolvent {
    /// Of A, of whose states these are the wake's.
    pub fn new(a: &DMatrix<f64>, wake: Range<usize>) -> Self {
        let others: Vec<usize> = (0..a.nrows()).filter(|state| !wake.contains(state)).collect();
        let of_wake: Vec<usize> = wake.clone().collect();
        let part = |rows: &[usize], columns: &[usize]| a.select_rows(rows).select_columns(columns);
        let inner = part(&of_wake, &of_wake);
        let mut blocks = Vec::new();
        let mut row = 0;
        while row < inner.nrows() {
            let is_pair = row + 1 < inner.nrows() && inner[(row, row + 1)] != 0.0;
            let block = if is_pair {
                WakeBlock::Pair([0, 1].map(|i| [0, 1].map(|j| inner[(row + i, row + j)])))
            } else {
                WakeBlock::Lag(inner[(row, row)])
            };
            blocks.push((row, block));
            row += if is_pair { 2 } else { 1 };
        }
        Resolvent {
            motion: part(&others, &others),
            wake_on_motion: part(&others, &of_wake),
            motion_on_wake: part(&of_wake, &others),
            blocks,
            wake,
            others,
        }
    }

    /// x of (iω − A) x = f for ω, rad/s; `None` where that has no solution.
    pub fn solve(&self, frequency: f64, forcing: &DVector<Complex<f64>>) -> Option<DVector<Complex<f64>>> {
        let rate = Complex::new(0.0, frequency);
        let mut forced_wake = forcing.rows(self.wake.start, self.wake.len()).into_owned();
        self.answer(rate, forced_wake.as_mut_slice());
        let forced: DVector<Complex<f64>> = forcing.select_rows(&self.others);
        let motion =
            self.condensed(rate).lu().solve(&(forced + product(&self.wake_on_motion, &forced_wake)))?;
        let mut wake = product(&self.motion_on_wake, &motion);
        self.answer(rate, wake.as_mut_slice());
        wake += forced_wake;
        let mut states = DVector::zeros(forcing.len());
        states.rows_mut(self.wake.start, self.wake.len()).copy_from(&wake);
        for (&place, value) in self.others.iter().zip(motion.iter()) {
            states[place] = *value;
        }
        Some(states)
    }

    /// iω − F − B (iω − D)⁻¹ C.
    fn condensed(&self, rate: Complex<f64>) -> DMatrix<Complex<f64>> {
        let mut answers = self.motion_on_wake.map(Complex::from);
        for mut column in answers.column_iter_mut() {
            self.answer(rate, column.as_mut_slice());
        }
        let [re, im] = [answers.map(|x| x.re), answers.map(|x| x.im)].map(|part| &self.wake_on_motion * part);
        DMatrix::from_fn(self.others.len(), self.others.len(), |i, j| {
            let diagonal = if i == j { rate } else { Complex::from(0.0) };
            diagonal - self.motion[(i, j)] - Complex::new(re[(i, j)], im[(i, j)])
        })
    }

    /// (iω − D)⁻¹ times a forcing, in its place.
    fn answer(&self, rate: Complex<f64>, forcing: &mut [Complex<f64>]) {
        for &(row, block) in &self.blocks {
            match block {
                WakeBlock::Lag(decay) => forcing[row] /= rate - decay,
                WakeBlock::Pair([[a, b], [c, d]]) => {
                    let (first, second) = (forcing[row], forcing[row + 1]);
                    let determinant = (rate - a) * (rate - d) - Complex::from(b * c);
                    forcing[row] = ((rate - d) * first + second * b) / determinant;
                    forcing[row + 1] = ((rate - a) * second + first * c) / determinant;
                }
            }
        }
    }
}

/// A real matrix times a complex vector.
pub(super) fn product(matrix: &DMatrix<f64>, vector: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let [re, im] = [vector.map(|x| x.re), vector.map(|x| x.im)].map(|part| matrix * part);
    re.zip_map(&im, Complex::new)
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

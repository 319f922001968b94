//! The wake's own part D of a linearised motion: diagonal but for the 2 × 2 blocks of complex inflow states, so that (λ − D)⁻¹ is cheap.
//!
//! [theory: stability.condensed, inflow.eigenbasis]

use nalgebra::{Complex, DMatrix, DVector};

/// D.
#[derive(Clone, Debug)]
pub(crate) struct WakeBlocks(Vec<(usize, Block)>);

/// A diagonal block, which begins at some row.
#[derive(Clone, Copy, Debug)]
enum Block {
    Lag(f64),
    Pair([[f64; 2]; 2]),
}

impl WakeBlocks {
    /// Of D as a square matrix.
    pub fn of(inner: &DMatrix<f64>) -> Self {
        WakeBlocks::of_entries(inner.nrows(), |row, column| inner[(row, column)])
    }

    /// Of the entries of D.
    fn of_entries(rows: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut blocks = Vec::new();
        let mut row = 0;
        while row < rows {
            let is_pair = row + 1 < rows && entry(row, row + 1) != 0.0;
            let block = if is_pair {
                Block::Pair([0, 1].map(|i| [0, 1].map(|j| entry(row + i, row + j))))
            } else {
                Block::Lag(entry(row, row))
            };
            blocks.push((row, block));
            row += if is_pair { 2 } else { 1 };
        }
        WakeBlocks(blocks)
    }

    /// A share of the way from here to another D of as many rows, in each entry. What is a pair in one of them is one here.
    pub fn towards(&self, other: &Self, share: f64) -> Self {
        let [one, other] = [self, other].map(WakeBlocks::bands);
        let entry = |row: usize, column: usize| {
            let band = column + 1 - row;
            (1.0 - share) * one[row][band] + share * other[row][band]
        };
        WakeBlocks::of_entries(one.len(), entry)
    }

    /// Of each row of D the entries before the diagonal, on it and behind it.
    fn bands(&self) -> Vec<[f64; 3]> {
        let mut bands = Vec::new();
        for &(_, block) in &self.0 {
            match block {
                Block::Lag(rate) => bands.push([0.0, rate, 0.0]),
                Block::Pair([[a, b], [c, d]]) => bands.extend([[0.0, a, b], [c, d, 0.0]]),
            }
        }
        bands
    }

    /// Dᵀ.
    pub fn transposed(&self) -> Self {
        self.map(|block| match block {
            Block::Pair([[a, b], [c, d]]) => Block::Pair([[a, c], [b, d]]),
            lag @ Block::Lag(_) => lag,
        })
    }

    /// D times a number.
    pub fn scaled(&self, factor: f64) -> Self {
        self.map(|block| match block {
            Block::Lag(rate) => Block::Lag(factor * rate),
            Block::Pair(rates) => Block::Pair(rates.map(|row| row.map(|rate| factor * rate))),
        })
    }

    fn map(&self, change: impl Fn(Block) -> Block) -> Self {
        WakeBlocks(self.0.iter().map(|&(row, block)| (row, change(block))).collect())
    }

    /// (λ − D)⁻¹ times a forcing, in its place.
    pub fn answer(&self, eigenvalue: Complex<f64>, forcing: &mut [Complex<f64>]) {
        for &(row, block) in &self.0 {
            match block {
                Block::Lag(rate) => forcing[row] /= eigenvalue - rate,
                Block::Pair([[a, b], [c, d]]) => {
                    let (first, second) = (forcing[row], forcing[row + 1]);
                    let determinant = (eigenvalue - a) * (eigenvalue - d) - Complex::from(b * c);
                    forcing[row] = ((eigenvalue - d) * first + second * b) / determinant;
                    forcing[row + 1] = ((eigenvalue - a) * second + first * c) / determinant;
                }
            }
        }
    }

    /// (λ − D)⁻¹ times a vector.
    pub fn answered(
        &self,
        eigenvalue: Complex<f64>,
        mut forcing: DVector<Complex<f64>>,
    ) -> DVector<Complex<f64>> {
        self.answer(eigenvalue, forcing.as_mut_slice());
        forcing
    }

    /// B (λ − D)⁻¹ C: what the wake does to a motion that forces it.
    pub fn eliminated(
        &self,
        eigenvalue: Complex<f64>,
        wake_on_motion: &DMatrix<f64>,
        motion_on_wake: &DMatrix<f64>,
    ) -> DMatrix<Complex<f64>> {
        let mut answers = motion_on_wake.map(Complex::from);
        for mut column in answers.column_iter_mut() {
            self.answer(eigenvalue, column.as_mut_slice());
        }
        let [re, im] = [answers.map(|x| x.re), answers.map(|x| x.im)].map(|part| wake_on_motion * part);
        re.zip_map(&im, Complex::new)
    }

    /// D⁻¹ times a matrix.
    pub fn divide(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let mut answers = matrix.map(|entry| Complex::from(-entry));
        for mut column in answers.column_iter_mut() {
            self.answer(Complex::from(0.0), column.as_mut_slice());
        }
        answers.map(|entry| entry.re)
    }
}

/// A real matrix times a complex vector.
pub(crate) fn product(matrix: &DMatrix<f64>, vector: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let [re, im] = [vector.map(|x| x.re), vector.map(|x| x.im)].map(|part| matrix * part);
    re.zip_map(&im, Complex::new)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pair between two lags.
    fn inner() -> DMatrix<f64> {
        DMatrix::from_row_slice(
            4,
            4,
            &[
                -2.0, 0.0, 0.0, 0.0, //
                0.0, -3.0, 1.5, 0.0, //
                0.0, -1.0, -4.0, 0.0, //
                0.0, 0.0, 0.0, -5.0,
            ],
        )
    }

    #[test]
    fn between_two_of_them_each_entry_is_between_also_where_a_pair_is_two_lags_in_one() {
        let right = DMatrix::from_fn(4, 1, |i, _| 1.0 + i as f64);
        let lags = DMatrix::from_diagonal(&DVector::from_vec(vec![-1.0, -2.0, -3.0, -4.0]));
        for (one, other) in [(inner(), inner() * 2.0), (inner(), lags.clone()), (lags, inner())] {
            let whole = &one * 0.75 + &other * 0.25;
            let blocks = WakeBlocks::of(&one).towards(&WakeBlocks::of(&other), 0.25);
            assert!((whole * blocks.divide(&right) - &right).amax() < 1e-14);
        }
    }

    #[test]
    fn blocks_answer_as_the_whole_matrix_does() {
        let right = DMatrix::from_fn(4, 2, |i, j| 1.0 + i as f64 - 0.3 * j as f64);
        for (blocks, whole) in [
            (WakeBlocks::of(&inner()), inner()),
            (WakeBlocks::of(&inner()).transposed(), inner().transpose()),
            (WakeBlocks::of(&inner()).scaled(2.5), inner() * 2.5),
        ] {
            assert!((&whole * blocks.divide(&right) - &right).amax() < 1e-14);
            let at = Complex::new(0.4, 1.7);
            let forcing = right.column(0).map(Complex::from);
            let found = blocks.answered(at, forcing.clone());
            assert!((&found * at - product(&whole, &found) - forcing).camax() < 1e-14);
        }
    }
}

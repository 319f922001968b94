//! What inputs move and what outputs show: the Gramians of a stable system, T as in its Schur form
//! [theory: linearisation.balanced].
//!
//! Bartels and Stewart's method (*Solution of the matrix equation AX + XB = C*, Communications of the ACM 15, 1972), from the
//! last columns to the first.

use nalgebra::DMatrix;

use super::schur::{Block, sylvester};

/// Part of the largest diagonal entry at which what is left of a Gramian is rounding.
const ROUNDING: f64 = 1e-15;

/// P of T P + P Tᵀ + B Bᵀ = 0; none where two roots of T add up to 0.
pub fn of_inputs(t: &DMatrix<f64>, blocks: &[Block], b: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    lyapunov(t, blocks, &(b * b.transpose()))
}

/// Q of Tᵀ Q + Q T + Cᵀ C = 0; none where two roots of T add up to 0.
pub fn of_outputs(t: &DMatrix<f64>, blocks: &[Block], c: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    // Tᵀ is upper triangular where rows and columns are counted from the last.
    let n = t.nrows();
    let backwards = |matrix: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| matrix[(n - 1 - i, n - 1 - j)]);
    let reversed = blocks.iter().rev().map(|block| Block { start: n - block.start - block.size, ..*block });
    let blocks: Vec<Block> = reversed.collect();
    let found = lyapunov(&backwards(&t.transpose()), &blocks, &backwards(&(c.transpose() * c)))?;
    Some(backwards(&found))
}

/// X of T X + X Tᵀ + F = 0, self-adjoint as F.
fn lyapunov(t: &DMatrix<f64>, blocks: &[Block], f: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = t.nrows();
    let mut x = DMatrix::zeros(n, n);
    for (last, &Block { start, size }) in blocks.iter().enumerate().rev() {
        let after = start + size;
        // What is known: columns behind, and by reflection the rows below these.
        let mut right = -f.view((0, start), (after, size));
        let beside = t.view((start, after), (size, n - after)).transpose();
        right.gemm(-1.0, &x.view((0, after), (after, n - after)), &beside, 1.0);
        let below = x.view((after, start), (n - after, size));
        right.gemm(-1.0, &t.view((0, after), (after, n - after)), &below, 1.0);
        let opposite = -t.view((start, start), (size, size)).transpose();
        for &Block { start: row, size: rows } in blocks[..=last].iter().rev() {
            let diagonal = t.view((row, row), (rows, rows));
            let known = right.rows(row, rows).into_owned();
            let solution = sylvester(diagonal, opposite.as_view(), &known)?;
            right.rows_mut(0, row).gemm(-1.0, &t.view((0, row), (row, rows)), &solution, 1.0);
            x.view_mut((start, row), (size, rows)).copy_from(&solution.transpose());
            x.view_mut((row, start), (rows, size)).copy_from(&solution);
        }
    }
    Some(x)
}

/// L of X = L Lᵀ for a self-adjoint X without negative roots, with as few columns as rounding leaves: Cholesky's with pivots.
pub fn factor(x: &DMatrix<f64>) -> DMatrix<f64> {
    let n = x.nrows();
    let mut rest: Vec<f64> = x.diagonal().iter().copied().collect();
    let least = ROUNDING * rest.iter().copied().fold(0.0, f64::max);
    let mut columns = DMatrix::zeros(n, n);
    for found in 0..n {
        let Some(pivot) = (0..n).max_by(|&one, &other| rest[one].total_cmp(&rest[other])) else { break };
        if rest[pivot] <= least {
            return columns.columns(0, found).into_owned();
        }
        let mut column = x.column(pivot).into_owned();
        let row = columns.view((pivot, 0), (1, found)).transpose();
        column.gemv(-1.0, &columns.columns(0, found), &row.column(0), 1.0);
        column /= rest[pivot].sqrt();
        for (entry, rest) in column.iter_mut().zip(&mut rest) {
            // What has been a pivot has nothing left.
            if *rest == 0.0 {
                *entry = 0.0;
            }
            *rest = (*rest - *entry * *entry).max(0.0);
        }
        rest[pivot] = 0.0;
        columns.set_column(found, &column);
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::super::schur::{Schur, scattered};
    use super::*;

    /// A stable T with pairs and single roots.
    fn stable(n: usize) -> Schur {
        let matrix = scattered(n, n, 0.2) - DMatrix::identity(n, n) * 6.0;
        let schur = Schur::of(&matrix).unwrap();
        let pairs = schur.blocks.iter().filter(|block| block.size == 2).count();
        assert!(pairs > 1 && 2 * pairs < n - 1, "{pairs}");
        schur
    }

    #[test]
    fn gramians_satisfy_their_equations_and_are_their_factors() {
        let Schur { t, blocks, .. } = stable(11);
        let (b, c) = (scattered(11, 3, 0.2), scattered(2, 11, 0.9));
        let p = of_inputs(&t, &blocks, &b).unwrap();
        assert!((&t * &p + &p * t.transpose() + &b * b.transpose()).amax() < 1e-13);
        let q = of_outputs(&t, &blocks, &c).unwrap();
        assert!((t.transpose() * &q + &q * &t + c.transpose() * &c).amax() < 1e-13);
        for gramian in [p, q] {
            let l = factor(&gramian);
            assert!((&l * l.transpose() - &gramian).amax() < 1e-14 * gramian.amax());
        }
    }

    #[test]
    fn a_factor_has_no_more_columns_than_its_product_has_rank() {
        let l = scattered(9, 3, 0.6);
        let found = factor(&(&l * l.transpose()));
        assert_eq!(found.shape(), (9, 3));
        assert_eq!(factor(&DMatrix::zeros(4, 4)).shape(), (4, 0));
    }
}

//! Dense solves of the size of the equations of motion, without allocation.
//!
//! Matrices are row-major slices. nalgebra's factorisations take and give back owned storage, and its LU
//! allocates; the equations of motion are solved hundreds of times a second of flight.

use pulp::{Simd, WithSimd};

use crate::lanes::{LANES, Place};

/// Solves A x = b for a symmetric positive definite A, of which only the upper triangle is read: A = UᵀD⁻¹U with
/// D the diagonal of U. b becomes x; the result is `false` when A is not positive definite.
pub struct Cholesky<'a> {
    /// A.
    pub a: &'a [f64],
    /// b.
    pub b: &'a mut [f64],
    /// [Room](Cholesky::room) for U, each row of which is followed by a number of DU⁻ᵀb.
    pub factor: &'a mut [f64],
}

impl Cholesky<'_> {
    /// How many numbers a solution with n unknowns writes down.
    pub fn room(n: usize) -> usize {
        n * (n + 1).next_multiple_of(LANES)
    }
}

impl WithSimd for Cholesky<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let Cholesky { a, b, factor } = self;
        let n = b.len();
        if n == 0 {
            return true;
        }
        let width = (n + 1).next_multiple_of(LANES);
        let rows = factor.chunks_exact_mut(width).zip(a.chunks_exact(n)).zip(&*b);
        for (i, ((row, a), b)) in rows.enumerate() {
            row[i..n].copy_from_slice(&a[i..]);
            row[n] = *b;
        }
        for j in 0..n {
            let (row, below) = factor[j * width..n * width].split_at_mut(width);
            if row[j].is_nan() || row[j] <= 0.0 {
                return false;
            }
            let reciprocal = 1.0 / row[j];
            for (i, target) in (j + 1..n).zip(below.chunks_exact_mut(width)) {
                let begin = i - i % LANES;
                subtract(simd, &mut target[begin..], row[i] * reciprocal, &row[begin..]);
            }
            row[j] = reciprocal;
        }
        for i in (0..n).rev() {
            let solved = factor[i * width + n] * factor[i * width + i];
            b[i] = solved;
            for row in factor[..i * width].chunks_exact_mut(width) {
                row[n] -= row[i] * solved;
            }
        }
        true
    }
}

/// target −= factor · row.
#[inline(always)]
fn subtract<S: Simd>(simd: S, target: &mut [f64], factor: f64, row: &[f64]) {
    for (target, row) in target.chunks_exact_mut(LANES).zip(row.chunks_exact(LANES)) {
        for place in Place::all(simd) {
            place.store_slice(target, place.load_slice(target) - place.load_slice(row) * factor);
        }
    }
}

/// Solves A x = b by elimination with row pivoting. A is overwritten, b becomes x.
/// Returns `false` when A is singular.
pub fn solve_lu(a: &mut [f64], b: &mut [f64]) -> bool {
    let n = b.len();
    for column in 0..n {
        let magnitude = |row: usize| a[row * n + column].abs();
        let pivot =
            (column..n).fold(column, |best, row| if magnitude(row) > magnitude(best) { row } else { best });
        let largest = magnitude(pivot);
        if largest.is_nan() || largest == 0.0 {
            return false;
        }
        if pivot != column {
            for k in 0..n {
                a.swap(column * n + k, pivot * n + k);
            }
            b.swap(column, pivot);
        }
        let (above, below) = a.split_at_mut((column + 1) * n);
        let pivot_row = &above[column * n..];
        for (row, target) in below.chunks_exact_mut(n).zip(column + 1..) {
            let factor = row[column] / pivot_row[column];
            for (value, pivot) in row[column..].iter_mut().zip(&pivot_row[column..]) {
                *value -= factor * pivot;
            }
            b[target] -= factor * b[column];
        }
    }
    for i in (0..n).rev() {
        let sum = dot(&a[i * n + i + 1..(i + 1) * n], &b[i + 1..]);
        b[i] = (b[i] - sum) / a[i * n + i];
    }
    true
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve_cholesky(a: &mut [f64], b: &mut [f64]) -> bool {
        let factor = &mut vec![0.0; Cholesky::room(b.len())];
        pulp::Arch::new().dispatch(Cholesky { a, b, factor })
    }

    fn sample(n: usize) -> (Vec<f64>, Vec<f64>) {
        let entry = |i: usize, j: usize| libm::sin((1 + i * 7 + j * 3) as f64);
        let mut a = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..n {
                a[i * n + j] = (0..n).map(|k| entry(i, k) * entry(j, k)).sum::<f64>() + f64::from(i == j);
            }
        }
        let b = (0..n).map(|i| libm::cos(i as f64)).collect();
        (a, b)
    }

    fn residual(a: &[f64], x: &[f64], b: &[f64]) -> f64 {
        let n = b.len();
        (0..n).map(|i| (dot(&a[i * n..(i + 1) * n], x) - b[i]).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn both_solvers_solve() {
        let (a, b) = sample(9);
        for solve in [solve_cholesky, solve_lu] {
            let (mut factor, mut x) = (a.clone(), b.clone());
            assert!(solve(&mut factor, &mut x));
            assert!(residual(&a, &x, &b) < 1e-13);
        }
    }

    #[test]
    fn without_unknowns_there_is_nothing_to_solve() {
        assert!(solve_cholesky(&mut [], &mut []) && solve_lu(&mut [], &mut []));
    }

    #[test]
    fn elimination_pivots_past_a_zero_on_the_diagonal() {
        let mut x = [3.0, 5.0];
        assert!(solve_lu(&mut [0.0, 1.0, 2.0, 0.0], &mut x));
        assert_eq!(x, [2.5, 3.0]);
    }

    #[test]
    fn indefinite_singular_and_nan_matrices_are_reported() {
        assert!(!solve_cholesky(&mut [1.0, 0.0, 0.0, -1.0], &mut [1.0, 1.0]));
        assert!(!solve_cholesky(&mut [f64::NAN, 0.0, 0.0, 1.0], &mut [1.0, 1.0]));
        assert!(!solve_lu(&mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
        assert!(!solve_lu(&mut [f64::NAN], &mut [1.0]));
    }
}

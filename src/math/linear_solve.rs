//! Systems of linear equations of the size of the equations of motion, solved without allocation.
//!
//! nalgebra's factorisations take and give back owned storage, and its LU allocates; the equations of motion are
//! solved hundreds of times a second of flight.

use pulp::Arch;

use super::arithmetic::{Arithmetic, Machine, Work};
use super::lanes::{LANES, Window};
use super::square_matrix::SquareMatrix;

/// A x = b. A is written anew for every factorisation, which takes its place.
#[derive(Clone, Debug)]
pub struct LinearSystem {
    /// A, of which only the upper triangle is read if it is self-adjoint; then its factor.
    pub matrix: SquareMatrix,
    method: Method,
}

#[derive(Clone, Debug)]
enum Method {
    /// A = LDLᵀ of a positive definite A: rows of Lᵀ, 1/D on the diagonal.
    Cholesky,
    /// PA = LU: U, and below it the multipliers of L; with which row each row was exchanged.
    Elimination { pivots: Vec<usize> },
}

impl LinearSystem {
    /// Of so many unknowns.
    pub fn new(self_adjoint: bool, size: usize) -> Self {
        let method =
            if self_adjoint { Method::Cholesky } else { Method::Elimination { pivots: vec![0; size] } };
        LinearSystem { matrix: SquareMatrix::new(size), method }
    }

    /// Factorises A and turns b into x. `false` when A is singular, or not positive definite if it is to be self-adjoint.
    pub fn solve(&mut self, machine: impl Machine, b: &mut [f64]) -> bool {
        match &mut self.method {
            Method::Cholesky => machine.run(CholeskySolution { matrix: &mut self.matrix, b }),
            Method::Elimination { pivots } => {
                let regular = eliminate(&mut self.matrix, pivots);
                if regular {
                    solve_eliminated(&self.matrix, pivots, b);
                }
                regular
            }
        }
    }

    /// Turns another b into x with the factor that there is: the same bits as with a new one.
    pub fn solve_again(&self, b: &mut [f64]) {
        match &self.method {
            Method::Cholesky => {
                for j in 0..b.len() {
                    let (row, solved) = (self.matrix.row(j), b[j]);
                    for (b, l) in b[j + 1..].iter_mut().zip(&row[j + 1..]) {
                        *b -= l * solved;
                    }
                    b[j] = solved * row[j];
                }
                substitute_back(&self.matrix, b);
            }
            Method::Elimination { pivots } => solve_eliminated(&self.matrix, pivots, b),
        }
    }
}

/// Factorisation of a self-adjoint matrix and solution.
struct CholeskySolution<'a> {
    matrix: &'a mut SquareMatrix,
    b: &'a mut [f64],
}

impl Work for CholeskySolution<'_> {
    type Output = bool;

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) -> bool {
        let CholeskySolution { matrix, b } = self;
        // b is eliminated with the matrix, as one more column.
        let n = b.len();
        for (row, &b) in b.iter().enumerate() {
            matrix[(row, n)] = b;
        }
        // Small widths written out, so that their loops are unrolled.
        let (width, rows) = (matrix.width(), matrix.rows_mut());
        let regular = match width / LANES {
            1 => factorise(simd, rows, LANES),
            2 => factorise(simd, rows, 2 * LANES),
            3 => factorise(simd, rows, 3 * LANES),
            _ => factorise(simd, rows, width),
        };
        if regular {
            for (row, b) in b.iter_mut().enumerate() {
                *b = matrix[(row, n)];
            }
            substitute_back(matrix, b);
        }
        regular
    }
}

/// Factorises a self-adjoint matrix with rows of a given width, and eliminates all that stands right of it; `false` when it
/// is not positive definite.
#[inline(always)]
fn factorise<S: Arithmetic>(simd: S, rows: &mut [f64], width: usize) -> bool {
    let Some(&(mut pivot)) = rows.first() else { return true };
    for j in 0..rows.len() / width {
        if pivot.is_nan() || pivot <= 0.0 {
            return false;
        }
        let reciprocal = 1.0 / pivot;
        let (row, below) = rows[j * width..].split_at_mut(width);
        // The next pivot ahead of its row: all that follows waits for it.
        if let Some(next) = below.get(j + 1) {
            pivot = next - row[j + 1] * reciprocal * row[j + 1];
        }
        for (i, target) in (j + 1..).zip(below.chunks_exact_mut(width)) {
            subtract(simd, target, row[i] * reciprocal, row);
        }
        for row in row.chunks_exact_mut(LANES) {
            for window in Window::all(simd) {
                window.store_slice(row, window.load_slice(row) * reciprocal);
            }
        }
        row[j] = reciprocal;
    }
    true
}

/// Turns D⁻¹L⁻¹b into x.
#[inline(always)]
fn substitute_back(matrix: &SquareMatrix, b: &mut [f64]) {
    for i in (0..b.len()).rev() {
        let (unknown, solved) = b.split_at_mut(i);
        for (k, b) in unknown.iter_mut().enumerate() {
            *b -= matrix[(k, i)] * solved[0];
        }
    }
}

/// target −= factor · row.
#[inline(always)]
fn subtract<S: Arithmetic>(simd: S, target: &mut [f64], factor: f64, row: &[f64]) {
    for (target, row) in target.chunks_exact_mut(LANES).zip(row.chunks_exact(LANES)) {
        for window in Window::all(simd) {
            window.store_slice(target, window.load_slice(target) - window.load_slice(row) * factor);
        }
    }
}

/// Factorises a matrix with row pivoting; `false` when it is singular.
fn eliminate(matrix: &mut SquareMatrix, pivots: &mut [usize]) -> bool {
    let (n, width) = (matrix.size(), matrix.width());
    for column in 0..n {
        let magnitude = |row: usize| matrix[(row, column)].abs();
        let pivot =
            (column..n).fold(column, |best, row| if magnitude(row) > magnitude(best) { row } else { best });
        let largest = magnitude(pivot);
        if largest.is_nan() || largest == 0.0 {
            return false;
        }
        pivots[column] = pivot;
        matrix.swap_rows(column, pivot);
        let (pivot_row, below) = matrix.split_below(column);
        for row in below.chunks_exact_mut(width) {
            let factor = row[column] / pivot_row[column];
            row[column] = factor;
            for (value, pivot) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                *value -= factor * pivot;
            }
        }
    }
    true
}

/// Turns b into x with the factor of an elimination.
fn solve_eliminated(matrix: &SquareMatrix, pivots: &[usize], b: &mut [f64]) {
    for (row, &pivot) in pivots.iter().enumerate() {
        b.swap(row, pivot);
    }
    for i in 0..b.len() {
        b[i] -= dot(&matrix.row(i)[..i], &b[..i]);
    }
    for i in (0..b.len()).rev() {
        let sum = dot(&matrix.row(i)[i + 1..], &b[i + 1..]);
        b[i] = (b[i] - sum) / matrix[(i, i)];
    }
}

/// Solves A x = b by elimination, A row by row; b becomes x. `false` when A is singular. Allocates.
pub fn solve(a: &[f64], b: &mut [f64]) -> bool {
    let mut system = LinearSystem::new(false, b.len());
    system.matrix = SquareMatrix::from_rows(b.len(), a);
    system.solve(Arch::Scalar, b)
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve_cholesky(a: &[f64], b: &mut [f64]) -> bool {
        let mut system = LinearSystem::new(true, b.len());
        system.matrix = SquareMatrix::from_rows(b.len(), a);
        let again = &mut b.to_vec();
        let regular = system.solve(Arch::new(), b);
        if regular {
            system.solve_again(again);
            assert_eq!(b, again, "another right-hand side is solved with the same bits");
        }
        regular
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
        for n in [1, 5, 6, 7, 8, 9, 15, 16, 17, 23, 31, 39] {
            let (a, b) = sample(n);
            for solve in [solve_cholesky, solve] {
                let mut x = b.clone();
                assert!(solve(&a, &mut x));
                assert!(residual(&a, &x, &b) < 1e-14 * n as f64, "{n}");
            }
        }
    }

    #[test]
    fn without_unknowns_there_is_nothing_to_solve() {
        assert!(solve_cholesky(&[], &mut []) && solve(&[], &mut []));
    }

    #[test]
    fn elimination_pivots_past_a_zero_on_the_diagonal() {
        let mut x = [3.0, 5.0];
        assert!(solve(&[0.0, 1.0, 2.0, 0.0], &mut x));
        assert_eq!(x, [2.5, 3.0]);
    }

    #[test]
    fn indefinite_singular_and_nan_matrices_are_reported() {
        assert!(!solve_cholesky(&[1.0, 0.0, 0.0, -1.0], &mut [1.0, 1.0]));
        assert!(!solve_cholesky(&[f64::NAN, 0.0, 0.0, 1.0], &mut [1.0, 1.0]));
        assert!(!solve(&[1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
        assert!(!solve(&[f64::NAN], &mut [1.0]));
    }
}

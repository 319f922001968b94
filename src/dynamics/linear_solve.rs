//! Dense solves of the size of the equations of motion, without allocation.
//!
//! Matrices are row-major slices. nalgebra's factorisations take and give back owned storage, and its LU
//! allocates; the equations of motion are solved hundreds of times a second of flight.

use pulp::{Arch, Simd, WithSimd};

use crate::lanes::{LANES, Place};

/// The factor of a mass matrix.
#[derive(Clone, Debug)]
pub enum Factor {
    /// Of a symmetric one.
    Symmetric(Cholesky),
    /// Of any.
    General(Lu),
}

impl Factor {
    /// Room for the factor of n × n matrices.
    pub fn new(symmetric: bool, size: usize) -> Self {
        if symmetric { Factor::Symmetric(Cholesky::new(size)) } else { Factor::General(Lu::new(size)) }
    }

    /// Factorises A; `false` when it is singular, or not positive definite if it is to be symmetric.
    pub fn factorise(&mut self, arch: Arch, a: &[f64]) -> bool {
        match self {
            Factor::Symmetric(factor) => arch.dispatch(Factorise { factor, a }),
            Factor::General(factor) => factor.factorise(a),
        }
    }

    /// Turns b into the solution of A x = b.
    pub fn solve(&self, b: &mut [f64]) {
        match self {
            Factor::Symmetric(factor) => factor.solve(b),
            Factor::General(factor) => factor.solve(b),
        }
    }
}

struct Factorise<'a> {
    factor: &'a mut Cholesky,
    a: &'a [f64],
}

impl WithSimd for Factorise<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        self.factor.factorise(simd, self.a)
    }
}

/// Solves A x = b by elimination; b becomes x. `false` when A is singular. Allocates.
pub fn solve(a: &[f64], b: &mut [f64]) -> bool {
    let mut factor = Lu::new(b.len());
    let regular = factor.factorise(a);
    if regular {
        factor.solve(b);
    }
    regular
}

/// The factor of a symmetric positive definite A = LDLᵀ.
#[derive(Clone, Debug)]
pub struct Cholesky {
    size: usize,
    /// Rows of Lᵀ, each padded to whole groups of lanes; 1/D on the diagonal.
    rows: Vec<f64>,
}

impl Cholesky {
    /// Room for the factor of n × n matrices.
    pub fn new(size: usize) -> Self {
        Cholesky { size, rows: vec![0.0; size * size.next_multiple_of(LANES)] }
    }

    /// Factorises A, of which only the upper triangle is read; `false` when it is not positive definite.
    #[inline(always)]
    pub fn factorise<S: Simd>(&mut self, simd: S, a: &[f64]) -> bool {
        let n = self.size;
        if n == 0 {
            return true;
        }
        let width = n.next_multiple_of(LANES);
        for (row, a) in self.rows.chunks_exact_mut(width).zip(a.chunks_exact(n)) {
            row[..n].copy_from_slice(a);
        }
        for j in 0..n {
            let (row, below) = self.rows[j * width..].split_at_mut(width);
            if row[j].is_nan() || row[j] <= 0.0 {
                return false;
            }
            let reciprocal = 1.0 / row[j];
            for (i, target) in (j + 1..n).zip(below.chunks_exact_mut(width)) {
                let begin = i - i % LANES;
                let factor = row[i] * reciprocal;
                subtract(simd, &mut target[begin..], factor, &row[begin..]);
            }
            for entry in &mut row[j + 1..n] {
                *entry *= reciprocal;
            }
            row[j] = reciprocal;
        }
        true
    }

    /// Turns b into the solution of A x = b.
    pub fn solve(&self, b: &mut [f64]) {
        let n = self.size;
        let width = n.next_multiple_of(LANES);
        for (j, row) in self.rows.chunks_exact(width.max(1)).enumerate() {
            let solved = b[j];
            for (b, l) in b[j + 1..].iter_mut().zip(&row[j + 1..n]) {
                *b -= l * solved;
            }
            b[j] = solved * row[j];
        }
        for i in (0..n).rev() {
            let solved = b[i];
            for (b, row) in b[..i].iter_mut().zip(self.rows.chunks_exact(width)) {
                *b -= row[i] * solved;
            }
        }
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

/// The factor PA = LU of a regular matrix.
#[derive(Clone, Debug)]
pub struct Lu {
    /// U, and below it the multipliers of L.
    rows: Vec<f64>,
    /// The row with which each row was exchanged.
    pivots: Vec<usize>,
}

impl Lu {
    /// Room for the factor of n × n matrices.
    pub fn new(size: usize) -> Self {
        Lu { rows: vec![0.0; size * size], pivots: vec![0; size] }
    }

    /// Factorises A with row pivoting; `false` when it is singular.
    pub fn factorise(&mut self, a: &[f64]) -> bool {
        let n = self.pivots.len();
        let rows = &mut self.rows;
        rows.copy_from_slice(a);
        for column in 0..n {
            let magnitude = |row: usize| rows[row * n + column].abs();
            let pivot = (column..n)
                .fold(column, |best, row| if magnitude(row) > magnitude(best) { row } else { best });
            let largest = magnitude(pivot);
            if largest.is_nan() || largest == 0.0 {
                return false;
            }
            self.pivots[column] = pivot;
            if pivot != column {
                for k in 0..n {
                    rows.swap(column * n + k, pivot * n + k);
                }
            }
            let (above, below) = rows.split_at_mut((column + 1) * n);
            let pivot_row = &above[column * n..];
            for row in below.chunks_exact_mut(n) {
                let factor = row[column] / pivot_row[column];
                row[column] = factor;
                for (value, pivot) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                    *value -= factor * pivot;
                }
            }
        }
        true
    }

    /// Turns b into the solution of A x = b.
    pub fn solve(&self, b: &mut [f64]) {
        let n = self.pivots.len();
        for (row, &pivot) in self.pivots.iter().enumerate() {
            b.swap(row, pivot);
        }
        for i in 0..n {
            b[i] -= dot(&self.rows[i * n..i * n + i], &b[..i]);
        }
        for i in (0..n).rev() {
            let sum = dot(&self.rows[i * n + i + 1..(i + 1) * n], &b[i + 1..]);
            b[i] = (b[i] - sum) / self.rows[i * n + i];
        }
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve_cholesky(a: &[f64], b: &mut [f64]) -> bool {
        let mut factor = Factor::new(true, b.len());
        let regular = factor.factorise(Arch::new(), a);
        factor.solve(b);
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
        let (a, b) = sample(9);
        for solve in [solve_cholesky, solve] {
            let mut x = b.clone();
            assert!(solve(&a, &mut x));
            assert!(residual(&a, &x, &b) < 1e-13);
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

//! The real Schur form of a matrix with chosen roots first [theory: linearisation.balanced].
//!
//! A = Q T Qᵀ, T upper triangular but for blocks of two rows, which have pairs of complex roots. Neighbouring blocks change
//! places by a turn of their two or more rows (Bai and Demmel, *On swapping diagonal blocks in real Schur form*, Linear Algebra
//! and its Applications 186, 1993).

use nalgebra::{Complex, DMatrix, DMatrixView};

/// Relative size at which a subdiagonal entry is dropped, and larger ones where the iteration does not come to an end.
const DEFLATIONS: [f64; 4] = [1e-13, 1e-12, 1e-11, 1e-10];

/// Cap on the iterations, per row.
const MAX_ITERATIONS: usize = 30;

/// Q and T.
pub struct Schur {
    /// Orthogonal.
    pub q: DMatrix<f64>,
    pub t: DMatrix<f64>,
    pub blocks: Vec<Block>,
}

/// A diagonal block of T.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// Its first row.
    pub start: usize,
    /// 1 or 2.
    pub size: usize,
}

impl Schur {
    /// Of a square matrix; none where the iteration does not come to an end.
    pub fn of(matrix: &DMatrix<f64>) -> Option<Self> {
        let n = matrix.nrows();
        if n == 0 {
            return Some(Schur { q: matrix.clone(), t: matrix.clone(), blocks: Vec::new() });
        }
        let cap = MAX_ITERATIONS * n;
        let schur = |deflation| nalgebra::Schur::try_new(matrix.clone(), deflation, cap);
        let (q, mut t) = DEFLATIONS.into_iter().find_map(schur)?.unpack();
        let mut blocks = Vec::new();
        let mut start = 0;
        while start < n {
            let is_pair = start + 1 < n && t[(start + 1, start)] != 0.0;
            let size = if is_pair { 2 } else { 1 };
            t.view_mut((start + size, start), (n - start - size, size)).fill(0.0);
            blocks.push(Block { start, size });
            start += size;
        }
        Some(Schur { q, t, blocks })
    }

    /// Brings the blocks whose roots are chosen to the front; returns how many rows they have. None where two roots of which
    /// one is chosen are the same.
    pub fn order(&mut self, is_chosen: impl Fn(Complex<f64>) -> bool) -> Option<usize> {
        let (mut front, mut rows) = (0, 0);
        for place in 0..self.blocks.len() {
            let block = self.blocks[place];
            if !is_chosen(self.root(block)) {
                continue;
            }
            for before in (front..place).rev() {
                self.swap(before)?;
            }
            front += 1;
            rows += block.size;
        }
        Some(rows)
    }

    /// Y with which the first rows of T and the rest no longer act on each other: T₁₁ Y − Y T₂₂ = −T₁₂; the state is
    /// Q [[1, Y], [0, 1]] times that of the parts. None where both share a root.
    pub fn apart(&self, first: usize) -> Option<DMatrix<f64>> {
        let mut apart = DMatrix::zeros(first, self.t.nrows() - first);
        for Block { start, size } in self.blocks_from(first) {
            let here = first + start;
            let mut right = -self.t.view((0, here), (first, size));
            right.gemm(1.0, &apart.columns(0, start), &self.t.view((first, here), (start, size)), 1.0);
            let [one, other] =
                [(0, first), (here, size)].map(|(start, size)| self.t.view((start, start), (size, size)));
            apart.columns_mut(start, size).copy_from(&sylvester(one, other, &right)?);
        }
        Some(apart)
    }

    /// The blocks from a row on, which one begins, as they stand in that part of T.
    pub fn blocks_from(&self, first: usize) -> impl Iterator<Item = Block> {
        let blocks = self.blocks.iter().filter(move |block| block.start >= first);
        blocks.map(move |block| Block { start: block.start - first, ..*block })
    }

    /// The root of a block, of a pair the upper one.
    fn root(&self, Block { start, size }: Block) -> Complex<f64> {
        let entry = |row, column| self.t[(start + row, start + column)];
        if size == 1 {
            return Complex::new(entry(0, 0), 0.0);
        }
        let (mean, half) = (0.5 * (entry(0, 0) + entry(1, 1)), 0.5 * (entry(0, 0) - entry(1, 1)));
        let squared = half * half + entry(0, 1) * entry(1, 0);
        Complex::new(mean, (-squared).max(0.0).sqrt())
    }

    /// Has a block and the one behind it change places.
    fn swap(&mut self, place: usize) -> Option<()> {
        let [first, second] = [self.blocks[place], self.blocks[place + 1]];
        let (start, rows) = (first.start, first.size + second.size);
        let part = |row: usize, column: usize, rows, columns| {
            self.t.view((start + row, start + column), (rows, columns)).into_owned()
        };
        let (p, s) = (first.size, second.size);
        let (one, other, coupling) = (part(0, 0, p, p), part(p, p, s, s), part(0, p, p, s));
        // The columns of [X; 1] span what the second block's roots move in.
        let solution = sylvester(one.as_view(), other.as_view(), &-coupling)?;
        let mut basis = DMatrix::zeros(rows, rows);
        basis.view_mut((0, 0), (p, s)).copy_from(&solution);
        basis.view_mut((p, 0), (s, s)).fill_with_identity();
        basis.view_mut((0, s), (p, p)).fill_with_identity();
        let turn = basis.qr().q();
        let across = turn.transpose() * self.t.rows(start, rows);
        self.t.rows_mut(start, rows).copy_from(&across);
        for matrix in [&mut self.t, &mut self.q] {
            let along = matrix.columns(start, rows) * &turn;
            matrix.columns_mut(start, rows).copy_from(&along);
        }
        self.t.view_mut((start + s, start), (p, s)).fill(0.0);
        self.blocks[place] = Block { start, size: s };
        self.blocks[place + 1] = Block { start: start + s, size: p };
        Some(())
    }
}

/// X of A X − X B = C, of a few rows and columns; none where A and B share a root.
pub fn sylvester(a: DMatrixView<f64>, b: DMatrixView<f64>, c: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let (rows, columns) = c.shape();
    if c.is_empty() {
        return Some(c.clone());
    }
    if c.len() == 1 {
        let apart = a[(0, 0)] - b[(0, 0)];
        return (apart != 0.0).then(|| c / apart);
    }
    let mut equations = DMatrix::zeros(rows * columns, rows * columns);
    for column in 0..columns {
        for row in 0..rows {
            for other in 0..rows {
                equations[(column * rows + row, column * rows + other)] += a[(row, other)];
            }
            for other in 0..columns {
                equations[(column * rows + row, other * rows + row)] -= b[(other, column)];
            }
        }
    }
    let right = DMatrix::from_column_slice(rows * columns, 1, c.as_slice());
    let solution = equations.lu().solve(&right)?;
    Some(DMatrix::from_column_slice(rows, columns, solution.as_slice()))
}

/// Entries between −1 and 1 that have no pattern.
#[cfg(test)]
pub fn scattered(rows: usize, columns: usize, seed: f64) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |i, j| (1e4 * (seed + 1.7 * i as f64 + 31.3 * j as f64).sin()).sin())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chosen_roots_come_first_and_the_matrix_stays() {
        let matrix = scattered(14, 14, 0.3);
        let mut schur = Schur::of(&matrix).unwrap();
        let is_chosen = |root: Complex<f64>| root.norm() < 1.5;
        let chosen = schur.blocks.iter().filter(|block| is_chosen(schur.root(**block)));
        let expected: usize = chosen.map(|block| block.size).sum();
        assert!(
            schur.blocks.iter().any(|block| block.size == 2) && (2..14).contains(&expected),
            "{expected}"
        );
        assert!(!is_chosen(schur.root(schur.blocks[0])), "nothing is to be ordered");
        assert_eq!(schur.order(is_chosen), Some(expected));
        let Schur { q, t, blocks } = &schur;
        assert!((q * t * q.transpose() - &matrix).amax() < 1e-13);
        assert!((q.transpose() * q - DMatrix::identity(14, 14)).amax() < 1e-13);
        let rest = 14 - expected;
        let [one, other] =
            [(0, expected), (expected, rest)].map(|(start, size)| t.view((start, start), (size, size)));
        let y = schur.apart(expected).unwrap();
        let apart = one * &y - &y * other + t.view((0, expected), (expected, rest));
        assert!(apart.amax() < 1e-12 * y.amax().max(1.0));
        for block in blocks {
            assert_eq!(is_chosen(schur.root(*block)), block.start < expected);
            let below =
                t.view((block.start + block.size, block.start), (14 - block.start - block.size, block.size));
            assert_eq!(below.amax(), 0.0);
        }
    }

    #[test]
    fn a_root_that_is_on_both_sides_is_none() {
        let [a, c] = [scattered(3, 3, 0.1), scattered(3, 2, 0.2)];
        let b = scattered(2, 2, 0.7);
        let x = sylvester(a.as_view(), b.as_view(), &c).unwrap();
        assert!((&a * &x - &x * &b - &c).amax() < 1e-13);
        let twice = DMatrix::identity(2, 2) * 3.0;
        assert_eq!(sylvester(twice.as_view(), twice.as_view(), &DMatrix::identity(2, 2)), None);
    }
}

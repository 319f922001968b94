//! Square matrices of the size of the equations of motion, row by row, ready for wide vectors.

use std::ops::{Index, IndexMut};

use super::arithmetic::Arithmetic;
use super::lanes::{AlignedNumbers, LANES, Window, zeros};

/// Rows and columns that there are at least beyond the matrix, for blocks and right-hand sides that reach over its edge.
pub const SPARE: usize = 2;

/// A square matrix. Rows are whole groups of lanes; what stands beyond the matrix has no meaning.
#[derive(Clone, Debug)]
pub struct SquareMatrix {
    size: usize,
    width: usize,
    numbers: AlignedNumbers,
}

impl SquareMatrix {
    /// Zeros.
    pub fn new(size: usize) -> Self {
        let width = (size + SPARE).next_multiple_of(LANES);
        SquareMatrix { size, width, numbers: zeros((size + SPARE) * width) }
    }

    /// From entries row by row.
    pub fn from_rows(size: usize, entries: &[f64]) -> Self {
        let mut matrix = SquareMatrix::new(size);
        for (row, entries) in entries.chunks_exact(size.max(1)).enumerate() {
            matrix.row_mut(row)[..size].copy_from_slice(entries);
        }
        matrix
    }

    /// Number of rows and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Length of a row with what stands beyond the matrix.
    pub fn width(&self) -> usize {
        self.width
    }

    /// A row with what stands beyond the matrix.
    #[inline(always)]
    pub fn row(&self, row: usize) -> &[f64] {
        &self.numbers[row * self.width..][..self.width]
    }

    /// A row with what stands beyond the matrix, to be changed.
    #[inline(always)]
    pub fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.numbers[row * self.width..][..self.width]
    }

    /// A row with what stands beyond the matrix, and the numbers of all rows below it.
    #[inline(always)]
    pub fn split_below(&mut self, row: usize) -> (&mut [f64], &mut [f64]) {
        let begin = row * self.width;
        let end = self.size * self.width;
        self.numbers[begin..end].split_at_mut(self.width)
    }

    /// The numbers of all rows, one row after the other.
    #[inline(always)]
    pub fn rows_mut(&mut self) -> &mut [f64] {
        &mut self.numbers[..self.size * self.width]
    }

    /// Exchanges two rows.
    pub fn swap_rows(&mut self, row: usize, other: usize) {
        for column in 0..self.width {
            self.numbers.swap(row * self.width + column, other * self.width + column);
        }
    }

    /// Becomes a copy of another of the same size.
    #[inline(always)]
    pub fn copy_from(&mut self, other: &Self) {
        self.numbers.copy_from_slice(&other.numbers);
    }

    /// Adds another of the same size times a factor.
    #[inline(always)]
    pub fn add_scaled<S: Arithmetic>(&mut self, simd: S, factor: f64, other: &Self) {
        let eights = other.numbers.chunks_exact(LANES);
        for (sum, other) in self.numbers.chunks_exact_mut(LANES).zip(eights) {
            for window in Window::all(simd) {
                window.store_slice(sum, window.load_slice(sum) + window.load_slice(other) * factor);
            }
        }
    }
}

impl Index<(usize, usize)> for SquareMatrix {
    type Output = f64;

    #[inline(always)]
    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        &self.numbers[row * self.width + column]
    }
}

impl IndexMut<(usize, usize)> for SquareMatrix {
    #[inline(always)]
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut f64 {
        &mut self.numbers[row * self.width + column]
    }
}

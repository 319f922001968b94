//! Constant matrices that are multiplied with many vectors, eight rows at a time.
//!
//! Each sum is [`CHAINS`] sums, each of every fourth column that is kept (what then remains goes to the first), added in
//! the end: additions need not wait for each other, and the bits are the same at any width of the machine's vectors.

use super::arithmetic::Arithmetic;
use super::lanes::{Eight, LANES, Window};

/// How many sums run side by side.
const CHAINS: usize = 4;

/// A constant matrix: rows in groups of eight, and of each group the columns that are not all zero there.
#[derive(Clone, Debug)]
pub struct Columns {
    rows: usize,
    /// For each group of rows, where its columns end.
    ends: Vec<usize>,
    columns: Vec<usize>,
    entries: Vec<Eight>,
}

impl Columns {
    /// From the matrix' entries by row and column.
    pub fn new(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut matrix = Columns { rows, ends: Vec::new(), columns: Vec::new(), entries: Vec::new() };
        for first in (0..rows).step_by(LANES) {
            for column in 0..columns {
                let row_entry =
                    |lane: usize| if first + lane < rows { entry(first + lane, column) } else { 0.0 };
                let eight = Eight(std::array::from_fn(row_entry));
                if eight != Eight::ZERO {
                    matrix.columns.push(column);
                    matrix.entries.push(eight);
                }
            }
            matrix.ends.push(matrix.columns.len());
        }
        matrix
    }

    /// Multiplies all entries by a factor.
    pub fn scale(&mut self, factor: f64) {
        self.entries.iter_mut().flat_map(|Eight(entries)| entries).for_each(|entry| *entry *= factor);
    }

    /// Length of a product: the number of rows, filled up to whole groups.
    pub fn room(&self) -> usize {
        self.rows.next_multiple_of(LANES)
    }

    /// How many groups of eight entries are kept.
    #[cfg(test)]
    pub fn kept(&self) -> usize {
        self.entries.len()
    }

    /// product = matrix · vector, as far as `product` has [room](Self::room).
    #[inline(always)]
    pub fn times<S: Arithmetic>(&self, simd: S, vector: &[f64], product: &mut [f64]) {
        let mut begin = 0;
        for (product, &end) in product.chunks_exact_mut(LANES).zip(&self.ends) {
            let (columns, entries) = (&self.columns[begin..end], &self.entries[begin..end]);
            for window in Window::all(simd) {
                let mut sums = [window.splat(0.0); CHAINS];
                let (columns, last_columns) = columns.as_chunks::<CHAINS>();
                let (entries, last_entries) = entries.as_chunks::<CHAINS>();
                for (columns, entries) in columns.iter().zip(entries) {
                    for chain in 0..CHAINS {
                        sums[chain] += window.load(&entries[chain]) * vector[columns[chain]];
                    }
                }
                let [mut first, second, third, fourth] = sums;
                for (&column, entries) in last_columns.iter().zip(last_entries) {
                    first += window.load(entries) * vector[column];
                }
                window.store_slice(product, (first + second) + (third + fourth));
            }
            begin = end;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::math::Counting;

    #[test]
    fn the_product_is_that_of_the_matrix_and_zero_columns_are_left_out() {
        let entry = |row: usize, column: usize| {
            if column == 2 { 0.0 } else { (1 + row) as f64 - 0.1 * (column * column) as f64 }
        };
        let matrix = Columns::new(11, 11, entry);
        assert_eq!((matrix.room(), matrix.kept()), (16, 20));
        let counted = Cell::new(0);
        matrix.times(Counting { multiplications: &counted }, &[1.0; 11], &mut vec![0.0; matrix.room()]);
        assert_eq!(counted.get(), 20 * LANES);
        let vector = [0.3, -1.0, 7.0, 2.0, 0.1, -0.2, 0.05, 0.4, -0.3, 0.02, 0.6];
        let mut product = vec![f64::NAN; matrix.room()];
        matrix.times(pulp::Scalar::new(), &vector, &mut product);
        for (row, product) in product.into_iter().enumerate() {
            let expected: f64 =
                if row < 11 { (0..11).map(|column| entry(row, column) * vector[column]).sum() } else { 0.0 };
            assert!((product - expected).abs() < 1e-13, "{row}");
        }
    }
}

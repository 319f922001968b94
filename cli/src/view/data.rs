//! The numbers of a page as bytes, little-endian, and what the scene says of them.

use serde_json::{Value, json};

use super::low_rank::{LowRank, Rounded};

/// Where blocks begin, in bytes.
const BLOCK: usize = 4;

/// All numbers of a page, block after block.
#[derive(Debug, Default)]
pub struct Data {
    pub bytes: Vec<u8>,
}

impl Data {
    /// Adds a matrix, so many values a row, whose columns are each right to a tolerance; says where it is.
    pub fn matrix(&mut self, values: &[f64], tolerances: &[f64]) -> Value {
        let LowRank { rows, mean, terms } = LowRank::of(values, tolerances);
        let shapes: Vec<&Rounded> = terms.iter().map(|term| &term.shape).collect();
        let coefficients: Vec<&Rounded> = terms.iter().map(|term| &term.coefficients).collect();
        let scales = |rounded: &[&Rounded]| rounded.iter().map(|one| one.scale).collect::<Vec<_>>();
        let by_row = (0..rows).flat_map(|row| coefficients.iter().map(move |one| one.numbers[row]));
        json!({
            "rows": rows,
            "columns": mean.len(),
            "rank": terms.len(),
            "mean": self.block(mean.iter().flat_map(|number| number.to_le_bytes())),
            "basis": self.block(shapes.iter().flat_map(|one| &one.numbers).flat_map(|number| number.to_le_bytes())),
            "basisScale": scales(&shapes),
            "coefficients": self.block(by_row.flat_map(i16::to_le_bytes)),
            "coefficientScale": scales(&coefficients),
        })
    }

    /// Adds a block; where it begins.
    fn block(&mut self, bytes: impl Iterator<Item = u8>) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(BLOCK), 0);
        let begin = self.bytes.len();
        self.bytes.extend(bytes);
        begin
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the page reads it.
    #[test]
    fn a_matrix_is_read_back_from_its_bytes() {
        let values = [0.0, 1.0, 2.0, 0.5, -1.0, 7.0];
        let mut data = Data::default();
        data.block([1_u8].into_iter());
        let matrix = data.matrix(&values, &[1e-4; 3]);
        let number = |name: &str| matrix[name].as_u64().unwrap() as usize;
        let (columns, rank) = (number("columns"), number("rank"));
        assert_eq!((number("rows"), columns), (2, 3));
        let word = |begin: usize, place: usize| {
            let bytes = &data.bytes[begin + 2 * place..][..2];
            f64::from(i16::from_le_bytes([bytes[0], bytes[1]]))
        };
        for (place, value) in values.iter().enumerate() {
            let (row, column) = (place / columns, place % columns);
            let mean = &data.bytes[number("mean") + 4 * column..][..4];
            let mut told = f64::from(f32::from_le_bytes([mean[0], mean[1], mean[2], mean[3]]));
            for term in 0..rank {
                let scale = |name: &str| matrix[name][term].as_f64().unwrap();
                told += word(number("coefficients"), row * rank + term)
                    * scale("coefficientScale")
                    * word(number("basis"), term * columns + column)
                    * scale("basisScale");
            }
            assert!((told - value).abs() < 1e-4, "{told} {value}");
        }
        assert!(["mean", "basis", "coefficients"].into_iter().all(|name| number(name).is_multiple_of(4)));
    }
}

//! How large numbers are, and how much alike.

/// What differs by less than this share differs by rounding alone: that of an angle up to 2π, of its sine and cosine as
/// another program computes them, and of products with them.
pub const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The largest magnitude, 0 of none; not-a-number is passed over.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0_f64, |largest, value| largest.max(value.abs()))
}

/// Whether two numbers differ by no more than a share of the larger one.
pub fn are_alike(a: f64, b: f64, share: f64) -> bool {
    (a - b).abs() <= share * a.abs().max(b.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn likeness_is_a_share_of_the_larger_number_whatever_the_signs() {
        assert!(are_alike(0.0, 0.0, 1e-9) && are_alike(-3.0, -3.0 - 2e-9, 1e-9));
        assert!(
            !are_alike(3.0, 3.0 + 4e-9, 1e-9) && !are_alike(1.0, -1.0, 1e-9) && !are_alike(0.0, 1e-300, 1e-9)
        );
        assert_eq!((largest([]), largest([1.0, -2.0, f64::NAN])), (0.0, 2.0));
    }
}

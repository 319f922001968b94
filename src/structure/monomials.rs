//! Homogeneous polynomials of modes: each distinct monomial once, in lexicographic order [theory: strain-energy.packed].

use nalgebra::DMatrix;

/// The coefficients of those monomials of n modes whose modes are all among the chosen (ascending) ones.
pub(super) fn chosen_coefficients<const DEGREE: usize>(
    coefficients: &[f64],
    n: usize,
    chosen: &[usize],
) -> Vec<f64> {
    if coefficients.is_empty() {
        return Vec::new();
    }
    let tuples = ascending_tuples::<DEGREE>(chosen.len());
    tuples.map(|tuple| coefficients[rank(tuple.map(|place| chosen[place]), n)]).collect()
}

/// The coefficients of a homogeneous polynomial of modes as one of coordinates with such shares in them, a column each.
///
/// With x = S z that of z_a z_b … is the derivative along the columns a, b, … of S, over the orders of equal ones.
pub(super) fn combined_coefficients(coefficients: &[f64], degree: usize, shares: &DMatrix<f64>) -> Vec<f64> {
    let mut combined = Vec::with_capacity(monomials(shares.ncols(), degree));
    if !coefficients.is_empty() {
        push_derivatives(coefficients, degree, shares, (0, 0.0), &mut combined);
    }
    combined
}

/// Appends the derivatives of a polynomial along all columns from the last one on, which `times` derivatives were taken
/// along already, each by one index after the other.
fn push_derivatives(
    coefficients: &[f64],
    degree: usize,
    shares: &DMatrix<f64>,
    (last, times): (usize, f64),
    combined: &mut Vec<f64>,
) {
    if degree == 0 {
        combined.extend_from_slice(coefficients);
        return;
    }
    let mut slope = vec![0.0; monomials(shares.nrows(), degree - 1)];
    for column in last..shares.ncols() {
        let equal = if column == last { times + 1.0 } else { 1.0 };
        slope.fill(0.0);
        add_slope(coefficients, degree, shares.column(column).as_slice(), &mut slope);
        slope.iter_mut().for_each(|coefficient| *coefficient /= equal);
        push_derivatives(&slope, degree - 1, shares, (column, equal), combined);
    }
}

/// Adds the derivative of a polynomial along a direction.
///
/// The polynomial is Σ x_a P_a, where P_a has the variables from a on: its derivative Σ s_a P_a + x_a P_a′. In lexicographic
/// order P_a stands in one piece in the polynomial, and again in one piece in the derivative.
fn add_slope(coefficients: &[f64], degree: usize, direction: &[f64], slope: &mut [f64]) {
    if degree == 1 {
        slope[0] += coefficients.iter().zip(direction).map(|(c, s)| c * s).sum::<f64>();
        return;
    }
    let (mut coefficients, mut slope) = (coefficients, slope);
    for first in 0..direction.len() {
        let left = direction.len() - first;
        let (part, others) = coefficients.split_at(monomials(left, degree - 1));
        if direction[first] != 0.0 {
            slope.iter_mut().zip(part).for_each(|(sum, c)| *sum += direction[first] * c);
        }
        let (own, after) = slope.split_at_mut(monomials(left, degree - 2));
        add_slope(part, degree - 1, &direction[first..], own);
        (coefficients, slope) = (others, after);
    }
}

/// How many ascending tuples stand before one in lexicographic order.
pub(super) fn rank<const DEGREE: usize>(tuple: [usize; DEGREE], n: usize) -> usize {
    let mut before = 0;
    let mut least = 0;
    for (place, &index) in tuple.iter().enumerate() {
        // Those that agree up to here and go on with less.
        before += monomials(n - least, DEGREE - place) - monomials(n - index, DEGREE - place);
        least = index;
    }
    before
}

/// Number of distinct monomials of a degree in n variables.
pub(super) fn monomials(n: usize, degree: usize) -> usize {
    (0..degree).fold(1, |product, k| product * (n + k) / (k + 1))
}

/// All ascending index tuples a ≤ b ≤ … < n, in lexicographic order.
pub(super) fn ascending_tuples<const DEGREE: usize>(n: usize) -> impl Iterator<Item = [usize; DEGREE]> {
    std::iter::successors((n > 0).then_some([0; DEGREE]), move |tuple| {
        let place = (0..DEGREE).rev().find(|&place| tuple[place] + 1 < n)?;
        let mut next = *tuple;
        next[place..].fill(tuple[place] + 1);
        Some(next)
    })
}

/// Number of distinct orders of the indices of an ascending tuple.
pub(super) fn permutations(tuple: &[usize]) -> f64 {
    let mut orders = 1.0;
    let mut run = 0.0;
    for (place, index) in tuple.iter().enumerate() {
        run = if place > 0 && tuple[place - 1] == *index { run + 1.0 } else { 1.0 };
        orders *= (place + 1) as f64 / run;
    }
    orders
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn monomials_are_found_by_their_rank() {
        for n in 1..7 {
            assert_eq!(ascending_tuples::<4>(n).count(), monomials(n, 4));
            assert!(ascending_tuples::<3>(n).enumerate().all(|(place, tuple)| rank(tuple, n) == place));
            assert!(ascending_tuples::<4>(n).enumerate().all(|(place, tuple)| rank(tuple, n) == place));
        }
    }

    /// All terms of a polynomial.
    fn value<const DEGREE: usize>(coefficients: &[f64], x: &[f64]) -> f64 {
        let terms = ascending_tuples::<DEGREE>(x.len()).zip(coefficients);
        terms.map(|(tuple, c)| c * tuple.map(|index| x[index]).iter().product::<f64>()).sum()
    }

    #[test]
    fn combined_coordinates_have_the_value_of_what_they_combine() {
        let number = |seed: usize| libm::sin(1.0 + 3.7 * seed as f64);
        let coefficients: Vec<f64> = (0..monomials(5, 4)).map(number).collect();
        // Of three coordinates the first is one mode alone.
        let shares = DMatrix::from_fn(5, 3, |row, column| match (row, column) {
            (1, 0) => 1.0,
            (_, 0) => 0.0,
            (row, column) => number(10 * row + column),
        });
        let combined = combined_coefficients(&coefficients, 4, &shares);
        let z = [0.7, -1.3, 0.4];
        let x = &shares * nalgebra::DVector::from_column_slice(&z);
        let (found, expected) = (value::<4>(&combined, &z), value::<4>(&coefficients, x.as_slice()));
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        let single =
            |column| combined_coefficients(&coefficients, 4, &shares.columns(column, 1).into_owned());
        assert_eq!(combined[0], single(0)[0]);
        assert_eq!(single(0)[0], coefficients[rank([1, 1, 1, 1], 5)]);
    }

    #[test]
    fn distinct_orders_are_counted() {
        assert_eq!(permutations(&[0, 1, 2]), 6.0);
        assert_eq!(permutations(&[0, 0, 2]), 3.0);
        assert_eq!(permutations(&[1, 1, 2, 2]), 6.0);
        assert_eq!(permutations(&[0, 1, 2, 3]), 24.0);
        assert_eq!(permutations(&[3, 3, 3, 3]), 1.0);
    }
}

//! Homogeneous polynomials of modes: each distinct monomial once, in lexicographic order [theory: strain-energy.packed].

use nalgebra::DMatrix;

/// The coefficients of those monomials of n modes whose modes are all among the chosen (ascending) ones.
pub(super) fn chosen_coefficients<const DEGREE: usize>(
    coefficients: &[f64],
    n: usize,
    chosen: &[usize],
) -> Vec<f64> {
    let tuples = ascending_tuples::<DEGREE>(chosen.len());
    tuples.map(|tuple| coefficients[rank(tuple.map(|place| chosen[place]), n)]).collect()
}

/// The coefficients of a homogeneous polynomial of modes, given by its terms, as one of coordinates with such shares in them.
pub(super) fn combined_coefficients<const DEGREE: usize>(
    terms: impl Iterator<Item = ([usize; DEGREE], f64)>,
    shares: &DMatrix<f64>,
) -> Vec<f64> {
    let n = shares.ncols();
    let taking: Vec<Vec<(usize, f64)>> = shares
        .row_iter()
        .map(|row| row.iter().copied().enumerate().filter(|(_, share)| *share != 0.0).collect())
        .collect();
    let mut coefficients = vec![0.0; monomials(n, DEGREE)];
    for (modes, coefficient) in terms.filter(|(_, coefficient)| *coefficient != 0.0) {
        // Each mode of the monomial is a sum over coordinates: the product of these sums, term by term.
        let mut products = vec![([0; DEGREE], coefficient)];
        for (place, &mode) in modes.iter().enumerate() {
            let longer = products.iter().flat_map(|&(tuple, product)| {
                taking[mode].iter().map(move |&(coordinate, share)| {
                    let mut tuple = tuple;
                    tuple[place] = coordinate;
                    (tuple, product * share)
                })
            });
            products = longer.collect();
        }
        for (mut tuple, product) in products {
            tuple.sort_unstable();
            coefficients[rank(tuple, n)] += product;
        }
    }
    coefficients
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

    #[test]
    fn distinct_orders_are_counted() {
        assert_eq!(permutations(&[0, 1, 2]), 6.0);
        assert_eq!(permutations(&[0, 0, 2]), 3.0);
        assert_eq!(permutations(&[1, 1, 2, 2]), 6.0);
        assert_eq!(permutations(&[0, 1, 2, 3]), 24.0);
        assert_eq!(permutations(&[3, 3, 3, 3]), 1.0);
    }
}

//! The strain energy's cubic and quartic terms, arranged for evaluation in every step [3.2; physics.md §3].
//!
//! With the products p_ab = q_a q_b (a ≤ b), U₃ = Σ q_a k p_bc and U₄ = Σ p_ab k p_cd: each row of coefficients
//! stands beside a block of products, and value and gradient come from one sweep,
//! s = ∂U/∂p then ∂U/∂q_a += Σ (1 + δ_ab) s_ab q_b. On an airframe with a mirror plane every monomial with an odd
//! number of antisymmetric modes vanishes; products are ordered by parity, and blocks without coefficients are left out.

use pulp::{Arch, Simd, WithSimd};

use crate::lanes::{Eight, LANES, Place};

use super::StrainEnergy;
use super::reduced::ModeFamily;

/// Coefficients of eight neighbouring products.
#[derive(Clone, Debug)]
struct Block {
    /// Which eight.
    products: usize,
    coefficients: Eight,
}

/// The monomials that one factor has in common.
#[derive(Clone, Debug)]
struct Row {
    /// Index of the factor: a mode of U₃, a product of U₄.
    factor: usize,
    blocks: Vec<Block>,
}

/// U₃ and U₄ of a choice of modes.
#[derive(Clone, Debug)]
pub struct StrainPolynomial {
    /// a and b of each product in use, with its place.
    pairs: Vec<(usize, [usize; 2])>,
    /// Number of blocks of products.
    blocks: usize,
    cubic: Vec<Row>,
    quartic: Vec<Row>,
    /// How wide this machine's vectors are.
    pub(crate) arch: Arch,
}

/// Scratch memory: the products and the slopes of the energy over them.
#[derive(Clone, Debug)]
pub struct PairProducts {
    products: Vec<Eight>,
    slopes: Vec<Eight>,
}

impl StrainPolynomial {
    /// Arranges the coefficients; terms of third and of fourth order are kept as asked.
    pub fn new(energy: &StrainEnergy, families: &[ModeFamily], cubic: bool, quartic: bool) -> Self {
        let odd = |modes: &[usize]| {
            modes.iter().filter(|&&mode| families[mode] == ModeFamily::Antisymmetric).count() % 2 == 1
        };
        let n = families.len();
        let all = || (0..n).flat_map(move |a| (a..n).map(move |b| [a, b]));
        let mut pairs: Vec<(usize, [usize; 2])> = Vec::new();
        let mut blocks = 0;
        for parity in [false, true] {
            let class: Vec<_> = all().filter(|pair| odd(pair) == parity).collect();
            pairs.extend(class.iter().enumerate().map(|(i, &pair)| (blocks * LANES + i, pair)));
            blocks += class.len().div_ceil(LANES);
        }
        let mut place = vec![0; n * n];
        for &(index, [a, b]) in &pairs {
            place[a * n + b] = index;
        }
        let mut polynomial = StrainPolynomial {
            pairs,
            blocks,
            cubic: (0..n).map(|factor| Row { factor, blocks: Vec::new() }).collect(),
            quartic: all().map(|[a, b]| Row { factor: place[a * n + b], blocks: Vec::new() }).collect(),
            arch: Arch::new(),
        };
        // Rows before those of a: n + (n − 1) + … of them, one for each pair.
        let row_of = |a: usize, b: usize| a * (2 * n + 1 - a) / 2 + b - a;
        if cubic {
            for ([a, b, c], coefficient) in energy.cubic_terms().filter(|(modes, _)| !odd(modes)) {
                polynomial.cubic[a].add(place[b * n + c], coefficient);
            }
        }
        if quartic {
            for ([a, b, c, d], coefficient) in energy.quartic_terms().filter(|(modes, _)| !odd(modes)) {
                polynomial.quartic[row_of(a, b)].add(place[c * n + d], coefficient);
            }
        }
        polynomial
    }

    /// Room for the products.
    pub fn pair_products(&self) -> PairProducts {
        let zeros = vec![Eight::ZERO; self.blocks];
        PairProducts { products: zeros.clone(), slopes: zeros }
    }

    /// U₃ + U₄ at q, J at nominal stiffness, with the gradient added to `gradient`.
    pub fn add(&self, q: &[f64], gradient: &mut [f64], scratch: &mut PairProducts) -> f64 {
        self.arch.dispatch(Sweep { polynomial: self, q, gradient, scratch })
    }
}

impl Row {
    fn add(&mut self, product: usize, coefficient: f64) {
        let (products, lane) = (product / LANES, product % LANES);
        let place = self.blocks.iter().rposition(|block| block.products == products).unwrap_or_else(|| {
            self.blocks.push(Block { products, coefficients: Eight::ZERO });
            self.blocks.len() - 1
        });
        self.blocks[place].coefficients.0[lane] += coefficient;
    }
}

/// One evaluation.
struct Sweep<'a> {
    polynomial: &'a StrainPolynomial,
    q: &'a [f64],
    gradient: &'a mut [f64],
    scratch: &'a mut PairProducts,
}

impl WithSimd for Sweep<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let Sweep { polynomial: StrainPolynomial { pairs, cubic, quartic, .. }, q, gradient, scratch } = self;
        let PairProducts { products, slopes } = scratch;
        for &(index, [a, b]) in pairs {
            products[index / LANES].0[index % LANES] = q[a] * q[b];
        }
        slopes.fill(Eight::ZERO);
        let mut value = 0.0;
        for row in cubic {
            let sum = sweep(simd, row, q[row.factor], products, slopes);
            gradient[row.factor] += sum;
            value += q[row.factor] * sum;
        }
        for row in quartic {
            let (block, lane) = (row.factor / LANES, row.factor % LANES);
            let factor = products[block].0[lane];
            let sum = sweep(simd, row, factor, products, slopes);
            slopes[block].0[lane] += sum;
            value += factor * sum;
        }
        for &(index, [a, b]) in pairs {
            let slope = slopes[index / LANES].0[index % LANES];
            gradient[a] += slope * q[b];
            gradient[b] += slope * q[a];
        }
        value
    }
}

/// One row: adds `factor` times its coefficients to the slopes and returns their product with the products.
#[inline(always)]
fn sweep<S: Simd>(simd: S, row: &Row, factor: f64, products: &[Eight], slopes: &mut [Eight]) -> f64 {
    let mut sums = Eight::ZERO;
    for place in Place::all(simd) {
        let mut sum = place.splat(0.0);
        for Block { products: block, coefficients } in &row.blocks {
            let coefficients = place.load(coefficients);
            sum += coefficients * place.load(&products[*block]);
            let slope = place.load(&slopes[*block]) + coefficients * factor;
            place.store(&mut slopes[*block], slope);
        }
        place.store(&mut sums, sum);
    }
    sums.sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::tests::jet;

    #[test]
    fn the_fast_form_agrees_with_the_plain_one_to_rounding() {
        let model = jet();
        let n = model.modes.len();
        let families: Vec<_> = model.modes.iter().map(|mode| mode.family).collect();
        let q: Vec<f64> = (0..n).map(|mode| 30.0 * libm::sin(1.0 + mode as f64)).collect();
        for (cubic, quartic) in [(true, false), (false, true), (true, true)] {
            let polynomial = StrainPolynomial::new(&model.strain_energy, &families, cubic, quartic);
            let (mut fast, mut plain) = (vec![0.0; n], vec![0.0; n]);
            let value = polynomial.add(&q, &mut fast, &mut polynomial.pair_products());
            let mut expected = 0.0;
            if cubic {
                expected += model.strain_energy.add_cubic(&q, &mut plain);
            }
            if quartic {
                expected += model.strain_energy.add_quartic(&q, &mut plain);
            }
            let largest = plain.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            assert!((value - expected).abs() < 1e-12 * expected.abs(), "{value} {expected}");
            assert!(fast.iter().zip(&plain).all(|(fast, plain)| (fast - plain).abs() < 1e-12 * largest));
        }
    }

    #[test]
    fn monomials_that_symmetry_forbids_have_no_block() {
        let model = jet();
        let families: Vec<_> = model.modes.iter().map(|mode| mode.family).collect();
        let unsymmetric = vec![ModeFamily::Unsymmetric; families.len()];
        let blocks = |families: &[ModeFamily]| {
            let polynomial = StrainPolynomial::new(&model.strain_energy, families, true, true);
            polynomial.quartic.iter().map(|row| row.blocks.len()).sum::<usize>()
        };
        assert!(10 * blocks(&families) < 6 * blocks(&unsymmetric));
    }
}

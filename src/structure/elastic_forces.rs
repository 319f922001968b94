//! ∂U/∂q arranged for evaluation in every step [theory: strain-energy.packed; thesis eq. 2.5].
//!
//! With the products p_ab = q_a q_b (a ≤ b) all of it is one product of a constant matrix with the vector [q; p]:
//!
//! ```text
//! ∂U/∂q_a = (K₀ q + D p)_a + Σ_b S_ab q_b,      S = F p,
//! ```
//!
//! where D has the coefficients of U₃ and the self-adjoint S those of U₄, a third of ½K₂ each way. On an airframe with a
//! mirror plane every monomial with an odd number of antisymmetric modes vanishes: rows are ordered by parity, and
//! [`Columns`] leaves out what is zero. The plain form is [`StrainEnergy`].

use crate::math::{AlignedNumbers, Arithmetic, Columns, LANES, zeros};

use super::StrainEnergy;
use super::mode::ModeFamily;

/// The elastic generalised forces of a choice of modes, with the opposite sign: ∂U/∂q.
///
/// [theory: strain-energy.force, strain-energy.tensors]
#[derive(Clone, Debug)]
pub struct ElasticForces {
    /// a and b of each product, in the order of the vector's second part.
    pairs: Vec<[usize; 2]>,
    /// Row of each mode.
    mode_rows: Vec<usize>,
    /// Row of S_ab for each a and b; empty without U₄.
    stiffness_rows: Vec<usize>,
    /// [K₀ D; 0 F].
    matrix: Columns,
}

/// Scratch memory: the vector [q; p] and the product of the matrix with it.
#[derive(Clone, Debug)]
pub struct ElasticScratch {
    vector: Vec<f64>,
    product: AlignedNumbers,
}

/// What a row of the matrix belongs to.
#[derive(Clone, Copy, PartialEq)]
enum Row {
    Mode(usize),
    Pair(usize),
    /// Fills a group of rows up.
    Empty,
}

impl ElasticForces {
    /// Arranges the coefficients of U times `scale`; terms of third and of fourth order are kept as asked.
    pub fn new(
        energy: &StrainEnergy,
        families: &[ModeFamily],
        scale: f64,
        cubic: bool,
        quartic: bool,
    ) -> Self {
        let is_odd = |modes: &[usize]| {
            modes.iter().filter(|&&mode| families[mode] == ModeFamily::Antisymmetric).count() % 2 == 1
        };
        let n = families.len();
        let pairs: Vec<[usize; 2]> = if cubic || quartic {
            (0..n).flat_map(|a| (a..n).map(move |b| [a, b])).collect()
        } else {
            Vec::new()
        };
        let mut rows = Vec::new();
        for parity in [false, true] {
            rows.extend((0..n).filter(|&mode| is_odd(&[mode]) == parity).map(Row::Mode));
            let quartic_pairs = if quartic { pairs.len() } else { 0 };
            rows.extend((0..quartic_pairs).filter(|&pair| is_odd(&pairs[pair]) == parity).map(Row::Pair));
            rows.resize(rows.len().next_multiple_of(LANES), Row::Empty);
        }
        // PROOF: every mode, and with U₄ every pair, is in one of the two parities.
        let place = |row: Row| rows.iter().position(|&other| other == row).expect("a row for each");
        let mode_rows: Vec<usize> = (0..n).map(|mode| place(Row::Mode(mode))).collect();

        let width = n + pairs.len();
        let mut entries = vec![0.0; rows.len() * width];
        // Pairs before those of a: n + (n − 1) + … of them.
        let pair_of = |a: usize, b: usize| {
            let (a, b) = (a.min(b), a.max(b));
            a * (2 * n + 1 - a) / 2 + b - a
        };
        let pair_rows: Vec<usize> =
            (0..if quartic { pairs.len() } else { 0 }).map(|pair| place(Row::Pair(pair))).collect();
        let mut add = |row: usize, column: usize, coefficient: f64| {
            entries[row * width + column] += scale * coefficient;
        };
        for (a, &row) in mode_rows.iter().enumerate() {
            for b in (0..n).filter(|&b| is_odd(&[a]) == is_odd(&[b])) {
                add(row, b, energy.linear_stiffness[a * n + b]);
            }
        }
        for ([a, b, c], coefficient) in energy.cubic_terms().filter(|(modes, _)| cubic && !is_odd(modes)) {
            for [one, other, another] in [[a, b, c], [b, c, a], [c, a, b]] {
                add(mode_rows[one], n + pair_of(other, another), coefficient);
            }
        }
        for (modes, coefficient) in energy.quartic_terms().filter(|(modes, _)| quartic && !is_odd(modes)) {
            for [i, j, k, l] in SPLITS {
                if modes[i] <= modes[j] {
                    let row = pair_rows[pair_of(modes[i], modes[j])];
                    add(row, n + pair_of(modes[k], modes[l]), coefficient / 3.0);
                }
            }
        }
        let matrix = Columns::new(rows.len(), width, |row, column| entries[row * width + column]);
        let stiffnesses = if quartic { n * n } else { 0 };
        let stiffness_rows = (0..stiffnesses).map(|entry| pair_rows[pair_of(entry / n, entry % n)]).collect();
        ElasticForces { pairs, mode_rows, stiffness_rows, matrix }
    }

    /// Multiplies U by a factor.
    pub fn scale(&mut self, factor: f64) {
        self.matrix.scale(factor);
    }

    /// Scratch memory for the evaluation.
    pub fn scratch(&self) -> ElasticScratch {
        ElasticScratch {
            vector: vec![0.0; self.mode_rows.len() + self.pairs.len()],
            product: zeros(self.matrix.room()),
        }
    }

    /// Writes ∂U/∂q at q.
    #[inline(always)]
    pub fn write<S: Arithmetic>(
        &self,
        simd: S,
        q: &[f64],
        gradient: &mut [f64],
        scratch: &mut ElasticScratch,
    ) {
        let ElasticScratch { vector, product } = scratch;
        let (linear, products) = vector.split_at_mut(q.len());
        linear.copy_from_slice(q);
        for (product, &[a, b]) in products.iter_mut().zip(&self.pairs) {
            *product = q[a] * q[b];
        }
        self.matrix.times(simd, vector, product);
        for (gradient, &row) in gradient.iter_mut().zip(&self.mode_rows) {
            *gradient = product[row];
        }
        for (gradient, rows) in gradient.iter_mut().zip(self.stiffness_rows.chunks_exact(q.len().max(1))) {
            *gradient += rows.iter().zip(q).map(|(&row, q)| product[row] * q).sum::<f64>();
        }
    }
}

/// All ways to take two factors of a monomial of fourth order in turn, and the two that remain.
const SPLITS: [[usize; 4]; 12] = [
    [0, 1, 2, 3],
    [1, 0, 2, 3],
    [0, 2, 1, 3],
    [2, 0, 1, 3],
    [0, 3, 1, 2],
    [3, 0, 1, 2],
    [1, 2, 0, 3],
    [2, 1, 0, 3],
    [1, 3, 0, 2],
    [3, 1, 0, 2],
    [2, 3, 0, 1],
    [3, 2, 0, 1],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::test_jet::jet;

    fn families() -> Vec<ModeFamily> {
        jet().modes.iter().map(|mode| mode.family).collect()
    }

    #[test]
    fn the_fast_form_agrees_with_the_plain_one_to_rounding() {
        let energy = &jet().strain_energy;
        let n = families().len();
        let q: Vec<f64> = (0..n).map(|mode| 30.0 * libm::sin(1.0 + mode as f64)).collect();
        for (cubic, quartic) in [(false, false), (true, false), (false, true), (true, true)] {
            let forces = ElasticForces::new(energy, &families(), 0.7, cubic, quartic);
            let (mut fast, mut plain) = (vec![f64::NAN; n], vec![0.0; n]);
            forces.write(pulp::Scalar::new(), &q, &mut fast, &mut forces.scratch());
            energy.add_quadratic(&q, &mut plain);
            if cubic {
                energy.add_cubic(&q, &mut plain);
            }
            if quartic {
                energy.add_quartic(&q, &mut plain);
            }
            let largest = plain.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            assert!(
                fast.iter().zip(&plain).all(|(fast, plain)| (fast - 0.7 * plain).abs() < 1e-12 * largest)
            );
        }
    }

    #[test]
    fn what_symmetry_forbids_is_left_out() {
        let unsymmetric = vec![ModeFamily::Unsymmetric; families().len()];
        let kept = |families: &[ModeFamily]| {
            ElasticForces::new(&jet().strain_energy, families, 1.0, true, true).matrix.kept()
        };
        assert!(10 * kept(&families()) < 6 * kept(&unsymmetric));
    }
}

//! Strain energy as a quartic polynomial of the generalised coordinates.
//!
//! [theory: strain-energy.green, strain-energy.section, strain-energy.polynomial; thesis §3.2]
//!
//! Green's axial strain ε = e + ½[e² + (v′ − zφ′)² + (w′ + yφ′)²] with e = u′ − y v″ − z w″ at the four
//! booms of each section, and ½ GJ φ′² for torsion. The polynomial's coefficients are computed once:
//! U = ½ qᵀK₀q + U₃(q) + U₄(q), each distinct monomial stored once.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Beam, Coupling};

use super::assembly::Structure;
use super::beam::{GAUSS_5, Gradients};
use super::monomials::{
    ascending_tuples, chosen_coefficients, combined_coefficients, monomials, permutations,
};

/// Coefficients of the strain energy of n modes at nominal stiffness [theory: strain-energy.packed].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrainEnergy {
    /// Number of modes.
    modes: usize,
    /// K₀, n × n.
    pub(super) linear_stiffness: Vec<f64>,
    /// Coefficients of q_a q_b q_c in U₃, a ≤ b ≤ c in lexicographic order; none where there is no U₃.
    cubic: Vec<f64>,
    /// Coefficients of q_a q_b q_c q_d in U₄, a ≤ b ≤ c ≤ d in lexicographic order; none where there is no U₄.
    quartic: Vec<f64>,
}

impl StrainEnergy {
    /// Integrates over all elements for the given mode shapes, with the real EA.
    pub fn new(structure: &Structure, shapes: &DMatrix<f64>) -> Self {
        let mut energy = StrainEnergy::zero(shapes.ncols());
        for (index, beam) in structure.aircraft.beams.iter().enumerate() {
            let geometry = &structure.geometry[index];
            for (fraction, weight) in GAUSS_5 {
                let section = SectionGradients::new(structure, index, &geometry.gradients(fraction), shapes);
                energy.add_section(beam, &section, weight * geometry.length);
            }
            for (angle, spring) in geometry.springs() {
                let angle = structure.apply_row(index, angle, shapes);
                energy.add_linear_stiffness(&(&angle * angle.transpose() * *spring));
            }
        }
        energy
    }

    /// No stiffness at all, with room for the coefficients of all orders.
    pub fn zero(modes: usize) -> Self {
        StrainEnergy {
            cubic: vec![0.0; monomials(modes, 3)],
            quartic: vec![0.0; monomials(modes, 4)],
            ..StrainEnergy::quadratic(vec![0.0; modes * modes], modes)
        }
    }

    /// ½ qᵀK₀q alone.
    pub(super) fn quadratic(linear_stiffness: Vec<f64>, modes: usize) -> Self {
        StrainEnergy { modes, linear_stiffness, cubic: Vec::new(), quartic: Vec::new() }
    }

    /// Whether every coefficient is finite.
    pub fn is_finite(&self) -> bool {
        self.linear_stiffness.iter().chain(&self.cubic).chain(&self.quartic).all(|x| x.is_finite())
    }

    /// Whether all arrays have the lengths that `modes` asks for, those of U₃ and U₄ too.
    pub fn is_consistent(&self, modes: usize) -> bool {
        self.modes == modes
            && self.linear_stiffness.len() == modes * modes
            && self.cubic.len() == monomials(modes, 3)
            && self.quartic.len() == monomials(modes, 4)
    }

    /// The energy of a choice of modes (ascending), all others held at zero.
    pub fn select(&self, chosen: &[usize]) -> Self {
        let n = self.modes;
        StrainEnergy {
            modes: chosen.len(),
            linear_stiffness: chosen
                .iter()
                .flat_map(|&a| chosen.iter().map(move |&b| self.linear_stiffness[a * n + b]))
                .collect(),
            cubic: chosen_coefficients::<3>(&self.cubic, n, chosen),
            quartic: chosen_coefficients::<4>(&self.quartic, n, chosen),
        }
    }

    /// The energy of coordinates with such shares in these, a column each.
    pub fn combine(&self, shares: &DMatrix<f64>) -> Self {
        let stiffness = DMatrix::from_row_slice(self.modes, self.modes, &self.linear_stiffness);
        // By rows: the product is self-adjoint up to rounding.
        let combined = (shares.transpose() * stiffness * shares).transpose();
        StrainEnergy {
            modes: shares.ncols(),
            linear_stiffness: combined.as_slice().to_vec(),
            cubic: combined_coefficients(&self.cubic, 3, shares),
            quartic: combined_coefficients(&self.quartic, 4, shares),
        }
    }

    /// The modes of each monomial of U₃ and its coefficient.
    pub(super) fn cubic_terms(&self) -> impl Iterator<Item = ([usize; 3], f64)> {
        ascending_tuples(self.modes).zip(self.cubic.iter().copied())
    }

    /// The modes of each monomial of U₄ and its coefficient.
    pub(super) fn quartic_terms(&self) -> impl Iterator<Item = ([usize; 4], f64)> {
        ascending_tuples(self.modes).zip(self.quartic.iter().copied())
    }

    /// U₂ = ½ qᵀK₀q, with K₀ q added to `gradient` [theory: strain-energy.force].
    pub fn add_quadratic(&self, q: &[f64], gradient: &mut [f64]) -> f64 {
        let mut value = 0.0;
        for (a, row) in self.linear_stiffness.chunks_exact(self.modes.max(1)).enumerate() {
            let force: f64 = row.iter().zip(q).map(|(k, q)| k * q).sum();
            gradient[a] += force;
            value += 0.5 * q[a] * force;
        }
        value
    }

    /// U₃, with its gradient (½K₁q) added to `gradient` [theory: strain-energy.force; thesis eq. 2.5, 3.5].
    pub fn add_cubic(&self, q: &[f64], gradient: &mut [f64]) -> f64 {
        if self.cubic.is_empty() {
            return 0.0;
        }
        let mut rest = self.cubic.as_slice();
        let mut value = 0.0;
        for a in 0..self.modes {
            let mut slope_a = 0.0;
            for b in a..self.modes {
                let (row, tail) = rest.split_at(self.modes - b);
                rest = tail;
                let sum = sweep(row, q[a] * q[b], &q[b..], &mut gradient[b..]);
                gradient[b] += q[a] * sum;
                slope_a += q[b] * sum;
            }
            gradient[a] += slope_a;
            value += q[a] * slope_a;
        }
        value
    }

    /// U₄, with its gradient (⅓K₂q) added to `gradient` [theory: strain-energy.force; thesis eq. 2.5, 3.5].
    pub fn add_quartic(&self, q: &[f64], gradient: &mut [f64]) -> f64 {
        if self.quartic.is_empty() {
            return 0.0;
        }
        let mut rest = self.quartic.as_slice();
        let mut value = 0.0;
        for a in 0..self.modes {
            let mut slope_a = 0.0;
            for b in a..self.modes {
                let mut slope_b = 0.0;
                for c in b..self.modes {
                    let (row, tail) = rest.split_at(self.modes - c);
                    rest = tail;
                    let sum = sweep(row, q[a] * q[b] * q[c], &q[c..], &mut gradient[c..]);
                    gradient[c] += q[a] * q[b] * sum;
                    slope_b += q[c] * sum;
                }
                gradient[b] += q[a] * slope_b;
                slope_a += q[b] * slope_b;
            }
            gradient[a] += slope_a;
            value += q[a] * slope_a;
        }
        value
    }

    /// Adds the energy of one integration section that stands for `length` metres of the beam.
    ///
    /// [theory: strain-energy.section]
    fn add_section(&mut self, beam: &Beam, section: &SectionGradients, length: f64) {
        let torsion = &section.twist * section.twist.transpose() * (beam.torsional_stiffness * length);
        self.add_linear_stiffness(&torsion);
        if !beam.coupling.is_none() {
            self.add_coupling(&beam.coupling, section, length);
        }
        let Coupling { tension_axis: [y_t, z_t], shear_centre: [y_s, z_s], .. } = beam.coupling;
        for place in booms(beam) {
            let rigidity = 0.25 * beam.axial_stiffness * length;
            self.add_boom(section, (place, [y_t - y_s, z_t - z_s]), rigidity);
        }
    }

    /// Adds what couples torsion with bending; EI_yz comes from the booms [theory: coupled-sections.higher].
    fn add_coupling(&mut self, coupling: &Coupling, section: &SectionGradients, length: f64) {
        let [by_w, by_v] = coupling.bend_twist;
        for (curvature, rigidity) in [(&section.curvature_w, by_w), (&section.curvature_v, by_v)] {
            let product = &section.twist * curvature.transpose();
            self.add_linear_stiffness(&((&product + product.transpose()) * (rigidity * length)));
        }
    }

    /// Adds ½ EA ε² of a boom at (y, z) from the tension axis, which is some way from the shear centre: ε = e·q + ½ qᵀQq
    /// [theory: strain-energy.polynomial].
    fn add_boom(&mut self, section: &SectionGradients, ([y, z], apart): ([f64; 2], [f64; 2]), rigidity: f64) {
        let e = &section.stretch - &section.curvature_v * y - &section.curvature_w * z;
        let v = &section.slope_v - &section.twist * (z + apart[1]);
        let w = &section.slope_w + &section.twist * (y + apart[0]);
        let quadratic = &e * e.transpose() + &v * v.transpose() + &w * w.transpose();
        self.add_linear_stiffness(&(&e * e.transpose() * rigidity));

        for (tuple, coefficient) in ascending_tuples(self.modes).zip(&mut self.cubic) {
            let [a, b, c] = tuple;
            let permuted = e[a] * quadratic[(b, c)] + e[b] * quadratic[(a, c)] + e[c] * quadratic[(a, b)];
            *coefficient += 0.5 * rigidity * permutations(&tuple) * permuted / 3.0;
        }
        let mut rest = self.quartic.as_mut_slice();
        for [a, b, c] in ascending_tuples(self.modes) {
            let (row, tail) = rest.split_at_mut(self.modes - c);
            rest = tail;
            // Columns stand for rows of the self-adjoint matrix: their numbers lie side by side.
            let [of_a, of_b, of_c] = [a, b, c].map(|mode| &quadratic.as_slice()[mode * self.modes..][c..]);
            let (ab, ac, bc) = (quadratic[(a, b)], quadratic[(a, c)], quadratic[(b, c)]);
            let factor = |d| 0.125 * rigidity * permutations(&[a, b, c, d]);
            let add = |coefficient: &mut f64, factor: f64, ad: f64, bd: f64, cd: f64| {
                let permuted = ab * cd + ac * bd + ad * bc;
                *coefficient += factor * permuted / 3.0;
            };
            add(&mut row[0], factor(c), of_a[0], of_b[0], of_c[0]);
            // All others have as many orders as the next.
            let others = factor(c + 1);
            for (((coefficient, ad), bd), cd) in row.iter_mut().zip(of_a).zip(of_b).zip(of_c).skip(1) {
                add(coefficient, others, *ad, *bd, *cd);
            }
        }
    }

    fn add_linear_stiffness(&mut self, matrix: &DMatrix<f64>) {
        for (sum, term) in self.linear_stiffness.iter_mut().zip(matrix.iter()) {
            *sum += term;
        }
    }
}

/// The places of four booms from the tension axis, in the principal axes of bending.
///
/// [theory: strain-energy.section, coupled-sections.higher]
fn booms(beam: &Beam) -> [[f64; 2]; 4] {
    let Beam { axial_stiffness: axial, bending_stiffness_y: about_y, bending_stiffness_z: about_z, .. } =
        *beam;
    let product = beam.coupling.bending;
    let (one, other) = if product == 0.0 {
        ([(about_z / axial).sqrt(), 0.0], [0.0, (about_y / axial).sqrt()])
    } else {
        let (mean, apart) = (0.5 * (about_z + about_y), 0.5 * (about_z - about_y));
        let radius = libm::hypot(apart, product);
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(product, apart));
        let (far, near) = (((mean + radius) / axial).sqrt(), ((mean - radius) / axial).sqrt());
        ([far * cos, far * sin], [-near * sin, near * cos])
    };
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    signs.map(|(a, b)| [a * one[0] + b * other[0], a * one[1] + b * other[1]])
}

/// Displacement gradients at one section as linear forms on the generalised coordinates.
///
/// [theory: structure.gradients]
struct SectionGradients {
    stretch: DVector<f64>,
    slope_v: DVector<f64>,
    slope_w: DVector<f64>,
    twist: DVector<f64>,
    curvature_v: DVector<f64>,
    curvature_w: DVector<f64>,
}

impl SectionGradients {
    fn new(structure: &Structure, beam: usize, gradients: &Gradients, shapes: &DMatrix<f64>) -> Self {
        let modal = |row| structure.apply_row(beam, row, shapes);
        SectionGradients {
            stretch: modal(&gradients.stretch),
            slope_v: modal(&gradients.slope_v),
            slope_w: modal(&gradients.slope_w),
            twist: modal(&gradients.twist),
            curvature_v: modal(&gradients.curvature_v),
            curvature_w: modal(&gradients.curvature_w),
        }
    }
}

/// One row of packed coefficients: adds `factor`·row to the gradient and returns row·q.
fn sweep(row: &[f64], factor: f64, q: &[f64], gradient: &mut [f64]) -> f64 {
    let mut sum = 0.0;
    for ((coefficient, q), gradient) in row.iter().zip(q).zip(gradient) {
        sum += coefficient * q;
        *gradient += factor * coefficient;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of a quartic polynomial with arbitrary coefficients, to test the sweeps against.
    fn sample() -> StrainEnergy {
        let mut energy = StrainEnergy::zero(4);
        let coefficient = |k: usize| libm::sin(1.0 + 3.7 * k as f64);
        for (k, c) in energy.cubic.iter_mut().enumerate() {
            *c = coefficient(k);
        }
        for (k, c) in energy.quartic.iter_mut().enumerate() {
            *c = coefficient(k + 100);
        }
        for a in 0..4 {
            for b in 0..4 {
                energy.linear_stiffness[4 * a + b] = coefficient(200 + a + b);
            }
        }
        energy
    }

    fn value(energy: &StrainEnergy, q: &[f64]) -> f64 {
        let unused = &mut [0.0; 4];
        energy.add_quadratic(q, unused) + energy.add_cubic(q, unused) + energy.add_quartic(q, unused)
    }

    #[test]
    fn the_sweep_evaluates_each_monomial_once() {
        let energy = sample();
        let q = [0.3, -1.2, 0.7, 2.0];
        let product = |tuple: &[usize]| tuple.iter().map(|&i| q[i]).product::<f64>();
        let cubic: f64 = energy.cubic_terms().map(|(tuple, c)| c * product(&tuple)).sum();
        let quartic: f64 = energy.quartic_terms().map(|(tuple, c)| c * product(&tuple)).sum();
        assert!((energy.add_cubic(&q, &mut [0.0; 4]) - cubic).abs() < 1e-13);
        assert!((energy.add_quartic(&q, &mut [0.0; 4]) - quartic).abs() < 1e-13);
    }

    #[test]
    fn the_gradient_is_the_derivative_of_the_energy() {
        let energy = sample();
        let q = [0.3, -1.2, 0.7, 2.0];
        let mut gradient = [0.0; 4];
        energy.add_quadratic(&q, &mut gradient);
        energy.add_cubic(&q, &mut gradient);
        energy.add_quartic(&q, &mut gradient);
        for mode in 0..4 {
            let step = 1e-5;
            let shifted = |sign: f64| {
                let mut moved = q;
                moved[mode] += sign * step;
                value(&energy, &moved)
            };
            let difference = (shifted(1.0) - shifted(-1.0)) / (2.0 * step);
            assert!((difference - gradient[mode]).abs() < 1e-8, "{difference} {}", gradient[mode]);
        }
    }

    #[test]
    fn a_choice_of_modes_has_the_energy_with_the_others_at_rest() {
        let energy = sample();
        let chosen = energy.select(&[1, 3]);
        assert!(chosen.is_consistent(2));
        let unused = &mut [0.0; 2];
        let q = [0.6, -0.9];
        let part =
            chosen.add_quadratic(&q, unused) + chosen.add_cubic(&q, unused) + chosen.add_quartic(&q, unused);
        assert!((part - value(&energy, &[0.0, q[0], 0.0, q[1]])).abs() < 1e-14);
    }

    #[test]
    fn combined_coordinates_have_the_energy_of_what_they_combine() {
        let energy = sample();
        let shares = DMatrix::from_row_slice(4, 2, &[1.0, 0.0, 0.0, 0.4, 0.0, -0.7, 0.0, 1.3]);
        let combined = energy.combine(&shares);
        assert!(combined.is_consistent(2));
        let q = [0.6, -0.9];
        let packaged = &shares * DVector::from_column_slice(&q);
        let unused = &mut [0.0; 2];
        let value_there = combined.add_quadratic(&q, unused)
            + combined.add_cubic(&q, unused)
            + combined.add_quartic(&q, unused);
        assert!((value_there - value(&energy, packaged.as_slice())).abs() < 1e-13);
    }
}

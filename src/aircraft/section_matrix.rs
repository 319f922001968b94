//! 6 × 6 matrices of a section: what a beam that does not shear has of a stiffness, what a bay has of a mass per length.
//!
//! [theory: coupled-sections.matrix, coupled-sections.condensed, coupled-sections.mass]

use nalgebra::{Cholesky, DMatrix, Matrix3, Matrix6, Vector3};

use super::coupling::Coupling;
use super::masses::{MOMENTS_ALLOWED, principal_moments};
use super::schema::MatrixSpec;

/// Scaled to ones on its diagonal, the least eigenvalue of a matrix that counts as positive definite.
const DEFINITE: f64 = 1e-12;

/// What the mass of a section is like.
const FORM_ALLOWED: &str = "the mass of a rigid section is allowed: [[μ 1, −μ c×], [μ c×, J]]";

/// Departures from the form of a rigid section's mass, relative to its largest entries of the kind, that are rounding.
const ROUNDED: f64 = 1e-6;

/// Stiffnesses of a section: EA, GJ, EI_y and EI_z, and what couples them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SectionStiffness {
    pub(super) axial: f64,
    pub(super) torsional: f64,
    pub(super) bending_y: f64,
    pub(super) bending_z: f64,
    pub(super) coupling: Coupling,
}

impl SectionStiffness {
    /// Whether every strain has positive energy.
    pub(super) fn is_positive_definite(&self) -> bool {
        let SectionStiffness { axial, torsional, bending_y, bending_z, coupling } = *self;
        let Coupling { bending, bend_twist: [y, z], .. } = coupling;
        let matrix = Matrix3::new(torsional, y, z, y, bending_y, bending, z, bending, bending_z);
        axial > 0.0 && is_positive_definite(&DMatrix::from_column_slice(3, 3, matrix.as_slice()))
    }

    /// Of a matrix about the reference axis, the transverse shear forces zero; `None` if it is not positive definite.
    pub(super) fn condensed(matrix: &Matrix6<f64>) -> Option<Self> {
        if !is_positive_definite(&DMatrix::from_column_slice(6, 6, matrix.as_slice())) {
            return None;
        }
        let compliance = Cholesky::new(*matrix)?.inverse();
        // The compliance without shear forces: its inverse is the condensed stiffness.
        let kept = [0, 3, 4, 5];
        let without_shear = nalgebra::Matrix4::from_fn(|i, j| compliance[(kept[i], kept[j])]);
        let stiffness = Cholesky::new(without_shear)?.inverse();
        let axial = stiffness[(0, 0)];
        let along = stiffness.column(0) / axial;
        let rest = stiffness - along * along.transpose() * axial;
        let coupling = Coupling {
            bending: 0.0 - rest[(2, 3)],
            bend_twist: [0.0 - rest[(1, 2)], rest[(1, 3)]],
            stretch_by_twist: along[1],
            tension_axis: [0.0 - along[3], along[2]],
            shear_centre: [-compliance[(3, 2)], compliance[(3, 1)]].map(|twist| twist / compliance[(3, 3)]),
        };
        let section = SectionStiffness {
            axial,
            torsional: rest[(1, 1)],
            bending_y: rest[(2, 2)],
            bending_z: rest[(3, 3)],
            coupling,
        };
        section.is_positive_definite().then_some(section)
    }
}

/// Whether a matrix is so by far more than rounding.
fn is_positive_definite(matrix: &DMatrix<f64>) -> bool {
    let diagonal = matrix.diagonal();
    if !diagonal.iter().all(|entry| *entry > 0.0 && entry.is_finite()) {
        return false;
    }
    let roots = diagonal.map(f64::sqrt);
    let scaled =
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / (roots[i] * roots[j]));
    Cholesky::new(scaled - DMatrix::identity(matrix.nrows(), matrix.ncols()) * DEFINITE).is_some()
}

/// The mass per length of a section, local axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SectionMass {
    /// kg/m.
    pub(super) mass: f64,
    /// From the reference axis, m.
    pub(super) centre: Vector3<f64>,
    /// About the centre, kg·m.
    pub(super) inertia: Matrix3<f64>,
}

impl SectionMass {
    /// Of a matrix of this form, with an inertia about its centre that a body can have; the error says what is not, and what is allowed.
    pub(super) fn of(matrix: &Matrix6<f64>) -> Result<Self, [String; 2]> {
        let other = |fault: &str| Err([fault.to_owned(), FORM_ALLOWED.to_owned()]);
        let block = |row: usize, column: usize| matrix.fixed_view::<3, 3>(row, column).into_owned();
        let (masses, arms, about_axis) = (block(0, 0), block(3, 0), block(3, 3));
        let mass = masses.trace() / 3.0;
        if mass <= 0.0 {
            return other("no mass in its first three diagonals");
        }
        if (masses - Matrix3::identity() * mass).amax() > ROUNDED * mass {
            return other("masses that are not alike in all directions");
        }
        let centre = Vector3::new(
            arms[(2, 1)] - arms[(1, 2)],
            arms[(0, 2)] - arms[(2, 0)],
            arms[(1, 0)] - arms[(0, 1)],
        ) / (2.0 * mass);
        let cross = centre.cross_matrix();
        let size = (mass * about_axis.trace().abs()).sqrt().max(arms.amax());
        if (arms - cross * mass).amax() > ROUNDED * size {
            return other("first moments that are those of no centre of mass");
        }
        let inertia = about_axis + cross * cross * mass;
        // What is carried to the centre is rounded by what it was about the axis.
        principal_moments(&inertia, ROUNDED * about_axis.amax()).map_err(|moments| {
            let fault = format!("the principal moments of inertia {moments} kg m about its centre");
            [fault, MOMENTS_ALLOWED.to_owned()]
        })?;
        Ok(SectionMass { mass, centre, inertia })
    }
}

/// The matrix at a fraction of the component's length: linear between its places, constant beyond them. There is at least one.
pub(super) fn matrix_at(matrices: &[MatrixSpec], s: f64) -> Matrix6<f64> {
    let next = matrices.partition_point(|matrix| matrix.at < s);
    let value = |place: usize| matrices[place].matrix.value;
    match next {
        0 => value(0),
        next if next == matrices.len() => value(next - 1),
        next => {
            let [before, after] = [&matrices[next - 1], &matrices[next]];
            let fraction = (s - before.at) / (after.at - before.at);
            before.matrix.value + (after.matrix.value - before.matrix.value) * fraction
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stiffness about the reference axis of a section whose shear forces act at a shear centre and whose axial force acts at
    /// a tension axis, without coupling otherwise: by its strain energy, written out.
    fn apart([y_t, z_t]: [f64; 2], [y_s, z_s]: [f64; 2]) -> Matrix6<f64> {
        // Strains of the two axes as rows on those of the reference axis.
        let row = |entries: [f64; 6]| nalgebra::RowVector6::from_row_slice(&entries);
        let terms = [
            (7e6, row([1.0, 0.0, 0.0, 0.0, z_t, -y_t])),
            (2e6, row([0.0, 1.0, 0.0, -z_s, 0.0, 0.0])),
            (1e6, row([0.0, 0.0, 1.0, y_s, 0.0, 0.0])),
            (4e4, row([0.0, 0.0, 0.0, 1.0, 0.0, 0.0])),
            (5e4, row([0.0, 0.0, 0.0, 0.0, 1.0, 0.0])),
            (9e5, row([0.0, 0.0, 0.0, 0.0, 0.0, 1.0])),
        ];
        terms.iter().map(|(stiffness, row)| row.transpose() * row * *stiffness).sum()
    }

    fn near(found: f64, expected: f64, scale: f64) {
        assert!((found - expected).abs() < 1e-9 * scale, "{found} {expected}");
    }

    #[test]
    fn axes_that_are_apart_are_found_and_stiffnesses_are_those_about_them() {
        let (tension, shear) = ([0.12, -0.03], [-0.2, 0.05]);
        let section = SectionStiffness::condensed(&apart(tension, shear)).unwrap();
        near(section.axial, 7e6, 7e6);
        near(section.torsional, 4e4, 4e4);
        near(section.bending_y, 5e4, 5e4);
        near(section.bending_z, 9e5, 9e5);
        let Coupling { bending, bend_twist, stretch_by_twist, tension_axis, shear_centre } = section.coupling;
        [bending, bend_twist[0], bend_twist[1]].into_iter().for_each(|coupling| near(coupling, 0.0, 5e4));
        near(stretch_by_twist, 0.0, 1.0);
        for axis in 0..2 {
            near(tension_axis[axis], tension[axis], 1.0);
            near(shear_centre[axis], shear[axis], 1.0);
        }
    }

    #[test]
    fn shear_that_goes_with_bending_softens_it_and_shear_forces_are_zero() {
        // γ13 coupled with κ2 by S35, γ12 with κ1 and κ3: with F2 = F3 = 0, S − S_ab S_bb⁻¹ S_ba by hand.
        let mut matrix = Matrix6::from_diagonal(&nalgebra::Vector6::new(8e6, 2e6, 1e6, 4e4, 5e4, 9e5));
        let mut couple = |i: usize, j: usize, entry: f64| {
            (matrix[(i - 1, j - 1)], matrix[(j - 1, i - 1)]) = (entry, entry);
        };
        couple(3, 5, 1e5);
        couple(2, 4, 5e4);
        couple(2, 6, 3e5);
        couple(4, 5, -1e4);
        couple(1, 4, 2e4);
        let section = SectionStiffness::condensed(&matrix).unwrap();
        near(section.axial, 8e6, 8e6);
        near(section.coupling.stretch_by_twist, 2e4 / 8e6, 1e-3);
        near(section.bending_y, 5e4 - 1e5 * 1e5 / 1e6, 5e4);
        near(section.bending_z, 9e5 - 3e5 * 3e5 / 2e6, 9e5);
        near(section.torsional, 4e4 - 5e4 * 5e4 / 2e6 - 2e4 * 2e4 / 8e6, 4e4);
        // κ2 = −w″: bending up by a moment twists the other way.
        near(section.coupling.bend_twist[0], 1e4, 1e4);
        near(section.coupling.bend_twist[1], -5e4 * 3e5 / 2e6, 1e4);
        near(section.coupling.bending, 0.0, 5e4);
    }

    #[test]
    fn a_matrix_by_which_a_strain_has_no_energy_is_none() {
        let mut matrix = apart([0.0; 2], [0.0; 2]);
        (matrix[(3, 4)], matrix[(4, 3)]) = (4.5e4, 4.5e4);
        assert!(SectionStiffness::condensed(&matrix).is_none());
        matrix[(3, 3)] = -1.0;
        assert!(SectionStiffness::condensed(&matrix).is_none());
    }

    #[test]
    fn a_section_mass_is_taken_apart_about_its_centre() {
        let (mass, centre) = (12.0, Vector3::new(0.0, -0.2, 0.04));
        let inertia = Matrix3::new(0.9, 0.0, 0.0, 0.0, 0.3, 0.02, 0.0, 0.02, 0.6);
        let cross = centre.cross_matrix();
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * mass));
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(cross * mass));
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-cross * mass));
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&(inertia - cross * cross * mass));
        let found = SectionMass::of(&matrix).unwrap();
        near(found.mass, mass, 1.0);
        assert!((found.centre - centre).norm() < 1e-14 && (found.inertia - inertia).norm() < 1e-14);
        let refused = |change: fn(&mut Matrix6<f64>)| {
            let mut matrix = matrix;
            change(&mut matrix);
            SectionMass::of(&matrix).unwrap_err()[0].clone()
        };
        assert!(refused(|matrix| matrix[(1, 1)] = 11.0).contains("alike"));
        assert!(refused(|matrix| matrix[(3, 0)] = 1.0).contains("no centre"));
        assert!(refused(|matrix| *matrix *= -1.0).contains("no mass"));
        // More about x than about y and z together, and less than nothing.
        assert!(refused(|matrix| matrix[(3, 3)] += 0.01).contains("principal moments"));
        assert!(refused(|matrix| matrix[(4, 4)] -= 1.0).contains("principal moments"));
    }
}

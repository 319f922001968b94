//! The mirror plane y = 0 and the subspaces of symmetric and antisymmetric motion (physics.md §1).

use nalgebra::DMatrix;

use crate::aircraft::Aircraft;

use super::ModeFamily;

/// A unit vector of the symmetric or antisymmetric subspace: one unknown, or a pair of them.
type BasisVector = Vec<(usize, f64)>;

/// The reflection of nodal unknowns in the plane y = 0.
#[derive(Debug)]
pub struct Mirror {
    /// Node → its mirror image (itself on the plane).
    image: Vec<usize>,
}

/// Entries of mirrored matrices may differ by this share of the roots of their diagonals.
const SYMMETRIC: f64 = 1e-9;

/// How translations (x, y, z) and rotations (x, y, z) of a node reflect.
pub(super) const SIGN: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

impl Mirror {
    /// The mirror of an aircraft, `None` when its nodes, stiffness or mass have no mirror plane y = 0.
    pub fn find(aircraft: &Aircraft, stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Option<Self> {
        let size = aircraft.nodes.iter().map(nalgebra::Vector3::norm).fold(0.0, f64::max);
        let image = aircraft
            .nodes
            .iter()
            .map(|node| {
                let mirrored = nalgebra::Vector3::new(node.x, -node.y, node.z);
                aircraft.nodes.iter().position(|other| (other - mirrored).norm() < 1e-9 * size)
            })
            .collect::<Option<Vec<_>>>()?;
        let mirror = Mirror { image };
        (mirror.preserves(stiffness) && mirror.preserves(mass)).then_some(mirror)
    }

    /// Orthonormal basis of a family's subspace.
    pub fn subspace(&self, family: ModeFamily) -> Vec<BasisVector> {
        let sign = if family == ModeFamily::Antisymmetric { -1.0 } else { 1.0 };
        let mut basis = Vec::new();
        for (node, &image) in self.image.iter().enumerate().skip(1) {
            for (axis, reflected) in SIGN.iter().enumerate() {
                let unknown = 6 * (node - 1) + axis;
                if image == node && sign * reflected > 0.0 {
                    basis.push(vec![(unknown, 1.0)]);
                } else if image > node {
                    let half = std::f64::consts::FRAC_1_SQRT_2;
                    basis.push(vec![(unknown, half), (6 * (image - 1) + axis, sign * reflected * half)]);
                }
            }
        }
        basis
    }

    /// Whether reflecting rows and columns leaves the matrix as it is, each entry relative to its diagonals.
    fn preserves(&self, matrix: &DMatrix<f64>) -> bool {
        let reflect =
            |unknown: usize| (6 * (self.image[unknown / 6 + 1] - 1) + unknown % 6, SIGN[unknown % 6]);
        let diagonal = matrix.map_diagonal(|value| value.abs().sqrt());
        (0..matrix.nrows()).all(|i| {
            let (image_i, sign_i) = reflect(i);
            (0..matrix.ncols()).all(|j| {
                let (image_j, sign_j) = reflect(j);
                let difference = matrix[(i, j)] - sign_i * sign_j * matrix[(image_i, image_j)];
                difference.abs() <= SYMMETRIC * diagonal[i] * diagonal[j]
            })
        })
    }
}

/// The whole space as a basis, for a structure without a mirror plane.
pub fn whole_space(unknowns: usize) -> Vec<BasisVector> {
    (0..unknowns).map(|unknown| vec![(unknown, 1.0)]).collect()
}

/// The matrix restricted to a subspace.
pub fn restrict(matrix: &DMatrix<f64>, basis: &[BasisVector]) -> DMatrix<f64> {
    DMatrix::from_fn(basis.len(), basis.len(), |a, b| {
        let mut sum = 0.0;
        for &(i, ci) in &basis[a] {
            for &(j, cj) in &basis[b] {
                sum += ci * cj * matrix[(i, j)];
            }
        }
        sum
    })
}

/// A vector of the subspace, written in all unknowns.
pub fn expand(coordinates: &[f64], basis: &[BasisVector], unknowns: usize) -> nalgebra::DVector<f64> {
    let mut vector = nalgebra::DVector::zeros(unknowns);
    for (coordinate, terms) in coordinates.iter().zip(basis) {
        for &(unknown, coefficient) in terms {
            vector[unknown] += coefficient * coordinate;
        }
    }
    vector
}

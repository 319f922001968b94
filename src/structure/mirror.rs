//! The mirror plane y = 0 and the subspaces of symmetric and antisymmetric motion [theory: structure.families].

use nalgebra::{DMatrix, DVector, Vector3};

use crate::aircraft::{Aircraft, Branches};

use super::ModeFamily;
use super::shared_unknowns::SharedUnknowns;

/// A unit vector of the symmetric or antisymmetric subspace: one unknown, a pair of them, or several that joints make one.
type BasisVector = Vec<(usize, f64)>;

/// The reflection of nodal unknowns in the plane y = 0.
#[derive(Debug)]
pub struct Reflection {
    /// Node → its mirror image (itself on the plane).
    image: Vec<usize>,
}

/// Entries of mirrored matrices may differ by this share of the roots of their diagonals.
const SYMMETRIC: f64 = 1e-9;

/// How translations (x, y, z) and rotations (x, y, z) of a node reflect.
///
/// [theory: structure.families, symmetry.mirror]
pub(super) const SIGN: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

impl Reflection {
    /// The mirror of an aircraft, `None` when its nodes, joints, stiffness or mass have no mirror plane y = 0.
    pub fn find(aircraft: &Aircraft, stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Option<Self> {
        let size = aircraft.nodes.iter().map(Vector3::norm).fold(0.0, f64::max);
        let branches = Branches::of(aircraft);
        let joined = aircraft.rotations_joined();
        let matrices = [Reflected::new(stiffness), Reflected::new(mass)];
        let alike = |node: usize, other: usize| {
            let (at, image_at) = (aircraft.nodes[node], aircraft.nodes[other]);
            let (before, image_before) = (branches.parent(node), branches.parent(other));
            (Vector3::new(at.x, -at.y, at.z) - image_at).norm() < 1e-9 * size
                && joined[node] == joined[other]
                && matrices.iter().all(|matrix| {
                    matrix.preserves([node, node], [other, other])
                        && matrix.preserves([before, node], [image_before, other])
                })
        };
        // Stiffness and mass join each node to itself and to its neighbours in the tree: nothing else is to be compared.
        let images = branches.images(&alike);
        let are_joined = aircraft.joints.iter().all(|joint| aircraft.is_mirrored(joint, &images));
        let image = images.into_iter().collect::<Option<_>>()?;
        are_joined.then_some(Reflection { image })
    }

    /// The mirror image of a node, itself on the plane.
    pub fn image(&self, node: usize) -> usize {
        self.image[node]
    }

    /// Orthonormal basis of a family's subspace, in which shared unknowns are one.
    pub fn subspace(&self, family: ModeFamily, shared: &SharedUnknowns) -> Vec<BasisVector> {
        let sign = if family == ModeFamily::Antisymmetric { -1.0 } else { 1.0 };
        let mut basis = Vec::new();
        for (node, &image) in self.image.iter().enumerate().skip(1) {
            for (axis, reflected) in SIGN.iter().enumerate() {
                let Some(own) = shared.led_by(node, axis) else { continue };
                let (first, image) = (6 * node + axis, shared.first(image, axis));
                if image == first && sign * reflected > 0.0 {
                    basis.push(own.column(1.0).collect());
                } else if image > first {
                    let half = std::f64::consts::FRAC_1_SQRT_2;
                    let image = shared.of_first(image);
                    basis.push(own.column(half).chain(image.column(sign * reflected * half)).collect());
                }
            }
        }
        basis
    }
}

/// A self-adjoint matrix of nodal unknowns, to be compared with its reflection.
struct Reflected<'m> {
    matrix: &'m DMatrix<f64>,
    /// Roots of the diagonal.
    scale: DVector<f64>,
}

impl<'m> Reflected<'m> {
    fn new(matrix: &'m DMatrix<f64>) -> Self {
        Reflected { matrix, scale: matrix.map_diagonal(|value| value.abs().sqrt()) }
    }

    /// Whether the block of two nodes is, reflected, that of their images, each entry relative to its diagonals. The
    /// clamped node has none.
    fn preserves(&self, [row, column]: [usize; 2], [image_row, image_column]: [usize; 2]) -> bool {
        if [row, column, image_row, image_column].contains(&0) {
            return row == image_row;
        }
        let (first, first_column) = (6 * (row - 1), 6 * (column - 1));
        let (image, image_column) = (6 * (image_row - 1), 6 * (image_column - 1));
        (0..36).map(|entry| (entry / 6, entry % 6)).all(|(i, j)| {
            let reflected = SIGN[i] * SIGN[j] * self.matrix[(image + i, image_column + j)];
            let difference = self.matrix[(first + i, first_column + j)] - reflected;
            difference.abs() <= SYMMETRIC * self.scale[first + i] * self.scale[first_column + j]
        })
    }
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

/// The part of a load on all unknowns that acts in a subspace, in its coordinates.
pub fn project(load: &DVector<f64>, basis: &[BasisVector]) -> DVector<f64> {
    let part =
        |terms: &BasisVector| terms.iter().map(|&(unknown, coefficient)| coefficient * load[unknown]).sum();
    DVector::from_iterator(basis.len(), basis.iter().map(part))
}

/// A vector of the subspace, written in all unknowns.
pub fn expand(coordinates: &[f64], basis: &[BasisVector], unknowns: usize) -> DVector<f64> {
    let mut vector = DVector::zeros(unknowns);
    for (coordinate, terms) in coordinates.iter().zip(basis) {
        for &(unknown, coefficient) in terms {
            vector[unknown] += coefficient * coordinate;
        }
    }
    vector
}

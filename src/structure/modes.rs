//! Natural modes of the clamped structure by family [theory: structure.modes, structure.families; thesis §3.1].

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use crate::aircraft::ModeBasis;

use super::assembly::Structure;
use super::mirror::{self, Reflection};
use super::mode_count::ModeCount;
use super::pairs::Pairs;
use super::{Mode, ModeFamily, ModeKind, StructureError};

/// Frequencies closer than this (relative) count as equal: symmetric before antisymmetric.
const DEGENERATE: f64 = 1e-9;

/// Cap on the iterations of the eigensolver.
const MAX_ITERATIONS: usize = 100_000;

/// Natural modes with their shapes.
#[derive(Debug)]
pub struct ModalBasis {
    /// Lowest frequency first.
    pub modes: Vec<Mode>,
    /// One column per mode, mass-normalised, on all nodal unknowns.
    pub shapes: DMatrix<f64>,
}

impl ModalBasis {
    /// The lowest modes of all families together; more where they would cut a pair in half.
    ///
    /// # Errors
    /// As [`with`](Self::with).
    pub fn new(structure: &Structure, count: impl Into<ModeCount>) -> Result<Self, StructureError> {
        Self::with(structure, count.into(), ModeKind::All)
    }

    /// The lowest modes of all families together, as many as it takes to have `count` of a kind among them.
    ///
    /// # Errors
    /// When the stiffness matrix is not positive definite, or the structure has no such modes.
    pub fn with(structure: &Structure, count: ModeCount, kind: ModeKind) -> Result<Self, StructureError> {
        let stiffness = structure.stiffness(structure.aircraft.mode_basis == ModeBasis::BendingTorsion);
        let mass = structure.mass();
        // Axially rigid beams would hide a difference in bending.
        let (mut modes, pairs) =
            match Reflection::find(structure.aircraft, &structure.stiffness(false), &mass) {
                Some(mirror) => {
                    let family_modes =
                        |family| family_modes(&stiffness, &mass, &mirror.subspace(family), family);
                    (
                        merge(family_modes(ModeFamily::Symmetric)?, family_modes(ModeFamily::Antisymmetric)?),
                        None,
                    )
                }
                None => {
                    let whole = mirror::whole_space(structure.unknowns());
                    let modes = family_modes(&stiffness, &mass, &whole, ModeFamily::Unsymmetric)?;
                    (modes, Some(Pairs::new(structure.aircraft, &mass)))
                }
            };
        let count = count.lowest(kind, modes.iter().map(|(mode, _)| mode.family))?;
        if let Some(pairs) = pairs {
            pairs.mark(&mut modes, count);
        }
        let completed = modes[count..].iter().take_while(|(mode, _)| mode.completes_a_pair).count();
        let (modes, shapes): (Vec<_>, Vec<_>) = modes.into_iter().take(count + completed).unzip();
        let shapes = if shapes.is_empty() {
            DMatrix::zeros(structure.unknowns(), 0)
        } else {
            DMatrix::from_columns(&shapes)
        };
        Ok(ModalBasis { modes, shapes })
    }
}

/// All modes of a subspace, lowest first: solves M φ = (1/ω²) K φ with the Cholesky factor of K, since M is
/// singular [theory: structure.modes].
fn family_modes(
    stiffness: &DMatrix<f64>,
    mass: &DMatrix<f64>,
    basis: &[Vec<(usize, f64)>],
    family: ModeFamily,
) -> Result<Vec<(Mode, DVector<f64>)>, StructureError> {
    if basis.is_empty() {
        return Ok(Vec::new());
    }
    let factor = Cholesky::new(mirror::restrict(stiffness, basis)).ok_or(StructureError::Mechanism)?;
    let lower = factor.l();
    let solve = |mut matrix: DMatrix<f64>| {
        lower.solve_lower_triangular_mut(&mut matrix);
        matrix
    };
    let flexibility = solve(solve(mirror::restrict(mass, basis)).transpose());
    let self_adjoint = (&flexibility + flexibility.transpose()) * 0.5;
    let eigen = SymmetricEigen::try_new(self_adjoint, f64::EPSILON, MAX_ITERATIONS)
        .ok_or(StructureError::EigenvaluesNotFound)?;

    let mut order: Vec<usize> = (0..basis.len()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let massless = 1e-12 * eigen.eigenvalues[order[0]];
    let mut modes = Vec::new();
    for index in order.into_iter().take_while(|&index| eigen.eigenvalues[index] > massless) {
        let angular_frequency = 1.0 / eigen.eigenvalues[index].sqrt();
        let mut shape = eigen.eigenvectors.column(index) * angular_frequency;
        lower.tr_solve_lower_triangular_mut(&mut shape);
        let mut shape = mirror::expand(shape.as_slice(), basis, mass.nrows());
        fix_sign(&mut shape);
        modes.push((Mode { family, angular_frequency, completes_a_pair: false }, shape));
    }
    Ok(modes)
}

/// Makes the largest nodal translation component positive: the first of equals in node order.
///
/// [theory: structure.modes]
fn fix_sign(shape: &mut DVector<f64>) {
    let translations = || (0..shape.len()).filter(|unknown| unknown % 6 < 3);
    let largest = translations().map(|unknown| shape[unknown].abs()).fold(0.0, f64::max);
    let first = translations().find(|&unknown| shape[unknown].abs() >= largest * (1.0 - DEGENERATE));
    if first.is_some_and(|unknown| shape[unknown] < 0.0) {
        shape.neg_mut();
    }
}

/// Merges two ascending families by frequency [theory: structure.families].
fn merge<T>(symmetric: Vec<(Mode, T)>, antisymmetric: Vec<(Mode, T)>) -> Vec<(Mode, T)> {
    let mut merged = Vec::with_capacity(symmetric.len() + antisymmetric.len());
    let (mut s, mut a) = (symmetric.into_iter().peekable(), antisymmetric.into_iter().peekable());
    loop {
        let symmetric_first = match (s.peek(), a.peek()) {
            (Some((left, _)), Some((right, _))) => {
                left.angular_frequency <= right.angular_frequency * (1.0 + DEGENERATE)
            }
            (left, _) => left.is_some(),
        };
        match if symmetric_first { s.next() } else { a.next() } {
            Some(mode) => merged.push(mode),
            None => return merged,
        }
    }
}

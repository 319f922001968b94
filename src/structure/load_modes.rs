//! Load modes: the shapes that static loads give the clamped structure, beside the natural modes.
//!
//! [theory: load-modes.shapes]
//!
//! A few of them spare many natural modes, for strains of loads converge slowly in those. What is orthogonal to
//! eigenvectors in the mass is so in the stiffness, so that natural modes stay what they are, and all together are
//! Rayleigh and Ritz's approximation in the span of modes and strains.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::StructureError;

/// Of a search for eigenvalues.
pub(super) const MAX_ITERATIONS: usize = 100_000;

/// A load of which less than this is left without the natural modes, or a part of a load that is smaller, gives none.
const OF_NATURAL_MODES: f64 = 1e-6;

/// Shapes whose Gram matrix has an eigenvalue below this, relative to the largest, are dependent on one another.
const DEPENDENT: f64 = 1e-9;

/// Mass and stiffness of whatever coordinates the shapes are written in.
pub(super) struct Metric<'m> {
    pub mass: &'m DMatrix<f64>,
    pub stiffness: &'m DMatrix<f64>,
}

/// The load modes of one family, lowest frequency first, with their angular frequencies: mass-normalised, orthogonal in
/// mass and stiffness to the `natural` modes and to one another. `strained` are the shapes that the loads give.
///
/// # Errors
/// When the eigenvalues of one of the two small matrices are not found, or its numbers overflow.
pub(super) fn load_modes(
    strained: Vec<DVector<f64>>,
    natural: &[DVector<f64>],
    metric: &Metric,
) -> Result<Vec<(f64, DVector<f64>)>, StructureError> {
    let natural: Vec<(&DVector<f64>, DVector<f64>)> =
        natural.iter().map(|mode| (mode, metric.mass * mode)).collect();
    let columns: Vec<_> =
        strained.into_iter().filter_map(|shape| without(&natural, shape, metric.mass)).collect();
    if columns.is_empty() {
        return Ok(Vec::new());
    }
    let shapes = DMatrix::from_columns(&columns);
    let gram = SymmetricEigen::try_new(of(metric.mass, &shapes), f64::EPSILON, MAX_ITERATIONS)
        .ok_or(StructureError::EigenvaluesNotFound)?;
    let largest = gram.eigenvalues.max();
    let kept = (0..columns.len()).filter(|&i| gram.eigenvalues[i] >= DEPENDENT * largest);
    let kept: Vec<_> = kept.map(|i| gram.eigenvectors.column(i) / gram.eigenvalues[i].sqrt()).collect();
    if kept.is_empty() {
        return Err(StructureError::NotFinite);
    }
    let shapes = shapes * DMatrix::from_columns(&kept);
    let ritz = SymmetricEigen::try_new(of(metric.stiffness, &shapes), f64::EPSILON, MAX_ITERATIONS)
        .ok_or(StructureError::EigenvaluesNotFound)?;
    if !ritz.eigenvalues.iter().all(|square| square.is_finite() && *square > 0.0) {
        return Err(StructureError::NotFinite);
    }
    let mut order: Vec<usize> = (0..kept.len()).collect();
    order.sort_by(|&a, &b| ritz.eigenvalues[a].total_cmp(&ritz.eigenvalues[b]));
    let mode = |i: usize| (ritz.eigenvalues[i].sqrt(), &shapes * ritz.eigenvectors.column(i));
    Ok(order.into_iter().map(mode).collect())
}

/// What the natural modes, each with its product with the mass, leave of a shape: of unit mass; `None` if it is nothing.
fn without(
    natural: &[(&DVector<f64>, DVector<f64>)],
    mut shape: DVector<f64>,
    mass: &DMatrix<f64>,
) -> Option<DVector<f64>> {
    let norm = |shape: &DVector<f64>| shape.dot(&(mass * shape)).max(0.0).sqrt();
    let before = norm(&shape);
    // Twice, for what rounding leaves of large parts.
    for _ in 0..2 {
        let parts: Vec<f64> = natural.iter().map(|(_, of_mass)| of_mass.dot(&shape)).collect();
        for ((mode, _), part) in natural.iter().zip(parts) {
            shape.axpy(-part, mode, 1.0);
        }
    }
    let left = norm(&shape);
    (left > OF_NATURAL_MODES * before).then(|| shape / left)
}

/// XᵀAX, made self-adjoint to the last digit.
fn of(matrix: &DMatrix<f64>, shapes: &DMatrix<f64>) -> DMatrix<f64> {
    let product = shapes.transpose() * (matrix * shapes);
    (&product + product.transpose()) * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The load modes of two coordinates with these stiffnesses, strained by one load.
    fn of_stiffnesses(stiffnesses: [f64; 2]) -> Result<Vec<(f64, DVector<f64>)>, StructureError> {
        let stiffness = DMatrix::from_diagonal(&DVector::from_column_slice(&stiffnesses));
        let metric = Metric { mass: &DMatrix::identity(2, 2), stiffness: &stiffness };
        load_modes(vec![DVector::from_column_slice(&[3.0, 4.0])], &[], &metric)
    }

    #[test]
    fn a_load_mode_without_a_frequency_is_refused() {
        assert_eq!(of_stiffnesses([25.0, 25.0]).unwrap()[0].0, 5.0);
        assert_eq!(of_stiffnesses([f64::INFINITY, 1.0]).unwrap_err(), StructureError::NotFinite);
        assert_eq!(of_stiffnesses([-25.0, 1.0]).unwrap_err(), StructureError::NotFinite);
    }
}

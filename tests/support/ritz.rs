//! A beam in few modes of one's own choice (Ritz), where natural modes would converge slowly.

use flexible_aircraft::structure::{ModalBasis, Mode, ModeFamily, Structure};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Three bending modes in y of a beam along x, the static stretch under tension and under its own centrifugal force,
/// and for each pair of bending modes the axial motion −½∫ w_a′w_b′ dx that lets the beam shorten as it bends.
pub fn bending_and_shortening(structure: &Structure) -> DMatrix<f64> {
    let basis = ModalBasis::new(structure, 8).unwrap();
    let tip = structure.unknowns() - 6;
    let in_plane = |column: &DVector<f64>| column[tip + 1].abs() > 0.5 * column.rows(tip, 3).norm();
    let columns: Vec<DVector<f64>> =
        basis.shapes.column_iter().map(|column| column.clone_owned()).filter(in_plane).take(3).collect();
    let mut all = columns.clone();
    let elements = structure.geometry.len();
    let step = structure.geometry[0].length;
    let axial = |u: &dyn Fn(usize) -> f64| {
        let mut column = DVector::zeros(structure.unknowns());
        (1..=elements).for_each(|node| column[6 * (node - 1)] = u(node));
        column
    };
    all.push(axial(&|node| node as f64 * step));
    all.push(axial(&|node| (node as f64 * step).powi(3)));
    for a in 0..columns.len() {
        for b in a..columns.len() {
            let mut shortening = vec![0.0];
            for (element, geometry) in structure.geometry.iter().enumerate() {
                let slope = |place: f64, column: &DVector<f64>| {
                    let shape = DMatrix::from_columns(std::slice::from_ref(column));
                    structure.apply_row(element, &geometry.gradients(place).slope_v, &shape)[0]
                };
                // Three-point Gauss rule: exact for the quartic slope squared.
                let gauss = [
                    (0.112_701_665_379_258_3, 5.0 / 18.0),
                    (0.5, 8.0 / 18.0),
                    (0.887_298_334_620_741_7, 5.0 / 18.0),
                ];
                let sum: f64 =
                    gauss.iter().map(|&(x, w)| w * slope(x, &columns[a]) * slope(x, &columns[b])).sum();
                shortening.push(shortening[element] - 0.5 * step * sum);
            }
            all.push(axial(&|node| shortening[node]));
        }
    }
    all.iter_mut().for_each(|column| *column /= column.amax());
    DMatrix::from_columns(&all)
}

/// Modes within the span of trial shapes, mass-normalised; those that move nearly alike count once.
pub fn ritz_modes(structure: &Structure, trial: &DMatrix<f64>) -> (Vec<Mode>, DMatrix<f64>) {
    let mass = trial.transpose() * structure.mass() * trial;
    let eigen = SymmetricEigen::new(mass);
    let kept: Vec<usize> =
        (0..trial.ncols()).filter(|&i| eigen.eigenvalues[i] > 1e-9 * eigen.eigenvalues.max()).collect();
    let columns: Vec<_> = kept
        .iter()
        .map(|&i| trial * eigen.eigenvectors.column(i) / libm::sqrt(eigen.eigenvalues[i]))
        .collect();
    let normal = DMatrix::from_columns(&columns);
    let eigen = SymmetricEigen::new(normal.transpose() * structure.stiffness(false) * &normal);
    let modes = eigen.eigenvalues.iter().map(|square| Mode {
        family: ModeFamily::Unsymmetric,
        angular_frequency: libm::sqrt(*square),
        completes_a_pair: false,
        of_loads: false,
    });
    (modes.collect(), normal * eigen.eigenvectors)
}

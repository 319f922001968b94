//! Natural modes of the aircraft as it flies: free, in air, about one state [theory: linearisation.free-modes].
//!
//! The generalised coordinates belong to the clamped structure. In flight the rigid motion answers every
//! deformation and air moves along, so that the coordinates swing in other combinations q = Qz and at other
//! frequencies. With ν̇ = A⁻¹F they follow from W = (A⁻¹)_qq and the derivatives of q̈ with the wake at rest: Q
//! makes W⁻¹ the unit matrix and the self-adjoint part of −W⁻¹ ∂q̈/∂q diagonal.

use nalgebra::{Cholesky, DMatrix, SymmetricEigen};

use crate::equations::{Controls, EquationsOfMotion, Workspace};
use crate::math::central;

/// Sweeps of the eigenvalue solver; more have never been needed.
const MOST_SWEEPS: usize = 1000;

/// Slower modes (rad/s) count as this fast.
const SLOWEST: f64 = 1.0;

/// Stronger damping, as a share of critical damping, counts as this strong.
const STRONGEST: f64 = 0.9;

/// The modes, as many as generalised coordinates.
#[derive(Clone, Debug)]
pub struct FreeModes {
    /// Q, one column per mode.
    pub shapes: DMatrix<f64>,
    /// Q⁻¹.
    pub inverse: DMatrix<f64>,
    /// ζω of each mode, 1/s.
    pub decay: Vec<f64>,
    /// ω √(1 − ζ²) of each mode, rad/s; positive.
    pub frequency: Vec<f64>,
}

impl FreeModes {
    /// About a state. Allocates. `None` when the motion there has no such modes, as without modes of the structure.
    pub fn new(equations: &EquationsOfMotion, state: &[f64], controls: &Controls) -> Option<Self> {
        let n = equations.layout().modes();
        let mut workspace = Workspace::new(equations);
        let mobility = equations.elastic_mobility(state, controls, &mut workspace)?;
        let root = Cholesky::new(mobility)?.unpack();
        let inverse_root = root.clone().try_inverse()?;
        let layout = *equations.layout();
        let by_coordinates =
            derivatives(equations, state, controls, layout.coordinates().start, &mut workspace);
        let by_rates =
            derivatives(equations, state, controls, layout.coordinate_rates().start, &mut workspace);

        let stiffness = -(&inverse_root * by_coordinates * &root);
        let self_adjoint = (&stiffness + stiffness.transpose()) * 0.5;
        if n == 0 || !self_adjoint.iter().chain(by_rates.iter()).all(|x| x.is_finite()) {
            return None;
        }
        let SymmetricEigen { eigenvectors, eigenvalues } =
            SymmetricEigen::try_new(self_adjoint, f64::EPSILON, MOST_SWEEPS)?;
        let shapes = root * &eigenvectors;
        let inverse = eigenvectors.transpose() * inverse_root;
        let damping = -(&inverse * by_rates * &shapes);
        let decay_and_frequency = |mode: usize| {
            let square = eigenvalues[mode].max(SLOWEST * SLOWEST);
            let decay = (0.5 * damping[(mode, mode)]).clamp(0.0, STRONGEST * libm::sqrt(square));
            (decay, libm::sqrt(square - decay * decay))
        };
        let (decay, frequency) = (0..n).map(decay_and_frequency).unzip();
        Some(FreeModes { shapes, inverse, decay, frequency })
    }
}

/// ∂q̈/∂y for the n states from `first` on, by central differences.
fn derivatives(
    equations: &EquationsOfMotion,
    state: &[f64],
    controls: &Controls,
    first: usize,
    workspace: &mut Workspace,
) -> DMatrix<f64> {
    let n = equations.layout().modes();
    let (mut moved, mut rates) = (state.to_vec(), vec![0.0; state.len()]);
    let step = 1e-3 * equations.coordinate_magnitude();
    let mut accelerations = |moved: &[f64]| {
        equations.rates(moved, controls, &mut rates, workspace);
        rates[equations.layout().coordinate_rates()].to_vec()
    };
    let mut matrix = DMatrix::zeros(n, n);
    for column in 0..n {
        let value = state[first + column];
        moved[first + column] = value + step;
        let ahead = accelerations(&moved);
        moved[first + column] = value - step;
        let behind = accelerations(&moved);
        moved[first + column] = value;
        for row in 0..n {
            matrix[(row, column)] = central([behind[row], ahead[row]], step);
        }
    }
    matrix
}

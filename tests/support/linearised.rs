//! The jet linearised at a trim, and single eigenvalues of it.

use flexible_aircraft::dynamics::{
    Configuration, Controls, EquationsOfMotion, Fidelity, Trim, TrimCondition, Workspace,
};
use flexible_aircraft::structure::ModeFamily;
use nalgebra::{Complex, DMatrix, DVector, Vector3};

use super::jet;

/// The state matrix of the jet with 8 symmetric modes and N = 5 at its trim at 7620 m, by central differences.
pub fn state_matrix(fidelity: Fidelity, stiffness_scale: f64, airspeed: f64) -> DMatrix<f64> {
    let (equations, trim) = trimmed(fidelity, stiffness_scale, airspeed, 5);
    linearise(&equations, &trim)
}

/// The jet's equations with 8 symmetric modes and their trim at 7620 m.
pub fn trimmed(
    fidelity: Fidelity,
    stiffness_scale: f64,
    airspeed: f64,
    inflow_states: usize,
) -> (EquationsOfMotion, Trim) {
    let jet = jet();
    let symmetric = (0..jet.modes.len()).filter(|&mode| jet.modes[mode].family == ModeFamily::Symmetric);
    let chosen: Vec<_> = if fidelity == Fidelity::Rigid { Vec::new() } else { symmetric.take(8).collect() };
    let configuration = Configuration {
        fidelity,
        stiffness_scale,
        structural_damping: 0.0,
        inflow_states,
        tunnel_flow: Vector3::zeros(),
    };
    let equations = EquationsOfMotion::new(&jet.select(&chosen), &configuration);
    let trim = equations.trim(&TrimCondition { airspeed, altitude: 7620.0, heading: 0.0 }).unwrap();
    (equations, trim)
}

/// The state matrix at a trim, by central differences.
pub fn linearise(equations: &EquationsOfMotion, trim: &Trim) -> DMatrix<f64> {
    let mut controls = Controls::neutral(2);
    controls.elevator = trim.elevator;
    controls.thrust.fill(trim.thrust);

    let n = trim.state.len();
    let mut workspace = Workspace::new(equations);
    let mut matrix = DMatrix::zeros(n, n);
    for column in 0..n {
        let mut rates = [vec![0.0; n], vec![0.0; n]];
        let step = 1e-5;
        for (rates, sign) in rates.iter_mut().zip([1.0, -1.0]) {
            let mut state = trim.state.clone();
            state[column] += sign * step;
            equations.rates(&state, &controls, rates, &mut workspace);
        }
        for row in 0..n {
            matrix[(row, column)] = (rates[0][row] - rates[1][row]) / (2.0 * step);
        }
    }
    matrix
}

/// The eigenvalue nearest to a guess, by inverse iteration.
pub fn eigenvalue_near(matrix: &DMatrix<f64>, guess: Complex<f64>) -> Complex<f64> {
    let n = matrix.nrows();
    let shifted = matrix.map(Complex::from) - DMatrix::identity(n, n) * guess;
    let factors = shifted.lu();
    let mut vector = DVector::from_fn(n, |i, _| Complex::new(1.0, libm::sin(i as f64)));
    let mut eigenvalue = guess;
    for _ in 0..200 {
        vector /= Complex::from(vector.norm());
        let next = factors.solve(&vector).unwrap();
        let moved = guess + vector.dotc(&next).inv();
        vector = next;
        if (moved - eigenvalue).norm() < 1e-12 * moved.norm() {
            return moved;
        }
        eigenvalue = moved;
    }
    panic!("no eigenvalue found near {guess}");
}

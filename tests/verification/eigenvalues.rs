//! Eigenvalues of the trimmed jet are those of physics.md §8 (N = 5, 8 symmetric modes, 127 m/s).

use flexible_aircraft::dynamics::{
    Configuration, Controls, EquationsOfMotion, Fidelity, TrimCondition, Workspace,
};
use flexible_aircraft::structure::ModeFamily;
use nalgebra::{Complex, DMatrix, Schur, Vector3};

use crate::support::jet;

/// Eigenvalues of the linearised equations at the trim, by central differences.
fn eigenvalues(fidelity: Fidelity, stiffness_scale: f64) -> Vec<Complex<f64>> {
    let jet = jet();
    let symmetric = (0..jet.modes.len()).filter(|&mode| jet.modes[mode].family == ModeFamily::Symmetric);
    let chosen: Vec<_> = if fidelity == Fidelity::Rigid { Vec::new() } else { symmetric.take(8).collect() };
    let configuration = Configuration {
        fidelity,
        stiffness_scale,
        structural_damping: 0.0,
        inflow_states: 5,
        tunnel_flow: Vector3::zeros(),
    };
    let equations = EquationsOfMotion::new(&jet.select(&chosen), &configuration);
    let trim = equations.trim(&TrimCondition { airspeed: 127.0, altitude: 7620.0, heading: 0.0 }).unwrap();
    let mut controls = Controls::neutral(2);
    controls.elevator = trim.elevator;
    controls.thrust.fill(trim.thrust);

    let n = trim.state.len();
    let mut workspace = Workspace::new(&equations);
    let mut jacobian = DMatrix::zeros(n, n);
    for column in 0..n {
        let mut rates = [vec![0.0; n], vec![0.0; n]];
        let step = 1e-5;
        for (rates, sign) in rates.iter_mut().zip([1.0, -1.0]) {
            let mut state = trim.state.clone();
            state[column] += sign * step;
            equations.rates(&state, &controls, rates, &mut workspace);
        }
        for row in 0..n {
            jacobian[(row, column)] = (rates[0][row] - rates[1][row]) / (2.0 * step);
        }
    }
    Schur::try_new(jacobian, f64::EPSILON, 100_000).unwrap().complex_eigenvalues().iter().copied().collect()
}

fn assert_has(name: &str, eigenvalues: &[Complex<f64>], expected: Complex<f64>) {
    let nearest = eigenvalues
        .iter()
        .min_by(|a, b| (**a - expected).norm().total_cmp(&(**b - expected).norm()))
        .unwrap();
    let error = (nearest - expected).norm() / expected.norm();
    assert!(error < 5e-3, "{name}: {nearest}, expected {expected}");
}

#[test]
fn phugoid_short_period_and_first_elastic_mode_are_the_published_ones() {
    let c = Complex::new;
    for (name, fidelity, stiffness, expected) in [
        ("rigid", Fidelity::Rigid, 1.0, vec![c(-0.0110, 0.1155), c(-0.529, 1.210)]),
        ("exact", Fidelity::Exact, 1.0, vec![c(-0.0112, 0.1162), c(-0.534, 1.186), c(-1.465, 15.55)]),
        (
            "exact, one tenth",
            Fidelity::Exact,
            0.1,
            vec![c(-0.0142, 0.1233), c(-0.186, 9.750), c(-1.140, 8.749)],
        ),
        // physics.md §10: CL's slowly growing mode at one-tenth stiffness.
        ("CL, one tenth", Fidelity::ConsistentlyLinearised, 0.1, vec![c(0.30, 33.8)]),
    ] {
        let found = eigenvalues(fidelity, stiffness);
        for expected in expected {
            assert_has(name, &found, expected);
        }
    }
}

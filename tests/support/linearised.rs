//! The jet linearised at a trim, and single eigenvalues of it.

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{Plant, PlantSettings, Trim};
use nalgebra::{Complex, DMatrix, DVector};

use super::{eight_symmetric, jet};

/// The state matrix of the jet with 8 symmetric modes and N = 5 at its trim at 7620 m.
pub fn state_matrix(fidelity: Fidelity, stiffness_scale: f64, airspeed: f64) -> DMatrix<f64> {
    let (plant, trim) = trimmed(fidelity, stiffness_scale, airspeed, 5);
    plant.linearise(&trim).matrix
}

/// The jet's plant with 8 symmetric modes and their trim at 7620 m.
pub fn trimmed(
    fidelity: Fidelity,
    stiffness_scale: f64,
    airspeed: f64,
    inflow_states: usize,
) -> (Plant, Trim) {
    let settings = Settings::from(PlantSettings {
        fidelity,
        stiffness_scale,
        airspeed,
        inflow_states,
        ..eight_symmetric().plant
    });
    let plant = Plant::under(&jet(), &settings.plant).unwrap();
    let trim = plant.trim(&settings.plant.trim_condition()).unwrap();
    (plant, trim)
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

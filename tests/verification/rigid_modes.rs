//! The phugoid and the short period of the rigid aircraft are those of the textbooks, as far as these go.

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{Plant, StateMatrix, Trim, Unknown};
use nalgebra::{Complex, DMatrix, Matrix2, Matrix3};

use crate::support::jet;
use crate::support::linearised::{eigenvalue_near, trimmed};

use super::record::Record;

const SPEED: f64 = 127.0;
const ALTITUDE: f64 = 7620.0;

/// The matrix of longitudinal motion in stability axes on [u, θ, h, w, q], without wake states.
fn longitudinal(plant: &Plant, trim: &Trim) -> DMatrix<f64> {
    let StateMatrix { unknowns, matrix } = plant.linearise(trim);
    let place = |wanted| unknowns.iter().position(|unknown| *unknown == wanted).unwrap();
    let (x, z) = (place(Unknown::Velocity(0)), place(Unknown::Velocity(2)));
    let (sin, cos) = libm::sincos(trim.point.pitch);
    // How each variable moves the unknowns, and how it is read from their rates.
    let moves = [
        vec![(x, cos), (z, sin)],
        vec![(place(Unknown::Pitch), 1.0)],
        vec![(place(Unknown::Down), -1.0)],
        vec![(x, -sin), (z, cos)],
        vec![(place(Unknown::Rate(1)), 1.0)],
    ];
    let mut chosen = DMatrix::zeros(unknowns.len(), moves.len());
    for (variable, terms) in moves.iter().enumerate() {
        for &(unknown, factor) in terms {
            chosen[(unknown, variable)] = factor;
        }
    }
    chosen.transpose() * matrix * chosen
}

/// The oscillation of a 3 × 3 matrix.
fn slowest(matrix: &DMatrix<f64>) -> Complex<f64> {
    let matrix = Matrix3::from_fn(|i, j| matrix[(i, j)]);
    oscillation(matrix.complex_eigenvalues().iter().copied())
}

/// The eigenvalue of largest imaginary part.
fn oscillation(eigenvalues: impl IntoIterator<Item = Complex<f64>>) -> Complex<f64> {
    eigenvalues.into_iter().max_by(|a, b| a.im.total_cmp(&b.im)).unwrap()
}

#[test]
fn phugoid_and_short_period_are_those_of_the_textbooks() {
    let mut record = Record::new(
        "rigid-modes",
        "Rigid jet at 127 m/s, 7620 m: eigenvalues (1/s) of all equations against approximations",
        "Lanchester: ω = √2 g/V, real part −(g/V)(D/L) at constant thrust; with the fall of density, ω² = 2g²/V² − gρ′/ρ; \
         short period at constant speed, and phugoid with w and q in equilibrium, from the derivatives (Etkin, Reid, *Dynamics \
         of Flight*, chapter 6; Cook, *Flight Dynamics Principles*, chapter 6)",
    );
    let (plant, trim) = trimmed(Fidelity::Rigid, 1.0, SPEED, 0);
    let matrix = longitudinal(&plant, &trim);
    let phugoid = eigenvalue_near(&matrix, Complex::new(-0.011, 0.116));
    let short_period = eigenvalue_near(&matrix, Complex::new(-0.53, 1.21));

    let block = Matrix2::from_fn(|i, j| matrix[(3 + i, 3 + j)]);
    let constant_speed = oscillation(block.complex_eigenvalues().iter().copied());
    both(&mut record, "short period at constant speed", constant_speed, [0.003, 0.01], short_period);
    against_lanchester(&mut record, &plant, &trim, phugoid);
    with_fast_motion_eliminated(&mut record, &matrix, phugoid);

    let (unsteady, trim) = trimmed(Fidelity::Rigid, 1.0, SPEED, 5);
    let unsteady = unsteady.linearise(&trim).matrix;
    both(
        &mut record,
        "short period with N = 5 against N = 0",
        short_period,
        [0.025, 0.04],
        eigenvalue_near(&unsteady, short_period),
    );
    both(
        &mut record,
        "phugoid with N = 5 against N = 0",
        phugoid,
        [0.02, 1e-3],
        eigenvalue_near(&unsteady, phugoid),
    );
    record.remark(
        "Why they deviate. Lanchester's aircraft neither pitches against its flight path nor climbs into thinner air: the fall of \
         density alone raises the frequency by 5 %, and the rest of it comes from w and q. The damping is 14 % below Lanchester's \
         because w and q follow late: the short period is only ten times faster. Speed varies little in the short period, so the \
         approximation at constant speed is good to 1 %; the wake (N = 5) makes it faster and the phugoid less damped.",
    );
    record.finish();
}

/// Lanchester's phugoid, and the same in air that thins with height.
fn against_lanchester(record: &mut Record, plant: &Plant, trim: &Trim, phugoid: Complex<f64>) {
    let gravity = jet().gravity;
    let weight = plant.equations().integrals().mass * gravity;
    let (sin, cos) = libm::sincos(trim.point.pitch);
    let drag_over_lift = 2.0 * trim.point.thrust * cos / (weight - 2.0 * trim.point.thrust * sin);
    let lanchester = Complex::new(-gravity / SPEED * drag_over_lift, libm::sqrt(2.0) * gravity / SPEED);
    both(record, "phugoid, Lanchester", lanchester, [0.15, 0.06], phugoid);
    // ISA: ρ′/ρ = −(g₀/R − 0.0065)/T.
    let gradient = -(9.80665 / 287.05287 - 0.0065) / (288.15 - 0.0065 * ALTITUDE);
    let rising = libm::sqrt(2.0 * (gravity / SPEED).powi(2) - gravity * gradient);
    record.relative("phugoid with the fall of density: frequency", rising, 0.012, phugoid.im);
}

/// The phugoid with w and q in equilibrium, and following late.
fn with_fast_motion_eliminated(record: &mut Record, matrix: &DMatrix<f64>, phugoid: Complex<f64>) {
    let part = |rows: std::ops::Range<usize>, columns: std::ops::Range<usize>| {
        matrix.view((rows.start, columns.start), (rows.len(), columns.len())).into_owned()
    };
    let fast = part(3..5, 3..5).try_inverse().unwrap();
    let coupling = part(0..3, 3..5) * &fast;
    let slow = part(0..3, 0..3) - &coupling * part(3..5, 0..3);
    let in_equilibrium = slowest(&slow);
    record.relative("phugoid, w and q in equilibrium: frequency", in_equilibrium.im, 0.01, phugoid.im);
    let lag = DMatrix::identity(3, 3) + coupling * &fast * part(3..5, 0..3);
    let lagging = slowest(&(lag.try_inverse().unwrap() * slow));
    both(record, "phugoid, w and q following with their lag", lagging, [1e-3, 4e-3], phugoid);
}

/// Real and imaginary part.
fn both(
    record: &mut Record,
    case: &str,
    reference: Complex<f64>,
    [real, imaginary]: [f64; 2],
    found: Complex<f64>,
) {
    record.relative(&format!("{case}: real part"), reference.re, real, found.re);
    record.relative(&format!("{case}: frequency"), reference.im, imaginary, found.im);
}

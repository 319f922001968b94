//! Eigenvalues of the trimmed jet with N = 5 and 8 symmetric modes at 127 m/s [theory: thesis-runs.eigenvalues].

use flexible_aircraft::equations::Fidelity;
use nalgebra::Complex;

use crate::support::linearised::{eigenvalue_near, state_matrix};

use super::record::Record;

/// Real and imaginary parts (1/s) as printed, with half a unit of the last digit of each.
type Published = &'static [(f64, f64, [f64; 2])];

const FOUR_DIGITS: [f64; 2] = [5e-5; 2];
const THREE_DIGITS: [f64; 2] = [5e-4; 2];

fn check(record: &mut Record, fidelity: Fidelity, stiffness_scale: f64, published: Published) {
    let matrix = state_matrix(fidelity, stiffness_scale, 127.0);
    for &(re, im, rounding) in published {
        let found = eigenvalue_near(&matrix, Complex::new(re, im));
        let case = format!("{fidelity:?} × {stiffness_scale}");
        record.absolute(&format!("{case}: real part"), re, 1.2 * rounding[0], found.re);
        record.absolute(&format!("{case}: imaginary part"), im, 1.2 * rounding[1], found.im);
    }
}

#[test]
fn the_eigenvalues_of_the_trimmed_jet_are_the_published_ones() {
    let mut record = Record::new(
        "eigenvalues",
        "Eigenvalues of the trimmed jet, 1/s: N = 5, 8 symmetric modes, 127 m/s, 7620 m",
        "[theory: thesis-runs.eigenvalues]; the tolerance is 0.6 units of the last published digit",
    );
    let rigid = &[(-0.0108, 0.1154, FOUR_DIGITS), (-0.5289, 1.2093, FOUR_DIGITS)];
    check(&mut record, Fidelity::Rigid, 1.0, rigid);
    let nominal =
        &[(-0.0110, 0.1161, FOUR_DIGITS), (-0.5336, 1.1854, FOUR_DIGITS), (-1.4649, 15.5505, FOUR_DIGITS)];
    check(&mut record, Fidelity::Exact, 1.0, nominal);
    let soft =
        &[(-0.0140, 0.1233, FOUR_DIGITS), (-0.2142, 9.7578, FOUR_DIGITS), (-1.1087, 8.7422, FOUR_DIGITS)];
    check(&mut record, Fidelity::Exact, 0.1, soft);
    check(&mut record, Fidelity::ConsistentlyLinearised, 0.1, &[(0.30, 33.8, [5e-2; 2])]);
    record.finish();
}

#[test]
fn the_eigenvalues_of_the_geometrically_exact_jet_are_those_of_an_independent_computation() {
    let mut record = Record::new(
        "eigenvalues-geometrically-exact",
        "Geometrically exact: eigenvalues of the same jet, 1/s",
        "an independent computation of [theory: geometrically-exact.recursion] with the same modes and strips; the tolerance is 0.6 units of its last digit",
    );
    let nominal = &[
        (-0.0110, 0.1158, FOUR_DIGITS),
        (-0.5335, 1.1880, FOUR_DIGITS),
        (-1.528, 14.687, THREE_DIGITS),
        (-0.0161, 26.449, [5e-5, 5e-4]),
    ];
    check(&mut record, Fidelity::GeometricallyExact, 1.0, nominal);
    let soft = &[
        (-0.0117, 0.0961, FOUR_DIGITS),
        (-0.3597, 1.2046, FOUR_DIGITS),
        (-1.662, 5.993, THREE_DIGITS),
        (-0.0617, 8.365, [5e-5, 5e-4]),
        (-0.704, 12.856, THREE_DIGITS),
    ];
    check(&mut record, Fidelity::GeometricallyExact, 0.1, soft);
    record.finish();
}

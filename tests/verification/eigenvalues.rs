//! Eigenvalues of the trimmed jet with N = 5 and 8 symmetric modes at 127 m/s [theory: thesis-runs.eigenvalues].

use flexible_aircraft::equations::Fidelity;
use nalgebra::Complex;

use crate::support::linearised::{eigenvalue_near, state_matrix};

use super::record::Record;

/// Published eigenvalues (1/s) with half a unit of their last digit.
type Published = &'static [(f64, f64, f64)];

fn check(record: &mut Record, fidelity: Fidelity, stiffness_scale: f64, published: Published) {
    let matrix = state_matrix(fidelity, stiffness_scale, 127.0);
    for &(re, im, rounding) in published {
        let found = eigenvalue_near(&matrix, Complex::new(re, im));
        let case = format!("{fidelity:?} × {stiffness_scale}");
        record.absolute(&format!("{case}: real part"), re, 1.2 * rounding, found.re);
        record.absolute(&format!("{case}: imaginary part"), im, 1.2 * rounding, found.im);
    }
}

#[test]
fn the_eigenvalues_of_the_trimmed_jet_are_the_published_ones() {
    let mut record = Record::new(
        "eigenvalues",
        "Eigenvalues of the trimmed jet, 1/s: N = 5, 8 symmetric modes, 127 m/s, 7620 m",
        "[theory: thesis-runs.eigenvalues]; the tolerance is 0.6 units of the last published digit",
    );
    let rigid = &[(-0.0108, 0.1154, 5e-5), (-0.5289, 1.2093, 5e-5)];
    check(&mut record, Fidelity::Rigid, 1.0, rigid);
    let nominal = &[(-0.0110, 0.1161, 5e-5), (-0.5336, 1.1854, 5e-5), (-1.4649, 15.5505, 5e-5)];
    check(&mut record, Fidelity::Exact, 1.0, nominal);
    let soft = &[(-0.0140, 0.1233, 5e-5), (-0.2142, 9.7578, 5e-5), (-1.1087, 8.7422, 5e-5)];
    check(&mut record, Fidelity::Exact, 0.1, soft);
    check(&mut record, Fidelity::ConsistentlyLinearised, 0.1, &[(0.30, 33.8, 5e-2)]);
    record.finish();
}

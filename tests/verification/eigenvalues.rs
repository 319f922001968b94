//! Eigenvalues of the trimmed jet are those of physics.md §8 (N = 5, 8 symmetric modes, 127 m/s).

use flexible_aircraft::simulation::Fidelity;
use nalgebra::Complex;

use super::record::Record;
use crate::support::linearised::{eigenvalue_near, state_matrix};

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
        "physics.md §8 and §10; the tolerance is 0.6 units of the last published digit",
    );
    let rigid = &[(-0.0110, 0.1155, 5e-5), (-0.529, 1.210, 5e-4)];
    check(&mut record, Fidelity::Rigid, 1.0, rigid);
    let nominal = &[(-0.0112, 0.1162, 5e-5), (-0.534, 1.186, 5e-4), (-1.465, 15.55, 5e-3)];
    check(&mut record, Fidelity::Exact, 1.0, nominal);
    let soft = &[(-0.0142, 0.1233, 5e-5), (-0.186, 9.750, 5e-4), (-1.140, 8.749, 5e-4)];
    check(&mut record, Fidelity::Exact, 0.1, soft);
    check(&mut record, Fidelity::ConsistentlyLinearised, 0.1, &[(0.30, 33.8, 5e-2)]);
    record.finish();
}

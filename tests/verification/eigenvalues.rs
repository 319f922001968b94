//! Eigenvalues of the trimmed jet are those of physics.md §8 (N = 5, 8 symmetric modes, 127 m/s).

use flexible_aircraft::simulation::Fidelity;
use nalgebra::Complex;

use crate::support::linearised::{eigenvalue_near, state_matrix};

/// Published eigenvalues (1/s) with half a unit of their last digit.
type Published = &'static [(f64, f64, f64)];

fn check(fidelity: Fidelity, stiffness_scale: f64, published: Published) {
    let matrix = state_matrix(fidelity, stiffness_scale, 127.0);
    for &(re, im, rounding) in published {
        let published = Complex::new(re, im);
        let found = eigenvalue_near(&matrix, published);
        println!("{fidelity:?} × {stiffness_scale}: {found:.5}, published {published}");
        assert!(
            (found - published).norm() < 1.5 * rounding,
            "{fidelity:?} × {stiffness_scale}: {found}, published {published}"
        );
    }
}

#[test]
fn the_rigid_phugoid_and_short_period_are_the_published_ones() {
    check(Fidelity::Rigid, 1.0, &[(-0.0110, 0.1155, 5e-5), (-0.529, 1.210, 5e-4)]);
}

#[test]
fn the_exact_phugoid_short_period_and_first_elastic_mode_are_the_published_ones() {
    let published = &[(-0.0112, 0.1162, 5e-5), (-0.534, 1.186, 5e-4), (-1.465, 15.55, 5e-3)];
    check(Fidelity::Exact, 1.0, published);
}

#[test]
fn the_exact_modes_at_one_tenth_stiffness_are_the_published_ones() {
    let published = &[(-0.0142, 0.1233, 5e-5), (-0.186, 9.750, 5e-4), (-1.140, 8.749, 5e-4)];
    check(Fidelity::Exact, 0.1, published);
}

#[test]
fn the_consistently_linearised_model_grows_slowly_at_one_tenth_stiffness() {
    // physics.md §10.
    check(Fidelity::ConsistentlyLinearised, 0.1, &[(0.30, 33.8, 5e-2)]);
}

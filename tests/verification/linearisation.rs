//! The state matrix of a trimmed aircraft: kinematics that are known exactly, and what it leaves out.

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{Plant, PlantSettings, StateMatrix, Unknown};
use flexible_aircraft::symmetry::Plants;
use nalgebra::Complex;

use crate::support::{eight_symmetric, jet};

/// The jet with 8 symmetric modes at 127 m/s, and its pitch angle.
fn trimmed() -> (StateMatrix, f64) {
    let settings = eight_symmetric();
    let equations = Plant::under(&jet(), &settings.plant).unwrap();
    let trim = equations.trim(&settings.plant.trim_condition()).unwrap();
    (equations.linearise(&trim), trim.point.pitch)
}

/// ∂(rate of `row`)/∂`column`.
fn entry(StateMatrix { unknowns, matrix }: &StateMatrix, row: Unknown, column: Unknown) -> f64 {
    let index = |wanted| unknowns.iter().position(|unknown| *unknown == wanted).unwrap();
    matrix[(index(row), index(column))]
}

#[test]
fn the_kinematic_rows_are_exact() {
    let (a, pitch) = trimmed();
    let expected = [
        (Unknown::Down, Unknown::Velocity(0), -pitch.sin()),
        (Unknown::Down, Unknown::Velocity(2), pitch.cos()),
        (Unknown::Down, Unknown::Pitch, -127.0),
        (Unknown::Down, Unknown::Down, 0.0),
        (Unknown::Pitch, Unknown::Rate(1), 1.0),
        (Unknown::Roll, Unknown::Rate(0), 1.0),
        (Unknown::Roll, Unknown::Rate(2), pitch.tan()),
        (Unknown::Coordinate(3), Unknown::CoordinateRate(3), 1.0),
        (Unknown::Coordinate(3), Unknown::CoordinateRate(4), 0.0),
    ];
    for (row, column, expected) in expected {
        let found = entry(&a, row, column);
        assert!((found - expected).abs() < 1e-9, "∂{row:?}/∂{column:?} = {found}, expected {expected}");
    }
}

#[test]
fn longitudinal_and_lateral_motion_do_not_couple() {
    let (a, _) = trimmed();
    for longitudinal in [Unknown::Velocity(0), Unknown::Velocity(2), Unknown::Rate(1), Unknown::Pitch] {
        for lateral in [Unknown::Velocity(1), Unknown::Rate(0), Unknown::Rate(2), Unknown::Roll] {
            for found in [entry(&a, longitudinal, lateral), entry(&a, lateral, longitudinal)] {
                assert!(found.abs() < 1e-8, "{longitudinal:?}, {lateral:?}: {found}");
            }
        }
    }
}

#[test]
fn a_free_aircraft_keeps_nine_rigid_unknowns_and_a_clamped_one_none() {
    let unknowns = |model: &flexible_aircraft::structure::ReducedModel| {
        let settings =
            Settings::from(PlantSettings { mode_count: 4, inflow_states: 3, ..PlantSettings::of(model) });
        let equations = Plant::under(model, &settings.plant).unwrap();
        equations.linearise(&equations.trim(&settings.plant.trim_condition()).unwrap()).unknowns
    };
    let strips = 3 * jet().strips.len();
    assert_eq!(unknowns(&jet()).len(), 9 + 2 * 4 + strips);
    let mut held = (*jet()).clone();
    held.support = flexible_aircraft::aircraft::Support::Clamped;
    let held = unknowns(&held);
    assert_eq!((held.len(), held[0]), (2 * 4 + strips, Unknown::Coordinate(0)));
}

/// The jet's half and the whole: (unknowns, eigenvalues) of each, with six modes of which some are antisymmetric.
fn half_and_whole(fidelity: Fidelity) -> [(Vec<Unknown>, Vec<Complex<f64>>); 2] {
    let settings = PlantSettings { fidelity, mode_count: 6, inflow_states: 2, ..PlantSettings::of(&jet()) };
    let plants = Plants::under(&jet(), &settings).unwrap();
    [plants.half().unwrap(), plants.whole()].map(|plant| {
        let matrix = plant.linearise(&plant.trim(&settings.trim_condition()).unwrap());
        let eigenvalues = matrix.eigenvalues().unwrap();
        (matrix.unknowns, eigenvalues)
    })
}

#[test]
fn half_an_aircraft_has_the_eigenvalues_of_the_symmetric_motion_of_the_whole_and_no_others() {
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        half_an_aircraft_has_the_eigenvalues_of_the_whole_at(fidelity);
    }
}

fn half_an_aircraft_has_the_eigenvalues_of_the_whole_at(fidelity: Fidelity) {
    let [(unknowns, half), (_, mut whole)] = half_and_whole(fidelity);
    let in_plane = [
        Unknown::Down,
        Unknown::Pitch,
        Unknown::Velocity(0),
        Unknown::Velocity(2),
        Unknown::Rate(1),
        Unknown::Coordinate(0),
    ];
    assert_eq!(unknowns[..6], in_plane);
    // Each is one of the whole's, none of them twice: a spurious zero would find none left.
    for eigenvalue in half {
        let distance = |other: &Complex<f64>| (other - eigenvalue).norm();
        let nearest =
            (0..whole.len()).min_by(|&a, &b| distance(&whole[a]).total_cmp(&distance(&whole[b]))).unwrap();
        let far = distance(&whole.swap_remove(nearest));
        assert!(far < 1e-6 * (1.0 + eigenvalue.norm()), "{eigenvalue}: {far:e}");
    }
}

//! The thesis' levels differ as theory and the thesis say.

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Inputs, Settings};
use flexible_aircraft::plant::PlantSettings;
use nalgebra::Complex;

use crate::support::linearised::{eigenvalue_near, state_matrix};
use crate::support::{ELEVATOR, eight_symmetric, fly, jet, two_three_one_one, up};

use super::record::Record;

/// Those of the thesis.
const FLEXIBLE: [Fidelity; 4] = [
    Fidelity::Exact,
    Fidelity::ConsistentlyLinearised,
    Fidelity::Inconsistent,
    Fidelity::RuthlesslyLinearised,
];

fn elevator(inputs: &mut Inputs, angle: f64) {
    inputs.controls[ELEVATOR] = angle;
}

/// Flies nose-up from the start, a million times stiffer, and gives the largest differences to the rigid
/// aircraft in attitude (rad) and velocity (m/s).
fn differences_to_rigid(fidelity: Fidelity, mode_count: usize, seconds: f64) -> [f64; 2] {
    let flight = |fidelity, stiffness_scale| {
        // The integrator's errors are to be far below what is compared.
        let tolerance = 1e-8;
        let settings = Settings {
            tolerance,
            ..PlantSettings { fidelity, stiffness_scale, mode_count, ..PlantSettings::of(&jet()) }.into()
        };
        fly(&settings, seconds, |_| -0.05, elevator)
    };
    let (rigid, flexible) = (flight(Fidelity::Rigid, 1.0), flight(fidelity, 1e6));
    let turned = rigid.last().unwrap().attitude.y - rigid[0].attitude.y;
    assert!(turned > 1e-3, "the manoeuvre pitched the rigid aircraft by only {turned} rad");
    let (mut attitude, mut velocity) = (0.0_f64, 0.0_f64);
    for (flexible, rigid) in flexible.iter().zip(&rigid) {
        attitude = attitude.max((flexible.attitude - rigid.attitude).norm());
        velocity = velocity.max((flexible.velocity - rigid.velocity).norm());
    }
    [attitude, velocity]
}

#[test]
fn a_million_times_stiffer_every_level_flies_like_the_rigid_aircraft() {
    let mut record = Record::new(
        "rigid-limit",
        "At 10⁶ times the stiffness every level flies like the rigid aircraft: largest difference after 0.05 rad of elevator",
        "the rigid model, itself checked by its eigenvalues; the differences fall with the stiffness",
    );
    for fidelity in FLEXIBLE.into_iter().chain([Fidelity::GeometricallyExact]) {
        let [attitude, velocity] = differences_to_rigid(fidelity, 4, 2.0);
        record.error(&format!("{fidelity:?}, 4 modes, 2 s: attitude, rad"), 1e-7, attitude);
        record.error(&format!("{fidelity:?}, 4 modes, 2 s: velocity, m/s"), 1e-5, velocity);
    }
    // Modes of up to 9 kHz: short, for a cell takes many sub-steps.
    for fidelity in [Fidelity::Exact, Fidelity::GeometricallyExact] {
        let [attitude, velocity] = differences_to_rigid(fidelity, 12, 0.4);
        record.error(&format!("{fidelity:?}, 12 modes, 0.4 s: attitude, rad"), 1e-7, attitude);
        record.error(&format!("{fidelity:?}, 12 modes, 0.4 s: velocity, m/s"), 1e-5, velocity);
    }
    record.finish();
}

#[test]
fn at_one_tenth_stiffness_the_exact_wing_deflects_least() {
    let peaks = FLEXIBLE.map(|fidelity| {
        let settings =
            Settings::from(PlantSettings { fidelity, stiffness_scale: 0.1, ..eight_symmetric().plant });
        let history = fly(&settings, 8.0, two_three_one_one, elevator);
        history.iter().map(|outputs| up(outputs, "wing_tip_right")).fold(0.0, f64::max)
    });
    let [exact, others @ ..] = peaks;
    assert!(others.iter().all(|&peak| exact < 0.7 * peak), "{peaks:?}");
}

#[test]
fn at_one_tenth_stiffness_the_exact_aircraft_is_damped_most() {
    // The slowest mode of wing against fuselage, near 9 rad/s, is the one that rings after a manoeuvre
    // ([theory: thesis-runs.eigenvalues] has it for E: −0.2142 ± 9.7578i at 127 m/s).
    let mut record = Record::new(
        "damping",
        "At one-tenth stiffness the exact aircraft is damped most: its damping over the next best, wing-against-fuselage mode",
        "thesis §5.4, in words; [theory: thesis-runs.eigenvalues] has the exact model's eigenvalue",
    );
    for airspeed in [127.0, 177.8] {
        let dampings = FLEXIBLE.map(|fidelity| {
            let frequency = if fidelity == Fidelity::Exact { 9.7 } else { 8.7 };
            let matrix = state_matrix(fidelity, 0.1, airspeed);
            -eigenvalue_near(&matrix, Complex::new(0.0, frequency)).re
        });
        let [exact, others @ ..] = dampings;
        let next = others.into_iter().fold(0.0, f64::max);
        record.at_least(&format!("{airspeed} m/s"), 1.5, exact / next);
    }
    record.finish();
}

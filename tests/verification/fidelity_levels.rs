//! The five levels differ as theory and the thesis say.

use flexible_aircraft::simulation::{Fidelity, Inputs, Outputs, Settings};

use crate::support::{eight_symmetric, fly, two_three_one_one, up};

const FLEXIBLE: [Fidelity; 4] = [
    Fidelity::Exact,
    Fidelity::ConsistentlyLinearised,
    Fidelity::Inconsistent,
    Fidelity::RuthlesslyLinearised,
];

fn elevator(inputs: &mut Inputs, angle: f64) {
    inputs.elevator = angle;
}

#[test]
fn a_million_times_stiffer_every_level_flies_like_the_rigid_aircraft() {
    let flight = |fidelity, stiffness_scale| {
        let settings = Settings { fidelity, stiffness_scale, mode_count: 4, ..Settings::default() };
        fly(&settings, 6.0, two_three_one_one, elevator)
    };
    let rigid = flight(Fidelity::Rigid, 1.0);
    for fidelity in FLEXIBLE {
        for (flexible, rigid) in flight(fidelity, 1e6).iter().zip(&rigid) {
            let error = (flexible.attitude - rigid.attitude).norm();
            assert!(error < 2e-6, "{fidelity:?}: attitude differs by {error:e} rad");
            let error = (flexible.velocity - rigid.velocity).norm();
            assert!(error < 5e-5, "{fidelity:?}: velocity differs by {error:e} m/s");
        }
    }
}

/// How much of the wing's oscillation is left: mean square rate of the first mode from 10 to 15 s, after the
/// manoeuvre, over that from 2 to 6 s.
fn remaining_oscillation(history: &[Outputs]) -> f64 {
    let power = |range: std::ops::Range<usize>| {
        let count = range.len() as f64;
        history[range].iter().map(|outputs| outputs.modal_q_dot[0].powi(2)).sum::<f64>() / count
    };
    power(1000..1500) / power(200..600)
}

#[test]
fn at_one_tenth_stiffness_the_exact_wing_deflects_least_and_is_damped_most() {
    let results = FLEXIBLE.map(|fidelity| {
        let settings = Settings { fidelity, stiffness_scale: 0.1, airspeed: 177.8, ..eight_symmetric() };
        let history = fly(&settings, 15.0, two_three_one_one, elevator);
        let peak = history.iter().map(|outputs| up(outputs, "wing_tip_right")).fold(0.0, f64::max);
        (peak, remaining_oscillation(&history))
    });
    println!("{results:?}");
    let [(exact_peak, exact_rest), others @ ..] = results;
    for (peak, rest) in others {
        assert!(exact_peak < 0.7 * peak, "peaks {results:?}");
        assert!(exact_rest < rest, "remaining oscillation {results:?}");
    }
}

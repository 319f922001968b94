//! The lift of a section that is held in a gust: Sears' function of a wave, Küssner's of a sharp edge. A strip is flown into
//! gusts through the equations of motion, nothing is taken from the inside.
//!
//! [theory: gusts.chord, gusts.strip]

use std::f64::consts::TAU;

use flexible_aircraft::air::{Extent, FrozenGust, GustSettings, GustShape, Track, TurbulenceSettings};
use nalgebra::{Complex, DVector, Vector3};

use super::record::Record;
use crate::support::strip::{DENSITY, PrescribedStrip, SEMICHORD, SPEED};

type C64 = Complex<f64>;

/// Steps of a march, semichords.
const STEP: f64 = 0.01;

/// A gust upwards of 1 m/s and of a gradient in semichords, which the leading edge meets at the start, and the lift over
/// 2πρUb·1 m/s at steps afterwards.
fn lift_in_gust(inflow_states: usize, gradient: f64, steps: usize) -> (FrozenGust, Vec<f64>) {
    let single = GustSettings {
        shape: GustShape::OneMinusCosine,
        gradient: gradient * SEMICHORD,
        peak: 1.0,
        start: 0.0,
        ..GustSettings::default()
    };
    let aircraft = Extent { nose: SEMICHORD, reach: SEMICHORD };
    let gust = || {
        let track = Track::new(&Vector3::zeros(), &(Vector3::x() * SPEED), aircraft);
        FrozenGust::new(track, (&single, &TurbulenceSettings::default()), 0.0, DENSITY).unwrap()
    };
    let mut strip = PrescribedStrip::new(inflow_states, 0.0, 0.0, 0.8);
    strip.fly_into(gust());
    let places = strip.inflow();
    let mut evaluate = |travelled: f64, inflow: &DVector<f64>| {
        strip.stand_at(travelled * SEMICHORD);
        strip.state[places.clone()].copy_from_slice(inflow.as_slice());
        let (force, rates) = strip.evaluate();
        (-force[1] / (TAU * DENSITY * SPEED * SEMICHORD), DVector::from_vec(rates))
    };
    let dt = STEP * SEMICHORD / SPEED;
    let mut inflow = DVector::zeros(places.len());
    let mut lifts = Vec::new();
    for step in 0..steps {
        let at = STEP * step as f64;
        let (lift, k1) = evaluate(at, &inflow);
        lifts.push(lift);
        let (_, k2) = evaluate(at + 0.5 * STEP, &(&inflow + &k1 * (0.5 * dt)));
        let (_, k3) = evaluate(at + 0.5 * STEP, &(&inflow + &k2 * (0.5 * dt)));
        let (_, k4) = evaluate(at + STEP, &(&inflow + &k3 * dt));
        inflow += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (dt / 6.0);
    }
    (gust(), lifts)
}

/// The lift in a wave of reduced frequency k over its quasi-steady value, phase at mid-chord: the Fourier transform of the lift
/// in a short gust over that of the gust.
fn response((gust, lifts): &(FrozenGust, Vec<f64>), k: f64) -> C64 {
    let transform = |value: &dyn Fn(usize) -> f64| -> C64 {
        let term = |step: usize| C64::from_polar(value(step), -k * STEP * step as f64);
        (0..lifts.len()).map(term).sum()
    };
    let up = |step: usize| -gust.velocity(STEP * step as f64 * SEMICHORD)[2];
    transform(&|step| lifts[step]) / transform(&up)
}

/// Sears' function by the Bessel functions of W. R. Sears, *J. Aeronaut. Sci.* 8 (1941) 104–108: C(k)(J₀ − iJ₁) + iJ₁.
fn sears(k: f64) -> C64 {
    let h0 = C64::new(libm::j0(k), -libm::y0(k));
    let h1 = C64::new(libm::j1(k), -libm::y1(k));
    let [j0, j1] = [libm::j0(k), libm::j1(k)];
    h1 / (h1 + C64::i() * h0) * C64::new(j0, -j1) + C64::new(0.0, j1)
}

#[test]
fn the_lift_in_a_wave_is_sears_function_as_far_as_three_points_and_the_inflow_carry() {
    let mut record = Record::new(
        "sears",
        "Lift of a held section in waves of the air, against Sears' function: error in % of its magnitude",
        "Sears (1941); *reference*: the errors of an independent computation of the same three points a chord; Fourier transform of a gust of 1.5 semichords",
    );
    let exact = sears(0.3);
    record.absolute("exact S(0.3), real part", 0.62350, 5e-6, exact.re);
    record.absolute("exact S(0.3), imaginary part", -0.12562, 5e-6, exact.im);
    let five = lift_in_gust(5, 1.5, 60_000);
    let found = response(&five, 0.3);
    record.absolute("N = 5, S(0.3), real part", 0.62123, 2e-5, found.re);
    record.absolute("N = 5, S(0.3), imaginary part", -0.10364, 2e-5, found.im);
    let steady = lift_in_gust(0, 1.5, 1_000);
    let wave_numbers = [0.1, 0.3, 0.5, 1.0, 1.5, 2.0, 3.0];
    let errors = [
        ("N = 5", &five, [4.3, 3.5, 2.0, 0.6, 0.8, 1.1, 10.0], [0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.5]),
        ("N = 0", &steady, [29.0, 59.0, 79.0, 107.0, 114.0, 109.0, 87.0], [0.5; 7]),
    ];
    for (name, lift, errors, digits) in errors {
        for ((k, error), digit) in wave_numbers.into_iter().zip(errors).zip(digits) {
            let found = 100.0 * (response(lift, k) - sears(k)).norm() / sears(k).norm();
            record.absolute(&format!("{name}, k = {k}: error, %"), error, digit, found);
        }
    }
    record.finish();
}

#[test]
fn the_lift_after_a_sharp_edge_is_kussners_function_as_far_as_the_inflow_carries() {
    let mut record = Record::new(
        "kussner",
        "Lift over its final value, semichords after the leading edge met a sharp-edged gust",
        "*reference*: an independent computation with five and six inflow states and the whole chord; Küssner's function itself in the last rows",
    );
    // Gusts of 2H, each H behind the last, make a step that rises over H.
    const GRADIENT: f64 = 0.1;
    let distances = [2.0, 4.0, 6.0, 8.0, 12.0];
    let step_response = |inflow_states: usize| {
        let (_, lifts) = lift_in_gust(inflow_states, GRADIENT, 1_500);
        let between = (GRADIENT / STEP).round() as usize;
        distances.map(|distance| {
            let last = ((distance + 0.5 * GRADIENT) / STEP).round() as usize;
            (0..=last).rev().step_by(between).map(|step| lifts[step]).sum::<f64>()
        })
    };
    let [five, six] = [5, 6].map(step_response);
    for (name, found, reference) in [
        ("N = 5", five, [0.5477, 0.6893, 0.7605, 0.8045, 0.8611]),
        ("N = 6", six, [0.5528, 0.6974, 0.7765, 0.8240, 0.8769]),
    ] {
        for ((distance, found), reference) in distances.into_iter().zip(found).zip(reference) {
            record.absolute(&format!("{name}, {distance} semichords"), reference, 5e-4, found);
        }
    }
    for ((distance, found), exact) in
        distances.into_iter().zip(five).zip([0.5508, 0.6945, 0.7731, 0.8225, 0.8802])
    {
        record.relative(&format!("N = 5, {distance} semichords, Küssner's function"), exact, 0.025, found);
    }
    record.finish();
}

//! Unsteady aerodynamics of a strip: Peters' inflow approaches Theodorsen's and Wagner's functions as its states
//! grow in number, leading-edge suction propels as Garrick says, a flap lifts and pitches as thin-aerofoil theory
//! says. A strip is moved through the equations of motion, nothing is taken from the inside.
//!
//! [theory: inflow.lift-deficiency, air-loads.suction, air-loads.flap; thesis §4.1]

use nalgebra::{Complex, DMatrix, DVector};

use super::record::Record;
use crate::support::strip::{DENSITY, PrescribedStrip, SEMICHORD, SPEED};

type C64 = Complex<f64>;

/// Inflow states × time: the strip's lift is linear in its inflow states and in w.
struct LiftFilter {
    /// Rates of the inflow states per state, 1/s, and per w.
    system: DMatrix<f64>,
    input: DVector<f64>,
    /// Circulatory lift over its quasi-steady value 2πρUbw, per state and per w, s/m.
    output: DVector<f64>,
    through: f64,
}

impl LiftFilter {
    /// By unit states and unit w.
    fn new(inflow_states: usize) -> Self {
        let mut strip = PrescribedStrip::new(inflow_states, 0.0, 0.0, 0.8);
        let lift = |force: [f64; 3]| -force[1] / (std::f64::consts::TAU * DENSITY * SPEED * SEMICHORD);
        let places = strip.inflow();
        let columns: Vec<_> = places
            .map(|place| {
                strip.state[place] = 1.0;
                let (force, rates) = strip.evaluate();
                strip.state[place] = 0.0;
                (lift(force), DVector::from_vec(rates))
            })
            .collect();
        strip.move_with(1.0, 0.0);
        let (force, rates) = strip.evaluate();
        let system: Vec<_> = columns.iter().map(|(_, rates)| rates.clone()).collect();
        LiftFilter {
            system: DMatrix::from_columns(&system),
            input: DVector::from_vec(rates),
            output: DVector::from_iterator(columns.len(), columns.iter().map(|(lift, _)| *lift)),
            through: lift(force),
        }
    }

    /// C(k) at the reduced frequency k = ωb/U.
    fn lift_deficiency(&self, k: f64) -> C64 {
        let n = self.input.len();
        let s = C64::new(0.0, k * SPEED / SEMICHORD);
        let resolvent = DMatrix::identity(n, n) * s - self.system.map(C64::from);
        let states = resolvent.lu().solve(&self.input.map(C64::from)).unwrap();
        states.dot(&self.output.map(C64::from)) + self.through
    }
}

/// Theodorsen's C(k) = H₁/(H₁ + iH₀) of Hankel functions of the second kind (NACA TR 496, 1935).
fn theodorsen(k: f64) -> C64 {
    let h0 = C64::new(libm::j0(k), -libm::y0(k));
    let h1 = C64::new(libm::j1(k), -libm::y1(k));
    h1 / (h1 + C64::i() * h0)
}

#[test]
fn the_lift_deficiency_approaches_theodorsens_function() {
    let mut record = Record::new(
        "theodorsen",
        "Lift deficiency C(k) of N inflow states: largest error |C_N − C| for 0.01 ≤ k ≤ 2",
        "Theodorsen, NACA TR 496 (1935), with exact Hankel functions; Peters, Karunamoorthy, Cao, *J. Aircraft* 32 (1995) 313–322. \
         The tolerances are the model's own truncation as found; [theory: inflow.lift-deficiency] has C₅(0.1) and C₅(0.3)",
    );
    record.absolute("exact C(0.1), real part, against Theodorsen's table", 0.8319, 1e-4, theodorsen(0.1).re);
    record.absolute("exact C(0.1), imaginary part", -0.1723, 1e-4, theodorsen(0.1).im);
    let wave_numbers: Vec<f64> = (0..=100).map(|i| 0.01 * libm::pow(200.0, f64::from(i) / 100.0)).collect();
    let truncation = [0.21, 0.15, 0.08, 0.04, 0.04, 0.02, 0.025, 0.01];
    for (states, bound) in (1..).zip(truncation) {
        let filter = LiftFilter::new(states);
        let error = |k: &f64| (filter.lift_deficiency(*k) - theodorsen(*k)).norm();
        let largest = wave_numbers.iter().map(error).fold(0.0, f64::max);
        record.error(&format!("N = {states}"), bound, largest);
    }
    let five = LiftFilter::new(5);
    for (k, re, im) in [(0.1, 0.7987, -0.1872), (0.3, 0.6594, -0.1577)] {
        record.absolute(&format!("N = 5, C({k}), real part"), re, 6e-5, five.lift_deficiency(k).re);
        record.absolute(&format!("N = 5, C({k}), imaginary part"), im, 6e-5, five.lift_deficiency(k).im);
    }
    record.finish();
}

/// Lift over its final value s semichords after a step of w: Runge–Kutta steps of 0.01 semichords.
fn step_response(filter: &LiftFilter, distances: &[f64]) -> Vec<f64> {
    const STEP: f64 = 0.01;
    let dt = STEP * SEMICHORD / SPEED;
    let f = |x: &DVector<f64>| &filter.system * x + &filter.input;
    let mut states = DVector::zeros(filter.input.len());
    let mut travelled = 0.0;
    let mut found = Vec::new();
    for &distance in distances {
        while travelled < distance - 0.5 * STEP {
            let k1 = f(&states);
            let k2 = f(&(&states + &k1 * (0.5 * dt)));
            let k3 = f(&(&states + &k2 * (0.5 * dt)));
            let k4 = f(&(&states + &k3 * dt));
            states += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (dt / 6.0);
            travelled += STEP;
        }
        found.push(states.dot(&filter.output) + filter.through);
    }
    found
}

#[test]
fn the_lift_after_a_step_is_wagners() {
    let mut record = Record::new(
        "wagner",
        "Lift after a step of the angle of attack, over its final value, s semichords later",
        "R. T. Jones' approximation φ(s) = 1 − 0.165 e^(−0.0455 s) − 0.335 e^(−0.3 s) of Wagner's function, good to about 1 % \
         (NACA TR 681, 1940)",
    );
    let distances = [0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0];
    for (states, tolerance) in [(5, 0.025), (8, 0.01)] {
        let found = step_response(&LiftFilter::new(states), &distances);
        for (s, found) in distances.iter().zip(found) {
            let jones = 1.0 - 0.165 * libm::exp(-0.0455 * s) - 0.335 * libm::exp(-0.3 * s);
            record.absolute(&format!("N = {states}, s = {s}"), jones, tolerance, found);
        }
    }
    record.finish();
}

/// Mean force along the chord of a strip that plunges and pitches with w = Re(ŵ e^{iωt}), Ω = Re(Ω̂ e^{iωt}).
fn mean_suction(inflow_states: usize, axis: f64, k: f64, upwash: C64, pitch_rate: C64) -> f64 {
    const STEPS: usize = 400;
    let omega = k * SPEED / SEMICHORD;
    let dt = std::f64::consts::TAU / omega / STEPS as f64;
    let mut strip = PrescribedStrip::new(inflow_states, axis, 1.0, 0.8);
    let places = strip.inflow();
    let mut x = DVector::zeros(places.len());
    let mut at = |time: f64, x: &DVector<f64>| {
        let turn = C64::new(libm::cos(omega * time), libm::sin(omega * time));
        strip.move_with((upwash * turn).re, (pitch_rate * turn).re);
        strip.state[places.clone()].copy_from_slice(x.as_slice());
        let (force, rates) = strip.evaluate();
        (force[0], DVector::from_vec(rates))
    };
    // The wake forgets at 0.07 U/b or faster: it is periodic to 1e-12 after 400 semichords.
    let cycles = (400.0 * k / std::f64::consts::TAU).ceil() as usize + 1;
    let mut sum = 0.0;
    for index in 0..cycles * STEPS {
        let t = index as f64 * dt;
        let (force, k1) = at(t, &x);
        if index >= (cycles - 1) * STEPS {
            sum += force / STEPS as f64;
        }
        let (_, k2) = at(t + 0.5 * dt, &(&x + &k1 * (0.5 * dt)));
        let (_, k3) = at(t + 0.5 * dt, &(&x + &k2 * (0.5 * dt)));
        let (_, k4) = at(t + dt, &(&x + &k3 * dt));
        x += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (dt / 6.0);
    }
    sum
}

/// Garrick's mean suction πρS̄² with S = √(b/2)·[2C Q − bΩ] in our sizes, Q = w + (b/2 − d)Ω the upwash at
/// three-quarter chord.
fn garrick(lift_deficiency: C64, axis: f64, upwash: C64, pitch_rate: C64) -> f64 {
    let (b, d) = (SEMICHORD, axis * SEMICHORD);
    let q = upwash + pitch_rate * (0.5 * b - d);
    let s = (lift_deficiency * q * 2.0 - pitch_rate * b) * libm::sqrt(b / 2.0);
    // The mean of a squared sine is half its squared amplitude.
    std::f64::consts::PI * DENSITY * s.norm_sqr() / 2.0
}

#[test]
fn full_suction_propels_as_garrick_says() {
    let mut record = Record::new(
        "garrick",
        "Mean leading-edge suction (N/m) of an oscillating strip, η = 1, N = 8",
        "Garrick, NACA TR 567 (1936): πρS̄², S = ½√2·[2C(k)Q − bα̇] with √b; in plunge it is the whole propulsive force \
         πρbω²h²(F² + G²). First with the strip's own C₈(k), then with Theodorsen's C(k)",
    );
    let motions = [
        ("plunge", 0.0, C64::from(1.0), C64::from(0.0)),
        ("pitch about quarter chord", -0.5, C64::from(0.0), C64::from(2.0)),
        ("both, out of phase", 0.2, C64::new(0.4, 0.7), C64::new(-1.0, 1.5)),
    ];
    let filter = LiftFilter::new(8);
    for (name, axis, upwash, pitch_rate) in motions {
        for k in [0.1, 0.3, 1.0] {
            let found = mean_suction(8, axis, k, upwash, pitch_rate);
            let own = garrick(filter.lift_deficiency(k), axis, upwash, pitch_rate);
            let exact = garrick(theodorsen(k), axis, upwash, pitch_rate);
            record.relative(&format!("{name}, k = {k}, own C"), own, 1e-6, found);
            record.relative(&format!("{name}, k = {k}, exact C"), exact, 0.03, found);
        }
    }
    record.finish();
}

#[test]
fn a_flap_lifts_and_pitches_as_thin_aerofoil_theory_says() {
    let mut record = Record::new(
        "flap",
        "Lift (N/m) and nose-up moment about the elastic axis (N) of a flap at 0.1 rad, 20 m/s, sea level",
        "Theodorsen, NACA TR 496 (1935): L = 2ρbU²T₁₀β, M = −ρb²U²(T₄ + T₁₀)β + 2ρb²U²(a + ½)T₁₀β, \
         T₄ = −arccos c + c√(1 − c²), T₁₀ = √(1 − c²) + arccos c",
    );
    for (hinge, axis) in [(0.5, 0.0), (0.7, -0.3), (0.8, 0.2), (0.9, -0.5)] {
        let mut strip = PrescribedStrip::new(0, axis, 0.0, hinge);
        let angle = 0.1;
        strip.controls.angles[0] = angle;
        let (force, _) = strip.evaluate();
        let c: f64 = 2.0 * hinge - 1.0;
        let root = libm::sqrt(1.0 - c * c);
        let (t4, t10) = (-libm::acos(c) + c * root, root + libm::acos(c));
        let pressure = DENSITY * SPEED * SPEED * angle * SEMICHORD;
        let moment = pressure * SEMICHORD * (-(t4 + t10) + 2.0 * (axis + 0.5) * t10);
        let case = format!("hinge {hinge}, elastic axis a = {axis}");
        record.relative(&format!("{case}: lift"), 2.0 * pressure * t10, 1e-6, -force[1]);
        record.relative(&format!("{case}: moment"), moment, 1e-6, force[2]);
    }
    record.finish();
}

//! Energy balance in air: along a flight the work of aerodynamic forces, thrust and gravity is the change of kinetic
//! and strain energy, for the two models that follow from a Lagrangian [2.2, 4; physics.md §2, §4, §5].
//!
//! The work is summed here strip by strip as physics.md §4 writes the loads, apparent mass included, from the
//! motion alone; nothing of the program's load summation is used. Steady inflow (N = 0): λ₀ = 0.

use std::f64::consts::PI;

use flexible_aircraft::dynamics::{
    Attitude, Configuration, Controls, EquationsOfMotion, Fidelity, Mechanics, TrimCondition, Workspace,
};
use flexible_aircraft::structure::{ModeShapes, ReducedModel, ReducedStrip};
use nalgebra::{DVector, DVectorView, Matrix3xX, Rotation3, Vector3};

use super::record::Record;
use crate::support::{derivative, jet, random};

/// ν, ν̇ and q at an instant.
struct Motion<'a> {
    velocity: Vector3<f64>,
    rate: Vector3<f64>,
    velocity_change: Vector3<f64>,
    rate_change: Vector3<f64>,
    q: DVectorView<'a, f64>,
    q_dot: DVectorView<'a, f64>,
    q_dot_change: DVectorView<'a, f64>,
    density: f64,
}

/// A point of the structure and what it does.
struct Point {
    turn: Rotation3<f64>,
    velocity: Vector3<f64>,
    spin: Vector3<f64>,
    /// Ψᵠq̇.
    elastic_spin: Vector3<f64>,
    /// v̇ + ω̇×R + Ψᵘq̈ + ω×Ψᵘq̇.
    velocity_change: Vector3<f64>,
    /// ω̇ + Ψᵠq̈.
    spin_change: Vector3<f64>,
}

fn point(motion: &Motion, position: &Vector3<f64>, shapes: &ModeShapes) -> Point {
    let [psi_u, psi_phi] =
        [&shapes.translation, &shapes.rotation].map(|rows| Matrix3xX::from_row_slice(rows));
    let place = position + &psi_u * motion.q;
    let (elastic_velocity, elastic_spin) = (&psi_u * motion.q_dot, &psi_phi * motion.q_dot);
    Point {
        turn: Rotation3::new(&psi_phi * motion.q),
        velocity: motion.velocity + motion.rate.cross(&place) + elastic_velocity,
        spin: motion.rate + elastic_spin,
        elastic_spin,
        velocity_change: motion.velocity_change
            + motion.rate_change.cross(&place)
            + &psi_u * motion.q_dot_change
            + motion.rate.cross(&elastic_velocity),
        spin_change: motion.rate_change + &psi_phi * motion.q_dot_change,
    }
}

/// Power of a strip's loads, W.
fn strip_power(motion: &Motion, strip: &ReducedStrip, controls: &Controls) -> f64 {
    let at = point(motion, &strip.position, &strip.shapes);
    let (f, s) = (at.turn * strip.forward, at.turn * strip.span);
    let n = f.cross(&s);
    let m = n + f * strip.zero_lift_offset;
    let (b, d, rho) = (strip.semichord, strip.elastic_axis_aft_of_midchord, motion.density);

    let (u, across, omega) = (f.dot(&at.velocity), n.dot(&at.velocity), s.dot(&at.spin));
    let w = across + u * strip.zero_lift_offset;
    let w_dot = m.dot(&at.velocity_change) + at.elastic_spin.cross(&m).dot(&at.velocity);
    let omega_dot = s.dot(&at.spin_change) + at.elastic_spin.cross(&s).dot(&at.spin);

    let (mut flap_lift, mut flap_moment) = (0.0, 0.0);
    if let Some(flap) = &strip.flap {
        let gains = &flap.gains;
        let angle = gains.elevator * controls.elevator
            + gains.aileron * controls.aileron
            + gains.aileron_symmetric * controls.aileron_symmetric
            + gains.rudder * controls.rudder;
        let hinge = libm::acos(2.0 * flap.hinge - 1.0);
        let (sin, cos) = libm::sincos(hinge);
        let pressure = flap.lift_slope * rho * b * u * u * angle;
        flap_lift = pressure * (hinge + sin) / PI;
        flap_moment = -pressure * b * sin * (1.0 + cos) / (2.0 * PI);
    }
    let circulatory = strip.lift_slope * rho * u * b * (w + (0.5 * b - d) * omega);
    let lift = PI * rho * b * b * (w_dot - d * omega_dot) + circulatory + flap_lift;
    let moment = (0.5 * b + d) * (circulatory + flap_lift)
        + PI * rho * b * b * (d * w_dot - 0.5 * b * u * omega - (d * d + b * b / 8.0) * omega_dot)
        + flap_moment;
    let suction = strip.leading_edge_suction * strip.lift_slope * rho * b * (w - d * omega).powi(2);
    let drag = strip.profile_drag * rho * b * (u * u + across * across).powf(1.5);
    strip.width * (-lift * across + moment * omega + suction * u - drag)
}

/// Power of all loads, W.
fn power(
    model: &ReducedModel,
    equations: &EquationsOfMotion,
    state: &[f64],
    nu_dot: &[f64],
    controls: &Controls,
) -> f64 {
    let layout = equations.layout();
    let rigid = equations.motion(state);
    let motion = Motion {
        velocity: rigid.velocity,
        rate: rigid.rate,
        velocity_change: Vector3::from_column_slice(&nu_dot[0..3]),
        rate_change: Vector3::from_column_slice(&nu_dot[3..6]),
        q: DVectorView::from_slice(&state[layout.coordinates()], layout.modes()),
        q_dot: DVectorView::from_slice(&state[layout.coordinate_rates()], layout.modes()),
        q_dot_change: DVectorView::from_slice(&nu_dot[6..], layout.modes()),
        density: equations.air(state).density,
    };
    let air: f64 = model.strips.iter().map(|strip| strip_power(&motion, strip, controls)).sum();
    let engine = |(engine, thrust): (&flexible_aircraft::structure::ReducedEngine, &f64)| {
        let at = point(&motion, &engine.position, &engine.shapes);
        thrust * (at.turn * engine.direction).dot(&at.velocity)
    };
    let thrust: f64 = model.engines.iter().zip(&controls.thrust).map(engine).sum();

    let attitude = Attitude::from_quaternion(&state[layout.attitude()]);
    let gravity = attitude.body_from_inertial * Vector3::new(0.0, 0.0, model.gravity);
    let p = |amounts: &DVectorView<f64>| -> Vector3<f64> {
        model.integrals.momentum.iter().zip(amounts.iter()).map(|(p, amount)| p * *amount).sum()
    };
    let first_moment = model.integrals.first_moment + p(&motion.q);
    let momentum =
        motion.velocity * model.integrals.mass + motion.rate.cross(&first_moment) + p(&motion.q_dot);
    air + thrust + gravity.dot(&momentum)
}

/// The jet with twelve modes of both families at one-tenth stiffness in steady inflow.
fn soft_jet(fidelity: Fidelity) -> (ReducedModel, EquationsOfMotion) {
    let model = jet().select(&(0..12).collect::<Vec<_>>());
    let configuration = Configuration {
        fidelity,
        stiffness_scale: 0.1,
        structural_damping: 0.0,
        inflow_states: 0,
        tunnel_flow: Vector3::zeros(),
    };
    let equations = EquationsOfMotion::new(&model, &configuration);
    (model, equations)
}

/// T + U.
fn energy(equations: &EquationsOfMotion, state: &[f64]) -> f64 {
    let mechanics = Mechanics::new(equations, state);
    mechanics.kinetic_energy + mechanics.strain_energy
}

/// Controls that shake the aircraft in all axes: the largest
/// change of energy along 4 s, J, and the largest difference to the work.
fn balance(fidelity: Fidelity) -> (f64, f64) {
    const STEP: f64 = 1e-3;
    let (model, equations) = soft_jet(fidelity);
    let trim = equations.trim(&TrimCondition { airspeed: 127.0, altitude: 7620.0, heading: 0.0 }).unwrap();
    let mut workspace = Workspace::new(&equations);
    let mut slope = |time: f64, state: &DVector<f64>| {
        let wave = libm::sin(std::f64::consts::TAU * 0.5 * time);
        let mut controls = Controls::neutral(2);
        (controls.elevator, controls.aileron, controls.rudder) =
            (trim.point.elevator - 0.05 * wave, 0.03 * wave, 0.02 * wave);
        controls.thrust.fill(trim.point.thrust * (1.0 + 0.3 * wave));
        let mut rates = vec![0.0; state.len()];
        // The last entry is the work.
        let aircraft = &state.as_slice()[..state.len() - 1];
        equations.rates(aircraft, &controls, &mut rates[..aircraft.len()], &mut workspace);
        let work = rates.len() - 1;
        rates[work] = power(&model, &equations, aircraft, workspace.accelerations(), &controls);
        DVector::from_vec(rates)
    };
    let energy = |state: &DVector<f64>| energy(&equations, &state.as_slice()[..state.len() - 1]);
    let mut state = DVector::from_vec([trim.state.as_slice(), &[0.0]].concat());
    let start = energy(&state);
    let (mut largest, mut difference) = (0.0_f64, 0.0_f64);
    for index in 0..4000 {
        let t = f64::from(index) * STEP;
        let k1 = slope(t, &state);
        let k2 = slope(t + 0.5 * STEP, &(&state + &k1 * (0.5 * STEP)));
        let k3 = slope(t + 0.5 * STEP, &(&state + &k2 * (0.5 * STEP)));
        let k4 = slope(t + STEP, &(&state + &k3 * STEP));
        state += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (STEP / 6.0);
        let change = energy(&state) - start;
        largest = largest.max(change.abs());
        difference = difference.max((change - state[state.len() - 1]).abs());
    }
    (largest, difference)
}

/// The largest difference of power and d(T + U)/dt over ten random states, relative to the power.
fn instantaneous(fidelity: Fidelity) -> f64 {
    let (model, equations) = soft_jet(fidelity);
    let layout = *equations.layout();
    let mut workspace = Workspace::new(&equations);
    let mut largest = 0.0_f64;
    for seed in 0..10 {
        let mut next = random(seed);
        let mut state: Vec<f64> = (0..layout.len()).map(|_| next()).collect();
        state[layout.position().end - 1] = -7620.0;
        state[layout.velocity().start] = 127.0;
        for (range, scale) in [
            (layout.velocity().end - 1..layout.velocity().end, 15.0),
            (layout.coordinates(), 20.0),
            (layout.coordinate_rates(), 60.0),
        ] {
            state[range].iter_mut().for_each(|x| *x *= scale);
        }
        let mut controls = Controls::neutral(2);
        (controls.elevator, controls.aileron, controls.rudder) = (0.2 * next(), 0.2 * next(), 0.2 * next());
        controls.aileron_symmetric = 0.2 * next();
        controls.thrust.fill(3e4 * next());
        let mut rates = vec![0.0; state.len()];
        equations.rates(&state, &controls, &mut rates, &mut workspace);
        let expected = power(&model, &equations, &state, workspace.accelerations(), &controls);
        // T + U is quartic along a straight line.
        let moved = |s: f64| state.iter().zip(&rates).map(|(x, rate)| x + s * rate).collect::<Vec<_>>();
        let found = derivative(1e-2, |s| energy(&equations, &moved(s)));
        largest = largest.max((found / expected - 1.0).abs());
    }
    largest
}

#[test]
fn the_work_of_air_thrust_and_gravity_is_the_change_of_energy() {
    let mut record = Record::new(
        "energy-balance",
        "Jet at one-tenth stiffness in air, all surfaces and thrust moving: energy and work over 4 s, and at random states",
        "work of the loads as physics.md §4 and §5 write them, summed here; Runge–Kutta steps of 1 ms",
    );
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent] {
        let (largest, difference) = balance(fidelity);
        record.at_least(&format!("{fidelity:?}: largest change of T + U, J"), 1e6, largest);
        record.rounding(
            &format!("{fidelity:?}: largest difference to the work, over that"),
            1e-10,
            difference / largest,
        );
    }
    for fidelity in [Fidelity::Exact, Fidelity::Inconsistent] {
        let case = format!("{fidelity:?}: power against d(T + U)/dt, ten random states, relative");
        record.rounding(&case, 1e-9, instantaneous(fidelity));
    }
    record.finish();
}

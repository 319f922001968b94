//! Leading-edge suction: in steady flow neither camber nor flap propels, and ailerons yaw adversely where suction is lost
//! [theory: air-loads.suction, air-loads.steady-drag; thesis §4.1].

use std::f64::consts::PI;

use flexible_aircraft::air::Air;
use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Workspace};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::Plant;
use flexible_aircraft::structure::{ReducedModel, ReducedStrip};
use nalgebra::Vector3;

use crate::support::plain_sections::moving_point;
use crate::support::strip::{PrescribedStrip, SEMICHORD, SPEED};
use crate::support::{AILERON, eight_symmetric, jet, random, soft};

use super::record::Record;

/// A strip in steady flow.
struct Steady {
    suction: f64,
    camber: f64,
    /// Angles of two controls that turn the flap by 1 and by −0.4.
    controls: [f64; 2],
    /// n·V/U.
    incidence: f64,
}

/// Force along f and along −n, N/m.
fn chord_forces(Steady { suction, camber, controls, incidence }: &Steady) -> [f64; 2] {
    let mut strip = PrescribedStrip::altered(0, -0.3, *suction, 0.75, |strip| {
        strip.zero_lift_offset = *camber;
        if let Some(flap) = &mut strip.flap {
            flap.gains[1] = -0.4;
        }
    });
    strip.controls.angles.copy_from_slice(controls);
    strip.move_with(SPEED * incidence, 0.0);
    let ([x, z, _], _) = strip.evaluate();
    [x, -z]
}

/// All combinations of suction, camber, flap and incidence.
fn steady_flows() -> impl Iterator<Item = Steady> {
    let suctions = [-0.5, 0.0, 0.5, 0.9, 1.0];
    suctions.into_iter().flat_map(|suction| {
        [-0.05, 0.0, 0.05].into_iter().flat_map(move |camber| {
            [[0.0, 0.0], [0.3, 0.0], [-0.2, 0.3], [0.2, 0.5]].into_iter().flat_map(move |controls| {
                let incidences = [-0.1, 0.0, 0.02, 0.15].into_iter();
                incidences.map(move |incidence| Steady { suction, camber, controls, incidence })
            })
        })
    })
}

#[test]
fn neither_camber_nor_flap_propels_in_steady_flow() {
    let mut record = Record::new(
        "steady-drag",
        "Drag of a strip (N/m) in steady flow: 5 suctions η ≤ 1, 3 cambers, 4 positions of two controls on its flap, 4 incidences",
        "[theory: air-loads.steady-drag]: without profile drag its power is (1 − η) L²/(CLα ρ b U)",
    );
    let (mut largest, mut difference, mut thrust) = (0.0_f64, 0.0_f64, 0.0_f64);
    for flow in steady_flows() {
        let [forward, lift] = chord_forces(&flow);
        let speed = SPEED * (1.0 + flow.incidence * flow.incidence).sqrt();
        let drag = (lift * SPEED * flow.incidence - forward * SPEED) / speed;
        let power = (1.0 - flow.suction) * lift * lift
            / (std::f64::consts::TAU * Air::at(0.0).density * SEMICHORD * SPEED);
        largest = largest.max(lift.abs());
        difference = difference.max((drag - power / speed).abs());
        thrust = thrust.max(-drag);
    }
    record.at_least("largest lift", 100.0, largest);
    record.rounding("difference to the formula, over the largest lift", 1e-14, difference / largest);
    record.rounding("thrust, over the largest lift", 1e-14, thrust / largest);
    record.finish();
}

/// The jet with another suction, and its wing with camber, turned about its span so that the zero-lift line stays.
fn with_camber(suction: f64, camber: f64) -> ReducedModel {
    let mut model = (*jet()).clone();
    for strip in &mut model.strips {
        strip.leading_edge_suction = suction;
        if strip.component.starts_with("wing") {
            let ReducedStrip { forward, span, .. } = strip;
            let (sin, cos) = libm::sincos(camber);
            *forward = *forward * cos + forward.cross(span) * sin;
            strip.zero_lift_offset = camber;
        }
    }
    model
}

#[test]
fn with_the_same_zero_lift_line_any_camber_trims_at_the_same_thrust() {
    let mut record = Record::new(
        "camber-thrust",
        "Thrust of the trimmed jet with full suction (N per engine), its wing cambered about the same zero-lift line",
        "the jet without camber; w is linear in the camber, the turned chord is not: α0²/2 remains",
    );
    let thrust = |camber: f64| {
        let flight = Simulation::new(with_camber(1.0, camber).into(), &eight_symmetric(), 0.0).unwrap();
        flight.trim().thrust
    };
    let flat = thrust(0.0);
    for camber in [-0.05, 0.02, 0.05, 0.1] {
        let case = format!("α0 = {camber}");
        record.relative(&case, flat, 5e-5, thrust(camber));
    }
    record.finish();
}

#[test]
fn a_cambered_aircraft_without_thrust_loses_energy() {
    let model = with_camber(1.0, 3.0_f64.to_radians());
    let mut flight = Simulation::new(model.into(), &Settings::of(&jet()), 0.0).unwrap();
    let mut inputs = Inputs::zero(&jet());
    inputs.thrust.fill(-flight.trim().thrust);
    flight.set_inputs(&inputs, &Inputs::zero(&jet()));
    // h + V²/2g, m.
    let height = |flight: &mut Simulation| {
        let outputs = flight.outputs();
        outputs.velocity.norm_squared() / (2.0 * 9.806) - outputs.position.z
    };
    let mut before = height(&mut flight);
    for second in 1..=20 {
        flight.advance_to(f64::from(second)).unwrap();
        let now = height(&mut flight);
        assert!(now < before, "{second} s: {before} m to {now} m");
        before = now;
    }
}

/// The moment about the axis across the flight path, downwards, that 0.1 rad of aileron adds to the trimmed rigid jet,
/// N·m.
fn yaw_of_ailerons(suction: f64) -> f64 {
    let configuration = Configuration {
        fidelity: Fidelity::Rigid,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states: 0,
        temperature_offset: 0.0,
        tunnel_flow: Vector3::zeros(),
    };
    // The same state for every suction.
    let trimmed = Plant::new(&jet(), &configuration).unwrap();
    let trim = trimmed.trim(&Settings::of(&jet()).plant.trim_condition()).unwrap();
    let equations = EquationsOfMotion::new(&with_camber(suction, 0.0), &configuration).unwrap();
    let (sin, cos) = libm::sincos(trim.point.pitch);
    let mut controls = trim.controls.clone();
    let mut yaw = |aileron: f64| {
        controls.angles[AILERON] = aileron;
        let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], Workspace::new(&equations));
        equations.rates(&trim.state, &controls, &mut rates, &mut workspace);
        workspace.forces()[5] * cos - workspace.forces()[3] * sin
    };
    yaw(0.1) - yaw(0.0)
}

#[test]
fn ailerons_yaw_adversely_where_suction_is_lost() {
    let mut record = Record::new(
        "adverse-yaw",
        "Yaw moment of the rigid jet (N·m) about the axis across its flight path, 0.1 rad of aileron to the right",
        "[theory: air-loads.steady-drag]: drag (1 − η) L²/(CLα ρ b U²) is linear in η, and more on the left, where lift grows",
    );
    let full = yaw_of_ailerons(1.0);
    let none = yaw_of_ailerons(0.0);
    record.at_most("no suction, over full suction", -4e4, none - full);
    for suction in [0.3, 0.9] {
        let case = format!("η = {suction}, over full suction");
        record.relative(&case, (1.0 - suction) * (none - full), 1e-10, yaw_of_ailerons(suction) - full);
    }
    record.finish();
}

/// The jet with 12 modes and strips of random camber, flaps and suction, without profile drag.
fn cambered() -> ReducedModel {
    let mut model = jet().select(&(0..12).collect::<Vec<_>>());
    let mut next = random(11);
    for strip in &mut model.strips {
        strip.zero_lift_offset = 0.05 * next();
        strip.zero_lift_moment = 0.1 * next();
        strip.leading_edge_suction = 0.5 + 0.5 * next();
        strip.profile_drag = 0.0;
        if let Some(flap) = &mut strip.flap {
            flap.gains.iter_mut().for_each(|gain| *gain = next());
        }
    }
    model
}

/// The power of the air loads of a bent jet in steady flow and what the strips lose, W, and the powers of all lifts in modulus.
fn powers(model: &ReducedModel, seed: u64) -> [f64; 3] {
    let mut next = random(seed);
    let settings = soft(Fidelity::GeometricallyExact);
    let [with_strips, without] = [model.clone(), ReducedModel { strips: Vec::new(), ..model.clone() }]
        .map(|model| EquationsOfMotion::new(&model, &settings).unwrap());
    let layout = with_strips.layout();
    let mut state = vec![0.0; layout.len()];
    state[layout.position().end - 1] = -7620.0;
    state[layout.attitude().start] = 1.0;
    state[layout.coordinates()].iter_mut().for_each(|q| *q = 50.0 * next());
    let velocity = Vector3::new(127.0, 10.0 * next(), 10.0 * next());
    state[layout.velocity()].copy_from_slice(velocity.as_slice());
    let mut controls = with_strips.neutral_controls();
    controls.angles.iter_mut().for_each(|angle| *angle = 0.3 * next());
    let force = |equations: &EquationsOfMotion| {
        let mut workspace = Workspace::new(equations);
        equations.rates(&state, &controls, &mut vec![0.0; state.len()], &mut workspace);
        Vector3::from_column_slice(&workspace.forces()[..3])
    };
    let power = (force(&with_strips) - force(&without)).dot(&velocity);
    let density = Air::at(7620.0).density;
    let (mut lost, mut all) = (0.0, 0.0);
    for strip in &model.strips {
        let q = &state[layout.coordinates()];
        let turn = moving_point(&model.sections, [q, &[0.0; 12]], strip.section, &Vector3::zeros()).turn;
        let (forward, span) = (turn * strip.forward, turn * strip.span);
        let (chordwise, across) = (forward.dot(&velocity), forward.cross(&span).dot(&velocity));
        let flap_lift = strip.flap.as_ref().map_or(0.0, |flap| {
            let angle: f64 = flap.gains.iter().zip(&controls.angles).map(|(gain, angle)| gain * angle).sum();
            let hinge = libm::acos(2.0 * flap.hinge - 1.0);
            flap.lift_slope * angle * (hinge + libm::sin(hinge)) / PI
        });
        let slope = strip.lift_slope * (across + chordwise * strip.zero_lift_offset) + flap_lift * chordwise;
        let lift = density * strip.semichord * chordwise * slope * strip.width;
        lost += (1.0 - strip.leading_edge_suction) * lift * slope / strip.lift_slope;
        all += (lift * across).abs();
    }
    [power, lost, all]
}

#[test]
fn in_steady_flow_bent_wings_only_lose_what_suction_lacks() {
    let mut record = Record::new(
        "steady-power",
        "Jet with 12 modes, GE, bent by metres, random camber, flaps and suction, steady flow: power of the air loads and what the strips lose, over the powers of all lifts",
        "[theory: air-loads.steady-drag]: without profile drag a strip loses (1 − η) L²/(CLα ρ b U)",
    );
    let model = cambered();
    let apart = |seed| {
        let [power, lost, all] = powers(&model, seed);
        assert!(lost > 1e-3 * all);
        ((power + lost) / all).abs()
    };
    record.rounding("largest of 10 states", 1e-14, (0..10).map(apart).fold(0.0, f64::max));
    record.finish();
}

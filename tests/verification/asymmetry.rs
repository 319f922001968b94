//! Aircraft that are not symmetric: banked, with aileron and rudder set, they fly level and straight without sideslip.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Attachment, MassBay};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{InputReference, Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Plant, PlantSettings, TrimPoint};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{Slot, VariableTable};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::support::plain_loads::Instant;
use crate::support::plain_points::Moving;
use crate::support::{AILERON, ELEVATOR, RUDDER, angles, jet};

/// The shipped jet, changed by the caller.
fn changed_jet(change: impl FnOnce(&mut Aircraft)) -> Aircraft {
    let text = include_str!("../../aircraft/generic-business-jet.toml");
    let mut aircraft = Aircraft::parse(text, "generic-business-jet.toml").unwrap();
    change(&mut aircraft);
    aircraft
}

/// A point mass (kg) on the right wing, y metres from the plane of symmetry.
fn load(aircraft: &mut Aircraft, mass: f64, y: f64) {
    let nodes = &aircraft.nodes;
    let carries = |beam: &&flexible_aircraft::aircraft::Beam| {
        let [from, to] = beam.nodes.map(|node| nodes[node].y);
        beam.component == "wing_right" && from <= y && y <= to
    };
    let beam = aircraft.beams.iter().position(|beam| carries(&beam)).unwrap();
    let [from, to] = aircraft.beams[beam].nodes.map(|node| nodes[node].y);
    let attachment = Attachment { beam, fraction: (y - from) / (to - from) };
    aircraft.bays.push(MassBay { attachment, mass, offset: Vector3::zeros(), inertia: Matrix3::zeros() });
}

fn loaded_jet(mass: f64, y: f64) -> ReducedModel {
    ReducedModel::new(&changed_jet(|aircraft| load(aircraft, mass, y)), ReducedModel::USUAL_MODES).unwrap()
}

fn trim(model: &ReducedModel, settings: &Settings) -> TrimPoint {
    *Simulation::new(Arc::new(model.clone()), settings, 0.0).unwrap().trim()
}

/// v̇, ω̇ and q̈ at the trim, by their largest.
fn imbalance(model: &ReducedModel, settings: &Settings) -> f64 {
    let mut flight = Simulation::new(Arc::new(model.clone()), settings, 0.0).unwrap();
    let outputs = flight.outputs().clone();
    flight.advance_to(0.01).unwrap();
    let turned = (flight.outputs().rate - outputs.rate).amax() / 0.01;
    outputs.acceleration.amax().max(turned)
}

#[test]
fn a_trace_of_asymmetry_changes_the_trim_by_a_trace_with_any_number_of_modes() {
    let lopsided = loaded_jet(1e-6, 0.5);
    for mode_count in 0..=ReducedModel::USUAL_MODES {
        let settings =
            |model: &ReducedModel| Settings::from(PlantSettings { mode_count, ..PlantSettings::of(model) });
        let symmetric = trim(&jet(), &settings(&jet()));
        let found = trim(&lopsided, &settings(&lopsided));
        let differences = [
            found.pitch - symmetric.pitch,
            found.pitch_control - symmetric.pitch_control,
            1e-5 * (found.thrust - symmetric.thrust),
            found.roll,
            found.roll_control,
            found.yaw_control,
        ];
        assert!(
            differences.iter().all(|difference| difference.abs() < 1e-7),
            "{mode_count}: {differences:?}"
        );
        assert_eq!(found.sideslip, 0.0);
    }
}

#[test]
fn no_pair_of_modes_is_cut_in_half() {
    let lopsided = loaded_jet(1e-6, 0.5);
    let count = |mode_count| {
        Settings::from(PlantSettings { mode_count, ..PlantSettings::of(&lopsided) })
            .plant
            .choose_modes(&lopsided)
            .unwrap()
            .len()
    };
    // The first two modes are those of the two wings; the shipped jet has ten such pairs among its 26 modes.
    assert_eq!([0, 1, 2, 3, 4].map(count), [0, 2, 2, 4, 4]);
    let aircraft = changed_jet(|aircraft| load(aircraft, 1e-6, 0.5));
    assert_eq!(ReducedModel::new(&aircraft, 1).unwrap().modes.len(), 2);
    assert_eq!(ReducedModel::new(&aircraft, 2).unwrap().modes.len(), 2);
    // Symmetric and antisymmetric modes are whole each by itself.
    assert!(jet().modes.iter().all(|mode| !mode.completes_a_pair));
}

#[test]
fn gravity_thrust_and_the_air_balance_the_trimmed_aircraft_in_all_six_directions() {
    // Strip by strip (`support/plain_loads.rs`), bay by bay and engine by engine, from the aircraft's data.
    let aircraft = changed_jet(|aircraft| load(aircraft, 300.0, 5.0));
    let model = ReducedModel::new(&aircraft, 0).unwrap();
    let settings = Settings::from(PlantSettings {
        fidelity: Fidelity::Rigid,
        inflow_states: 0,
        ..PlantSettings::of(&model)
    });
    let plant = Plant::under(&model, &settings.plant).unwrap();
    let trim = plant.trim(&settings.plant.trim_condition()).unwrap();
    let rates = vec![0.0; trim.state.len()];
    let (equations, controls) = (plant.equations(), &trim.controls);
    let moving = Moving::Superposed;
    let instant = Instant { equations, moving, controls, state: &trim.state, rates: &rates, gust: None };
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    let mut act = |place: &Vector3<f64>, acting: Vector3<f64>| {
        force += acting;
        moment += place.cross(&acting);
    };
    let mut twisting = Vector3::zeros();
    for strip in &model.strips {
        let load = instant.load(strip);
        act(&strip.position, load.force);
        twisting += load.span * load.moment;
    }
    let TrimPoint { roll, pitch, roll_control: aileron, yaw_control: rudder, .. } = trim.point;
    let down = Rotation3::from_euler_angles(roll, pitch, 0.0).inverse() * Vector3::z();
    for bay in &aircraft.bays {
        let [from, to] = aircraft.beams[bay.attachment.beam].nodes.map(|node| aircraft.nodes[node]);
        let place = from + (to - from) * bay.attachment.fraction + bay.offset;
        act(&place, down * (aircraft.gravity * bay.mass));
    }
    for engine in &model.engines {
        act(&engine.position, engine.direction * trim.point.thrust);
    }
    moment += twisting;
    // Of a weight of 290 kN and moments of some 100 kN m.
    assert!(force.amax() < 1e-4 && moment.amax() < 1e-3, "{force} {moment}");
    // 300 kg at 5 m roll to the right: the aileron rolls left.
    assert!(aileron < -1e-3 && roll != 0.0 && rudder != 0.0, "{:?}", trim.point);
}

#[test]
fn a_jet_with_a_load_on_one_wing_trims_level_and_flies_straight_for_a_minute() {
    let model = Arc::new(loaded_jet(300.0, 5.0));
    for fidelity in Fidelity::ALL {
        let settings = Settings::from(PlantSettings { fidelity, ..PlantSettings::of(&model) });
        let mut flight = Simulation::new(Arc::clone(&model), &settings, 0.0).unwrap();
        let point = *flight.trim();
        let begin = flight.outputs().clone();
        assert!(!flight.is_symmetric());
        assert!((begin.attitude - Vector3::new(point.roll, point.pitch, 0.0)).amax() < 1e-14);
        assert!(
            begin.air.sideslip.abs() < 1e-14
                && (begin.controls[AILERON], begin.controls[RUDDER])
                    == (point.roll_control, point.yaw_control)
        );
        let seconds = if fidelity == Fidelity::Exact { 60.0 } else { 5.0 };
        flight.advance_to(seconds).unwrap();
        let end = flight.outputs();
        assert!(
            (end.attitude - begin.attitude).amax() < 1e-6,
            "{fidelity:?}: {}",
            end.attitude - begin.attitude
        );
        // The velocity is in the aircraft's own plane y = 0, and that is banked: the track is not quite the heading.
        let [roll, pitch, yaw] = [begin.attitude.x, begin.attitude.y, begin.attitude.z];
        let velocity = Rotation3::from_euler_angles(roll, pitch, yaw) * begin.velocity;
        assert!(velocity.z.abs() < 1e-12 && (velocity.norm() - 127.0).abs() < 1e-12);
        let astray = end.position - begin.position - velocity * seconds;
        assert!(astray.norm() < 1e-3, "{fidelity:?}: {astray}");
        assert!(end.air.sideslip.abs() < 1e-7);
    }
}

#[test]
fn the_outputs_name_the_lateral_trim_and_inputs_add_to_it() {
    let model = Arc::new(loaded_jet(300.0, 5.0));
    let variables = VariableTable::new(&model);
    let read = |flight: &mut Simulation, name: &str| {
        let variable = variables.get(variables.reference(name).unwrap()).unwrap();
        let Slot::Output(slot) = variable.slot else { panic!("{name} is no output") };
        slot.number(flight.instant())
    };
    let mut flight = Simulation::new(Arc::clone(&model), &Settings::of(&model), 0.0).unwrap();
    let point = *flight.trim();
    for (name, value) in [
        ("trim.roll", point.roll),
        ("trim.beta", 0.0),
        ("trim.aileron", point.roll_control),
        ("trim.rudder", point.yaw_control),
        ("attitude.roll", point.roll),
        ("surface.aileron", point.roll_control),
        ("surface.rudder", point.yaw_control),
    ] {
        assert!((read(&mut flight, name) - value).abs() < 1e-15, "{name}");
    }
    let still = Inputs::zero(&jet());
    flight.set_inputs(&angles(&jet(), &[(AILERON, 0.01), (RUDDER, -0.02)]), &still);
    assert!((read(&mut flight, "surface.aileron") - point.roll_control - 0.01).abs() < 1e-15);
    assert!((read(&mut flight, "surface.rudder") - point.yaw_control + 0.02).abs() < 1e-15);

    let absolute = Settings { input_reference: InputReference::Absolute, ..Settings::of(&model) };
    let mut flight = Simulation::new(Arc::clone(&model), &absolute, 0.0).unwrap();
    let TrimPoint { pitch_control, roll_control, yaw_control, thrust, .. } = point;
    let trimmed = [(ELEVATOR, pitch_control), (AILERON, roll_control), (RUDDER, yaw_control)];
    let trimmed = Inputs { thrust: vec![thrust; 2], ..angles(&jet(), &trimmed) };
    flight.set_inputs(&trimmed, &still);
    flight.advance_to(2.0).unwrap();
    assert!((flight.outputs().attitude.x - point.roll).abs() < 1e-9);
}

#[test]
fn an_engine_off_the_centre_line_is_balanced_by_the_rudder() {
    let aircraft = changed_jet(|aircraft| aircraft.engines[0].offset.y += 1.0);
    let model = ReducedModel::new(&aircraft, 6).unwrap();
    let settings = Settings::of(&model);
    let point = trim(&model, &settings);
    // The thrust is too far to the right and yaws to the left: the rudder yaws right, the wing's lift goes against its force.
    assert!(point.yaw_control > 1e-3, "{point:?}");
    assert!(imbalance(&model, &settings) < 1e-6);
}

/// The jet with a load and without some kinds of surfaces.
fn without(aileron: bool, rudder: bool) -> ReducedModel {
    let mut model = loaded_jet(300.0, 5.0);
    for flap in model.strips.iter_mut().filter_map(|strip| strip.flap.as_mut()) {
        if aileron {
            flap.gains[AILERON] = 0.0;
        }
        if rudder {
            flap.gains[RUDDER] = 0.0;
        }
    }
    model
}

#[test]
fn where_a_control_is_missing_the_aircraft_slips() {
    for (model, missing) in [(without(false, true), "rudder"), (without(true, false), "aileron")] {
        let settings = Settings::of(&model);
        let point = trim(&model, &settings);
        assert!(point.sideslip.abs() > 1e-4, "{missing}: {point:?}");
        assert!(if missing == "rudder" { point.yaw_control == 0.0 } else { point.roll_control == 0.0 });
        assert!(imbalance(&model, &settings) < 1e-6, "{missing}");
    }
}

#[test]
fn without_aileron_and_rudder_the_unbalanced_moments_are_named() {
    let model = without(true, true);
    let error = Simulation::new(Arc::new(model.clone()), &Settings::of(&model), 0.0).unwrap_err().to_string();
    assert!(error.contains("no control with trim = \"roll\" or \"yaw\" moves anything"), "{error}");
    let after = error.split("a rolling moment of ").nth(1).unwrap();
    let rolling: f64 = after.split(' ').next().unwrap().parse().unwrap();
    // 300 kg at 5 m, pitched by 0.14 rad; the elastic wing gives way by some centimetres.
    let expected = 300.0 * 9.806 * 5.0 * libm::cos(0.14);
    assert!((rolling / expected - 1.0).abs() < 0.3, "{error}");
    assert!(error.contains("rate.x (roll) stays unbalanced"), "{error}");
}

#[test]
fn with_one_engine_out_the_trim_is_that_of_an_independent_code() {
    // Nominal, right engine out, no sideslip [theory: trim.lateral]: by a numpy prototype that shares nothing with this program.
    let aircraft = changed_jet(|aircraft| aircraft.engines.retain(|engine| engine.name == "left"));
    let model = ReducedModel::new(&aircraft, ReducedModel::USUAL_MODES).unwrap();
    let point = trim(&model, &Settings::of(&model));
    let expected = [
        (point.angle_of_attack(), 0.140035),
        (point.roll, -0.030648),
        (point.pitch, 0.139970),
        (point.pitch_control, -0.245381),
        (point.roll_control, -0.010583),
        (point.yaw_control, -0.333767),
        (point.thrust, 47_766.7),
    ];
    for (found, expected) in expected {
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected} {point:?}");
    }
}

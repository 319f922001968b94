//! Trims beyond level flight, against an independent computation [theory: trim.manoeuvres].

use std::f64::consts::{FRAC_PI_6, PI};
use std::sync::Arc;

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{
    ConditionSettings, Held, Lateral, LimitedTrimError, ManoeuvreChoice, Outputs, PlantSettings, Shortfall,
    TrimLimits,
};
use flexible_aircraft::symmetry::Plants;

use crate::support::{ELEVATOR, RUDDER, jet, up};

use super::record::Record;

const SOURCE: &str = "prototype in numpy that shares nothing with this program; its printed digits";

/// The jet at 127 m/s and 7620 m with twelve modes of both families.
fn settings(stiffness_scale: f64, condition: ConditionSettings) -> Settings {
    let base = PlantSettings::of(&jet());
    PlantSettings { fidelity: Fidelity::Exact, stiffness_scale, condition, ..base }.into()
}

fn straight() -> ConditionSettings {
    ConditionSettings::default()
}

fn climb(degrees: f64) -> ConditionSettings {
    ConditionSettings { climb_angle: degrees * PI / 180.0, ..straight() }
}

fn turn() -> ConditionSettings {
    ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, bank_angle: FRAC_PI_6, ..straight() }
}

fn turn_at(load_factor: f64) -> ConditionSettings {
    ConditionSettings { manoeuvre: ManoeuvreChoice::Turn, load_factor, ..straight() }
}

fn pull_up() -> ConditionSettings {
    ConditionSettings { manoeuvre: ManoeuvreChoice::PullUp, load_factor: 1.5, ..straight() }
}

fn sideslip() -> ConditionSettings {
    ConditionSettings { sideslip: 3.0 * PI / 180.0, ..straight() }
}

/// Without the thrust of the engine with this number.
fn engine_out(failed_engine: usize) -> ConditionSettings {
    ConditionSettings { failed_engine, ..straight() }
}

/// A row of the independent computation: angles, rad; thrust of all engines, N; ψ̇ or q, rad/s; wing tips, m.
struct Row {
    name: &'static str,
    stiffness_scale: f64,
    condition: ConditionSettings,
    /// α, β, φ, θ, elevator, aileron, rudder.
    angles: [f64; 7],
    thrust: f64,
    rate: f64,
    tips: [f64; 2],
}

fn table() -> Vec<Row> {
    let row = |name, stiffness_scale, condition, angles, thrust, rate, tips| Row {
        name,
        stiffness_scale,
        condition,
        angles,
        thrust,
        rate,
        tips,
    };
    vec![
        row(
            "nominal, climb 5°",
            1.0,
            climb(5.0),
            [0.138363, 0.0, 0.0, 0.225629, -0.281104, 0.0, 0.0],
            71_507.0,
            0.0,
            [0.55044; 2],
        ),
        row(
            "nominal, descent 4°",
            1.0,
            climb(-4.0),
            [0.140780, 0.0, 0.0, 0.070967, -0.218549, 0.0, 0.0],
            27_719.7,
            0.0,
            [0.55838; 2],
        ),
        row(
            "nominal, turn φ 30°",
            1.0,
            turn(),
            [0.161578, -0.000090, FRAC_PI_6, 0.140190, -0.346782, -0.005023, 0.031179],
            59_991.0,
            0.043998,
            [0.63068, 0.62883],
        ),
        row(
            "nominal, turn n 1.5",
            1.0,
            turn_at(1.5),
            [0.211908, 0.001075, 0.852423, 0.141471, -0.585594, -0.008410, 0.036163],
            96_012.6,
            0.086326,
            [0.78794, 0.78551],
        ),
        row(
            "nominal, pull-up 1.5",
            1.0,
            pull_up(),
            [0.212124, 0.0, 0.0, 0.212124, -0.563419, 0.0, 0.0],
            96_103.3,
            0.038606,
            [0.78681; 2],
        ),
        row(
            "nominal, sideslip 3°",
            1.0,
            sideslip(),
            [0.140528, 0.052360, 0.018608, 0.141469, -0.250781, 0.044317, -0.308703],
            47_732.7,
            0.0,
            [0.54244, 0.56949],
        ),
        row(
            "nominal, right engine out, β 0",
            1.0,
            engine_out(2),
            [0.140035, 0.0, -0.030648, 0.139970, -0.245381, -0.010583, -0.333767],
            47_766.7,
            0.0,
            [0.56638, 0.54554],
        ),
        row(
            "tenth, level",
            0.1,
            straight(),
            [0.158940, 0.0, 0.0, 0.158940, -0.355800, 0.0, 0.0],
            49_847.1,
            0.0,
            [2.68684; 2],
        ),
        row(
            "tenth, climb 5°",
            0.1,
            climb(5.0),
            [0.156721, 0.0, 0.0, 0.243987, -0.385590, 0.0, 0.0],
            73_764.0,
            0.0,
            [2.66566; 2],
        ),
        row(
            "tenth, turn φ 30°",
            0.1,
            turn(),
            [0.184251, 0.000179, FRAC_PI_6, 0.160106, -0.479947, -0.005304, 0.028990],
            63_494.4,
            0.043823,
            [2.88060, 2.87619],
        ),
        row(
            "tenth, pull-up 1.5",
            0.1,
            pull_up(),
            [0.245134, 0.0, 0.0, 0.245134, -0.762699, 0.0, 0.0],
            103_609.3,
            0.038606,
            [3.2578; 2],
        ),
        row(
            "tenth, right engine out, β 0",
            0.1,
            engine_out(2),
            [0.158830, 0.0, -0.029548, 0.158762, -0.352857, -0.011116, -0.443881],
            50_241.3,
            0.0,
            [2.71102, 2.66041],
        ),
    ]
}

/// Outputs at the start.
fn start(settings: &Settings) -> Outputs {
    Simulation::new(jet(), settings, 0.0).unwrap().instant_with_loads().outputs.clone()
}

#[test]
fn climbs_turns_pull_ups_sideslip_and_a_failed_engine_are_trimmed_as_the_independent_computation_has_them() {
    let mut record = Record::new(
        "trim-manoeuvres",
        "Trims of the jet beyond level flight, 127 m/s, 7620 m, twelve modes: angles (rad), total thrust (N), rates (rad/s), wing tips up (m)",
        SOURCE,
    );
    for Row { name, stiffness_scale, condition, angles, thrust, rate, tips } in table() {
        let mut flight = Simulation::new(jet(), &settings(stiffness_scale, condition), 0.0).unwrap();
        let point = *flight.trim();
        let found = [
            point.angle_of_attack(),
            point.sideslip,
            point.roll,
            point.pitch,
            point.pitch_control,
            point.roll_control,
            point.yaw_control,
        ];
        let words = ["α", "β", "φ", "θ", "elevator", "aileron", "rudder"];
        for ((word, reference), found) in words.into_iter().zip(angles).zip(found) {
            record.absolute(&format!("{name}: {word}"), reference, 6e-7, found);
        }
        let outputs = flight.outputs();
        record.absolute(&format!("{name}: thrust"), thrust, 0.06, outputs.thrust.iter().sum());
        record.absolute(&format!("{name}: rate"), rate, 6e-7, point.turn_rate + point.pitch_rate);
        for (tip, reference) in ["wing_tip_right", "wing_tip_left"].into_iter().zip(tips) {
            // One of them is printed to four digits.
            let tolerance = if reference > 3.0 { 6e-5 } else { 6e-6 };
            record.absolute(&format!("{name}: {tip}"), reference, tolerance, up(outputs, tip));
        }
    }
    record.finish();
}

#[test]
fn load_factors_and_rates_of_turns_and_pull_ups_are_those_of_their_closed_forms() {
    let gravity = jet().gravity;
    let start_of = |condition| {
        let flight = Simulation::new(jet(), &settings(1.0, condition), 0.0).unwrap();
        (*flight.trim(), start(&settings(1.0, condition)))
    };
    for load_factor in [1.5, -1.5] {
        let (point, outputs) = start_of(turn_at(load_factor));
        // Exactly ψ̇ = (g/V) √(n² − 1), to the left for a negative one.
        let rate = gravity / 127.0 * 1.25_f64.sqrt() * load_factor.signum();
        assert!((point.turn_rate - rate).abs() < 1e-9, "{}", point.turn_rate);
        assert!((outputs.lift_load_factor - 1.5).abs() < 1e-7 && outputs.load_factor.y.abs() < 1e-7);
        assert!((point.load_factor - outputs.lift_load_factor).abs() < 1e-7);
    }
    let (point, outputs) = start_of(pull_up());
    assert!((point.pitch_rate - gravity * 0.5 / 127.0).abs() < 1e-9);
    assert!((outputs.lift_load_factor - 1.5).abs() < 1e-7);
    let (point, outputs) = start_of(climb(5.0));
    assert!((outputs.path.climb_angle - 5.0 * PI / 180.0).abs() < 1e-12);
    assert!((point.load_factor - (5.0 * PI / 180.0).cos()).abs() < 1e-7);
    // Mirror images: the left engine out, and the bank angle given that it needs.
    let [(right, _), (left, _)] = [2, 1].map(|engine| start_of(engine_out(engine)));
    assert!((right.yaw_control + left.yaw_control).abs() < 1e-9 && (right.roll + left.roll).abs() < 1e-9);
    let banked = ConditionSettings { bank_angle: right.roll, lateral: Lateral::Bank, ..engine_out(2) };
    let (banked, _) = start_of(banked);
    assert!(banked.sideslip.abs() < 1e-9 && (banked.yaw_control - right.yaw_control).abs() < 1e-8);
}

#[test]
fn a_flight_that_begins_in_a_manoeuvre_goes_on_in_it() {
    const SECONDS: f64 = 2.0;
    for condition in [climb(5.0), turn(), sideslip(), engine_out(1)] {
        let mut flight = Simulation::new(jet(), &settings(1.0, condition), 0.0).unwrap();
        let (point, before) = (*flight.trim(), flight.outputs().clone());
        flight.advance_to(SECONDS).unwrap();
        let after = flight.outputs();
        let (turned, climbed) = (after.attitude.z - before.attitude.z, before.position.z - after.position.z);
        // Only the air thins on the way up, by 0.3 %.
        let [of_load_factor, of_rate, of_height] =
            if condition.climb_angle == 0.0 { [1e-6, 1e-6, 1e-4] } else { [5e-3, 2e-3, 0.05] };
        assert!((after.load_factor - before.load_factor).norm() < of_load_factor, "{condition:?}");
        assert!((after.rate - before.rate).norm() < of_rate, "{condition:?}");
        assert!((turned - point.turn_rate * SECONDS).abs() < 1e-5, "{condition:?}: {turned}");
        let height = 127.0 * point.climb_angle.sin() * SECONDS;
        assert!((climbed - height).abs() < of_height, "{condition:?}: {climbed}");
    }
    let out = start(&settings(1.0, engine_out(1)));
    assert!(out.thrust[0] == 0.0 && out.thrust[1] > 4e4, "{:?}", out.thrust);
}

/// Limits that bind nothing.
fn free() -> TrimLimits {
    let any = [f64::NEG_INFINITY, f64::INFINITY];
    TrimLimits { controls: vec![any; jet().controls.len()], thrust: any }
}

/// What is left of a trim within limits.
fn held(stiffness_scale: f64, condition: ConditionSettings, limits: &TrimLimits) -> Vec<Held> {
    let plant = settings(stiffness_scale, condition).plant;
    let plants = Plants::under(&jet(), &plant).unwrap();
    match plants.trim_within(&plant.trim_condition(), limits).1 {
        Err(LimitedTrimError::Beyond(Shortfall { held, found: true })) => held,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_a_trim_lacks_within_limits_is_what_the_independent_computation_says() {
    let mut elevator = free();
    for (stiffness_scale, limit, needed, left) in
        [(1.0, -0.2, -0.2479, -0.02363), (0.1, -0.3, -0.3558, -0.02241)]
    {
        elevator.controls[ELEVATOR] = [limit, 1.0];
        let [found] = &held(stiffness_scale, straight(), &elevator)[..] else { panic!("one") };
        assert!((found.needed - needed).abs() < 6e-5 && (found.left - left).abs() < 6e-6, "{found:?}");
    }
    // A kilonewton too little for each engine is missing along the path, with sideslip and without.
    let mass = jet().integrals.mass;
    for condition in [climb(5.0), sideslip()] {
        let trim = *Simulation::new(jet(), &settings(1.0, condition), 0.0).unwrap().trim();
        let thrust = TrimLimits { thrust: [0.0, trim.thrust - 1e3], ..free() };
        let [found] = &held(1.0, condition, &thrust)[..] else { panic!("one") };
        // Thrust is along the body's axis; the rest of it goes into incidence and elevator.
        let expected = -2e3 / mass * trim.angle_of_attack().cos();
        assert!((found.left / expected - 1.0).abs() < 0.1, "{found:?} {expected}");
    }
    assert!(
        Plants::under(&jet(), &settings(1.0, turn()).plant)
            .unwrap()
            .trim_within(&settings(1.0, turn()).plant.trim_condition(), &free())
            .1
            .is_ok()
    );
}

#[test]
fn without_the_controls_that_hold_it_a_flight_is_refused_or_held_by_sideslip() {
    let mut model = (*jet()).clone();
    model.controls[RUDDER].role = None;
    let model = Arc::new(model);
    let trimmed = |condition| Simulation::new(Arc::clone(&model), &settings(1.0, condition), 0.0);
    let refused = trimmed(sideslip()).unwrap_err().to_string();
    assert!(
        refused.contains("no steady flight with sideslip: it needs controls with trim = \"roll\" and"),
        "{refused}"
    );
    let mut out = trimmed(engine_out(2)).unwrap();
    assert!(out.trim().sideslip.abs() > 0.01 && out.trim().yaw_control == 0.0, "{:?}", out.trim());
    assert!(out.outputs().acceleration.norm() < 1e-6);
    let mut turning = trimmed(turn()).unwrap();
    let lateral = turning.outputs().load_factor.y;
    assert!(lateral.abs() > 1e-4 && turning.trim().turn_rate > 0.04, "{lateral}");
}

#[test]
fn section_loads_in_a_pull_up_and_with_an_engine_out_are_those_of_the_independent_computation() {
    let mut record = Record::new(
        "section-loads-manoeuvres",
        "Section loads of the jet, nominal stiffness: pull-up with n = 1.5, and the left engine out without sideslip (N, N m)",
        SOURCE,
    );
    let cases = [
        (
            "pull-up 1.5, wing_root_right",
            pull_up(),
            "wing_root_right",
            [135_221.0, -14_209.0, -14_877.0, 77_116.0, 792_571.0, -56_597.0],
        ),
        (
            "left engine out, vtail_root",
            engine_out(1),
            "vtail_root",
            [9022.0, -2841.0, -2071.0, -1674.0, 23_019.0, -6971.0],
        ),
    ];
    let words = ["shear", "shear_chordwise", "axial", "torsion", "bending", "bending_chordwise"];
    for (name, condition, cut, references) in cases {
        let outputs = start(&settings(1.0, condition));
        let place = jet().cuts.iter().position(|other| other.name == cut).unwrap();
        let loads = outputs.loads.known().unwrap()[place];
        let found = [
            loads.shear,
            loads.shear_chordwise,
            loads.axial,
            loads.torsion,
            loads.bending,
            loads.bending_chordwise,
        ];
        for ((word, reference), found) in words.into_iter().zip(references).zip(found) {
            record.absolute(&format!("{name}: {word}"), reference, 0.6, found);
        }
    }
    record.finish();
}

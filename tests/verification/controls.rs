//! Controls of other aircraft than the jet: ruddervators, elevons, eight flaps that move each by itself. They fly, trim, and
//! leave symmetry exactly when what they do is not alike on both sides.

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, TrimRole};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::plant::{Outputs, Plant};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::SymmetricHalf;
use nalgebra::Vector3;

use crate::support::angles;

const V_TAIL: &str = include_str!("../data/v-tail.toml");
const ELEVONS: &str = include_str!("../data/elevons.toml");
const EIGHT_FLAPS: &str = include_str!("../data/eight-flaps.toml");

/// An angle so small that it moves nothing, but three times as much as counts as rounding [theory: symmetry.unfolding]: the
/// whole aircraft flies.
const NOTHING: f64 = 3.0 * 16.0 * f64::EPSILON;

fn reduced(text: &str) -> Arc<ReducedModel> {
    let aircraft = Aircraft::parse(text, "controls.toml").unwrap_or_else(|error| panic!("{error}"));
    Arc::new(ReducedModel::new(&aircraft, 12).unwrap())
}

/// The file with some text replaced.
fn edited(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

fn flight(model: &Arc<ReducedModel>) -> Simulation {
    let settings = Settings { tolerance: 1e-8, ..Settings::of(model) };
    Simulation::new(Arc::clone(model), &settings, 0.0).unwrap_or_else(|error| panic!("{error}"))
}

/// Inputs at zero but for the angles of controls by their names.
fn named(model: &ReducedModel, moved: &[(&str, f64)]) -> Inputs {
    let place = |name: &str| model.control(name).unwrap_or_else(|| panic!("no control {name}"));
    angles(model, &moved.iter().map(|&(name, angle)| (place(name), angle)).collect::<Vec<_>>())
}

/// What half a second under some angles makes of the trimmed flight.
fn moved(model: &Arc<ReducedModel>, moved: &[(&str, f64)]) -> Simulation {
    let mut flight = flight(model);
    flight.set_inputs(&named(model, moved), &Inputs::zero(model));
    flight.advance_to(0.5).unwrap();
    flight
}

fn rate(mut flight: Simulation) -> [f64; 3] {
    flight.outputs().rate.into()
}

#[test]
fn ruddervators_pitch_together_and_yaw_against_each_other() {
    let model = reduced(V_TAIL);
    let trim = *flight(&model).trim();
    assert!(
        trim.pitch_control.abs() < 0.2 && (trim.roll_control, trim.yaw_control) == (0.0, 0.0),
        "{trim:?}"
    );
    let together = moved(&model, &[("pitch_tail", 0.02)]);
    assert!(together.is_symmetric());
    let [roll, pitch, yaw] = rate(together);
    assert!(pitch < -0.01 && (roll, yaw) == (0.0, 0.0), "{pitch}");
    let against = moved(&model, &[("yaw_tail", 0.02)]);
    assert!(!against.is_symmetric());
    let [_, pitch, yaw] = rate(against);
    assert!(yaw > 0.005 && pitch.abs() < 0.1 * yaw, "{pitch} {yaw}");
}

/// Against each other they leave the right ruddervator alone: without the left one, nothing happens.
#[test]
fn controls_on_the_same_flap_add_up() {
    let model = reduced(V_TAIL);
    let settings = Settings::of(&model);
    let trim = Plant::under(&model, &settings.plant).unwrap().trim(&settings.plant.trim_condition()).unwrap();
    let mut right = (*model).clone();
    for strip in right.strips.iter_mut().filter(|strip| strip.component == "tail_left") {
        strip.flap.as_mut().unwrap().gains.fill(0.0);
    }
    let plant = Plant::under(&right, &settings.plant).unwrap();
    let turning = |moved: &[(&str, f64)]| {
        let mut controls = trim.controls.clone();
        controls
            .angles
            .iter_mut()
            .zip(named(&model, moved).controls)
            .for_each(|(angle, more)| *angle += more);
        let (mut rates, mut workspace) = (vec![0.0; trim.state.len()], plant.workspace());
        plant.rates(&trim.state, &controls, &mut rates, &mut workspace);
        Vector3::from_column_slice(&rates[plant.layout().rate()])
    };
    let still = turning(&[]);
    let moves = |moved: &[(&str, f64)]| (turning(moved) - still).norm();
    assert!(moves(&[("pitch_tail", 0.03)]) > 1e-2 && moves(&[("yaw_tail", 0.03)]) > 1e-2);
    assert!(moves(&[("pitch_tail", 0.03), ("yaw_tail", -0.03)]) < 1e-12);
}

#[test]
fn elevons_pitch_together_and_roll_against_each_other() {
    let model = reduced(ELEVONS);
    assert_eq!(model.control_for(TrimRole::Yaw), None);
    let together = moved(&model, &[("elevator", 0.01)]);
    assert!(together.is_symmetric());
    assert!(rate(together)[1] < -0.005);
    let against = moved(&model, &[("aileron", 0.01)]);
    assert!(!against.is_symmetric());
    assert!(rate(against)[0] > 0.01);
}

#[test]
fn a_flying_wing_that_is_not_symmetric_slips_for_want_of_a_control_for_yaw() {
    let lopsided = edited(ELEVONS, "symmetric = true", "symmetric = false");
    let lopsided = edited(&lopsided, "offset_m = [-0.65, 0, 0.1]", "offset_m = [-0.65, 0.05, 0.1]");
    let trim = *flight(&reduced(&lopsided)).trim();
    // The mass is on the right: the aileron rolls left.
    assert!(trim.roll_control < -1e-3 && trim.sideslip != 0.0 && trim.yaw_control == 0.0, "{trim:?}");
}

const PAIRS: [[&str; 2]; 4] = [
    ["flap_right_1", "flap_left_1"],
    ["flap_right_2", "flap_left_2"],
    ["flap_right_3", "flap_left_3"],
    ["flap_right_4", "flap_left_4"],
];

#[test]
fn each_flap_alone_leaves_symmetry_and_each_equal_pair_keeps_it() {
    let model = reduced(EIGHT_FLAPS);
    assert_eq!(model.controls.len(), 9);
    for [right, left] in PAIRS {
        assert!(moved(&model, &[(right, 0.03), (left, 0.03)]).is_symmetric(), "{right}");
        assert!(!moved(&model, &[(right, 0.03)]).is_symmetric(), "{right}");
        assert!(!moved(&model, &[(left, -0.03)]).is_symmetric(), "{left}");
        assert!(!moved(&model, &[(right, 0.03), (left, -0.03)]).is_symmetric(), "{right}");
        assert!(!moved(&model, &[(right, 0.03), (left, 0.03 + 1e-13)]).is_symmetric(), "{right}");
    }
    // A flap rolls the aircraft away from its side.
    assert!(rate(moved(&model, &[("flap_right_4", 0.03)]))[0] < -0.005);
    assert!(rate(moved(&model, &[("flap_left_4", 0.03)]))[0] > 0.005);
    // What differs by rounding alone is alike.
    let rounded = moved(&model, &[("flap_right_2", 0.1 + 0.2), ("flap_left_2", 0.3)]);
    assert!(rounded.is_symmetric());
}

#[test]
fn pairs_that_ramp_alike_keep_symmetry_and_others_leave_it() {
    let model = reduced(EIGHT_FLAPS);
    for (left, is_symmetric) in [(0.05, true), (0.04, false), (-0.05, false)] {
        let mut flight = flight(&model);
        flight.set_inputs(
            &Inputs::zero(&model),
            &named(&model, &[("flap_right_3", 0.05), ("flap_left_3", left)]),
        );
        flight.advance_to(0.5).unwrap();
        assert_eq!(flight.is_symmetric(), is_symmetric, "{left}");
    }
}

/// The largest differences of accelerations and rates, and of the tips' deflections.
fn compare(half: &Outputs, whole: &Outputs) -> [f64; 2] {
    let far = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0_f64, |far, (a, b)| far.max((a - b).abs()));
    let tips =
        |outputs: &Outputs| -> Vec<f64> { outputs.deflections.iter().map(|d| d.displacement.z).collect() };
    let motion = far(half.acceleration.as_slice(), whole.acceleration.as_slice())
        .max(far(half.rate.as_slice(), whole.rate.as_slice()));
    [motion, far(&tips(half), &tips(whole))]
}

#[test]
fn pairs_of_flaps_fly_half_the_aircraft_as_the_whole_one() {
    let model = reduced(EIGHT_FLAPS);
    let fly = |aside: f64| {
        let mut flight = flight(&model);
        let mut history = Vec::new();
        for step in 0..300 {
            let time = 0.01 * f64::from(step);
            let mut pairs = vec![("elevator", 0.01 * libm::sin(3.0 * time))];
            for (number, [right, left]) in PAIRS.into_iter().enumerate() {
                let angle = 0.05 * libm::sin((2.0 + number as f64) * time);
                pairs.extend([(right, angle), (left, angle)]);
            }
            pairs[1].1 += aside;
            flight.set_inputs(&named(&model, &pairs), &Inputs::zero(&model));
            flight.advance_to(time + 0.01).unwrap();
            assert_eq!(flight.is_symmetric(), aside == 0.0);
            history.push(flight.outputs().clone());
        }
        history
    };
    let (half, whole) = (fly(0.0), fly(NOTHING));
    let worst = half.iter().zip(&whole).fold([0.0_f64; 2], |worst, (half, whole)| {
        let found = compare(half, whole);
        [worst[0].max(found[0]), worst[1].max(found[1])]
    });
    // m/s² and rad/s, m.
    assert!(worst[0] < 1e-10 && worst[1] < 1e-12, "{worst:?}");
    let peak = half.iter().fold(0.0_f64, |peak, outputs| peak.max(outputs.rate.y.abs()));
    assert!(peak > 0.01, "{peak}");
}

/// The condition is on the flap, not on the aircraft.
#[test]
fn a_flap_on_one_side_alone_leaves_symmetry_when_it_moves() {
    let lonely = "    { input = \"flap_left_2\", side = \"left\", gain = 1, from = 0.32, to = 0.54 },\n";
    let model = reduced(&edited(EIGHT_FLAPS, lonely, &lonely.replace("gain = 1", "gain = 0")));
    assert!(SymmetricHalf::find(&model).is_some());
    assert!(moved(&model, &[("elevator", 0.01), ("flap_left_2", 0.1)]).is_symmetric());
    assert!(!moved(&model, &[("flap_right_2", 0.1)]).is_symmetric());
    assert!(!moved(&model, &[("flap_right_2", 0.1), ("flap_left_2", 0.1)]).is_symmetric());
}

/// Other flaps on the left than on the right: both have to rest.
#[test]
fn flaps_that_do_not_mirror_each_other_leave_symmetry_also_together() {
    let mut model = (*reduced(EIGHT_FLAPS)).clone();
    for strip in model.strips.iter_mut().filter(|strip| strip.component == "wing_left") {
        strip.flap.as_mut().unwrap().hinge = 0.7;
    }
    let model = Arc::new(model);
    assert!(moved(&model, &[("elevator", 0.01)]).is_symmetric());
    assert!(!moved(&model, &[("flap_right_1", 0.02), ("flap_left_1", 0.02)]).is_symmetric());
}

/// Without it there is no trim, and with it nothing is symmetric.
#[test]
fn an_elevator_on_one_side_alone_is_trimmed_as_the_whole_aircraft() {
    let one_sided = edited(EIGHT_FLAPS, "mirror = \"same\"", "mirror = \"none\"");
    let one_sided =
        edited(&one_sided, "input = \"elevator\", gain", "input = \"elevator\", side = \"right\", gain");
    let one_sided = edited(&one_sided, "name = \"flap_right_4\"", "name = \"flap_right_4\"\ntrim = \"roll\"");
    let model = reduced(&one_sided);
    assert!(SymmetricHalf::find(&model).is_none());
    let flight = flight(&model);
    assert!(!flight.is_symmetric());
    assert!(flight.trim().pitch_control != 0.0 && flight.trim().roll_control != 0.0);
}

#[test]
fn the_description_of_a_trim_and_its_warnings_use_the_names_of_the_file() {
    let limited = edited(V_TAIL, "trim = \"pitch\"", "trim = \"pitch\"\nminimum_deg = 10\nmaximum_deg = 20");
    let model = reduced(&limited);
    let flight = flight(&model);
    let described = flight.trim().describe(&model.controls, true);
    assert!(described.contains(", pitch_tail ") && !described.contains("elevator"), "{described}");
    let [exceeded] = flight.limits_exceeded() else { panic!("{:?}", flight.limits_exceeded()) };
    let text = exceeded.to_string();
    assert!(
        text.starts_with("pitch_tail ")
            && text.ends_with("is below 0.1745 rad (10.0°), the aircraft file's limit")
    );
}

#[test]
fn without_a_control_for_pitch_the_refusal_says_what_is_missing() {
    let refused = |text: &str| {
        let model = reduced(text);
        Simulation::new(Arc::clone(&model), &Settings::of(&model), 0.0).unwrap_err().to_string()
    };
    assert_eq!(
        refused(&edited(ELEVONS, "trim = \"pitch\"\n", "")),
        "no steady level flight: no control has trim = \"pitch\"; give it to one of: elevator"
    );
    assert_eq!(
        refused(&edited(ELEVONS, "{ input = \"elevator\", gain = 1", "{ input = \"elevator\", gain = 0")),
        "no steady level flight: elevator has trim = \"pitch\" and moves no flap"
    );
    let start = ELEVONS.find("[[control]]").unwrap();
    let (end, moves) = (ELEVONS.find("[[component]]").unwrap(), ELEVONS.find("control = [").unwrap());
    let after_moves = moves + ELEVONS[moves..].find("\n]").unwrap() + 2;
    let none = [&ELEVONS[..start], &ELEVONS[end..moves], &ELEVONS[after_moves..]].concat();
    assert_eq!(
        refused(&none),
        "no steady level flight: no control has trim = \"pitch\"; there are no controls: add a [[control]] for it"
    );
}

/// The recipe of the format's description.
#[test]
fn elevons_that_move_by_themselves_are_trimmed_by_a_stick_beside_them() {
    let page = include_str!("../../aircraft/README.md");
    let blocks: Vec<&str> =
        page.split("```toml\n").skip(1).filter_map(|block| block.split("```").next()).collect();
    let recipe =
        |of: &str| *blocks.iter().find(|block| block.contains(of) && block.contains("stick")).unwrap();
    let (controls, moves) = (recipe("[[control]]"), recipe("control = ["));
    let start = ELEVONS.find("[[control]]").unwrap();
    let (end, old) = (ELEVONS.find("[[component]]").unwrap(), ELEVONS.find("control = [").unwrap());
    let after_old = old + ELEVONS[old..].find("\n]").unwrap() + 2;
    let text = [&ELEVONS[..start], controls, &ELEVONS[end..old], moves, &ELEVONS[after_old..]].concat();

    let with_elevator = flight(&reduced(ELEVONS)).trim().pitch_control;
    let model = reduced(&text);
    let mut flight = flight(&model);
    let trimmed: Vec<f64> = flight.trim().angles(&model.controls).collect();
    assert!((trimmed[0] - with_elevator).abs() < 1e-12 && trimmed[1..] == [0.0; 2], "{trimmed:?}");
    // Both elevons alike fly as the stick, and the half for the whole.
    let alike = Inputs { controls: vec![0.0, 0.01, 0.01], ..Inputs::zero(&model) };
    flight.set_inputs(&alike, &Inputs::zero(&model));
    flight.advance_to(0.5).unwrap();
    assert!(flight.is_symmetric() && flight.outputs().rate.y < 0.0);
    let right = Inputs { controls: vec![0.0, 0.01, 0.0], ..Inputs::zero(&model) };
    flight.set_inputs(&right, &Inputs::zero(&model));
    flight.advance_to(0.7).unwrap();
    assert!(flight.outputs().rate.x < 0.0, "a right trailing edge down lifts the right wing");
}

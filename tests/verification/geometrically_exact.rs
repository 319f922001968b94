//! The jet under geometrically exact kinematics, and what other levels make of the same flight
//! [theory: geometrically-exact.recursion, geometrically-exact.energy].

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, Outputs, Plant, PlantSettings, TrimPoint};
use flexible_aircraft::structure::{ModeCount, ModeKind, ReducedModel};

use crate::support::station;

use super::record::Record;

/// Symmetric modes and stiffness scale; pitch and elevator (rad), thrust of an engine (N), wing tip up and inboard (m) as far as
/// they are given.
const TRIMS: [(usize, f64, [Option<f64>; 5]); 3] = [
    (8, 1.0, [Some(0.138_29), Some(-0.235_04), Some(23_725.0), Some(0.5863), Some(0.0585)]),
    (8, 0.1, [Some(0.169_09), Some(-0.349_16), Some(29_381.0), Some(5.4282), Some(2.0800)]),
    (16, 0.1, [Some(0.166_45), Some(-0.2976), None, Some(5.674), Some(2.294)]),
];

/// Of what is compared: its name and a unit of the last digit of the references, of which the last case has fewer.
const QUANTITIES: [(&str, [f64; 2]); 5] = [
    ("pitch, rad", [1e-5, 1e-5]),
    ("elevator, rad", [1e-5, 1e-4]),
    ("thrust of an engine, N", [1.0, 1.0]),
    ("wing tip up, m", [1e-4, 1e-3]),
    ("wing tip inboard, m", [1e-4, 1e-3]),
];

/// The horizontal tail's tip up with 8 modes at one-tenth stiffness, m.
const TAIL_TIP: f64 = 0.2956;

#[test]
fn the_jet_is_trimmed_with_wings_that_bend_by_almost_half_of_their_length() {
    let mut record = Record::new(
        "trim-geometrically-exact",
        "The same flight of the jet, geometrically exact: symmetric modes × stiffness",
        "an independent computation; a unit of its last digit",
    );
    for (count, stiffness_scale, expected) in TRIMS {
        let (trim, outputs) = trimmed(count, stiffness_scale);
        let tip = outputs.deflections[station("wing_tip_right")].displacement;
        let found = [trim.pitch, trim.pitch_control, trim.thrust, -tip.z, -tip.y];
        for (((name, digits), expected), found) in QUANTITIES.iter().zip(expected).zip(found) {
            if let Some(expected) = expected {
                let case = format!("{count} × {stiffness_scale}: {name}");
                record.absolute(&case, expected, digits[usize::from(count > 8)], found);
            }
        }
        if (count, stiffness_scale) == (8, 0.1) {
            let tail = -outputs.deflections[station("htail_tip_right")].displacement.z;
            record.absolute("8 × 0.1: tip of the horizontal tail up, m", TAIL_TIP, 1e-4, tail);
        }
    }
    record.finish();
}

/// The shipped jet with so many symmetric modes.
fn jet(count: usize) -> Arc<ReducedModel> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::read(path).unwrap();
    Arc::new(ReducedModel::with(&aircraft, ModeCount::Asked(count), ModeKind::Symmetric).unwrap())
}

/// Its trim at 127 m/s, 7620 m.
fn trimmed(count: usize, stiffness_scale: f64) -> (TrimPoint, Outputs) {
    let model = jet(count);
    let settings = PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        mode_selection: ModeSelection::Symmetric,
        mode_count: count,
        stiffness_scale,
        ..PlantSettings::of(&model)
    };
    let mut flight = Simulation::new(model, &Settings::from(settings), 0.0).unwrap();
    (*flight.trim(), flight.outputs().clone())
}

/// Symmetric modes.
const COUNTS: [usize; 5] = [8, 12, 16, 24, 40];

/// The wing tip up at one-tenth stiffness with so many, and at the geometrically exact level inboard, m.
const E_UP: [f64; 5] = [2.831, 2.899, 2.876, 2.887, 2.885];
const I_UP: [f64; 5] = [4.986, 5.197, 5.171, 5.204, 5.211];
const GE_UP: [f64; 5] = [5.428, 5.701, 5.674, 5.721, 5.734];
const GE_INBOARD: [f64; 5] = [2.080, 2.318, 2.294, 2.338, 2.351];

/// The wing tip of one of the jet's trims at one-tenth stiffness: up and inboard, m.
fn wing_tip(model: &ReducedModel, fidelity: Fidelity, mode_count: usize) -> [f64; 2] {
    let settings = PlantSettings {
        fidelity,
        mode_selection: ModeSelection::Symmetric,
        mode_count,
        stiffness_scale: 0.1,
        inflow_states: 0,
        ..PlantSettings::of(model)
    };
    let plant = Plant::under(model, &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
    let tip = outputs.deflections[station("wing_tip_right")].displacement;
    [-tip.z, -tip.y]
}

#[test]
fn with_more_modes_every_level_keeps_its_own_wing_tip_and_the_geometrically_exact_one_alone_comes_in_by_metres()
 {
    let mut record = Record::new(
        "trim-levels",
        "The same flight at one-tenth stiffness over the number of symmetric modes: wing tip, m",
        "an independent computation of each level; a unit of its last digit",
    );
    let model = jet(COUNTS[COUNTS.len() - 1]);
    let at = |level| COUNTS.map(|count| wing_tip(&model, level, count));
    let [e, i, cl, ge] = [
        Fidelity::Exact,
        Fidelity::Inconsistent,
        Fidelity::ConsistentlyLinearised,
        Fidelity::GeometricallyExact,
    ]
    .map(at);
    let mut remark = String::from(
        "Inboard, m: where beams keep their length alone the tip comes in by metres. Cubic energy without its quartic (CL) does not \
         converge.\n\n| modes | E | I | CL | GE | CL up |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    for (place, count) in COUNTS.into_iter().enumerate() {
        let [e, i, cl, ge] = [e[place], i[place], cl[place], ge[place]];
        record.absolute(&format!("E, {count} modes: up"), E_UP[place], 1e-3, e[0]);
        record.absolute(&format!("I, {count} modes: up"), I_UP[place], 1e-3, i[0]);
        record.absolute(&format!("GE, {count} modes: up"), GE_UP[place], 1e-3, ge[0]);
        record.absolute(&format!("GE, {count} modes: inboard"), GE_INBOARD[place], 1e-3, ge[1]);
        let cells = [e[1], i[1], cl[1], ge[1], cl[0]].map(|metres| format!("{metres:.3}"));
        remark += &format!("| {count} | {} |\n", cells.join(" | "));
    }
    record.remark(remark.trim_end());
    record.finish();
}

//! The jet under geometrically exact kinematics [theory: geometrically-exact.recursion, geometrically-exact.energy].

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, Outputs, PlantSettings, TrimPoint};
use flexible_aircraft::structure::{ModeCount, ModeKind, ReducedModel};

use crate::support::station;

use super::record::Record;

/// Symmetric modes and stiffness scale; pitch and elevator (rad), thrust of an engine (N), wing tip up and inboard (m).
const TRIMS: [(usize, f64, [f64; 5]); 3] = [
    (8, 1.0, [0.138_29, -0.235_04, 23_725.0, 0.5863, 0.0585]),
    (8, 0.1, [0.169_09, -0.349_16, 29_381.0, 5.4282, 2.0800]),
    (16, 0.1, [0.166_45, -0.2976, f64::NAN, 5.674, 2.294]),
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
            if !expected.is_nan() {
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

/// The jet at 127 m/s, 7620 m.
fn trimmed(count: usize, stiffness_scale: f64) -> (TrimPoint, Outputs) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/aircraft/generic-business-jet.toml");
    let aircraft = Aircraft::read(path).unwrap();
    let model = ReducedModel::with(&aircraft, ModeCount::Asked(count), ModeKind::Symmetric).unwrap();
    let model = Arc::new(model);
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

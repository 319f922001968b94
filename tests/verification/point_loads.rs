//! A dead force is to a trimmed aircraft what the weight of a body is that hangs there.
//!
//! [theory: gravity-and-thrust.point-loads, gravity-and-thrust.gravity, trim.balance]

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{Plant, PlantSettings, PointLoad};
use flexible_aircraft::structure::ReducedModel;
use nalgebra::Vector3;

use crate::support::{eight_symmetric, jet, station};

use super::record::Record;

/// On each wing tip, kg.
const HUNG: f64 = 200.0;

const TIPS: [&str; 2] = ["wing_tip_right", "wing_tip_left"];

/// The jet with bodies at its wing tips, in the modes that it has without.
fn hung_with_bodies() -> ReducedModel {
    let mut model = (*jet()).clone();
    for tip in TIPS {
        let section = model.stations[station(tip)].carrier.section;
        let body = &mut model.sections[section].body;
        // What does not turn needs no inertia.
        body.offset *= body.mass / (body.mass + HUNG);
        body.mass += HUNG;
    }
    model
}

/// Pitch, elevator (rad), thrust (N), wing tip up and inboard (m) of a trimmed plant.
fn trim(plant: &Plant, settings: &PlantSettings) -> [f64; 5] {
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
    let tip = outputs.deflections[station(TIPS[0])].displacement;
    [trim.point.pitch, trim.point.pitch_control, trim.point.thrust, -tip.z, -tip.y]
}

#[test]
fn a_dead_force_trims_the_jet_as_the_weight_of_a_body_does() {
    let settings = PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        stiffness_scale: 0.1,
        inflow_states: 0,
        ..eight_symmetric().plant
    };
    let plant = Plant::under(&jet(), &settings).unwrap();
    let weight = Vector3::z() * (HUNG * jet().gravity);
    let load = |tip: &str| PointLoad { station: tip.to_owned(), force: weight, moment: Vector3::zeros() };
    let loaded = trim(&plant.clone().under_loads(&TIPS.map(load)).unwrap(), &settings);
    let heavy = trim(&Plant::under(&hung_with_bodies(), &settings).unwrap(), &settings);
    let mut record = Record::new(
        "dead-force",
        "Jet at one-tenth stiffness, GE, 8 symmetric modes, 127 m/s, 200 kg on each wing tip: dead forces against bodies of that weight",
        "the same aircraft with bodies in its tip sections; tolerance: rounding",
    );
    let lowered = trim(&plant, &settings)[3] - heavy[3];
    record.at_least("weight lowers the wing tips, m", 0.1, lowered);
    let quantities = ["pitch", "elevator", "thrust", "wing tip up", "wing tip inboard"];
    for ((quantity, loaded), heavy) in quantities.into_iter().zip(loaded).zip(heavy) {
        record.rounding(quantity, 1e-14, loaded / heavy - 1.0);
    }
    record.finish();
}

//! The jet under geometrically exact kinematics [theory: geometrically-exact.recursion, geometrically-exact.energy].

use std::sync::Arc;

use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::structure::{ModeCount, ModeKind, ReducedModel};

use crate::support::station;

/// Symmetric modes and stiffness scale; pitch and elevator (rad), thrust of an engine (N), wing tip up and
/// inboard (m): of an independent computation.
const TRIMS: [(usize, f64, [f64; 5]); 2] = [
    (8, 1.0, [0.138_29, -0.235_04, 23_725.0, 0.5863, 0.0585]),
    (8, 0.1, [0.169_09, -0.349_16, 29_381.0, 5.4282, 2.0800]),
];

#[test]
fn the_jet_is_trimmed_with_wings_that_bend_by_almost_half_of_their_length() {
    let aircraft = flexible_aircraft::Aircraft::read(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/aircraft/generic-business-jet.toml"
    ));
    let aircraft = aircraft.unwrap();
    for (count, stiffness_scale, expected) in TRIMS {
        let model = ReducedModel::with(&aircraft, ModeCount::Asked(count), ModeKind::Symmetric).unwrap();
        let model = Arc::new(model);
        let settings = PlantSettings {
            fidelity: Fidelity::GeometricallyExact,
            mode_selection: ModeSelection::Symmetric,
            mode_count: count,
            stiffness_scale,
            ..PlantSettings::of(&model)
        };
        let mut flight = Simulation::new(Arc::clone(&model), &Settings::from(settings), 0.0).unwrap();
        let trim = *flight.trim();
        let tip = flight.outputs().deflections[station("wing_tip_right")].displacement;
        let found = [trim.pitch, trim.pitch_control, trim.thrust, -tip.z, -tip.y];
        for ((found, expected), bound) in found.iter().zip(expected).zip([1e-5, 1e-5, 0.5, 1e-4, 1e-4]) {
            assert!((found - expected).abs() < bound, "{found} {expected}");
        }
    }
}

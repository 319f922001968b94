//! An aircraft without engine glides: in steady flight it pays for its drag with height.

use std::sync::Arc;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;

/// The motor glider of the page about aircraft files, with its engine or without.
fn glider(engine: bool) -> Arc<ReducedModel> {
    let page = include_str!("../../aircraft/README.md");
    let text = page.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let text = if engine { text } else { without_engine(text) };
    Arc::new(ReducedModel::new(&Aircraft::parse(text, "glider.toml").unwrap(), 12).unwrap())
}

/// Everything before the engine: only a station follows.
fn without_engine(text: &str) -> &str {
    text.split("[[engine]]").next().unwrap()
}

#[test]
fn an_aircraft_without_engine_glides_at_the_angle_that_its_drag_asks_for() {
    let glider = glider(false);
    for fidelity in Fidelity::ALL {
        let settings = Settings::from(PlantSettings { fidelity, ..PlantSettings::of(&glider) });
        let mut flight = Simulation::new(Arc::clone(&glider), &settings, 0.0).unwrap();
        let trim = *flight.trim();
        assert!(trim.climb_angle < -0.01 && trim.climb_angle > -0.2, "{trim:?}");
        // Without acceleration the air's force is the opposite of the weight: the load factor along the path is sin γ.
        let outputs = flight.outputs().clone();
        assert!(outputs.acceleration.amax() < 1e-7);
        let along = outputs.velocity.normalize();
        let felt = outputs.load_factor.x * along.x - outputs.load_factor.z * along.z;
        assert!((felt - trim.climb_angle.sin()).abs() < 1e-9, "{fidelity:?}: {felt} {trim:?}");
        assert!((outputs.air.angle_of_attack - (trim.pitch - trim.climb_angle)).abs() < 1e-12);
        assert!(outputs.air.sideslip == 0.0 && flight.is_symmetric());

        // Two seconds later it is V sin γ t lower; the denser air bends its path by little.
        flight.advance_to(2.0).unwrap();
        let sunk = flight.outputs().position.z - outputs.position.z;
        let expected = -2.0 * outputs.air.speed * trim.climb_angle.sin();
        assert!((sunk / expected - 1.0).abs() < 2e-3, "{fidelity:?}: {sunk} {expected}");
    }
}

#[test]
fn the_glide_has_the_drag_that_an_engine_balances_in_level_flight() {
    // At small angles D = T cos α and D = −W sin γ at the same lift but for 1 − cos γ.
    let (glides, flies) = (glider(false), glider(true));
    let trim = |model: &Arc<ReducedModel>| {
        *Simulation::new(Arc::clone(model), &Settings::of(model), 0.0).unwrap().trim()
    };
    let weight = glides.integrals.mass * glides.gravity;
    let (glide, level) = (trim(&glides), trim(&flies));
    assert_eq!(level.climb_angle, 0.0);
    assert!((-weight * glide.climb_angle.sin() / level.thrust - 1.0).abs() < 0.03, "{glide:?} {level:?}");
}

#[test]
fn a_glider_has_a_climb_angle_and_no_thrust() {
    let names = |model: &ReducedModel| {
        let table = VariableTable::new(model);
        ["trim.climb_angle", "trim.thrust"].map(|name| table.reference(name).is_some())
    };
    assert_eq!(names(&glider(false)), [true, false]);
    assert_eq!(names(&glider(true)), [false, true]);
}

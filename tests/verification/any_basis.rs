//! Load modes of every kind of aircraft: with mirror plane and without, free and clamped, without strips, without controls,
//! of any number of natural modes.

use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::Aircraft;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation};
use flexible_aircraft::plant::{ModeSelection, PlantSettings};
use flexible_aircraft::structure::{ModeFamily, ReducedModel};
use flexible_aircraft::symmetry::Plants;

/// Where displacements of the modes superpose, and where their strains do.
const LEVELS: [Fidelity; 2] = [Fidelity::Exact, Fidelity::GeometricallyExact];

/// Natural modes.
const PACKAGED: usize = 6;

/// With load modes.
fn aircraft(file: &str) -> Aircraft {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    Aircraft { load_modes: true, ..Aircraft::read(&path).unwrap() }
}

fn model(aircraft: &Aircraft) -> Arc<ReducedModel> {
    Arc::new(ReducedModel::new(aircraft, PACKAGED).unwrap())
}

/// Load modes that are symmetric, antisymmetric, and of a structure without mirror plane.
fn load_modes(model: &ReducedModel) -> [usize; 3] {
    [ModeFamily::Symmetric, ModeFamily::Antisymmetric, ModeFamily::Unsymmetric]
        .map(|family| model.modes.iter().filter(|mode| mode.of_loads && mode.family == family).count())
}

/// Attitude and speed after 50 ms.
fn fly(model: &Arc<ReducedModel>, settings: PlantSettings) -> [u64; 2] {
    let mut flight = Simulation::new(Arc::clone(model), &Settings::from(settings), 0.0).unwrap();
    flight.step(0.0, 0.05).unwrap();
    let outputs = flight.outputs();
    assert!(outputs.modal_q.iter().all(|q| q.is_finite()));
    [outputs.attitude.y, outputs.air.speed].map(f64::to_bits)
}

#[test]
fn each_kind_of_aircraft_has_its_load_modes_and_flies_with_any_number_of_natural_modes_in_use() {
    let cases = [
        ("aircraft/goland-wing.toml", 60.0, [0, 0, 3]),
        ("aircraft/patil-wing.toml", 25.0, [0, 0, 3]),
        ("tests/data/small-aircraft.toml", 127.0, [4, 4, 0]),
        ("tests/data/v-tail.toml", 127.0, [4, 4, 0]),
    ];
    for (file, airspeed, expected) in cases {
        let model = model(&aircraft(file));
        assert_eq!(load_modes(&model), expected, "{file}");
        assert_eq!(ReducedModel::from_bytes(&model.to_bytes()).as_ref(), Ok(&*model));
        for (fidelity, mode_count) in
            LEVELS.into_iter().flat_map(|level| [0, 1, PACKAGED].map(|n| (level, n)))
        {
            fly(&model, PlantSettings { fidelity, mode_count, airspeed, ..PlantSettings::of(&model) });
        }
    }
}

#[test]
fn without_strips_weight_alone_loads_and_without_controls_no_flap_does() {
    let small = aircraft("tests/data/small-aircraft.toml");
    let without_strips = |aircraft: &Aircraft| model(&Aircraft { strips: Vec::new(), ..aircraft.clone() });
    assert_eq!(load_modes(&without_strips(&small)), [1, 0, 0]);
    let mut fixed = Aircraft { controls: Vec::new(), ..small };
    fixed.strips.iter_mut().for_each(|strip| strip.flap = None);
    assert_eq!(load_modes(&model(&fixed)), [3, 2, 0]);
    let wing = without_strips(&aircraft("aircraft/goland-wing.toml"));
    assert_eq!(load_modes(&wing), [0, 0, 1]);
    for fidelity in LEVELS {
        fly(&wing, PlantSettings { fidelity, mode_count: 2, ..PlantSettings::of(&wing) });
    }
}

#[test]
fn half_the_aircraft_has_the_symmetric_load_modes_and_flies_with_them() {
    let model = model(&aircraft("tests/data/small-aircraft.toml"));
    let is_symmetric = |mode: usize| model.modes[mode].family == ModeFamily::Symmetric;
    for mode_count in [0, 2] {
        let all = PlantSettings { mode_count, ..PlantSettings::of(&model) };
        let symmetric = PlantSettings { mode_selection: ModeSelection::Symmetric, ..all };
        let lowest = (0..mode_count).filter(|&mode| is_symmetric(mode)).count();
        for (settings, whole, half) in
            [(all, mode_count + 8, lowest + 4), (symmetric, mode_count + 4, mode_count + 4)]
        {
            let plants = Plants::under(&model, &settings).unwrap();
            let modes = [plants.whole(), plants.half().unwrap()].map(|plant| plant.layout().modes());
            assert_eq!(modes, [whole, half], "{mode_count}");
            for fidelity in LEVELS {
                fly(&model, PlantSettings { fidelity, ..settings });
            }
        }
    }
}

#[test]
fn rigid_flight_has_none_and_keeps_its_bits() {
    let small = aircraft("tests/data/small-aircraft.toml");
    let models = [true, false].map(|load_modes| model(&Aircraft { load_modes, ..small.clone() }));
    let [with, without] = models
        .map(|model| fly(&model, PlantSettings { fidelity: Fidelity::Rigid, ..PlantSettings::of(&model) }));
    assert_eq!(with, without);
}

//! What the targets share.

pub mod functions;

use std::path::Path;
use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity};
use flexible_aircraft::flight::{Inputs, Settings, Simulation};
use flexible_aircraft::fmi::{Interface, description, starts};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;
use twox_hash::XxHash3_128;

/// The smallest of the shipped aircraft: one strip on one beam.
pub const WING: &str = include_str!("../../aircraft/typical-section.toml");

/// Reduced to two modes.
pub fn wing() -> ReducedModel {
    ReducedModel::new(&Aircraft::parse(WING, "typical-section.toml").unwrap(), 2).unwrap()
}

/// Writes a file that a target begins with into its corpus.
pub fn seed(target: &str, name: &str, bytes: &[u8]) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(target);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(name), bytes).unwrap();
}

/// Everything that an FMU does with a model that has been accepted, at its own level of fidelity and geometrically exactly.
pub fn fly(model: ReducedModel) {
    for interface in Interface::ALL {
        let starts = starts::usual(interface, &model);
        let token = description::token(interface, &model, &starts);
        assert!(description::write(interface, &model, &starts).contains(&token));
    }
    let model = Arc::new(model);
    let own = PlantSettings { mode_count: model.natural_modes(), ..PlantSettings::of(&model) };
    let zero = Inputs::zero(&model);
    let mut inputs = zero.clone();
    inputs.controls.fill(0.01);
    for fidelity in [own.fidelity, Fidelity::GeometricallyExact] {
        let settings = Settings::from(PlantSettings { fidelity, ..own });
        if let Ok(mut flight) = Simulation::new(Arc::clone(&model), &settings, 0.0) {
            flight.set_inputs(&inputs, &zero);
            let _ = flight.advance_to(0.012);
            let _ = flight.outputs();
        }
    }
}

/// The checksum of models and states.
pub fn hash(bytes: &[u8]) -> u128 {
    XxHash3_128::oneshot(bytes)
}

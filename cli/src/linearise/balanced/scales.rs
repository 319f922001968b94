//! How much of each input and output counts alike where a model is reduced [theory: linearisation.balanced].

use std::collections::BTreeMap;

use flexible_aircraft::air::STANDARD_GRAVITY;
use flexible_aircraft::{LinearModel, LinearName};

/// What section loads are called.
const LOADS: &str = "loads.";

/// Part of the largest section load at the trim.
const OF_LOAD: f64 = 0.1;

/// Where nothing loads the aircraft at the trim, N or N m.
const LEAST_LOAD: f64 = 1.0;

/// For people.
pub const TEXT: &str = "0.1 rad, 10 kN and 10 m/s of inputs; 10 m/s, 0.1 rad, 0.2 rad/s, 1 g and 1 m of outputs, \
                        of section loads a tenth of the largest of their kind";

/// Of the inputs of a model: 0.1 rad, 10 kN, 10 m/s.
pub fn of_inputs(model: &LinearModel) -> Vec<f64> {
    model.inputs.iter().map(of_unit).collect()
}

/// Of its outputs: 10 m/s, 0.1 rad, 0.2 rad/s, 1 g, 1 m, a tenth of the largest section load of the same kind; of all else one
/// of its unit.
pub fn of_outputs(model: &LinearModel) -> Vec<f64> {
    let kind = |name: &LinearName| {
        let cut = name.name.strip_prefix(LOADS)?;
        cut.rsplit('.').next().map(str::to_owned)
    };
    let mut largest: BTreeMap<String, f64> = BTreeMap::new();
    for (name, value) in model.outputs.iter().zip(&model.y0) {
        if let Some(kind) = kind(name) {
            let found = largest.entry(kind).or_default();
            *found = found.max(value.abs());
        }
    }
    let scale = |name: &LinearName| match kind(name).and_then(|kind| largest.get(&kind)) {
        Some(&largest) => (OF_LOAD * largest).max(LEAST_LOAD),
        None => of_unit(name),
    };
    model.outputs.iter().map(scale).collect()
}

fn of_unit(name: &LinearName) -> f64 {
    match name.unit {
        "rad" => 0.1,
        "rad/s" => 0.2,
        "m/s" => 10.0,
        "m/s2" => STANDARD_GRAVITY,
        "N" => 1e4,
        _ => 1.0,
    }
}

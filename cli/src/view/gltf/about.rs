//! What is said of a whole file, in the extras of its root: which outputs of the FMU move it, and how.

use std::f64::consts::TAU;

use serde_json::{Map, Value, json};

use super::super::View;
use super::joints::digits;
use crate::describe::modes::family_name;

/// The node that is O and the body axes.
pub const ROOT: &str = "aircraft";

const AXES: &str = "x left, y up, z forward, m; a vector (x, y, z) in body axes, or (north, east, down), is (-y, -z, x) here";
const LINEAR: &str = "linear: displacement = sum of modes.displacement * modal.q[i], rotation vector = sum of modes.rotation * modal.q[i], \
     from the jig shape, in the axes of the root; all levels of fidelity but geometrically_exact";

/// Of a skeleton.
pub fn skeleton(view: &View, is_linear: bool) -> Value {
    let mut about = common(view);
    if is_linear {
        about.insert("modes".to_owned(), modes(view));
        about.insert("drivenByModes".to_owned(), json!(LINEAR));
    }
    about.into()
}

/// What files of both kinds say.
pub fn common(view: &View) -> Map<String, Value> {
    let mut about = Map::new();
    about.insert("aircraft".to_owned(), json!(view.airframe.aircraft.name));
    about.insert("level".to_owned(), json!(view.settings.plant.fidelity.name()));
    about.insert("axes".to_owned(), json!(AXES));
    about
}

/// The modes in the order of their coordinates.
fn modes(view: &View) -> Value {
    let mode = |(place, mode): (usize, &flexible_aircraft::structure::Mode)| {
        json!({
            "output": output(place),
            "frequency": digits(mode.angular_frequency / TAU),
            "family": family_name(mode.family),
            "ofLoads": mode.of_loads,
        })
    };
    view.model.modes.iter().enumerate().map(mode).collect()
}

/// The FMU's output with the coordinate of a mode.
pub fn output(mode: usize) -> String {
    format!("modal.q[{}]", mode + 1)
}

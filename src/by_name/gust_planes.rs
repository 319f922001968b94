//! Planes across the track at which a frozen gust is given to a linear model [theory: linearisation.gust-planes].

use std::sync::Arc;

use crate::air::{GustWave, ImposedGust};
use crate::plant::SettingError;
use crate::variables::Unit;

use super::at_trim::AtTrim;
use super::linear_model::LinearModel;
use super::linear_names::Name;

/// The senses of a plane's inputs: their names, and where they blow along the track, to the right, down.
const SENSES: [(&str, [f64; 3]); 2] = [("up", [0.0, 0.0, -1.0]), ("right", [0.0, 1.0, 0.0])];

/// Puts inputs for so many planes behind those of a model, which is of an aircraft at a trim.
///
/// # Errors
/// When there is a single plane.
pub(super) fn append(linear: &mut LinearModel, at_trim: &AtTrim, count: usize) -> Result<(), SettingError> {
    let [first, last] = at_trim.way.ends;
    let places: Arc<[f64]> = match count {
        0 => return Ok(()),
        1 => {
            let [setting, found] = ["gust_planes", "1"].map(str::to_owned);
            let allowed = "0, or 2 and more: between planes a gust is linear".to_owned();
            return Err(SettingError { setting, found, allowed });
        }
        _ => (0..count).map(|plane| first + (last - first) * plane as f64 / (count - 1) as f64).collect(),
    };
    let inputs: Vec<(usize, usize)> =
        (0..count).flat_map(|plane| (0..SENSES.len()).map(move |sense| (plane, sense))).collect();
    let gust = |&(plane, sense): &(usize, usize)| ImposedGust {
        wave: GustWave::Plane { places: Arc::clone(&places), plane },
        strength: SENSES[sense].1,
    };
    let columns = at_trim.linear_gusts(&inputs.iter().map(gust).collect::<Vec<_>>());
    let LinearModel { b, d, bd, dd, u0, .. } = linear;
    let before = u0.len();
    for matrix in [&mut *b, &mut *d, bd, dd] {
        matrix.resize_horizontally_mut(before + inputs.len(), 0.0);
    }
    // Actuators and engines that lag come behind the states of the plant, and no gust acts on them.
    b.view_mut((0, before), columns.b.shape()).copy_from(&columns.b);
    d.view_mut((0, before), columns.d.shape()).copy_from(&columns.d);
    u0.resize(before + inputs.len(), 0.0);
    linear.inputs.extend(inputs.iter().map(|&(plane, sense)| Name {
        name: format!("gust_plane[{}].{}", plane + 1, SENSES[sense].0),
        unit: Unit::MetrePerSecond.name(),
    }));
    linear.gust_planes = places.to_vec();
    Ok(())
}

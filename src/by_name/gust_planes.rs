//! Planes across the track at which a frozen gust is given to a linear model [theory: linearisation.gust-planes].

use std::sync::Arc;

use crate::air::{GustWave, ImposedGust};
use crate::flight::{Settings, SimulationError};
use crate::plant::SettingError;
use crate::structure::ReducedModel;
use crate::variables::Unit;

use super::linear_model::{Inflow, LinearModel};
use super::linear_names::Name;
use super::linearising::AtTrim;

/// The senses of a plane's inputs: their names, and where they blow along the track, to the right, down.
const SENSES: [(&str, [f64; 3]); 2] = [("up", [0.0, 0.0, -1.0]), ("right", [0.0, 1.0, 0.0])];

impl LinearModel {
    /// [`new`](Self::new) with further inputs `gust_plane[i].up` and `.right`, i from 1 on: the velocity of a frozen gust, m/s, at
    /// planes across the track, as many as that and equally far apart from the foremost leading edge of any strip to the last
    /// trailing edge, linear between them. When it comes to which plane is for who gives the inputs:
    /// [`gust_planes`](Self::gust_planes) has where they are [theory: linearisation.gust-planes]. Allocates.
    ///
    /// ```
    /// use flexible_aircraft::{Aircraft, Inflow, LinearModel, flight::Settings};
    ///
    /// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
    /// let mut settings = Settings::of(&jet);
    /// settings.plant.mode_count = 2;
    /// let model = LinearModel::with_gust_planes(jet, &settings, Inflow::Steady, 3)?;
    /// assert_eq!(model.inputs[model.inputs.len() - 2].name, "gust_plane[3].up");
    /// // From the nose, 10.4 m before O, the last plane is met after this time, s.
    /// let delay = (model.gust_planes[0] - model.gust_planes[2]) / settings.plant.airspeed;
    /// assert!((0.1..0.3).contains(&delay));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As of [`new`](Self::new), and when there is a single plane.
    pub fn with_gust_planes(
        model: impl Into<Arc<ReducedModel>>,
        settings: &Settings,
        inflow: Inflow,
        planes: usize,
    ) -> Result<Self, SimulationError> {
        let at_trim = AtTrim::new(model.into(), settings, inflow)?;
        let mut linear = at_trim.linear_model();
        append(&mut linear, &at_trim, planes)?;
        Ok(linear)
    }
}

/// Puts inputs for so many planes behind those of a model, which is of an aircraft at a trim.
///
/// # Errors
/// When there is a single plane.
fn append(linear: &mut LinearModel, at_trim: &AtTrim, count: usize) -> Result<(), SettingError> {
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

//! The trim with which a flight would begin, and the static stability there, or why there is none
//! [theory: linearisation.static-margin].

use flexible_aircraft::aircraft::{ReferenceLengths, Support};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{LimitExceeded, StaticStability};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;
use nalgebra::Vector3;

use super::senses;
use crate::flown;

/// An aircraft in a flight condition.
pub struct Balance {
    /// Manoeuvre, airspeed, altitude, level and modes, for people.
    pub condition: String,
    /// Or why there is none.
    pub stability: Result<StaticStability, String>,
    /// By the reference lengths, where there are any.
    pub margin: Option<Margin>,
    /// What is odd about the trim, for people: that there is none, or what of it is beyond the limits of the aircraft.
    pub odd: Option<String>,
    /// What each control does at once, rad/s² by rad about body axes, where that can be found.
    pub senses: Option<Vec<Vector3<f64>>>,
}

/// Static stability without dimensions.
pub struct Margin {
    /// In reference chords.
    pub margin: f64,
    /// C_Lα, 1/rad.
    pub lift_slope: f64,
}

impl Balance {
    pub fn new(model: &ReducedModel, settings: &Settings, lengths: Option<ReferenceLengths>) -> Self {
        let manoeuvre = match model.support {
            Support::Free => settings.plant.condition.manoeuvre().name(!model.engines.is_empty()),
            Support::Clamped => "rest in the tunnel",
        };
        let condition = format!("{manoeuvre}, {}", flown::condition(model, settings));
        let none = |reason: String| (Err(reason.clone()), Some(reason));
        let (stability, odd) = stability(model, settings).unwrap_or_else(none);
        let margin = stability.as_ref().ok().zip(lengths).map(|(stability, lengths)| Margin {
            margin: stability.margin(lengths.chord),
            lift_slope: stability.lift_slope_coefficient(lengths.area),
        });
        let senses = (model.support == Support::Free).then(|| senses::of(model, &settings.plant)).flatten();
        Balance { condition, stability, margin, odd, senses }
    }
}

/// Static stability in the trim or why there is none, with a warning of what of the trim is beyond its limits.
///
/// # Errors
/// When there is no trim.
fn stability(
    model: &ReducedModel,
    settings: &Settings,
) -> Result<(Result<StaticStability, String>, Option<String>), String> {
    let plants = Plants::under(model, &settings.plant).map_err(|error| error.to_string())?;
    let found = plants.trim(&settings.plant.trim_condition());
    let trimmed = found.map_err(|error| format!("there is no trim: {error}"))?;
    let plant = plants.half().filter(|_| trimmed.form.is_symmetric()).unwrap_or(plants.whole());
    let exceeded = LimitExceeded::find(&model.limits, plant, trimmed.trim());
    let stability = plant.static_stability(trimmed.trim()).map_err(|error| error.to_string());
    Ok((stability, LimitExceeded::warning(&exceeded, model, &settings.plant)))
}

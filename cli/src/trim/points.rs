//! The points of a table of trims.

use flexible_aircraft::aircraft::ReferenceLengths;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{
    LimitExceeded, LimitedTrimError, PlantSettings, SettingError, TrimLimits, TrimPoint,
};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::symmetry::Plants;
use rayon::prelude::*;

use crate::progress::Audience;

/// How a point came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Found,
    /// The trim needs more than controls and engines can give.
    BeyondLimits,
    /// There is no trim.
    NoTrim,
}

impl Status {
    /// As it stands in tables.
    pub fn name(self) -> &'static str {
        match self {
            Status::Found => "ok",
            Status::BeyondLimits => "beyond_limits",
            Status::NoTrim => "no_trim",
        }
    }
}

/// A point of the table.
pub struct Point {
    pub settings: PlantSettings,
    pub status: Status,
    /// Where it was trimmed.
    pub trim: Option<TrimPoint>,
    /// In reference chords, of a straight flight that is its own mirror image.
    pub static_margin: Option<f64>,
    /// N of all engines together.
    pub total_thrust: f64,
    /// Why it was not trimmed; empty where it was.
    pub message: String,
    /// What it is beyond and stands all the same.
    pub warnings: Vec<String>,
}

/// An aircraft that is trimmed, and how.
pub struct Trimmed<'a> {
    pub model: &'a ReducedModel,
    pub reference: Option<ReferenceLengths>,
    /// Whether limits of the aircraft file do not count.
    pub ignore_limits: bool,
}

/// Trims an aircraft under all of some settings, on all cores.
///
/// # Errors
/// When a setting is out of range.
pub fn trim(aircraft: &Trimmed, all: &[Settings], audience: &Audience) -> Result<Vec<Point>, SettingError> {
    let progress = audience.progress(all.len(), "trims");
    let trim = |settings: &Settings| {
        let point = point(aircraft, settings);
        progress.advance();
        point
    };
    all.par_iter().map(trim).collect()
}

fn point(aircraft: &Trimmed, settings: &Settings) -> Result<Point, SettingError> {
    let &Trimmed { model, reference, ignore_limits } = aircraft;
    let plants = Plants::under(model, &settings.plant)?;
    let limits = limits(model, settings, ignore_limits);
    let (plant, found) = plants.trim_within(&settings.plant.trim_condition(), &limits);
    Ok(match found {
        Ok(trim) => {
            let exceeded = LimitExceeded::find(&model.limits, plant, &trim);
            let is_symmetric = plants.half().is_some() && settings.plant.condition.manoeuvre().is_symmetric();
            let stability = if is_symmetric { plant.static_stability(&trim).ok() } else { None };
            Point {
                settings: settings.plant,
                status: Status::Found,
                trim: Some(trim.point),
                static_margin: stability.zip(reference).map(|(found, lengths)| found.margin(lengths.chord)),
                total_thrust: trim.controls.thrust.iter().sum(),
                message: String::new(),
                warnings: exceeded.iter().map(ToString::to_string).collect(),
            }
        }
        Err(error) => Point {
            settings: settings.plant,
            status: match error {
                LimitedTrimError::NotFound(_) => Status::NoTrim,
                LimitedTrimError::Beyond(_) => Status::BeyondLimits,
            },
            trim: None,
            static_margin: None,
            total_thrust: 0.0,
            message: error.to_string(),
            warnings: Vec::new(),
        },
    })
}

/// Those of actuators and engines and, unless they are to be ignored, of the aircraft file.
fn limits(model: &ReducedModel, settings: &Settings, ignore_limits: bool) -> TrimLimits {
    let within = |[least, most]: [f64; 2], bounds: [Option<f64>; 2]| {
        let [given_least, given_most] = if ignore_limits { [None, None] } else { bounds };
        [
            given_least.map_or(least, |bound| bound.max(least)),
            given_most.map_or(most, |bound| bound.min(most)),
        ]
    };
    let controls = model.controls.iter().enumerate();
    let controls = controls
        .map(|(number, control)| within(settings.actuators.get(number).stops(), control.limits.given()));
    let failed = settings.plant.condition.manoeuvre().failed_engine;
    let running = (0..model.engines.len()).filter(|number| failed != Some(*number));
    let engines = running.map(|number| settings.engines.get(number).limits());
    let engines = engines
        .reduce(|[least, most], [other_least, other_most]| [least.max(other_least), most.min(other_most)]);
    TrimLimits {
        controls: controls.collect(),
        thrust: within(engines.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]), model.limits.thrust.given()),
    }
}

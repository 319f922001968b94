//! Continuous turbulence: the rms of each output by that of the turbulence, and limit loads by CS 25.341(b)
//! [theory: gusts.continuous].

use std::sync::Arc;
use std::time::Instant;

use flexible_aircraft::air::{GustSettings, Spectrum, TurbulenceSettings};
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::plant::EigenvaluesNotFound;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{HarmonicGusts, InTurbulence};

use super::Written;
use crate::diagnostics;
use crate::flown::trimmed;
use crate::numbers::{Plain, fixed, short};
use crate::watched::Watched;

mod plot;
mod report;
mod table;

/// Ā that the last halving of the steps of the frequencies moves by more than this part of it is warned of.
const INEXACT: f64 = 1e-3;

/// Why nothing was found of continuous turbulence.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Trim(#[from] SimulationError),
    #[error(transparent)]
    Roots(#[from] EigenvaluesNotFound),
    #[error(
        "--output-names {0}: found an output that no linear model has, for sensors sample; allowed are others"
    )]
    Sampled(String),
}

/// What was found.
struct Found<'w> {
    watched: &'w [Watched],
    /// Of each watched output.
    trim: Vec<f64>,
    turbulence: TurbulenceSettings,
    /// U_σ, m/s of true airspeed.
    velocity: f64,
    directions: Vec<Direction>,
}

/// Turbulence in a direction.
struct Direction {
    /// 0 upwards, 90 to the right.
    degrees: f64,
    outputs: InTurbulence,
}

/// An output of a direction.
struct Row<'f> {
    output: &'f Watched,
    trim: f64,
    /// Ā, per m/s.
    rms: f64,
    /// N0, Hz.
    crossings: f64,
    /// Limits: the trim less and more U_σ Ā.
    limits: [f64; 2],
}

/// Finds what an aircraft, whose gust gives U_σ, does in turbulence of some directions, degrees.
pub fn run(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    directions: &[f64],
    watched: &[Watched],
) -> Result<Written, Error> {
    let turbulence = match settings.turbulence.spectrum {
        Spectrum::None => TurbulenceSettings { spectrum: Spectrum::VonKarman, ..settings.turbulence },
        _ => settings.turbulence,
    };
    // The trim is in still air.
    let calm = Settings {
        gust: GustSettings::default(),
        turbulence: TurbulenceSettings::default(),
        ..settings.clone()
    };
    trimmed(model, &calm, 0.0)?;
    let began = Instant::now();
    let gusts = HarmonicGusts::new(Arc::clone(model), &calm)?;
    let linear = gusts.linear_model();
    let place = |output: &Watched| {
        let place = linear.outputs.iter().position(|other| other.name == output.name);
        place.ok_or_else(|| Error::Sampled(output.name.clone()))
    };
    let places = watched.iter().map(place).collect::<Result<Vec<usize>, Error>>()?;
    let in_direction = |&degrees: &f64| {
        let outputs = gusts.in_turbulence(degrees.to_radians(), &turbulence, &places)?;
        Ok(Direction { degrees, outputs })
    };
    let found = Found {
        watched,
        trim: places.iter().map(|&place| linear.y0[place]).collect(),
        turbulence,
        velocity: settings.gust.turbulence_velocity(settings.plant.altitude),
        directions: directions.iter().map(in_direction).collect::<Result<_, Error>>()?,
    };
    found.warn();
    Ok(Written {
        printed: report::text(model, settings, &found, began.elapsed().as_secs_f64()),
        files: [table::csv(&found), table::json(model, &found), plot::densities(&model.name, &found)],
    })
}

impl Found<'_> {
    /// Of each watched output what a direction does.
    fn rows<'f>(&'f self, direction: &'f Direction) -> impl Iterator<Item = Row<'f>> {
        let outputs = self.watched.iter().zip(&self.trim).zip(&direction.outputs.outputs);
        outputs.map(|((output, &trim), found)| {
            let increment = self.velocity * found.rms;
            let limits = [trim - increment, trim + increment];
            Row { output, trim, rms: found.rms, crossings: found.crossings, limits }
        })
    }

    /// By which part of it any Ā was moved at most when the steps of the frequencies were last halved.
    fn moved(&self) -> f64 {
        self.directions.iter().map(|direction| direction.outputs.moved).fold(0.0, f64::max)
    }

    /// Of what makes the numbers doubtful.
    fn warn(&self) {
        if self.moved() > INEXACT {
            diagnostics::warn(&format!(
                "the last halving of the steps of the frequencies moved a rms by {} of it: a root is hardly damped",
                short(self.moved())
            ));
        }
        let unstable = self.directions.first().and_then(|direction| direction.outputs.unstable.first());
        if let Some(root) = unstable {
            let root = format!("{} ± {}i", fixed(root.re, 5), fixed(root.im, 5));
            diagnostics::warn(&format!(
                "the aircraft is unstable, with a root at {root} 1/s: in turbulence no motion lasts, and A-bar is a number without meaning"
            ));
        }
    }

    /// The spectrum for people.
    fn spectrum(&self) -> String {
        let name = match self.turbulence.spectrum {
            Spectrum::None => "no",
            Spectrum::Dryden => "Dryden's",
            Spectrum::VonKarman => "von Kármán's",
        };
        format!("{name} spectrum, scale {} m", Plain(self.turbulence.length()))
    }
}

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
use crate::answer::Answer;
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
pub struct Found {
    model: Arc<ReducedModel>,
    settings: Settings,
    watched: Vec<Watched>,
    /// Of each watched output.
    trim: Vec<f64>,
    turbulence: TurbulenceSettings,
    /// U_σ, m/s of true airspeed.
    velocity: f64,
    directions: Vec<Direction>,
    /// That it took.
    seconds: f64,
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

impl Found {
    /// Finds what an aircraft, whose gust gives U_σ, does in turbulence of some directions, degrees.
    pub fn new(
        model: Arc<ReducedModel>,
        settings: Settings,
        directions: &[f64],
        watched: Vec<Watched>,
    ) -> Result<Self, Error> {
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
        trimmed(&model, &calm, 0.0)?;
        let began = Instant::now();
        let gusts = HarmonicGusts::new(Arc::clone(&model), &calm)?;
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
        let directions = directions.iter().map(in_direction).collect::<Result<_, Error>>()?;
        let found = Found {
            watched,
            trim: places.iter().map(|&place| linear.y0[place]).collect(),
            turbulence,
            velocity: settings.gust.turbulence_velocity(settings.plant.altitude),
            directions,
            seconds: began.elapsed().as_secs_f64(),
            model,
            settings,
        };
        found.warn();
        Ok(found)
    }

    /// What is printed, and the files.
    pub fn written(&self) -> Written {
        Written {
            printed: report::text(&self.model, &self.settings, self, self.seconds),
            files: [
                table::csv(self),
                table::json(&self.model, self),
                plot::densities(&self.model.name, self),
            ],
        }
    }

    /// A row for each direction, a column for each output.
    pub fn answer(&self) -> Answer {
        let of_outputs = |number: fn(&Row) -> f64| Answer::Matrix {
            rows: self.directions.len(),
            columns: self.watched.len(),
            values: self
                .directions
                .iter()
                .flat_map(|direction| self.rows(direction).map(|row| number(&row)))
                .collect(),
        };
        Answer::named([
            ("names", Answer::Texts(self.watched.iter().map(|output| output.name.clone()).collect())),
            ("units", Answer::Texts(self.watched.iter().map(|output| output.unit.clone()).collect())),
            ("trim", Answer::Numbers(self.trim.clone())),
            (
                "direction",
                Answer::Numbers(self.directions.iter().map(|direction| direction.degrees).collect()),
            ),
            ("rms", of_outputs(|row| row.rms)),
            ("crossings", of_outputs(|row| row.crossings)),
            ("velocity", Answer::Number(self.velocity)),
            ("least", of_outputs(|row| row.limits[0])),
            ("greatest", of_outputs(|row| row.limits[1])),
        ])
    }

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

//! Continuous turbulence: the rms of each output by that of the turbulence, and limit loads by CS 25.341(b)
//! [theory: gusts.continuous].

use std::sync::Arc;
use std::time::Instant;

use flexible_aircraft::air::{GustSettings, Spectrum, TurbulenceSettings};
use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::plant::{EigenvaluesNotFound, LimitExceeded};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{HarmonicGusts, InTurbulence};

use super::Written;
use crate::answer::Answer;
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
    /// Of what makes the numbers doubtful.
    pub warnings: Vec<String>,
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
        let beyond = beyond_limits(&model, &calm)?;
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
        let directions = directions.iter().map(in_direction).collect::<Result<Vec<Direction>, Error>>()?;
        Ok(Found {
            watched,
            trim: places.iter().map(|&place| linear.y0[place]).collect(),
            turbulence,
            velocity: settings.gust.turbulence_velocity(settings.plant.altitude),
            warnings: beyond.into_iter().chain(inexact(&directions)).chain(unstable(&directions)).collect(),
            directions,
            seconds: began.elapsed().as_secs_f64(),
            model,
            settings,
        })
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
            ("warnings", Answer::Texts(self.warnings.clone())),
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

/// A warning where the trim is beyond what the aircraft is flown within.
fn beyond_limits(model: &Arc<ReducedModel>, settings: &Settings) -> Result<Option<String>, SimulationError> {
    let trimmed = Simulation::new(Arc::clone(model), settings, 0.0)?;
    Ok(LimitExceeded::warning(trimmed.limits_exceeded(), model, &settings.plant))
}

/// A warning where the steps of the frequencies are too long.
fn inexact(directions: &[Direction]) -> Option<String> {
    let moved = directions.iter().map(|direction| direction.outputs.moved).fold(0.0, f64::max);
    (moved > INEXACT).then(|| {
        format!(
            "the last halving of the steps of the frequencies moved a rms by {} of it: a root is hardly damped",
            short(moved)
        )
    })
}

/// A warning where the aircraft is unstable, in whichever direction.
fn unstable(directions: &[Direction]) -> Option<String> {
    let root = directions.first()?.outputs.unstable.first()?;
    Some(format!(
        "the aircraft is unstable, with a root at {} ± {}i 1/s: in turbulence no motion lasts, and A-bar is a number without meaning",
        fixed(root.re, 5),
        fixed(root.im, 5)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_that_halving_still_moves_are_warned_of_in_any_direction() {
        let direction = |moved: f64| {
            let outputs =
                InTurbulence { frequencies: Vec::new(), outputs: Vec::new(), moved, unstable: Vec::new() };
            Direction { degrees: 0.0, outputs }
        };
        assert_eq!(inexact(&[direction(2e-4), direction(1e-3)]), None);
        let warning = inexact(&[direction(1e-4), direction(0.02)]).unwrap();
        assert!(warning.contains("moved a rms by 0.02 of it"), "{warning}");
        assert_eq!(unstable(&[direction(0.0)]), None);
    }
}

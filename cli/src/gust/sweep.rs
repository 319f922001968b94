//! The flights, on all cores.

use std::sync::Arc;

use flexible_aircraft::flight::{Instant, Settings, Simulation};
use flexible_aircraft::structure::ReducedModel;
use rayon::prelude::*;

use super::{Error, Watched};
use crate::numbers::Plain;
use crate::progress::Progress;

/// One gust.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// H, m.
    pub gradient: f64,
    /// For people: positive or negative.
    pub sense: &'static str,
    /// rad.
    pub direction: f64,
}

/// Least and greatest of an output, and when, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    pub least: (f64, f64),
    pub greatest: (f64, f64),
}

/// What a gust did.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown {
    pub case: Case,
    /// m/s of true airspeed.
    pub peak: f64,
    /// One for each watched output.
    pub extremes: Vec<Extremes>,
}

/// All gusts.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Of each watched output before any gust.
    pub trim: Vec<f64>,
    pub flights: Vec<Flown>,
}

impl Extremes {
    fn at(value: f64, time: f64) -> Self {
        Extremes { least: (value, time), greatest: (value, time) }
    }

    fn take(&mut self, value: f64, time: f64) {
        if value < self.least.0 {
            self.least = (value, time);
        }
        if value > self.greatest.0 {
            self.greatest = (value, time);
        }
    }
}

impl Sweep {
    /// Flies each case for a time (s), looking at the outputs in steps (s).
    ///
    /// # Errors
    /// When there is no trim, or a flight leaves the model's validity.
    pub fn fly(
        model: &Arc<ReducedModel>,
        settings: &Settings,
        watched: &[Watched],
        cases: &[Case],
        times: [f64; 2],
    ) -> Result<Self, Error> {
        let mut trimmed = Simulation::new(Arc::clone(model), settings, 0.0)?;
        let instant = look(&mut trimmed, watched);
        let trim = watched.iter().map(|output| output.slot.number(instant)).collect();
        let progress = Progress::new(cases.len(), "gusts");
        let flight = |case: &Case| {
            let flown = fly(model, settings, watched, case, times);
            progress.advance();
            flown
        };
        let flights = cases.par_iter().with_max_len(1).map(flight).collect::<Result<_, _>>()?;
        Ok(Sweep { trim, flights })
    }
}

fn fly(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    watched: &[Watched],
    case: &Case,
    [duration, step]: [f64; 2],
) -> Result<Flown, Error> {
    let gust = format!("the {} gust of {} m", case.sense, Plain(case.gradient));
    let failed = |source| Error::Flight { gust: gust.clone(), source };
    let mut settings = settings.clone();
    (settings.gust.gradient, settings.gust.direction) = (case.gradient, case.direction);
    let mut flight = Simulation::new(Arc::clone(model), &settings, 0.0).map_err(failed)?;
    let instant = look(&mut flight, watched);
    let peak = instant.outputs.gust_peak_velocity;
    let mut extremes: Vec<Extremes> =
        watched.iter().map(|output| Extremes::at(output.slot.number(instant), 0.0)).collect();
    let steps = (duration / step).ceil() as usize;
    for place in 1..=steps {
        let time = (place as f64 * step).min(duration);
        flight.advance_to(time).map_err(failed)?;
        let instant = look(&mut flight, watched);
        for (extremes, output) in extremes.iter_mut().zip(watched) {
            extremes.take(output.slot.number(instant), time);
        }
    }
    Ok(Flown { case: *case, peak, extremes })
}

/// What is read at the present; section loads cost as much as a step, and are found only where they are watched.
fn look<'f>(flight: &'f mut Simulation, watched: &[Watched]) -> &'f Instant {
    if watched.iter().any(|output| output.slot.is_section_load()) {
        flight.instant_with_loads()
    } else {
        flight.instant()
    }
}

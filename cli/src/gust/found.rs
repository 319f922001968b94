//! What the flights did to the watched outputs.

use flexible_aircraft::flight::{Instant, Simulation};

use super::case::Case;
use crate::watched::Watched;

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

/// Of all gusts.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Of each watched output before any gust.
    pub trim: Vec<f64>,
    pub flights: Vec<Flown>,
}

impl Extremes {
    /// Nothing was looked at.
    const NONE: Extremes = Extremes { least: (f64::INFINITY, 0.0), greatest: (f64::NEG_INFINITY, 0.0) };

    fn take(&mut self, value: f64, time: f64) {
        if value < self.least.0 {
            self.least = (value, time);
        }
        if value > self.greatest.0 {
            self.greatest = (value, time);
        }
    }
}

impl Flown {
    /// Nothing yet.
    pub fn begin(case: Case, watched: &[Watched]) -> Self {
        Flown { case, peak: 0.0, extremes: vec![Extremes::NONE; watched.len()] }
    }

    /// Looks at the watched outputs at a time, s.
    pub fn look(&mut self, time: f64, flight: &mut Simulation, watched: &[Watched]) {
        let instant = look(flight, watched);
        self.peak = instant.outputs.gust_peak_velocity;
        for (extremes, output) in self.extremes.iter_mut().zip(watched) {
            extremes.take(output.slot.number(instant), time);
        }
    }
}

/// The watched outputs at the present.
pub fn values(flight: &mut Simulation, watched: &[Watched]) -> Vec<f64> {
    let instant = look(flight, watched);
    watched.iter().map(|output| output.slot.number(instant)).collect()
}

/// What is read at the present; section loads cost as much as a step, and are found only where they are watched.
fn look<'f>(flight: &'f mut Simulation, watched: &[Watched]) -> &'f Instant {
    if watched.iter().any(|output| output.slot.is_section_load()) {
        flight.instant_with_loads()
    } else {
        flight.instant()
    }
}

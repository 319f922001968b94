//! What is done at a point, and what is left of it.

use std::sync::Arc;

use flexible_aircraft::air::GustShape;
use flexible_aircraft::flight::{Parts, Settings, Simulation, SimulationError};
use flexible_aircraft::plant::LimitExceeded;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::OutputSlot;
use flexible_aircraft::{Inflow, LinearModel};

use super::linear::{LinearKept, numbers_of};
use super::reduction::{Reduction, Seen};
use crate::numbers::Plain;
use crate::simulate::schedule::Schedule;

/// What is done.
pub enum Job {
    /// Outputs of the trim are kept.
    Trim(Vec<OutputSlot>),
    Fly(Flight),
    Linearise(Inflow, Vec<LinearKept>),
}

/// A flight from the trim on.
pub struct Flight {
    pub schedule: Schedule,
    /// Between two looks at the outputs, s.
    pub step: f64,
    /// Whether a gust has to begin before the end.
    pub is_gust: bool,
    /// Each once.
    pub outputs: Vec<OutputSlot>,
    /// Which output becomes what.
    pub kept: Vec<(usize, Reduction)>,
}

/// How a point came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Ok,
    /// There is no trim, or none within the limits of actuators and engines.
    NoTrim,
    /// The flight had to end early.
    LeftValidity,
    /// A value is not allowed, or there is no such aircraft.
    Invalid,
}

/// A point that did not come out.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    pub status: Status,
    pub message: String,
}

/// A point that did.
#[derive(Clone, Debug, PartialEq)]
pub struct Success {
    /// One for each column that is kept.
    pub numbers: Vec<Option<f64>>,
    /// Where the trim is beyond what the aircraft is flown within; empty where it is not.
    pub warning: String,
}

impl Status {
    pub const ALL: [Status; 4] = [Status::Ok, Status::NoTrim, Status::LeftValidity, Status::Invalid];

    /// As it stands in tables.
    pub fn name(self) -> &'static str {
        match self {
            Status::Ok => "ok",
            Status::NoTrim => "no_trim",
            Status::LeftValidity => "left_validity",
            Status::Invalid => "invalid",
        }
    }
}

impl Failure {
    pub fn invalid(reason: &impl ToString) -> Self {
        Failure { status: Status::Invalid, message: reason.to_string() }
    }
}

impl From<SimulationError> for Failure {
    fn from(error: SimulationError) -> Self {
        let status = match error {
            SimulationError::Trim(_) | SimulationError::BeyondLimit { .. } => Status::NoTrim,
            SimulationError::ReverseFlow { .. }
            | SimulationError::NotFinite { .. }
            | SimulationError::Tolerance { .. } => Status::LeftValidity,
            _ => Status::Invalid,
        };
        Failure { status, message: error.to_string() }
    }
}

impl Job {
    /// Does it with a model under some settings.
    pub fn run(&self, model: &Arc<ReducedModel>, settings: &Settings) -> Result<Success, Failure> {
        match self {
            Job::Trim(outputs) => {
                let mut simulation = Simulation::new(Arc::clone(model), settings, 0.0)?;
                let warning = warning(&simulation, model, settings);
                let instant = simulation.instant_of(parts(outputs));
                let numbers = outputs.iter().map(|output| Some(output.number(instant))).collect();
                Ok(Success { numbers, warning })
            }
            Job::Fly(flight) => flight.fly(model, settings),
            Job::Linearise(inflow, kept) => {
                let linear = LinearModel::new(Arc::clone(model), settings, *inflow)?;
                let numbers = numbers_of(&linear, kept).map_err(|error| Failure::invalid(&error))?;
                Ok(Success { numbers, warning: String::new() })
            }
        }
    }
}

impl Flight {
    fn fly(&self, model: &Arc<ReducedModel>, settings: &Settings) -> Result<Success, Failure> {
        let (start, end) = (settings.gust.start, self.schedule.end());
        if self.is_gust && settings.gust.shape != GustShape::None && start >= end {
            let [start, end] = [start, end].map(Plain);
            return Err(Failure::invalid(&format!(
                "gust.start: found {start} s, allowed is before the end of the flight, at {end} s"
            )));
        }
        let mut simulation = Simulation::new(Arc::clone(model), settings, self.schedule.start())?;
        let warning = warning(&simulation, model, settings);
        let parts = parts(&self.outputs);
        let mut seen: Vec<Seen> = Vec::with_capacity(self.outputs.len());
        self.schedule.fly(&mut simulation, model, Some(self.step), |time, simulation| {
            let instant = simulation.instant_of(parts);
            let values = self.outputs.iter().map(|output| output.number(instant));
            if seen.is_empty() {
                seen.extend(values.map(|value| Seen::first(time, value)));
            } else {
                seen.iter_mut().zip(values).for_each(|(seen, value)| seen.look(time, value));
            }
            Ok::<(), SimulationError>(())
        })?;
        let kept = self.kept.iter();
        let numbers = kept.map(|(output, reduction)| seen.get(*output).map(|seen| seen.reduced(*reduction)));
        Ok(Success { numbers: numbers.collect(), warning })
    }
}

/// What is read for some outputs: section loads, for one, cost as much as a step.
fn parts(outputs: &[OutputSlot]) -> Parts {
    outputs.iter().map(|output| output.part()).collect()
}

fn warning(simulation: &Simulation, model: &ReducedModel, settings: &Settings) -> String {
    LimitExceeded::warning(simulation.limits_exceeded(), model, &settings.plant).unwrap_or_default()
}

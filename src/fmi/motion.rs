//! What moves in an instance: a flight, or the equations alone.

use crate::flight::{ContinuousModel, Simulation};
use crate::plant::{LimitExceeded, TrimPoint};

/// What moves.
#[derive(Debug)]
pub(super) enum Motion {
    /// The FMU integrates.
    Flight(Box<Simulation>),
    /// The importer does.
    Continuous(Box<ContinuousModel>),
}

impl Motion {
    pub fn trim(&self) -> &TrimPoint {
        match self {
            Motion::Flight(flight) => flight.trim(),
            Motion::Continuous(model) => model.trim(),
        }
    }

    pub fn limits_exceeded(&self) -> &[LimitExceeded] {
        match self {
            Motion::Flight(flight) => flight.limits_exceeded(),
            Motion::Continuous(model) => model.limits_exceeded(),
        }
    }
}

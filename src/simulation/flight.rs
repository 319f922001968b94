//! The simulation of one flight.

use std::sync::Arc;

use super::{Inputs, Outputs, Settings, SimulationError};
use crate::structure::ReducedModel;

/// The trimmed flight condition found at construction.
#[derive(Clone, Debug, PartialEq)]
pub struct TrimPoint {
    /// Pitch angle, rad.
    pub pitch: f64,
    /// Elevator angle, rad.
    pub elevator: f64,
    /// Thrust per engine, N.
    pub thrust: f64,
}

/// A flight of one aircraft: state, time and everything needed to go on.
#[derive(Clone, Debug)]
pub struct Simulation {}

impl Simulation {
    /// Trims the aircraft and stands at the trimmed state at time `start`.
    ///
    /// # Errors
    /// When a setting is out of range or no trim exists.
    pub fn new(model: Arc<ReducedModel>, settings: &Settings, start: f64) -> Result<Self, SimulationError> {
        todo!()
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        todo!()
    }

    /// The trim found at construction.
    pub fn trim(&self) -> &TrimPoint {
        todo!()
    }

    /// Sets the inputs that act from now on, and their rates of change (zero: held constant).
    pub fn set_inputs(&mut self, inputs: &Inputs, rates: &Inputs) {
        todo!()
    }

    /// Flies to `end` (≥ `time()`), without allocating.
    ///
    /// # Errors
    /// When the flight leaves the model's validity; the simulation is then as it was before the call.
    pub fn advance_to(&mut self, end: f64) -> Result<(), SimulationError> {
        todo!()
    }

    /// The outputs at the present time under the present inputs, without allocating.
    pub fn outputs(&mut self) -> &Outputs {
        todo!()
    }

    /// Appends the complete state as bytes: restoring them continues bit for bit.
    pub fn snapshot(&self, bytes: &mut Vec<u8>) {
        todo!()
    }

    /// Goes back to a snapshot taken of a simulation of the same model with the same settings.
    ///
    /// # Errors
    /// When the bytes are damaged or of another model, settings or version; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SimulationError> {
        todo!()
    }
}

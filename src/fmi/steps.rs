//! Co-simulation: steps from one communication point to the next.

use crate::flight::{LATEST, SimulationError};

use super::instance::{GRID_REASON, Instance, is_time};
use super::interface::Version;
use super::refusal::Refusal;

impl Instance {
    /// Flies one communication step, without allocating when it succeeds.
    pub fn do_step(&mut self, point: f64, size: f64) -> Result<(), Refusal> {
        let is_long_enough = match self.interface.version {
            Version::V2 => size >= 0.0,
            Version::V3 => size > 0.0,
        };
        if !size.is_finite() || !is_long_enough {
            let least = match self.interface.version {
                Version::V2 => "that is not negative",
                Version::V3 => "greater than 0",
            };
            return Err(Refusal::error(format!(
                "step size: found {size}, allowed is a finite number {least}"
            )));
        }
        let began = self.time;
        if !point.is_finite() || (point - began).abs() > self.experiment.slack(began) {
            let reason = format!("communication point: found {point}, expected {began}");
            return Err(Refusal::error(reason));
        }
        let end = if size > 0.0 { began.max(point + size) } else { began };
        if !is_time(end) {
            let reason = format!("the step to {end} passes {LATEST:e} s: {GRID_REASON}");
            return Err(Refusal::error(reason));
        }
        if let Some(stop) = self.experiment.stop.filter(|stop| end > stop + self.experiment.slack(end)) {
            return Err(Refusal::error(format!("the step to {end} passes the stop time {stop}")));
        }
        // A master that is off by its rounding and does not step stays.
        let point = if size > 0.0 { point } else { began };
        let version = self.interface.version;
        let flight = self.flight()?;
        if let Err(error) = flight.step(point, size) {
            let reason = format!("in the step from t = {began} s to {end} s: {error}");
            return Err(if version == Version::V3 && is_of_the_model(&error) {
                Refusal::discard(reason)
            } else {
                Refusal::error(reason)
            });
        }
        self.take_inputs_of_flight();
        if end > began {
            self.rate_is_new.fill(false);
        }
        self.time = end;
        Ok(())
    }
}

/// Whether a flight cannot go on for what the model is, and not for what it was asked.
fn is_of_the_model(error: &SimulationError) -> bool {
    matches!(
        error,
        SimulationError::ReverseFlow { .. }
            | SimulationError::NotFinite { .. }
            | SimulationError::Tolerance { .. }
    )
}

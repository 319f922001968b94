//! Model exchange: the importer sets time and states, and asks for rates.

use std::mem::MaybeUninit;

use crate::flight::{LATEST, SimulationError};

use super::instance::{Instance, is_time};
use super::life_cycle::State;
use super::refusal::Refusal;

impl Instance {
    /// To the state between stretches of time, in which nothing happens.
    pub fn enter_event_mode(&mut self) {
        self.state = State::EventMode;
    }

    /// To the state in which the importer integrates.
    pub fn enter_continuous_time_mode(&mut self) {
        self.state = State::ContinuousTimeMode;
    }

    /// Takes a time, s; no equation has it. It may be beyond the stop time, for a method of many steps looks further ahead than
    /// it goes.
    pub fn set_time(&mut self, time: f64) -> Result<(), Refusal> {
        let (start, slack) = (self.experiment.start, self.experiment.slack(time));
        if time.is_finite() && !is_time(time) {
            return Err(Refusal::error(format!(
                "time: found {time}, allowed is -{LATEST:e} to {LATEST:e} s"
            )));
        }
        if !time.is_finite() || time < start - slack {
            return Err(Refusal::error(format!(
                "time: found {time}, allowed is the start time {start} s or later"
            )));
        }
        // An importer may be off by its rounding; before its start there is no state to be saved.
        self.time = time.max(start);
        Ok(())
    }

    /// How many states there are.
    pub fn state_count(&self) -> usize {
        self.table.states().len()
    }

    /// That an array has as many numbers as there are states.
    pub fn check_state_count(&self, found: usize) -> Result<(), Refusal> {
        let states = self.state_count();
        if found == states {
            return Ok(());
        }
        Err(Refusal::error(format!("number of states: found {found}, this FMU has {states}")))
    }

    /// Takes states, as many as there are.
    pub fn set_continuous_states(&mut self, states: &[f64]) -> Result<(), Refusal> {
        self.check_state_count(states.len())?;
        self.continuous()?.set_values(states);
        Ok(())
    }

    /// Writes the states.
    pub fn write_continuous_states(&mut self, places: &mut [MaybeUninit<f64>]) -> Result<(), Refusal> {
        self.check_state_count(places.len())?;
        fill(places, self.continuous()?.values());
        Ok(())
    }

    /// Writes the rates of the states, per second.
    pub fn write_state_rates(&mut self, places: &mut [MaybeUninit<f64>]) -> Result<(), Refusal> {
        self.check_state_count(places.len())?;
        let time = self.time;
        fill(places, self.continuous()?.rates(time).map_err(discard)?);
        Ok(())
    }

    /// Writes what is usual of the states.
    pub fn write_nominals(&self, places: &mut [MaybeUninit<f64>]) -> Result<(), Refusal> {
        self.check_state_count(places.len())?;
        for (place, (_, reference)) in places.iter_mut().zip(self.table.states()) {
            place.write(self.table.get(*reference).and_then(|row| row.nominal).unwrap_or(1.0));
        }
        Ok(())
    }

    /// That none of the event indicators is asked for: there are none.
    pub fn check_indicator_count(&self, found: usize) -> Result<(), Refusal> {
        match found {
            0 => Ok(()),
            _ => Err(Refusal::error(format!("number of event indicators: found {found}, this FMU has 0"))),
        }
    }
}

fn fill(places: &mut [MaybeUninit<f64>], numbers: &[f64]) {
    for (place, number) in places.iter_mut().zip(numbers) {
        place.write(*number);
    }
}

/// An importer that tries states beyond the model's validity may try others.
#[expect(clippy::needless_pass_by_value, reason = "as a result hands its error over")]
pub(super) fn discard(error: SimulationError) -> Refusal {
    Refusal::discard(error.to_string())
}

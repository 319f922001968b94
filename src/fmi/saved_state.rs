//! The state of an instance as bytes: everything that decides how it goes on, and nothing of the log.
//!
//! Content of the [sealed] bytes: life-cycle state, time, experiment, which input rates were given at the present time,
//! parameters in the order of the variable table; then, after a byte that says which, the state of the flight, which has
//! the inputs too, or where there is no flight yet inputs and their rates. The identity changes with aircraft, variables
//! and version, so foreign bytes are noticed without a version number of their own.

use crate::flight::{Inputs, Settings, Simulation};
use crate::sealed::{self, BrokenSeal, Mark, Reader};
use crate::variables::{Slot, Type, Value};

use super::instance::{Experiment, Instance, Refusal, is_time};
use super::life_cycle::State;

/// What the importer has a handle of.
///
/// It begins with a word that tells it from a handle, whatever that is: fmusim (0.0.39) frees a state by the state instead
/// of by its address.
#[repr(C)]
#[derive(Clone, Debug, PartialEq)]
pub struct SavedState {
    first_word: usize,
    bytes: Vec<u8>,
}

impl Default for SavedState {
    fn default() -> Self {
        SavedState { first_word: SavedState::FIRST_WORD, bytes: Vec::new() }
    }
}

const MARK: Mark = *b"FlexAcSt";

impl SavedState {
    /// Odd, and so neither NULL nor the address of a state.
    pub const FIRST_WORD: usize = 0x0fac_57a7;

    /// To be kept elsewhere.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

impl Instance {
    /// Replaces a saved state, without allocating where one of the same aircraft was.
    pub fn save_into(&self, saved: &mut SavedState) {
        saved.bytes.clear();
        sealed::seal(&mut saved.bytes, &MARK, self.identity, |writer| {
            let Experiment { tolerance, start, stop } = self.experiment;
            writer.byte(self.state as u8);
            writer.reals([self.time, start]);
            writer.optional_real(tolerance);
            writer.optional_real(stop);
            self.rate_is_new.iter().for_each(|is_new| writer.flag(*is_new));
            for (_, variable) in self.table.iter() {
                let Slot::Parameter(slot) = variable.slot else { continue };
                match slot.get(&self.settings) {
                    Value::Real(x) => writer.real(x),
                    Value::Integer(i) => writer.integer(i),
                    Value::Boolean(flag) => writer.flag(flag),
                }
            }
            writer.flag(self.flight.is_some());
            match &self.flight {
                Some(flight) => flight.write_state(writer),
                None => writer.reals(self.inputs.values().chain(self.rates.values())),
            }
        });
    }

    /// A saved state of its bytes: checks that the bytes are whole, undamaged and of this FMU.
    pub fn deserialise(&self, bytes: &[u8]) -> Result<SavedState, Refusal> {
        let reason = match sealed::open(bytes, &MARK, self.identity) {
            Ok(_) => return Ok(SavedState { bytes: bytes.to_vec(), ..SavedState::default() }),
            Err(BrokenSeal::Mark) => "these bytes are not a state of this FMU".to_owned(),
            Err(BrokenSeal::Length { expected }) => {
                let expected = expected.map_or("at least 16".to_owned(), |length| length.to_string());
                format!("found {} bytes, expected {expected}", bytes.len())
            }
            Err(BrokenSeal::Checksum) => "its checksum is wrong, so it is damaged".to_owned(),
            Err(BrokenSeal::Identity) => {
                "it is of another aircraft or another version of this FMU".to_owned()
            }
        };
        Err(Refusal::error(format!("serialised state: {reason}")))
    }

    /// Goes back to a saved state, or changes nothing.
    pub fn restore(&mut self, saved: &SavedState) -> Result<(), Refusal> {
        let restored = sealed::open(&saved.bytes, &MARK, self.identity)
            .ok()
            .and_then(|content| Restored::read(self, content))
            .ok_or_else(|| Refusal::error("the saved state is not of this FMU or damaged"))?;
        if let Some(objection) = restored.objection() {
            return Err(Refusal::error(format!("the saved state: {objection}")));
        }
        match restored.motion {
            Motion::None { inputs, rates } => {
                self.flight = None;
                (self.inputs, self.rates) = (inputs, rates);
            }
            Motion::Flight(state) => {
                let same = restored.settings == self.settings
                    && restored.experiment.tolerance == self.experiment.tolerance;
                let refuse = |error| Refusal::error(format!("the saved flight: {error}"));
                let flight = match self.flight.as_mut().filter(|_| same) {
                    Some(flight) => {
                        flight.read_state(state).map_err(refuse)?;
                        flight
                    }
                    None => {
                        let mut flight = self.trimmed(&restored.settings, &restored.experiment)?;
                        flight.read_state(state).map_err(refuse)?;
                        self.flight.insert(flight)
                    }
                };
                flight.write_inputs(&mut self.inputs);
                self.rates.clone_from(flight.input_rates());
            }
        }
        self.state = restored.state;
        self.time = restored.time;
        self.experiment = restored.experiment;
        self.settings = restored.settings;
        self.rate_is_new = restored.rate_is_new;
        Ok(())
    }
}

/// What the bytes say.
struct Restored<'a> {
    state: State,
    time: f64,
    experiment: Experiment,
    settings: Settings,
    rate_is_new: Vec<bool>,
    motion: Motion<'a>,
}

/// The flight, if there is one, and the inputs, which are the flight's own then.
enum Motion<'a> {
    None { inputs: Inputs, rates: Inputs },
    Flight(Reader<'a>),
}

impl<'a> Restored<'a> {
    fn read(instance: &Instance, mut content: Reader<'a>) -> Option<Self> {
        let state = *State::ALL.get(usize::from(content.byte()?))?;
        let (time, start) = (content.real()?, content.real()?);
        let (tolerance, stop) = (content.optional_real()?, content.optional_real()?);
        let mut settings = instance.settings.clone();
        let rate_is_new = instance.rate_is_new.iter().map(|_| content.flag()).collect::<Option<Vec<_>>>()?;
        for (_, variable) in instance.table.iter() {
            let Slot::Parameter(slot) = variable.slot else { continue };
            let value = match variable.kind {
                Type::Real => Value::Real(content.real()?),
                Type::Integer | Type::Enumeration(_) => Value::Integer(content.integer()?),
                Type::Boolean => Value::Boolean(content.flag()?),
            };
            slot.set(&mut settings, Some(value).filter(|value| variable.allows(*value))?);
        }
        let motion = if content.flag()? {
            Motion::Flight(content)
        } else {
            let (mut inputs, mut rates) = (instance.inputs.clone(), instance.rates.clone());
            content.reals(inputs.values_mut().chain(rates.values_mut()))?;
            if content.left() > 0 {
                return None;
            }
            Motion::None { inputs, rates }
        };
        let experiment = Experiment { tolerance, start, stop };
        Some(Restored { state, time, experiment, rate_is_new, settings, motion })
    }

    /// Why no instance can have come into such a state: a checksum does not tell a forger from a saver.
    fn objection(&self) -> Option<String> {
        let Experiment { start, stop, .. } = self.experiment;
        let has_flown = match self.state {
            State::Instantiated | State::InitializationMode => false,
            State::StepComplete | State::Terminated => true,
            State::Fatal => return Some("it is that of an instance that broke".to_owned()),
        };
        if let Some(objection) = self.experiment.objection() {
            return Some(objection);
        }
        let slack = self.experiment.slack(self.time);
        let end = if has_flown { stop.unwrap_or(f64::INFINITY) + slack } else { start };
        if !(is_time(self.time) && (start..=end).contains(&self.time)) {
            return Some(format!("time: found {} outside the experiment", self.time));
        }
        match (self.state, &self.motion) {
            (State::StepComplete | State::Terminated, Motion::None { .. }) => {
                Some("its flight is missing".to_owned())
            }
            (_, Motion::None { inputs, rates }) => {
                let found = inputs.values().chain(rates.values()).find(|number| !number.is_finite())?;
                Some(format!("inputs: found {found}, allowed are finite numbers"))
            }
            (State::Instantiated, Motion::Flight(_)) => {
                Some("found a flight before its initialisation".to_owned())
            }
            (_, Motion::Flight(state)) => {
                let time = Simulation::time_of_state(*state);
                let is_elsewhen = time.is_some_and(|time| !self.is_now(time));
                is_elsewhen.then(|| "its flight is at another time than the instance".to_owned())
            }
        }
    }

    /// Whether a flight's time, which may stand on a grid point close by, is that of the instance.
    fn is_now(&self, time: f64) -> bool {
        (time - self.time).abs() <= 10.0 * self.experiment.slack(self.time)
    }
}

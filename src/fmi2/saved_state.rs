//! The state of an instance as bytes: everything that decides how it goes on, and nothing of the log.
//!
//! Layout, little-endian: magic, length of the whole, identity of the FMU, life-cycle state, time,
//! experiment, parameters, inputs with their rates and whether these were given at the present time, in the
//! order of the variable table, the flight's own snapshot when there is one, checksum of all that. The
//! identity changes with aircraft, variables and version, so foreign bytes are noticed without a version
//! number of their own.

use super::instance::{Experiment, Instance, Refusal, is_time};
use super::life_cycle::State;
use crate::simulation::{Inputs, Settings, Simulation};
use crate::structure::fnv1a;
use crate::variables::{Slot, Type, Value};

/// What `fmi2FMUstate` points to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SavedState {
    bytes: Vec<u8>,
}

const MAGIC: &[u8; 8] = b"FlexAcSt";
const CHECKSUM_LENGTH: usize = size_of::<u128>();

impl SavedState {
    /// For `fmi2SerializeFMUstate`.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

impl Instance {
    /// `fmi2GetFMUstate`: replaces a saved state, without allocating where one of the same aircraft was.
    pub fn save_into(&self, saved: &mut SavedState) {
        let bytes = &mut saved.bytes;
        bytes.clear();
        bytes.extend(MAGIC);
        bytes.extend(0u64.to_le_bytes());
        bytes.extend(self.identity.to_le_bytes());
        bytes.push(self.state as u8);
        bytes.extend(self.time.to_le_bytes());
        bytes.extend(self.experiment.start.to_le_bytes());
        for optional in [self.experiment.tolerance, self.experiment.stop] {
            bytes.push(u8::from(optional.is_some()));
            bytes.extend(optional.unwrap_or_default().to_le_bytes());
        }
        let mut rate_is_new = self.rate_is_new.iter();
        for (_, variable) in self.table.iter() {
            match variable.slot {
                Slot::Parameter(slot) => match slot.get(&self.settings) {
                    Value::Real(x) => bytes.extend(x.to_le_bytes()),
                    Value::Integer(i) => bytes.extend(i.to_le_bytes()),
                },
                Slot::Input(slot) => {
                    bytes.extend(slot.get(&self.inputs).to_le_bytes());
                    bytes.extend(slot.get(&self.rates).to_le_bytes());
                    bytes.push(u8::from(rate_is_new.next() == Some(&true)));
                }
                Slot::Output(_) => {}
            }
        }
        bytes.push(u8::from(self.flight.is_some()));
        if let Some(flight) = &self.flight {
            // Room for the largest, so that it never has to grow.
            bytes.reserve(flight.largest_snapshot_size() + CHECKSUM_LENGTH);
            flight.snapshot(bytes);
        }
        let length = (bytes.len() + CHECKSUM_LENGTH) as u64;
        bytes[MAGIC.len()..MAGIC.len() + 8].copy_from_slice(&length.to_le_bytes());
        bytes.extend(fnv1a(bytes).to_le_bytes());
    }

    /// `fmi2DeSerializeFMUstate`: checks that the bytes are whole, undamaged and of this FMU.
    pub fn deserialise(&self, bytes: &[u8]) -> Result<SavedState, Refusal> {
        let refuse = |reason: String| Err(Refusal::error(format!("serialised state: {reason}")));
        let mut reader = Reader { bytes };
        if reader.take() != Some(*MAGIC) {
            return refuse("these bytes are not a state of this FMU".into());
        }
        let length = reader.take().map(u64::from_le_bytes);
        if length != Some(bytes.len() as u64) {
            let expected = length.map_or("at least 16".to_owned(), |length| length.to_string());
            return refuse(format!("found {} bytes, expected {expected}", bytes.len()));
        }
        let (content, checksum) = bytes.split_at(bytes.len().saturating_sub(CHECKSUM_LENGTH));
        if checksum != fnv1a(content).to_le_bytes() {
            return refuse("its checksum is wrong, so it is damaged".into());
        }
        if reader.take().map(u128::from_le_bytes) != Some(self.identity) {
            return refuse("it is of another aircraft or another version of this FMU".into());
        }
        Ok(SavedState { bytes: bytes.to_vec() })
    }

    /// `fmi2SetFMUstate`: goes back to a saved state, or changes nothing.
    pub fn restore(&mut self, saved: &SavedState) -> Result<(), Refusal> {
        let content = &saved.bytes[..saved.bytes.len().saturating_sub(CHECKSUM_LENGTH)];
        let restored = Restored::read(self, content)
            .ok_or_else(|| Refusal::error("the saved state is not of this FMU or damaged"))?;
        if let Some(objection) = restored.objection() {
            return Err(Refusal::error(format!("the saved state: {objection}")));
        }
        match restored.flight {
            None => self.flight = None,
            Some(snapshot) => {
                let same = restored.settings == self.settings
                    && restored.experiment.tolerance == self.experiment.tolerance;
                let refuse = |error| Refusal::error(format!("the saved flight: {error}"));
                match self.flight.as_mut().filter(|_| same) {
                    Some(flight) => {
                        let time = Simulation::time_of_snapshot(snapshot);
                        if time.is_some_and(|time| !restored.is_now(time)) {
                            return Err(Refusal::error(FLIGHT_ELSEWHEN));
                        }
                        flight.restore(snapshot).map_err(refuse)?;
                    }
                    None => {
                        let mut flight = self.trimmed(&restored.settings, &restored.experiment)?;
                        flight.restore(snapshot).map_err(refuse)?;
                        if !restored.is_now(flight.time()) {
                            return Err(Refusal::error(FLIGHT_ELSEWHEN));
                        }
                        self.flight = Some(flight);
                    }
                }
            }
        }
        self.state = restored.state;
        self.time = restored.time;
        self.experiment = restored.experiment;
        self.settings = restored.settings;
        self.inputs = restored.inputs;
        self.rates = restored.rates;
        self.rate_is_new = restored.rate_is_new;
        Ok(())
    }
}

const FLIGHT_ELSEWHEN: &str = "the saved flight: it is at another time than the instance";

/// What the bytes say.
struct Restored<'a> {
    state: State,
    time: f64,
    experiment: Experiment,
    settings: Settings,
    inputs: Inputs,
    rates: Inputs,
    rate_is_new: Vec<bool>,
    flight: Option<&'a [u8]>,
}

impl<'a> Restored<'a> {
    fn read(instance: &Instance, content: &'a [u8]) -> Option<Self> {
        let mut reader = Reader { bytes: content };
        reader.take::<8>().filter(|magic| magic == MAGIC)?;
        reader.take::<8>()?;
        reader.take().map(u128::from_le_bytes).filter(|identity| *identity == instance.identity)?;
        let state = *State::ALL.get(usize::from(reader.byte()?))?;
        let time = reader.real()?;
        let start = reader.real()?;
        let tolerance = reader.optional_real()?;
        let stop = reader.optional_real()?;
        let mut settings = instance.settings.clone();
        let mut inputs = instance.inputs.clone();
        let mut rates = instance.rates.clone();
        let mut rate_is_new = Vec::with_capacity(instance.rate_is_new.len());
        for (_, variable) in instance.table.iter() {
            match variable.slot {
                Slot::Parameter(slot) => {
                    let value = match variable.kind {
                        Type::Real => Value::Real(reader.real()?),
                        _ => Value::Integer(i32::from_le_bytes(reader.take()?)),
                    };
                    slot.set(&mut settings, Some(value).filter(|value| variable.allows(*value))?);
                }
                Slot::Input(slot) => {
                    *slot.of(&mut inputs) = reader.real()?;
                    *slot.of(&mut rates) = reader.real()?;
                    rate_is_new.push(reader.flag()?);
                }
                Slot::Output(_) => {}
            }
        }
        let flight = reader.flag()?.then_some(reader.bytes);
        let experiment = Experiment { tolerance, start, stop };
        Some(Restored { state, time, experiment, settings, inputs, rates, rate_is_new, flight })
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
        let mut numbers = self.inputs.values().chain(self.rates.values());
        if let Some(found) = numbers.find(|number| !number.is_finite()) {
            return Some(format!("inputs: found {found}, allowed are finite numbers"));
        }
        match (self.state, self.flight) {
            (State::Instantiated, Some(_)) => Some("found a flight before its initialisation".to_owned()),
            (State::StepComplete | State::Terminated, None) => Some("its flight is missing".to_owned()),
            _ => None,
        }
    }

    /// Whether a flight's time, which may stand on a grid point close by, is that of the instance.
    fn is_now(&self, time: f64) -> bool {
        (time - self.time).abs() <= 10.0 * self.experiment.slack(self.time)
    }
}

/// Reads from the front.
struct Reader<'a> {
    bytes: &'a [u8],
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (front, rest) = self.bytes.split_first_chunk()?;
        self.bytes = rest;
        Some(*front)
    }

    fn byte(&mut self) -> Option<u8> {
        self.take().map(|[byte]| byte)
    }

    fn flag(&mut self) -> Option<bool> {
        match self.byte()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    fn real(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    fn optional_real(&mut self) -> Option<Option<f64>> {
        let present = self.flag()?;
        let value = self.real()?;
        Some(present.then_some(value))
    }
}

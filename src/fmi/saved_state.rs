//! The state of an instance as bytes: everything that decides how it goes on, and nothing of the log.
//!
//! Content of the [sealed] bytes: life-cycle state, time, experiment, which input rates were given at the present time,
//! parameters in the order of the variable table; then, after a byte that says which, the state of the flight, which has
//! the inputs too, or where there is no flight yet inputs and their rates; of model exchange inputs and x. The identity changes
//! with aircraft, variables, version and kind, so foreign bytes are noticed without a version number of their own.

use crate::flight::{Inputs, Settings, Simulation};
use crate::sealed::{self, BrokenSeal, Mark, Reader};
use crate::variables::{Place, Slot, Type, Value};

use super::instance::{Experiment, Instance, is_time};
use super::interface::{Interface, Kind, Version};
use super::life_cycle::State;
use super::motion::Motion;
use super::refusal::Refusal;

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

/// Of co-simulation.
const FLIGHT_MARK: Mark = *b"FlexAcSt";
/// Of model exchange.
const EXCHANGE_MARK: Mark = *b"FlexAcMe";

fn mark(kind: Kind) -> Mark {
    match kind {
        Kind::CoSimulation => FLIGHT_MARK,
        Kind::ModelExchange => EXCHANGE_MARK,
    }
}

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
        sealed::seal(&mut saved.bytes, &mark(self.interface.kind), self.identity, |writer| {
            let Experiment { tolerance, start, stop } = self.experiment;
            writer.byte(self.state as u8);
            writer.reals([self.time, start]);
            writer.optional_real(tolerance);
            writer.optional_real(stop);
            self.rate_is_new.iter().for_each(|is_new| writer.flag(*is_new));
            for (_, variable) in self.table.iter() {
                let Place::Common(Slot::Parameter(slot)) = variable.slot else { continue };
                match slot.get(&self.settings) {
                    Value::Real(x) => writer.real(x),
                    Value::Integer(i) => writer.integer(i),
                    Value::Boolean(flag) => writer.flag(flag),
                }
            }
            writer.flag(self.motion.is_some());
            match &self.motion {
                Some(Motion::Flight(flight)) => flight.write_state(writer),
                Some(Motion::Continuous(model)) => {
                    writer.reals(self.inputs.values().chain(model.values().iter().copied()));
                }
                None => writer.reals(self.inputs.values().chain(self.rates.values())),
            }
        });
    }

    /// A saved state of its bytes: checks that the bytes are whole, undamaged and of this FMU.
    pub fn deserialise(&self, bytes: &[u8]) -> Result<SavedState, Refusal> {
        let kind = self.interface.kind;
        let other = match kind {
            Kind::CoSimulation => Kind::ModelExchange,
            Kind::ModelExchange => Kind::CoSimulation,
        };
        let reason = match sealed::open(bytes, &mark(kind), self.identity) {
            Ok(_) => return Ok(SavedState { bytes: bytes.to_vec(), ..SavedState::default() }),
            Err(BrokenSeal::Mark) if bytes.starts_with(&mark(other)) => {
                format!("it is of a {} FMU, and this is one for {}", other.name(), kind.name())
            }
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
        let restored = sealed::open(&saved.bytes, &mark(self.interface.kind), self.identity)
            .ok()
            .and_then(|content| Restored::read(self, content))
            .ok_or_else(|| Refusal::error("the saved state is not of this FMU or damaged"))?;
        if let Some(objection) = restored.objection(self.interface) {
            return Err(Refusal::error(format!("the saved state: {objection}")));
        }
        match &restored.motion {
            SavedMotion::None { inputs, rates } => {
                self.motion = None;
                self.inputs.clone_from(inputs);
                self.rates.clone_from(rates);
            }
            SavedMotion::Flight(state) => self.restore_flight(&restored, *state)?,
            SavedMotion::Continuous { inputs, states } => {
                self.restore_continuous(&restored, inputs, states)?;
            }
        }
        self.state = restored.state;
        self.time = restored.time;
        self.experiment = restored.experiment;
        self.settings = restored.settings;
        self.rate_is_new = restored.rate_is_new;
        Ok(())
    }

    fn restore_flight(&mut self, restored: &Restored, state: Reader) -> Result<(), Refusal> {
        let same =
            restored.settings == self.settings && restored.experiment.tolerance == self.experiment.tolerance;
        let refuse = |error| Refusal::error(format!("the saved flight: {error}"));
        match &mut self.motion {
            Some(Motion::Flight(flight)) if same => flight.read_state(state).map_err(refuse)?,
            _ => {
                let mut flight = self.trimmed(&restored.settings, &restored.experiment)?;
                flight.read_state(state).map_err(refuse)?;
                self.motion = Some(Motion::Flight(Box::new(flight)));
            }
        }
        self.take_inputs_of_flight();
        if let Some(Motion::Flight(flight)) = &self.motion {
            self.rates.clone_from(flight.input_rates());
        }
        Ok(())
    }

    fn restore_continuous(
        &mut self,
        restored: &Restored,
        inputs: &Inputs,
        states: &[f64],
    ) -> Result<(), Refusal> {
        let is_same = restored.settings == self.settings && self.motion.is_some();
        if !is_same {
            let model = self.continuous_under(&restored.settings)?;
            self.motion = Some(Motion::Continuous(Box::new(model)));
        }
        self.inputs.clone_from(inputs);
        self.continuous()?.set_values(states);
        self.pass_inputs_on();
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
    motion: SavedMotion<'a>,
}

/// What moves, if it has been trimmed, and the inputs, which are the flight's own where there is one.
enum SavedMotion<'a> {
    None { inputs: Inputs, rates: Inputs },
    Flight(Reader<'a>),
    Continuous { inputs: Inputs, states: Vec<f64> },
}

impl<'a> Restored<'a> {
    fn read(instance: &Instance, mut content: Reader<'a>) -> Option<Self> {
        let kind = instance.interface.kind;
        let state = *State::ALL.get(usize::from(content.byte()?)).filter(|state| state.is_of(kind))?;
        let (time, start) = (content.real()?, content.real()?);
        let (tolerance, stop) = (content.optional_real()?, content.optional_real()?);
        let mut settings = instance.settings.clone();
        let rate_is_new = instance.rate_is_new.iter().map(|_| content.flag()).collect::<Option<Vec<_>>>()?;
        for (_, variable) in instance.table.iter() {
            let Place::Common(Slot::Parameter(slot)) = variable.slot else { continue };
            let value = match variable.kind {
                Type::Real => Value::Real(content.real()?),
                Type::Integer | Type::Enumeration(_) => Value::Integer(content.integer()?),
                Type::Boolean => Value::Boolean(content.flag()?),
            };
            slot.set(&mut settings, Some(value).filter(|value| variable.allows(*value))?);
        }
        let motion = match (content.flag()?, kind) {
            (true, Kind::CoSimulation) => SavedMotion::Flight(content),
            (true, Kind::ModelExchange) => {
                let (mut inputs, mut states) =
                    (instance.inputs.clone(), vec![0.0; instance.table.states().len()]);
                content.reals(inputs.values_mut().chain(&mut states))?;
                (content.left() == 0).then_some(SavedMotion::Continuous { inputs, states })?
            }
            (false, _) => {
                let (mut inputs, mut rates) = (instance.inputs.clone(), instance.rates.clone());
                content.reals(inputs.values_mut().chain(rates.values_mut()))?;
                (content.left() == 0).then_some(SavedMotion::None { inputs, rates })?
            }
        };
        let experiment = Experiment { tolerance, start, stop };
        Some(Restored { state, time, experiment, rate_is_new, settings, motion })
    }

    /// Why no instance can have come into such a state: a checksum does not tell a forger from a saver.
    fn objection(&self, Interface { version, kind }: Interface) -> Option<String> {
        let Experiment { start, stop, .. } = self.experiment;
        let has_flown = match self.state {
            State::Instantiated | State::InitializationMode => false,
            State::StepComplete | State::EventMode | State::ContinuousTimeMode | State::Terminated => true,
            State::Fatal => return Some("it is that of an instance that broke".to_owned()),
        };
        if let Some(objection) = self.experiment.objection() {
            return Some(objection);
        }
        let slack = self.experiment.slack(self.time);
        let end = match kind {
            _ if !has_flown => start,
            Kind::CoSimulation => stop.unwrap_or(f64::INFINITY) + slack,
            // Importers look ahead of the stop time.
            Kind::ModelExchange => f64::INFINITY,
        };
        if !(is_time(self.time) && (start..=end).contains(&self.time)) {
            return Some(format!("time: found {} outside the experiment", self.time));
        }
        // An instance of FMI 3.0 is read before its initialisation, and ended by an error in it.
        let is_v3 = version == Version::V3;
        match (self.state, &self.motion) {
            (
                State::StepComplete | State::EventMode | State::ContinuousTimeMode,
                SavedMotion::None { .. },
            ) => Some("its flight is missing".to_owned()),
            (State::Terminated, SavedMotion::None { .. }) if !is_v3 => {
                Some("its flight is missing".to_owned())
            }
            (_, SavedMotion::None { inputs, rates }) => {
                let found = inputs.values().chain(rates.values()).find(|number| !number.is_finite())?;
                Some(format!("inputs: found {found}, allowed are finite numbers"))
            }
            (State::Instantiated, SavedMotion::Flight(_) | SavedMotion::Continuous { .. }) if !is_v3 => {
                Some("found a flight before its initialisation".to_owned())
            }
            (_, SavedMotion::Continuous { inputs, .. }) => {
                let found = inputs.values().find(|number| !number.is_finite())?;
                Some(format!("inputs: found {found}, allowed are finite numbers"))
            }
            (_, SavedMotion::Flight(state)) => {
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

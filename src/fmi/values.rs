//! Getting and setting the variables of an instance.
//!
//! Everything about a call is checked before anything is changed.

use crate::flight::{Instant, Parts, Settings, continuous_settings};
use crate::variables::{InputSlot, ParameterSlot, Place, Slot, Type, Value, Variable};

use super::exchange::discard;
use super::instance::Instance;
use super::interface::{Kind, Version};
use super::life_cycle::State;
use super::motion::Motion;
use super::refusal::Refusal;

/// The number of a variable.
pub type ValueReference = u32;

/// Which variables a call reads or writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Reals.
    Real,
    /// Integers, in FMI 2.0 enumerations too.
    Integer,
    /// Enumerations by their own functions, those of 64-bit integers.
    Enumeration,
    /// Booleans.
    Boolean,
    /// Of a type that no variable has, with its article.
    OfNone(&'static str),
}

impl Numbers {
    fn of(kind: Type, version: Version) -> Self {
        match (kind, version) {
            (Type::Real, _) => Numbers::Real,
            (Type::Enumeration(_), Version::V3) => Numbers::Enumeration,
            (Type::Integer | Type::Enumeration(_), _) => Numbers::Integer,
            (Type::Boolean, _) => Numbers::Boolean,
        }
    }

    fn name(self, version: Version) -> &'static str {
        match (self, version) {
            (Numbers::Real, Version::V2) => "a Real",
            (Numbers::Real, Version::V3) => "a Float64",
            (Numbers::Integer, Version::V2) => "an Integer or Enumeration",
            (Numbers::Integer, Version::V3) => "an Int32",
            (Numbers::Enumeration, _) => "an Enumeration, which is read and written as an Int64",
            (Numbers::Boolean, _) => "a Boolean",
            (Numbers::OfNone(name), _) => name,
        }
    }
}

/// What of an instance some variables are read from, beside inputs and parameters.
#[derive(Clone, Copy, Debug, Default)]
struct Wanted {
    outputs: Option<Parts>,
    rates: bool,
    states: bool,
}

/// What moves, as it is read.
#[derive(Clone, Copy, Debug, Default)]
struct Present<'a> {
    instant: Option<&'a Instant>,
    rates: &'a [f64],
    states: &'a [f64],
}

impl Instance {
    /// Passes the values of the referenced variables on, in order, once all references are known to be good.
    pub fn get(
        &mut self,
        numbers: Numbers,
        references: &[ValueReference],
        mut sink: impl FnMut(usize, Value),
    ) -> Result<(), Refusal> {
        let wanted = self.wanted(numbers, references)?;
        if wanted.outputs.is_some() || wanted.rates || wanted.states {
            self.motion()?;
        }
        let in_flight = matches!(self.state, State::StepComplete | State::Terminated);
        let in_use = in_flight.then(|| self.experiment.tolerance_in_use(&self.settings));
        let Instance { table, inputs, settings, motion, time, .. } = self;
        let present = present(motion, wanted, *time)?;
        let values = references.iter().filter_map(|reference| table.get(*reference)).map(|variable| {
            let value = match variable.slot {
                Place::Common(Slot::Input(slot)) => Value::Real(slot.get(inputs)),
                Place::Common(Slot::Parameter(ParameterSlot::Tolerance)) => {
                    Value::Real(in_use.unwrap_or(settings.tolerance))
                }
                Place::Common(Slot::Parameter(slot)) => slot.get(settings),
                Place::Common(Slot::Output(slot)) => {
                    present.instant.map_or(Value::Real(f64::NAN), |instant| slot.get(instant))
                }
                Place::State(place) => Value::Real(present.states[place]),
                Place::Rate(place) => Value::Real(present.rates[place]),
                Place::Time => Value::Real(*time),
            };
            (variable, value)
        });
        for (variable, value) in values.clone() {
            if matches!(value, Value::Real(x) if !x.is_finite()) {
                return Err(Refusal::error(format!("`{}` is not finite at t = {time} s", variable.name)));
            }
        }
        values.enumerate().for_each(|(i, (_, value))| sink(i, value));
        Ok(())
    }

    /// What has to be known for some variables.
    fn wanted(&self, numbers: Numbers, references: &[ValueReference]) -> Result<Wanted, Refusal> {
        let mut wanted = Wanted::default();
        for reference in references {
            match self.variable(*reference, numbers)?.slot {
                Place::Common(Slot::Output(slot)) => {
                    wanted.outputs = Some(wanted.outputs.unwrap_or_default().and(slot.part()));
                }
                Place::State(_) => wanted.states = true,
                Place::Rate(_) => wanted.rates = true,
                Place::Common(Slot::Input(_) | Slot::Parameter(_)) | Place::Time => {}
            }
        }
        Ok(wanted)
    }

    /// Sets variables, all of them or none. The value of an input ends a derivative that was given at an earlier
    /// communication point, not one that was given at the present one.
    pub fn set(
        &mut self,
        numbers: Numbers,
        references: &[ValueReference],
        values: impl Iterator<Item = Value> + Clone,
    ) -> Result<(), Refusal> {
        let mut changed = None;
        let mut states: Option<Vec<f64>> = None;
        for (reference, value) in references.iter().zip(values.clone()) {
            let variable = self.variable(*reference, numbers)?;
            if let Some(objection) = self.objection_to_setting(*reference, variable, value) {
                return Err(Refusal::error(objection));
            }
            let place = variable.slot;
            match (place, value) {
                // In flight it is a value that the parameter has.
                (Place::Common(Slot::Parameter(slot)), value) if self.is_before_flight() => {
                    slot.set(changed.get_or_insert_with(|| self.settings.clone()), value);
                }
                (place, Value::Real(number)) => {
                    if let Some(state) = self.state_at(place, *reference) {
                        let present = match &mut states {
                            Some(states) => states,
                            None => states.insert(self.continuous()?.values().to_vec()),
                        };
                        present[state] = number;
                    }
                }
                _ => {}
            }
        }
        if let Some(settings) = &changed
            && self.interface.kind == Kind::ModelExchange
        {
            continuous_settings::check(settings, &self.model)
                .map_err(|error| Refusal::error(error.to_string()))?;
        }
        self.take_inputs(references, values);
        if let Some(settings) = changed.filter(|settings| *settings != self.settings) {
            self.settings = settings;
            self.motion = None;
        }
        if let Some(states) = states {
            self.continuous()?.set_values(&states);
        }
        self.pass_inputs_on();
        Ok(())
    }

    /// Takes the inputs among some variables.
    fn take_inputs(&mut self, references: &[ValueReference], values: impl Iterator<Item = Value>) {
        for (reference, value) in references.iter().zip(values) {
            let slot = self.table.get(*reference).map(|variable| variable.slot);
            if let (Some(Place::Common(Slot::Input(slot))), Value::Real(number)) = (slot, value) {
                *slot.of(&mut self.inputs) = number;
                if !*self.rate_is_new(*reference) {
                    *slot.of(&mut self.rates) = 0.0;
                }
            }
        }
    }

    fn is_before_flight(&self) -> bool {
        matches!(self.state, State::Instantiated | State::InitializationMode)
    }

    /// The place in x of a variable, if it is a state.
    fn state_at(&self, place: Place, reference: ValueReference) -> Option<usize> {
        match place {
            Place::State(place) => Some(place),
            Place::Common(Slot::Output(output)) => self.table.state_of(output, reference),
            _ => None,
        }
    }

    /// From now on the input changes at this rate, until its rate is given again or its
    /// value is set at a later communication point. Derivatives of higher orders are left out with a warning.
    pub fn set_input_rates(
        &mut self,
        references: &[ValueReference],
        orders: &[i32],
        derivatives: &[f64],
    ) -> Result<(), Refusal> {
        let derivatives = references.iter().zip(orders).zip(derivatives);
        for ((reference, order), derivative) in derivatives.clone() {
            self.input(*reference)?;
            if *order < 1 || !derivative.is_finite() {
                let name = &self.variable(*reference, Numbers::Real)?.name;
                return Err(Refusal::error(if *order < 1 {
                    format!(
                        "`{name}`: found a derivative of order {order}, allowed is 1 (higher ones are left out)"
                    )
                } else {
                    format!("`{name}`: found the derivative {derivative}, allowed are finite ones")
                }));
            }
        }
        for ((reference, order), derivative) in derivatives {
            if *order == 1 {
                *self.input(*reference)?.of(&mut self.rates) = *derivative;
                *self.rate_is_new(*reference) = true;
            } else {
                let name = &self.variable(*reference, Numbers::Real)?.name;
                self.warn(format!(
                    "`{name}`: its derivative of order {order} is left out, only order 1 acts"
                ));
            }
        }
        self.pass_inputs_on();
        Ok(())
    }

    pub(super) fn variable(
        &self,
        reference: ValueReference,
        numbers: Numbers,
    ) -> Result<&Variable<Place>, Refusal> {
        let variable = self.table.get(reference).ok_or_else(|| Refusal::error(unknown(reference)))?;
        let version = self.interface.version;
        let found = Numbers::of(variable.kind, version);
        if found != numbers {
            let (found, asked) = (found.name(version), numbers.name(version));
            return Err(Refusal::error(format!("`{}` is {found}, not {asked}", variable.name)));
        }
        Ok(variable)
    }

    pub(super) fn input(&self, reference: ValueReference) -> Result<InputSlot, Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        match variable.slot {
            Place::Common(Slot::Input(slot)) => Ok(slot),
            _ => Err(Refusal::error(format!("`{}` is not an input", variable.name))),
        }
    }

    /// Whether the rate of an input was given at the present communication point.
    fn rate_is_new(&mut self, input: ValueReference) -> &mut bool {
        // Inputs are the first rows of the table.
        &mut self.rate_is_new[input as usize]
    }

    /// Why a variable may not be set to a value now. After initialisation a parameter may be written again with the value
    /// that it has, for some importers write all parameters before every step.
    fn objection_to_setting(
        &self,
        reference: ValueReference,
        variable: &Variable<Place>,
        value: Value,
    ) -> Option<String> {
        let name = &variable.name;
        match variable.slot {
            place if self.state_at(place, reference).is_some() => {
                if let Some(objection) = self.objection_to_setting_states() {
                    return Some(format!("`{name}` {objection}"));
                }
            }
            Place::Common(Slot::Output(_)) => {
                return Some(format!("`{name}` is an output and cannot be set"));
            }
            Place::Rate(_) => return Some(format!("`{name}` is a rate and cannot be set")),
            Place::Time => {
                return Some(format!("`{name}` is set by the steps that are taken, not as a variable"));
            }
            Place::Common(Slot::Parameter(slot))
                if !self.is_before_flight() && !has_value(slot, value, &self.settings, self.tolerance()) =>
            {
                return Some(format!(
                    "`{name}` is a fixed parameter: it can be set only until initialisation ends"
                ));
            }
            _ => {}
        }
        (!variable.allows(value)).then(|| {
            let found = match value {
                Value::Real(x) => x.to_string(),
                Value::Integer(i) => i.to_string(),
                Value::Boolean(flag) => flag.to_string(),
            };
            format!("`{name}`: found {found}, allowed is {}", variable.allowed())
        })
    }

    /// Why states may not be set now.
    fn objection_to_setting_states(&self) -> Option<&'static str> {
        match (self.state, self.interface.version) {
            (State::ContinuousTimeMode, _) | (State::EventMode, Version::V3) => None,
            (_, Version::V2) => Some("is a state: it is set in continuousTimeMode alone"),
            (_, Version::V3) => Some("is a state: it is set in Event Mode and Continuous-Time Mode alone"),
        }
    }

    /// In flight, where that of the experiment may be tighter.
    fn tolerance(&self) -> f64 {
        self.experiment.tolerance_in_use(&self.settings)
    }
}

/// Whether a parameter has a value, or reads so in flight.
fn has_value(slot: ParameterSlot, value: Value, settings: &Settings, tolerance: f64) -> bool {
    slot.get(settings) == value || (slot, value) == (ParameterSlot::Tolerance, Value::Real(tolerance))
}

/// What is wanted of what moves.
fn present(motion: &mut Option<Motion>, wanted: Wanted, time: f64) -> Result<Present<'_>, Refusal> {
    let Wanted { outputs, rates, .. } = wanted;
    match motion {
        None => Ok(Present::default()),
        Some(Motion::Flight(flight)) => {
            let instant = outputs.map(|parts| flight.instant_of(parts));
            Ok(Present { instant, ..Present::default() })
        }
        Some(Motion::Continuous(model)) => {
            if outputs.is_some() || rates {
                model.evaluate(outputs.unwrap_or_default(), time).map_err(discard)?;
            }
            let (instant, rates, states) = model.latest();
            Ok(Present { instant: Some(instant), rates, states })
        }
    }
}

fn unknown(reference: ValueReference) -> String {
    format!("value reference {reference}: there is no such variable")
}

//! Getting and setting the variables of an instance, and asking for its status.
//!
//! Everything about a call is checked before anything is changed.

use crate::flight::{Parts, Settings};
use crate::variables::{InputSlot, ParameterSlot, Slot, Type, Value, Variable};

use super::instance::{Instance, Refusal};
use super::life_cycle::State;

/// The number of a variable: its row in the table.
pub type ValueReference = u32;

/// Which variables a call reads or writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Reals.
    Real,
    /// Integers and enumerations.
    Integer,
    /// Booleans.
    Boolean,
}

impl Numbers {
    fn of(kind: Type) -> Self {
        match kind {
            Type::Real => Numbers::Real,
            Type::Integer | Type::Enumeration(_) => Numbers::Integer,
            Type::Boolean => Numbers::Boolean,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Numbers::Real => "a Real",
            Numbers::Integer => "an Integer or Enumeration",
            Numbers::Boolean => "a Boolean",
        }
    }
}

impl Instance {
    /// Passes the values of the referenced variables on, in order, once all references are known to be good.
    pub fn get(
        &mut self,
        numbers: Numbers,
        references: &[ValueReference],
        mut sink: impl FnMut(usize, Value),
    ) -> Result<(), Refusal> {
        let mut parts: Option<Parts> = None;
        for reference in references {
            if let Slot::Output(slot) = self.variable(*reference, numbers)?.slot {
                parts = Some(parts.unwrap_or_default().and(slot.part()));
            }
        }
        if parts.is_some() {
            self.flight()?;
        }
        let in_use = matches!(self.state, State::StepComplete | State::Terminated)
            .then(|| self.experiment.tolerance_in_use(&self.settings));
        let Instance { table, inputs, settings, flight, time, .. } = self;
        let present = flight.as_mut().zip(parts).map(|(flight, parts)| flight.instant_of(parts));
        let values = references.iter().filter_map(|reference| table.get(*reference)).map(|variable| {
            let value = match (variable.slot, &present) {
                (Slot::Input(slot), _) => Value::Real(slot.get(inputs)),
                (Slot::Parameter(ParameterSlot::Tolerance), _) => {
                    Value::Real(in_use.unwrap_or(settings.tolerance))
                }
                (Slot::Parameter(slot), _) => slot.get(settings),
                (Slot::Output(slot), Some(instant)) => slot.get(instant),
                (Slot::Output(_), None) => Value::Real(f64::NAN),
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

    /// Sets variables, all of them or none. The value of an input ends a derivative that was given at an earlier
    /// communication point, not one that was given at the present one.
    pub fn set(
        &mut self,
        numbers: Numbers,
        references: &[ValueReference],
        values: impl Iterator<Item = Value> + Clone,
    ) -> Result<(), Refusal> {
        // As it reads in flight, where the experiment's tolerance may be tighter.
        let in_use = self.experiment.tolerance_in_use(&self.settings);
        for (reference, value) in references.iter().zip(values.clone()) {
            let variable = self.variable(*reference, numbers)?;
            if let Some(objection) =
                objection_to_setting(variable, value, self.state, (&self.settings, in_use))
            {
                return Err(Refusal::error(objection));
            }
        }
        let mut changed = None;
        for (reference, value) in references.iter().zip(values) {
            match (self.variable(*reference, numbers)?.slot, value) {
                (Slot::Input(slot), Value::Real(x)) => {
                    *slot.of(&mut self.inputs) = x;
                    if !*self.rate_is_new(*reference) {
                        *slot.of(&mut self.rates) = 0.0;
                    }
                }
                // In flight it is a value that the parameter has.
                (Slot::Parameter(slot), value) if self.state != State::StepComplete => {
                    slot.set(changed.get_or_insert_with(|| self.settings.clone()), value);
                }
                _ => {}
            }
        }
        if let Some(settings) = changed.filter(|settings| *settings != self.settings) {
            self.settings = settings;
            self.flight = None;
        }
        self.pass_inputs_on();
        Ok(())
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

    /// Refuses any reference: there are no Strings.
    pub fn no_strings(&self, references: &[ValueReference]) -> Result<(), Refusal> {
        let Some(reference) = references.first() else { return Ok(()) };
        Err(Refusal::error(match self.table.get(*reference) {
            Some(variable) => {
                format!("`{}` is {}, not a String", variable.name, Numbers::of(variable.kind).name())
            }
            None => unknown(*reference),
        }))
    }

    pub(super) fn variable(&self, reference: ValueReference, numbers: Numbers) -> Result<&Variable, Refusal> {
        let variable = self.table.get(reference).ok_or_else(|| Refusal::error(unknown(reference)))?;
        let found = Numbers::of(variable.kind);
        if found != numbers {
            let reason = format!("`{}` is {}, not {}", variable.name, found.name(), numbers.name());
            return Err(Refusal::error(reason));
        }
        Ok(variable)
    }

    pub(super) fn input(&self, reference: ValueReference) -> Result<InputSlot, Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        match variable.slot {
            Slot::Input(slot) => Ok(slot),
            _ => Err(Refusal::error(format!("`{}` is not an input", variable.name))),
        }
    }

    /// Whether the rate of an input was given at the present communication point.
    fn rate_is_new(&mut self, input: ValueReference) -> &mut bool {
        // Inputs are the first rows of the table.
        &mut self.rate_is_new[input as usize]
    }

    fn pass_inputs_on(&mut self) {
        if let Some(flight) = &mut self.flight {
            flight.set_inputs(&self.inputs, &self.rates);
        }
    }
}

fn unknown(reference: ValueReference) -> String {
    format!("value reference {reference}: there is no such variable")
}

/// Why a variable may not be set to a value now. After initialisation a parameter may be written again with the value
/// that it has, for some importers write all parameters before every step.
fn objection_to_setting(
    variable: &Variable,
    value: Value,
    state: State,
    (settings, tolerance_in_use): (&Settings, f64),
) -> Option<String> {
    let name = &variable.name;
    match variable.slot {
        Slot::Output(_) => return Some(format!("`{name}` is an output and cannot be set")),
        Slot::Parameter(slot)
            if state == State::StepComplete
                && slot.get(settings) != value
                && (slot, value) != (ParameterSlot::Tolerance, Value::Real(tolerance_in_use)) =>
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

//! How a row of the table is made.

use std::ops::RangeInclusive;

use crate::flight::Settings;

use super::output_slot::OutputSlot;
use super::slot::{InputSlot, ParameterSlot, Slot};
use super::unit::Unit;
use super::value::Value;
use super::variable::{Type, Variability, Variable};

pub(super) fn input(name: &str, unit: Unit, slot: InputSlot, description: &str) -> Variable {
    Variable {
        start: Some(Value::Real(0.0)),
        ..real(name.to_owned(), Some(unit), Slot::Input(slot), description.to_owned())
    }
}

/// A parameter; type and unit are for the caller to add.
pub(super) fn parameter(
    name: impl Into<String>,
    slot: ParameterSlot,
    start: &Settings,
    description: impl Into<String>,
) -> Variable {
    Variable {
        variability: Variability::Fixed,
        start: Some(slot.get(start)),
        ..real(name.into(), None, Slot::Parameter(slot), description.into())
    }
}

pub(super) fn output(
    name: String,
    unit: impl Into<Option<Unit>>,
    slot: OutputSlot,
    description: String,
) -> Variable {
    real(name, unit.into(), Slot::Output(slot), description)
}

pub(super) fn real<Place>(
    name: String,
    unit: Option<Unit>,
    slot: Place,
    description: String,
) -> Variable<Place> {
    Variable {
        name,
        description,
        kind: Type::Real,
        variability: Variability::Continuous,
        unit,
        start: None,
        min: None,
        max: None,
        min_beside_none: None,
        nominal: None,
        slot,
    }
}

impl<Place> Variable<Place> {
    pub(super) fn at_least(self, min: f64) -> Self {
        Variable { min: Some(min), ..self }
    }

    pub(super) fn between(self, min: f64, max: f64) -> Self {
        Variable { min: Some(min), max: Some(max), ..self }
    }

    pub(super) fn within(self, range: RangeInclusive<f64>) -> Self {
        self.between(*range.start(), *range.end())
    }

    pub(super) fn nominal(self, nominal: f64) -> Self {
        Variable { nominal: Some(nominal), ..self }
    }
}

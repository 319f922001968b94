//! The table of FMI variables: declared once, here, for a given aircraft.
//!
//! The model description, the value references, the get and set functions and the documentation all come
//! from this table; nothing else lists a variable. A value reference is the row's index, one numbering for
//! all types, so that a reference used with the wrong type is noticed.

mod dependence;
mod slot;
mod table;
mod unit;

pub use slot::{
    AirQuantity, Axis, DeflectionComponent, EnumerationType, InputSlot, OutputSlot, ParameterSlot, Slot,
    Value,
};
pub use unit::{BaseUnit, DisplayUnit, Unit};

use crate::structure::ReducedModel;

/// The type of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A double.
    Real,
    /// A 32-bit integer.
    Integer,
    /// An integer that names one of a list, from 1.
    Enumeration(EnumerationType),
}

/// When a value may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variability {
    /// Constant after initialisation.
    Fixed,
    /// Changes only when the flight is initialised anew.
    Discrete,
    /// Changes with time.
    Continuous,
}

/// One row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// As users connect to it.
    pub name: String,
    /// For people.
    pub description: String,
    /// Type of its value.
    pub kind: Type,
    /// When its value changes.
    pub variability: Variability,
    /// Every Real has one, except the modal coordinates: no unit of FMI is made of √kg.
    pub unit: Option<Unit>,
    /// Value before it is set; inputs and parameters have one, outputs are calculated.
    pub start: Option<Value>,
    /// Smallest value that is accepted (parameters) or possible (outputs).
    pub min: Option<f64>,
    /// Largest value that is accepted (parameters) or possible (outputs).
    pub max: Option<f64>,
    /// Typical magnitude.
    pub nominal: Option<f64>,
    /// Where the value lives; it implies the causality.
    pub slot: Slot,
}

impl Variable {
    /// Whether the value is within `min` and `max` (enumerations: one of the list).
    pub fn allows(&self, value: Value) -> bool {
        let number = match value {
            Value::Real(x) => x,
            Value::Integer(i) => f64::from(i),
        };
        number.is_finite()
            && self.min.is_none_or(|min| number >= min)
            && self.max.is_none_or(|max| number <= max)
    }

    /// What [`allows`](Self::allows) accepts, for people, with its unit.
    pub fn allowed(&self) -> String {
        if let Type::Enumeration(enumeration) = self.kind {
            let items = enumeration.items().iter().enumerate();
            return items.map(|(i, (item, _))| format!("{} ({item})", i + 1)).collect::<Vec<_>>().join(", ");
        }
        let unit = match self.unit {
            None | Some(Unit::One) => String::new(),
            Some(unit) => format!(" {}", unit.name()),
        };
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!("{min} to {max}{unit}"),
            (Some(min), None) => format!("{min}{unit} and above"),
            (None, Some(max)) => format!("{max}{unit} and below"),
            (None, None) if unit.is_empty() => "any finite number".to_owned(),
            (None, None) => format!("any finite number, in{unit}"),
        }
    }
}

/// All variables of the FMU of one aircraft; the index is the value reference.
///
/// ```
/// use flexible_aircraft::variables::{Unit, VariableTable};
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let table = VariableTable::new(&jet);
/// let airspeed = table.named("airspeed").ok_or("no such variable")?;
/// assert_eq!((airspeed.unit, airspeed.allowed()), (Some(Unit::MetrePerSecond), "1 to 400 m/s".to_owned()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VariableTable {
    rows: Vec<Variable>,
}

impl VariableTable {
    /// The variables for this aircraft: engines, stations and packaged modes each bring their own.
    pub fn new(model: &ReducedModel) -> Self {
        VariableTable { rows: table::rows(model) }
    }

    /// The variable with a value reference.
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.rows.get(usize::try_from(reference).ok()?)
    }

    /// All variables with their value references, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &Variable)> {
        (0u32..).zip(&self.rows)
    }

    /// The variable of a name.
    pub fn named(&self, name: &str) -> Option<&Variable> {
        self.rows.iter().find(|variable| variable.name == name)
    }

    /// The value reference of a name.
    pub fn reference(&self, name: &str) -> Option<u32> {
        self.iter().find(|(_, variable)| variable.name == name).map(|(reference, _)| reference)
    }

    /// The variables on whose values an output depends at an instant of the flight: inputs that act on it
    /// without integration in between.
    pub fn dependencies(&self, output: OutputSlot) -> Vec<u32> {
        self.knowns(|known| matches!(known, Slot::Input(input) if dependence::direct(output, input)))
    }

    /// The variables on whose values an output depends at initialisation.
    pub fn initial_dependencies(&self, output: OutputSlot) -> Vec<u32> {
        self.knowns(|known| match known {
            Slot::Input(input) => dependence::direct(output, input),
            Slot::Parameter(parameter) => dependence::initial(output, parameter),
            Slot::Output(_) => false,
        })
    }

    fn knowns(&self, wanted: impl Fn(Slot) -> bool) -> Vec<u32> {
        self.iter().filter(|(_, variable)| wanted(variable.slot)).map(|(reference, _)| reference).collect()
    }
}

#[cfg(test)]
pub(crate) mod tests;

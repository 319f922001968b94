//! One row of the table: what FMI says of a variable, and where its value lives.

use super::enumeration::EnumerationType;
use super::slot::Slot;
use super::unit::Unit;
use super::value::Value;

/// The type of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A double.
    Real,
    /// A 32-bit integer.
    Integer,
    /// True or false.
    Boolean,
    /// An integer that names one of a list, from 1.
    Enumeration(EnumerationType),
}

/// When a value may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variability {
    /// Constant after initialisation.
    Fixed,
    /// Changes at events, or only when the flight is initialised anew.
    Discrete,
    /// Changes with time.
    Continuous,
}

/// One row of the table, or of another one whose values live elsewhere too.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable<Place = Slot> {
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
    /// Where 0 stands for none: the smallest value beside it that is accepted.
    pub min_beside_none: Option<f64>,
    /// Typical magnitude.
    pub nominal: Option<f64>,
    /// Where the value lives; it implies the causality.
    pub slot: Place,
}

impl<Place> Variable<Place> {
    /// Whether the value is within `min` and `max`, and not just beside a 0 that stands for none (enumerations: one of the list; Booleans: either).
    pub fn allows(&self, value: Value) -> bool {
        let number = match value {
            Value::Real(x) => x,
            Value::Integer(i) => f64::from(i),
            Value::Boolean(_) => return self.kind == Type::Boolean,
        };
        self.kind != Type::Boolean
            && number.is_finite()
            && self.min.is_none_or(|min| number >= min)
            && self.max.is_none_or(|max| number <= max)
            && self.min_beside_none.is_none_or(|min| number == 0.0 || number >= min)
    }

    /// What [`allows`](Self::allows) accepts, for people, with its unit.
    pub fn allowed(&self) -> String {
        match self.kind {
            Type::Enumeration(enumeration) => {
                let items = enumeration.items().iter().enumerate();
                let items: Vec<String> = items.map(|(i, (item, _))| format!("{} ({item})", i + 1)).collect();
                return items.join(", ");
            }
            Type::Boolean => return "true or false".to_owned(),
            Type::Real | Type::Integer => {}
        }
        let unit = match self.unit {
            None | Some(Unit::One) => String::new(),
            Some(unit) => format!(" {}", unit.name()),
        };
        match (self.min, self.max) {
            (Some(min), Some(max)) if min == max => format!("{min}{unit}"),
            (Some(min), Some(max)) => match self.min_beside_none {
                Some(beside) => format!("{min} or {beside} to {max}{unit}"),
                None => format!("{min} to {max}{unit}"),
            },
            (Some(min), None) => format!("{min}{unit} and above"),
            (None, Some(max)) => format!("{max}{unit} and below"),
            (None, None) if unit.is_empty() => "any finite number".to_owned(),
            (None, None) => format!("any finite number, in{unit}"),
        }
    }
}

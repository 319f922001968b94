//! What variables are set to, and what it means for them.

use std::fmt;

use crate::variables::{InputSlot, Slot, Type, Value, Variable, instead_of_degrees, probably_meant};

/// What a variable is set to: a number, an item of an enumeration by its name, or whether something is so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting<'a> {
    /// Of a Real, in SI units; a whole number of an Integer or the number of an item.
    Number(f64),
    /// Such as `rigid` of `model`.
    Item(&'a str),
    /// Of a Boolean.
    Flag(bool),
}

impl From<f64> for Setting<'_> {
    fn from(number: f64) -> Self {
        Setting::Number(number)
    }
}

impl From<i32> for Setting<'_> {
    fn from(number: i32) -> Self {
        Setting::Number(f64::from(number))
    }
}

impl<'a> From<&'a str> for Setting<'a> {
    fn from(item: &'a str) -> Self {
        Setting::Item(item)
    }
}

impl From<bool> for Setting<'_> {
    fn from(flag: bool) -> Self {
        Setting::Flag(flag)
    }
}

impl fmt::Display for Setting<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Setting::Number(number) => number.fmt(f),
            Setting::Item(item) => write!(f, "`{item}`"),
            Setting::Flag(flag) => flag.fmt(f),
        }
    }
}

/// What is allowed in place of an angle of a control that can only be in degrees.
pub(super) fn degrees(slot: Slot, setting: Setting) -> Option<String> {
    match (slot, setting) {
        (Slot::Input(InputSlot::Control(_)), Setting::Number(angle)) => instead_of_degrees(angle),
        _ => None,
    }
}

/// The item of an enumeration that was probably meant, to be put behind a message.
pub(super) fn item_meant(variable: &Variable, setting: Setting) -> String {
    let meant = match (variable.kind, setting) {
        (Type::Enumeration(kind), Setting::Item(item)) => {
            probably_meant(item, kind.items().iter().map(|(name, _)| *name))
        }
        _ => None,
    };
    meant.map_or_else(String::new, |meant| format!("; did you mean `{meant}`?"))
}

/// What a setting means for a variable, if it can mean anything.
pub(super) fn value(variable: &Variable, setting: Setting) -> Option<Value> {
    let whole = |number: f64| (libm::trunc(number) == number).then_some(Value::Integer(number as i32));
    match (variable.kind, setting) {
        (Type::Real, Setting::Number(number)) => Some(Value::Real(number)),
        (Type::Integer | Type::Enumeration(_), Setting::Number(number)) => whole(number),
        (Type::Enumeration(kind), Setting::Item(item)) => {
            let place = kind.items().iter().position(|(name, _)| *name == item)?;
            whole(1.0 + place as f64)
        }
        (Type::Boolean, Setting::Flag(flag)) => Some(Value::Boolean(flag)),
        (Type::Boolean, Setting::Number(_))
        | (Type::Real | Type::Integer | Type::Boolean, Setting::Item(_))
        | (Type::Real | Type::Integer | Type::Enumeration(_), Setting::Flag(_)) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::test_jet::jet;
    use crate::variables::VariableTable;

    #[test]
    fn a_boolean_is_set_by_true_and_false_alone_and_nothing_else_by_them() {
        let mut model = jet().clone();
        model.modes[25].of_loads = true;
        let table = VariableTable::new(&model);
        let meaning = |name: &str, setting| value(table.named(name).unwrap(), setting);
        for flag in [true, false] {
            assert_eq!(meaning("load_modes", flag.into()), Some(Value::Boolean(flag)));
            for name in ["model", "mode_count", "airspeed", "elevator"] {
                assert_eq!(meaning(name, flag.into()), None, "{name}");
            }
        }
        for wrong in [Setting::Number(1.0), Setting::Item("true")] {
            assert_eq!(meaning("load_modes", wrong), None);
        }
    }
}

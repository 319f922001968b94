//! Values of variables.

/// The value of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of a Real.
    Real(f64),
    /// Of an Integer, or of an Enumeration (from 1).
    Integer(i32),
    /// Of a Boolean.
    Boolean(bool),
}

impl Value {
    /// As a number: of an enumeration that of the item, of a Boolean 1 or 0.
    pub fn number(self) -> f64 {
        match self {
            Value::Real(number) => number,
            Value::Integer(number) => f64::from(number),
            Value::Boolean(flag) => f64::from(u8::from(flag)),
        }
    }
}

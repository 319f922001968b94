//! A variable of a component.

use std::fmt;
use std::str::FromStr;

/// A variable of a component, written `component.variable`; the variable's name may have further dots.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Endpoint {
    /// Name of the component.
    pub component: String,
    /// Name of the variable.
    pub variable: String,
}

impl FromStr for Endpoint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('.') {
            Some((component, variable)) if !component.is_empty() && !variable.is_empty() => {
                Ok(Endpoint { component: component.to_owned(), variable: variable.to_owned() })
            }
            _ => Err(format!("found `{text}`, expected COMPONENT.VARIABLE")),
        }
    }
}

impl fmt::Display for Endpoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.component, self.variable)
    }
}

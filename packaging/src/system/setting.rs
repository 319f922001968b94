//! Start values of parameters and inputs.

use super::check::{described, feeder, variable};
use super::error::Misfit;
use super::{Component, Connection, ConnectionError, Endpoint, SystemError};
use crate::model_description::VariableType;

/// A start value, checked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setting {
    pub at: Endpoint,
    pub kind: VariableType,
    /// As XML Schema writes it.
    pub value: String,
}

/// The settings of the components, in the given order.
pub(super) fn settings(
    components: &[Component],
    wanted: &[(Endpoint, String)],
    connections: &[Connection],
) -> Result<Vec<Setting>, SystemError> {
    let (mut settings, mut misfits): (Vec<Setting>, _) = (Vec::new(), Vec::new());
    for (at, value) in wanted {
        let is_taken = feeder(connections, at).is_some() || settings.iter().any(|other| other.at == *at);
        match setting(components, at, value, is_taken) {
            Ok(setting) => settings.push(setting),
            Err(error) => misfits.push(Misfit { given: format!("{at}={value}"), error }),
        }
    }
    if misfits.is_empty() { Ok(settings) } else { Err(SystemError::Misfits(misfits)) }
}

fn setting(
    components: &[Component],
    at: &Endpoint,
    value: &str,
    is_taken: bool,
) -> Result<Setting, ConnectionError> {
    let variable = variable(components, at)?;
    if is_taken || !matches!(variable.causality.as_str(), "parameter" | "input") {
        let state = if is_taken { ", which is connected or set already" } else { "" };
        return Err(ConnectionError::NotSettable { found: described(at, variable) + state });
    }
    let number = value.parse::<f64>().is_ok_and(f64::is_finite);
    let (fits, allowed) = match variable.kind {
        VariableType::Real => (number, "a finite number is allowed"),
        VariableType::Integer => (value.parse::<i32>().is_ok(), "an integer of 32 bits is allowed"),
        VariableType::Boolean => (matches!(value, "true" | "false"), "`true` and `false` are allowed"),
        VariableType::String => (true, "any text is allowed"),
        VariableType::Enumeration => {
            (false, "enumerations cannot be set here: libcosim does not load systems that do")
        }
    };
    if !fits {
        return Err(ConnectionError::Value { found: value.to_owned(), allowed });
    }
    Ok(Setting { at: at.clone(), kind: variable.kind, value: value.to_owned() })
}

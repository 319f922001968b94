//! Start values of parameters and inputs.

use flexible_aircraft::variables::{instead_of_degrees, probably_meant};

use super::check::{component, described, feeder, variable};
use super::component::Component;
use super::connection::Connection;
use super::endpoint::Endpoint;
use super::error::{ConnectionError, Misfit, SystemError};
use crate::model_description::{Variable, VariableType};

/// A start value, checked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setting {
    pub at: Endpoint,
    pub kind: VariableType,
    /// As XML Schema writes it; of an enumeration the name of the item.
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
    if let Some(dimensions) = component(components, at)?.description.dimensions(variable) {
        return Err(ConnectionError::Array { found: described(at, variable), dimensions });
    }
    let refused = |allowed: String| ConnectionError::Value { found: value.to_owned(), allowed };
    let angle = value.parse().ok().filter(|_| is_surface(components, at, variable));
    if let Some(allowed) = angle.and_then(instead_of_degrees) {
        return Err(refused(format!("allowed is {allowed}")));
    }
    let value =
        checked(variable, value).ok_or_else(|| refused(allowed(variable) + &meant(variable, value)))?;
    Ok(Setting { at: at.clone(), kind: variable.kind, value })
}

/// Whether a variable is the angle of a control surface, whose position is an output then, as of a packaged aircraft.
fn is_surface(components: &[Component], at: &Endpoint, variable: &Variable) -> bool {
    let position = Endpoint { variable: format!("surface.{}", at.variable), ..at.clone() };
    let has_position =
        self::variable(components, &position).is_ok_and(|position| position.causality == "output");
    variable.causality == "input" && variable.unit == "rad" && has_position
}

/// The item of an enumeration that was probably meant, to be put behind a message.
fn meant(variable: &Variable, value: &str) -> String {
    let names = variable.items.iter().map(|(name, _)| name.as_str());
    probably_meant(value, names).map_or(String::new(), |name| format!(", did you mean `{name}`?"))
}

/// The value as XML Schema writes it, if the variable can have it.
fn checked(variable: &Variable, value: &str) -> Option<String> {
    let fits = match variable.kind {
        VariableType::Boolean => matches!(value, "true" | "false"),
        VariableType::String => true,
        VariableType::Binary | VariableType::Clock => false,
        VariableType::Enumeration => {
            let is_meant =
                |(name, number): &&(String, String)| name.eq_ignore_ascii_case(value) || number == value;
            return variable.items.iter().find(is_meant).map(|(name, _)| name.clone());
        }
        kind => match kind.integers() {
            Some(([least, most], _)) => value
                .parse::<i128>()
                .is_ok_and(|number| (least..=most).contains(&number) && is_within(variable, number as f64)),
            None => value.parse().is_ok_and(|number| is_within(variable, number)),
        },
    };
    fits.then(|| value.to_owned())
}

/// Whether a number is finite and within the limits that the variable has.
fn is_within(variable: &Variable, number: f64) -> bool {
    let limit = |text: &str| text.trim().parse::<f64>().ok();
    number.is_finite()
        && limit(&variable.min).is_none_or(|min| number >= min)
        && limit(&variable.max).is_none_or(|max| number <= max)
}

/// What [`checked`] accepts, for people.
fn allowed(variable: &Variable) -> String {
    let of = match variable.kind {
        VariableType::Boolean => return "`true` and `false` are allowed".to_owned(),
        VariableType::String => return "any text is allowed".to_owned(),
        VariableType::Enumeration => {
            let items: Vec<String> =
                variable.items.iter().map(|(name, number)| format!("{number} ({name})")).collect();
            return format!("allowed is {}", items.join(", "));
        }
        VariableType::Binary | VariableType::Clock => return "no value can be given here".to_owned(),
        kind => match kind.integers() {
            Some(([0, _], bits)) => format!("an integer of {bits} bits, 0 or more"),
            Some((_, bits)) => format!("an integer of {bits} bits"),
            None => "a finite number".to_owned(),
        },
    };
    let (unit, in_unit) = match variable.unit.as_str() {
        "" | "1" => (String::new(), String::new()),
        unit => (format!(" {unit}"), format!(" in {unit}")),
    };
    match (variable.min.as_str(), variable.max.as_str()) {
        ("", "") => format!("{of}{in_unit} is allowed"),
        (min, "") => format!("allowed is {min}{unit} and above"),
        ("", max) => format!("allowed is {max}{unit} and below"),
        (min, max) if min == max => format!("allowed is {min}{unit}"),
        (min, max) => format!("allowed is {min} to {max}{unit}"),
    }
}

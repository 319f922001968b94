//! Where the parameters of an FMU start, if not where those of its aircraft do: what `package --set` wrote.
//!
//! A text file among the resources, a line `name = number` for each parameter that starts elsewhere, in the order of the
//! table; of an enumeration the number of the item, of a Boolean `true` or `false`.

use crate::flight::Settings;
use crate::structure::ReducedModel;
use crate::variables::{Slot, Type, Value, Variable, VariableTable, usual_starts};

use super::interface::Interface;

/// Name of the file in the FMU's `resources/`; it is not there where all parameters start as the aircraft's.
pub const STARTS_FILE: &str = "starts.txt";

/// A line that does not say where a parameter of this aircraft starts.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: found `{found}`, allowed is {allowed}")]
pub struct StartsError {
    /// From 1.
    pub line: usize,
    /// The line.
    pub found: String,
    /// For people.
    pub allowed: String,
}

/// Where those of an FMU start unless someone says otherwise.
pub fn usual(interface: Interface, model: &ReducedModel) -> Settings {
    usual_starts(model, interface.extent())
}

/// The file; `None` where nothing starts elsewhere.
pub fn write(interface: Interface, model: &ReducedModel, starts: &Settings) -> Option<String> {
    let usual = usual(interface, model);
    let line = |variable: &Variable| {
        let Slot::Parameter(slot) = variable.slot else { return None };
        let value = slot.get(starts);
        (value != slot.get(&usual)).then(|| format!("{} = {}\n", variable.name, text(value)))
    };
    let table = VariableTable::new(model);
    let lines: String = table.iter().filter_map(|(_, variable)| line(variable)).collect();
    (!lines.is_empty()).then_some(lines)
}

/// Where the parameters of an aircraft start that a file of its FMU says.
///
/// # Errors
/// At the first line that says no value of a parameter that it may have.
pub fn read(text: &str, interface: Interface, model: &ReducedModel) -> Result<Settings, StartsError> {
    let (table, mut settings) = (VariableTable::new(model), usual(interface, model));
    for (line, found) in (1..).zip(text.lines()) {
        let refuse = |allowed: String| StartsError { line, found: found.to_owned(), allowed };
        let parts = found.split_once(" = ");
        let variable = parts.and_then(|(name, value)| Some((table.named(name)?, value)));
        let Some((variable, value)) = variable else {
            return Err(refuse("`name = number` of a parameter".to_owned()));
        };
        let Slot::Parameter(slot) = variable.slot else {
            return Err(refuse("`name = number` of a parameter".to_owned()));
        };
        let value = parse(variable.kind, value).filter(|value| variable.allows(*value));
        slot.set(&mut settings, value.ok_or_else(|| refuse(variable.allowed()))?);
    }
    Ok(settings)
}

/// With as many digits as it takes to read the same number again.
fn text(value: Value) -> String {
    match value {
        Value::Real(x) => format!("{x:?}"),
        Value::Integer(i) => i.to_string(),
        Value::Boolean(flag) => flag.to_string(),
    }
}

fn parse(kind: Type, text: &str) -> Option<Value> {
    match kind {
        Type::Real => text.parse().ok().map(Value::Real),
        Type::Integer | Type::Enumeration(_) => text.parse().ok().map(Value::Integer),
        Type::Boolean => text.parse().ok().map(Value::Boolean),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::GustShape;
    use crate::structure::test_jet::jet;

    #[test]
    fn what_is_written_is_read_again_and_what_is_usual_is_not_written() {
        let usual = Settings::of(jet());
        assert_eq!(write(Interface::USUAL, jet(), &usual), None);
        let mut starts = usual.clone();
        starts.gust.shape = GustShape::OneMinusCosine;
        (starts.gust.gradient, starts.tolerance, starts.sensors.enabled) = (1.0 / 3.0, 1e-3, true);
        let text = write(Interface::USUAL, jet(), &starts).unwrap();
        assert_eq!(
            text,
            "tolerance = 0.001\nsensor.enabled = true\ngust.shape = 2\ngust.gradient = 0.3333333333333333\n"
        );
        assert_eq!(read(&text, Interface::USUAL, jet()), Ok(starts));
        assert_eq!(read("", Interface::USUAL, jet()), Ok(usual));
    }

    #[test]
    fn a_line_that_says_no_start_is_refused_with_what_is_allowed() {
        let refused = |text: &str| read(text, Interface::USUAL, jet()).unwrap_err().to_string();
        assert_eq!(
            refused("airspeed = 100.0\nairspeed = 1e9"),
            "line 2: found `airspeed = 1e9`, allowed is 1 to 400 m/s"
        );
        for line in ["nothing = 1", "elevator = 0.1", "attitude.pitch = 1", "airspeed"] {
            assert!(refused(line).ends_with("allowed is `name = number` of a parameter"), "{line}");
        }
        assert!(refused("model = 9").contains("6 (geometrically_exact)"));
        assert!(refused("sensor.enabled = 1").ends_with("allowed is true or false"));
    }
}

//! Parameters of the FMU, given as text.

use flexible_aircraft::simulation::Settings;
use flexible_aircraft::variables::{Slot, Type, Value, Variable, VariableTable};

/// What is wrong with an assignment.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{assignment}: found `{found}`, allowed is {allowed}")]
pub struct Mistake {
    assignment: String,
    found: String,
    allowed: String,
}

/// Carries out an assignment like `stiffness_scale=0.1` or `model=rigid`.
///
/// # Errors
/// When there is no such parameter, or its values are others.
pub fn set(assignment: &str, variables: &VariableTable, settings: &mut Settings) -> Result<(), Mistake> {
    let mistake = |found: &str, allowed: String| {
        let (assignment, found) = (assignment.to_owned(), found.to_owned());
        Mistake { assignment, found, allowed }
    };
    let (name, text) =
        assignment.split_once('=').ok_or_else(|| mistake(assignment, "NAME=VALUE".to_owned()))?;
    let parameters = variables.iter().filter_map(|(_, variable)| match variable.slot {
        Slot::Parameter(slot) => Some((variable, slot)),
        _ => None,
    });
    let parameters: Vec<_> = parameters.collect();
    let Some((variable, slot)) = parameters.iter().find(|(variable, _)| variable.name == name) else {
        let names: Vec<&str> = parameters.iter().map(|(variable, _)| variable.name.as_str()).collect();
        return Err(mistake(name, names.join(", ")));
    };
    let value = value(variable, text).filter(|value| variable.allows(*value));
    slot.set(settings, value.ok_or_else(|| mistake(text, variable.allowed()))?);
    Ok(())
}

/// A number, or the name of an enumeration's item.
fn value(variable: &Variable, text: &str) -> Option<Value> {
    match variable.kind {
        Type::Real => text.parse().ok().map(Value::Real),
        Type::Integer => text.parse().ok().map(Value::Integer),
        Type::Enumeration(enumeration) => {
            let item = (1..).zip(enumeration.items()).find(|(_, (item, _))| *item == text);
            item.map(|(number, _)| number).or(text.parse().ok()).map(Value::Integer)
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::simulation::Fidelity;
    use flexible_aircraft::structure::ReducedModel;

    use super::*;

    fn variables() -> (VariableTable, Settings) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
        let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap();
        (VariableTable::new(&model), Settings::of(&model))
    }

    #[test]
    fn numbers_and_items_become_settings() {
        let (variables, mut settings) = variables();
        for assignment in ["model=rigid", "stiffness_scale=0.1", "mode_count=2", "mode_family=2"] {
            set(assignment, &variables, &mut settings).unwrap();
        }
        assert_eq!((settings.fidelity, settings.stiffness_scale), (Fidelity::Rigid, 0.1));
        assert_eq!(settings.mode_count, 2);
    }

    #[test]
    fn a_wrong_assignment_is_told_what_is_allowed() {
        let (variables, mut settings) = variables();
        let cases = [
            ("model", "model: found `model`, allowed is NAME=VALUE"),
            ("elevator=1", "elevator=1: found `elevator`, allowed is "),
            (
                "model=stiff",
                "model=stiff: found `stiff`, allowed is 1 (exact), 2 (consistently_linearised), ",
            ),
            ("model=6", "model=6: found `6`, allowed is 1 (exact), "),
            ("airspeed=fast", "airspeed=fast: found `fast`, allowed is 1 to 400"),
            ("airspeed=NaN", "airspeed=NaN: found `NaN`, allowed is 1 to 400"),
        ];
        for (assignment, expected) in cases {
            let mistake = set(assignment, &variables, &mut settings).unwrap_err().to_string();
            assert!(mistake.starts_with(expected), "{mistake}");
        }
    }
}

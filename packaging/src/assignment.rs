//! Parameters of the FMU, given as text: `NAME=VALUE`.

use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::ModeSelection;
use flexible_aircraft::structure::{Mode, ModeCount, ModeFamily, ReducedModel};
use flexible_aircraft::variables::{
    ParameterSlot, Slot, Type, Value, Variable, VariableTable, probably_meant,
};

/// What is wrong with an assignment.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[expect(missing_docs, reason = "the messages say it")]
pub enum Mistake {
    #[error("{0}: allowed is NAME=VALUE")]
    Form(String),
    #[error("{assignment}: there is no parameter `{name}`{}; there are {known}", did_you_mean(.meant))]
    Unknown { assignment: String, name: String, meant: Option<String>, known: String },
    #[error(
        "{assignment}: `{name}` is an input and no parameter: it has no start, but a course over time, as a column of that name in \
         the INPUTS of `flexair simulate` or `flexair loads`"
    )]
    Input { assignment: String, name: String },
    #[error("{assignment}: `{name}` is an output: it is computed, not set")]
    Output { assignment: String, name: String },
    #[error("{assignment}: found `{found}`, allowed is {allowed}{}", did_you_mean(.meant))]
    Value { assignment: String, found: String, meant: Option<String>, allowed: String },
    #[error("{second}: `{name}` was set before, by {first}")]
    Twice { name: String, first: String, second: String },
}

/// The name that was probably meant, as a question to be put behind a message.
pub fn did_you_mean(name: &Option<String>) -> String {
    name.as_ref().map_or(String::new(), |name| format!(", did you mean `{name}`?"))
}

/// The settings of a model after assignments like `stiffness_scale=0.1` or `model=rigid`, each parameter once. Unless
/// `mode_count` is among them, all modes fly that were asked of the reduction, or the usual number where none were; of the
/// symmetric family no more than there are.
///
/// # Errors
/// At the first one that names no parameter, or a value that it cannot have.
pub fn settings(
    assignments: &[String],
    variables: &VariableTable,
    model: &ReducedModel,
    reduced_to: ModeCount,
) -> Result<Settings, Mistake> {
    let mut settings = Settings::of(model);
    if let ModeCount::Asked(_) = reduced_to {
        settings.plant.mode_count = model.natural_modes();
    }
    set_all(assignments, variables, &mut settings)?;
    let is_asked_for = assignments.iter().any(|assignment| name(assignment) == "mode_count");
    if !is_asked_for && settings.plant.mode_selection == ModeSelection::Symmetric {
        let is_counted = |mode: &&Mode| !mode.of_loads && mode.family == ModeFamily::Symmetric;
        let symmetric = model.modes.iter().filter(is_counted).count();
        settings.plant.mode_count = settings.plant.mode_count.min(symmetric);
    }
    Ok(settings)
}

/// What an assignment is to.
fn name(assignment: &str) -> &str {
    assignment.split('=').next().unwrap_or_default()
}

fn set_all(
    assignments: &[String],
    variables: &VariableTable,
    settings: &mut Settings,
) -> Result<(), Mistake> {
    for (index, second) in assignments.iter().enumerate() {
        set(second, variables, settings)?;
        if let Some(first) = assignments[..index].iter().find(|first| name(first) == name(second)) {
            let name = name(second).to_owned();
            return Err(Mistake::Twice { name, first: first.clone(), second: second.clone() });
        }
    }
    Ok(())
}

fn set(assignment: &str, variables: &VariableTable, settings: &mut Settings) -> Result<(), Mistake> {
    let Some((name, text)) = assignment.split_once('=') else {
        return Err(Mistake::Form(assignment.to_owned()));
    };
    let (variable, slot) = parameter(assignment, name, variables)?;
    let value = value(variable, text).filter(|value| variable.allows(*value));
    let value = value.ok_or_else(|| Mistake::Value {
        assignment: assignment.to_owned(),
        found: text.to_owned(),
        meant: meant(variable, text),
        allowed: variable.allowed(),
    })?;
    slot.set(settings, value);
    Ok(())
}

/// The parameter of a name.
fn parameter<'v>(
    assignment: &str,
    name: &str,
    variables: &'v VariableTable,
) -> Result<(&'v Variable, ParameterSlot), Mistake> {
    let assignment = assignment.to_owned();
    let found = variables.iter().find(|(_, variable)| variable.name == name);
    match found.map(|(_, variable)| (variable, variable.slot)) {
        Some((variable, Slot::Parameter(slot))) => Ok((variable, slot)),
        Some((_, Slot::Input(_))) => Err(Mistake::Input { assignment, name: name.to_owned() }),
        Some((_, Slot::Output(_))) => Err(Mistake::Output { assignment, name: name.to_owned() }),
        None => {
            let parameters =
                variables.iter().filter(|(_, variable)| matches!(variable.slot, Slot::Parameter(_)));
            let known: Vec<&str> = parameters.map(|(_, variable)| variable.name.as_str()).collect();
            Err(Mistake::Unknown {
                assignment,
                name: name.to_owned(),
                meant: probably_meant(name, known.iter().copied()).map(str::to_owned),
                known: known.join(", "),
            })
        }
    }
}

/// The item of an enumeration that was probably meant.
fn meant(variable: &Variable, text: &str) -> Option<String> {
    let Type::Enumeration(enumeration) = variable.kind else { return None };
    probably_meant(text, enumeration.items().iter().map(|(item, _)| *item)).map(str::to_owned)
}

/// A number, the name of an enumeration's item or a truth value, names in any case.
fn value(variable: &Variable, text: &str) -> Option<Value> {
    match variable.kind {
        Type::Real => text.parse().ok().map(Value::Real),
        Type::Integer => text.parse().ok().map(Value::Integer),
        Type::Boolean => text.to_lowercase().parse().ok().map(Value::Boolean),
        Type::Enumeration(enumeration) => {
            let mut items = (1..).zip(enumeration.items());
            let item = items.find(|(_, (item, _))| item.eq_ignore_ascii_case(text));
            item.map(|(number, _)| number).or(text.parse().ok()).map(Value::Integer)
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::equations::Fidelity;

    use super::*;

    /// Nobody asked for a number of modes.
    const USUAL: ModeCount = ModeCount::Usual(ReducedModel::USUAL_MODES);

    fn set(assignments: &[&str]) -> Result<Settings, String> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
        let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap();
        let variables = VariableTable::new(&model);
        let assignments: Vec<String> = assignments.iter().map(ToString::to_string).collect();
        settings(&assignments, &variables, &model, USUAL).map_err(|mistake| mistake.to_string())
    }

    #[test]
    fn numbers_and_items_in_any_case_become_settings() {
        let settings = set(&["model=Rigid", "stiffness_scale=0.1", "mode_count=2", "mode_family=2"]).unwrap();
        assert_eq!((settings.plant.fidelity, settings.plant.stiffness_scale), (Fidelity::Rigid, 0.1));
        assert_eq!(settings.plant.mode_count, 2);
    }

    #[test]
    fn a_wrong_assignment_is_told_what_is_allowed_with_its_unit() {
        let cases = [
            ("model", "model: allowed is NAME=VALUE"),
            (
                "elevator=1",
                "elevator=1: `elevator` is an input and no parameter: it has no start, but a course over time, as a column of that \
                 name in the INPUTS of `flexair simulate` or `flexair loads`",
            ),
            ("trim.pitch=1", "trim.pitch=1: `trim.pitch` is an output"),
            (
                "stifness_scale=1",
                "stifness_scale=1: there is no parameter `stifness_scale`, did you mean `stiffness_scale`?; there are ",
            ),
            ("flap=1", "flap=1: there is no parameter `flap`; there are input_reference, model, airspeed, "),
            (
                "model=stiff",
                "model=stiff: found `stiff`, allowed is 1 (exact), 2 (consistently_linearised), ",
            ),
            (
                "model=rigit",
                "model=rigit: found `rigit`, allowed is 1 (exact), 2 (consistently_linearised), 3 (inconsistent), 4 (ruthlessly_linearised), 5 (rigid), 6 (geometrically_exact), did you mean `rigid`?",
            ),
            ("model=7", "model=7: found `7`, allowed is 1 (exact), "),
            ("airspeed=fast", "airspeed=fast: found `fast`, allowed is 1 to 400 m/s"),
            ("airspeed=NaN", "airspeed=NaN: found `NaN`, allowed is 1 to 400 m/s"),
            ("altitude=25000", "altitude=25000: found `25000`, allowed is -1000 to 20000 m"),
            ("heading=north", "heading=north: found `north`, allowed is any finite number, in rad"),
        ];
        for (assignment, expected) in cases {
            let mistake = set(&[assignment]).unwrap_err();
            assert!(mistake.starts_with(expected), "{mistake}");
        }
    }

    /// The jet's first 12 modes are of both families.
    #[test]
    fn the_usual_number_of_modes_is_no_more_than_the_family_has() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 12).unwrap();
        let variables = VariableTable::new(&model);
        let of = |assignments: &[&str]| {
            let assignments: Vec<String> = assignments.iter().map(ToString::to_string).collect();
            settings(&assignments, &variables, &model, USUAL).unwrap()
        };
        let symmetric = of(&["mode_family=symmetric"]);
        assert!((1..12).contains(&symmetric.plant.mode_count), "{}", symmetric.plant.mode_count);
        assert_eq!(symmetric.plant.choose_modes(&model).unwrap().len(), symmetric.plant.mode_count);
        assert_eq!(of(&[]).plant.mode_count, 12);
        // What was asked for is not changed in silence.
        let asked = of(&["mode_count=12", "mode_family=symmetric"]);
        assert!(
            asked.plant.choose_modes(&model).unwrap_err().to_string().starts_with("mode_count: found 12")
        );
    }

    #[test]
    fn all_modes_fly_that_were_asked_for_and_the_usual_number_where_none_were() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let model = ReducedModel::new(&Aircraft::read(&path).unwrap(), 24).unwrap();
        let variables = VariableTable::new(&model);
        let flown = |assignment: &[&str], reduced_to| {
            let assignments: Vec<String> = assignment.iter().map(ToString::to_string).collect();
            let settings = settings(&assignments, &variables, &model, reduced_to).unwrap();
            settings.plant.choose_modes(&model).unwrap().len()
        };
        assert_eq!([flown(&[], ModeCount::Asked(24)), flown(&[], USUAL)], [24, 12]);
        assert_eq!(flown(&["mode_count=8"], ModeCount::Asked(24)), 8);
        let symmetric = model.modes.iter().filter(|mode| mode.family == ModeFamily::Symmetric).count();
        assert_eq!(flown(&["mode_family=symmetric"], ModeCount::Asked(24)), symmetric);
    }

    #[test]
    fn load_modes_are_switched_by_true_and_false_in_any_case_where_there_are_some() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
        let wing = Aircraft::read(&path).unwrap();
        let set = |load_modes, assignment: &str| {
            let model = ReducedModel::new(&Aircraft { load_modes, ..wing.clone() }, 2).unwrap();
            settings(&[assignment.to_owned()], &VariableTable::new(&model), &model, USUAL)
        };
        assert!(!set(true, "load_modes=false").unwrap().plant.load_modes);
        assert!(set(true, "load_modes=True").unwrap().plant.load_modes);
        let mistake = set(true, "load_modes=1").unwrap_err().to_string();
        assert_eq!(mistake, "load_modes=1: found `1`, allowed is true or false");
        let mistake = set(false, "load_modes=true").unwrap_err().to_string();
        assert!(mistake.starts_with("load_modes=true: there is no parameter `load_modes`"), "{mistake}");
    }

    #[test]
    fn a_parameter_is_set_once() {
        let mistake = set(&["airspeed=100", "model=rigid", "airspeed=120"]).unwrap_err();
        assert_eq!(mistake, "airspeed=120: `airspeed` was set before, by airspeed=100");
    }
}

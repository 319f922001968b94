//! Parameters of the FMU, given as text: `NAME=VALUE`.

use flexible_aircraft::flight::Settings;
use flexible_aircraft::fmi::{self, Interface, Kind};
use flexible_aircraft::plant::ModeSelection;
use flexible_aircraft::structure::{Mode, ModeCount, ModeFamily, ReducedModel};
use flexible_aircraft::variables::{
    ArchiveTable, ParameterSlot, Slot, Type, Value, Variable, VariableTable, probably_meant,
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
    #[error(
        "{assignment}: `{name}` belongs to co-simulation: a model exchange FMU has no such parameter, its importer integrates"
    )]
    CoSimulationAlone { assignment: String, name: String },
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

/// Where the parameters of an FMU start after assignments: as [`settings`], and of model exchange from what is usual there.
///
/// # Errors
/// As [`settings`], and at one to a parameter that FMUs of this kind have not.
pub fn starts(
    assignments: &[String],
    interface: Interface,
    model: &ReducedModel,
) -> Result<Settings, Mistake> {
    let variables = VariableTable::new(model);
    refuse_missing(assignments, interface, model)?;
    if interface.kind == Kind::ModelExchange && model.has_load_modes() {
        // All natural modes are to take part, whatever the family.
        let mut starts = fmi::starts::usual(interface, model);
        set_all(assignments, &variables, &mut starts)?;
        return Ok(starts);
    }
    settings(assignments, &variables, model, ModeCount::Usual(model.natural_modes()))
}

/// Refuses what is no parameter of such an FMU, though of another one.
fn refuse_missing(assignments: &[String], interface: Interface, model: &ReducedModel) -> Result<(), Mistake> {
    let usual = fmi::starts::usual(interface, model);
    let (all, its) = (VariableTable::new(model), ArchiveTable::new(model, &usual, interface.extent()));
    let is_missing = |name: &str| all.reference(name).is_some_and(|reference| its.get(reference).is_none());
    match assignments.iter().find(|assignment| is_missing(name(assignment))) {
        Some(assignment) => {
            let name = name(assignment).to_owned();
            Err(Mistake::CoSimulationAlone { assignment: assignment.clone(), name })
        }
        None => Ok(()),
    }
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
mod tests;

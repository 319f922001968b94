//! The columns of a sweep's table, and what is done to fill them.

use std::sync::Arc;

use flexible_aircraft::LinearModel;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{OutputSlot, Slot, Type, VariableTable, nearest, probably_meant};

use super::document::{Mistakes, Place};
use super::file::{Flown, Keep, Run, SweepFile};
use super::job::{Flight, Job};
use super::linear::{LinearKept, Part, unit};
use super::reduction::Reduction;
use crate::simulate::schedule::Schedule;
use crate::watched::{Watched, is_part};

/// More looks at one flight than anybody needs: hours in steps of 10 ms.
const MOST_LOOKS: f64 = 1e6;

/// A column of numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    pub name: String,
    /// 1 of what has none; empty where FMI has no name for it.
    pub unit: String,
}

/// A column and what of the file it comes from.
type Placed = (Column, Place);

/// What is done at each point, and the columns of what is kept.
pub fn job(file: &SweepFile, variables: &VariableTable, mistakes: &Mistakes) -> Option<(Job, Vec<Column>)> {
    let (job, columns) = match &file.run {
        Run::Trim => {
            let (outputs, columns) = of_trim(&file.keep, variables, mistakes);
            (Some(Job::Trim(outputs)), columns)
        }
        Run::Fly(flown) => {
            let (outputs, kept, columns) = of_flight(&file.keep, variables, mistakes);
            let flight = schedule(flown, variables, mistakes).map(|schedule| Flight {
                schedule,
                step: flown.step,
                is_gust: flown.is_gust,
                outputs,
                kept,
            });
            (flight.map(Job::Fly), columns)
        }
        Run::Linearise(inflow) => {
            let (kept, columns) = of_linear(&file.keep);
            (Some(Job::Linearise(*inflow, kept)), columns)
        }
    };
    refuse_repetitions(&columns, mistakes);
    Some((job?, columns.into_iter().map(|(column, _)| column).collect()))
}

/// Inputs over time.
fn schedule(flown: &Flown, variables: &VariableTable, mistakes: &Mistakes) -> Option<Schedule> {
    let mut schedule = Schedule::hands_off(flown.duration);
    let looks = schedule.point_count(Some(flown.step));
    if looks > MOST_LOOKS {
        let found = format!("found a duration and a step that make {looks:.0} looks at each flight");
        mistakes.add(&flown.place, found, format!("allowed are {MOST_LOOKS} at most"));
        return None;
    }
    for (input, place) in &flown.inputs {
        match input.add_to(schedule, variables, flown.step) {
            Ok(more) => schedule = more,
            Err(error) => {
                mistakes.add_said(place, &error.to_string());
                return None;
            }
        }
    }
    Some(schedule)
}

/// The outputs of a trim, and their columns.
fn of_trim(keep: &[Keep], variables: &VariableTable, mistakes: &Mistakes) -> (Vec<OutputSlot>, Vec<Placed>) {
    let real = variables.iter().map(|(_, variable)| variable).filter_map(|variable| match variable.slot {
        Slot::Output(slot) if variable.kind == Type::Real => {
            Some(Watched { name: variable.name.clone(), unit: super::names::unit(variable), slot })
        }
        _ => None,
    });
    let all: Vec<Watched> = real.collect();
    let mut found = (Vec::new(), Vec::new());
    for kept in keep {
        let Keep::Output { name, place, .. } = kept else { continue };
        for output in outputs(name, place, &all, mistakes) {
            found.0.push(output.slot);
            found.1.push((Column { name: output.name.clone(), unit: output.unit.clone() }, place.clone()));
        }
    }
    found
}

/// The outputs of flights that are looked at, what becomes of which, and their columns.
fn of_flight(
    keep: &[Keep],
    variables: &VariableTable,
    mistakes: &Mistakes,
) -> (Vec<OutputSlot>, Vec<(usize, Reduction)>, Vec<Placed>) {
    let all: Vec<Watched> = Watched::all(variables).collect();
    let (mut watched, mut kept, mut columns) = (Vec::new(), Vec::new(), Vec::new());
    for keep in keep {
        let Keep::Output { name, place, reductions } = keep else { continue };
        for output in outputs(name, place, &all, mistakes) {
            let number = watched.iter().position(|slot| *slot == output.slot).unwrap_or_else(|| {
                watched.push(output.slot);
                watched.len() - 1
            });
            for &reduction in reductions {
                kept.push((number, reduction));
                let name = format!("{}.{}", output.name, reduction.name());
                let of_output = variables.named(&output.name).map(super::names::unit).unwrap_or_default();
                let unit = if reduction == Reduction::TimeOfMax { "s".to_owned() } else { of_output };
                columns.push((Column { name, unit }, place.clone()));
            }
        }
    }
    (watched, kept, columns)
}

/// Those with a name or with it as their first parts.
fn outputs<'a>(name: &str, place: &Place, all: &'a [Watched], mistakes: &Mistakes) -> Vec<&'a Watched> {
    let found: Vec<&Watched> = all.iter().filter(|output| is_part(name, &output.name)).collect();
    if found.is_empty() {
        let known = || all.iter().map(|output| output.name.as_str());
        let allowed = match probably_meant(name, known()) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!(
                "allowed are outputs that are Real, or the first parts of their names: nearest are {}",
                nearest(name, known())
            ),
        };
        mistakes.add(place, format!("there is no output `{name}` here"), allowed);
    }
    found
}

/// Numbers of linear models, and their columns; the units of entries are not known yet.
fn of_linear(keep: &[Keep]) -> (Vec<LinearKept>, Vec<Placed>) {
    let (mut kept, mut columns) = (Vec::new(), Vec::new());
    for keep in keep {
        match keep {
            Keep::Root { number, place } => {
                for (part, end) in [(Part::Real, "re"), (Part::Imaginary, "im")] {
                    kept.push(LinearKept::Root { place: number - 1, part });
                    let name = format!("root[{number}].{end}");
                    columns.push((Column { name, unit: "1/s".to_owned() }, place.clone()));
                }
            }
            Keep::Entry { matrix, row, column, place } => {
                let name = format!("{matrix:?}[{row},{column}]");
                kept.push(LinearKept::Entry { matrix: *matrix, row: row.clone(), column: column.clone() });
                columns.push((Column { name, unit: String::new() }, place.clone()));
            }
            Keep::Output { .. } => {}
        }
    }
    (kept, columns)
}

fn refuse_repetitions(columns: &[Placed], mistakes: &Mistakes) {
    for (number, (column, place)) in columns.iter().enumerate() {
        if columns[..number].iter().any(|(other, _)| other.name == column.name) {
            mistakes.add(place, format!("found `{}` twice", column.name), "allowed is once");
        }
    }
}

/// Names and units of entries by the linear model of some settings, where there is one.
pub fn check_linear(
    columns: &mut [Column],
    job: &Job,
    (model, settings): (&Arc<ReducedModel>, &Settings),
    file: &SweepFile,
    mistakes: &Mistakes,
) {
    let Job::Linearise(inflow, kept) = job else { return };
    let is_entry = |kept: &&LinearKept| matches!(kept, LinearKept::Entry { .. });
    if !kept.iter().any(|kept| is_entry(&kept)) {
        return;
    }
    // Where this point cannot be linearised, others tell.
    let Ok(linear) = LinearModel::new(Arc::clone(model), settings, *inflow) else { return };
    let mut places = file.keep.iter().filter_map(|keep| match keep {
        Keep::Entry { place, .. } => Some(place),
        Keep::Root { .. } | Keep::Output { .. } => None,
    });
    for (column, kept) in columns.iter_mut().zip(kept) {
        let LinearKept::Entry { matrix, row, column: of } = kept else { continue };
        let Some(place) = places.next() else { continue };
        match unit(&linear, *matrix, [row, of]) {
            Ok(unit) => column.unit = unit,
            Err(error) => mistakes.add_said(place, &error.to_string()),
        }
    }
}

//! A sweep file against its aircraft: what all names mean, which points there are, what is done and kept at each.

use std::sync::Arc;

use flexible_aircraft::LinearModel;
use flexible_aircraft::aircraft::{Aircraft, Factor};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft::variables::{Type, VariableTable};
use flexible_aircraft_packaging::assignment;

use super::columns::{self, Column};
use super::document::Mistakes;
use super::file::{Fixed, Law, MOST_POINTS, SweepFile, Varied};
use super::foreseen;
use super::job::{Failure, Job, Success};
use super::models::{self, Key, Models};
use super::names::{Named, Names, unit};
use super::points::{Axis, Points};
use crate::marked::Rejected;
use crate::numbers::Plain;

/// All that is to be done.
pub struct Plan {
    pub varied: Vec<Column>,
    pub kept: Vec<Column>,
    pub points: Points,
    /// Which of the numbers of a point are factors of the aircraft; the others are parameters.
    factors: Vec<bool>,
    models: Models,
    count: ModeCount,
    variables: VariableTable,
    /// As `--set` would have them.
    assignments: Vec<String>,
    job: Job,
}

/// Why there is nothing to be done.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    File(#[from] Rejected),
    #[error(transparent)]
    Structure(#[from] StructureError),
}

impl Plan {
    /// Of a file with a text, for an aircraft.
    ///
    /// # Errors
    /// With all that is wrong in the file, or when the aircraft cannot be reduced.
    pub fn new(
        file: &SweepFile,
        mut aircraft: Aircraft,
        (file_name, text): (&str, &str),
    ) -> Result<Self, Error> {
        let of_factors = Mistakes::default();
        let known = aircraft.factors();
        let is_factor = |name: &str| known.iter().find(|factor| factor.name == name);
        aircraft.load_modes |= file.load_modes;
        for fixed in &file.fixed {
            if let Some(factor) = is_factor(&fixed.name) {
                multiply(&mut aircraft, factor, fixed, &of_factors);
            }
        }
        of_factors.conclude(Some(()), file_name, text)?;
        let mistakes = Mistakes::default();
        let count = ModeCount::asked_or_usual(file.modes, ReducedModel::USUAL_MODES);
        let plain = Arc::new(ReducedModel::new(&aircraft, count)?);
        let variables = VariableTable::new(&plain);
        let names = Names { variables: &variables, factors: &known };
        refuse_repetitions(file, &mistakes);
        let assignments = assignments(file, &names, (&plain, count), &mistakes);
        let (varied, axes): (Vec<Column>, Vec<Axis>) =
            file.varied.iter().filter_map(|varied| axis(varied, &names, &mistakes)).unzip();
        let points = points(axes, file, &mistakes);
        let prepared = columns::job(file, &variables, &mistakes);
        let (points, (job, kept)) = mistakes.conclude(points.zip(prepared), file_name, text)?;
        let chosen = file.varied.iter().filter_map(|varied| is_factor(&varied.name).cloned()).collect();
        let mut plan = Plan {
            varied,
            kept,
            points,
            factors: file.varied.iter().map(|varied| is_factor(&varied.name).is_some()).collect(),
            models: Models::new(aircraft, count, plain, chosen),
            count,
            variables,
            assignments,
            job,
        };
        let mistakes = Mistakes::default();
        if let Ok(settings) = plan.settings(&plan.points.values(0)) {
            columns::check_linear(
                &mut plan.kept,
                &plan.job,
                (&plan.models.plain, &settings),
                file,
                &mistakes,
            );
        }
        foreseen::check_gust(file, &plan.models.plain, &mistakes);
        if let Job::Linearise(inflow, _) = plan.job {
            let states = |numbers: &[f64]| {
                let settings = plan.settings(numbers).ok()?;
                LinearModel::state_count(&plan.models.plain, &settings, inflow).ok()
            };
            foreseen::check_roots(file, &plan.points, states, &mistakes);
        }
        Ok(mistakes.conclude(Some(plan), file_name, text)?)
    }

    /// What tells apart the aircraft of points with these numbers.
    pub fn key(&self, numbers: &[f64]) -> Key {
        models::key(&self.of_aircraft(numbers))
    }

    /// The numbers that are factors.
    fn of_aircraft(&self, numbers: &[f64]) -> Vec<f64> {
        let numbers = numbers.iter().zip(&self.factors).filter(|(_, is_factor)| **is_factor);
        numbers.map(|(number, _)| *number).collect()
    }

    /// The model of points with these numbers.
    pub fn model(&self, numbers: &[f64]) -> Result<Arc<ReducedModel>, Failure> {
        self.models.of(&self.of_aircraft(numbers)).map_err(|error| Failure::invalid(&error))
    }

    /// Does what is to be done at a point with these numbers, of which a model is.
    pub fn run(&self, model: &Arc<ReducedModel>, numbers: &[f64]) -> Result<Success, Failure> {
        self.job.run(model, &self.settings(numbers)?)
    }

    fn settings(&self, numbers: &[f64]) -> Result<Settings, Failure> {
        let parameters =
            self.varied.iter().zip(numbers).zip(&self.factors).filter(|(_, is_factor)| !**is_factor);
        let varied = parameters.map(|((column, number), _)| format!("{}={}", column.name, Plain(*number)));
        let assignments: Vec<String> = self.assignments.iter().cloned().chain(varied).collect();
        assignment::settings(&assignments, &self.variables, &self.models.plain, self.count)
            .map_err(|error| Failure::invalid(&error))
    }
}

/// Multiplies the aircraft by a factor that is the same at all points.
fn multiply(aircraft: &mut Aircraft, factor: &Factor, fixed: &Fixed, mistakes: &Mistakes) {
    match fixed.value.parse::<f64>().map(|by| aircraft.multiply(factor, by)) {
        Ok(Ok(())) => {}
        Ok(Err(error)) => mistakes.add_said(&fixed.place, &error.to_string()),
        Err(_) => {
            mistakes.add(&fixed.place, format!("found `{}`", fixed.value), "allowed is a number, the factor");
        }
    }
}

/// What is set is set once.
fn refuse_repetitions(file: &SweepFile, mistakes: &Mistakes) {
    let fixed = file.fixed.iter().map(|fixed| (&fixed.name, &fixed.place));
    let varied = file.varied.iter().map(|varied| (&varied.name, &varied.place));
    let all: Vec<_> = fixed.chain(varied).collect();
    for (place, (name, at)) in all.iter().enumerate() {
        if all[..place].iter().any(|(other, _)| other == name) {
            mistakes.add(
                at,
                format!("found `{name}` twice"),
                "allowed is once, under [set] or in one [[vary]]",
            );
        }
    }
}

/// The fixed parameters, each of which is allowed by itself; a gust is one where nothing says otherwise.
fn assignments(
    file: &SweepFile,
    names: &Names<'_>,
    (model, count): (&ReducedModel, ModeCount),
    mistakes: &Mistakes,
) -> Vec<String> {
    let mut assignments = Vec::new();
    for Fixed { name, value, place } in &file.fixed {
        let Some(Named::Parameter(_)) = names.find(name, place, mistakes) else { continue };
        let assignment = format!("{name}={value}");
        let alone = assignment::settings(std::slice::from_ref(&assignment), names.variables, model, count);
        if let Err(error) = alone {
            mistakes.add_said(place, &error.to_string());
        }
        assignments.push(assignment);
    }
    let shape = "gust.shape";
    let is_given = file.fixed.iter().any(|fixed| fixed.name == shape)
        || file.varied.iter().any(|varied| varied.name == shape);
    if file.run.is_gust() && !is_given {
        assignments.push(format!("{shape}=one_minus_cosine"));
    }
    assignments
}

/// The column of what varies, and how it does.
fn axis(varied: &Varied, names: &Names<'_>, mistakes: &Mistakes) -> Option<(Column, Axis)> {
    let Varied { name, place, law } = varied;
    let (unit, kind) = match names.find(name, place, mistakes)? {
        Named::Factor => ("1".to_owned(), Type::Real),
        Named::Parameter(variable) => (unit(variable), variable.kind),
    };
    let column = Column { name: name.clone(), unit };
    let refuse = |found: &str, allowed: &str| {
        mistakes.add(place, found, allowed);
        None
    };
    match (law, kind) {
        (Law::Items(items), Type::Enumeration(enumeration)) => {
            let number = |(item, place): &(String, _)| {
                let all = enumeration.items();
                let found = all.iter().position(|(name, _)| name.eq_ignore_ascii_case(item));
                if found.is_none() {
                    let allowed: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
                    mistakes.add(
                        place,
                        format!("found `{item}`"),
                        format!("allowed is {}", allowed.join(", ")),
                    );
                }
                found.map(|place| 1.0 + place as f64)
            };
            let numbers: Option<Vec<f64>> = items.iter().map(number).collect();
            Some((column, Axis::Grid(numbers?)))
        }
        (Law::Items(_), _) => refuse("found texts as values", "allowed are numbers: it is no enumeration"),
        (_, Type::Boolean) => {
            refuse("found a truth value", "allowed is a number; true or false goes under [set]")
        }
        (Law::Axis(axis), Type::Real) => Some((column, axis.clone())),
        (Law::Axis(Axis::Grid(numbers)), _) if numbers.iter().all(|number| number.fract() == 0.0) => {
            Some((column, Axis::Grid(numbers.clone())))
        }
        (Law::Axis(_), _) => {
            refuse("found numbers that are not whole", "allowed are whole numbers, on a grid")
        }
    }
}

fn points(axes: Vec<Axis>, file: &SweepFile, mistakes: &Mistakes) -> Option<Points> {
    let points = Points::new(axes, file.samples, file.seed);
    let points = points.filter(|points| points.count() <= MOST_POINTS);
    if let (None, Some(last)) = (&points, file.varied.last()) {
        let allowed = format!("allowed are {MOST_POINTS} at most");
        mistakes.add(
            &last.place,
            "found too many points: the values of all grids and the samples multiply",
            allowed,
        );
    }
    points
}

//! `flexair loads`: what sections of the airframe carry in a manoeuvre or in gusts: envelopes, in words, plots and numbers.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::{FileError, assignment};

use crate::chart::Chart;
use crate::files::{Drafts, Overwriting, named, refuse_overwriting};
use crate::progress::Progress;
use crate::simulate;
use crate::simulate::schedule::{Mistake, Schedule};
use crate::{diagnostics, terminal, workspace};

mod cases;
mod envelope;
mod plots;
mod report;

use cases::{Case, GustOptions, fly};
use envelope::Envelopes;

/// Options of `flexair loads`.
#[derive(Args)]
pub struct LoadsOptions {
    /// A table of inputs over time, as `flexair simulate` reads it; `-` is standard input [default: nobody touches the
    /// controls]
    #[arg(value_name = "INPUTS")]
    inputs: Option<PathBuf>,

    /// The aircraft file (TOML), with the cuts in question
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    /// How many natural modes to reduce the aircraft to, as in `flexair package` [default: 26, or all where there are
    /// fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Put load modes beside them, also where the aircraft file does not ask for them
    #[arg(long)]
    load_modes: bool,

    /// A parameter of the FMU, as in `model=rigid`. May be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,

    #[command(flatten)]
    gusts: GustOptions,

    /// How long to fly where there are no inputs, s
    #[arg(long, value_name = "SECONDS", value_parser = simulate::step, conflicts_with = "inputs")]
    duration: Option<f64>,

    /// Loads are looked at every so often, s, and at the rows of the inputs
    #[arg(long, value_name = "SECONDS", value_parser = simulate::step, default_value_t = 0.01)]
    step: f64,

    /// Also write the extremes at every node of every component, to a table of their own
    #[arg(long)]
    all_nodes: bool,

    /// Folder for the plots and the tables
    #[arg(long, value_name = "DIR", default_value = "target/loads")]
    output: PathBuf,
}

/// Seconds that are flown without inputs unless the user says otherwise: the longest gust of CS-25 has passed.
const USUAL_DURATION: f64 = 5.0;

/// More looks than anybody needs: hours in steps of 10 ms.
const MOST_POINTS: f64 = 1e6;

/// Why `flexair loads` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error("{}: found no [[cut]], allowed is at least one, or --all-nodes", .0.display())]
    NoCuts(PathBuf),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("--set {0}")]
    Parameter(#[from] assignment::Mistake),
    #[error("{}: {source}", named(path, "standard input"))]
    Inputs { path: PathBuf, source: Mistake },
    #[error(transparent)]
    Unreadable(#[from] simulate::Error),
    #[error(
        "found a step of {step} s, which makes {points:.0} looks at the loads, allowed are {MOST_POINTS} at most"
    )]
    Points { step: f64, points: f64 },
    #[error("{case}: {source}")]
    Flight { case: String, source: Box<SimulationError> },
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

impl Error {
    /// For people, on a terminal.
    pub fn report(&self) -> String {
        match self {
            Error::Aircraft(error) => diagnostics::render(error),
            other => format!("error: {other}"),
        }
    }
}

/// What was flown, and what came out.
pub struct Analysis {
    /// Its cuts are those of the file, then those at all nodes.
    pub model: Arc<ReducedModel>,
    /// How many are those of the file.
    pub named: usize,
    /// Names of what was flown.
    pub cases: Vec<String>,
    pub envelopes: Envelopes,
}

/// Flies, prints, draws, and writes the envelopes.
pub fn run(options: &LoadsOptions) -> Result<(), Error> {
    let aircraft = read(options)?;
    let outputs = outputs(options, &aircraft);
    let inputs = [Some(options.aircraft.as_path()), options.inputs.as_deref()];
    let paths: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&paths, inputs.into_iter().flatten())?;
    let drafts = Drafts::new(paths.iter().copied())?;
    let analysis = analyse(options, &aircraft)?;
    terminal::print(&report::text(&analysis))?;
    let mut contents = vec![report::table(&analysis, 0..analysis.named)];
    if options.all_nodes {
        contents.push(report::table(&analysis, analysis.named..analysis.model.cuts.len()));
    }
    contents.extend(plots::along(&analysis, &aircraft).iter().map(Chart::to_svg));
    contents.extend(plots::bending_over_torsion(&analysis).iter().map(Chart::to_svg));
    drafts.keep(contents.iter().map(String::as_str))?;
    for path in &outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

/// The aircraft, cut where its file says so and at all nodes.
fn read(options: &LoadsOptions) -> Result<Aircraft, Error> {
    let mut aircraft = diagnostics::read_aircraft(&options.aircraft)?;
    aircraft.load_modes |= options.load_modes;
    if aircraft.cuts.is_empty() && !options.all_nodes {
        return Err(Error::NoCuts(options.aircraft.clone()));
    }
    Ok(aircraft)
}

/// All files, in the order of their contents.
fn outputs(options: &LoadsOptions, aircraft: &Aircraft) -> Vec<PathBuf> {
    let name = options.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let tables = ["envelopes.csv", "nodes.csv"].into_iter().take(1 + usize::from(options.all_nodes));
    let mut endings: Vec<String> = tables.map(str::to_owned).collect();
    for component in plots::components(aircraft) {
        endings.extend(plots::ALONG.map(|(quantity, _)| format!("{component}-{quantity}.svg")));
    }
    endings.extend(aircraft.cuts.iter().map(|cut| format!("{}-bending-torsion.svg", cut.name)));
    endings.into_iter().map(|ending| options.output.join(format!("{name}-{ending}"))).collect()
}

fn analyse(options: &LoadsOptions, aircraft: &Aircraft) -> Result<Analysis, Error> {
    let named = aircraft.cuts.len();
    let mut cut = aircraft.clone();
    for component in &aircraft.components {
        cut.cuts.extend(aircraft.cuts_along(&component.name).unwrap_or_default());
    }
    let count = ModeCount::asked_or_usual(options.modes, ReducedModel::USUAL_MODES);
    let model = Arc::new(ReducedModel::new(&cut, count)?);
    let variables = VariableTable::new(&model);
    let settings = assignment::settings(&options.set, &variables, &model, count)?;
    let schedule = schedule(options, &variables)?;
    let points = schedule.point_count(Some(options.step));
    if points > MOST_POINTS {
        return Err(Error::Points { step: options.step, points });
    }
    let cases = options.gusts.cases(&settings);
    let progress = Progress::new(cases.len() * points as usize, "looks at the loads");
    let mut envelopes = Envelopes::new(model.cuts.len(), named);
    for (number, Case { name, settings }) in cases.iter().enumerate() {
        fly(&model, settings, (&schedule, options.step), &progress, |time, loads| {
            envelopes.take(number, time, loads);
        })
        .map_err(|source| Error::Flight { case: name.clone(), source: Box::new(source) })?;
    }
    let cases = cases.into_iter().map(|case| case.name).collect();
    Ok(Analysis { model, named, cases, envelopes })
}

/// What is given over time.
fn schedule(options: &LoadsOptions, variables: &VariableTable) -> Result<Schedule, Error> {
    match &options.inputs {
        Some(path) => Schedule::parse(&simulate::read(path)?, variables)
            .map_err(|source| Error::Inputs { path: path.clone(), source }),
        None => Ok(Schedule::hands_off(options.duration.unwrap_or(USUAL_DURATION))),
    }
}

#[cfg(test)]
mod tests;

//! `flexair loads`: what sections of the airframe carry in a manoeuvre or in gusts: envelopes, in words, plots and numbers.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;

use crate::chart::Chart;
use crate::files::{Drafts, Overwriting, named, refuse_overwriting};
use crate::flown::{self, FlownOptions, seconds, trimmed};
use crate::gust::set::{self, GustSetOptions};
use crate::gust_flights::{Failures, GustFlights, TooManyLooks};
use crate::simulate;
use crate::simulate::schedule::{Mistake, Schedule};
use crate::{terminal, workspace};

mod cases;
mod envelope;
mod plots;
mod report;

use cases::Cases;
use envelope::{Carried, Envelopes};

/// Options of `flexair loads`.
#[derive(Args)]
#[command(
    after_help = "With any of --gradients, --criterion, --peak, --direction and --weights the aircraft flies into gusts, as `flexair gust` has them: \
every gust in both senses, a flight each, and the envelopes are those of all.

Example: the jet through four gusts of CS-25, up and down
  flexair loads --gradients 15,30,60,106.68"
)]
pub struct LoadsOptions {
    /// A table of inputs over time, as `flexair simulate` reads it; `-` is standard input [default: nobody touches the
    /// controls]
    #[arg(value_name = "INPUTS")]
    inputs: Option<PathBuf>,

    /// The aircraft file (TOML), with the cuts in question
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    // There where any of them is given.
    #[command(flatten)]
    gusts: Option<GustSetOptions>,

    /// How long to fly where there are no inputs, s [default: 5]
    #[arg(long, value_name = "SECONDS", value_parser = seconds, conflicts_with = "inputs")]
    duration: Option<f64>,

    /// Loads are looked at every so often, s, and at the rows of the inputs
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value_t = 0.01)]
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

/// Why `flexair loads` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error("{}: found no [[cut]], allowed is at least one, or --all-nodes", .0.display())]
    NoCuts(PathBuf),
    #[error(transparent)]
    Gusts(#[from] set::Error),
    #[error("{}: {source}", named(path, "standard input"))]
    Inputs { path: PathBuf, source: Mistake },
    #[error(transparent)]
    Unreadable(#[from] simulate::Error),
    #[error(transparent)]
    Looks(#[from] TooManyLooks),
    #[error(transparent)]
    Trim(#[from] SimulationError),
    #[error(transparent)]
    Flights(#[from] Failures),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// What was flown, and what came out.
pub struct Analysis {
    /// Its cuts are those of the file, then those at all nodes.
    pub model: Arc<ReducedModel>,
    /// How many are those of the file.
    pub named: usize,
    /// Of all flights but for gradient and direction of a gust.
    pub settings: Settings,
    pub cases: Cases,
    /// What flights that came to their end have carried: at least one.
    pub flights: Vec<Carried>,
    pub envelopes: Envelopes,
    /// The others.
    failures: Option<Failures>,
}

/// Flies, prints, draws, and writes the envelopes; also where some of the gusts cannot be flown.
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
    contents.extend(plots::along(&analysis, &aircraft).iter().map(Chart::to_svg));
    contents.extend(plots::bending_over_torsion(&analysis).iter().map(Chart::to_svg));
    if options.all_nodes {
        contents.push(report::table(&analysis, analysis.named..analysis.model.cuts.len()));
    }
    drafts.keep(contents.iter().map(String::as_str))?;
    for (path, _) in outputs.iter().zip(&contents) {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    analysis.failures.map_or(Ok(()), |failures| Err(failures.into()))
}

/// The aircraft, cut where its file says so and at all nodes.
fn read(options: &LoadsOptions) -> Result<Aircraft, Error> {
    let aircraft = options.flown.read(&options.aircraft)?;
    if aircraft.cuts.is_empty() && !options.all_nodes {
        return Err(Error::NoCuts(options.aircraft.clone()));
    }
    Ok(aircraft)
}

/// All files, in the order of their contents; last what is not always written.
fn outputs(options: &LoadsOptions, aircraft: &Aircraft) -> Vec<PathBuf> {
    let name = options.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let mut endings = vec!["envelopes.csv".to_owned()];
    for component in plots::components(aircraft) {
        endings.extend(plots::ALONG.map(|(quantity, _)| format!("{component}-{quantity}.svg")));
    }
    endings.extend(aircraft.cuts.iter().map(|cut| format!("{}-bending-torsion.svg", cut.name)));
    endings.push("nodes.csv".to_owned());
    endings.into_iter().map(|ending| options.output.join(format!("{name}-{ending}"))).collect()
}

fn analyse(options: &LoadsOptions, aircraft: &Aircraft) -> Result<Analysis, Error> {
    let named = aircraft.cuts.len();
    let mut cut = aircraft.clone();
    for component in &aircraft.components {
        cut.cuts.extend(aircraft.cuts_along(&component.name).unwrap_or_default());
    }
    let model = options.flown.reduce(&cut)?;
    let variables = VariableTable::new(&model);
    let settings = options.flown.settings(&variables, &model)?;
    let schedule = schedule(options, &variables)?;
    let cases = Cases::of(options.gusts.as_ref(), &settings, &options.flown.set, schedule.duration())?;
    let gust_flights = GustFlights::new(&model, &settings, &schedule, options.step);
    gust_flights.check(cases.gusts.len())?;
    trimmed(&model, &settings, schedule.start())?;
    let flown =
        gust_flights.fly(&cases.gusts, |case| Carried::begin(case, model.cuts.len(), named), Carried::look);
    let (flights, failures) = Failures::part(flown, |case| cases.names[case].clone());
    if let Some(failures) = failures.as_ref().filter(|_| flights.is_empty()) {
        return Err(failures.clone().into());
    }
    let envelopes = Envelopes::of_all(&flights);
    Ok(Analysis { model: Arc::clone(&model), named, settings, cases, flights, envelopes, failures })
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

//! `flexair gust`: one 1-cosine gust after the other, the worst of each output [theory: gusts.one-minus-cosine]; or continuous
//! turbulence [theory: gusts.continuous].

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::flown::{self, FlownOptions, seconds, trimmed};
use crate::gust_flights::{Failures, GustFlights, TooManyLooks};
use crate::progress::Audience;
use crate::simulate::schedule::Schedule;
use crate::watched::{NoSuchOutput, Watched, is_part};
use crate::{diagnostics, terminal, workspace};

mod alleviation;
pub mod case;
mod continuous;
mod found;
mod gradients;
mod plot;
mod report;
pub mod set;
mod table;

use case::Case;
use found::{Flown, Found};
use set::GustSetOptions;

/// How the names of the files end that are written: all cases, the worst of them, the plot.
const OUTPUTS: [&str; 3] = ["gusts.csv", "worst.csv", "gusts.svg"];

/// Of continuous turbulence: the table twice, the plot.
const CONTINUOUS_OUTPUTS: [&str; 3] = ["continuous.csv", "continuous.json", "continuous.svg"];

/// How long each gust is flown unless the user says otherwise, and between two looks at the outputs, s.
const USUAL_DURATION: f64 = 10.0;
const USUAL_STEP: f64 = 0.005;

/// Options of `flexair gust`.
#[derive(Args)]
#[command(
    after_help = "Every gust is flown in both senses (upwards and downwards, with --direction 90 to the right and to the left), hands off, from the trim on. \
What it adds to the trim is counted as an increment.

With --continuous nothing is flown: the linear model gives each output's rms in turbulence of 1 m/s (A-bar), von Karman's unless \
--set turbulence.spectrum=dryden, of the scale turbulence.scale, and with U-sigma of CS 25.341(b) the limit loads about the trim.

Examples: the jet through the gusts of CS-25 at its design cruising speed, its loads and load factors; the same in continuous turbulence
  flexair gust --output-names loads,load_factor
  flexair gust --continuous --output-names loads,load_factor"
)]
pub struct GustOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// Continuous turbulence by CS 25.341(b) in place of single gusts, linear about the trim
    #[arg(long)]
    continuous: bool,

    #[command(flatten)]
    gusts: GustSetOptions,

    /// Outputs to watch: names, or the first parts of them, as in `load_factor` [default: loads, load_factor and upward
    /// deflections]
    #[arg(long, value_name = "NAME,NAME,…", value_delimiter = ',')]
    output_names: Vec<String>,

    /// How long each gust is flown, s, from the trim on [default: 10]
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    duration: Option<f64>,

    /// Time between two looks at the outputs, s [default: 0.005]
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    step: Option<f64>,

    /// Folder for the tables and the plot
    #[arg(long, value_name = "DIR", default_value = "target/gust")]
    output: PathBuf,
}

/// Why `flexair gust` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error(transparent)]
    Gusts(#[from] set::Error),
    #[error(transparent)]
    Looks(#[from] TooManyLooks),
    #[error(transparent)]
    Output(#[from] NoSuchOutput),
    #[error(transparent)]
    Trim(#[from] SimulationError),
    #[error(transparent)]
    Flights(#[from] Failures),
    #[error(transparent)]
    Continuous(#[from] continuous::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// Flies all gusts, prints the worst, and writes tables and a plot, also where some of the gusts cannot be flown; or does so with
/// continuous turbulence.
pub fn run(options: &GustOptions) -> Result<(), Error> {
    let file = options.aircraft.as_path();
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let endings = if options.continuous { CONTINUOUS_OUTPUTS } else { OUTPUTS };
    let outputs = endings.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [file])?;
    let drafts = Drafts::new(outputs.iter().map(PathBuf::as_path))?;
    let (written, failures) = if options.continuous {
        let found = options.turbulence()?;
        found.warnings.iter().for_each(|warning| diagnostics::warn(warning));
        (found.written(), None)
    } else {
        let flights = options.fly(&Audience::of_command())?;
        (flights.written(), flights.failures)
    };
    terminal::print(&written.printed)?;
    drafts.keep(&written.files)?;
    for path in &outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    failures.map_or(Ok(()), |failures| Err(failures.into()))
}

/// What is printed, and the files.
struct Written {
    printed: String,
    files: [String; 3],
}

/// What every gust did, or turbulence, as arrays.
pub fn answer(options: &GustOptions, audience: &Audience) -> Result<Answer, Error> {
    if options.continuous {
        return Ok(options.turbulence()?.answer());
    }
    let Flights { watched, found, failures, .. } = options.fly(audience)?;
    Ok(table::answer(&watched, &found, failures.as_ref()))
}

/// All gusts that could be flown, at least one.
struct Flights {
    model: Arc<ReducedModel>,
    settings: Settings,
    watched: Vec<Watched>,
    found: Found,
    failures: Option<Failures>,
    /// That they took.
    seconds: f64,
}

impl Flights {
    fn written(&self) -> Written {
        let Flights { model, settings, watched, found, seconds, .. } = self;
        let files = [
            table::all(watched, found),
            table::worst(watched, found),
            plot::increments(&model.name, watched, found).to_svg(),
        ];
        Written { printed: report::text(model, settings, watched, found, *seconds), files }
    }
}

impl GustOptions {
    /// What turbulence does.
    fn turbulence(&self) -> Result<continuous::Found, Error> {
        set::refuse_times(self.duration, self.step)?;
        let model = self.flown.reduce(&self.flown.read(&self.aircraft)?)?;
        let variables = VariableTable::new(&model);
        let settings = self.flown.settings(&variables, &model)?;
        let (directions, gust) = self.gusts.continuous(&settings, &self.flown.set)?;
        let watched = watched(&self.output_names, &variables)?;
        Ok(continuous::Found::new(model, Settings { gust, ..settings }, &directions, watched)?)
    }

    /// Flies single gusts.
    fn fly(&self, audience: &Audience) -> Result<Flights, Error> {
        let model = self.flown.reduce(&self.flown.read(&self.aircraft)?)?;
        let variables = VariableTable::new(&model);
        let settings = self.flown.settings(&variables, &model)?;
        let duration = self.duration.unwrap_or(USUAL_DURATION);
        let cases = self.gusts.cases(&settings, &self.flown.set, duration)?;
        let watched = watched(&self.output_names, &variables)?;
        let schedule = Schedule::hands_off(duration);
        let step = self.step.unwrap_or(USUAL_STEP);
        let gust_flights = GustFlights::new(&model, &settings, &schedule, step).before(audience);
        gust_flights.check(cases.len())?;
        let trim = found::values(&mut trimmed(&model, &settings, 0.0)?, &watched);
        if let Some(warning) = set::cut_off(&cases, &settings, duration) {
            diagnostics::warn(&warning);
        }
        let began = Instant::now();
        let (flights, failures) = fly(&gust_flights, &cases, &watched);
        let found = Found { trim, flights };
        if let Some(failures) = failures.as_ref().filter(|_| found.flights.is_empty()) {
            return Err(failures.clone().into());
        }
        let seconds = began.elapsed().as_secs_f64();
        Ok(Flights {
            model: Arc::clone(&model),
            settings: settings.clone(),
            watched,
            found,
            failures,
            seconds,
        })
    }
}

/// The outputs of these names; the usual ones where none is named.
fn watched(names: &[String], variables: &VariableTable) -> Result<Vec<Watched>, NoSuchOutput> {
    if names.is_empty() {
        return Ok(Watched::all(variables).filter(|output| is_usual(&output.name)).collect());
    }
    Watched::choose("--output-names", names, variables)
}

fn is_usual(name: &str) -> bool {
    let is_up = name.starts_with("deflection.") && name.ends_with(".up");
    is_up || ["loads", "load_factor"].iter().any(|part| is_part(part, name))
}

/// What each gust did to the watched outputs, and which could not be flown to the end.
fn fly(
    gust_flights: &GustFlights<'_>,
    cases: &[Case],
    watched: &[Watched],
) -> (Vec<Flown>, Option<Failures>) {
    let gusts: Vec<_> = cases.iter().map(|case| case.gust).collect();
    let flown = gust_flights.fly(
        &gusts,
        |number| Flown::begin(cases[number], watched),
        |flown, time, flight| flown.look(time, flight, watched),
    );
    Failures::part(flown, |number| format!("{} ({})", cases[number].name(), cases[number].sense.name()))
}

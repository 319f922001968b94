//! `flexair linearise`: a linear model about a trim, for those who design control laws [theory: linearisation.inputs].

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use flexible_aircraft::LinearContents;
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;
use zip::result::ZipError;

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::flown::{self, FlownOptions};
use crate::numbers::short;
use crate::progress::Audience;
use crate::{axis, diagnostics, limits, terminal, workspace};

mod arrays;
mod balanced;
mod inputs;
mod json;
mod labels;
mod linearised;
mod locus;
mod mat;
pub mod modes;
mod npz;
mod tables;
mod wake;

use inputs::Chosen;
use linearised::Linearised;
use locus::Locus;
use wake::Wake;

/// Options of `flexair linearise`.
#[derive(Args)]
#[command(
    after_help = "x' = A x + B u + Bd u' and y = C x + D u + Dd u' for departures from x0, u0, y0, in SI units and radians. Bd and Dd are those of the wind \
alone, whose rate acts on the apparent mass. The trim is that with which a flight begins: --set airspeed=150, --set condition.manoeuvre=turn. \
x_labels, u_labels and y_labels are the names in letters, digits and _, each once among inputs and outputs.

balanced:N splits off what is slower than 0.25 1/s or grows, which stays exact, and leaves of the rest the states that matter most to the response, all counted \
in N; a bound of the error is printed, and stands in the files as error_bound. The modes are those of the aircraft before. Its states, reduced[i], do not jump with the wind: Bd is 0. For the jet 44 states are right to 3e-3 of each output's largest \
gain from 0.1 to 60 rad/s, with --inputs controls to 1e-4 (36 to 5e-3).

Examples: the jet for Python and MATLAB, in gusts from nose to tail; with 36 states, for a control law; in a turn, with steady aerodynamics
  flexair linearise --format npz,mat --gust-stations 20
  flexair linearise --format mat --inflow balanced:36 --inputs controls
  flexair linearise --set condition.manoeuvre=turn --set condition.bank_angle=0.5 --inflow steady

The modes of the motion are told by name: phugoid, short period, Dutch roll, roll, spiral, elastic 1 and so on by frequency, and over airspeed
  flexair linearise --speed 100:180:17"
)]
pub struct LineariseOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// What becomes of the wake: its states are kept; aerodynamics are steady, as with inflow_states=0; or the whole model is
    /// reduced to so many states by balanced truncation
    #[arg(long, value_name = "keep|steady|balanced:N", default_value_t = Wake::Keep)]
    inflow: Wake,

    /// Add inputs gust_plane[i].up and .right, i from 1 on: a gust at so many planes across the track, equally far apart from the
    /// foremost leading edge to the last trailing edge, linear between them. When each plane meets it is for who gives the inputs
    #[arg(long, value_name = "COUNT", value_parser = gust_stations, default_value_t = 0)]
    gust_stations: usize,

    /// Inputs of the model
    #[arg(long, value_enum, default_value_t = Chosen::All)]
    inputs: Chosen,

    /// Keep position north and east and heading, and how far the air has gone (drift.north, .east, .down), on which nothing
    /// depends: not in a turn
    #[arg(long)]
    all_states: bool,

    /// Follow the modes by their names over these airspeeds, m/s, FROM:TO:COUNT or N,N,…: a table (locus.csv) and root loci
    /// (locus.svg) are written, and no model
    #[arg(long, value_name = "M/S", value_parser = speeds, conflicts_with_all = ["format", "gust_stations", "inputs", "all_states"])]
    speed: Option<LocusSpeeds>,

    /// Formats of the files: JSON, a table for each matrix, NumPy, MATLAB (level 5)
    #[arg(long, value_enum, value_name = "FORMAT,…", value_delimiter = ',', default_value = "json")]
    format: Vec<Format>,

    /// Folder for the files
    #[arg(long, value_name = "DIR", default_value = "target/linear")]
    output: PathBuf,
}

/// A format of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Json,
    Csv,
    Npz,
    Mat,
}

/// Why `flexair linearise` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error(transparent)]
    Trim(#[from] SimulationError),
    #[error(transparent)]
    Balanced(#[from] balanced::Error),
    #[error(
        "--inflow {0}: found with --speed, where allowed are keep and steady: what is reduced has modes of its own"
    )]
    LocusReduced(Wake),
    #[error("cannot write the archive of NumPy: {0}")]
    Archive(#[from] ZipError),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// More planes than this are a slip of the pen.
const MOST_STATIONS: usize = 1000;

fn gust_stations(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count: &usize| *count != 1 && *count <= MOST_STATIONS);
    count.ok_or_else(|| {
        format!("allowed is 0 for none, or 2 to {MOST_STATIONS}: between two planes a gust is linear")
    })
}

/// Linearises, prints the modes, and writes the model, or follows the modes over airspeeds.
pub fn run(options: &LineariseOptions) -> Result<(), Error> {
    match &options.speed {
        Some(LocusSpeeds(airspeeds)) => run_locus(options, airspeeds),
        None => run_model(options),
    }
}

fn run_model(options: &LineariseOptions) -> Result<(), Error> {
    let formats = options.formats();
    let outputs: Vec<PathBuf> = formats.iter().flat_map(|format| options.files(*format)).collect();
    let paths: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&paths, [options.aircraft.as_path()])?;
    let drafts = Drafts::new(paths.iter().copied())?;
    let Linearised { linear, modes, error_bound, told } = options.linearise()?;
    let arrays = arrays::of(&linear, error_bound);
    let mut contents: Vec<Vec<u8>> = Vec::with_capacity(outputs.len());
    for format in formats {
        match format {
            Format::Json => contents.push(json::text(&arrays, &modes.json()).into_bytes()),
            Format::Csv => {
                contents.extend(tables::all(&linear).map(String::into_bytes));
                contents.push(modes.table().into_bytes());
            }
            Format::Npz => contents.push(npz::bytes(&arrays)?),
            Format::Mat => contents.push(mat::bytes(&arrays)),
        }
    }
    terminal::print(&told)?;
    drafts.keep(&contents)?;
    for path in outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

/// Follows the modes over airspeeds, and writes where they go.
fn run_locus(options: &LineariseOptions, airspeeds: &[f64]) -> Result<(), Error> {
    let outputs = ["locus.csv", "locus.svg"].map(|ending| options.file(ending));
    let paths = outputs.each_ref().map(PathBuf::as_path);
    refuse_overwriting(&paths, [options.aircraft.as_path()])?;
    let drafts = Drafts::new(paths)?;
    let locus = options.locus(airspeeds, &Audience::of_command())?;
    drafts.keep([locus.table(), locus.drawing()])?;
    for path in paths {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

/// More airspeeds are a slip of the pen.
const MOST_AIRSPEEDS: usize = 10_000;

/// Airspeeds of a root locus.
#[derive(Clone, Debug)]
struct LocusSpeeds(Vec<f64>);

fn speeds(text: &str) -> Result<LocusSpeeds, String> {
    let found = axis::numbers(text, MOST_AIRSPEEDS);
    let ascends = |speeds: &Vec<f64>| speeds.len() > 1 && speeds.is_sorted_by(|one, next| one < next);
    found.filter(ascends).map(LocusSpeeds).ok_or_else(|| {
        format!("allowed are at least two ascending airspeeds, m/s: FROM:TO:COUNT, COUNT at most {MOST_AIRSPEEDS}, or N,N,…")
    })
}

/// All matrices, names and units under the keys of the files, and the modes; or the modes over airspeeds.
pub fn answer(options: &LineariseOptions, audience: &Audience) -> Result<Answer, Error> {
    if let Some(LocusSpeeds(airspeeds)) = &options.speed {
        return Ok(options.locus(airspeeds, audience)?.answer());
    }
    let Linearised { linear, modes, error_bound, .. } = options.linearise()?;
    let arrays = arrays::of(&linear, error_bound).into_iter().map(|(key, array)| (key, array.into()));
    Ok(Answer::named(arrays.chain([("modes", modes.answer())])))
}

impl LineariseOptions {
    fn flown(&self) -> Result<(Arc<ReducedModel>, Settings), Error> {
        let model = self.flown.reduce(&self.flown.read(&self.aircraft)?)?;
        let settings = self.flown.settings(&VariableTable::new(&model), &model)?;
        Ok((model, settings))
    }

    fn linearise(&self) -> Result<Linearised, Error> {
        let (model, settings) = self.flown()?;
        let contents = LinearContents {
            inflow: self.inflow.states(),
            all_states: self.all_states,
            gust_planes: self.gust_stations,
        };
        Linearised::new(&model, &settings, contents, self.inflow, self.inputs)
    }

    /// The modes over airspeeds; those that cannot be flown are warned of.
    fn locus(&self, airspeeds: &[f64], audience: &Audience) -> Result<Locus, Error> {
        if matches!(self.inflow, Wake::Balanced(_)) {
            return Err(Error::LocusReduced(self.inflow));
        }
        let (model, settings) = self.flown()?;
        let progress = audience.progress(airspeeds.len(), "airspeeds");
        let mut locus = Locus::new(&model, &settings, self.inflow.states(), airspeeds, &progress);
        if locus.is_empty()
            && let Some((_, failure)) = locus.failures.pop()
        {
            return Err(failure.into());
        }
        for (airspeed, failure) in &locus.failures {
            diagnostics::warn(&format!("left out: {} m/s: {failure}", short(*airspeed)));
        }
        for warning in limits::warnings(&locus.limits_exceeded) {
            diagnostics::warn(&warning);
        }
        Ok(locus)
    }

    /// Each format once, in the order in which they were asked for.
    fn formats(&self) -> Vec<Format> {
        let mut formats: Vec<Format> = Vec::new();
        for &format in &self.format {
            if !formats.contains(&format) {
                formats.push(format);
            }
        }
        formats
    }

    /// The files of a format.
    fn files(&self, format: Format) -> Vec<PathBuf> {
        let file = |ending: &str| self.file(ending);
        match format {
            Format::Json => vec![file("linear.json")],
            Format::Csv => {
                tables::NAMES.iter().chain(&["modes"]).map(|table| file(&format!("{table}.csv"))).collect()
            }
            Format::Npz => vec![file("linear.npz")],
            Format::Mat => vec![file("linear.mat")],
        }
    }

    /// A file whose name ends so.
    fn file(&self, ending: &str) -> PathBuf {
        let name = self.aircraft.file_stem().unwrap_or_default().to_string_lossy();
        self.output.join(format!("{name}-{ending}"))
    }
}

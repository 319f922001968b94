//! `flexair linearise`: a linear model about a trim, for those who design control laws [theory: linearisation.inputs].

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use flexible_aircraft::LinearModel;
use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;
use zip::result::ZipError;

use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::flown::{self, FlownOptions, trimmed};
use crate::{terminal, workspace};

mod arrays;
mod balanced;
mod inputs;
mod json;
mod labels;
mod mat;
mod npz;
mod roots;
mod tables;
mod wake;

use inputs::Chosen;
use wake::Wake;

/// Options of `flexair linearise`.
#[derive(Args)]
#[command(
    after_help = "x' = A x + B u + Bd u' and y = C x + D u + Dd u' for departures from x0, u0, y0, in SI units and radians. Bd and Dd are those of the wind \
alone, whose rate acts on the apparent mass. The trim is that with which a flight begins: --set airspeed=150, --set condition.manoeuvre=turn. \
x_labels, u_labels and y_labels are the names in letters, digits and _, each once among inputs and outputs.

balanced:N splits off what is slower than 0.25 1/s or grows, which stays exact, and leaves of the rest the states that matter most to the response, all counted \
in N; a bound of the error is printed. Its states, reduced[i], do not jump with the wind: Bd is 0. For the jet 44 states are right to 3e-3 of each output's largest \
gain from 0.1 to 60 rad/s, with --inputs controls to 1e-4 (36 to 5e-3).

Examples: the jet for Python and MATLAB; with 36 states, for a control law; in a turn, with steady aerodynamics
  flexair linearise --format npz,mat
  flexair linearise --format mat --inflow balanced:36 --inputs controls
  flexair linearise --set condition.manoeuvre=turn --set condition.bank_angle=0.5 --inflow steady"
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

    /// Inputs of the model
    #[arg(long, value_enum, default_value_t = Chosen::All)]
    inputs: Chosen,

    /// Keep position north and east and heading, and how far the air has gone (drift.north, .east, .down), on which nothing
    /// depends: not in a turn
    #[arg(long)]
    all_states: bool,

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
    #[error("cannot write the archive of NumPy: {0}")]
    Archive(#[from] ZipError),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// Linearises, prints the roots, and writes the model.
pub fn run(options: &LineariseOptions) -> Result<(), Error> {
    let formats = options.formats();
    let outputs: Vec<PathBuf> = formats.iter().flat_map(|format| options.files(*format)).collect();
    let paths: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&paths, [options.aircraft.as_path()])?;
    let drafts = Drafts::new(paths.iter().copied())?;
    let model = options.flown.reduce(&options.flown.read(&options.aircraft)?)?;
    let settings = options.flown.settings(&VariableTable::new(&model), &model)?;
    trimmed(&model, &settings, 0.0)?;
    let states = options.inflow.states();
    let mut linear = if options.all_states {
        LinearModel::with_all_states(Arc::clone(&model), &settings, states)?
    } else {
        LinearModel::new(Arc::clone(&model), &settings, states)?
    };
    options.inputs.choose(&mut linear);
    let mut reduction = String::new();
    if let Wake::Balanced(order) = options.inflow {
        let reduced = balanced::reduce(&linear, order)?;
        reduction = reduced.text() + "\n";
        linear = reduced.model;
    }
    let printed = roots::text(&model, &settings, &linear) + &reduction;
    let arrays = arrays::of(&linear);
    let mut contents: Vec<Vec<u8>> = Vec::with_capacity(outputs.len());
    for format in formats {
        match format {
            Format::Json => contents.push(json::text(&arrays).into_bytes()),
            Format::Csv => contents.extend(tables::all(&linear).map(String::into_bytes)),
            Format::Npz => contents.push(npz::bytes(&arrays)?),
            Format::Mat => contents.push(mat::bytes(&arrays)),
        }
    }
    terminal::print(&printed)?;
    drafts.keep(&contents)?;
    for path in outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

impl LineariseOptions {
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
        let name = self.aircraft.file_stem().unwrap_or_default().to_string_lossy();
        let file = |ending: &str| self.output.join(format!("{name}-{ending}"));
        match format {
            Format::Json => vec![file("linear.json")],
            Format::Csv => tables::NAMES.map(|table| file(&format!("{table}.csv"))).to_vec(),
            Format::Npz => vec![file("linear.npz")],
            Format::Mat => vec![file("linear.mat")],
        }
    }
}

//! `flexair linearise`: a linear model about a trim, for those who design control laws [theory: linearisation.inputs].

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft::{Inflow, LinearModel};
use flexible_aircraft_packaging::FileError;
use zip::result::ZipError;

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::flown::{self, FlownOptions, trimmed};
use crate::{terminal, workspace};

mod arrays;
mod json;
mod labels;
mod mat;
mod npz;
mod roots;
mod tables;

/// Options of `flexair linearise`.
#[derive(Args)]
#[command(
    after_help = "x' = A x + B u + Bd u' and y = C x + D u + Dd u' for departures from x0, u0, y0, in SI units and radians. Bd and Dd are those of the wind \
alone, whose rate acts on the apparent mass. The trim is that with which a flight begins: --set airspeed=150, --set condition.manoeuvre=turn. \
x_labels, u_labels and y_labels are the names in letters, digits and _, each once among inputs and outputs.

Examples: the jet for Python and MATLAB; in a turn, with steady aerodynamics
  flexair linearise --format npz,mat
  flexair linearise --set condition.manoeuvre=turn --set condition.bank_angle=0.5 --inflow steady"
)]
pub struct LineariseOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// What becomes of the wake: its states are kept, or aerodynamics are steady, as with inflow_states=0
    #[arg(long, value_enum, default_value_t = Wake::Keep)]
    inflow: Wake,

    /// Formats of the files: JSON, a table for each matrix, NumPy, MATLAB (level 5)
    #[arg(long, value_enum, value_name = "FORMAT,…", value_delimiter = ',', default_value = "json")]
    format: Vec<Format>,

    /// Folder for the files
    #[arg(long, value_name = "DIR", default_value = "target/linear")]
    output: PathBuf,
}

/// What becomes of the wake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Wake {
    Keep,
    Steady,
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
    let (model, settings, linear) = options.linearise()?;
    let printed = roots::text(&model, &settings, &linear);
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

/// All matrices, names and units under the keys of the files.
pub fn answer(options: &LineariseOptions) -> Result<Answer, Error> {
    let (_, _, linear) = options.linearise()?;
    Ok(Answer::named(arrays::of(&linear).into_iter().map(|(key, array)| (key, array.into()))))
}

impl LineariseOptions {
    fn linearise(&self) -> Result<(Arc<ReducedModel>, Settings, LinearModel), Error> {
        let model = self.flown.reduce(&self.flown.read(&self.aircraft)?)?;
        let settings = self.flown.settings(&VariableTable::new(&model), &model)?;
        trimmed(&model, &settings, 0.0)?;
        let inflow = match self.inflow {
            Wake::Keep => Inflow::Kept,
            Wake::Steady => Inflow::Steady,
        };
        let linear = LinearModel::new(Arc::clone(&model), &settings, inflow)?;
        Ok((model, settings, linear))
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

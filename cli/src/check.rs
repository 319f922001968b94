//! `flexair check`: what is wrong with an aircraft file, what is unusual about the aircraft, and what the file describes.

use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft_packaging::FileError;

use crate::describe::{Description, json, text};
use crate::diagnostics::odd_trims;
use crate::files::{Drafts, Overwriting, STANDARD, refuse_overwriting};
use crate::flown::{self, FlownOptions};
use crate::outcome::Outcome;
use crate::terminal;

/// Options of `flexair check`.
#[derive(Args)]
#[command(
    after_help = "Mistakes are shown with their lines, all at once, and nothing else is printed: the exit code is 1. Otherwise the aircraft is described as \
`flexair describe` does, with what is unusual at the end: mass by area, frequencies, static margin, volumes of tails and fins, ratios of \
stiffnesses, radii of gyration against the aircraft's size, elements without strips, controls that turn the aircraft against what is said of them, \
moments of sections and flaps, what turns in engines, nodes in one place without a joint, a trim that is beyond limits or not to be found. The exit code \
is 2 where anything is unusual and 0 where nothing is; options that cannot be read end with 1. An unusual \
aircraft flies all the same.

Example: in a script that goes on only where all is well
  flexair check my-aircraft.toml > described.txt && flexair package --aircraft my-aircraft.toml"
)]
pub struct CheckOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT")]
    file: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// Also write all of it as JSON, as `flexair describe` does; - is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Why an aircraft cannot be described.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    // Not transparent: whoever reports it finds the mistakes among its sources, and shows their lines.
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// Checks an aircraft file and says what is unusual.
///
/// # Errors
/// When there are mistakes in the file, or its aircraft has no modes or structure that could be described.
pub fn run(options: &CheckOptions) -> Result<Outcome, Error> {
    let outputs: Vec<&Path> = options.json.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&outputs, [options.file.as_path()])?;
    let to_standard = options.json.as_deref() == Some(Path::new(STANDARD));
    let drafts = Drafts::new(outputs.into_iter().filter(|_| !to_standard))?;

    let aircraft = Aircraft::read(&options.file)?;
    let aircraft = options.flown.changed(aircraft);
    let mut description = Description::new(&aircraft, &options.flown)?;
    description.warnings.extend(odd_trims(&aircraft));
    let count = description.warnings.len();

    let json = options.json.as_ref().map(|_| json::text(&description));
    match json.as_ref().filter(|_| to_standard) {
        Some(json) => terminal::print(json)?,
        None => terminal::print(&format!("{}\n{}\n", text::text(&description), verdict(options, count)))?,
    }
    drafts.keep(json.filter(|_| !to_standard))?;
    Ok(if count == 0 { Outcome::Clean } else { Outcome::Remarks })
}

fn verdict(options: &CheckOptions, warnings: usize) -> String {
    let file = options.file.display();
    match warnings {
        0 => format!("{file}: no mistakes, and nothing is unusual"),
        1 => format!("{file}: no mistakes, 1 warning"),
        _ => format!("{file}: no mistakes, {warnings} warnings"),
    }
}

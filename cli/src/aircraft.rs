//! `flexair aircraft`: which aircraft come with the program.

use clap::Args;
use flexible_aircraft::aircraft::{AircraftFileError, Support};
use flexible_aircraft_packaging::FileError;

use crate::home::Home;
use crate::{diagnostics, terminal};

/// Of names.
const WIDTH: usize = 22;

/// Options of `flexair aircraft`.
#[derive(Args)]
#[command(
    after_help = "Every command takes these names in place of a file, as in `flexair trim generic-business-jet`; to change one, copy its file"
)]
pub struct AircraftOptions {}

/// Why nothing is listed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error("no aircraft come with this program: looked for aircraft files in {0}")]
    None(String),
    #[error(transparent)]
    File(#[from] FileError),
}

/// Prints names, what they stand for, and where the files are.
pub fn run(home: &Home) -> Result<(), Error> {
    let folder = home.aircraft_folder();
    let mut lines = Vec::new();
    for name in home.aircraft_names() {
        let aircraft = diagnostics::read_aircraft(&home.aircraft_file(&name))?;
        let support = match aircraft.support {
            Support::Free => "free",
            Support::Clamped => "clamped in a wind tunnel",
        };
        lines.push(format!("{name:WIDTH$}  {}, {support}\n", aircraft.name));
    }
    if lines.is_empty() {
        return Err(Error::None(folder.display().to_string()));
    }
    let files = format!("\nTheir files, and a description of the format, are in {}\n", folder.display());
    Ok(terminal::print(&(lines.concat() + &files))?)
}

//! `flexair merge`: one FMU for the platforms of several.

use std::path::PathBuf;

use clap::Args;
use flexible_aircraft_packaging::{Draft, FileError, MergeError, merge};

use crate::files::{Overwriting, refuse_overwriting};
use crate::terminal;

/// Options of `flexair merge`.
#[derive(Args)]
pub struct MergeOptions {
    /// The FMUs
    #[arg(value_name = "FMU", num_args = 2.., required = true)]
    fmus: Vec<PathBuf>,

    /// The FMU to write
    #[arg(long, value_name = "FILE", default_value = "FlexibleAircraft.fmu")]
    output: PathBuf,
}

/// Why `flexair merge` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Merge(#[from] MergeError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(transparent)]
    File(#[from] FileError),
}

/// Reads all, and writes what they are together.
pub fn run(options: &MergeOptions) -> Result<(), Error> {
    refuse_overwriting(&[&options.output], options.fmus.iter().map(PathBuf::as_path))?;
    let bytes = merge(&options.fmus)?;
    let draft = Draft::write(&bytes, &options.output)?;
    let size = draft.size();
    draft.keep()?;
    Ok(terminal::print(&format!("{}: {:.1} MB\n", options.output.display(), size as f64 / 1e6))?)
}

//! `flexair merge`: one FMU for the platforms of several.

use std::path::PathBuf;

use clap::Args;
use flexible_aircraft_packaging::{Draft, MergeError, PackageError, merge};

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
    Write(#[from] PackageError),
}

/// Reads all, and writes what they are together.
pub fn run(options: &MergeOptions) -> Result<(), Error> {
    let bytes = merge(&options.fmus)?;
    let draft = Draft::write(&bytes, &options.output)?;
    let size = draft.size();
    draft.keep()?;
    println!("{}: {:.1} MB", options.output.display(), size as f64 / 1e6);
    Ok(())
}

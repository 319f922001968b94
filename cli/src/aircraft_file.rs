//! The aircraft file of a command that has it as an argument or as `--aircraft`, as all commands have it.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::workspace;

/// The aircraft file, given either way.
#[derive(Args)]
pub struct AircraftFile {
    /// The aircraft file (TOML), as --aircraft has it
    #[arg(value_name = "AIRCRAFT", conflicts_with = "aircraft")]
    file: Option<PathBuf>,

    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,
}

impl AircraftFile {
    /// The file that is meant.
    pub fn path(&self) -> &Path {
        self.file.as_deref().unwrap_or(&self.aircraft)
    }
}

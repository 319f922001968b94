//! flexible-aircraft's own folder, in which this program was built: what commands take when nothing else is asked for.

use std::path::{Path, PathBuf};

/// The folder.
pub fn root() -> &'static Path {
    let cli = Path::new(env!("CARGO_MANIFEST_DIR"));
    cli.parent().unwrap_or(cli)
}

/// The aircraft of all commands: the generic business jet.
pub fn aircraft() -> PathBuf {
    root().join("aircraft/generic-business-jet.toml")
}

/// Where its FMU is packaged to.
pub fn fmu() -> PathBuf {
    root().join("target/fmu/FlexibleAircraft.fmu")
}

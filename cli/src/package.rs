//! `flexair package`: from the aircraft file to an FMU that has flown.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use flexible_aircraft::aircraft::AircraftFileError;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{FileError, FmuError, Package, PackageError, Platform};

use crate::check::CheckFlight;
use crate::files::{Overwriting, refuse_overwriting};
use crate::{PackageOptions, diagnostics, terminal, workspace};

/// Why `flexair package` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Package(#[from] PackageError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(transparent)]
    File(#[from] FileError),
    #[error("FMI 2.0 has no name for this platform: give the library of another one with --binary")]
    NoPlatform,
    #[error("cannot build the shared library: {0}")]
    Build(String),
    #[error("the FMU does not fly and was not kept: {0}")]
    Check(#[from] FmuError),
}

/// Builds, packages, and flies what came out.
pub fn run(options: PackageOptions) -> Result<(), Error> {
    // Before the library is built: mistakes in the aircraft file and in the options should show at once.
    let PackageOptions { aircraft: aircraft_file, output, .. } = options;
    let libraries = options.binary.iter().map(|(_, library)| library.as_path());
    refuse_overwriting(&[&output], libraries.chain([aircraft_file.as_path()]))?;
    let aircraft = diagnostics::read_aircraft(&aircraft_file)?;

    let mut package = Package {
        aircraft: aircraft_file,
        mode_count: ModeCount::asked_or_usual(options.modes, ReducedModel::USUAL_MODES),
        load_modes: options.load_modes,
        starts: options.set,
        stations_along: options.stations_along,
        binaries: options.binary,
        workspace: workspace::root().into(),
    };
    let level = package.starts()?.plant.fidelity.name();
    add_library(&mut package.binaries)?;

    let file = package.aircraft.display();
    terminal::note(&format!("Packaging {} ({file}), which flies with model = {level}", aircraft.name));
    // A good FMU is replaced only by one that flies.
    let draft = package.draft(&output)?;
    let flight = if options.no_check {
        None
    } else {
        terminal::note(&format!("Flying it for {} s", CheckFlight::DURATION));
        Some(CheckFlight::fly(&Fmu::open(draft.path())?, &aircraft)?)
    };
    let size = draft.size();
    draft.keep()?;
    terminal::print(&format!("{}: {:.1} MB\n", output.display(), size as f64 / 1e6))?;
    if let Some(flight) = flight {
        terminal::print(&format!("{flight}\n"))?;
    }
    Ok(())
}

/// Adds the library of this machine where none was given.
fn add_library(binaries: &mut Vec<(Platform, PathBuf)>) -> Result<(), Error> {
    let host = Platform::host();
    if binaries.iter().any(|(platform, _)| Some(*platform) == host) {
        return Ok(());
    }
    match host {
        Some(host) => binaries.push((host, build_library()?)),
        None if binaries.is_empty() => return Err(Error::NoPlatform),
        None => {}
    }
    Ok(())
}

/// Has cargo build the shared library for this machine, and returns the file.
fn build_library() -> Result<PathBuf, Error> {
    terminal::note("Building the shared library");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let output = Command::new(cargo)
        .current_dir(workspace::root())
        // Not `--package`: with the default members, what `cargo run --release` built is used again.
        .args(["build", "--release", "--lib", "--message-format", "json-render-diagnostics"])
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| Error::Build(format!("cargo does not start: {error}")))?;
    if !output.status.success() {
        return Err(Error::Build(format!("cargo build ended with {}", output.status)));
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    messages.lines().find_map(shared_library).ok_or_else(|| Error::Build("cargo built none".into()))
}

/// The shared library, if this line of cargo's messages announces ours.
fn shared_library(message: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(message).ok()?;
    if message["reason"] != "compiler-artifact" || message["target"]["name"] != "flexible_aircraft" {
        return None;
    }
    let files = message["filenames"].as_array()?.iter().filter_map(|file| file.as_str());
    let is_library = |file: &&str| file.ends_with(std::env::consts::DLL_SUFFIX);
    files.into_iter().find(is_library).map(PathBuf::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shared_library_is_found_among_cargos_messages() {
        let library = format!("/t/libflexible_aircraft{}", std::env::consts::DLL_SUFFIX);
        let message = |name: &str| {
            format!(
                r#"{{"reason":"compiler-artifact","target":{{"name":"{name}"}},"filenames":["/t/a.rlib","{library}"]}}"#
            )
        };
        assert_eq!(shared_library(&message("flexible_aircraft")), Some(PathBuf::from(&library)));
        assert_eq!(shared_library(&message("nalgebra")), None);
        assert_eq!(shared_library(r#"{"reason":"build-finished","success":true}"#), None);
    }
}

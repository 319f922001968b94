//! `flexair package`: from the aircraft file to an FMU that has flown.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use flexible_aircraft::aircraft::AircraftFileError;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{FileError, FmuError, Package, PackageError, Platform};

use crate::answer::Answer;
use crate::check::CheckFlight;
use crate::files::{Overwriting, refuse_overwriting};
use crate::home::Home;
use crate::progress::Audience;
use crate::{PackageOptions, diagnostics, terminal};

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
    #[error("no shared libraries came with this program: looked for them in {}; give one with --binary", .0.display())]
    NoLibraries(PathBuf),
    #[error("cannot build the shared library: {0}")]
    Build(String),
    #[error("the FMU does not fly and was not kept: {0}")]
    Check(#[from] FmuError),
}

/// What was packaged.
struct Packaged {
    output: PathBuf,
    /// Bytes.
    size: u64,
    /// What it showed, if it was asked to.
    flight: Option<CheckFlight>,
}

/// Builds, packages, and flies what came out.
pub fn run(options: PackageOptions, home: &Home) -> Result<(), Error> {
    let Packaged { output, size, flight } = package(options, home, &Audience::of_command())?;
    terminal::print(&format!("{}: {:.1} MB\n", output.display(), size as f64 / 1e6))?;
    if let Some(flight) = flight {
        terminal::print(&format!("{flight}\n"))?;
    }
    Ok(())
}

/// The same for a program.
pub fn answer(options: PackageOptions, home: &Home, audience: &Audience) -> Result<Answer, Error> {
    let Packaged { output, size, flight } = package(options, home, audience)?;
    let flight = flight.map_or(String::new(), |flight| flight.to_string());
    Ok(Answer::named([
        ("path", Answer::Text(output.to_string_lossy().into_owned())),
        ("size", Answer::Number(size as f64)),
        ("flight", Answer::Text(flight)),
    ]))
}

fn package(options: PackageOptions, home: &Home, audience: &Audience) -> Result<Packaged, Error> {
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
        licences: home.licences(),
    };
    let level = package.starts()?.plant.fidelity.name();
    add_libraries(&mut package.binaries, home, audience)?;

    let file = package.aircraft.display();
    audience.note(&format!("Packaging {} ({file}), which flies with model = {level}", aircraft.name));
    // A good FMU is replaced only by one that flies.
    let draft = package.draft(&output)?;
    let flight = if options.no_check {
        None
    } else {
        audience.note(&format!("Flying it for {} s", CheckFlight::DURATION));
        Some(CheckFlight::fly(&Fmu::open(draft.path())?, &aircraft)?)
    };
    let size = draft.size();
    draft.keep()?;
    Ok(Packaged { output, size, flight })
}

/// Adds the libraries of which none was given: in a checkout that of this machine, elsewhere those that came with the program.
fn add_libraries(
    binaries: &mut Vec<(Platform, PathBuf)>,
    home: &Home,
    audience: &Audience,
) -> Result<(), Error> {
    let is_given = |platform: Platform| binaries.iter().any(|(given, _)| *given == platform);
    match (home, Platform::host()) {
        (Home::Installed(installation), _) => {
            let mut libraries = installation.libraries();
            libraries.retain(|(platform, _)| !is_given(*platform));
            if libraries.is_empty() && binaries.is_empty() {
                return Err(Error::NoLibraries(installation.folder().to_owned()));
            }
            binaries.extend(libraries);
        }
        (_, Some(host)) if is_given(host) => {}
        (Home::Checkout(root), Some(host)) => binaries.push((host, build_library(root, audience)?)),
        (Home::Checkout(_), None) if binaries.is_empty() => return Err(Error::NoPlatform),
        (Home::Checkout(_), None) => {}
    }
    Ok(())
}

/// Has cargo build the shared library for this machine, and returns the file.
fn build_library(root: &Path, audience: &Audience) -> Result<PathBuf, Error> {
    audience.note("Building the shared library");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let output = Command::new(cargo)
        .current_dir(root)
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

//! `flexair package`: from the aircraft file to an FMU that has flown.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::fmi::Interface;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{Draft, FileError, FmuError, Package, PackageError, Platform, Reduction};

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::home::Home;
use crate::interfaces::{OneFile, places};
use crate::progress::Audience;
use crate::proof::ProofFlight;
use crate::view::{self, archive};
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
    Output(#[from] OneFile),
    #[error(transparent)]
    File(#[from] FileError),
    #[error("the page of the documentation on which the aircraft is seen: {0}")]
    Scene(#[from] view::Error),
    #[error("FMI has no name for this platform: give the library of another one with --binary")]
    NoPlatform,
    #[error("no shared libraries came with this program: looked for them in {}; give one with --binary", .0.display())]
    NoLibraries(PathBuf),
    #[error("cannot build the shared library: {0}")]
    Build(String),
    #[error("the FMU ({interface}) does not fly and was not kept: {source}")]
    Check { interface: Interface, source: FmuError },
}

/// An archive that was written.
struct Packaged {
    interface: Interface,
    output: PathBuf,
    /// Bytes.
    size: u64,
    /// What it showed, if it was asked to.
    flight: Option<ProofFlight>,
}

/// Builds, packages, and flies what came out.
pub fn run(options: PackageOptions, home: &Home) -> Result<(), Error> {
    for Packaged { output, size, flight, .. } in package(options, home, &Audience::of_command())? {
        terminal::print(&format!("{}: {:.1} MB\n", output.display(), size as f64 / 1e6))?;
        if let Some(flight) = flight {
            terminal::print(&format!("{flight}\n"))?;
        }
    }
    Ok(())
}

/// The same for a program.
pub fn answer(options: PackageOptions, home: &Home, audience: &Audience) -> Result<Answer, Error> {
    let packaged = package(options, home, audience)?;
    let texts = |text: fn(&Packaged) -> String| Answer::Texts(packaged.iter().map(text).collect());
    Ok(Answer::named([
        ("interfaces", texts(|archive| archive.interface.to_string())),
        ("paths", texts(|archive| archive.output.to_string_lossy().into_owned())),
        ("sizes", Answer::Numbers(packaged.iter().map(|archive| archive.size as f64).collect())),
        ("flights", texts(|archive| archive.flight.as_ref().map_or(String::new(), ToString::to_string))),
    ]))
}

/// All archives that are asked for, or none.
fn package(options: PackageOptions, home: &Home, audience: &Audience) -> Result<Vec<Packaged>, Error> {
    // Before the library is built: mistakes in the aircraft file and in the options should show at once.
    let interfaces = options.interfaces.asked();
    let usual = home.output("package", &workspace::fmu());
    let outputs = places(&interfaces, options.output.as_deref(), &usual)?;
    let libraries = options.binary.iter().map(|(_, library)| library.as_path());
    let paths: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&paths, libraries.chain([options.aircraft.path()]))?;
    let aircraft = diagnostics::read_aircraft(options.aircraft.path())?;

    let mut package = Package {
        interface: Interface::USUAL,
        aircraft: options.aircraft.path().to_owned(),
        mode_count: ModeCount::asked_or_usual(options.modes, ReducedModel::USUAL_MODES),
        load_modes: options.load_modes,
        starts: options.set,
        stations_along: options.stations_along,
        binaries: options.binary,
        licences: home.licences(),
        scene: None,
    };
    let reduction = package.reduce()?;
    let mut starts = Vec::new();
    for &interface in &interfaces {
        package.interface = interface;
        starts.push(package.starts(&reduction)?);
    }
    add_libraries(&mut package.binaries, home, audience)?;

    let file = package.aircraft.display();
    audience.note(&format!(
        "Packaging {} ({file}), which flies with model = {}",
        aircraft.name,
        starts[0].plant.fidelity.name()
    ));
    if !options.no_scene {
        package.scene = scene(&package, &reduction, &starts[0], audience)?;
    }
    // Good FMUs are replaced only by ones that fly.
    let (mut drafts, mut packaged) = (Drafts::none(), Vec::new());
    for (interface, output) in interfaces.into_iter().zip(outputs) {
        package.interface = interface;
        let draft = package.draft_of(&reduction, &output)?;
        let flight = (!options.no_check).then(|| fly(&draft, interface, &aircraft, audience));
        let flight = flight.transpose().map_err(|source| Error::Check { interface, source })?;
        packaged.push(Packaged { interface, output, size: draft.size(), flight });
        drafts.add(draft);
    }
    drafts.keep_written()?;
    Ok(packaged)
}

/// The page on which the aircraft is seen in the documentation of all archives.
fn scene(
    package: &Package,
    reduction: &Reduction,
    starts: &Settings,
    audience: &Audience,
) -> Result<Option<String>, Error> {
    let scene = archive::scene(reduction.aircraft(), package.mode_count, starts)?;
    let without_trim = scene.as_ref().and_then(|scene| scene.without_trim.as_ref());
    if let Some(error) = without_trim {
        audience.note(&format!("The documentation shows no trim, for there is none: {error}"));
    }
    Ok(scene.map(|scene| scene.page))
}

/// Flies what has been written.
fn fly(
    draft: &Draft,
    interface: Interface,
    aircraft: &Aircraft,
    audience: &Audience,
) -> Result<ProofFlight, FmuError> {
    let duration = ProofFlight::duration(interface.kind);
    let what = if interface == Interface::USUAL { "it".to_owned() } else { format!("it as {interface}") };
    audience.note(&format!("Flying {what} for {duration} s"));
    ProofFlight::fly(&Fmu::open(draft.path())?, aircraft)
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

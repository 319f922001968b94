//! Which FMUs `flexair package` writes, and where to.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use flexible_aircraft::fmi::{Interface, Kind, Version};

/// What importers are to take the FMU as; of several versions and kinds there is an FMU for each pair.
#[derive(Args)]
pub struct Interfaces {
    /// The version of FMI. May be repeated, for an FMU of each [default: 2]
    #[arg(long, value_name = "VERSION", value_enum, value_delimiter = ',', hide_default_value = true)]
    fmi: Vec<Fmi>,

    /// Who integrates: the FMU (co-simulation), for flying it, or the importer (model-exchange), for linearising it. May be
    /// repeated, for an FMU of each [default: co-simulation]
    #[arg(long, value_name = "KIND", value_enum, value_delimiter = ',', hide_default_value = true)]
    kind: Vec<Integrating>,
}

/// Versions of FMI by their first numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Fmi {
    /// FMI 2.0, which most tools take
    #[value(name = "2")]
    V2,
    /// FMI 3.0
    #[value(name = "3")]
    V3,
}

/// Kinds of FMUs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Integrating {
    /// The FMU integrates
    CoSimulation,
    /// The importer integrates
    ModelExchange,
}

/// A file where there are several to write.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[error("--output FILE takes one archive; {0} were asked for: name a folder")]
pub struct OneFile(usize);

impl Interfaces {
    /// All pairs of what was asked for, each once, in the order of [`Interface::ALL`].
    pub fn asked(&self) -> Vec<Interface> {
        let is_asked = |interface: &Interface| {
            let (fmi, kind) = match (interface.version, interface.kind) {
                (Version::V2, Kind::CoSimulation) => (Fmi::V2, Integrating::CoSimulation),
                (Version::V2, Kind::ModelExchange) => (Fmi::V2, Integrating::ModelExchange),
                (Version::V3, Kind::CoSimulation) => (Fmi::V3, Integrating::CoSimulation),
                (Version::V3, Kind::ModelExchange) => (Fmi::V3, Integrating::ModelExchange),
            };
            is_among(&self.fmi, fmi, Fmi::V2) && is_among(&self.kind, kind, Integrating::CoSimulation)
        };
        Interface::ALL.into_iter().filter(is_asked).collect()
    }
}

/// Whether a value is among those that were given, or the usual one where none was.
fn is_among<T: Copy + PartialEq>(given: &[T], value: T, usual: T) -> bool {
    if given.is_empty() { value == usual } else { given.contains(&value) }
}

/// What the FMU of an interface is called after the usual one: `FlexibleAircraft.fmi3.me.fmu`.
fn file_name(usual: &Path, interface: Interface) -> PathBuf {
    let version = match interface.version {
        Version::V2 => "",
        Version::V3 => ".fmi3",
    };
    let kind = match interface.kind {
        Kind::CoSimulation => "",
        Kind::ModelExchange => ".me",
    };
    let stem = usual.file_stem().unwrap_or_default().to_string_lossy();
    PathBuf::from(format!("{stem}{version}{kind}.fmu"))
}

/// Where the FMUs go: to the output, a file or a folder, or beside where the usual one goes.
///
/// # Errors
/// When they are several and the output is a file.
pub fn places(
    interfaces: &[Interface],
    output: Option<&Path>,
    usual: &Path,
) -> Result<Vec<PathBuf>, OneFile> {
    let is_alone = interfaces.len() == 1;
    let folder = match output {
        None => usual.parent().unwrap_or(Path::new("")),
        Some(output) if is_folder(output) || (!is_alone && may_be_folder(output)) => output,
        Some(file) if is_alone => return Ok(vec![file.to_owned()]),
        Some(_) => return Err(OneFile(interfaces.len())),
    };
    Ok(interfaces.iter().map(|interface| folder.join(file_name(usual, *interface))).collect())
}

/// A folder that there is, or what ends like one.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(std::path::is_separator)
}

/// What does not exist and is not called like an FMU.
fn may_be_folder(path: &Path) -> bool {
    let is_fmu = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("fmu"));
    !is_fmu && !path.exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: &str = "target/fmu/FlexibleAircraft.fmu";

    fn places(interfaces: &[Interface], output: Option<&str>) -> Result<String, String> {
        let found = super::places(interfaces, output.map(Path::new), Path::new(USUAL));
        let names = |places: Vec<PathBuf>| {
            let names: Vec<String> = places.iter().map(|place| place.display().to_string()).collect();
            names.join(" ")
        };
        found.map(names).map_err(|error| error.to_string())
    }

    #[test]
    fn all_pairs_of_what_is_asked_for_are_written_each_once() {
        use {Fmi::*, Integrating::*};
        let asked = |fmi: &[Fmi], kind: &[Integrating]| {
            let asked = Interfaces { fmi: fmi.to_vec(), kind: kind.to_vec() }.asked();
            asked.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
        };
        assert_eq!(asked(&[], &[]), "FMI 2.0 co-simulation");
        assert_eq!(asked(&[V3, V3], &[]), "FMI 3.0 co-simulation");
        assert_eq!(asked(&[V3, V2], &[]), "FMI 2.0 co-simulation, FMI 3.0 co-simulation");
        assert_eq!(asked(&[], &[ModelExchange]), "FMI 2.0 model exchange");
        assert_eq!(
            asked(&[V2, V3], &[ModelExchange, CoSimulation]),
            "FMI 2.0 co-simulation, FMI 3.0 co-simulation, FMI 2.0 model exchange, FMI 3.0 model exchange"
        );
    }

    #[test]
    fn archives_are_called_after_version_and_kind() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().to_str().unwrap();
        let names = ["", ".fmi3", ".me", ".fmi3.me"].map(|part| format!("FlexibleAircraft{part}.fmu"));
        let under = |folder: &str| names.clone().map(|name| format!("{folder}/{name}")).join(" ");
        assert_eq!(places(&Interface::ALL, None), Ok(under("target/fmu")));
        assert_eq!(places(&Interface::ALL, Some(folder)), Ok(under(folder)));
        assert_eq!(places(&Interface::ALL, Some("new/folder")), Ok(under("new/folder")));
        for (interface, name) in Interface::ALL.into_iter().zip(&names) {
            assert_eq!(places(&[interface], None), Ok(format!("target/fmu/{name}")));
            assert_eq!(places(&[interface], Some(folder)), Ok(format!("{folder}/{name}")));
            assert_eq!(places(&[interface], Some("own")), Ok("own".to_owned()));
        }
    }

    #[test]
    fn a_file_takes_one_archive() {
        let file = tempfile::NamedTempFile::new().unwrap();
        for output in ["all.fmu", "folder/All.FMU", file.path().to_str().unwrap()] {
            let refused = places(&Interface::ALL[..3], Some(output)).unwrap_err();
            assert!(refused.starts_with("--output FILE takes one archive; 3 were asked for"), "{refused}");
            assert_eq!(places(&[Interface::USUAL], Some(output)), Ok(output.to_owned()));
        }
    }
}

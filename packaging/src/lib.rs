//! Builds the `.fmu` archive of a flexible aircraft, and loads one as an importing tool does.
//!
//! An FMU is the aircraft, reduced to its modes, with shared libraries for some platforms. [`Package`] says
//! what goes in; the same input gives the same bytes. [`merge`] joins FMUs that were packaged on different
//! machines. [`c_abi`] is the way back: from the archive to an
//! aircraft that flies.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::fmi;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft::variables::VariableTable;

mod archive;
pub mod assignment;
pub mod c_abi;
mod documentation;
mod draft;
mod error;
mod installation;
mod library;
mod licences;
mod merge;
mod model_description;
mod plan_view;
mod platform;
pub mod system;
mod temporary;

pub use draft::{Draft, is_stream, open_stream, replaced_by};
pub use error::{FileError, FmuError, PackageError};
pub use installation::Installation;
pub use library::{BuildMark, LibraryFault};
pub use licences::Licences;
pub use merge::{MergeError, merge};
pub use platform::{Platform, UnknownPlatform};
pub use temporary::remove_all as remove_temporary_files;

use archive::Entry;

/// The icon that importing tools show.
const ICON: &[u8] = include_bytes!("../../modelDescription/model.png");

/// What goes into an FMU.
#[derive(Clone, Debug)]
pub struct Package {
    /// The aircraft file.
    pub aircraft: PathBuf,
    /// How many natural modes the FMU offers, lowest frequencies first.
    pub mode_count: ModeCount,
    /// Load modes beside them also where the aircraft file does not ask for any.
    pub load_modes: bool,
    /// Where parameters start, as `gust.shape=one_minus_cosine`; the others start as the aircraft's.
    pub starts: Vec<String>,
    /// Components along which there are stations beside those of the file, and how many.
    pub stations_along: Vec<(String, usize)>,
    /// The shared library of each platform.
    pub binaries: Vec<(Platform, PathBuf)>,
    /// Where the licences of what is linked come from.
    pub licences: Licences,
}

impl Package {
    /// How the FMU flies where nothing is set in it: of all that can be asked for, but of the libraries.
    ///
    /// # Errors
    /// When the aircraft file is not right, the structure has not that many modes, or a station or a start cannot be.
    pub fn starts(&self) -> Result<Settings, PackageError> {
        Ok(self.reduce()?.2)
    }

    /// The aircraft with all its stations, what it is reduced to, and where its parameters start.
    fn reduce(&self) -> Result<(Aircraft, ReducedModel, Settings), PackageError> {
        let mut aircraft =
            Aircraft::read(&self.aircraft).map_err(|error| PackageError::Aircraft(Box::new(error)))?;
        aircraft.load_modes |= self.load_modes;
        for (component, count) in &self.stations_along {
            aircraft
                .add_stations_along(component, *count)
                .map_err(|source| PackageError::StationsAlong { component: component.clone(), source })?;
        }
        let model = ReducedModel::new(&aircraft, self.mode_count)
            .map_err(|source| PackageError::Structure { aircraft: self.aircraft.clone(), source })?;
        let variables = VariableTable::new(&model);
        let starts =
            assignment::settings(&self.starts, &variables, &model, ModeCount::Usual(model.natural_modes()))?;
        Ok((aircraft, model, starts))
    }

    /// The bytes of the `.fmu`: equal inputs, equal bytes.
    ///
    /// # Errors
    /// As [`starts`](Self::starts), or when a file cannot be read.
    pub fn to_bytes(&self) -> Result<Vec<u8>, PackageError> {
        let (aircraft, model, starts) = self.reduce()?;
        let xml = fmi::description::write(&model, &starts);
        let mut entries = vec![Entry::new(archive::MODEL_DESCRIPTION, xml), Entry::new("model.png", ICON)];
        entries.extend(libraries(&self.binaries)?);
        entries.push(Entry::new(format!("resources/{}", fmi::RESOURCE_FILE), model.to_bytes()));
        entries.extend(
            fmi::starts::write(&model, &starts)
                .map(|text| Entry::new(format!("resources/{}", fmi::starts::STARTS_FILE), text)),
        );
        entries.push(Entry::new("resources/aircraft.toml", read(&self.aircraft)?));
        let page = documentation::page(&aircraft, &model, &starts);
        entries.push(Entry::new("documentation/index.html", page));
        entries.extend(self.licences.entries()?);
        Ok(archive::to_bytes(entries)?)
    }

    /// Writes the `.fmu` beside its place, where it can be tried before it is [kept](Draft::keep), and the
    /// folders above it where they do not exist.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes), or when the file cannot be written.
    pub fn draft(&self, output: &Path) -> Result<Draft, PackageError> {
        Ok(Draft::write(&self.to_bytes()?, output)?)
    }

    /// Writes the `.fmu`, and the folders above it where they do not exist.
    ///
    /// # Errors
    /// As [`draft`](Self::draft).
    pub fn write(&self, output: &Path) -> Result<(), PackageError> {
        Ok(self.draft(output)?.keep()?)
    }
}

/// One library per platform, each of them of this version and these sources.
fn libraries(binaries: &[(Platform, PathBuf)]) -> Result<Vec<Entry>, PackageError> {
    let mut found = BTreeSet::new();
    if let Some((twice, _)) = binaries.iter().find(|(platform, _)| !found.insert(*platform)) {
        return Err(PackageError::TwoBinaries(*twice));
    }
    if binaries.is_empty() {
        return Err(PackageError::NoBinary);
    }
    let entry = |(platform, path): &(Platform, PathBuf)| {
        let bytes = read(path)?;
        let expected = BuildMark::own();
        let fault = match library::examine(&bytes, *platform) {
            Ok(found) if found == expected => {
                return Ok(Entry::new(platform.library_path(fmi::MODEL_IDENTIFIER), bytes));
            }
            Ok(found) => LibraryFault::OtherBuild { found, expected },
            Err(fault) => fault,
        };
        Err(PackageError::WrongBinary { path: path.clone(), fault })
    };
    binaries.iter().map(entry).collect()
}

fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path).map_err(|source| FileError { action: "read", path: path.to_owned(), source })
}

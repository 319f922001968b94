//! Builds the `.fmu` archive of a flexible aircraft, and loads one as an importing tool does.
//!
//! An FMU is the aircraft, reduced to its modes, with shared libraries for some platforms, behind one of the interfaces that FMI
//! has. [`Package`] says what goes in; the same input gives the same bytes. [`merge`] joins FMUs that were packaged on different
//! machines. [`c_abi`] is the way back: from the archive to an
//! aircraft that flies.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::flight::{Settings, continuous_settings};
use flexible_aircraft::fmi::{self, Interface, Kind, Version};
use flexible_aircraft::structure::{ModeCount, ReducedModel};

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
mod pictures;
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
pub use plan_view::PictureError;
pub use platform::{Platform, Processor, UnknownPlatform};
pub use temporary::remove_all as remove_temporary_files;

use archive::Entry;

/// What goes into an FMU.
#[derive(Clone, Debug)]
pub struct Package {
    /// What importers take it as.
    pub interface: Interface,
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
    /// A page that shows the aircraft's shapes, which the documentation then has in it.
    pub scene: Option<String>,
}

/// An aircraft with all its stations, and what it is reduced to: what the FMUs of one aircraft share, whatever their
/// interfaces.
#[derive(Clone, Debug)]
pub struct Reduction {
    aircraft: Aircraft,
    model: ReducedModel,
}

impl Reduction {
    /// The aircraft with all its stations.
    pub fn aircraft(&self) -> &Aircraft {
        &self.aircraft
    }
}

impl Package {
    /// The aircraft as its FMU has it.
    ///
    /// # Errors
    /// When the aircraft file is not right, the structure has not that many modes, or a station cannot be.
    pub fn reduce(&self) -> Result<Reduction, PackageError> {
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
        Ok(Reduction { aircraft, model })
    }

    /// How the FMU flies where nothing is set in it.
    ///
    /// # Errors
    /// When a parameter cannot start so.
    pub fn starts(&self, Reduction { model, .. }: &Reduction) -> Result<Settings, PackageError> {
        let starts = assignment::starts(&self.starts, self.interface, model)?;
        if self.interface.kind == Kind::ModelExchange {
            continuous_settings::check(&starts, model).map_err(PackageError::Discontinuous)?;
        }
        Ok(starts)
    }

    /// The bytes of the `.fmu`: equal inputs, equal bytes.
    ///
    /// # Errors
    /// As [`reduce`](Self::reduce) and [`starts`](Self::starts), or when a file cannot be read.
    pub fn to_bytes(&self) -> Result<Vec<u8>, PackageError> {
        self.bytes_of(&self.reduce()?)
    }

    /// The bytes of the `.fmu` of what the aircraft has been reduced to.
    fn bytes_of(&self, reduction: &Reduction) -> Result<Vec<u8>, PackageError> {
        let (interface, Reduction { aircraft, model }) = (self.interface, reduction);
        let starts = self.starts(reduction)?;
        let xml = fmi::description::write(interface, model, &starts);
        let mut entries = vec![Entry::new(archive::MODEL_DESCRIPTION, xml)];
        entries.extend(libraries(&self.binaries, interface.version)?);
        entries.push(Entry::new(format!("resources/{}", fmi::RESOURCE_FILE), model.to_bytes()));
        entries.extend(
            fmi::starts::write(interface, model, &starts)
                .map(|text| Entry::new(format!("resources/{}", fmi::starts::STARTS_FILE), text)),
        );
        entries.push(Entry::new("resources/aircraft.toml", read(&self.aircraft)?));
        entries.extend(pictures::entries(interface.version, aircraft)?);
        let page = documentation::page(interface, reduction, &starts, self.scene.is_some());
        entries.push(Entry::new("documentation/index.html", page));
        let scene = self.scene.as_deref();
        entries
            .extend(scene.map(|scene| Entry::new(format!("documentation/{}", documentation::SCENE), scene)));
        entries.extend(self.licences.entries(interface.version)?);
        Ok(archive::to_bytes(entries)?)
    }

    /// Writes the `.fmu` of what the aircraft has been [reduced](Self::reduce) to beside its place, where it can be tried before
    /// it is [kept](Draft::keep), and the folders above it where they do not exist.
    ///
    /// # Errors
    /// As [`starts`](Self::starts), or when a file cannot be read or written.
    pub fn draft_of(&self, reduction: &Reduction, output: &Path) -> Result<Draft, PackageError> {
        Ok(Draft::write(&self.bytes_of(reduction)?, output)?)
    }

    /// The same of an aircraft that has yet to be reduced.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes), or when the file cannot be written.
    pub fn draft(&self, output: &Path) -> Result<Draft, PackageError> {
        self.draft_of(&self.reduce()?, output)
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
fn libraries(binaries: &[(Platform, PathBuf)], version: Version) -> Result<Vec<Entry>, PackageError> {
    let mut found = BTreeSet::new();
    if let Some((twice, _)) = binaries.iter().find(|(platform, _)| !found.insert(*platform)) {
        return Err(PackageError::TwoBinaries(*twice));
    }
    if binaries.is_empty() {
        return Err(PackageError::NoBinary);
    }
    let mut entries = Vec::new();
    for (platform, path) in binaries {
        let (bytes, expected) = (read(path)?, BuildMark::own());
        let fault = match library::examine(&bytes, *platform) {
            Ok(library) if library.mark == expected => {
                let paths = library.processors.into_iter();
                let paths: BTreeSet<String> = paths
                    .map(|processor| platform.library_path(version, processor, fmi::MODEL_IDENTIFIER))
                    .collect();
                entries.extend(paths.into_iter().map(|path| Entry::new(path, bytes.clone())));
                continue;
            }
            Ok(library) => LibraryFault::OtherBuild { found: library.mark, expected },
            Err(fault) => fault,
        };
        return Err(PackageError::WrongBinary { path: path.clone(), fault });
    }
    Ok(entries)
}

fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path).map_err(|source| FileError { action: "read", path: path.to_owned(), source })
}

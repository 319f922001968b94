//! Joins the platforms of FMUs of the same aircraft, which were packaged on different machines.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use flexible_aircraft::fmi::{Interface, Version};
use zip::result::ZipError;

use crate::archive::{self, Entry};
use crate::library;
use crate::model_description::ModelDescription;
use crate::{BuildMark, FileError, LibraryFault, Platform, read};

/// Why FMUs cannot be joined.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// There is no FMU to merge.
    #[error("found no FMU to merge")]
    Nothing,
    /// A file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file is not an FMU as flexible-aircraft writes them.
    #[error("{} is no FMU of flexible-aircraft: {reason}", fmu.display())]
    NotOurs {
        /// The file.
        fmu: PathBuf,
        /// Why not.
        reason: String,
    },
    /// Importers take them as different things.
    #[error("{} is {of_first}, {} is {of_second}: nothing to merge", first.display(), second.display())]
    OtherInterface {
        /// An FMU.
        first: PathBuf,
        /// What it is.
        of_first: Interface,
        /// Another one.
        second: PathBuf,
        /// What that is.
        of_second: Interface,
    },
    /// They differ in more than their platforms.
    #[error(
        "only FMUs of one aircraft, version and guid can be merged: the {what} is {} in {}, {} in {}",
        of_first, first.display(), of_second, second.display()
    )]
    Different {
        /// In what.
        what: &'static str,
        /// An FMU.
        first: PathBuf,
        /// What it has.
        of_first: String,
        /// Another one.
        second: PathBuf,
        /// What that has.
        of_second: String,
    },
    /// A file beside the libraries differs.
    #[error("{} and {} do not have the same {file}", first.display(), second.display())]
    DifferentFile {
        /// Path in the archive.
        file: String,
        /// An FMU.
        first: PathBuf,
        /// Another one.
        second: PathBuf,
    },
    /// Both have a library for a platform, and not the same.
    #[error("{} and {} have different libraries for {folder}", first.display(), second.display())]
    TwoBinaries {
        /// That of the platform.
        folder: String,
        /// An FMU.
        first: PathBuf,
        /// Another one.
        second: PathBuf,
    },
    /// A library is not what it should be.
    #[error("{}, {platform}: {fault}", fmu.display())]
    WrongBinary {
        /// The FMU.
        fmu: PathBuf,
        /// Which of its platforms.
        platform: Platform,
        /// What is wrong.
        fault: LibraryFault,
    },
    /// The archive could not be put together.
    #[error("cannot build the archive: {0}")]
    Archive(#[from] ZipError),
}

/// The bytes of an FMU with the platforms of all given ones: the same whatever their order, and those of an FMU
/// packaged with all the platforms at once.
///
/// # Errors
/// When a file cannot be read or is none of our FMUs, when they differ in anything but their platforms, or when
/// libraries differ in the version or the sources that they were built of.
pub fn merge(fmus: &[PathBuf]) -> Result<Vec<u8>, MergeError> {
    let mut contents = fmus.iter().map(|fmu| Contents::read(fmu));
    let first = contents.next().ok_or(MergeError::Nothing)??;
    let merged = contents.try_fold(first, |merged, next| merged.joined(next?))?;
    Ok(archive::to_bytes(merged.into_entries())?)
}

/// What is in an FMU.
struct Contents {
    /// The FMU, for messages.
    fmu: PathBuf,
    description: ModelDescription,
    /// What its libraries were built of.
    mark: BuildMark,
    /// By their paths.
    libraries: BTreeMap<String, Vec<u8>>,
    /// All other files by their paths.
    others: BTreeMap<String, Vec<u8>>,
}

impl Contents {
    fn read(fmu: &Path) -> Result<Self, MergeError> {
        let not_ours = |reason: String| MergeError::NotOurs { fmu: fmu.to_owned(), reason };
        let bytes = read(fmu)?;
        let entries = archive::from_bytes(&bytes).map_err(|error| not_ours(error.to_string()))?;
        let files = entries.into_iter().map(|entry| (entry.path, entry.bytes));
        let (binaries, others): (BTreeMap<_, _>, BTreeMap<_, _>) =
            files.partition(|(path, _)| path.starts_with("binaries/"));
        let xml = others.get(archive::MODEL_DESCRIPTION).map(|xml| String::from_utf8_lossy(xml));
        let xml = xml.ok_or_else(|| not_ours(format!("it has no {}", archive::MODEL_DESCRIPTION)))?;
        let description = ModelDescription::parse(&xml).map_err(not_ours)?;

        let mut libraries = BTreeMap::new();
        let mut marks = Vec::new();
        for (path, bytes) in binaries {
            let version = description.interface.version;
            let place = Platform::of_library_path(&path, version, &description.model_identifier);
            let (platform, processor) = place.ok_or_else(|| not_ours(format!("it has a file {path}")))?;
            let wrong = |fault| MergeError::WrongBinary { fmu: fmu.to_owned(), platform, fault };
            let library = library::examine(&bytes, platform).map_err(wrong)?;
            if version == Version::V3 && !library.processors.contains(&processor) {
                return Err(not_ours(format!("its {path} does not run on the processor of that folder")));
            }
            marks.push(library.mark);
            libraries.insert(path, bytes);
        }
        let mark = marks.pop().ok_or_else(|| not_ours("it has no shared library".into()))?;
        if let Some(found) = marks.into_iter().find(|other| *other != mark) {
            return Err(not_ours(format!("it has libraries of {mark} and of {found}")));
        }
        Ok(Contents { fmu: fmu.to_owned(), description, mark, libraries, others })
    }

    fn joined(mut self, other: Contents) -> Result<Self, MergeError> {
        self.require_same_identity(&other)?;
        let (first, second) = (self.fmu.clone(), other.fmu);
        for (path, library) in other.libraries {
            if self.libraries.get(&path).is_some_and(|ours| *ours != library) {
                let folder = path.split('/').nth(1).unwrap_or(&path).to_owned();
                return Err(MergeError::TwoBinaries { folder, first, second });
            }
            self.libraries.insert(path, library);
        }
        let mut paths = self.others.keys().chain(other.others.keys());
        if let Some(file) = paths.find(|path| self.others.get(*path) != other.others.get(*path)) {
            return Err(MergeError::DifferentFile { file: file.clone(), first, second });
        }
        Ok(self)
    }

    fn require_same_identity(&self, other: &Contents) -> Result<(), MergeError> {
        let (a, b) = (&self.description, &other.description);
        if a.interface != b.interface {
            return Err(MergeError::OtherInterface {
                first: self.fmu.clone(),
                of_first: a.interface,
                second: other.fmu.clone(),
                of_second: b.interface,
            });
        }
        let sources = |contents: &Contents| contents.mark.to_string();
        for (what, of_first, of_second) in [
            ("description", &a.description, &b.description),
            ("version", &a.version, &b.version),
            ("guid", &a.token, &b.token),
            ("mark of the libraries' sources", &sources(self), &sources(other)),
        ] {
            if of_first != of_second {
                return Err(MergeError::Different {
                    what,
                    first: self.fmu.clone(),
                    of_first: of_first.clone(),
                    second: other.fmu.clone(),
                    of_second: of_second.clone(),
                });
            }
        }
        Ok(())
    }

    fn into_entries(self) -> Vec<Entry> {
        let all = self.libraries.into_iter().chain(self.others);
        all.map(|(path, bytes)| Entry::new(path, bytes)).collect()
    }
}

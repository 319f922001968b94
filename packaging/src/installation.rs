//! What `flexair` needs where its sources are not: a data folder, which is installed with it.
//!
//! Libraries and licences lie in it as they do in an FMU of FMI 2.0, so that they go into one as they are; for FMI 3.0 their
//! folders change.

use std::path::{Path, PathBuf};

use flexible_aircraft::fmi::{self, Version};

use crate::archive::Entry;
use crate::{Draft, Licences, PackageError, Platform, Processor, libraries, licences, read};

/// The aircraft files, in the workspace and in a data folder.
const AIRCRAFT: &str = "aircraft";

/// The licences of the command itself, in a data folder.
const OF_THE_COMMAND: &str = "licences-of-the-command";

/// Whose FMUs its libraries lie as in.
const LAYOUT: Version = Version::V2;

/// A data folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Installation {
    folder: PathBuf,
}

impl Installation {
    /// The one at a path, which may lack anything.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        Installation { folder: folder.into() }
    }

    /// Writes one of these libraries and of what lies in the workspace, for a program that is this package of it.
    ///
    /// # Errors
    /// When a library is not of these sources, cargo does not tell what is linked, or a file cannot be read or written.
    pub fn write(
        folder: &Path,
        workspace: &Path,
        binaries: &[(Platform, PathBuf)],
        program: &str,
    ) -> Result<Self, PackageError> {
        let mut entries = libraries(binaries, LAYOUT)?;
        entries.extend(licences::of_library(workspace)?);
        entries.extend(licences::of_program(workspace, program, OF_THE_COMMAND)?);
        for (name, path) in licences::listed(&workspace.join(AIRCRAFT))? {
            entries.push(Entry::new(format!("{AIRCRAFT}/{name}"), read(&path)?));
        }
        for Entry { path, bytes } in entries {
            Draft::write(&bytes, &folder.join(path))?.keep()?;
        }
        Ok(Installation::at(folder))
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The folder of its aircraft files.
    pub fn aircraft(&self) -> PathBuf {
        self.folder.join(AIRCRAFT)
    }

    /// The libraries that it has.
    pub fn libraries(&self) -> Vec<(Platform, PathBuf)> {
        // FMI 2.0 has one folder for all processors of a platform.
        let path = |platform: Platform| {
            self.folder.join(platform.library_path(LAYOUT, Processor::host(), fmi::MODEL_IDENTIFIER))
        };
        let all = Platform::ALL.into_iter().map(|platform| (platform, path(platform)));
        all.filter(|(_, path)| path.is_file()).collect()
    }

    /// The licences of the libraries.
    pub fn licences(&self) -> Licences {
        Licences::Gathered(self.folder.clone())
    }
}

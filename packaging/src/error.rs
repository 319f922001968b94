//! Why an FMU could not be written.

use std::path::PathBuf;

use flexible_aircraft::aircraft::AircraftFileError;
use flexible_aircraft::structure::StructureError;

use crate::Platform;

/// Why an FMU could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PackageError {
    /// A file or folder could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// What was tried, as a verb.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// What the operating system says.
        source: std::io::Error,
    },
    /// The aircraft file is not right. Boxed: it carries the text for the diagnostics.
    #[error(transparent)]
    Aircraft(Box<AircraftFileError>),
    /// The structure cannot be reduced to modes.
    #[error("{}: {source}", aircraft.display())]
    Structure {
        /// The aircraft file.
        aircraft: PathBuf,
        /// What is wrong with its structure.
        source: StructureError,
    },
    /// Two libraries for one platform.
    #[error("found two shared libraries for {0}; an FMU has one per platform")]
    TwoBinaries(Platform),
    /// Nothing to run on.
    #[error("an FMU needs a shared library of at least one platform: found none")]
    NoBinary,
    /// cargo did not tell what the library is linked with.
    #[error("cannot list the licences of the linked libraries: `cargo metadata` {reason}")]
    Licences {
        /// What happened instead.
        reason: String,
    },
    /// The library wrote a model description that this crate does not understand.
    #[error("modelDescription.xml: {0}")]
    ModelDescription(String),
    /// The archive could not be put together.
    #[error("cannot build the archive: {0}")]
    Archive(#[from] zip::result::ZipError),
}

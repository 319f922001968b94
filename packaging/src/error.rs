//! Why an FMU could not be written, or not be used.

use std::ffi::NulError;
use std::io;
use std::path::PathBuf;

use flexible_aircraft::aircraft::{AircraftFileError, StationsAlongError, looked_for};
use flexible_aircraft::fmi::{Interface, Version};
use flexible_aircraft::plant::SettingError;
use flexible_aircraft::structure::StructureError;

use crate::assignment::Mistake;
use crate::{LibraryFault, PictureError, Platform};

/// A file or folder that could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("cannot {action} {}: {source}{}", path.display(), looked_for(path, source))]
pub struct FileError {
    /// What was tried, as a verb.
    pub action: &'static str,
    /// The file or folder.
    pub path: PathBuf,
    /// What the operating system says.
    pub source: io::Error,
}

/// Why an FMU could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PackageError {
    /// A file or folder could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
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
    /// A parameter cannot start so.
    #[error("--set {0}")]
    Start(#[from] Mistake),
    /// A start that only an integrator of our own could fly.
    #[error("model exchange: {0}")]
    Discontinuous(SettingError),
    /// There cannot be such stations along a component.
    #[error("stations along {component}: {source}")]
    StationsAlong {
        /// The component.
        component: String,
        /// What is wrong.
        source: StationsAlongError,
    },
    /// Two libraries for one platform.
    #[error("found two shared libraries for {0}; an FMU has one per platform")]
    TwoBinaries(Platform),
    /// A file that is not flexible-aircraft's shared library for its platform.
    #[error("{}: {fault}", path.display())]
    WrongBinary {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        fault: LibraryFault,
    },
    /// Nothing to run on.
    #[error("an FMU needs a shared library of at least one platform: found none")]
    NoBinary,
    /// cargo did not tell what the library is linked with.
    #[error("cannot list the licences of the linked libraries: {reason}")]
    Licences {
        /// What happened instead.
        reason: String,
    },
    /// The aircraft cannot be drawn.
    #[error("cannot draw documentation/diagram.png: {0}")]
    Picture(#[from] PictureError),
    /// The archive could not be put together.
    #[error("cannot build the archive: {0}")]
    Archive(#[from] zip::result::ZipError),
}

/// Why an FMU could not be loaded or refused a call.
#[derive(Debug, thiserror::Error)]
pub enum FmuError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The archive cannot be unpacked.
    #[error("cannot unpack {}: {reason}", path.display())]
    Archive {
        /// The FMU.
        path: PathBuf,
        /// What happened.
        reason: String,
    },
    /// Its `modelDescription.xml` cannot be used.
    #[error("modelDescription.xml: {0}")]
    ModelDescription(String),
    /// It is another kind of FMU than what is to be done with it needs.
    #[error("{}: found an FMU of {found}, needed is one of {needed}", path.display())]
    OtherInterface {
        /// The FMU.
        path: PathBuf,
        /// What it is.
        found: Interface,
        /// What it should be.
        needed: Interface,
    },
    /// There is no name for this machine.
    #[error("FMI {} knows no platform for this machine", .0.number())]
    NoPlatform(Version),
    /// The shared library does not load, or lacks a function of the standard.
    #[error("cannot use the shared library: {}", with_causes(.0))]
    Library(#[from] libloading::Error),
    /// No variable of this name.
    #[error("the FMU has no variable `{0}`")]
    UnknownVariable(String),
    /// A text for the FMU contains a zero byte.
    #[error("the text for the FMU contains a zero byte: {0}")]
    ZeroByte(#[from] NulError),
    /// As many values as references are needed.
    #[error("{references} value references with {values} values")]
    Lengths {
        /// Number of value references.
        references: usize,
        /// Number of values.
        values: usize,
    },
    /// As many values as states are needed.
    #[error("{values} values of {states} states")]
    States {
        /// Number of states.
        states: usize,
        /// Number of values.
        values: usize,
    },
    /// A function of the FMU returned another status than OK or warning.
    #[error("{function} returned {status}{}", indented(log))]
    Refused {
        /// Which function.
        function: &'static str,
        /// Name of the returned status.
        status: &'static str,
        /// What the FMU logged during the call, one message per line.
        log: String,
    },
}

/// An error and what led to it: the loader's own reason is a cause of `dlopen failed`.
fn with_causes(error: &dyn std::error::Error) -> String {
    let causes = std::iter::successors(Some(error), |error| error.source());
    causes.map(ToString::to_string).collect::<Vec<_>>().join(": ")
}

/// Log lines below the message that they explain.
fn indented(log: &str) -> String {
    log.lines().map(|line| format!("\n  {line}")).collect()
}

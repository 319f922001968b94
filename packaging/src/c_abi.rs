//! The calling side of the FMI 2.0 C interface: loads a packaged FMU as any importer does.
//!
//! [`Fmu`] is the unpacked archive with its library, [`Instance`] one aircraft in it. The only `unsafe` code
//! outside the FMU itself; everything public is safe to call as long as the library keeps to FMI 2.0.

mod instance;
mod interface;

use std::ffi::CString;
use std::path::Path;
use std::ptr::NonNull;
use std::rc::Rc;

use libloading::Library;

pub use instance::Instance;
use interface::flexible_aircraft_importer_logger;
use interface::{CO_SIMULATION, Callbacks, FALSE, Functions, Log, TRUE, calloc, drain, free};

use crate::model_description::ModelDescription;
use crate::temporary::TemporaryFolder;
use crate::{FileError, FmuError, Platform};

/// A value reference: the address of a variable.
pub type ValueReference = u32;

/// An unpacked FMU whose library is loaded.
pub struct Fmu {
    description: ModelDescription,
    functions: Functions,
    /// Keeps the functions callable.
    _library: Library,
    /// Deleted last.
    directory: TemporaryFolder,
}

impl Fmu {
    /// Unpacks an FMU into a temporary folder and loads its library for this machine.
    ///
    /// # Errors
    /// When the archive is damaged or has no library that loads here.
    pub fn open(path: &Path) -> Result<Self, FmuError> {
        let failed = |reason: String| FmuError::Archive { path: path.to_owned(), reason };
        let archive = std::fs::File::open(path).map_err(|source| FileError {
            action: "read",
            path: path.to_owned(),
            source,
        })?;
        let directory = TemporaryFolder::new().map_err(|error| failed(error.to_string()))?;
        let mut archive = zip::ZipArchive::new(archive).map_err(|error| failed(error.to_string()))?;
        archive.extract(directory.path()).map_err(|error| failed(error.to_string()))?;
        let xml = std::fs::read_to_string(directory.path().join("modelDescription.xml"))
            .map_err(|error| FmuError::ModelDescription(error.to_string()))?;
        let description = ModelDescription::parse(&xml).map_err(FmuError::ModelDescription)?;
        let platform = Platform::host().ok_or(FmuError::NoPlatform)?;
        let library = platform.library_path(&description.model_identifier);
        // SAFETY: loading runs the library's initialisers; that of an FMU is to be trusted like any program.
        let library = unsafe { Library::new(directory.path().join(library)) }?;
        Ok(Fmu { description, functions: Functions::of(&library)?, _library: library, directory })
    }

    /// The value reference of a variable.
    ///
    /// # Errors
    /// When there is no such variable.
    pub fn variable(&self, name: &str) -> Result<ValueReference, FmuError> {
        let variable = self.description.variable(name).map(|variable| variable.value_reference);
        variable.ok_or_else(|| FmuError::UnknownVariable(name.to_owned()))
    }

    /// The value references of several variables, in the given order.
    ///
    /// # Errors
    /// When there is no variable of one of the names.
    pub fn variables(&self, names: &[impl AsRef<str>]) -> Result<Vec<ValueReference>, FmuError> {
        names.iter().map(|name| self.variable(name.as_ref())).collect()
    }

    /// The names of all variables, in the order of the model description.
    pub fn variable_names(&self) -> impl Iterator<Item = &str> {
        self.description.variables.iter().map(|variable| variable.name.as_str())
    }

    /// A new instance for co-simulation, with logging on.
    ///
    /// # Errors
    /// When the FMU refuses; the error carries its log.
    pub fn instantiate(&self, name: &str) -> Result<Instance<'_>, FmuError> {
        let name = CString::new(name)?;
        let guid = CString::new(self.description.guid.as_str())?;
        let resources = CString::new(file_uri(&self.directory.path().join("resources")))?;
        let log = Rc::new(Log::default());
        let callbacks = Rc::new(Callbacks {
            logger: flexible_aircraft_importer_logger,
            allocate_memory: calloc,
            free_memory: free,
            step_finished: None,
            environment: Rc::as_ptr(&log).cast_mut().cast(),
        });
        // SAFETY: all pointers are valid during the call; the callbacks and the log, which the FMU may keep,
        // live in the `Instance` until it is freed and never move.
        let component = unsafe {
            (self.functions.instantiate)(
                name.as_ptr(),
                CO_SIMULATION,
                guid.as_ptr(),
                resources.as_ptr(),
                Rc::as_ptr(&callbacks),
                FALSE,
                TRUE,
            )
        };
        match NonNull::new(component) {
            Some(component) => {
                Ok(Instance { functions: &self.functions, component, log, _callbacks: callbacks })
            }
            None => Err(FmuError::Refused {
                function: "fmi2Instantiate",
                status: "no instance",
                log: drain(&log),
            }),
        }
    }
}

/// `file:///path` with everything but letters, digits and a few marks percent-encoded.
fn file_uri(path: &Path) -> String {
    let path = path.to_string_lossy().replace('\\', "/");
    let mut uri = String::from("file:///");
    for byte in path.trim_start_matches('/').bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' | b':' => {
                uri.push(char::from(byte));
            }
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

//! The calling side of the C interfaces of FMI 2.0 and 3.0: loads a packaged FMU as any importer does.
//!
//! [`Fmu`] is the unpacked archive with its library, [`Instance`] one aircraft in it. The only `unsafe` code
//! outside the FMU itself; everything public is safe to call as long as the library keeps to its version of FMI.

mod exchange;
mod fmi2;
mod fmi3;
mod functions;
mod instance;
mod log;
mod symbol;
mod value_reference;

use std::ffi::{CString, c_void};
use std::path::{Path, PathBuf};
use std::ptr::{self, NonNull};
use std::rc::Rc;

use flexible_aircraft::fmi::{Interface, Kind};
use libloading::Library;

use functions::Functions;
pub use instance::Instance;
use log::{Log, drain, log_message};
pub use value_reference::ValueReference;

use crate::model_description::ModelDescription;
use crate::temporary::TemporaryFolder;
use crate::{FileError, FmuError, Platform, Processor};

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
        let version = description.interface.version;
        let platform = Platform::host().ok_or(FmuError::NoPlatform(version))?;
        let library = platform.library_path(version, Processor::host(), &description.model_identifier);
        // SAFETY: loading runs the library's initialisers; that of an FMU is to be trusted like any program.
        let library = unsafe { Library::new(directory.path().join(library)) }?;
        Ok(Fmu { description, functions: Functions::of(&library, version)?, _library: library, directory })
    }

    /// As [`open`](Self::open), of an FMU that importers take as one thing alone.
    ///
    /// # Errors
    /// As [`open`](Self::open), and when it is something else.
    pub fn open_as(path: &Path, needed: Interface) -> Result<Self, FmuError> {
        let fmu = Fmu::open(path)?;
        let found = fmu.interface();
        let path = path.to_owned();
        if found == needed { Ok(fmu) } else { Err(FmuError::OtherInterface { path, found, needed }) }
    }

    /// What importers take it as.
    pub fn interface(&self) -> Interface {
        self.description.interface
    }

    /// How many states an importer of it integrates.
    pub fn states(&self) -> usize {
        self.description.states
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

    /// A new instance, with logging on.
    ///
    /// # Errors
    /// When the FMU refuses; the error carries its log.
    pub fn instantiate(&self, name: &str) -> Result<Instance<'_>, FmuError> {
        let texts = Texts {
            name: CString::new(name)?,
            token: CString::new(self.description.token.as_str())?,
            resources: self.directory.path().join("resources"),
        };
        let log = Rc::new(Log::default());
        // The FMU may keep it; it is alive until the instance is freed, and never moves.
        let environment = Rc::as_ptr(&log).cast_mut().cast();
        let callbacks = Rc::new(fmi2::Callbacks::logging_to(environment));
        let (function, component) = match &self.functions {
            Functions::V2(functions) => self.instantiate_second(functions, &texts, &callbacks)?,
            Functions::V3(functions) => self.instantiate_third(functions, &texts, environment)?,
        };
        match NonNull::new(component) {
            Some(component) => {
                let states = self.description.states;
                Ok(Instance { functions: &self.functions, component, states, log, _callbacks: callbacks })
            }
            None => Err(FmuError::Refused { function, status: "no instance", log: drain(&log) }),
        }
    }

    fn instantiate_second(
        &self,
        functions: &fmi2::Functions,
        Texts { name, token, resources }: &Texts,
        callbacks: &Rc<fmi2::Callbacks>,
    ) -> Result<(&'static str, fmi2::Component), FmuError> {
        let resources = CString::new(file_uri(resources))?;
        let kind = match self.description.interface.kind {
            Kind::CoSimulation => fmi2::CO_SIMULATION,
            Kind::ModelExchange => fmi2::MODEL_EXCHANGE,
        };
        // SAFETY: all pointers are valid during the call; the callbacks and the log, which the FMU may keep,
        // live in the `Instance` until it is freed and never move.
        let component = unsafe {
            (functions.instantiate)(
                name.as_ptr(),
                kind,
                token.as_ptr(),
                resources.as_ptr(),
                Rc::as_ptr(callbacks),
                fmi2::FALSE,
                fmi2::TRUE,
            )
        };
        Ok(("fmi2Instantiate", component))
    }

    fn instantiate_third(
        &self,
        functions: &fmi3::Functions,
        Texts { name, token, resources }: &Texts,
        environment: *mut c_void,
    ) -> Result<(&'static str, fmi3::Component), FmuError> {
        let resources = CString::new(resources.join("").to_string_lossy().into_owned())?;
        let (name, token, resources) = (name.as_ptr(), token.as_ptr(), resources.as_ptr());
        let (visible, logging) = (fmi3::FALSE, fmi3::TRUE);
        match self.description.interface.kind {
            Kind::CoSimulation => {
                // SAFETY: all pointers are valid during the call; the log, which the FMU may keep, lives in the `Instance`
                // until it is freed and never moves. There are no intermediate variables and no function for updates.
                let component = unsafe {
                    (functions.instantiate_co_simulation)(
                        name,
                        token,
                        resources,
                        visible,
                        logging,
                        fmi3::FALSE,
                        fmi3::FALSE,
                        ptr::null(),
                        0,
                        environment,
                        Some(log_message),
                        None,
                    )
                };
                Ok(("fmi3InstantiateCoSimulation", component))
            }
            Kind::ModelExchange => {
                // SAFETY: as above.
                let component = unsafe {
                    (functions.instantiate_model_exchange)(
                        name,
                        token,
                        resources,
                        visible,
                        logging,
                        environment,
                        Some(log_message),
                    )
                };
                Ok(("fmi3InstantiateModelExchange", component))
            }
        }
    }
}

/// What an instance is made of.
struct Texts {
    name: CString,
    token: CString,
    resources: PathBuf,
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

//! The calling side of the FMI 2.0 C interface: loads a packaged FMU as any importer does.
//!
//! [`Fmu`] is the unpacked archive with its library, [`Instance`] one aircraft in it. The only `unsafe` code
//! outside the FMU itself; everything public is safe to call as long as the library keeps to FMI 2.0.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::Path;
use std::ptr::NonNull;
use std::rc::Rc;
use std::sync::{Mutex, PoisonError};

use libloading::{Library, Symbol};
use tempfile::TempDir;

use crate::model_description::ModelDescription;
use crate::{FmuError, Platform};

/// A value reference: the address of a variable.
pub type ValueReference = u32;

type Component = *mut c_void;
type Status = c_int;
const STATUS_NAMES: [&str; 6] =
    ["fmi2OK", "fmi2Warning", "fmi2Discard", "fmi2Error", "fmi2Fatal", "fmi2Pending"];
const TRUE: c_int = 1;
const FALSE: c_int = 0;
const CO_SIMULATION: c_int = 1;

type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
struct Callbacks {
    logger: Logger,
    allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    free_memory: unsafe extern "C" fn(*mut c_void),
    step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    environment: *mut c_void,
}

// SAFETY: defined in `log_line.c` with this signature; the last two are those of the C library.
unsafe extern "C" {
    fn flexible_aircraft_importer_logger(
        environment: *mut c_void,
        instance: *const c_char,
        status: Status,
        category: *const c_char,
        message: *const c_char,
        ...
    );
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

type Log = Mutex<Vec<String>>;

/// Called by `log_line.c` with the finished line.
///
/// # Safety
/// `environment` points to a [`Log`]; `category` and `line` are C strings or null.
#[unsafe(no_mangle)]
unsafe extern "C" fn flexible_aircraft_importer_log(
    environment: *mut c_void,
    category: *const c_char,
    line: *const c_char,
) {
    let text = |text: *const c_char| {
        // SAFETY: the caller passes C strings or null, and null has been ruled out.
        if text.is_null() { "".into() } else { unsafe { CStr::from_ptr(text) }.to_string_lossy() }
    };
    // SAFETY: `environment` is the log that `Fmu::instantiate` put into the callbacks; it outlives the instance.
    let log = unsafe { &*environment.cast::<Log>() };
    let line = format!("[{}] {}", text(category), text(line));
    log.lock().unwrap_or_else(PoisonError::into_inner).push(line);
}

/// Declares the functions that are called, with the C signatures of `fmi2FunctionTypes.h`.
struct Functions {
    instantiate: unsafe extern "C" fn(
        *const c_char,
        c_int,
        *const c_char,
        *const c_char,
        *const Callbacks,
        c_int,
        c_int,
    ) -> Component,
    free_instance: unsafe extern "C" fn(Component),
    setup_experiment: unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> Status,
    enter_initialization_mode: unsafe extern "C" fn(Component) -> Status,
    exit_initialization_mode: unsafe extern "C" fn(Component) -> Status,
    terminate: unsafe extern "C" fn(Component) -> Status,
    reset: unsafe extern "C" fn(Component) -> Status,
    get_real: unsafe extern "C" fn(Component, *const ValueReference, usize, *mut f64) -> Status,
    set_real: unsafe extern "C" fn(Component, *const ValueReference, usize, *const f64) -> Status,
    get_integer: unsafe extern "C" fn(Component, *const ValueReference, usize, *mut c_int) -> Status,
    set_integer: unsafe extern "C" fn(Component, *const ValueReference, usize, *const c_int) -> Status,
    do_step: unsafe extern "C" fn(Component, f64, f64, c_int) -> Status,
}

impl Functions {
    fn of(library: &Library) -> Result<Self, libloading::Error> {
        /// The function `name`.
        ///
        /// # Safety
        /// `T` is the type of that function.
        unsafe fn function<T: Copy>(library: &Library, name: &str) -> Result<T, libloading::Error> {
            // SAFETY: promised by the caller.
            let symbol: Symbol<'_, T> = unsafe { library.get(name) }?;
            Ok(*symbol)
        }
        // SAFETY: the field types are the signatures that FMI 2.0 prescribes for these names.
        unsafe {
            Ok(Functions {
                instantiate: function(library, "fmi2Instantiate")?,
                free_instance: function(library, "fmi2FreeInstance")?,
                setup_experiment: function(library, "fmi2SetupExperiment")?,
                enter_initialization_mode: function(library, "fmi2EnterInitializationMode")?,
                exit_initialization_mode: function(library, "fmi2ExitInitializationMode")?,
                terminate: function(library, "fmi2Terminate")?,
                reset: function(library, "fmi2Reset")?,
                get_real: function(library, "fmi2GetReal")?,
                set_real: function(library, "fmi2SetReal")?,
                get_integer: function(library, "fmi2GetInteger")?,
                set_integer: function(library, "fmi2SetInteger")?,
                do_step: function(library, "fmi2DoStep")?,
            })
        }
    }
}

/// An unpacked FMU whose library is loaded.
pub struct Fmu {
    description: ModelDescription,
    functions: Functions,
    /// Keeps the functions callable.
    _library: Library,
    /// Deleted last.
    directory: TempDir,
}

impl Fmu {
    /// Unpacks an FMU into a temporary folder and loads its library for this machine.
    ///
    /// # Errors
    /// When the archive is damaged or has no library that loads here.
    pub fn open(path: &Path) -> Result<Self, FmuError> {
        let failed = |reason: String| FmuError::Archive { path: path.to_owned(), reason };
        let archive = std::fs::File::open(path).map_err(|error| failed(error.to_string()))?;
        let directory = tempfile::tempdir().map_err(|error| failed(error.to_string()))?;
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

fn drain(log: &Log) -> String {
    log.lock().unwrap_or_else(PoisonError::into_inner).drain(..).collect::<Vec<_>>().join("\n")
}

/// One aircraft in an FMU; freed when dropped.
pub struct Instance<'fmu> {
    functions: &'fmu Functions,
    component: NonNull<c_void>,
    log: Rc<Log>,
    _callbacks: Rc<Callbacks>,
}

impl Instance<'_> {
    /// `fmi2SetupExperiment`: start time, s, and the tolerance of the integrator where one is wanted.
    ///
    /// # Errors
    /// When the FMU refuses; the error carries its log. This holds for all methods of an instance.
    pub fn setup_experiment(&mut self, start: f64, tolerance: Option<f64>) -> Result<(), FmuError> {
        let defined = if tolerance.is_some() { TRUE } else { FALSE };
        let setup = self.functions.setup_experiment;
        // SAFETY: `component` is alive until `drop`, here and in all calls below.
        let status = unsafe {
            setup(self.component.as_ptr(), defined, tolerance.unwrap_or_default(), start, FALSE, 0.0)
        };
        self.checked("fmi2SetupExperiment", status)
    }

    /// `fmi2EnterInitializationMode`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn enter_initialization_mode(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.enter_initialization_mode)(self.component.as_ptr()) };
        self.checked("fmi2EnterInitializationMode", status)
    }

    /// `fmi2ExitInitializationMode`: the aircraft is trimmed here.
    ///
    /// # Errors
    /// When the FMU refuses, for example because there is no trim.
    pub fn exit_initialization_mode(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.exit_initialization_mode)(self.component.as_ptr()) };
        self.checked("fmi2ExitInitializationMode", status)
    }

    /// Starts the flight with the parameters set so far: the three calls from set-up to the end of
    /// initialisation.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn initialise(&mut self, start: f64, tolerance: Option<f64>) -> Result<(), FmuError> {
        self.setup_experiment(start, tolerance)?;
        self.enter_initialization_mode()?;
        self.exit_initialization_mode()
    }

    /// `fmi2Terminate`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn terminate(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.terminate)(self.component.as_ptr()) };
        self.checked("fmi2Terminate", status)
    }

    /// `fmi2Reset`: back to the state after instantiation.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn reset(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.reset)(self.component.as_ptr()) };
        self.checked("fmi2Reset", status)
    }

    /// `fmi2DoStep` from `time` by `step`, s.
    ///
    /// # Errors
    /// When the FMU refuses, for example because the flight left the model's validity.
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.do_step)(self.component.as_ptr(), time, step, TRUE) };
        self.checked("fmi2DoStep", status)
    }

    /// `fmi2GetReal` into `values`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_real(&self, references: &[ValueReference], values: &mut [f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let get = self.functions.get_real;
        // SAFETY: as in `setup_experiment`; both arrays have `references.len()` elements.
        let status = unsafe {
            get(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        self.checked("fmi2GetReal", status)
    }

    /// `fmi2SetReal`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_real(&mut self, references: &[ValueReference], values: &[f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let set = self.functions.set_real;
        // SAFETY: as in `get_real`.
        let status =
            unsafe { set(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_ptr()) };
        self.checked("fmi2SetReal", status)
    }

    /// `fmi2GetInteger` into `values`, enumerations too.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_integer(&self, references: &[ValueReference], values: &mut [i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let get = self.functions.get_integer;
        // SAFETY: as in `get_real`.
        let status = unsafe {
            get(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        self.checked("fmi2GetInteger", status)
    }

    /// `fmi2SetInteger`, enumerations too.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_integer(&mut self, references: &[ValueReference], values: &[i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let set = self.functions.set_integer;
        // SAFETY: as in `get_real`.
        let status =
            unsafe { set(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_ptr()) };
        self.checked("fmi2SetInteger", status)
    }

    /// The log lines since the last refused call, which are then forgotten.
    pub fn take_log(&mut self) -> String {
        drain(&self.log)
    }

    fn checked(&self, function: &'static str, status: Status) -> Result<(), FmuError> {
        if status == 0 || status == 1 {
            return Ok(());
        }
        let known = usize::try_from(status).ok().and_then(|status| STATUS_NAMES.get(status));
        let status = known.copied().unwrap_or("an unknown status");
        Err(FmuError::Refused { function, status, log: drain(&self.log) })
    }
}

fn same_length(references: &[ValueReference], values: usize) -> Result<(), FmuError> {
    if references.len() == values {
        Ok(())
    } else {
        Err(FmuError::Lengths { references: references.len(), values })
    }
}

impl Drop for Instance<'_> {
    fn drop(&mut self) {
        // SAFETY: the instance is alive and nobody can use it afterwards; its library is still loaded,
        // because `functions` borrows from the `Fmu`.
        unsafe { (self.functions.free_instance)(self.component.as_ptr()) };
    }
}

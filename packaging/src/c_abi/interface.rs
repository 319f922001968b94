//! The C side: types of `fmi2FunctionTypes.h`, the functions of a library, and the logger that an FMU calls.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Mutex, PoisonError};

use libloading::{Library, Symbol};

use super::ValueReference;

pub(super) type Component = *mut c_void;
pub(super) type Status = c_int;
pub(super) const STATUS_NAMES: [&str; 6] =
    ["fmi2OK", "fmi2Warning", "fmi2Discard", "fmi2Error", "fmi2Fatal", "fmi2Pending"];
pub(super) const TRUE: c_int = 1;
pub(super) const FALSE: c_int = 0;
pub(super) const CO_SIMULATION: c_int = 1;

pub(super) type Logger =
    unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
pub(super) struct Callbacks {
    pub(super) logger: Logger,
    pub(super) allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub(super) free_memory: unsafe extern "C" fn(*mut c_void),
    pub(super) step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    pub(super) environment: *mut c_void,
}

// SAFETY: defined in `log_line.c` with this signature; the last two are those of the C library.
unsafe extern "C" {
    pub(super) fn flexible_aircraft_importer_logger(
        environment: *mut c_void,
        instance: *const c_char,
        status: Status,
        category: *const c_char,
        message: *const c_char,
        ...
    );
    pub(super) fn calloc(count: usize, size: usize) -> *mut c_void;
    pub(super) fn free(memory: *mut c_void);
}

pub(super) type Log = Mutex<Vec<String>>;

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
pub(super) struct Functions {
    pub(super) instantiate: unsafe extern "C" fn(
        *const c_char,
        c_int,
        *const c_char,
        *const c_char,
        *const Callbacks,
        c_int,
        c_int,
    ) -> Component,
    pub(super) free_instance: unsafe extern "C" fn(Component),
    pub(super) setup_experiment: unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> Status,
    pub(super) enter_initialization_mode: unsafe extern "C" fn(Component) -> Status,
    pub(super) exit_initialization_mode: unsafe extern "C" fn(Component) -> Status,
    pub(super) terminate: unsafe extern "C" fn(Component) -> Status,
    pub(super) reset: unsafe extern "C" fn(Component) -> Status,
    pub(super) get_real: unsafe extern "C" fn(Component, *const ValueReference, usize, *mut f64) -> Status,
    pub(super) set_real: unsafe extern "C" fn(Component, *const ValueReference, usize, *const f64) -> Status,
    pub(super) get_integer:
        unsafe extern "C" fn(Component, *const ValueReference, usize, *mut c_int) -> Status,
    pub(super) set_integer:
        unsafe extern "C" fn(Component, *const ValueReference, usize, *const c_int) -> Status,
    pub(super) do_step: unsafe extern "C" fn(Component, f64, f64, c_int) -> Status,
}

impl Functions {
    pub(super) fn of(library: &Library) -> Result<Self, libloading::Error> {
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

/// The lines of a log, which are then forgotten.
pub(super) fn drain(log: &Log) -> String {
    log.lock().unwrap_or_else(PoisonError::into_inner).drain(..).collect::<Vec<_>>().join("\n")
}

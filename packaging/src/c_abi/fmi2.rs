//! FMI 2.0: types of `fmi2FunctionTypes.h` and the functions of a library.

use std::ffi::{c_char, c_int, c_void};

use libloading::Library;

use super::log::flexible_aircraft_importer_logger;
use super::symbol::function;
use super::value_reference::ValueReference;

pub(super) type Component = *mut c_void;
pub(super) type Status = c_int;
pub(super) const STATUS_NAMES: [&str; 6] =
    ["fmi2OK", "fmi2Warning", "fmi2Discard", "fmi2Error", "fmi2Fatal", "fmi2Pending"];
pub(super) const TRUE: c_int = 1;
pub(super) const FALSE: c_int = 0;
pub(super) const MODEL_EXCHANGE: c_int = 0;
pub(super) const CO_SIMULATION: c_int = 1;

type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
pub(super) struct Callbacks {
    logger: Logger,
    allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    free_memory: unsafe extern "C" fn(*mut c_void),
    step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    environment: *mut c_void,
}

impl Callbacks {
    /// Those that log into an environment, which is a [`Log`](super::log::Log).
    pub(super) fn logging_to(environment: *mut c_void) -> Self {
        Callbacks {
            logger: flexible_aircraft_importer_logger,
            allocate_memory: calloc,
            free_memory: free,
            step_finished: None,
            environment,
        }
    }
}

/// `fmi2EventInfo`.
#[derive(Default)]
#[repr(C)]
pub(super) struct EventInfo {
    pub(super) new_discrete_states_needed: c_int,
    pub(super) terminate_simulation: c_int,
    pub(super) nominals_of_continuous_states_changed: c_int,
    pub(super) values_of_continuous_states_changed: c_int,
    pub(super) next_event_time_defined: c_int,
    pub(super) next_event_time: f64,
}

// SAFETY: those of the C library.
unsafe extern "C" {
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

type Call = unsafe extern "C" fn(Component) -> Status;
type GetNumbers<T> = unsafe extern "C" fn(Component, *const ValueReference, usize, *mut T) -> Status;
type SetNumbers<T> = unsafe extern "C" fn(Component, *const ValueReference, usize, *const T) -> Status;

/// The functions that are called, with the C signatures of `fmi2FunctionTypes.h`.
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
    pub(super) enter_initialization_mode: Call,
    pub(super) exit_initialization_mode: Call,
    pub(super) terminate: Call,
    pub(super) reset: Call,
    pub(super) get_real: GetNumbers<f64>,
    pub(super) set_real: SetNumbers<f64>,
    pub(super) get_integer: GetNumbers<c_int>,
    pub(super) set_integer: SetNumbers<c_int>,
    pub(super) do_step: unsafe extern "C" fn(Component, f64, f64, c_int) -> Status,
    pub(super) new_discrete_states: unsafe extern "C" fn(Component, *mut EventInfo) -> Status,
    pub(super) enter_continuous_time_mode: Call,
    pub(super) set_time: unsafe extern "C" fn(Component, f64) -> Status,
    pub(super) set_continuous_states: unsafe extern "C" fn(Component, *const f64, usize) -> Status,
    pub(super) get_continuous_states: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
    pub(super) get_derivatives: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
}

impl Functions {
    pub(super) fn of(library: &Library) -> Result<Self, libloading::Error> {
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
                new_discrete_states: function(library, "fmi2NewDiscreteStates")?,
                enter_continuous_time_mode: function(library, "fmi2EnterContinuousTimeMode")?,
                set_time: function(library, "fmi2SetTime")?,
                set_continuous_states: function(library, "fmi2SetContinuousStates")?,
                get_continuous_states: function(library, "fmi2GetContinuousStates")?,
                get_derivatives: function(library, "fmi2GetDerivatives")?,
            })
        }
    }
}

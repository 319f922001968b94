//! The C types of FMI 2.0 (`fmi2TypesPlatform.h`, `fmi2FunctionTypes.h`), platform "default".

use libc::{c_char, c_double, c_int, c_uint, c_void, size_t};

pub use crate::fmi::status::Status;

/// `fmi2Component`: an instance, opaque to the importer.
pub type Component = *mut c_void;
/// `fmi2FMUstate`: a saved state, opaque to the importer.
pub type FmuState = *mut c_void;
/// `fmi2ComponentEnvironment`: the importer's own, passed back to its callbacks.
pub type ComponentEnvironment = *mut c_void;
/// `fmi2ValueReference`.
pub type ValueReference = c_uint;
/// `fmi2Real`.
pub type Real = c_double;
/// `fmi2Integer`.
pub type Integer = c_int;
/// `fmi2Boolean`: 0 is false.
pub type Boolean = c_int;
/// `fmi2String`: NUL-terminated UTF-8.
pub type CString = *const c_char;
/// `fmi2Byte`.
pub type Byte = c_char;

/// `fmi2False`.
pub const FALSE: Boolean = 0;
/// `fmi2CoSimulation` of `fmi2Type`.
pub const CO_SIMULATION: c_int = 1;
/// `fmi2ModelExchange` of `fmi2Type`.
pub const MODEL_EXCHANGE: c_int = 0;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
pub const LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
pub const TERMINATED: c_int = 3;

/// `fmi2EventInfo`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EventInfo {
    /// `newDiscreteStatesNeeded`.
    pub new_discrete_states_needed: Boolean,
    /// `terminateSimulation`.
    pub terminate_simulation: Boolean,
    /// `nominalsOfContinuousStatesChanged`.
    pub nominals_changed: Boolean,
    /// `valuesOfContinuousStatesChanged`.
    pub values_changed: Boolean,
    /// `nextEventTimeDefined`.
    pub next_event_time_defined: Boolean,
    /// s.
    pub next_event_time: Real,
}

/// `fmi2CallbackLogger`: environment, instance name, status, category, format, arguments of the format.
pub type CallbackLogger = unsafe extern "C" fn(ComponentEnvironment, CString, Status, CString, CString, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CallbackFunctions {
    /// May be NULL: then nothing is logged.
    pub logger: Option<CallbackLogger>,
    /// Not used, as `canNotUseMemoryManagementFunctions` says.
    pub allocate_memory: Option<unsafe extern "C" fn(size_t, size_t) -> *mut c_void>,
    /// Not used.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Not used: no step runs asynchronously.
    pub step_finished: Option<unsafe extern "C" fn(ComponentEnvironment, Status)>,
    /// Passed to the logger.
    pub component_environment: ComponentEnvironment,
}

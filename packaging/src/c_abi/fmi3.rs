//! FMI 3.0: types of `fmi3FunctionTypes.h` and the functions of a library.

use std::ffi::{c_char, c_int, c_void};

use libloading::Library;

use super::symbol::function;
use super::value_reference::ValueReference;

pub(super) type Component = *mut c_void;
pub(super) type Status = c_int;
pub(super) const STATUS_NAMES: [&str; 5] = ["fmi3OK", "fmi3Warning", "fmi3Discard", "fmi3Error", "fmi3Fatal"];

/// `fmi3Boolean`, the `bool` of C: a byte that is 0 or 1.
pub(super) type Boolean = u8;
pub(super) const TRUE: Boolean = 1;
pub(super) const FALSE: Boolean = 0;

/// `fmi3LogMessageCallback`.
type LogMessage = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// `fmi3IntermediateUpdateCallback`, which nobody calls.
type IntermediateUpdate =
    unsafe extern "C" fn(*mut c_void, f64, Boolean, Boolean, Boolean, Boolean, *mut Boolean, *mut f64);

type Call = unsafe extern "C" fn(Component) -> Status;
type GetNumbers<T> = unsafe extern "C" fn(Component, *const ValueReference, usize, *mut T, usize) -> Status;
type SetNumbers<T> = unsafe extern "C" fn(Component, *const ValueReference, usize, *const T, usize) -> Status;

/// The functions that are called, with the C signatures of `fmi3FunctionTypes.h`.
pub(super) struct Functions {
    /// The name, the token, the resource path, visible, loggingOn, eventModeUsed, earlyReturnAllowed, required
    /// intermediate variables and their number, the environment, its log, intermediateUpdate.
    pub(super) instantiate_co_simulation: unsafe extern "C" fn(
        *const c_char,
        *const c_char,
        *const c_char,
        Boolean,
        Boolean,
        Boolean,
        Boolean,
        *const ValueReference,
        usize,
        *mut c_void,
        Option<LogMessage>,
        Option<IntermediateUpdate>,
    ) -> Component,
    /// The name, the token, the resource path, visible, loggingOn, the environment, its log.
    pub(super) instantiate_model_exchange: unsafe extern "C" fn(
        *const c_char,
        *const c_char,
        *const c_char,
        Boolean,
        Boolean,
        *mut c_void,
        Option<LogMessage>,
    ) -> Component,
    pub(super) free_instance: unsafe extern "C" fn(Component),
    pub(super) enter_initialization_mode:
        unsafe extern "C" fn(Component, Boolean, f64, f64, Boolean, f64) -> Status,
    pub(super) exit_initialization_mode: Call,
    pub(super) terminate: Call,
    pub(super) reset: Call,
    pub(super) get_float64: GetNumbers<f64>,
    pub(super) set_float64: SetNumbers<f64>,
    pub(super) get_int32: GetNumbers<i32>,
    pub(super) set_int32: SetNumbers<i32>,
    /// The point, the step, noSetFMUStatePriorToCurrentPoint; eventHandlingNeeded, terminateSimulation, earlyReturn,
    /// lastSuccessfulTime.
    pub(super) do_step: unsafe extern "C" fn(
        Component,
        f64,
        f64,
        Boolean,
        *mut Boolean,
        *mut Boolean,
        *mut Boolean,
        *mut f64,
    ) -> Status,
    /// discreteStatesNeedUpdate, terminateSimulation, nominalsOfContinuousStatesChanged,
    /// valuesOfContinuousStatesChanged, nextEventTimeDefined, nextEventTime.
    pub(super) update_discrete_states: unsafe extern "C" fn(
        Component,
        *mut Boolean,
        *mut Boolean,
        *mut Boolean,
        *mut Boolean,
        *mut Boolean,
        *mut f64,
    ) -> Status,
    pub(super) enter_continuous_time_mode: Call,
    pub(super) set_time: unsafe extern "C" fn(Component, f64) -> Status,
    pub(super) set_continuous_states: unsafe extern "C" fn(Component, *const f64, usize) -> Status,
    pub(super) get_continuous_states: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
    pub(super) get_continuous_state_derivatives: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
}

impl Functions {
    pub(super) fn of(library: &Library) -> Result<Self, libloading::Error> {
        // SAFETY: the field types are the signatures that FMI 3.0 prescribes for these names.
        unsafe {
            Ok(Functions {
                instantiate_co_simulation: function(library, "fmi3InstantiateCoSimulation")?,
                instantiate_model_exchange: function(library, "fmi3InstantiateModelExchange")?,
                free_instance: function(library, "fmi3FreeInstance")?,
                enter_initialization_mode: function(library, "fmi3EnterInitializationMode")?,
                exit_initialization_mode: function(library, "fmi3ExitInitializationMode")?,
                terminate: function(library, "fmi3Terminate")?,
                reset: function(library, "fmi3Reset")?,
                get_float64: function(library, "fmi3GetFloat64")?,
                set_float64: function(library, "fmi3SetFloat64")?,
                get_int32: function(library, "fmi3GetInt32")?,
                set_int32: function(library, "fmi3SetInt32")?,
                do_step: function(library, "fmi3DoStep")?,
                update_discrete_states: function(library, "fmi3UpdateDiscreteStates")?,
                enter_continuous_time_mode: function(library, "fmi3EnterContinuousTimeMode")?,
                set_time: function(library, "fmi3SetTime")?,
                set_continuous_states: function(library, "fmi3SetContinuousStates")?,
                get_continuous_states: function(library, "fmi3GetContinuousStates")?,
                get_continuous_state_derivatives: function(library, "fmi3GetContinuousStateDerivatives")?,
            })
        }
    }
}

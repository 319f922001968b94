//! The C functions that a target calls, of both versions of FMI under the same names.

use std::ffi::{c_char, c_int, c_void};

use flexible_aircraft::fmi::Version;

/// An instance, or a saved state.
pub type Handle = *mut c_void;

pub const OK: c_int = 0;
pub const ERROR: c_int = 3;
pub const FATAL: c_int = 4;

// SAFETY: as in fmi2Functions.h and fmi3Functions.h; the library is linked in, `description::token` sees to that.
unsafe extern "C" {
    pub fn fmi2Instantiate(
        name: *const c_char,
        kind: c_int,
        guid: *const c_char,
        resources: *const c_char,
        callbacks: *const [*const c_void; 5],
        visible: c_int,
        logging_on: c_int,
    ) -> Handle;
    fn fmi2FreeInstance(component: Handle);
    fn fmi2SetupExperiment(
        component: Handle,
        tolerance_defined: c_int,
        tolerance: f64,
        start: f64,
        stop_defined: c_int,
        stop: f64,
    ) -> c_int;
    fn fmi2EnterInitializationMode(component: Handle) -> c_int;
    fn fmi2ExitInitializationMode(component: Handle) -> c_int;
    fn fmi2Reset(component: Handle) -> c_int;
    fn fmi2DoStep(component: Handle, point: f64, size: f64, no_set_state: c_int) -> c_int;
    fn fmi2GetRealStatus(component: Handle, kind: c_int, value: *mut f64) -> c_int;
    fn fmi2GetReal(component: Handle, references: *const u32, count: usize, values: *mut f64) -> c_int;
    fn fmi2GetFMUstate(component: Handle, state: *mut Handle) -> c_int;
    fn fmi2SetFMUstate(component: Handle, state: Handle) -> c_int;
    fn fmi2FreeFMUstate(component: Handle, state: *mut Handle) -> c_int;
    fn fmi2SerializedFMUstateSize(component: Handle, state: Handle, size: *mut usize) -> c_int;
    fn fmi2SerializeFMUstate(component: Handle, state: Handle, bytes: *mut u8, size: usize) -> c_int;
    fn fmi2DeSerializeFMUstate(component: Handle, bytes: *const u8, size: usize, state: *mut Handle)
    -> c_int;
    fn fmi2EnterContinuousTimeMode(component: Handle) -> c_int;
    fn fmi2GetDerivatives(component: Handle, rates: *mut f64, count: usize) -> c_int;
    fn fmi2GetContinuousStates(component: Handle, states: *mut f64, count: usize) -> c_int;
    fn fmi2SetContinuousStates(component: Handle, states: *const f64, count: usize) -> c_int;

    pub fn fmi3InstantiateCoSimulation(
        name: *const c_char,
        token: *const c_char,
        resources: *const c_char,
        visible: u8,
        logging_on: u8,
        event_mode_used: u8,
        early_return_allowed: u8,
        intermediate_variables: *const u32,
        intermediate_variable_count: usize,
        environment: *mut c_void,
        log_message: *mut c_void,
        intermediate_update: *mut c_void,
    ) -> Handle;
    pub fn fmi3InstantiateModelExchange(
        name: *const c_char,
        token: *const c_char,
        resources: *const c_char,
        visible: u8,
        logging_on: u8,
        environment: *mut c_void,
        log_message: *mut c_void,
    ) -> Handle;
    fn fmi3FreeInstance(instance: Handle);
    fn fmi3EnterInitializationMode(
        instance: Handle,
        tolerance_defined: u8,
        tolerance: f64,
        start: f64,
        stop_defined: u8,
        stop: f64,
    ) -> c_int;
    fn fmi3ExitInitializationMode(instance: Handle) -> c_int;
    fn fmi3Reset(instance: Handle) -> c_int;
    fn fmi3DoStep(
        instance: Handle,
        point: f64,
        size: f64,
        no_set_state: u8,
        event_handling_needed: *mut u8,
        terminate_simulation: *mut u8,
        early_return: *mut u8,
        last_successful_time: *mut f64,
    ) -> c_int;
    fn fmi3GetFloat64(
        instance: Handle,
        references: *const u32,
        count: usize,
        values: *mut f64,
        value_count: usize,
    ) -> c_int;
    fn fmi3GetFMUState(instance: Handle, state: *mut Handle) -> c_int;
    fn fmi3SetFMUState(instance: Handle, state: Handle) -> c_int;
    fn fmi3FreeFMUState(instance: Handle, state: *mut Handle) -> c_int;
    fn fmi3SerializedFMUStateSize(instance: Handle, state: Handle, size: *mut usize) -> c_int;
    fn fmi3SerializeFMUState(instance: Handle, state: Handle, bytes: *mut u8, size: usize) -> c_int;
    fn fmi3DeserializeFMUState(instance: Handle, bytes: *const u8, size: usize, state: *mut Handle) -> c_int;
    fn fmi3EnterContinuousTimeMode(instance: Handle) -> c_int;
    fn fmi3GetContinuousStateDerivatives(instance: Handle, rates: *mut f64, count: usize) -> c_int;
    fn fmi3GetContinuousStates(instance: Handle, states: *mut f64, count: usize) -> c_int;
    fn fmi3SetContinuousStates(instance: Handle, states: *const f64, count: usize) -> c_int;
}

/// What an instance can be asked; all functions want one that is alive, and arrays as long as said.
pub struct Functions {
    pub free: unsafe extern "C" fn(Handle),
    /// From whatever state into the initialisation.
    pub initialise: unsafe fn(Handle) -> c_int,
    pub exit_initialization: unsafe extern "C" fn(Handle) -> c_int,
    pub step: unsafe fn(Handle, f64, f64) -> c_int,
    /// That has been reached by steps, if it is known.
    pub time: unsafe fn(Handle, Option<u32>) -> Option<f64>,
    pub get_reals: unsafe fn(Handle, &[u32], &mut [f64]) -> c_int,
    pub get_state: unsafe extern "C" fn(Handle, *mut Handle) -> c_int,
    pub set_state: unsafe extern "C" fn(Handle, Handle) -> c_int,
    pub free_state: unsafe extern "C" fn(Handle, *mut Handle) -> c_int,
    pub state_size: unsafe extern "C" fn(Handle, Handle, *mut usize) -> c_int,
    pub serialise: unsafe extern "C" fn(Handle, Handle, *mut u8, usize) -> c_int,
    pub deserialise: unsafe extern "C" fn(Handle, *const u8, usize, *mut Handle) -> c_int,
    pub enter_continuous_time: unsafe extern "C" fn(Handle) -> c_int,
    pub rates: unsafe extern "C" fn(Handle, *mut f64, usize) -> c_int,
    pub states: unsafe extern "C" fn(Handle, *mut f64, usize) -> c_int,
    pub set_states: unsafe extern "C" fn(Handle, *const f64, usize) -> c_int,
}

impl Functions {
    pub fn of(version: Version) -> Self {
        match version {
            Version::V2 => Functions {
                free: fmi2FreeInstance,
                // SAFETY: by the caller, here and below.
                initialise: |c| unsafe {
                    fmi2Reset(c)
                        .max(fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0))
                        .max(fmi2EnterInitializationMode(c))
                },
                exit_initialization: fmi2ExitInitializationMode,
                step: |c, point, size| unsafe { fmi2DoStep(c, point, size, 0) },
                time: |c, _| {
                    let mut time = 0.0;
                    (unsafe { fmi2GetRealStatus(c, 2, &mut time) } == OK).then_some(time)
                },
                get_reals: |c, references, values| unsafe {
                    fmi2GetReal(c, references.as_ptr(), references.len(), values.as_mut_ptr())
                },
                get_state: fmi2GetFMUstate,
                set_state: fmi2SetFMUstate,
                free_state: fmi2FreeFMUstate,
                state_size: fmi2SerializedFMUstateSize,
                serialise: fmi2SerializeFMUstate,
                deserialise: fmi2DeSerializeFMUstate,
                enter_continuous_time: fmi2EnterContinuousTimeMode,
                rates: fmi2GetDerivatives,
                states: fmi2GetContinuousStates,
                set_states: fmi2SetContinuousStates,
            },
            Version::V3 => Functions {
                free: fmi3FreeInstance,
                initialise: |c| unsafe {
                    fmi3Reset(c).max(fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0))
                },
                exit_initialization: fmi3ExitInitializationMode,
                step: |c, point, size| {
                    let (mut flags, mut reached) = ([0_u8; 3], 0.0);
                    let [events, ends, returns] = &mut flags;
                    unsafe { fmi3DoStep(c, point, size, 0, events, ends, returns, &mut reached) }
                },
                // The time is the last variable of co-simulation.
                time: |c, reference| {
                    let (mut time, reference) = (0.0, reference?);
                    (unsafe { fmi3GetFloat64(c, &reference, 1, &mut time, 1) } == OK).then_some(time)
                },
                get_reals: |c, references, values| unsafe {
                    let count = references.len();
                    fmi3GetFloat64(c, references.as_ptr(), count, values.as_mut_ptr(), count)
                },
                get_state: fmi3GetFMUState,
                set_state: fmi3SetFMUState,
                free_state: fmi3FreeFMUState,
                state_size: fmi3SerializedFMUStateSize,
                serialise: fmi3SerializeFMUState,
                deserialise: fmi3DeserializeFMUState,
                enter_continuous_time: fmi3EnterContinuousTimeMode,
                rates: fmi3GetContinuousStateDerivatives,
                states: fmi3GetContinuousStates,
                set_states: fmi3SetContinuousStates,
            },
        }
    }
}

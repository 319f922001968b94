//! Saved states.

use libc::size_t;

use crate::fmi::instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, free_saved, on, saved, serialise, store, write};
use crate::fmi3::types::{Instance, StateHandle, Status};

/// Saves the state; into the given state when there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(instance: Instance, state: *mut StateHandle) -> Status {
    let body = |instance: &mut instance::Instance| {
        // SAFETY: `state` is NULL or a place that holds NULL or a state, as the module says of states.
        unsafe { store(state, |saved| instance.save_into(saved)) }
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetFMUstate, body) }
}

/// Goes back to a saved state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: Instance, state: StateHandle) -> Status {
    // SAFETY: states and instances as the module says.
    unsafe { on(instance, Operation::SetFMUstate, |instance| instance.restore(saved(state)?)) }
}

/// Frees a saved state and sets the handle to NULL; NULL is ignored, and so is a state in place of the address of its handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(instance: Instance, state: *mut StateHandle) -> Status {
    let body = |_: &mut instance::Instance| {
        // SAFETY: `state` is NULL, a place that holds NULL or a state, or a state.
        unsafe { free_saved(state) };
        Ok(())
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::FreeFMUstate, body) }
}

/// Length of a saved state in bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: Instance,
    state: StateHandle,
    size: *mut size_t,
) -> Status {
    // SAFETY: states, results and instances as the module says.
    unsafe {
        on(instance, Operation::SerializedFMUstateSize, |_| write(size, saved(state)?.bytes().len(), "size"))
    }
}

/// Copies a saved state into an array.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: Instance,
    state: StateHandle,
    bytes: *mut u8,
    size: size_t,
) -> Status {
    // SAFETY: instances, states and arrays as the module says.
    unsafe { on(instance, Operation::SerializeFMUstate, |_| serialise(state, bytes, size)) }
}

/// Makes a saved state of its bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: Instance,
    bytes: *const u8,
    size: size_t,
    state: *mut StateHandle,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        // SAFETY: arrays as the module says.
        let saved = instance.deserialise(unsafe { array(bytes, size, "serializedState") }?)?;
        // SAFETY: `state` is NULL or a place that holds NULL or a state.
        unsafe { store(state, |present| *present = saved) }
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::DeSerializeFMUstate, body) }
}

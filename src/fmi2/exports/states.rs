//! Saved states.

use libc::size_t;

use crate::fmi::instance::Instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, free_saved, on, saved, serialise, store, write};
use crate::fmi2::types::{Byte, Component, FmuState, Status};

/// Saves the state; into the given state when there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: Component, state: *mut FmuState) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: `state` is NULL or a place that holds NULL or a state, as the module says of states.
        unsafe { store(state, |saved| instance.save_into(saved)) }
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetFMUstate, body) }
}

/// Goes back to a saved state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: Component, state: FmuState) -> Status {
    // SAFETY: states and components as the module says.
    unsafe { on(component, Operation::SetFMUstate, |instance| instance.restore(saved(state)?)) }
}

/// Frees a saved state and sets the handle to NULL; NULL is ignored, and so is a state in place of the address of its handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: Component, state: *mut FmuState) -> Status {
    let body = |_: &mut Instance| {
        // SAFETY: `state` is NULL, a place that holds NULL or a state, or a state.
        unsafe { free_saved(state) };
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::FreeFMUstate, body) }
}

/// Length of a saved state in bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: Component,
    state: FmuState,
    size: *mut size_t,
) -> Status {
    // SAFETY: states, results and components as the module says.
    unsafe {
        on(component, Operation::SerializedFMUstateSize, |_| write(size, saved(state)?.bytes().len(), "size"))
    }
}

/// Copies a saved state into an array.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: Component,
    state: FmuState,
    bytes: *mut Byte,
    size: size_t,
) -> Status {
    // SAFETY: components, states and arrays as the module says.
    unsafe { on(component, Operation::SerializeFMUstate, |_| serialise(state, bytes.cast(), size)) }
}

/// Makes a saved state of its bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: Component,
    bytes: *const Byte,
    size: size_t,
    state: *mut FmuState,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let saved = instance.deserialise(unsafe { array(bytes.cast::<u8>(), size, "serializedState") }?)?;
        // SAFETY: `state` is NULL or a place that holds NULL or a state.
        unsafe { store(state, |present| *present = saved) }
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::DeSerializeFMUstate, body) }
}

//! Saved states.

use std::ptr::null_mut;

use libc::size_t;

use super::{Outcome, array, array_to_fill, on, write};
use crate::fmi::instance::{Instance, Refusal};
use crate::fmi::life_cycle::Operation;
use crate::fmi::saved_state::SavedState;
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

/// Has a state written behind a handle, into the present one when there is one.
///
/// # Safety
/// `place` is NULL or holds NULL or a state, as the module says of states.
unsafe fn store(place: *mut FmuState, write: impl FnOnce(&mut SavedState)) -> Outcome {
    // SAFETY: by the caller.
    let Some(handle) = (unsafe { place.as_mut() }) else {
        return Err(Refusal::error("FMUstate: found NULL, expected a place for the result"));
    };
    if handle.addr() == SavedState::FIRST_WORD {
        return Err(Refusal::error("FMUstate: found a state, expected the address of one"));
    }
    // SAFETY: by the caller, what is not NULL is a leaked `Box<SavedState>`.
    match unsafe { handle.cast::<SavedState>().as_mut() } {
        Some(present) => write(present),
        None => {
            let mut saved = Box::<SavedState>::default();
            write(&mut saved);
            *handle = Box::into_raw(saved).cast();
        }
    }
    Ok(())
}

/// The saved state behind a handle.
///
/// # Safety
/// As the module says of states, but the address of a handle, also of a null one, is recognised; the result must not
/// outlive the call into the FMU.
unsafe fn saved<'a>(state: FmuState) -> Result<&'a SavedState, Refusal> {
    // SAFETY: by the caller, what is not NULL is a leaked `Box<SavedState>`, which begins with a word, or the place of a handle.
    match unsafe { state.cast::<usize>().as_ref() } {
        // SAFETY: a handle is never this word, so this is the state.
        Some(&SavedState::FIRST_WORD) => Ok(unsafe { &*state.cast::<SavedState>() }),
        Some(_) => {
            Err(Refusal::error("FMUstate: found something else than a state, perhaps the address of one"))
        }
        None => Err(Refusal::error("FMUstate: found NULL")),
    }
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
        // SAFETY: `state` is NULL, a place that holds NULL or a state, or a state, which begins with a word.
        let Some(handle) = (unsafe { state.as_mut() }) else { return Ok(()) };
        if handle.addr() == SavedState::FIRST_WORD {
            return Ok(());
        }
        let owned = std::mem::replace(handle, null_mut()).cast::<SavedState>();
        if !owned.is_null() {
            // SAFETY: it is a leaked `Box<SavedState>`, and the only handle to it has been cleared.
            drop(unsafe { Box::from_raw(owned) });
        }
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
    let body = |_: &mut Instance| {
        // SAFETY: states and arrays as the module says.
        let (saved, places) =
            unsafe { (saved(state)?, array_to_fill(bytes.cast::<u8>(), size, "serializedState")?) };
        let length = saved.bytes().len();
        if places.len() < length {
            return Err(Refusal::error(format!("size: found {size}, the state needs {length} bytes")));
        }
        for (place, byte) in places.iter_mut().zip(saved.bytes()) {
            place.write(*byte);
        }
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SerializeFMUstate, body) }
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

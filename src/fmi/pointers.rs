//! What C passes and is passed: components, arrays, texts, places for results, handles of saved states. Shared by the C
//! interfaces of all versions.
//!
//! What the FMI standards ask of an importer is what all of them rely on: a component is NULL or came
//! from an instantiating function, has not been freed and is used by one thread at a time; an array has as many
//! elements as the count beside it says; a string is NUL-terminated; a state came from
//! the same component and has not been freed. NULL where an array, a string or a result belongs is refused.

use std::ffi::CStr;
use std::mem::MaybeUninit;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr::null_mut;

use libc::{c_char, c_void};

use super::instance::Instance;
use super::operation::Operation;
use super::refusal::Refusal;
use super::saved_state::SavedState;
use super::status::Status;

/// An instance, opaque to the importer.
pub type Component = *mut c_void;
/// A saved state, opaque to the importer.
pub type StateHandle = *mut c_void;

/// How the body of a function ends.
pub type Outcome = Result<(), Refusal>;

/// Hands an instance over to the importer.
pub fn leak(instance: Instance) -> Component {
    Box::into_raw(Box::new(instance)).cast()
}

/// Frees an instance; NULL is ignored.
///
/// # Safety
/// As the module says of components; it is not used any more.
pub unsafe fn free(component: Component) {
    if component.is_null() {
        return;
    }
    // SAFETY: by the caller this is a leaked `Box<Instance>` that is not used any more.
    let instance = unsafe { Box::from_raw(component.cast::<Instance>()) };
    // A panic while freeing has nobody to be told to.
    let _ = catch_unwind(AssertUnwindSafe(|| drop(instance)));
}

/// Runs `body` on the instance behind a component.
///
/// # Safety
/// As the module says of components.
pub unsafe fn on(
    component: Component,
    operation: Operation,
    body: impl FnOnce(&mut Instance) -> Outcome,
) -> Status {
    // SAFETY: a component that is not NULL is a leaked `Box<Instance>`, used by this thread alone.
    match unsafe { component.cast::<Instance>().as_mut() } {
        Some(instance) => instance.call(operation, body),
        None => Status::Error,
    }
}

/// An array of the importer.
///
/// # Safety
/// As the module says of arrays; the result must not outlive the call into the FMU.
pub unsafe fn array<'a, T>(pointer: *const T, count: usize, name: &str) -> Result<&'a [T], Refusal> {
    check_array(pointer, count, name)?;
    // SAFETY: by the caller, `count` elements are there; the count zero needs none.
    Ok(if count == 0 { &[] } else { unsafe { std::slice::from_raw_parts(pointer, count) } })
}

/// An array that the importer wants filled.
///
/// # Safety
/// As the module says of arrays; the result must not outlive the call into the FMU.
pub unsafe fn array_to_fill<'a, T>(
    pointer: *mut T,
    count: usize,
    name: &str,
) -> Result<&'a mut [MaybeUninit<T>], Refusal> {
    check_array(pointer, count, name)?;
    // SAFETY: by the caller, there is room for `count` elements, whose content may be anything.
    Ok(if count == 0 { &mut [] } else { unsafe { std::slice::from_raw_parts_mut(pointer.cast(), count) } })
}

fn check_array<T>(pointer: *const T, count: usize, name: &str) -> Outcome {
    if count > isize::MAX as usize / size_of::<T>() {
        return Err(Refusal::error(format!("{name}: {count} elements do not fit into memory")));
    }
    if count > 0 && (pointer.is_null() || !pointer.is_aligned()) {
        return Err(Refusal::error(format!("{name}: found a NULL or misaligned array of {count} elements")));
    }
    Ok(())
}

/// A string of the importer; `None` for NULL. Bytes that are not UTF-8 become replacement characters.
///
/// # Safety
/// As the module says of strings.
pub unsafe fn text(pointer: *const c_char) -> Option<String> {
    // SAFETY: as the caller's.
    unsafe { bytes(pointer) }.map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// The bytes of a string of the importer; `None` for NULL.
///
/// # Safety
/// As the module says of strings; the result must not outlive the call into the FMU.
pub unsafe fn bytes<'a>(pointer: *const c_char) -> Option<&'a [u8]> {
    if pointer.is_null() {
        return None;
    }
    // SAFETY: by the caller, the string is NUL-terminated.
    Some(unsafe { CStr::from_ptr(pointer) }.to_bytes())
}

/// Writes a result of a call.
///
/// # Safety
/// `place` is NULL or room for a `T`.
pub unsafe fn write<T>(place: *mut T, value: T, name: &str) -> Outcome {
    if place.is_null() {
        return Err(Refusal::error(format!("{name}: found NULL, expected a place for the result")));
    }
    // SAFETY: by the caller, a `T` may be written there; what was there is not dropped.
    unsafe { place.write(value) };
    Ok(())
}

/// Has a state written behind a handle, into the present one when there is one.
///
/// # Safety
/// `place` is NULL or holds NULL or a state, as the module says of states.
pub unsafe fn store(place: *mut StateHandle, write: impl FnOnce(&mut SavedState)) -> Outcome {
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
pub unsafe fn saved<'a>(state: StateHandle) -> Result<&'a SavedState, Refusal> {
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

/// Frees a saved state and sets the handle to NULL; NULL is ignored, and so is a state in place of the address of its handle.
///
/// # Safety
/// `state` is NULL, a place that holds NULL or a state, or a state.
pub unsafe fn free_saved(state: *mut StateHandle) {
    // SAFETY: by the caller; a state begins with a word.
    let Some(handle) = (unsafe { state.as_mut() }) else { return };
    if handle.addr() == SavedState::FIRST_WORD {
        return;
    }
    let owned = std::mem::replace(handle, null_mut()).cast::<SavedState>();
    if !owned.is_null() {
        // SAFETY: it is a leaked `Box<SavedState>`, and the only handle to it has been cleared.
        drop(unsafe { Box::from_raw(owned) });
    }
}

/// Copies a saved state into an array of bytes.
///
/// # Safety
/// As the module says of states and arrays.
pub unsafe fn serialise(state: StateHandle, bytes: *mut u8, size: usize) -> Outcome {
    // SAFETY: by the caller.
    let (saved, places) = unsafe { (saved(state)?, array_to_fill(bytes, size, "serializedState")?) };
    let length = saved.bytes().len();
    if places.len() < length {
        return Err(Refusal::error(format!("size: found {size}, the state needs {length} bytes")));
    }
    for (place, byte) in places.iter_mut().zip(saved.bytes()) {
        place.write(*byte);
    }
    Ok(())
}

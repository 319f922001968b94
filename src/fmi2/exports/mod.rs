//! The functions of `fmi2Functions.h`.
//!
//! Each turns C's arguments into safe types and hands them to the [`Instance`]. What the FMI 2.0 standard
//! asks of an importer is what all of them rely on, and is not repeated at each: a component is NULL or came
//! from `fmi2Instantiate`, has not been freed and is used by one thread at a time; an array has as many
//! elements as the count beside it says; a string is NUL-terminated; a state came from
//! `fmi2GetFMUstate` or `fmi2DeSerializeFMUstate` of the same component and has not been freed. NULL where an
//! array, a string or a result belongs is refused.

mod co_simulation;
mod common;
mod model_exchange;
mod states;
mod variables;

use std::ffi::CStr;
use std::mem::MaybeUninit;

use super::types::{CString, Component, Status};
use crate::fmi::instance::{Instance, Refusal};
use crate::fmi::life_cycle::Operation;

#[cfg(test)]
pub(super) use {co_simulation::*, common::*, model_exchange::*, states::*, variables::*};

type Outcome = Result<(), Refusal>;

/// Runs `body` on the instance behind a component.
///
/// # Safety
/// As the module says of components.
unsafe fn on(
    component: Component,
    operation: Operation,
    body: impl FnOnce(&mut Instance) -> Outcome,
) -> Status {
    // SAFETY: a component that is not NULL is a `Box<Instance>` leaked by fmi2Instantiate, used by this
    // thread alone.
    match unsafe { component.cast::<Instance>().as_mut() } {
        Some(instance) => instance.call(operation, body),
        None => Status::Error,
    }
}

/// An array of the importer.
///
/// # Safety
/// As the module says of arrays; the result must not outlive the call into the FMU.
unsafe fn array<'a, T>(pointer: *const T, count: usize, name: &str) -> Result<&'a [T], Refusal> {
    check_array(pointer, count, name)?;
    // SAFETY: by the caller, `count` elements are there; the count zero needs none.
    Ok(if count == 0 { &[] } else { unsafe { std::slice::from_raw_parts(pointer, count) } })
}

/// An array that the importer wants filled.
///
/// # Safety
/// As the module says of arrays; the result must not outlive the call into the FMU.
unsafe fn array_to_fill<'a, T>(
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
unsafe fn text(pointer: CString) -> Option<String> {
    // SAFETY: as the caller's.
    unsafe { bytes(pointer) }.map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// The bytes of a string of the importer; `None` for NULL.
///
/// # Safety
/// As the module says of strings; the result must not outlive the call into the FMU.
unsafe fn bytes<'a>(pointer: CString) -> Option<&'a [u8]> {
    if pointer.is_null() {
        return None;
    }
    // SAFETY: by the caller, the string is NUL-terminated.
    Some(unsafe { CStr::from_ptr(pointer) }.to_bytes())
}

/// Writes a result.
///
/// # Safety
/// `place` is NULL or a place for a `T`.
unsafe fn write<T>(place: *mut T, value: T, name: &str) -> Outcome {
    if place.is_null() {
        return Err(Refusal::error(format!("{name}: found NULL, expected a place for the result")));
    }
    // SAFETY: by the caller, a `T` may be written there; what was there is not dropped.
    unsafe { place.write(value) };
    Ok(())
}

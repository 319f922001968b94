//! Getting and setting variables.

use std::ffi::c_int;

use super::{array, array_to_fill, on};
use crate::fmi2::instance::Instance;
use crate::fmi2::life_cycle::Function;
use crate::fmi2::types::{Boolean, CString, Component, Status, ValueReference};
use crate::fmi2::values::Family;
use crate::variables::Value;

/// Values of Reals.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut f64,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, places) =
            unsafe { (array(references, count, "vr")?, array_to_fill(values, count, "value")?) };
        instance.get(Family::Real, references, |i, value| {
            if let Value::Real(x) = value {
                places[i].write(x);
            }
        })
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetReal, body) }
}

/// Values of Integers and Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut c_int,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, places) =
            unsafe { (array(references, count, "vr")?, array_to_fill(values, count, "value")?) };
        instance.get(Family::Integer, references, |i, value| {
            if let Value::Integer(x) = value {
                places[i].write(x);
            }
        })
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetInteger, body) }
}

/// Sets Reals.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const f64,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, values) =
            unsafe { (array(references, count, "vr")?, array(values, count, "value")?) };
        instance.set(Family::Real, references, values.iter().map(|x| Value::Real(*x)))
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Function::SetReal, body) }
}

/// Sets Integers and Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const c_int,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, values) =
            unsafe { (array(references, count, "vr")?, array(values, count, "value")?) };
        instance.set(Family::Integer, references, values.iter().map(|i| Value::Integer(*i)))
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Function::SetInteger, body) }
}

/// Refuses any Boolean or String: there are none.
///
/// # Safety
/// As the module says.
unsafe fn none_of_type(
    component: Component,
    function: Function,
    references: *const ValueReference,
    count: usize,
    wanted: &str,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        instance.none_of_type(unsafe { array(references, count, "vr") }?, wanted)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, function, body) }
}

/// Values of Booleans, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _values: *mut Boolean,
) -> Status {
    // SAFETY: as the module says.
    unsafe { none_of_type(component, Function::GetBoolean, references, count, "a Boolean") }
}

/// Values of Strings, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _values: *mut CString,
) -> Status {
    // SAFETY: as the module says.
    unsafe { none_of_type(component, Function::GetString, references, count, "a String") }
}

/// Sets Booleans, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _values: *const Boolean,
) -> Status {
    // SAFETY: as the module says.
    unsafe { none_of_type(component, Function::SetBoolean, references, count, "a Boolean") }
}

/// Sets Strings, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _values: *const CString,
) -> Status {
    // SAFETY: as the module says.
    unsafe { none_of_type(component, Function::SetString, references, count, "a String") }
}

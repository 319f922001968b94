//! Getting and setting variables.

use libc::size_t;

use crate::fmi::instance::Instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, array_to_fill, on};
use crate::fmi::values::Numbers;
use crate::fmi2::types::{Boolean, CString, Component, FALSE, Integer, Real, Status, ValueReference};
use crate::variables::Value;

/// Values of Reals.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *mut Real,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, places) =
            unsafe { (array(references, count, "vr")?, array_to_fill(values, count, "value")?) };
        instance.get(Numbers::Real, references, |i, value| {
            if let Value::Real(x) = value {
                places[i].write(x);
            }
        })
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetReal, body) }
}

/// Values of Integers and Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *mut Integer,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, places) =
            unsafe { (array(references, count, "vr")?, array_to_fill(values, count, "value")?) };
        instance.get(Numbers::Integer, references, |i, value| {
            if let Value::Integer(x) = value {
                places[i].write(x);
            }
        })
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetInteger, body) }
}

/// Sets Reals.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *const Real,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, values) =
            unsafe { (array(references, count, "vr")?, array(values, count, "value")?) };
        instance.set(Numbers::Real, references, values.iter().map(|x| Value::Real(*x)))
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetReal, body) }
}

/// Sets Integers and Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *const Integer,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, values) =
            unsafe { (array(references, count, "vr")?, array(values, count, "value")?) };
        instance.set(Numbers::Integer, references, values.iter().map(|i| Value::Integer(*i)))
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetInteger, body) }
}

/// Values of Booleans.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *mut Boolean,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, places) =
            unsafe { (array(references, count, "vr")?, array_to_fill(values, count, "value")?) };
        instance.get(Numbers::Boolean, references, |i, value| {
            if let Value::Boolean(flag) = value {
                places[i].write(Boolean::from(flag));
            }
        })
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetBoolean, body) }
}

/// Sets Booleans; whatever is not 0 is true.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    values: *const Boolean,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, values) =
            unsafe { (array(references, count, "vr")?, array(values, count, "value")?) };
        let values = values.iter().map(|flag| Value::Boolean(*flag != FALSE));
        instance.set(Numbers::Boolean, references, values)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetBoolean, body) }
}

/// Refuses any String: there are none.
///
/// # Safety
/// As the module says.
unsafe fn no_strings(
    component: Component,
    operation: Operation,
    references: *const ValueReference,
    count: size_t,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let references = unsafe { array(references, count, "vr") }?;
        instance.get(Numbers::OfNone("a String"), references, |_, _| {})
    };
    // SAFETY: components as the module says.
    unsafe { on(component, operation, body) }
}

/// Values of Strings, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    _values: *mut CString,
) -> Status {
    // SAFETY: as the module says.
    unsafe { no_strings(component, Operation::GetString, references, count) }
}

/// Sets Strings, of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    _values: *const CString,
) -> Status {
    // SAFETY: as the module says.
    unsafe { no_strings(component, Operation::SetString, references, count) }
}

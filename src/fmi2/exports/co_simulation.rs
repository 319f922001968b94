//! Steps, derivatives and the status of the slave.

use libc::{c_int, size_t};

use crate::fmi::instance::Instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{Outcome, array, array_to_fill, on, write};
use crate::fmi::refusal::Refusal;
use crate::fmi2::types::{
    Boolean, CString, Component, FALSE, Integer, LAST_SUCCESSFUL_TIME, Real, Status, TERMINATED,
    ValueReference,
};

/// How outputs change with inputs, along a direction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: Component,
    unknowns: *const ValueReference,
    unknown_count: size_t,
    knowns: *const ValueReference,
    known_count: size_t,
    known_changes: *const Real,
    unknown_changes: *mut Real,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (unknowns, knowns, direction, places) = unsafe {
            (
                array(unknowns, unknown_count, "vUnknown_ref")?,
                array(knowns, known_count, "vKnown_ref")?,
                array(known_changes, known_count, "dvKnown")?,
                array_to_fill(unknown_changes, unknown_count, "dvUnknown")?,
            )
        };
        for (place, derivative) in places.iter_mut().zip(instance.derivatives(unknowns, knowns, direction)?) {
            place.write(derivative);
        }
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetDirectionalDerivative, body) }
}

/// Rates of change of inputs, order 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    component: Component,
    references: *const ValueReference,
    count: size_t,
    orders: *const Integer,
    values: *const Real,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let (references, orders, rates) = unsafe {
            (array(references, count, "vr")?, array(orders, count, "order")?, array(values, count, "value")?)
        };
        instance.set_input_rates(references, orders, rates)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetRealInputDerivatives, body) }
}

/// Refused, as `maxOutputDerivativeOrder` 0 says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: size_t,
    _orders: *const Integer,
    _values: *mut Real,
) -> Status {
    let body = |_: &mut Instance| Err(Refusal::error("this FMU provides no derivatives of outputs"));
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetRealOutputDerivatives, body) }
}

/// Flies one communication step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: Component,
    current_communication_point: Real,
    communication_step_size: Real,
    _no_set_fmu_state_prior_to_current_point: Boolean,
) -> Status {
    let body =
        |instance: &mut Instance| instance.do_step(current_communication_point, communication_step_size);
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::DoStep, body) }
}

/// Refused: no step is ever in progress.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::CancelStep, |_| Ok(())) }
}

/// Why a status is discarded.
fn no_such_status(kind: c_int) -> Outcome {
    let reason = format!("status kind {kind} is not known for a slave that computes while it is called");
    Err(Refusal::discard(reason))
}

/// Discarded: there is no asynchronous step whose status could be asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(component: Component, kind: c_int, _value: *mut Status) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetStatus, |_| no_such_status(kind)) }
}

/// The last communication point that was reached.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(component: Component, kind: c_int, value: *mut Real) -> Status {
    let body = |instance: &mut Instance| match kind {
        // SAFETY: results as the module says.
        LAST_SUCCESSFUL_TIME => unsafe { write(value, instance.time, "value") },
        _ => no_such_status(kind),
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetRealStatus, body) }
}

/// Discarded: the standard defines none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetIntegerStatus(
    component: Component,
    kind: c_int,
    _value: *mut Integer,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetIntegerStatus, |_| no_such_status(kind)) }
}

/// Whether the slave wants to end the simulation: it never does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: Component,
    kind: c_int,
    value: *mut Boolean,
) -> Status {
    let body = |_: &mut Instance| match kind {
        // SAFETY: results as the module says.
        TERMINATED => unsafe { write(value, FALSE, "value") },
        _ => no_such_status(kind),
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetBooleanStatus, body) }
}

/// Discarded: no step is ever pending.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStringStatus(
    component: Component,
    kind: c_int,
    _value: *mut CString,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetStringStatus, |_| no_such_status(kind)) }
}

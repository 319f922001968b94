//! The functions of model exchange: importers look for them, the life cycle refuses them.

use libc::{c_void, size_t};

use super::on;
use crate::fmi::life_cycle::Operation;
use crate::fmi2::types::{Boolean, Component, Real, Status};

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterEventMode(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::EnterEventMode, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(component: Component, _event_info: *mut c_void) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::NewDiscreteStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterContinuousTimeMode(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::EnterContinuousTimeMode, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CompletedIntegratorStep(
    component: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    _enter_event_mode: *mut Boolean,
    _terminate_simulation: *mut Boolean,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::CompletedIntegratorStep, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetTime(component: Component, _time: Real) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetTime, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetContinuousStates(
    component: Component,
    _states: *const Real,
    _count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetContinuousStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDerivatives(
    component: Component,
    _derivatives: *mut Real,
    _count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetDerivatives, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetEventIndicators(
    component: Component,
    _indicators: *mut Real,
    _count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetEventIndicators, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetContinuousStates(
    component: Component,
    _states: *mut Real,
    _count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetContinuousStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetNominalsOfContinuousStates(
    component: Component,
    _nominals: *mut Real,
    _count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetNominalsOfContinuousStates, |_| Ok(())) }
}

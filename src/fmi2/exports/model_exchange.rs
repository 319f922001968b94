//! The functions of model exchange: importers look for them, the life cycle refuses them.

use std::ffi::c_void;

use super::on;
use crate::fmi2::life_cycle::Function;
use crate::fmi2::types::{Boolean, Component, Status};

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterEventMode(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::EnterEventMode, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(component: Component, _event_info: *mut c_void) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::NewDiscreteStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterContinuousTimeMode(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::EnterContinuousTimeMode, |_| Ok(())) }
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
    unsafe { on(component, Function::CompletedIntegratorStep, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetTime(component: Component, _time: f64) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::SetTime, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetContinuousStates(
    component: Component,
    _states: *const f64,
    _count: usize,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::SetContinuousStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDerivatives(
    component: Component,
    _derivatives: *mut f64,
    _count: usize,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetDerivatives, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetEventIndicators(
    component: Component,
    _indicators: *mut f64,
    _count: usize,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetEventIndicators, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetContinuousStates(
    component: Component,
    _states: *mut f64,
    _count: usize,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetContinuousStates, |_| Ok(())) }
}

/// Refused: model exchange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetNominalsOfContinuousStates(
    component: Component,
    _nominals: *mut f64,
    _count: usize,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Function::GetNominalsOfContinuousStates, |_| Ok(())) }
}

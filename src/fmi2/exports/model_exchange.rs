//! Model exchange: modes, time, states and their rates.

use libc::size_t;

use crate::fmi::instance::Instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, array_to_fill, on, write};
use crate::fmi2::types::{Boolean, Component, EventInfo, FALSE, Real, Status};

/// To the mode between stretches of time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterEventMode(component: Component) -> Status {
    let body = |instance: &mut Instance| {
        instance.enter_event_mode();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::EnterEventMode, body) }
}

/// Nothing: there are no discrete states, and no event is ahead.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(component: Component, event_info: *mut EventInfo) -> Status {
    // SAFETY: results and components as the module says.
    unsafe {
        on(component, Operation::NewDiscreteStates, |_| write(event_info, EventInfo::default(), "eventInfo"))
    }
}

/// To the mode in which the importer integrates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterContinuousTimeMode(component: Component) -> Status {
    let body = |instance: &mut Instance| {
        instance.enter_continuous_time_mode();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::EnterContinuousTimeMode, body) }
}

/// Nothing: no step ends anything.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CompletedIntegratorStep(
    component: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    let body = |_: &mut Instance| {
        // SAFETY: results as the module says.
        unsafe {
            write(enter_event_mode, FALSE, "enterEventMode")?;
            write(terminate_simulation, FALSE, "terminateSimulation")
        }
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::CompletedIntegratorStep, body) }
}

/// Takes the time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetTime(component: Component, time: Real) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetTime, |instance| instance.set_time(time)) }
}

/// Takes the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetContinuousStates(
    component: Component,
    states: *const Real,
    count: size_t,
) -> Status {
    let body = |instance: &mut Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.set_continuous_states(unsafe { array(states, count, "x") }?)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetContinuousStates, body) }
}

/// Rates of the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDerivatives(
    component: Component,
    derivatives: *mut Real,
    count: size_t,
) -> Status {
    let body = |instance: &mut Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_state_rates(unsafe { array_to_fill(derivatives, count, "derivatives") }?)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetDerivatives, body) }
}

/// Of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetEventIndicators(
    component: Component,
    _indicators: *mut Real,
    count: size_t,
) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetEventIndicators, |instance| instance.check_indicator_count(count)) }
}

/// The states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetContinuousStates(
    component: Component,
    states: *mut Real,
    count: size_t,
) -> Status {
    let body = |instance: &mut Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_continuous_states(unsafe { array_to_fill(states, count, "x") }?)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetContinuousStates, body) }
}

/// What is usual of the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetNominalsOfContinuousStates(
    component: Component,
    nominals: *mut Real,
    count: size_t,
) -> Status {
    let body = |instance: &mut Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_nominals(unsafe { array_to_fill(nominals, count, "x_nominal") }?)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::GetNominalsOfContinuousStates, body) }
}

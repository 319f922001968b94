//! Model exchange: modes, time, states and their rates.

use libc::size_t;

use crate::fmi::instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, array_to_fill, on, write};
use crate::fmi3::types::{Boolean, FALSE, Instance, Status};

/// To the mode between stretches of time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterEventMode(instance: Instance) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.enter_event_mode();
        Ok(())
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::EnterEventMode, body) }
}

/// Nothing: there are no discrete states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EvaluateDiscreteStates(instance: Instance) -> Status {
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::EvaluateDiscreteStates, |_| Ok(())) }
}

/// Nothing: there are no discrete states, and no event is ahead.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    instance: Instance,
    discrete_states_need_update: *mut Boolean,
    terminate_simulation: *mut Boolean,
    nominals_changed: *mut Boolean,
    values_changed: *mut Boolean,
    next_event_time_defined: *mut Boolean,
    next_event_time: *mut f64,
) -> Status {
    let flags = [
        (discrete_states_need_update, "discreteStatesNeedUpdate"),
        (terminate_simulation, "terminateSimulation"),
        (nominals_changed, "nominalsOfContinuousStatesChanged"),
        (values_changed, "valuesOfContinuousStatesChanged"),
        (next_event_time_defined, "nextEventTimeDefined"),
    ];
    let body = |_: &mut instance::Instance| {
        for (flag, name) in flags {
            // SAFETY: results as the module says.
            unsafe { write(flag, FALSE, name) }?;
        }
        // SAFETY: as above.
        unsafe { write(next_event_time, 0.0, "nextEventTime") }
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::NewDiscreteStates, body) }
}

/// To the mode in which the importer integrates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterContinuousTimeMode(instance: Instance) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.enter_continuous_time_mode();
        Ok(())
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::EnterContinuousTimeMode, body) }
}

/// Nothing: no step ends anything.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3CompletedIntegratorStep(
    instance: Instance,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    let body = |_: &mut instance::Instance| {
        // SAFETY: results as the module says.
        unsafe {
            write(enter_event_mode, FALSE, "enterEventMode")?;
            write(terminate_simulation, FALSE, "terminateSimulation")
        }
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::CompletedIntegratorStep, body) }
}

/// Takes the time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetTime(instance: Instance, time: f64) -> Status {
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::SetTime, |instance| instance.set_time(time)) }
}

/// Takes the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetContinuousStates(
    instance: Instance,
    states: *const f64,
    count: size_t,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.set_continuous_states(unsafe { array(states, count, "continuousStates") }?)
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::SetContinuousStates, body) }
}

/// Rates of the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStateDerivatives(
    instance: Instance,
    derivatives: *mut f64,
    count: size_t,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_state_rates(unsafe { array_to_fill(derivatives, count, "derivatives") }?)
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetDerivatives, body) }
}

/// Of which there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetEventIndicators(
    instance: Instance,
    _indicators: *mut f64,
    count: size_t,
) -> Status {
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetEventIndicators, |instance| instance.check_indicator_count(count)) }
}

/// The states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStates(
    instance: Instance,
    states: *mut f64,
    count: size_t,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_continuous_states(unsafe { array_to_fill(states, count, "continuousStates") }?)
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetContinuousStates, body) }
}

/// What is usual of the states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNominalsOfContinuousStates(
    instance: Instance,
    nominals: *mut f64,
    count: size_t,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.check_state_count(count)?;
        // SAFETY: arrays as the module says.
        instance.write_nominals(unsafe { array_to_fill(nominals, count, "nominals") }?)
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetNominalsOfContinuousStates, body) }
}

/// How many event indicators there are: none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfEventIndicators(instance: Instance, count: *mut size_t) -> Status {
    // SAFETY: results and instances as the module says.
    unsafe { on(instance, Operation::GetNumberOfEventIndicators, |_| write(count, 0, "nEventIndicators")) }
}

/// How many states there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfContinuousStates(instance: Instance, count: *mut size_t) -> Status {
    let body = |instance: &mut instance::Instance| {
        // SAFETY: results as the module says.
        unsafe { write(count, instance.state_count(), "nContinuousStates") }
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetNumberOfContinuousStates, body) }
}

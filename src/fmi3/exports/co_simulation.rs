//! Steps.

use crate::fmi::instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{on, write};
use crate::fmi::refusal::Refusal;
use crate::fmi3::types::{Boolean, FALSE, Instance, Status};

/// Flies one communication step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: Instance,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    event_handling_needed: *mut Boolean,
    terminate_simulation: *mut Boolean,
    early_return: *mut Boolean,
    last_successful_time: *mut f64,
) -> Status {
    let flags = [
        (event_handling_needed, "eventHandlingNeeded"),
        (terminate_simulation, "terminateSimulation"),
        (early_return, "earlyReturn"),
    ];
    let body = |instance: &mut instance::Instance| {
        if last_successful_time.is_null() {
            return Err(Refusal::error("lastSuccessfulTime: found NULL, expected a place for the result"));
        }
        for (flag, name) in flags {
            // SAFETY: results as the module says.
            unsafe { write(flag, FALSE, name) }?;
        }
        let flown = instance.do_step(current_communication_point, communication_step_size);
        // SAFETY: as above.
        unsafe { write(last_successful_time, instance.time, "lastSuccessfulTime") }?;
        flown
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::DoStep, body) }
}

//! Making, freeing and initialising instances.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr::null_mut;

use libc::{c_char, c_int, size_t};

use crate::fmi::instance::{Experiment, Instance};
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, bytes, free, leak, on, text};
use crate::fmi::resource;
use crate::fmi::{Interface, Kind, Version};
use crate::fmi2::logger;
use crate::fmi2::types::{
    Boolean, CO_SIMULATION, CString, CallbackFunctions, Component, FALSE, MODEL_EXCHANGE, Real, Status,
};

/// "default": the types of `fmi2TypesPlatform.h` as they are.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// "2.0".
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Makes an instance; NULL when that is not possible, with the reason in the log.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: CString,
    fmu_type: c_int,
    guid: CString,
    resource_location: CString,
    functions: *const CallbackFunctions,
    _visible: Boolean,
    logging_on: Boolean,
) -> Component {
    // SAFETY: the importer passes NULL or a structure that lives during this call.
    let Some(callbacks) = (unsafe { functions.as_ref() }) else { return null_mut() };
    // SAFETY: the importer passes NULL or NUL-terminated strings.
    let (name, guid, location) = unsafe { (text(instance_name), text(guid), bytes(resource_location)) };
    let name = name.unwrap_or_default();
    let log = || logger::log(callbacks, &name, logging_on != FALSE);
    let instantiated = catch_unwind(AssertUnwindSafe(|| {
        if name.is_empty() {
            return Err("instance name: found NULL or an empty string".to_owned());
        }
        let kind = kind_of(fmu_type)?;
        let guid = guid.ok_or("guid: found NULL")?;
        let location = location.ok_or("resource location: found NULL")?;
        let resources = resource::directory(location).map_err(|error| error.to_string())?;
        let interface = Interface { version: Version::V2, kind };
        Instance::new(interface, &resources, &guid, log()).map_err(|error| error.to_string())
    }));
    let refused = |status, reason: &str| {
        log().write(status, &format!("fmi2Instantiate: {reason}"));
        null_mut()
    };
    match instantiated {
        Ok(Ok(instance)) => leak(instance),
        Ok(Err(reason)) => refused(Status::Error, &reason),
        Err(_) => refused(Status::Fatal, "internal error, please report it"),
    }
}

/// The kind of FMU that a type means.
fn kind_of(fmu_type: c_int) -> Result<Kind, String> {
    match fmu_type {
        CO_SIMULATION => Ok(Kind::CoSimulation),
        MODEL_EXCHANGE => Ok(Kind::ModelExchange),
        _ => Err(format!(
            "type: found {fmu_type}, allowed are fmi2ModelExchange ({MODEL_EXCHANGE}) and fmi2CoSimulation ({CO_SIMULATION})"
        )),
    }
}

/// Frees an instance; NULL is ignored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: Component) {
    // SAFETY: components as the module says.
    unsafe { free(component) }
}

/// Chooses log categories.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: Component,
    logging_on: Boolean,
    category_count: size_t,
    categories: *const CString,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: arrays as the module says.
        let names = unsafe { array(categories, category_count, "categories") }?;
        // SAFETY: strings as the module says.
        let names: Vec<String> =
            names.iter().map(|name| unsafe { text(*name) }.unwrap_or_default()).collect();
        instance.choose_log(logging_on != FALSE, &names)
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetDebugLogging, body) }
}

/// Tolerance, start and stop time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: Component,
    tolerance_defined: Boolean,
    tolerance: Real,
    start: Real,
    stop_defined: Boolean,
    stop: Real,
) -> Status {
    let experiment = Experiment {
        tolerance: (tolerance_defined != FALSE).then_some(tolerance),
        start,
        stop: (stop_defined != FALSE).then_some(stop),
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::SetupExperiment, |instance| instance.set_up_experiment(experiment)) }
}

/// Begins initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: Component) -> Status {
    let body = |instance: &mut Instance| {
        instance.enter_initialization();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::EnterInitializationMode, body) }
}

/// Trims and ends initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: Component) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::ExitInitializationMode, Instance::exit_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: Component) -> Status {
    let body = |instance: &mut Instance| {
        instance.terminate();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::Terminate, body) }
}

/// Back to the state after instantiation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: Component) -> Status {
    let body = |instance: &mut Instance| {
        instance.reset();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(component, Operation::Reset, body) }
}

//! Making, freeing and initialising instances.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::ptr::null_mut;

use libc::{c_char, size_t};

use crate::fmi::instance::{self, Experiment};
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{array, bytes, free, leak, on, text};
use crate::fmi::{Interface, Kind, Version, resource};
use crate::fmi3::logger;
use crate::fmi3::types::{
    Boolean, CString, FALSE, Instance, InstanceEnvironment, LogMessageCallback, Status, UnusedCallback,
    ValueReference,
};

/// "3.0".
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// What all instantiating functions are given.
struct Request {
    token: CString,
    resource_path: CString,
    logging_on: Boolean,
    environment: InstanceEnvironment,
    log_message: Option<LogMessageCallback>,
}

/// Makes an instance; NULL when that is not possible, with the reason in the log.
///
/// # Safety
/// Token and path are NULL or NUL-terminated strings.
unsafe fn instantiate(
    function: &str,
    request: &Request,
    kind: impl FnOnce() -> Result<Kind, String>,
) -> Instance {
    let Request { token, resource_path, logging_on, environment, log_message } = *request;
    // SAFETY: by the caller.
    let (token, path) = unsafe { (text(token), bytes(resource_path)) };
    let log = || logger::log(log_message, environment, logging_on != FALSE);
    let instantiated = catch_unwind(AssertUnwindSafe(|| {
        let interface = Interface { version: Version::V3, kind: kind()? };
        let token = token.ok_or("instantiation token: found NULL")?;
        let resources = folder(path)?;
        instance::Instance::new(interface, &resources, &token, log()).map_err(|error| error.to_string())
    }));
    let refused = |status, reason: &str| {
        log().write(status, &format!("{function}: {reason}"));
        null_mut()
    };
    match instantiated {
        Ok(Ok(instance)) => leak(instance),
        Ok(Err(reason)) => refused(Status::Error, &reason),
        Err(_) => refused(Status::Fatal, "internal error, please report it"),
    }
}

/// The folder of the resources: a path as it is, or of early importers its URI.
fn folder(path: Option<&[u8]>) -> Result<PathBuf, String> {
    let path = path.ok_or("resource path: found NULL")?;
    let folder = if path.starts_with(b"file:") {
        resource::directory(path).map_err(|error| error.to_string())?
    } else {
        let path = resource::native(path.to_vec()).ok_or_else(|| {
            format!("resource path `{}`: its bytes are not UTF-8", String::from_utf8_lossy(path))
        })?;
        as_folder(&path)?;
        path
    };
    Ok(folder)
}

fn as_folder(path: &Path) -> Result<(), String> {
    if path.is_dir() {
        Ok(())
    } else {
        Err(format!("resource path: found `{}`, which is no folder", path.display()))
    }
}

/// Makes an instance that integrates by itself.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _instance_name: CString,
    token: CString,
    resource_path: CString,
    _visible: Boolean,
    logging_on: Boolean,
    event_mode_used: Boolean,
    _early_return_allowed: Boolean,
    _required_intermediate_variables: *const ValueReference,
    required_intermediate_variable_count: size_t,
    environment: InstanceEnvironment,
    log_message: Option<LogMessageCallback>,
    _intermediate_update: UnusedCallback,
) -> Instance {
    let request = Request { token, resource_path, logging_on, environment, log_message };
    let kind = || {
        if event_mode_used != FALSE {
            return Err("eventModeUsed: found true, but this FMU has no event mode".to_owned());
        }
        if required_intermediate_variable_count > 0 {
            let found = required_intermediate_variable_count;
            return Err(format!(
                "nRequiredIntermediateVariables: found {found}, but this FMU has no intermediate update (0)"
            ));
        }
        Ok(Kind::CoSimulation)
    };
    // SAFETY: the importer passes NULL or NUL-terminated strings.
    unsafe { instantiate("fmi3InstantiateCoSimulation", &request, kind) }
}

/// Makes an instance that the importer integrates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _instance_name: CString,
    token: CString,
    resource_path: CString,
    _visible: Boolean,
    logging_on: Boolean,
    environment: InstanceEnvironment,
    log_message: Option<LogMessageCallback>,
) -> Instance {
    let request = Request { token, resource_path, logging_on, environment, log_message };
    // SAFETY: the importer passes NULL or NUL-terminated strings.
    unsafe { instantiate("fmi3InstantiateModelExchange", &request, || Ok(Kind::ModelExchange)) }
}

/// Refused: there are no clocks by which it could be scheduled.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _instance_name: CString,
    token: CString,
    resource_path: CString,
    _visible: Boolean,
    logging_on: Boolean,
    environment: InstanceEnvironment,
    log_message: Option<LogMessageCallback>,
    _clock_update: UnusedCallback,
    _lock_preemption: UnusedCallback,
    _unlock_preemption: UnusedCallback,
) -> Instance {
    let request = Request { token, resource_path, logging_on, environment, log_message };
    let refused = || Err("this FMU has no clocks: it is for co-simulation or model exchange".to_owned());
    // SAFETY: the importer passes NULL or NUL-terminated strings.
    unsafe { instantiate("fmi3InstantiateScheduledExecution", &request, refused) }
}

/// Frees an instance; NULL is ignored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: Instance) {
    // SAFETY: components as the module says.
    unsafe { free(instance) }
}

/// Chooses log categories.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: Instance,
    logging_on: Boolean,
    category_count: size_t,
    categories: *const CString,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        // SAFETY: arrays as the module says.
        let names = unsafe { array(categories, category_count, "categories") }?;
        // SAFETY: strings as the module says.
        let names: Vec<String> =
            names.iter().map(|name| unsafe { text(*name) }.unwrap_or_default()).collect();
        instance.choose_log(logging_on != FALSE, &names)
    };
    // SAFETY: components as the module says.
    unsafe { on(instance, Operation::SetDebugLogging, body) }
}

/// Takes the experiment and begins initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: Instance,
    tolerance_defined: Boolean,
    tolerance: f64,
    start: f64,
    stop_defined: Boolean,
    stop: f64,
) -> Status {
    let experiment = Experiment {
        tolerance: (tolerance_defined != FALSE).then_some(tolerance),
        start,
        stop: (stop_defined != FALSE).then_some(stop),
    };
    let body = |instance: &mut instance::Instance| {
        instance.set_up_experiment(experiment)?;
        instance.enter_initialization();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(instance, Operation::EnterInitializationMode, body) }
}

/// Trims and ends initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(instance: Instance) -> Status {
    // SAFETY: components as the module says.
    unsafe { on(instance, Operation::ExitInitializationMode, instance::Instance::exit_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(instance: Instance) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.terminate();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(instance, Operation::Terminate, body) }
}

/// Back to the state after instantiation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: Instance) -> Status {
    let body = |instance: &mut instance::Instance| {
        instance.reset();
        Ok(())
    };
    // SAFETY: components as the module says.
    unsafe { on(instance, Operation::Reset, body) }
}

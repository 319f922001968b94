//! What an FMU logs, and the functions of both versions of FMI that it calls for that.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Mutex, PoisonError};

/// Lines that nobody has taken yet.
pub(super) type Log = Mutex<Vec<String>>;

// SAFETY: defined in `log_line.c` with this signature.
unsafe extern "C" {
    /// `fmi2CallbackLogger`.
    pub(super) fn flexible_aircraft_importer_logger(
        environment: *mut c_void,
        instance: *const c_char,
        status: c_int,
        category: *const c_char,
        message: *const c_char,
        ...
    );
}

/// Called by `log_line.c` with the finished line.
///
/// # Safety
/// `environment` points to a [`Log`]; `category` and `line` are C strings or null.
#[unsafe(no_mangle)]
unsafe extern "C" fn flexible_aircraft_importer_log(
    environment: *mut c_void,
    category: *const c_char,
    line: *const c_char,
) {
    // SAFETY: promised by the caller.
    unsafe { append(environment, category, line) }
}

/// `fmi3LogMessageCallback`.
///
/// # Safety
/// `environment` points to a [`Log`]; `category` and `message` are C strings or null.
pub(super) unsafe extern "C" fn log_message(
    environment: *mut c_void,
    _status: c_int,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: promised by the caller.
    unsafe { append(environment, category, message) }
}

/// # Safety
/// `environment` points to a [`Log`]; `category` and `line` are C strings or null.
unsafe fn append(environment: *mut c_void, category: *const c_char, line: *const c_char) {
    let text = |text: *const c_char| {
        // SAFETY: the caller passes C strings or null, and null has been ruled out.
        if text.is_null() { "".into() } else { unsafe { CStr::from_ptr(text) }.to_string_lossy() }
    };
    // SAFETY: `environment` is the log that `Fmu::instantiate` handed over; it outlives the instance.
    let log = unsafe { &*environment.cast::<Log>() };
    let line = format!("[{}] {}", text(category), text(line));
    log.lock().unwrap_or_else(PoisonError::into_inner).push(line);
}

/// The lines of a log, which are then forgotten.
pub(super) fn drain(log: &Log) -> String {
    log.lock().unwrap_or_else(PoisonError::into_inner).drain(..).collect::<Vec<_>>().join("\n")
}

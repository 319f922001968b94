//! Messages to the importer's logger.
//!
//! The callback is a variadic C function of printf's kind, but not every importer can take variadic
//! arguments. So the text is finished here and passed as the format, with every `%` doubled: nothing in it
//! can be taken for a conversion, and no argument follows.

use std::ffi::CString;

use super::types::{CallbackFunctions, CallbackLogger, ComponentEnvironment};
use crate::fmi::Version;
use crate::fmi::log::{Category, Log, Messenger, c_text};
use crate::fmi::status::Status;

/// The log of an instance with this name, which goes to the importer's logger.
///
/// The logger must be safe to call with the environment beside it from the thread that uses the instance: the
/// importer grants that by passing both to `fmi2Instantiate`.
pub fn log(callbacks: &CallbackFunctions, instance_name: &str, logging_on: bool) -> Log {
    let messenger = callbacks.logger.map(|callback| {
        let environment = callbacks.component_environment;
        Box::new(Logger { callback, environment, instance_name: c_text(instance_name) }) as Box<dyn Messenger>
    });
    Log::new(Version::V2, messenger, logging_on)
}

/// The importer's logger.
#[derive(Debug)]
struct Logger {
    callback: CallbackLogger,
    environment: ComponentEnvironment,
    instance_name: CString,
}

impl Messenger for Logger {
    fn pass_on(&self, status: Status, category: Category, text: &str) {
        let category = c_text(category.name());
        let format = c_text(&text.replace('%', "%%"));
        // SAFETY: the importer passed this function and its environment to fmi2Instantiate for this
        // purpose; the strings are NUL-terminated and outlive the call; the format has no conversions.
        unsafe {
            (self.callback)(
                self.environment,
                self.instance_name.as_ptr(),
                status,
                category.as_ptr(),
                format.as_ptr(),
            );
        }
    }
}

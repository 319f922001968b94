//! Messages to the importer's logger.
//!
//! The callback is no variadic function, but a `#` in its text begins the reference of a variable, so that each is doubled.

use super::types::{InstanceEnvironment, LogMessageCallback};
use crate::fmi::Version;
use crate::fmi::log::{Category, Log, Messenger, c_text};
use crate::fmi::status::Status;

/// The log of an instance, which goes to the importer's logger.
///
/// The logger must be safe to call with the environment beside it from the thread that uses the instance: the
/// importer grants that by passing both when it instantiates.
pub fn log(callback: Option<LogMessageCallback>, environment: InstanceEnvironment, logging_on: bool) -> Log {
    let messenger = callback.map(|callback| Box::new(Logger { callback, environment }) as Box<dyn Messenger>);
    Log::new(Version::V3, messenger, logging_on)
}

/// The importer's logger.
#[derive(Debug)]
struct Logger {
    callback: LogMessageCallback,
    environment: InstanceEnvironment,
}

impl Messenger for Logger {
    fn pass_on(&self, status: Status, category: Category, text: &str) {
        let category = c_text(category.name());
        let message = c_text(&text.replace('#', "##"));
        // SAFETY: the importer passed this function and its environment for this purpose; the strings are
        // NUL-terminated and outlive the call.
        unsafe { (self.callback)(self.environment, status, category.as_ptr(), message.as_ptr()) };
    }
}

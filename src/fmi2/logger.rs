//! Messages to the importer.
//!
//! The callback is a variadic C function of printf's kind, but not every importer can take variadic
//! arguments. So the text is finished here and passed as the format, with every `%` doubled: nothing in it
//! can be taken for a conversion, and no argument follows.

use std::ffi::CString;

use super::types::{CallbackLogger, ComponentEnvironment, Status};

/// A log category of the model description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    Events,
    StatusWarning,
    StatusError,
    StatusFatal,
    All,
}

impl Category {
    /// All categories, in the order of the model description.
    pub const ALL: [Category; 5] = [
        Category::Events,
        Category::StatusWarning,
        Category::StatusError,
        Category::StatusFatal,
        Category::All,
    ];

    /// Name in the model description.
    pub fn name(self) -> &'static str {
        match self {
            Category::Events => "logEvents",
            Category::StatusWarning => "logStatusWarning",
            Category::StatusError => "logStatusError",
            Category::StatusFatal => "logStatusFatal",
            Category::All => "logAll",
        }
    }

    /// What falls into it.
    pub fn description(self) -> &'static str {
        match self {
            Category::Events => "Instantiation, initialisation, trim, reset and termination",
            Category::StatusWarning => "Reasons of fmi2Warning and fmi2Discard",
            Category::StatusError => "Reasons of fmi2Error",
            Category::StatusFatal => "Reasons of fmi2Fatal",
            Category::All => "All messages",
        }
    }

    fn of(status: Status) -> Self {
        match status {
            Status::Ok => Category::Events,
            Status::Warning | Status::Discard => Category::StatusWarning,
            Status::Error => Category::StatusError,
            Status::Fatal => Category::StatusFatal,
        }
    }
}

/// The importer's logger with the categories that it wants.
#[derive(Debug)]
pub struct Logger {
    callback: Option<CallbackLogger>,
    environment: ComponentEnvironment,
    instance_name: CString,
    wanted: Vec<Category>,
}

/// What is told when debug logging is off: a warning or an error without a reason costs its finder days.
const ALWAYS: [Category; 3] = [Category::StatusWarning, Category::StatusError, Category::StatusFatal];

impl Logger {
    /// With all categories when `logging_on`, else warnings and errors only.
    ///
    /// The callback must be safe to call with `environment` from the thread that uses the instance: the
    /// importer grants that by passing both to `fmi2Instantiate`.
    pub fn new(
        callback: Option<CallbackLogger>,
        environment: ComponentEnvironment,
        instance_name: &str,
        logging_on: bool,
    ) -> Self {
        let mut logger =
            Logger { callback, environment, instance_name: c_text(instance_name), wanted: Vec::new() };
        logger.choose(logging_on, &[]);
        logger
    }

    /// `fmi2SetDebugLogging`: these categories only (none given: all), or warnings and errors only when off.
    pub fn choose(&mut self, logging_on: bool, categories: &[Category]) {
        let chosen = match (logging_on, categories) {
            (false, _) => &ALWAYS,
            (true, []) => &[Category::All][..],
            (true, some) => some,
        };
        self.wanted = chosen.to_vec();
    }

    /// Whether a message with this status would be passed on.
    pub fn wants(&self, status: Status) -> bool {
        self.callback.is_some()
            && (self.wanted.contains(&Category::All) || self.wanted.contains(&Category::of(status)))
    }

    /// Passes a message on if its category is wanted. The status determines the category.
    pub fn log(&self, status: Status, text: &str) {
        let Some(callback) = self.callback.filter(|_| self.wants(status)) else { return };
        let category = c_text(Category::of(status).name());
        let format = c_text(&text.replace('%', "%%"));
        // SAFETY: the importer passed this function and its environment to fmi2Instantiate for this
        // purpose; the strings are NUL-terminated and outlive the call; the format has no conversions.
        unsafe {
            callback(
                self.environment,
                self.instance_name.as_ptr(),
                status,
                category.as_ptr(),
                format.as_ptr(),
            );
        }
    }
}

/// As a C string; a NUL inside is left out.
fn c_text(text: &str) -> CString {
    let bytes: Vec<u8> = text.bytes().filter(|byte| *byte != 0).collect();
    CString::new(bytes).unwrap_or_default()
}

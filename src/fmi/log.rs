//! Messages to the importer: which of them it wants, and who passes them on.

use std::ffi::CString;
use std::fmt::Debug;

use super::interface::Version;
use super::life_cycle::Objection;
use super::operation::Operation;
use super::status::Status;

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

    fn of(status: Status) -> Self {
        match status {
            Status::Ok => Category::Events,
            Status::Warning | Status::Discard => Category::StatusWarning,
            Status::Error => Category::StatusError,
            Status::Fatal => Category::StatusFatal,
        }
    }
}

/// Who passes messages on to the importer, as its version of FMI wants them.
pub trait Messenger: Debug {
    /// Passes a message on.
    fn pass_on(&self, status: Status, category: Category, text: &str);
}

/// The importer's log with the categories that it wants.
#[derive(Debug)]
pub struct Log {
    version: Version,
    messenger: Option<Box<dyn Messenger>>,
    wanted: Vec<Category>,
}

/// What is told when debug logging is off: a warning or an error without a reason costs its finder days.
const ALWAYS: [Category; 3] = [Category::StatusWarning, Category::StatusError, Category::StatusFatal];

impl Log {
    /// With all categories when `logging_on`, else warnings and errors only; without a messenger nothing is told.
    pub fn new(version: Version, messenger: Option<Box<dyn Messenger>>, logging_on: bool) -> Self {
        let mut log = Log { version, messenger, wanted: Vec::new() };
        log.choose(logging_on, &[]);
        log
    }

    /// These categories only from now on (none given: all), or warnings and errors only when off.
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
        self.messenger.is_some()
            && (self.wanted.contains(&Category::All) || self.wanted.contains(&Category::of(status)))
    }

    /// Has a message passed on if its category is wanted. The status determines the category.
    pub fn write(&self, status: Status, text: &str) {
        if let Some(messenger) = self.messenger_for(status) {
            messenger.pass_on(status, Category::of(status), text);
        }
    }

    /// The same of an operation, whose function the message names.
    pub fn write_of(&self, operation: Operation, status: Status, text: &str) {
        if self.wants(status) {
            self.write(status, &format!("{}: {text}", operation.name(self.version).unwrap_or_default()));
        }
    }

    /// Says why an operation may not be asked for.
    pub fn refuse(&self, operation: Operation, objection: Objection) {
        if self.wants(Status::Error) {
            self.write_of(operation, Status::Error, &objection.text(self.version));
        }
    }

    fn messenger_for(&self, status: Status) -> Option<&dyn Messenger> {
        self.messenger.as_deref().filter(|_| self.wants(status))
    }
}

/// As a C string; a NUL inside is left out.
pub fn c_text(text: &str) -> CString {
    let bytes: Vec<u8> = text.bytes().filter(|byte| *byte != 0).collect();
    CString::new(bytes).unwrap_or_default()
}

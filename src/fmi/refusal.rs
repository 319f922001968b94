//! Why a call is refused.

use super::status::Status;

/// Why a call is refused, and with which status.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// `Error` or `Discard`.
    pub status: Status,
    /// For the log.
    pub reason: String,
}

impl Refusal {
    /// The call is wrong.
    pub fn error(reason: impl Into<String>) -> Self {
        Refusal { status: Status::Error, reason: reason.into() }
    }

    /// The call is right, but this FMU cannot answer.
    pub fn discard(reason: impl Into<String>) -> Self {
        Refusal { status: Status::Discard, reason: reason.into() }
    }
}

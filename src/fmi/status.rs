//! How a call ended.

/// The same numbers in all versions of FMI. Pending (5 in version 2) is missing: an instance computes while it is called.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// As asked for.
    Ok = 0,
    /// As asked for, but the log has something to say about it.
    Warning = 1,
    /// The call is right, but cannot be answered.
    Discard = 2,
    /// The call is wrong, and nothing has changed.
    Error = 3,
    /// The instance is broken and can only be freed.
    Fatal = 4,
}

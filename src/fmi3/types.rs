//! The C types of FMI 3.0 (`fmi3PlatformTypes.h`, `fmi3FunctionTypes.h`).

use libc::{c_char, c_void};

pub use crate::fmi::pointers::{Component as Instance, StateHandle};
pub use crate::fmi::status::Status;

/// `fmi3InstanceEnvironment`: the importer's own, passed back to its callbacks.
pub type InstanceEnvironment = *mut c_void;
/// `fmi3ValueReference`.
pub type ValueReference = u32;
/// `fmi3Boolean`, a `bool` of C: as a number, for nobody promises that an importer's is 0 or 1.
pub type Boolean = u8;
/// `fmi3Clock`, a `bool` of C.
pub type Clock = u8;
/// `fmi3String`: NUL-terminated UTF-8.
pub type CString = *const c_char;
/// `fmi3Binary`.
pub type Binary = *const u8;

/// `fmi3False`.
pub const FALSE: Boolean = 0;

/// `fmi3LogMessageCallback`: environment, status, category, message.
pub type LogMessageCallback = unsafe extern "C" fn(InstanceEnvironment, Status, CString, CString);
/// A callback that is never called.
pub type UnusedCallback = Option<unsafe extern "C" fn()>;

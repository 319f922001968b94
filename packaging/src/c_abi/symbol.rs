//! Functions of a library by their names.

use libloading::{Library, Symbol};

/// The function `name`.
///
/// # Safety
/// `T` is the type of that function.
pub(super) unsafe fn function<T: Copy>(library: &Library, name: &str) -> Result<T, libloading::Error> {
    // SAFETY: promised by the caller.
    let symbol: Symbol<'_, T> = unsafe { library.get(name) }?;
    Ok(*symbol)
}

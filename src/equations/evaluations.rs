//! How often this thread has evaluated the equations of motion: for tests of what a call costs.

use std::cell::Cell;

thread_local! {
    static COUNT: Cell<u32> = const { Cell::new(0) };
}

/// Counts one more.
pub fn count() {
    COUNT.set(COUNT.get().wrapping_add(1));
}

/// Their number; only differences mean something.
pub fn so_far() -> u32 {
    COUNT.get()
}

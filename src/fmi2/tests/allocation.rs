use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use super::*;

/// The system's allocator, counting what the thread asks for.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: everything is passed on to the system's allocator; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_step_that_succeeds_allocates_nothing() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&[("elevator", 0.05), ("wind_down", 2.0)]), Status::Ok);
    let before = ALLOCATIONS.get();
    for i in 0..50 {
        assert_eq!(fmu.step(0.013 * f64::from(i), 0.013), Status::Ok);
    }
    assert_eq!(ALLOCATIONS.get(), before);
    assert!(Fmu::new().component.is_aligned() && ALLOCATIONS.get() > before, "the count does not count");
}

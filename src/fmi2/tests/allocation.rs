use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use super::*;

/// The system's allocator, counting what the thread asks for and has not given back.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
    static BYTES_HELD: Cell<usize> = const { Cell::new(0) };
}

/// How often this thread has asked for memory so far.
pub(crate) fn allocations() -> usize {
    ALLOCATIONS.get()
}

/// How much memory this thread holds; only differences mean something.
pub(crate) fn bytes_held() -> usize {
    BYTES_HELD.get()
}

// SAFETY: everything is passed on to the system's allocator; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        BYTES_HELD.set(BYTES_HELD.get().wrapping_add(layout.size()));
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // What another thread asked for may be given back here.
        BYTES_HELD.set(BYTES_HELD.get().wrapping_sub(layout.size()));
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What a master does at each communication point: set, step, get.
#[test]
fn setting_stepping_and_getting_allocate_nothing() {
    let fmu = Fmu::flying();
    let inputs = ["elevator", "thrust_left", "thrust_right", "wind_down"].map(reference);
    let ramped = [reference("aileron")];
    let outputs =
        ["attitude.pitch", "loads.wing_root_right.bending", "deflection.wing_tip_right.up", "elevator"]
            .map(reference);
    let mut values = [0.0; 4];
    let before = ALLOCATIONS.get();
    for i in 0..50 {
        let i = f64::from(i);
        let set = fmu.set_references(&inputs, &[1e-3 * i, 10.0 * i, -10.0 * i, 0.04 * i]);
        // SAFETY: the component is alive, the arrays are as long as said.
        let (rated, stepped, got) = unsafe {
            (
                fmi2SetRealInputDerivatives(
                    fmu.component,
                    ramped.as_ptr(),
                    1,
                    [1].as_ptr(),
                    [1e-3 * i].as_ptr(),
                ),
                fmi2DoStep(fmu.component, 0.013 * i, 0.013, 1),
                fmi2GetReal(fmu.component, outputs.as_ptr(), 4, values.as_mut_ptr()),
            )
        };
        assert_eq!([set, rated, stepped, got], [Status::Ok; 4]);
    }
    assert_eq!(ALLOCATIONS.get(), before);
    assert_eq!(values[3], 0.049);
    assert!(Fmu::new().component.is_aligned() && ALLOCATIONS.get() > before, "the count does not count");
}

/// Under actuators at their limits, engines that lag and noisy sensors, saved at every point.
#[test]
fn devices_allocate_nothing_while_they_are_set_stepped_and_saved() {
    let fmu = Fmu::initialising();
    let parameters = [
        ("actuator.elevator.frequency", 40.0),
        ("actuator.elevator.rate_limit", 0.5),
        ("actuator.rudder.frequency", 30.0),
        ("engine.left.time_constant", 0.5),
        ("engine.right.maximum", 3e4),
        ("sensor.time_constant", 0.02),
        ("sensor.noise.rate", 1e-3),
    ];
    assert_eq!(fmu.set(&parameters), Status::Ok);
    assert_eq!([fmu.set_boolean("sensor.enabled", 1), fmu.set_integer("sensor.delay", 3)], [Status::Ok; 2]);
    assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
    let inputs = ["elevator", "rudder", "thrust_left"].map(reference);
    let outputs = ["surface.elevator", "actuator.elevator.rate", "sensor.rate.y"].map(reference);
    let (mut values, mut state) = ([0.0; 3], null_mut());
    // SAFETY: the component is alive, the handle is NULL and later that of a state.
    let mut save = || assert_eq!(unsafe { fmi2GetFMUstate(fmu.component, &raw mut state) }, Status::Ok);
    save();
    let before = ALLOCATIONS.get();
    for i in 0..50 {
        let i = f64::from(i);
        let set = fmu.set_references(&inputs, &[1e-2 * i, if i < 25.0 { 0.0 } else { 0.1 }, 100.0 * i]);
        // SAFETY: the component is alive, the arrays are as long as said.
        let (stepped, got) = unsafe {
            (
                fmi2DoStep(fmu.component, 0.013 * i, 0.013, 1),
                fmi2GetReal(fmu.component, outputs.as_ptr(), 3, values.as_mut_ptr()),
            )
        };
        assert_eq!([set, stepped, got], [Status::Ok; 3]);
        save();
    }
    let allocated = ALLOCATIONS.get() - before;
    // SAFETY: the component is alive, the handle is that of a state.
    assert_eq!(unsafe { fmi2FreeFMUstate(fmu.component, &raw mut state) }, Status::Ok);
    assert_eq!(allocated, 0);
}

/// What a master does that may have to take a step back.
#[test]
fn saving_into_a_state_that_is_there_allocates_nothing() {
    let fmu = Fmu::flying();
    let inputs = ["elevator", "aileron"].map(reference);
    let mut state = null_mut();
    // SAFETY: the component is alive, the handle is NULL and later that of a state.
    let mut save = || assert_eq!(unsafe { fmi2GetFMUstate(fmu.component, &raw mut state) }, Status::Ok);
    save();
    let before = ALLOCATIONS.get();
    for i in 0..50 {
        // The whole aircraft, whose state is longer, takes over halfway.
        let aileron = if i < 25 { 0.0 } else { 1e-3 };
        let set = fmu.set_references(&inputs, &[1e-4 * f64::from(i), aileron]);
        // SAFETY: the component is alive.
        let stepped = unsafe { fmi2DoStep(fmu.component, 0.01 * f64::from(i), 0.01, 0) };
        assert_eq!([set, stepped], [Status::Ok; 2]);
        save();
    }
    let allocated = ALLOCATIONS.get() - before;
    // SAFETY: the component is alive, the handle is that of a state.
    assert_eq!(unsafe { fmi2FreeFMUstate(fmu.component, &raw mut state) }, Status::Ok);
    assert_eq!(allocated, 0);
}

#[test]
fn a_storm_with_actuators_and_sensors_allocates_nothing_in_a_step() {
    let fmu = Fmu::new();
    for (name, item) in [("gust.shape", 2), ("turbulence.spectrum", 3)] {
        assert_eq!(fmu.set_integer(name, item), Status::Ok);
    }
    assert_eq!(fmu.set_boolean("sensor.enabled", 1), Status::Ok);
    let reals = [
        ("gust.start", 0.1),
        ("actuator.elevator.frequency", 40.0),
        ("engine.left.time_constant", 0.3),
        ("sensor.noise.rate", 0.01),
    ];
    assert_eq!(fmu.set(&reals), Status::Ok);
    assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()], [Status::Ok; 3]);
    let outputs = ["load_factor.z", "sensor.rate.y", "wind.down", "actuator.elevator.rate"].map(reference);
    let elevator = reference("elevator");
    let (mut values, before) = ([0.0; 4], ALLOCATIONS.get());
    for i in 0..50 {
        let set = fmu.set_references(&[elevator], &[1e-3 * f64::from(i)]);
        // SAFETY: the component is alive, the arrays are as long as said.
        let (stepped, got) = unsafe {
            (
                fmi2DoStep(fmu.component, 0.013 * f64::from(i), 0.013, 1),
                fmi2GetReal(fmu.component, outputs.as_ptr(), 4, values.as_mut_ptr()),
            )
        };
        assert_eq!([set, stepped, got], [Status::Ok; 3]);
    }
    assert_eq!(ALLOCATIONS.get(), before);
    assert!(values.iter().all(|value| *value != 0.0), "{values:?}");
}

use super::endurance::typical_section;
use super::*;
use crate::fmi::instance::{Experiment, Instance};
use crate::fmi::life_cycle::State;
use crate::fmi::operation::Operation;

fn state(fmu: &Fmu) -> State {
    // SAFETY: a component is an `Instance`.
    unsafe { &*fmu.component.cast::<Instance>() }.state
}

#[test]
fn an_experiment_out_of_reason_is_refused() {
    let fmu = Fmu::new();
    for (tolerance, start, stop, part) in [
        (Some(0.0), 0.0, None, "tolerance"),
        (Some(f64::NAN), 0.0, None, "tolerance"),
        (Some(1.0), 0.0, None, "tolerance: found 1, allowed is a number between 0 and 1, exclusive"),
        (None, f64::INFINITY, None, "start time"),
        (None, -1.1e12, None, "start time: found -1100000000000, allowed is -1e12 to 1e12 s"),
        (None, 1.1e12, None, "grid of 10 ms"),
        (None, 1.0, Some(0.5), "stop time: found 0.5, allowed is the start time 1 s or later"),
        (None, 0.0, Some(f64::NAN), "stop time"),
        (None, 0.0, Some(f64::NEG_INFINITY), "stop time"),
    ] {
        assert_eq!(fmu.set_up(tolerance, start, stop), Status::Error, "{part}");
        fmu.assert_refused(&[part]);
    }
    assert_eq!(fmu.set_up(Some(1e-5), 1.0, Some(1.0)), Status::Ok);
}

#[test]
fn a_flight_may_begin_before_time_zero() {
    let fmu = Fmu::new();
    assert_eq!(fmu.set_up(None, -0.02, Some(0.01)), Status::Ok);
    assert_eq!((fmu.enter(), fmu.exit()), (Status::Ok, Status::Ok));
    for point in [-0.02, -0.01, 0.0] {
        assert_eq!(fmu.step(point, 0.01), Status::Ok, "{:?}", fmu.log);
    }
    assert_eq!(fmu.step(0.01, 0.01), Status::Error);
    fmu.assert_refused(&["stop time 0.01"]);
}

#[test]
fn any_stop_time_after_the_start_will_do() {
    for start in [0.0, 1.7e9] {
        for stop in [start, 1.7e9 + 3e7, 1e13, f64::MAX, f64::INFINITY] {
            let fmu = Fmu::new();
            assert_eq!(fmu.set_up(None, start, Some(stop)), Status::Ok, "{start} {stop}");
            assert_eq!((fmu.enter(), fmu.exit()), (Status::Ok, Status::Ok));
            assert_eq!(fmu.step(start, 0.01) == Status::Ok, stop > start, "{start} {stop}: {:?}", fmu.log);
        }
    }
}

/// Where it is flown from and by how much does not matter, but a day is the most at once.
#[test]
fn a_step_beyond_time_or_longer_than_a_day_is_refused_at_once() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.step(0.0, 1e300), Status::Error);
    fmu.assert_refused(&["passes 1e12 s", "grid of 10 ms"]);
    for size in [1e7, 1.7e9, 86_401.0] {
        assert_eq!(fmu.step(0.0, size), Status::Error);
        fmu.assert_refused(&["from t = 0 s", &format!("found {size} s"), "86400 s, a day, at once"]);
    }
    assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
}

#[test]
fn calls_in_the_wrong_state_are_refused_and_change_nothing() {
    let fmu = Fmu::new();
    assert_eq!(fmu.exit(), Status::Error);
    fmu.assert_refused(&["fmi2ExitInitializationMode", "instantiated", "initializationMode"]);
    assert_eq!(fmu.step(0.0, 0.1), Status::Error);
    assert_eq!(fmu.terminate(), Status::Error);
    assert_eq!(fmu.get_references(&[0]), Err(Status::Error));
    assert_eq!(state(&fmu), State::Instantiated);
    assert_eq!(fmu.enter(), Status::Ok);
    assert_eq!(fmu.enter(), Status::Error);
    assert_eq!(fmu.set_up(None, 0.0, None), Status::Error);
    assert_eq!(state(&fmu), State::InitializationMode);
    assert_eq!(fmu.reset(), Status::Ok);
    assert_eq!(state(&fmu), State::Instantiated);
}

#[test]
fn model_exchange_is_refused_with_the_reason() {
    let fmu = Fmu::initialising();
    // SAFETY: the component is alive; refused calls use no pointers.
    let statuses = unsafe {
        [
            fmi2EnterEventMode(fmu.component),
            fmi2NewDiscreteStates(fmu.component, null_mut()),
            fmi2EnterContinuousTimeMode(fmu.component),
            fmi2CompletedIntegratorStep(fmu.component, 0, null_mut(), null_mut()),
            fmi2SetTime(fmu.component, 0.0),
            fmi2SetContinuousStates(fmu.component, null(), 0),
            fmi2GetDerivatives(fmu.component, null_mut(), 0),
            fmi2GetEventIndicators(fmu.component, null_mut(), 0),
            fmi2GetContinuousStates(fmu.component, null_mut(), 0),
            fmi2GetNominalsOfContinuousStates(fmu.component, null_mut(), 0),
        ]
    };
    assert_eq!(statuses, [Status::Error; 10]);
    assert_eq!(fmu.log.borrow().len(), 10);
    fmu.assert_refused(&["co-simulation"]);
}

#[test]
fn a_panic_is_fatal_and_then_only_free_is_accepted() {
    let fmu = Fmu::new();
    // SAFETY: a component is an `Instance`, and no other reference to it is alive.
    let instance = unsafe { &mut *fmu.component.cast::<Instance>() };
    assert_eq!(instance.call(Operation::Reset, |_| panic!("100% broken")), Status::Fatal);
    let message = fmu.last_message();
    assert_eq!((message.status, message.category.as_str()), (Status::Fatal, "logStatusFatal"));
    assert!(message.format.contains("100%% broken"), "{}", message.format);
    assert_eq!((fmu.reset(), fmu.enter(), fmu.step(0.0, 1.0)), (Status::Error, Status::Error, Status::Error));
    assert_eq!(state(&fmu), State::Fatal);
}

#[test]
fn reset_forgets_experiment_and_values() {
    let fmu = Fmu::new();
    assert_eq!(fmu.set_up(Some(1e-5), 2.0, Some(3.0)), Status::Ok);
    assert_eq!(fmu.set(&[("elevator", 0.1), ("airspeed", 150.0)]), Status::Ok);
    assert_eq!(fmu.reset(), Status::Ok);
    // SAFETY: a component is an `Instance`.
    assert_eq!(unsafe { &*fmu.component.cast::<Instance>() }.experiment, Experiment::default());
    assert_eq!(fmu.enter(), Status::Ok);
    assert_eq!((fmu.get("elevator"), fmu.get("airspeed")), (0.0, 127.0));
}

/// A small one of a kind, in a state.
fn fmu_in(kind: Kind, state: State) -> Fmu {
    let fmu = Fmu::of(kind, &typical_section());
    let initialise = || {
        assert_eq!((fmu.set_up(None, 0.0, None), fmu.enter()), (Status::Ok, Status::Ok));
    };
    match state {
        State::Instantiated => fmu,
        State::InitializationMode => {
            initialise();
            fmu
        }
        State::StepComplete | State::EventMode => {
            initialise();
            assert_eq!(fmu.exit(), Status::Ok);
            fmu
        }
        State::ContinuousTimeMode => {
            let fmu = fmu_in(kind, State::EventMode);
            // SAFETY: the component is alive.
            assert_eq!(unsafe { fmi2EnterContinuousTimeMode(fmu.component) }, Status::Ok);
            fmu
        }
        State::Terminated => {
            initialise();
            assert_eq!((fmu.exit(), fmu.terminate()), (Status::Ok, Status::Ok));
            fmu
        }
        State::Fatal => {
            // SAFETY: a component is an `Instance`, and no other reference to it is alive.
            let instance = unsafe { &mut *fmu.component.cast::<Instance>() };
            assert_eq!(instance.call(Operation::Reset, |_| panic!("for the test")), Status::Fatal);
            fmu
        }
    }
}

/// Calls a function with arguments that ask for as little as possible.
pub(super) fn call(function: Operation, c: Component) -> Status {
    use Operation as O;
    let (v, r, i, s, b) = (null(), null_mut(), null_mut(), null_mut(), null_mut());
    // SAFETY: the component is alive, empty arrays may be NULL, and results at NULL are refused.
    unsafe {
        match function {
            O::SetDebugLogging => fmi2SetDebugLogging(c, 0, 0, null()),
            O::SetupExperiment => fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0),
            O::EnterInitializationMode => fmi2EnterInitializationMode(c),
            O::ExitInitializationMode => fmi2ExitInitializationMode(c),
            O::Terminate => fmi2Terminate(c),
            O::Reset => fmi2Reset(c),
            O::GetReal => fmi2GetReal(c, v, 0, r),
            O::GetInteger => fmi2GetInteger(c, v, 0, i),
            O::GetBoolean => fmi2GetBoolean(c, v, 0, b),
            O::GetString => fmi2GetString(c, v, 0, s),
            O::SetReal => fmi2SetReal(c, v, 0, null()),
            O::SetInteger => fmi2SetInteger(c, v, 0, null()),
            O::SetBoolean => fmi2SetBoolean(c, v, 0, null()),
            O::SetString => fmi2SetString(c, v, 0, null()),
            O::GetFMUstate => fmi2GetFMUstate(c, null_mut()),
            O::SetFMUstate => fmi2SetFMUstate(c, null_mut()),
            O::FreeFMUstate => fmi2FreeFMUstate(c, null_mut()),
            O::SerializedFMUstateSize => fmi2SerializedFMUstateSize(c, null_mut(), null_mut()),
            O::SerializeFMUstate => fmi2SerializeFMUstate(c, null_mut(), null_mut(), 0),
            O::DeSerializeFMUstate => fmi2DeSerializeFMUstate(c, null(), 0, null_mut()),
            O::GetDirectionalDerivative => fmi2GetDirectionalDerivative(c, v, 0, v, 0, null(), r),
            O::SetRealInputDerivatives => fmi2SetRealInputDerivatives(c, v, 0, null(), null()),
            O::GetRealOutputDerivatives => fmi2GetRealOutputDerivatives(c, v, 0, null(), r),
            O::DoStep => fmi2DoStep(c, 0.0, 0.0, 1),
            O::CancelStep => fmi2CancelStep(c),
            O::GetStatus => fmi2GetStatus(c, 0, null_mut()),
            O::GetRealStatus => fmi2GetRealStatus(c, 0, r),
            O::GetIntegerStatus => fmi2GetIntegerStatus(c, 0, i),
            O::GetBooleanStatus => fmi2GetBooleanStatus(c, 0, b),
            O::GetStringStatus => fmi2GetStringStatus(c, 0, s),
            O::EnterEventMode => fmi2EnterEventMode(c),
            O::NewDiscreteStates => fmi2NewDiscreteStates(c, null_mut()),
            O::EnterContinuousTimeMode => fmi2EnterContinuousTimeMode(c),
            O::CompletedIntegratorStep => fmi2CompletedIntegratorStep(c, 0, b, b),
            O::SetTime => fmi2SetTime(c, 0.0),
            O::SetContinuousStates => fmi2SetContinuousStates(c, null(), 0),
            O::GetDerivatives => fmi2GetDerivatives(c, r, 0),
            O::GetEventIndicators => fmi2GetEventIndicators(c, r, 0),
            O::GetContinuousStates => fmi2GetContinuousStates(c, r, 0),
            O::GetNominalsOfContinuousStates => fmi2GetNominalsOfContinuousStates(c, r, 0),
            other => panic!("{other:?} is no operation of FMI 2.0"),
        }
    }
}

#[test]
fn every_function_obeys_the_table_in_every_state() {
    for kind in [Kind::CoSimulation, Kind::ModelExchange] {
        for before in State::ALL.into_iter().filter(|state| state.is_of(kind)) {
            for function in operations() {
                obeys_the_table(kind, before, function);
            }
        }
    }
}

fn obeys_the_table(kind: Kind, before: State, function: Operation) {
    let fmu = fmu_in(kind, before);
    let status = call(function, fmu.component);
    match function.objection(Interface { version: Version::V2, kind }, before) {
        Some(objection) => {
            assert_eq!((status, state(&fmu)), (Status::Error, before), "{function:?} in {before:?}");
            fmu.assert_refused(&[&format!("{}: {}", name(function), objection.text(Version::V2))]);
        }
        None => {
            let log = fmu.log.borrow();
            let refused = log.iter().any(|message| message.format.contains("not allowed in state"));
            assert!(!refused, "{function:?} in {before:?}: {log:?}");
        }
    }
}

//! What may be asked for when, and what a wrong call does.

use super::*;
use crate::fmi::instance;
use crate::fmi::life_cycle::State;
use crate::fmi::operation::Operation;
use crate::fmi2::tests::endurance::typical_section;

fn state(fmu: &Fmu) -> State {
    // SAFETY: an instance of C is an `Instance`.
    unsafe { &*fmu.instance.cast::<instance::Instance>() }.state
}

/// The operations that FMI 3.0 has.
fn operations() -> impl Iterator<Item = Operation> {
    Operation::ALL.iter().copied().filter(|operation| operation.name(Version::V3).is_some())
}

/// A small one of a kind, in a state.
fn fmu_in(kind: Kind, state: State) -> Fmu {
    let fmu = Fmu::of(kind, &typical_section());
    // SAFETY: the instance is alive, here and below.
    let statuses = unsafe {
        let enter = |fmu: &Fmu| fmi3EnterInitializationMode(fmu.instance, 0, 0.0, 0.0, 0, 0.0);
        match state {
            State::Instantiated => vec![],
            State::InitializationMode => vec![enter(&fmu)],
            State::StepComplete | State::EventMode => vec![fmu.initialise(0.0)],
            State::ContinuousTimeMode => {
                vec![fmu.initialise(0.0), fmi3EnterContinuousTimeMode(fmu.instance)]
            }
            State::Terminated => vec![fmu.initialise(0.0), fmi3Terminate(fmu.instance)],
            State::Fatal => {
                let instance = &mut *fmu.instance.cast::<instance::Instance>();
                assert_eq!(instance.call(Operation::Reset, |_| panic!("for the test")), Status::Fatal);
                vec![]
            }
        }
    };
    assert!(statuses.iter().all(|status| *status == Status::Ok), "{:?}", fmu.log);
    fmu
}

/// Calls a function with arguments that ask for as little as possible.
pub(super) fn call(function: Operation, i: Instance) -> Status {
    use Operation as O;
    let (v, n) = (null(), null_mut());
    // SAFETY: the instance is alive, empty arrays may be NULL, and results at NULL are refused.
    unsafe {
        match function {
            O::SetDebugLogging => fmi3SetDebugLogging(i, 0, 0, null()),
            O::EnterInitializationMode => fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0),
            O::ExitInitializationMode => fmi3ExitInitializationMode(i),
            O::Terminate => fmi3Terminate(i),
            O::Reset => fmi3Reset(i),
            O::GetReal => fmi3GetFloat64(i, v, 0, null_mut(), 0),
            O::GetInteger => fmi3GetInt32(i, v, 0, null_mut(), 0),
            O::GetInt64 => fmi3GetInt64(i, v, 0, null_mut(), 0),
            O::GetBoolean => fmi3GetBoolean(i, v, 0, null_mut(), 0),
            O::GetString => fmi3GetString(i, v, 0, null_mut(), 0),
            O::GetFloat32 => fmi3GetFloat32(i, v, 0, null_mut(), 0),
            O::GetInt8 => fmi3GetInt8(i, v, 0, null_mut(), 0),
            O::GetUInt8 => fmi3GetUInt8(i, v, 0, null_mut(), 0),
            O::GetInt16 => fmi3GetInt16(i, v, 0, null_mut(), 0),
            O::GetUInt16 => fmi3GetUInt16(i, v, 0, null_mut(), 0),
            O::GetUInt32 => fmi3GetUInt32(i, v, 0, null_mut(), 0),
            O::GetUInt64 => fmi3GetUInt64(i, v, 0, null_mut(), 0),
            O::GetBinary => fmi3GetBinary(i, v, 0, null_mut(), null_mut(), 0),
            O::SetReal => fmi3SetFloat64(i, v, 0, null(), 0),
            O::SetInteger => fmi3SetInt32(i, v, 0, null(), 0),
            O::SetInt64 => fmi3SetInt64(i, v, 0, null(), 0),
            O::SetBoolean => fmi3SetBoolean(i, v, 0, null(), 0),
            O::SetString => fmi3SetString(i, v, 0, null(), 0),
            O::SetFloat32 => fmi3SetFloat32(i, v, 0, null(), 0),
            O::SetInt8 => fmi3SetInt8(i, v, 0, null(), 0),
            O::SetUInt8 => fmi3SetUInt8(i, v, 0, null(), 0),
            O::SetInt16 => fmi3SetInt16(i, v, 0, null(), 0),
            O::SetUInt16 => fmi3SetUInt16(i, v, 0, null(), 0),
            O::SetUInt32 => fmi3SetUInt32(i, v, 0, null(), 0),
            O::SetUInt64 => fmi3SetUInt64(i, v, 0, null(), 0),
            O::SetBinary => fmi3SetBinary(i, v, 0, null(), null(), 0),
            O::GetFMUstate => fmi3GetFMUState(i, null_mut()),
            O::SetFMUstate => fmi3SetFMUState(i, null_mut()),
            O::FreeFMUstate => fmi3FreeFMUState(i, null_mut()),
            O::SerializedFMUstateSize => fmi3SerializedFMUStateSize(i, null_mut(), null_mut()),
            O::SerializeFMUstate => fmi3SerializeFMUState(i, null_mut(), null_mut(), 0),
            O::DeSerializeFMUstate => fmi3DeserializeFMUState(i, null(), 0, null_mut()),
            O::GetDirectionalDerivative => {
                fmi3GetDirectionalDerivative(i, v, 0, v, 0, null(), 0, null_mut(), 0)
            }
            O::GetAdjointDerivative => fmi3GetAdjointDerivative(i, v, 0, v, 0, null(), 0, null_mut(), 0),
            O::GetNumberOfVariableDependencies => fmi3GetNumberOfVariableDependencies(i, 0, null_mut()),
            O::GetVariableDependencies => {
                fmi3GetVariableDependencies(i, 0, null_mut(), null_mut(), null_mut(), null_mut(), 0)
            }
            O::GetRealOutputDerivatives => fmi3GetOutputDerivatives(i, v, 0, null(), null_mut(), 0),
            O::DoStep => fmi3DoStep(i, 0.0, 0.1, 1, n, n, n, null_mut()),
            O::EnterStepMode => fmi3EnterStepMode(i),
            O::EnterEventMode => fmi3EnterEventMode(i),
            O::NewDiscreteStates => fmi3UpdateDiscreteStates(i, n, n, n, n, n, null_mut()),
            O::EvaluateDiscreteStates => fmi3EvaluateDiscreteStates(i),
            O::EnterContinuousTimeMode => fmi3EnterContinuousTimeMode(i),
            O::CompletedIntegratorStep => fmi3CompletedIntegratorStep(i, 0, n, n),
            O::SetTime => fmi3SetTime(i, 0.0),
            O::SetContinuousStates => fmi3SetContinuousStates(i, null(), 0),
            O::GetDerivatives => fmi3GetContinuousStateDerivatives(i, null_mut(), 0),
            O::GetEventIndicators => fmi3GetEventIndicators(i, null_mut(), 0),
            O::GetContinuousStates => fmi3GetContinuousStates(i, null_mut(), 0),
            O::GetNominalsOfContinuousStates => fmi3GetNominalsOfContinuousStates(i, null_mut(), 0),
            O::GetNumberOfContinuousStates => fmi3GetNumberOfContinuousStates(i, null_mut()),
            O::GetNumberOfEventIndicators => fmi3GetNumberOfEventIndicators(i, null_mut()),
            O::EnterConfigurationMode => fmi3EnterConfigurationMode(i),
            O::ExitConfigurationMode => fmi3ExitConfigurationMode(i),
            O::GetClock => fmi3GetClock(i, v, 0, null_mut()),
            O::SetClock => fmi3SetClock(i, v, 0, null()),
            O::GetIntervalDecimal => fmi3GetIntervalDecimal(i, v, 0, null_mut(), null_mut()),
            O::GetIntervalFraction => fmi3GetIntervalFraction(i, v, 0, null_mut(), null_mut(), null_mut()),
            O::GetShiftDecimal => fmi3GetShiftDecimal(i, v, 0, null_mut()),
            O::GetShiftFraction => fmi3GetShiftFraction(i, v, 0, null_mut(), null_mut()),
            O::SetIntervalDecimal => fmi3SetIntervalDecimal(i, v, 0, null()),
            O::SetIntervalFraction => fmi3SetIntervalFraction(i, v, 0, null(), null()),
            O::SetShiftDecimal => fmi3SetShiftDecimal(i, v, 0, null()),
            O::SetShiftFraction => fmi3SetShiftFraction(i, v, 0, null(), null()),
            O::ActivateModelPartition => fmi3ActivateModelPartition(i, 0, 0.0),
            other => panic!("{other:?} is no operation of FMI 3.0"),
        }
    }
}

#[test]
fn every_function_obeys_the_table_in_every_state_and_a_wrong_call_ends_the_instance() {
    for kind in [Kind::CoSimulation, Kind::ModelExchange] {
        let interface = Interface { version: Version::V3, kind };
        for before in State::ALL.into_iter().filter(|state| state.is_of(kind)) {
            for function in operations() {
                let fmu = fmu_in(kind, before);
                let status = call(function, fmu.instance);
                let what = format!("{function:?} of {interface} in {before:?}: {:?}", fmu.log);
                match function.objection(interface, before) {
                    Some(objection) => {
                        assert_eq!(status, Status::Error, "{what}");
                        let name = function.name(Version::V3).unwrap();
                        fmu.assert_refused(&[&format!("{name}: {}", objection.text(Version::V3))]);
                    }
                    None => assert!(!what.contains("not allowed in state"), "{what}"),
                }
                let ends = status == Status::Error && before != State::Fatal;
                assert!(!ends || state(&fmu) == State::Terminated, "{what}: {:?}", state(&fmu));
            }
        }
    }
}

/// What is allowed in words of the design, some of it against the table that the code has.
#[test]
fn what_has_no_meaning_here_is_refused_with_its_reason() {
    for (function, kind, reason) in [
        (Operation::EnterConfigurationMode, Kind::CoSimulation, "no structural parameters"),
        (Operation::EnterEventMode, Kind::CoSimulation, "no event mode"),
        (Operation::EnterStepMode, Kind::CoSimulation, "no event mode"),
        (Operation::NewDiscreteStates, Kind::CoSimulation, "no event mode"),
        (Operation::GetClock, Kind::CoSimulation, "no clocks"),
        (Operation::SetIntervalFraction, Kind::ModelExchange, "no clocks"),
        (Operation::ActivateModelPartition, Kind::CoSimulation, "no clocks"),
        (Operation::GetRealOutputDerivatives, Kind::CoSimulation, "order 0"),
        (Operation::GetAdjointDerivative, Kind::ModelExchange, "no adjoint derivatives"),
        (Operation::GetVariableDependencies, Kind::CoSimulation, "its model description says"),
        (Operation::SetContinuousStates, Kind::CoSimulation, "belongs to model exchange"),
        (Operation::DoStep, Kind::ModelExchange, "belongs to co-simulation"),
        (Operation::EnterStepMode, Kind::ModelExchange, "belongs to co-simulation"),
    ] {
        let fmu = Fmu::new(kind);
        assert_eq!(fmu.initialise(0.0), Status::Ok);
        assert_eq!(call(function, fmu.instance), Status::Error);
        fmu.assert_refused(&[reason]);
    }
}

#[test]
fn a_reset_or_a_saved_state_leads_back_from_an_error() {
    let fmu = Fmu::new(Kind::CoSimulation);
    assert_eq!(fmu.initialise(0.0), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
    let pitch = fmu.get("attitude.pitch");
    let mut saved = null_mut();
    // SAFETY: the instance is alive, the place is there.
    assert_eq!(unsafe { fmi3GetFMUState(fmu.instance, &mut saved) }, Status::Ok);
    assert_eq!(fmu.step(7.0, 0.01), Status::Error);
    fmu.assert_refused(&["communication point: found 7, expected 0.01"]);
    assert_eq!(state(&fmu), State::Terminated);
    assert_eq!(fmu.get("attitude.pitch"), pitch);
    assert_eq!(fmu.step(0.01, 0.01), Status::Error);
    // SAFETY: the state is of the instance.
    unsafe {
        assert_eq!(fmi3SetFMUState(fmu.instance, saved), Status::Ok, "{:?}", fmu.log);
        assert_eq!(fmi3FreeFMUState(fmu.instance, &mut saved), Status::Ok);
    }
    assert_eq!(fmu.step(0.01, 0.01), Status::Ok);
    assert_eq!(fmu.step(0.02, 0.0), Status::Error);
    fmu.assert_refused(&["step size: found 0, allowed is a finite number greater than 0"]);
    // SAFETY: the instance is alive.
    assert_eq!(unsafe { fmi3Reset(fmu.instance) }, Status::Ok);
    assert_eq!((fmu.initialise(0.0), fmu.step(0.0, 0.01)), (Status::Ok, Status::Ok));
    // An error before the initialisation: saved, and gone back to.
    let fmu = Fmu::new(Kind::ModelExchange);
    assert_eq!(fmu.set(&[("airspeed", -1.0)]), Status::Error);
    assert_eq!(state(&fmu), State::Terminated);
    let mut saved = null_mut();
    // SAFETY: as above.
    unsafe {
        assert_eq!(fmi3GetFMUState(fmu.instance, &mut saved), Status::Ok);
        assert_eq!(fmi3Reset(fmu.instance), Status::Ok);
        assert_eq!(fmi3SetFMUState(fmu.instance, saved), Status::Ok, "{:?}", fmu.log);
        assert_eq!(state(&fmu), State::Terminated);
        assert_eq!(fmi3FreeFMUState(fmu.instance, &mut saved), Status::Ok);
    }
}

#[test]
fn a_flight_beyond_the_model_is_discarded_and_the_instance_as_before() {
    let fmu = Fmu::new(Kind::CoSimulation);
    assert_eq!(fmu.initialise(0.0), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
    assert_eq!(fmu.set(&[("wind_north", 1000.0)]), Status::Ok);
    assert_eq!(fmu.step(0.01, 0.1), Status::Discard);
    let message = fmu.last_message();
    assert_eq!((message.status, message.category.as_str()), (Status::Discard, "logStatusWarning"));
    assert!(message.text.contains("from behind"), "{message:?}");
    assert_eq!(state(&fmu), State::StepComplete);
    assert_eq!(fmu.get("time"), 0.01);
    assert_eq!(fmu.set(&[("wind_north", 0.0)]), Status::Ok);
    assert_eq!(fmu.step(0.01, 0.01), Status::Ok);
}

#[test]
fn what_is_read_before_the_initialisation_is_the_trim_of_the_present_parameters() {
    for kind in [Kind::CoSimulation, Kind::ModelExchange] {
        let fmu = Fmu::new(kind);
        assert_eq!(fmu.get("airspeed"), 127.0);
        let slow = fmu.get("trim.pitch");
        assert_eq!(fmu.set(&[("airspeed", 150.0)]), Status::Ok);
        let fast = fmu.get("trim.pitch");
        assert!(fast < slow - 0.01, "{slow} {fast}");
        assert_eq!(fmu.initialise(2.0), Status::Ok);
        assert_eq!((fmu.get("trim.pitch"), fmu.get("time")), (fast, 2.0));
    }
}

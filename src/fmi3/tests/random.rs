//! Random calls with random arguments over FMI 3.0, by the driver of all versions.

use super::*;
use crate::fmi::operation::Operation;
use crate::fmi2::tests::random::{Call, Means, Random, assert_finite, call_the_same, play};

impl Random for Fmu {
    fn call(call: &Call, function: Operation, i: Instance, means: &mut Means) -> Status {
        use Operation as O;
        match function {
            O::GetReal => {
                let (status, values) = get(call, i, fmi3GetFloat64, f64::NAN);
                assert_finite(status, &values, call);
                status
            }
            O::GetInteger => get(call, i, fmi3GetInt32, 0).0,
            O::GetInt64 => get(call, i, fmi3GetInt64, 0).0,
            O::GetBoolean => {
                let (status, values) = get(call, i, fmi3GetBoolean, 9);
                assert!(status != Status::Ok || values.iter().all(|flag| *flag < 2), "{values:?}: {call:?}");
                status
            }
            O::SetReal => set(call, i, fmi3SetFloat64, &call.reals),
            O::SetInteger => set(call, i, fmi3SetInt32, &call.integers),
            O::SetInt64 => set(call, i, fmi3SetInt64, &call.integers_as(i64::from)),
            O::SetBoolean => set(call, i, fmi3SetBoolean, &call.integers_as(|number| number as u8)),
            O::SetDebugLogging => {
                let names = call.categories();
                let (start, count) = call.array(&names);
                // SAFETY: the array is as long as said or is refused, its strings are constants or NULL.
                unsafe { fmi3SetDebugLogging(i, u8::from(call.flag(0)), count, start) }
            }
            O::EnterInitializationMode => {
                let x = &call.reals;
                let flags = [call.flag(0), call.flag(1)].map(u8::from);
                // SAFETY: the instance is alive or NULL.
                unsafe { fmi3EnterInitializationMode(i, flags[0], x[0], x[1], flags[1], x[2]) }
            }
            O::DoStep => {
                let ([point, size], mut flags, mut reached) = (call.step(i), [9_u8; 3], f64::NAN);
                let [events, ends, returns] = flags.each_mut().map(|flag| call.place(flag));
                // SAFETY: the instance is alive or NULL, the places are there or NULL.
                unsafe { fmi3DoStep(i, point, size, 1, events, ends, returns, call.place(&mut reached)) }
            }
            O::GetDirectionalDerivative => differentiate(call, i),
            O::NewDiscreteStates => {
                let (mut flags, mut time) = ([9_u8; 5], f64::NAN);
                let [needed, ends, nominals, values, defined] = flags.each_mut().map(|flag| call.place(flag));
                let time = call.place(&mut time);
                // SAFETY: the instance is alive or NULL, the places are there or NULL.
                unsafe { fmi3UpdateDiscreteStates(i, needed, ends, nominals, values, defined, time) }
            }
            O::CompletedIntegratorStep => {
                let mut flags = [9_u8; 2];
                let [events, ends] = flags.each_mut().map(|flag| call.place(flag));
                // SAFETY: the instance is alive or NULL, the places are there or NULL.
                unsafe { fmi3CompletedIntegratorStep(i, u8::from(call.flag(5)), events, ends) }
            }
            O::GetNumberOfContinuousStates | O::GetNumberOfEventIndicators => {
                let mut count = usize::MAX;
                let place = call.place(&mut count);
                // SAFETY: the instance is alive or NULL, the place is there or NULL.
                unsafe {
                    match function {
                        O::GetNumberOfContinuousStates => fmi3GetNumberOfContinuousStates(i, place),
                        _ => fmi3GetNumberOfEventIndicators(i, place),
                    }
                }
            }
            _ => call_the_same::<Fmu>(call, function, i, means)
                .or_else(|| ask_for_none(call, function, i))
                .unwrap_or_else(|| life_cycle::call(function, i)),
        }
    }

    fn free_null() {
        // SAFETY: NULL is ignored.
        unsafe { fmi3FreeInstance(null_mut()) };
    }
}

type Get<T> = unsafe extern "C" fn(Instance, *const u32, usize, *mut T, usize) -> Status;
type Set<T> = unsafe extern "C" fn(Instance, *const u32, usize, *const T, usize) -> Status;

fn get<T: Copy>(call: &Call, i: Instance, function: Get<T>, filled: T) -> (Status, Vec<T>) {
    let (references, count) = call.array(&call.references);
    let mut values = vec![filled; call.references.len() + 1];
    let (places, _) = call.array_to_fill(&mut values);
    values.truncate(call.references.len());
    // SAFETY: arrays are as long as said or are refused for their length, alignment or being NULL.
    (unsafe { function(i, references, count, places, call.second_count(count)) }, values)
}

fn set<T>(call: &Call, i: Instance, function: Set<T>, values: &[T]) -> Status {
    let (references, count) = call.array(&call.references);
    // SAFETY: arrays are at least as long as said or are refused for their length, alignment or being NULL.
    unsafe { function(i, references, count, call.array(values).0, call.second_count(count)) }
}

fn differentiate(call: &Call, i: Instance) -> Status {
    let (unknowns, count) = call.array(&call.references);
    let (knowns, seed) = (call.array(&call.knowns).0, call.array(&call.reals).0);
    let mut results = vec![f64::NAN; call.references.len() + 1];
    let (places, _) = call.array_to_fill(&mut results);
    let (seeds, sensitivities) = match call.flag(0) {
        true => (call.second_count(count), count),
        false => (count, call.second_count(count)),
    };
    // SAFETY: arrays are at least as long as said or are refused for their length, alignment or being NULL.
    let status = unsafe {
        fmi3GetDirectionalDerivative(i, unknowns, count, knowns, count, seed, seeds, places, sensitivities)
    };
    call.assert_finite_slopes(status, &results[..call.references.len()]);
    status
}

/// Asks half of the time for variables of a type that none has.
fn ask_for_none(call: &Call, function: Operation, i: Instance) -> Option<Status> {
    use Operation as O;
    if call.flag(3) {
        return None;
    }
    let ((v, n), null_value) = (call.array(&call.references), null_mut());
    // SAFETY: the array is as long as said or is refused; there are no values, for none is read or written.
    Some(unsafe {
        match function {
            O::GetFloat32 => fmi3GetFloat32(i, v, n, null_mut(), n),
            O::GetInt8 => fmi3GetInt8(i, v, n, null_mut(), n),
            O::GetUInt8 => fmi3GetUInt8(i, v, n, null_mut(), n),
            O::GetInt16 => fmi3GetInt16(i, v, n, null_mut(), n),
            O::GetUInt16 => fmi3GetUInt16(i, v, n, null_mut(), n),
            O::GetUInt32 => fmi3GetUInt32(i, v, n, null_mut(), n),
            O::GetUInt64 => fmi3GetUInt64(i, v, n, null_mut(), n),
            O::GetString => fmi3GetString(i, v, n, null_mut(), n),
            O::GetBinary => fmi3GetBinary(i, v, n, null_value, null_mut(), n),
            O::SetFloat32 => fmi3SetFloat32(i, v, n, null(), n),
            O::SetInt8 => fmi3SetInt8(i, v, n, null(), n),
            O::SetUInt8 => fmi3SetUInt8(i, v, n, null(), n),
            O::SetInt16 => fmi3SetInt16(i, v, n, null(), n),
            O::SetUInt16 => fmi3SetUInt16(i, v, n, null(), n),
            O::SetUInt32 => fmi3SetUInt32(i, v, n, null(), n),
            O::SetUInt64 => fmi3SetUInt64(i, v, n, null(), n),
            O::SetString => fmi3SetString(i, v, n, null(), n),
            O::SetBinary => fmi3SetBinary(i, v, n, null(), null(), n),
            _ => return None,
        }
    })
}

/// What both kinds refuse.
const NEVER_DONE: [&str; 18] = [
    "fmi3ActivateModelPartition",
    "fmi3EnterConfigurationMode",
    "fmi3EnterStepMode",
    "fmi3ExitConfigurationMode",
    "fmi3GetAdjointDerivative",
    "fmi3GetClock",
    "fmi3GetIntervalDecimal",
    "fmi3GetIntervalFraction",
    "fmi3GetNumberOfVariableDependencies",
    "fmi3GetOutputDerivatives",
    "fmi3GetShiftDecimal",
    "fmi3GetShiftFraction",
    "fmi3GetVariableDependencies",
    "fmi3SetClock",
    "fmi3SetIntervalDecimal",
    "fmi3SetIntervalFraction",
    "fmi3SetShiftDecimal",
    "fmi3SetShiftFraction",
];

#[test]
fn random_calls_over_fmi_3_co_simulation_crash_nothing_hang_nothing_and_leave_nothing_behind() {
    let of_exchange = [
        "fmi3CompletedIntegratorStep",
        "fmi3EnterContinuousTimeMode",
        "fmi3EnterEventMode",
        "fmi3EvaluateDiscreteStates",
        "fmi3GetContinuousStateDerivatives",
        "fmi3GetContinuousStates",
        "fmi3GetEventIndicators",
        "fmi3GetNominalsOfContinuousStates",
        "fmi3GetNumberOfContinuousStates",
        "fmi3GetNumberOfEventIndicators",
        "fmi3SetContinuousStates",
        "fmi3SetTime",
        "fmi3UpdateDiscreteStates",
    ];
    play::<Fmu>(Kind::CoSimulation, &[&NEVER_DONE[..], &of_exchange].concat());
}

#[test]
fn random_calls_over_fmi_3_model_exchange_crash_nothing_hang_nothing_and_leave_nothing_behind() {
    play::<Fmu>(Kind::ModelExchange, &[&NEVER_DONE[..], &["fmi3DoStep"]].concat());
}

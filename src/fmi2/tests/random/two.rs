//! The functions of FMI 2.0 with random arguments.

use super::call::Call;
use super::{Means, Random, assert_finite, call_the_same};
use crate::fmi::operation::Operation;
use crate::fmi2::tests::*;
use crate::fmi2::types::EventInfo;

impl Random for Fmu {
    fn call(call: &Call, function: Operation, c: Component, means: &mut Means) -> Status {
        use Operation as O;
        match function {
            // No variable is one: none is asked for.
            O::GetString | O::SetString if call.flag(3) => life_cycle::call(function, c),
            O::GetReal | O::GetInteger | O::GetBoolean | O::GetString => get(call, function, c),
            O::SetReal | O::SetInteger | O::SetBoolean | O::SetString => set(call, function, c),
            O::SetDebugLogging => {
                let names = call.categories();
                let (start, count) = call.array(&names);
                // SAFETY: the array is as long as said or is refused, its strings are constants or NULL.
                unsafe { fmi2SetDebugLogging(c, c_int::from(call.flag(0)), count, start) }
            }
            O::DoStep => {
                let [point, size] = call.step(c);
                // SAFETY: the component is alive or NULL.
                unsafe { fmi2DoStep(c, point, size, c_int::from(call.flag(5))) }
            }
            O::GetDirectionalDerivative | O::SetRealInputDerivatives | O::GetRealOutputDerivatives => {
                differentiate(call, function, c)
            }
            O::SetupExperiment => {
                let x = &call.reals;
                let flags = [call.flag(0), call.flag(1)].map(c_int::from);
                // SAFETY: the component is alive or NULL.
                unsafe { fmi2SetupExperiment(c, flags[0], x[0], x[1], flags[1], x[2]) }
            }
            O::GetStatus
            | O::GetRealStatus
            | O::GetIntegerStatus
            | O::GetBooleanStatus
            | O::GetStringStatus => ask(call, function, c),
            O::NewDiscreteStates => {
                let mut info = EventInfo::default();
                // SAFETY: the component is alive or NULL, the place is there or NULL.
                unsafe { fmi2NewDiscreteStates(c, call.place(&mut info)) }
            }
            O::CompletedIntegratorStep => {
                let [mut events, mut ends] = [9; 2];
                let [events, ends] = [&mut events, &mut ends].map(|place| call.place(place));
                // SAFETY: the component is alive or NULL, the places are there or NULL.
                unsafe { fmi2CompletedIntegratorStep(c, c_int::from(call.flag(5)), events, ends) }
            }
            _ => call_the_same::<Fmu>(call, function, c, means)
                .unwrap_or_else(|| life_cycle::call(function, c)),
        }
    }

    fn free_null() {
        // SAFETY: NULL is ignored.
        unsafe { fmi2FreeInstance(null_mut()) };
    }
}

fn get(call: &Call, function: Operation, c: Component) -> Status {
    let (references, count) = call.array(&call.references);
    let room = call.references.len() + 1;
    let (mut reals, mut integers, mut strings) = (vec![f64::NAN; room], vec![0; room], vec![null(); room]);
    let (integer_places, _) = call.array_to_fill(&mut integers);
    // SAFETY: arrays are as long as said or are refused for their length, alignment or being NULL.
    let status = unsafe {
        match function {
            Operation::GetReal => fmi2GetReal(c, references, count, call.array_to_fill(&mut reals).0),
            Operation::GetInteger => fmi2GetInteger(c, references, count, integer_places),
            Operation::GetBoolean => fmi2GetBoolean(c, references, count, integer_places),
            _ => fmi2GetString(c, references, count, call.array_to_fill(&mut strings).0),
        }
    };
    if function == Operation::GetReal {
        assert_finite(status, &reals[..call.references.len()], call);
    }
    status
}

fn set(call: &Call, function: Operation, c: Component) -> Status {
    let (references, count) = call.array(&call.references);
    let (reals, integers) = (call.array(&call.reals).0, call.array(&call.integers).0);
    // SAFETY: arrays are at least as long as said or are refused for their length, alignment or being NULL.
    unsafe {
        match function {
            Operation::SetReal => fmi2SetReal(c, references, count, reals),
            Operation::SetInteger => fmi2SetInteger(c, references, count, integers),
            Operation::SetBoolean => fmi2SetBoolean(c, references, count, integers),
            _ => fmi2SetString(c, references, count, null()),
        }
    }
}

fn differentiate(call: &Call, function: Operation, c: Component) -> Status {
    let (references, count) = call.array(&call.references);
    let (knowns, reals, orders) = (
        call.array(&call.knowns).0,
        call.array(&call.reals).0,
        vec![[1, 1, 2, 0][usize::from(call.choice % 4)]; call.references.len() + 1],
    );
    let mut results = vec![f64::NAN; call.references.len() + 1];
    let places = call.array_to_fill(&mut results).0;
    // SAFETY: arrays are at least as long as said or are refused for their length, alignment or being NULL.
    unsafe {
        match function {
            Operation::GetDirectionalDerivative => {
                let status = fmi2GetDirectionalDerivative(c, references, count, knowns, count, reals, places);
                call.assert_finite_slopes(status, &results[..call.references.len()]);
                status
            }
            Operation::SetRealInputDerivatives => {
                fmi2SetRealInputDerivatives(c, references, count, call.array(&orders).0, reals)
            }
            _ => fmi2GetRealOutputDerivatives(c, references, count, call.array(&orders).0, places),
        }
    }
}

fn ask(call: &Call, function: Operation, c: Component) -> Status {
    let kind = call.integers.first().copied().unwrap_or(2);
    let (mut real, mut integer, mut status, mut text) = (0.0, 0, Status::Ok, null());
    // SAFETY: the component is alive or NULL, the places are there or NULL.
    unsafe {
        match function {
            Operation::GetStatus => fmi2GetStatus(c, kind, call.place(&mut status)),
            Operation::GetRealStatus => fmi2GetRealStatus(c, kind, call.place(&mut real)),
            Operation::GetIntegerStatus => fmi2GetIntegerStatus(c, kind, call.place(&mut integer)),
            Operation::GetBooleanStatus => fmi2GetBooleanStatus(c, kind, call.place(&mut integer)),
            _ => fmi2GetStringStatus(c, kind, call.place(&mut text)),
        }
    }
}

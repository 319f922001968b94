//! What random calls of a sequence hand on to each other, and the functions that all versions have.

use super::Random;
use super::call::{Call, Pointers, STATES};
use crate::fmi::operation::Operation;
use crate::fmi::saved_state::SavedState;
use crate::fmi2::tests::surface::{fit_checksum, instance};
use crate::fmi2::tests::*;

/// Saved states, and what arguments are made of.
pub(crate) struct Means {
    pub states: [FmuState; STATES],
    /// The last serialised state.
    pub bytes: Vec<u8>,
    /// States of the trim of the component that is called, where the importer integrates.
    pub trim: Vec<f64>,
}

impl Default for Means {
    fn default() -> Self {
        Means { states: [null_mut(); STATES], bytes: Vec::new(), trim: Vec::new() }
    }
}

impl Means {
    /// The last serialised bytes, some of them replaced, cut off or not, with a checksum that fits or not.
    fn damaged(&self, call: &Call) -> Vec<u8> {
        let mut bytes = self.bytes.clone();
        if bytes.is_empty() || call.flag(7) {
            return bytes;
        }
        for (place, byte) in &call.damage {
            let length = bytes.len();
            bytes[place.index(length)] = *byte;
        }
        if call.flag(6) && call.flag(5) {
            bytes.truncate(bytes.len() / 2);
        }
        if call.flag(4) {
            fit_checksum(&mut bytes);
        }
        bytes
    }
}

/// Calls a function that differs between the versions in its name alone, if it is one.
pub(crate) fn call_the_same<S: Random>(
    call: &Call,
    function: Operation,
    c: Component,
    means: &mut Means,
) -> Option<Status> {
    use Operation as O;
    match function {
        O::SetTime => {
            // SAFETY: the component is alive or NULL.
            Some(unsafe { (S::EXCHANGE.set_time)(c, call.time(c)) })
        }
        O::SetContinuousStates => {
            let states = call.states(&means.trim);
            let (pointer, count) = call.array(&states);
            // SAFETY: the component is alive or NULL, the array is as long as said or is refused.
            Some(unsafe { (S::EXCHANGE.set_states)(c, pointer, count) })
        }
        O::GetContinuousStates => Some(numbers(call, c, S::EXCHANGE.states).0),
        O::GetEventIndicators if call.flag(0) => {
            // SAFETY: the component is alive or NULL, an empty array may be NULL.
            Some(unsafe { (S::EXCHANGE.indicators)(c, null_mut(), 0) })
        }
        O::GetEventIndicators => Some(numbers(call, c, S::EXCHANGE.indicators).0),
        O::GetDerivatives | O::GetNominalsOfContinuousStates => {
            let get = match function {
                O::GetDerivatives => S::EXCHANGE.rates,
                _ => S::EXCHANGE.nominals,
            };
            let (status, numbers) = numbers(call, c, get);
            assert_finite(status, &numbers, call);
            Some(status)
        }
        O::GetFMUstate
        | O::SetFMUstate
        | O::FreeFMUstate
        | O::SerializedFMUstateSize
        | O::SerializeFMUstate
        | O::DeSerializeFMUstate => Some(call_on_state::<S>(call, function, c, means)),
        _ => None,
    }
}

/// As many numbers as there are states, or one more.
fn numbers(
    call: &Call,
    c: Component,
    get: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
) -> (Status, Vec<f64>) {
    let count = if c.is_null() { 3 } else { instance(c).state_count() } + usize::from(call.is_miscounted);
    let mut numbers = vec![f64::NAN; count + 1];
    let (pointer, _) = call.array_to_fill(&mut numbers);
    let count = if call.pointers == Pointers::Absurd { usize::MAX } else { count };
    numbers.truncate(count);
    // SAFETY: the component is alive or NULL, the array is as long as said or is refused.
    (unsafe { get(c, pointer, count) }, numbers)
}

fn call_on_state<S: Random>(call: &Call, function: Operation, c: Component, means: &mut Means) -> Status {
    use Operation as O;
    let (functions, state) = (S::STATES, means.states[call.state]);
    let place = call.place(&mut means.states[call.state]);
    let mut size = 0;
    // SAFETY: components and states are alive or NULL; arrays are as long as said or are refused for their
    // length, alignment or being NULL. States may serve another component than they came from.
    unsafe {
        match function {
            O::GetFMUstate => (functions.get)(c, place),
            O::SetFMUstate => (functions.set)(c, state),
            O::FreeFMUstate => (functions.free)(c, place),
            O::SerializedFMUstateSize => (functions.size)(c, state, call.place(&mut size)),
            O::SerializeFMUstate => {
                // Its length stands in itself.
                let size = if state.is_null() { 0 } else { (*state.cast::<SavedState>()).bytes().len() };
                let mut bytes = vec![0_u8; if call.flag(0) { size } else { size / 2 }];
                let (pointer, count) = call.array_to_fill(&mut bytes);
                let status = (functions.serialise)(c, state, pointer, count);
                if status == Status::Ok && call.pointers == Pointers::Whole {
                    means.bytes = bytes;
                }
                status
            }
            _ => {
                let bytes = means.damaged(call);
                let (pointer, count) = call.array(&bytes);
                (functions.deserialise)(c, pointer, count, place)
            }
        }
    }
}

/// What is read is a number.
pub(crate) fn assert_finite(status: Status, numbers: &[f64], call: &Call) {
    assert!(status != Status::Ok || numbers.iter().all(|x| x.is_finite()), "{numbers:?}: {call:?}");
}

//! One random call: what is random in it, and how it becomes arguments in C.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::instance;
use crate::fmi::life_cycle::Operation;
use crate::fmi2::tests::*;

/// What a call does with its arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pointers {
    Whole,
    Null,
    Misaligned,
    /// As many elements as fit into no memory.
    Absurd,
}

/// Which function: three of them must come in order for anything to happen, so they also come together.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    Instantiate,
    Free,
    TakeOff,
    Call(Operation),
}

/// One call; every function takes of it what it needs.
#[derive(Clone, Debug)]
pub struct Call {
    pub action: Action,
    /// One of the components; the last is NULL.
    pub component: usize,
    /// One of the saved states.
    pub state: usize,
    pub pointers: Pointers,
    pub references: Vec<u32>,
    pub reals: Vec<f64>,
    pub integers: Vec<c_int>,
    /// Flags of all kinds.
    pub choice: u8,
    /// Bytes of a serialised state that are replaced.
    pub damage: Vec<(Index, u8)>,
}

pub const COMPONENTS: usize = 3;
pub const STATES: usize = 4;

fn action() -> impl Strategy<Value = Action> {
    use Operation as O;
    let often = select(vec![
        O::DoStep,
        O::DoStep,
        O::DoStep,
        O::GetReal,
        O::GetReal,
        O::SetReal,
        O::SetReal,
        O::SetInteger,
        O::SetRealInputDerivatives,
        O::GetDirectionalDerivative,
        O::GetFMUstate,
        O::SetFMUstate,
        O::SerializeFMUstate,
        O::DeSerializeFMUstate,
    ]);
    let any = select(Operation::all().collect::<Vec<_>>());
    prop_oneof![
        1 => Just(Action::Instantiate),
        1 => Just(Action::Free),
        6 => Just(Action::TakeOff),
        60 => often.prop_map(Action::Call),
        32 => any.prop_map(Action::Call),
    ]
}

fn real() -> impl Strategy<Value = f64> {
    let usual = vec![0.0, 1e-3, -0.02, 0.1, 1.0, 5.0, 127.0, 160.0, 7620.0];
    let odd =
        vec![-0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 5e-324, 1e-300, 1e12];
    prop_oneof![8 => select(usual), 2 => -1.0..1.0, 1 => select(odd), 1 => any::<f64>()]
}

pub fn call() -> impl Strategy<Value = Call> {
    // Inputs, parameters, outputs, and what does not exist.
    let reference = prop_oneof![8 => 0_u32..12, 5 => 12_u32..23, 9 => 23_u32..93, 1 => any::<u32>()];
    let integer = prop_oneof![10 => 0..8, 1 => any::<c_int>()];
    let pointers = prop_oneof![
        24 => Just(Pointers::Whole),
        1 => Just(Pointers::Null),
        1 => Just(Pointers::Misaligned),
        1 => Just(Pointers::Absurd),
    ];
    let count = prop_oneof![8 => 1..3_usize, 4 => 0..12_usize, 1 => 200..300_usize];
    let arrays = count
        .prop_flat_map(move |n| (vec(reference.clone(), n), vec(real(), n + 3), vec(integer.clone(), n)));
    let damage = vec((any::<Index>(), any::<u8>()), 0..4);
    let component = prop_oneof![30 => 0..COMPONENTS, 1 => Just(COMPONENTS)];
    let numbers = (component, 0..STATES, any::<u8>());
    (action(), numbers, pointers, arrays, damage).prop_map(
        |(action, (component, state, choice), pointers, (references, reals, integers), damage)| Call {
            action,
            component,
            state,
            pointers,
            references,
            reals,
            integers,
            choice,
            damage,
        },
    )
}

impl Call {
    pub fn flag(&self, bit: u8) -> bool {
        self.choice >> bit & 1 == 1
    }

    /// Pointer and count of an array, as the call will have them.
    pub fn array<T>(&self, elements: &[T]) -> (*const T, usize) {
        let start = elements.as_ptr();
        match self.pointers {
            Pointers::Null => (null(), elements.len()),
            Pointers::Misaligned if align_of::<T>() > 1 => (start.wrapping_byte_add(1), elements.len()),
            Pointers::Whole | Pointers::Misaligned => (start, elements.len()),
            Pointers::Absurd => (start, usize::MAX),
        }
    }

    /// The same of an array to be filled.
    pub fn array_to_fill<T>(&self, elements: &mut [T]) -> (*mut T, usize) {
        let start = elements.as_mut_ptr();
        let (shaped, count) = self.array(elements);
        match self.pointers {
            Pointers::Null => (null_mut(), count),
            _ => (start.wrapping_byte_offset(shaped as isize - start as isize), count),
        }
    }

    /// A place for a result, or NULL.
    pub fn place<T>(&self, place: &mut T) -> *mut T {
        if self.pointers == Pointers::Null { null_mut() } else { place }
    }
}

pub fn get(call: &Call, function: Operation, c: Component) -> Status {
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
    reals.truncate(call.references.len());
    if status == Status::Ok && function == Operation::GetReal {
        assert!(reals.iter().all(|x| x.is_finite()), "{reals:?}: {call:?}");
    }
    status
}

pub fn set(call: &Call, function: Operation, c: Component) -> Status {
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

pub fn set_debug_logging(call: &Call, c: Component) -> Status {
    let names = [c"logStatusError", c"logAll", c"logEvents", c"logStatusWarning", c"%s%n"];
    let mut pointers: Vec<_> =
        names[..usize::from(call.choice % 6)].iter().map(|name| name.as_ptr()).collect();
    if call.flag(7) && call.flag(6) {
        pointers.push(null());
    }
    let (start, count) = call.array(&pointers);
    // SAFETY: the array is as long as said or is refused, its strings are constants or NULL.
    unsafe { fmi2SetDebugLogging(c, c_int::from(call.flag(0)), count, start) }
}

pub fn do_step(call: &Call, c: Component) -> Status {
    const SIZES: [f64; 12] =
        [0.01, 0.005, 0.0123, 3e-5, 0.0, 1e-12, 0.05, -0.1, f64::NAN, f64::INFINITY, 1e300, 2e7];
    let now = if c.is_null() { 0.0 } else { instance(c).time };
    let point = if call.flag(7) && call.flag(6) { call.reals[0] } else { now };
    // SAFETY: the component is alive or NULL.
    unsafe {
        fmi2DoStep(
            c,
            point,
            SIZES[usize::from(call.choice % 16).saturating_sub(4)],
            c_int::from(call.flag(5)),
        )
    }
}

pub fn differentiate(call: &Call, function: Operation, c: Component) -> Status {
    let (references, count) = call.array(&call.references);
    let (reals, orders) = (
        call.array(&call.reals).0,
        vec![[1, 1, 2, 0][usize::from(call.choice % 4)]; call.references.len() + 1],
    );
    let inputs: Vec<u32> = call.references.iter().map(|reference| reference % 12).collect();
    let mut results = vec![0.0; call.references.len() + 1];
    let places = call.array_to_fill(&mut results).0;
    // SAFETY: arrays are at least as long as said or are refused for their length, alignment or being NULL.
    unsafe {
        match function {
            Operation::GetDirectionalDerivative => fmi2GetDirectionalDerivative(
                c,
                references,
                count,
                call.array(&inputs).0,
                count,
                reals,
                places,
            ),
            Operation::SetRealInputDerivatives => {
                fmi2SetRealInputDerivatives(c, references, count, call.array(&orders).0, reals)
            }
            _ => fmi2GetRealOutputDerivatives(c, references, count, call.array(&orders).0, places),
        }
    }
}

pub fn ask(call: &Call, function: Operation, c: Component) -> Status {
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

//! One random call: what is random in it, and how it becomes arguments in C.

use std::rc::Rc;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::references::Pools;
use crate::fmi::operation::Operation;
use crate::fmi2::tests::surface::instance;
use crate::fmi2::tests::*;

/// What a call does with its arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pointers {
    Whole,
    Null,
    Misaligned,
    /// As many elements as fit into no memory.
    Absurd,
}

/// Which function: some of them must come in order for anything to happen, so they also come together.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Action {
    Instantiate,
    Free,
    TakeOff,
    Call(Operation),
}

/// One call; every function takes of it what it needs.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    pub action: Action,
    /// One of the components; the last is NULL.
    pub component: usize,
    /// One of the saved states.
    pub state: usize,
    pub pointers: Pointers,
    pub references: Vec<u32>,
    /// As many as references.
    pub knowns: Vec<u32>,
    pub reals: Vec<f64>,
    pub integers: Vec<c_int>,
    /// Flags of all kinds.
    pub choice: u8,
    /// Of counts that come twice one is wrong.
    pub is_miscounted: bool,
    /// Bytes of a serialised state that are replaced.
    pub damage: Vec<(Index, u8)>,
}

pub(crate) const COMPONENTS: usize = 3;
pub(crate) const STATES: usize = 4;

/// Of those that are worth being called often, these.
fn often(Interface { version, kind }: Interface) -> Vec<Operation> {
    use Operation as O;
    let mut often = vec![
        O::GetReal,
        O::GetReal,
        O::SetReal,
        O::SetReal,
        O::SetInteger,
        O::SetBoolean,
        O::SetInt64,
        O::GetDirectionalDerivative,
        O::GetFMUstate,
        O::SetFMUstate,
        O::SerializeFMUstate,
        O::DeSerializeFMUstate,
    ];
    often.extend(match kind {
        Kind::CoSimulation => vec![O::DoStep, O::DoStep, O::DoStep, O::SetRealInputDerivatives],
        Kind::ModelExchange => {
            vec![O::SetTime, O::SetContinuousStates, O::GetDerivatives, O::GetContinuousStates]
        }
    });
    often.retain(|operation| operation.name(version).is_some());
    often
}

fn action(interface: Interface) -> impl Strategy<Value = Action> {
    let has = |operation: &Operation| operation.name(interface.version).is_some();
    let any = select(Operation::ALL.iter().copied().filter(has).collect::<Vec<_>>());
    // A wrong call ends an instance of FMI 3.0.
    let take_offs = match interface.version {
        Version::V2 => 4,
        Version::V3 => 12,
    };
    prop_oneof![
        2 => Just(Action::Instantiate),
        1 => Just(Action::Free),
        take_offs => Just(Action::TakeOff),
        60 => select(often(interface)).prop_map(Action::Call),
        32 => any.prop_map(Action::Call),
    ]
}

fn real() -> impl Strategy<Value = f64> {
    let usual = vec![0.0, 1e-3, -0.02, 0.1, 1.0, 5.0, 127.0, 160.0, 7620.0];
    let odd =
        vec![-0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 5e-324, 1e-300, 1e12];
    prop_oneof![8 => select(usual), 12 => -0.1..0.1, 1 => select(odd), 1 => any::<f64>()]
}

/// Of an interface; the components are of these aircraft.
pub(crate) fn call(interface: Interface, pools: Rc<[Pools; COMPONENTS]>) -> impl Strategy<Value = Call> {
    let component = prop_oneof![30 => 0..COMPONENTS, 1 => Just(COMPONENTS)];
    (action(interface), component).prop_flat_map(move |(action, component)| {
        let pools = &pools[component % COMPONENTS];
        let (reference, known) = match action {
            Action::Call(function) => (pools.wanted_by(function), pools.knowns()),
            _ => (pools.all(), pools.all()),
        };
        let integer = prop_oneof![10 => 0..8, 1 => any::<c_int>()];
        let pointers = prop_oneof![
            40 => Just(Pointers::Whole),
            1 => Just(Pointers::Null),
            1 => Just(Pointers::Misaligned),
            1 => Just(Pointers::Absurd),
        ];
        let count = prop_oneof![8 => 1..3_usize, 4 => 0..12_usize, 1 => 200..300_usize];
        let arrays = count.prop_flat_map(move |n| {
            let (references, knowns) = (vec(reference.clone(), n), vec(known.clone(), n));
            (references, knowns, vec(real(), n + 3), vec(integer.clone(), n))
        });
        let damage = vec((any::<Index>(), any::<u8>()), 0..4);
        let is_miscounted = prop::bool::weighted(0.04);
        (0..STATES, any::<u8>(), pointers, arrays, damage, is_miscounted).prop_map(
            move |(state, choice, pointers, arrays, damage, is_miscounted)| {
                let (references, knowns, reals, integers) = arrays;
                Call {
                    action,
                    component,
                    state,
                    pointers,
                    references,
                    knowns,
                    reals,
                    integers,
                    choice,
                    is_miscounted,
                    damage,
                }
            },
        )
    })
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

    /// A count that FMI 3.0 wants a second time.
    pub fn second_count(&self, count: usize) -> usize {
        if self.is_miscounted { count.wrapping_add(1) } else { count }
    }

    /// The integers as another type.
    pub fn integers_as<T>(&self, convert: impl Fn(c_int) -> T) -> Vec<T> {
        self.integers.iter().map(|number| convert(*number)).collect()
    }

    /// Communication point and size of a step.
    pub fn step(&self, c: Component) -> [f64; 2] {
        const SIZES: [f64; 12] =
            [0.01, 0.005, 0.0123, 3e-5, 0.0, 1e-12, 0.05, -0.1, f64::NAN, f64::INFINITY, 1e300, 2e7];
        let now = if c.is_null() { 0.0 } else { instance(c).time };
        let point = if self.flag(7) && self.flag(6) { self.reals[0] } else { now };
        [point, SIZES[usize::from(self.choice % 16).saturating_sub(4)]]
    }

    /// A time to go to.
    pub fn time(&self, c: Component) -> f64 {
        let now = if c.is_null() { 0.0 } else { instance(c).time };
        if self.choice.is_multiple_of(8) { self.reals[0] } else { now + 0.005 * f64::from(self.choice % 4) }
    }

    /// States, most of them near these, and as many.
    pub fn states(&self, trim: &[f64]) -> Vec<f64> {
        let near = |change: f64| if change.is_finite() { 1e-3 * change.clamp(-1.0, 1.0) } else { 0.0 };
        let change = |i: usize| match self.reals[i % self.reals.len()] {
            change if self.choice.is_multiple_of(16) => change,
            change => near(change),
        };
        let mut states: Vec<f64> = trim.iter().enumerate().map(|(i, x)| x + change(i)).collect();
        if self.choice % 16 == 1 {
            states.pop();
        }
        states
    }
}

impl Call {
    /// Names of log categories, perhaps one too many or NULL.
    pub fn categories(&self) -> Vec<*const c_char> {
        let names = [c"logStatusError", c"logAll", c"logEvents", c"logStatusWarning", c"%s#%n"];
        let mut pointers: Vec<_> =
            names[..usize::from(self.choice % 6)].iter().map(|name| name.as_ptr()).collect();
        if self.flag(7) && self.flag(6) {
            pointers.push(null());
        }
        pointers
    }

    /// Derivatives are numbers unless the direction is beyond all reason.
    pub fn assert_finite_slopes(&self, status: Status, slopes: &[f64]) {
        let is_reasonable = self.reals.iter().all(|x| x.abs() < 1e100);
        assert!(
            !is_reasonable || status != Status::Ok || slopes.iter().all(|x| x.is_finite()),
            "{slopes:?}: {self:?}"
        );
    }
}

//! Random calls with random arguments: nothing crashes or hangs, what is refused says why and changes nothing,
//! what is read is a number, and nothing is left behind.

mod call;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use proptest::collection::vec;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use call::{
    Action, COMPONENTS, Call, Pointers, STATES, ask, call, differentiate, do_step, get, set,
    set_debug_logging,
};

use super::allocation::bytes_held;
use super::*;
use crate::aircraft::Aircraft;
use crate::fmi::instance::Instance;
use crate::fmi::life_cycle::{Operation, State};
use crate::sealed::{CHECKSUM, HEADER, hash};
use crate::structure::ReducedModel;

const SEQUENCES: u32 = 360;
const CALLS: usize = 360;

/// How often a function did what it was asked to, and how often it refused.
type Tally = BTreeMap<&'static str, [u32; 2]>;

/// What all calls of a sequence act on.
struct World<'a> {
    unpacked: &'a [(Unpacked, String)],
    tally: &'a RefCell<Tally>,
    fmus: [Option<Fmu>; COMPONENTS],
    states: [FmuState; STATES],
    bytes: Vec<u8>,
}

/// What is behind a component.
pub(super) fn instance(component: Component) -> &'static mut Instance {
    // SAFETY: a component is an `Instance`; the reference is given up before the next call into the FMU.
    unsafe { &mut *component.cast::<Instance>() }
}

impl World<'_> {
    fn component(&self, call: &Call) -> Component {
        let fmu = self.fmus.get(call.component).and_then(Option::as_ref);
        fmu.map_or(null_mut(), |fmu| fmu.component)
    }

    fn perform(&mut self, call: &Call) {
        match call.action {
            Action::Instantiate => self.instantiate(call),
            Action::Free => self.free(call),
            Action::TakeOff => self.take_off(call),
            Action::Call(function) => self.check(call, function),
        }
    }

    fn instantiate(&mut self, call: &Call) {
        let (unpacked, guid) = &self.unpacked[usize::from(call.flag(0))];
        let uri = if call.flag(1) { unpacked.uri("a {b}") } else { unpacked.uri("a {b}") + "/" };
        // Three bits that must all be set, so that most instances come into being.
        let spoilt = call.flag(2) && call.flag(3) && call.flag(4);
        let request = Request {
            name: [Some("/a b/%s/é"), Some("x"), None]
                [if spoilt { usize::from(call.flag(5)) + 1 } else { 0 }],
            kind: if spoilt && call.flag(6) { call.integers.first().copied().unwrap_or(7) } else { 1 },
            guid: if spoilt && call.flag(7) { Some("%n") } else { Some(guid) },
            uri: Some(&uri),
            logging_on: call.flag(6),
        };
        let fmu = Fmu::with_logger(&request, call.flag(5).then(variadic_logger));
        let possible = request.name.is_some() && request.kind == 1 && request.guid == Some(guid);
        assert_eq!(fmu.component.is_null(), !possible, "{request:?}: {:?}", fmu.log);
        if let Some(place) = self.fmus.get_mut(call.component).filter(|_| possible) {
            *place = Some(fmu);
        }
    }

    fn free(&mut self, call: &Call) {
        match self.fmus.get_mut(call.component) {
            Some(place) => *place = None,
            // SAFETY: NULL is ignored.
            None => unsafe { fmi2FreeInstance(null_mut()) },
        }
    }

    fn take_off(&mut self, call: &Call) {
        for function in [
            Operation::Reset,
            Operation::SetupExperiment,
            Operation::EnterInitializationMode,
            Operation::ExitInitializationMode,
        ] {
            let quiet = Call { pointers: Pointers::Whole, choice: 0, reals: vec![0.0; 3], ..call.clone() };
            self.check(&quiet, function);
        }
    }

    /// Calls a function and checks what must hold whatever the arguments are.
    fn check(&mut self, call: &Call, function: Operation) {
        let component = self.component(call);
        let messages = |world: &Self| {
            let fmu = world.fmus.get(call.component).and_then(Option::as_ref);
            fmu.map_or(0, |fmu| fmu.log.borrow().len())
        };
        let before = (!component.is_null()).then(|| (saved(instance(component)), messages(self)));
        let began = Instant::now();
        let status = self.call(call, function, component);
        assert!(began.elapsed() < Duration::from_secs(20), "{function:?} hangs: {call:?}");
        let Some((before, messages_before)) = before else {
            assert_eq!(status, Status::Error, "{function:?} on NULL");
            return;
        };
        assert_ne!(status, Status::Fatal, "{function:?}: {call:?}");
        let succeeded = matches!(status, Status::Ok | Status::Warning);
        self.tally.borrow_mut().entry(functions::name(function)).or_default()[usize::from(!succeeded)] += 1;
        if succeeded {
            return;
        }
        let instance = instance(component);
        assert!(saved(instance) == before, "{function:?} was refused and changed something: {call:?}");
        if instance.log.wants(status) {
            let fmu = self.fmus[call.component].as_ref().expect("it has a component");
            let message = fmu.last_message();
            assert_eq!(messages(self), messages_before + 1, "{function:?}: {message:?}");
            assert_eq!(message.status, status);
            assert!(message.format.contains(functions::name(function)), "{message:?}");
            assert!(!message.format.replace("%%", "").contains('%'), "{message:?}");
        }
    }

    fn call(&mut self, call: &Call, function: Operation, c: Component) -> Status {
        use Operation as O;
        match function {
            O::GetReal | O::GetInteger | O::GetBoolean | O::GetString => get(call, function, c),
            O::SetReal | O::SetInteger | O::SetBoolean | O::SetString => set(call, function, c),
            O::GetFMUstate
            | O::SetFMUstate
            | O::FreeFMUstate
            | O::SerializedFMUstateSize
            | O::SerializeFMUstate
            | O::DeSerializeFMUstate => self.call_on_state(call, function, c),
            O::SetDebugLogging => set_debug_logging(call, c),
            O::DoStep => do_step(call, c),
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
            _ => life_cycle::call(function, c),
        }
    }

    fn call_on_state(&mut self, call: &Call, function: Operation, c: Component) -> Status {
        use Operation as O;
        let state = self.states[call.state];
        let place = call.place(&mut self.states[call.state]);
        let mut size = 0;
        // SAFETY: components and states are alive or NULL; arrays are as long as said or are refused for their
        // length, alignment or being NULL. States may serve another component than they came from.
        unsafe {
            match function {
                O::GetFMUstate => fmi2GetFMUstate(c, place),
                O::SetFMUstate => fmi2SetFMUstate(c, state),
                O::FreeFMUstate => fmi2FreeFMUstate(c, place),
                O::SerializedFMUstateSize => fmi2SerializedFMUstateSize(c, state, call.place(&mut size)),
                O::SerializeFMUstate => {
                    if !state.is_null() {
                        fmi2SerializedFMUstateSize(c, state, &mut size);
                    }
                    let mut bytes = vec![0_u8; if call.flag(0) { size } else { size / 2 }];
                    let (pointer, count) = call.array_to_fill(&mut bytes);
                    let status = fmi2SerializeFMUstate(c, state, pointer.cast(), count);
                    if status == Status::Ok && call.pointers == Pointers::Whole {
                        self.bytes = bytes;
                    }
                    status
                }
                _ => {
                    let bytes = self.damaged(call);
                    let (pointer, count) = call.array(&bytes);
                    fmi2DeSerializeFMUstate(c, pointer.cast(), count, place)
                }
            }
        }
    }

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

    /// Frees what is left.
    fn clear(&mut self) {
        if let Some(fmu) =
            self.fmus.iter().flatten().find(|fmu| instance(fmu.component).state != State::Fatal)
        {
            for state in &mut self.states {
                // SAFETY: the component is alive, states are alive or NULL.
                assert_eq!(unsafe { fmi2FreeFMUstate(fmu.component, state) }, Status::Ok);
            }
        }
        assert_eq!(self.states, [null_mut(); STATES]);
        self.fmus = Default::default();
    }
}

/// Makes length and checksum of a state right, so that everything else is put to the test.
pub(super) fn fit_checksum(bytes: &mut [u8]) {
    let Some(end) = bytes.len().checked_sub(CHECKSUM) else { return };
    let length = bytes.len() as u64;
    if end >= HEADER {
        bytes[8..16].copy_from_slice(&length.to_le_bytes());
    }
    let checksum = hash(&bytes[..end]);
    bytes[end..].copy_from_slice(&checksum.to_le_bytes());
}

/// Two small aircraft: the jet with few modes, and a wing in a tunnel.
fn aircraft() -> [ReducedModel; 2] {
    let reduced =
        |text: &str, modes| ReducedModel::new(&Aircraft::parse(text, "aircraft.toml").unwrap(), modes);
    [
        reduced(include_str!("../../../aircraft/generic-business-jet.toml"), 4).unwrap(),
        reduced(include_str!("../../../aircraft/goland-wing.toml"), 3).unwrap(),
    ]
}

/// Other sequences: `RANDOM_SEED=<number> cargo test random`.
#[test]
fn a_hundred_thousand_random_calls_crash_nothing_hang_nothing_and_leave_nothing_behind() {
    let seed: u64 = std::env::var("RANDOM_SEED").map_or(0, |seed| seed.parse().unwrap());
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let config =
        Config { cases: SEQUENCES, failure_persistence: None, max_shrink_iters: 200, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &key));
    let unpacked = aircraft().map(|model| (Unpacked::of(&model.to_bytes(), "a {b}"), guid(&model)));
    let tally = RefCell::new(Operation::all().map(|function| (functions::name(function), [0; 2])).collect());
    let played = runner.run(&vec(call(), CALLS), |calls| {
        let held = bytes_held();
        let mut world = World {
            unpacked: &unpacked,
            tally: &tally,
            fmus: Default::default(),
            states: [null_mut(); STATES],
            bytes: Vec::new(),
        };
        for component in 0..COMPONENTS {
            let choice = if component == 1 { 0b0110_0001 } else { 0b0110_0000 };
            world.instantiate(&Call { component, choice, ..calls[0].clone() });
        }
        calls.iter().for_each(|call| world.perform(call));
        world.instantiate(&Call { component: 0, choice: 0, ..calls[0].clone() });
        world.clear();
        drop(world);
        assert_eq!(bytes_held(), held, "memory was left behind");
        Ok(())
    });
    if let Err(failure) = played {
        panic!("{failure}");
    }
    let tally = tally.into_inner();
    assert!(tally.values().flatten().sum::<u32>() >= 100_000, "{tally:?}");
    for (function, [done, _]) in &tally {
        assert_eq!(*done == 0, NEVER_DONE.contains(function), "{function}: {tally:?}");
    }
}

/// What this FMU always refuses.
const NEVER_DONE: [&str; 15] = [
    "fmi2CancelStep",
    "fmi2CompletedIntegratorStep",
    "fmi2EnterContinuousTimeMode",
    "fmi2EnterEventMode",
    "fmi2GetContinuousStates",
    "fmi2GetDerivatives",
    "fmi2GetEventIndicators",
    "fmi2GetIntegerStatus",
    "fmi2GetNominalsOfContinuousStates",
    "fmi2GetRealOutputDerivatives",
    "fmi2GetStatus",
    "fmi2GetStringStatus",
    "fmi2NewDiscreteStates",
    "fmi2SetContinuousStates",
    "fmi2SetTime",
];

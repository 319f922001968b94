//! Random calls with random arguments: nothing crashes or hangs, what is refused says why and changes nothing (but that a
//! wrong call ends an instance of FMI 3.0), what is read is a number, and nothing is left behind.
//!
//! The driver is that of all versions and kinds; each version says how its functions are called.

mod call;
mod means;
mod references;
mod two;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::time;

use proptest::collection::vec;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

pub(crate) use call::{Call, Pointers};
pub(crate) use means::{Means, assert_finite, call_the_same};

use call::{Action, COMPONENTS, STATES, call};
use references::Pools;

use super::allocation::bytes_held;
use super::surface::{Archive, Instantiation, Surface, instance};
use super::*;
use crate::aircraft::Aircraft;
use crate::fmi::instance::Instance;
use crate::fmi::life_cycle::State;
use crate::fmi::operation::Operation;
use crate::structure::ReducedModel;

/// Calls of a function of which some must do what they ask for.
const OFTEN: u32 = 300;

const SEQUENCES: u32 = 80;
const CALLS: usize = 360;

/// How a version of FMI is called with random arguments.
pub(crate) trait Random: Surface {
    /// Calls a function.
    fn call(call: &Call, function: Operation, component: Component, means: &mut Means) -> Status;

    /// Frees an instance that is NULL.
    fn free_null();
}

/// How often a function did what it was asked to, and how often it refused.
type Tally = BTreeMap<&'static str, [u32; 2]>;

/// What all calls of a sequence act on.
struct World<'a, S: Random> {
    archives: &'a [Archive; 2],
    tally: &'a RefCell<Tally>,
    fmus: [Option<S>; COMPONENTS],
    /// States of each component where it last took off, where the importer integrates.
    trims: [Vec<f64>; COMPONENTS + 1],
    means: Means,
}

/// The first component is of the first aircraft, whose trim takes its time.
fn aircraft_of(component: usize) -> usize {
    usize::from(component > 0)
}

fn name<S: Surface>(function: Operation) -> &'static str {
    function.name(S::VERSION).expect("an operation of this version")
}

impl<S: Random> World<'_, S> {
    fn fmu(&self, call: &Call) -> Option<&S> {
        self.fmus.get(call.component).and_then(Option::as_ref)
    }

    fn perform(&mut self, call: &Call) {
        match call.action {
            Action::Instantiate => self.instantiate(call),
            Action::Free => match self.fmus.get_mut(call.component) {
                Some(place) => *place = None,
                None => S::free_null(),
            },
            Action::TakeOff => self.take_off(call),
            Action::Call(function) => self.check(call, function),
        }
    }

    fn instantiate(&mut self, call: &Call) {
        let archive = &self.archives[aircraft_of(call.component)];
        let folder = if call.flag(1) { archive.folder() } else { archive.folder() + "/" };
        // Three bits that must all be set, so that most instances come into being.
        let flaw = (call.flag(2) && call.flag(3) && call.flag(4)).then_some(call.choice % 4);
        let request = Instantiation {
            logging_on: call.flag(6),
            has_logger: call.flag(5),
            flaw,
            ..archive.request(&folder)
        };
        let fmu = S::instantiate(&request);
        assert_eq!(fmu.component().is_null(), flaw.is_some(), "{flaw:?}: {:?}", fmu.last_message());
        if let Some(place) = self.fmus.get_mut(call.component).filter(|_| flaw.is_none()) {
            *place = Some(fmu);
        }
    }

    /// To the first communication point, or to where the importer integrates; or less far.
    fn take_off(&mut self, call: &Call) {
        let mut functions = vec![
            Operation::Reset,
            Operation::SetupExperiment,
            Operation::EnterInitializationMode,
            Operation::ExitInitializationMode,
        ];
        functions.retain(|function| function.name(S::VERSION).is_some());
        let is_exchange = self.archives[0].interface.kind == Kind::ModelExchange;
        if is_exchange {
            functions.push(Operation::EnterContinuousTimeMode);
        }
        let left_out = [3, 2, 1, 1, 0, 0, 0, 0][usize::from(call.choice % 8)];
        functions.truncate(functions.len() - left_out.min(functions.len() - 1));
        for function in functions {
            let quiet = Call { pointers: Pointers::Whole, choice: 0, reals: vec![0.0; 3], ..call.clone() };
            self.check(&quiet, function);
        }
        if let Some(fmu) = self.fmu(call).filter(|_| is_exchange && left_out <= 1) {
            let c = fmu.component();
            let mut states = vec![f64::NAN; instance(c).state_count()];
            // SAFETY: the component is alive, the array is as long as said.
            let status = unsafe { (S::EXCHANGE.states)(c, states.as_mut_ptr(), states.len()) };
            assert_eq!(status, Status::Ok, "{:?}", fmu.last_message());
            self.trims[call.component] = states;
        }
    }

    /// Calls a function and checks what must hold whatever the arguments are.
    fn check(&mut self, call: &Call, function: Operation) {
        let component = self.fmu(call).map_or(null_mut(), Surface::component);
        let complaints = |world: &Self| world.fmu(call).map_or(0, Surface::complaint_count);
        let before = (!component.is_null())
            .then(|| (instance(component).state, saved(instance(component)), complaints(self)));
        self.means.trim.clone_from(&self.trims[call.component]);
        let began = time::Instant::now();
        let status = S::call(call, function, component, &mut self.means);
        assert!(began.elapsed() < time::Duration::from_secs(20), "{function:?} hangs: {call:?}");
        let Some((state_before, before, complaints_before)) = before else {
            assert_eq!(status, Status::Error, "{function:?} on NULL");
            return;
        };
        let fmu = self.fmu(call).expect("it has a component");
        assert_ne!(status, Status::Fatal, "{:?}: {call:?}", fmu.last_message());
        let succeeded = matches!(status, Status::Ok | Status::Warning);
        self.tally.borrow_mut().entry(name::<S>(function)).or_default()[usize::from(!succeeded)] += 1;
        if succeeded {
            if call.choice.is_multiple_of(4) {
                assert_goes_back_to_its_own_state(instance(component), call);
            }
            return;
        }
        let instance = instance(component);
        if S::VERSION == Version::V3 && status == Status::Error {
            assert_eq!(instance.state, State::Terminated, "{function:?}: {call:?}");
            instance.state = state_before;
            assert!(saved(instance) == before, "{function:?} changed more than the state: {call:?}");
            instance.state = State::Terminated;
        } else {
            assert!(
                saved(instance) == before,
                "{function:?} was refused ({:?}) and changed something: {call:?}",
                fmu.last_message()
            );
        }
        if instance.log.wants(status) {
            let (found, text) = fmu.last_message().expect("it is told");
            assert_eq!(complaints(self), complaints_before + 1, "{function:?}: {text}");
            assert_eq!(found, status);
            assert!(text.contains(name::<S>(function)), "{text}");
            let special = match S::VERSION {
                Version::V2 => "%",
                Version::V3 => "#",
            };
            assert!(!text.replace(&special.repeat(2), "").contains(special), "{text}");
        }
    }

    /// Frees what is left.
    fn clear(&mut self) {
        let is_alive = |fmu: &&S| instance(fmu.component()).state != State::Fatal;
        if let Some(fmu) = self.fmus.iter().flatten().find(is_alive) {
            for state in &mut self.means.states {
                // SAFETY: the component is alive, states are alive or NULL.
                assert_eq!(unsafe { (S::STATES.free)(fmu.component(), state) }, Status::Ok);
            }
        }
        assert_eq!(self.means.states, [null_mut(); STATES]);
        self.fmus = Default::default();
    }
}

/// Wherever an instance has come to, a state saved there leads back there.
fn assert_goes_back_to_its_own_state(instance: &mut Instance, call: &Call) {
    let own = saved(instance);
    assert_eq!(instance.restore(&own), Ok(()), "{call:?}");
    assert!(saved(instance) == own, "{call:?}");
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

/// More than 15 000 calls over one interface, of which some functions are refused always.
/// Other sequences: `RANDOM_SEED=<number> cargo test random`.
pub(crate) fn play<S: Random>(kind: Kind, never_done: &[&str]) {
    let interface = Interface { version: S::VERSION, kind };
    let seed: u64 = std::env::var("RANDOM_SEED").map_or(0, |seed| seed.parse().unwrap());
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let config =
        Config { cases: SEQUENCES, failure_persistence: None, max_shrink_iters: 200, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &key));
    let archives = aircraft().map(|model| Archive::new(interface, &model));
    let pools: [Pools; COMPONENTS] =
        std::array::from_fn(|component| Pools::of(interface, &archives[aircraft_of(component)].model));
    let names = Operation::ALL.iter().filter_map(|function| function.name(S::VERSION));
    let tally = RefCell::new(names.map(|name| (name, [0; 2])).collect());
    let played = runner.run(&vec(call(interface, Rc::new(pools)), CALLS), |calls| {
        let held = bytes_held();
        let mut world = World::<S> {
            archives: &archives,
            tally: &tally,
            fmus: Default::default(),
            trims: Default::default(),
            means: Means::default(),
        };
        for component in 0..COMPONENTS {
            world.instantiate(&Call { component, choice: 0b0110_0000, ..calls[0].clone() });
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
    assert!(tally.values().flatten().sum::<u32>() >= 15_000, "{tally:?}");
    for (function, [done, refused]) in &tally {
        assert!(*done == 0 || !never_done.contains(function), "{function}: {tally:?}");
        // What is asked rarely may have been refused by chance each time; the tables of the life cycle are tried one by one.
        let is_asked_often = done + refused >= OFTEN;
        assert!(*done > 0 || !is_asked_often || never_done.contains(function), "{function}: {tally:?}");
        let is_always_right = ["Reset", "FreeFMUstate", "FreeFMUState"].contains(&&function[4..]);
        assert!(*refused == 0 || !is_always_right, "{function}: {tally:?}");
        assert!(*refused > 0 || is_always_right || !is_asked_often, "{function}: {tally:?}");
    }
    if std::env::var_os("RANDOM_TALLY").is_some() {
        println!("{tally:#?}");
    }
}

#[test]
fn random_calls_over_fmi_2_co_simulation_crash_nothing_hang_nothing_and_leave_nothing_behind() {
    play::<Fmu>(
        Kind::CoSimulation,
        &[
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
        ],
    );
}

#[test]
fn random_calls_over_fmi_2_model_exchange_crash_nothing_hang_nothing_and_leave_nothing_behind() {
    play::<Fmu>(
        Kind::ModelExchange,
        &[
            "fmi2CancelStep",
            "fmi2DoStep",
            "fmi2GetBooleanStatus",
            "fmi2GetIntegerStatus",
            "fmi2GetRealOutputDerivatives",
            "fmi2GetRealStatus",
            "fmi2GetStatus",
            "fmi2GetStringStatus",
            "fmi2SetRealInputDerivatives",
        ],
    );
}

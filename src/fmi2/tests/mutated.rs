//! Mutated bytes at the three doors: aircraft file, reduced model, serialised state. What comes in is refused with
//! a reason or flies; nothing panics, hangs or takes memory that a forged length asks for.
//!
//! The targets under `fuzz/` do the same for longer, guided by what the bytes reach.

use std::cell::Cell;
use std::sync::Arc;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use crate::aircraft::{Aircraft, AircraftFileError, Fidelity};
use crate::flight::{Inputs, Settings, Simulation};
use crate::fmi::description;
use crate::fmi::life_cycle::State;
use crate::plant::PlantSettings;
use crate::sealed::hash;
use crate::structure::ReducedModel;

use super::endurance::typical_section;
use super::surface::{Archive, Saved, Surface, fit_checksum, instance};
use super::*;

/// A change of a sequence of bytes.
#[derive(Clone, Debug)]
enum Mutation {
    Replace(Index, u8),
    Insert(Index, u8),
    Remove(Index, usize),
    Repeat(Index, usize),
    /// A double whose bytes begin there.
    Number(Index, f64),
    Truncate(Index),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let byte = prop_oneof![
        any::<u8>(),
        select(vec![0, 1, 0x7f, 0x80, 0xff, b'0', b'9', b'-', b'.', b'[', b'"', b'\n'])
    ];
    let number =
        select(vec![f64::NAN, f64::INFINITY, f64::MAX, -f64::MAX, 0.0, -0.0, -1.0, 5e-324, 1e9, 1e100]);
    let at = any::<Index>;
    prop_oneof![
        6 => (at(), byte.clone()).prop_map(|(at, byte)| Mutation::Replace(at, byte)),
        2 => (at(), byte).prop_map(|(at, byte)| Mutation::Insert(at, byte)),
        2 => (at(), 1..20_usize).prop_map(|(at, count)| Mutation::Remove(at, count)),
        1 => (at(), 1..60_usize).prop_map(|(at, count)| Mutation::Repeat(at, count)),
        6 => (at(), number).prop_map(|(at, number)| Mutation::Number(at, number)),
        1 => at().prop_map(Mutation::Truncate),
    ]
}

impl Mutation {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let place = |at: &Index, bytes: &[u8]| at.index(bytes.len().max(1));
        match self {
            Mutation::Replace(at, byte) => {
                let at = place(at, bytes);
                bytes.iter_mut().skip(at).take(1).for_each(|place| *place = *byte);
            }
            Mutation::Insert(at, byte) => bytes.insert(at.index(bytes.len() + 1), *byte),
            Mutation::Remove(at, count) => {
                let at = place(at, bytes);
                bytes.drain(at.min(bytes.len())..(at + count).min(bytes.len()));
            }
            Mutation::Repeat(at, count) => {
                let at = place(at, bytes);
                let part = bytes[at.min(bytes.len())..(at + count).min(bytes.len())].to_vec();
                bytes.splice(at.min(bytes.len())..at.min(bytes.len()), part);
            }
            Mutation::Number(at, number) => {
                let at = place(at, bytes);
                bytes.iter_mut().skip(at).zip(number.to_le_bytes()).for_each(|(place, byte)| *place = byte);
            }
            Mutation::Truncate(at) => bytes.truncate(at.index(bytes.len() + 1)),
        }
    }
}

/// Hands many mutations of `whole` to `check`.
fn mutate(whole: &[u8], cases: u32, check: impl Fn(Vec<u8>)) {
    each(cases, vec(mutation(), 1..4), |mutations| {
        let mut bytes = whole.to_vec();
        mutations.iter().for_each(|mutation| mutation.apply(&mut bytes));
        check(bytes);
    });
}

/// Hands many values of a strategy to `check`, the same ones each time.
fn each<S: Strategy>(cases: u32, strategy: S, check: impl Fn(S::Value)) {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 500, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]));
    let played = runner.run(&strategy, |value| {
        check(value);
        Ok(())
    });
    if let Err(failure) = played {
        panic!("{failure}");
    }
}

/// Everything that an FMU does with a model that has been accepted, at its own level of fidelity and geometrically exactly.
fn fly(model: ReducedModel) {
    assert!(description::write(Interface::USUAL, &model, &Settings::of(&model)).contains(&guid(&model)));
    let model = Arc::new(model);
    let own = PlantSettings { mode_count: model.natural_modes(), ..PlantSettings::of(&model) };
    for fidelity in [own.fidelity, Fidelity::GeometricallyExact] {
        let settings = Settings::from(PlantSettings { fidelity, ..own });
        let (inputs, zero) = (Inputs::zero(&model), Inputs::zero(&model));
        if let Ok(mut flight) = Simulation::new(Arc::clone(&model), &settings, 0.0) {
            flight.set_inputs(&inputs, &zero);
            let _ = flight.advance_to(0.012);
            let _ = flight.outputs();
        }
    }
}

/// Reads an aircraft file; whether it describes an aircraft.
fn read(text: &str) -> bool {
    match Aircraft::parse(text, "mutated.toml") {
        Ok(aircraft) => {
            // Larger ones differ in nothing but the time that they take.
            if let (..30, Ok(model)) = (aircraft.beams.len(), ReducedModel::new(&aircraft, 4)) {
                fly(model);
            }
            true
        }
        Err(AircraftFileError::Rejected { diagnostics, .. }) => {
            assert!(!diagnostics.is_empty());
            false
        }
        Err(error) => panic!("{error}"),
    }
}

const AIRCRAFT: &str = include_str!("../../../tests/data/small-aircraft.toml");

#[test]
fn a_mutated_aircraft_file_is_refused_with_a_place_or_flies() {
    mutate(AIRCRAFT.as_bytes(), 3000, |bytes| {
        read(&String::from_utf8_lossy(&bytes));
    });
}

/// Where the numbers of a text are.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let is_number = |c: char| c.is_ascii_digit() || "+-.e".contains(c);
    let ends = text.char_indices().map(|(end, _)| end).filter(|end| !text[*end..].starts_with(is_number));
    let starts = ends.clone().map(|end| text[..end].trim_end_matches(is_number).len());
    let words = starts.zip(ends).map(|(start, end)| start..end);
    words.filter(|word| text[word.clone()].parse::<f64>().is_ok()).collect()
}

#[test]
fn an_aircraft_file_with_other_numbers_is_refused_with_a_place_or_flies() {
    let other = select(vec![
        "0",
        "-0.0",
        "1",
        "2",
        "3",
        "0.5",
        "-1",
        "1e-9",
        "1e-300",
        "5e-324",
        "1e9",
        "1e100",
        "1e308",
        "-1e308",
        "inf",
        "nan",
        "9223372036854775807",
        "1e999",
        "\"x\"",
        "[]",
        "[0, 1]",
        "[0, 0, 0]",
        "{}",
        "true",
    ]);
    let accepted = Cell::new(0);
    each(3000, vec((any::<Index>(), other), 1..4), |changes| {
        let mut text = AIRCRAFT.to_owned();
        for (place, other) in changes {
            let places = numbers(&text);
            text.replace_range(places[place.index(places.len())].clone(), other);
        }
        accepted.set(accepted.get() + u32::from(read(&text)));
    });
    assert!(accepted.get() > 100, "{accepted:?}");
}

#[test]
fn a_mutated_reduced_model_is_refused_or_flies_even_if_its_checksum_fits() {
    const HEADER: usize = 32;
    let whole = typical_section().to_bytes();
    let accepted = Cell::new(0);
    mutate(&whole[HEADER..], 8000, |payload| {
        let mut bytes = whole[..8].to_vec();
        bytes.extend((payload.len() as u64).to_le_bytes());
        bytes.extend(hash(&payload).to_le_bytes());
        bytes.extend(&payload);
        if let Ok(model) = ReducedModel::from_bytes(&bytes) {
            accepted.set(accepted.get() + 1);
            fly(model);
        }
        bytes[HEADER / 2] ^= 1;
        assert!(ReducedModel::from_bytes(&bytes).is_err(), "a wrong checksum was accepted");
    });
    assert!(accepted.get() > 1000, "{accepted:?}");
}

/// Mutated states of a wing over one interface: each is refused and changes nothing (but that an error ends an instance of
/// FMI 3.0), or what can be asked for afterwards is a number or refused.
pub(crate) fn mutated_states_are_refused_or_go_on<S: Surface>(kind: Kind) {
    let archive = Archive::new(Interface { version: S::VERSION, kind }, &typical_section());
    let fmu: S = archive.instantiate();
    assert_eq!(fmu.initialise(), Status::Ok, "{:?}", fmu.last_message());
    let moved = match kind {
        Kind::CoSimulation => fmu.step(0.0, 0.012),
        // SAFETY: the component is alive.
        Kind::ModelExchange => unsafe { (S::EXCHANGE.enter)(fmu.component()) },
    };
    assert_eq!(moved, Status::Ok);
    let reals = archive.reals();
    let good = Saved::of(&fmu);
    let (whole, accepted) = (good.bytes(), Cell::new(0));
    let instance = || instance(fmu.component());
    mutate(&whole, 2500, |mut bytes| {
        let (before, state) = (saved(instance()), instance().state);
        let raw = Saved::from_bytes(&fmu, &bytes).err();
        assert!(bytes == whole || raw == Some(Status::Error), "a wrong checksum was accepted");
        fit_checksum(&mut bytes);
        match Saved::from_bytes(&fmu, &bytes).and_then(|saved| ok(saved.restore())) {
            Ok(()) => {
                accepted.set(accepted.get() + 1);
                go_on(&fmu, kind, &reals);
                let own = Saved::of(&fmu).restore();
                assert_eq!(own, Status::Ok, "it does not take its own state: {:?}", fmu.last_message());
            }
            Err(status) => {
                assert_eq!(status, Status::Error);
                if S::VERSION == Version::V3 {
                    assert_eq!(instance().state, State::Terminated);
                    instance().state = state;
                }
                assert!(saved(instance()) == before, "{:?}", fmu.last_message());
            }
        }
        assert_eq!(good.restore(), Status::Ok);
        assert!(saved(instance()) == before);
        fmu.forget_messages();
    });
    assert!(accepted.get() > 150, "{accepted:?}");
}

fn ok(status: Status) -> Result<(), Status> {
    if status == Status::Ok { Ok(()) } else { Err(status) }
}

/// Reads what there is, and flies or integrates on.
fn go_on<S: Surface>(fmu: &S, kind: Kind, reals: &[u32]) {
    let c = fmu.component();
    for reference in reals {
        let mut value = [f64::NAN];
        let status = fmu.get_reals(&[*reference], &mut value);
        assert_ne!(status, Status::Fatal, "{:?}", fmu.last_message());
        assert!(status != Status::Ok || value[0].is_finite());
    }
    let time = instance(c).time;
    if kind == Kind::CoSimulation {
        assert_ne!(fmu.step(time, 0.012), Status::Fatal, "{:?}", fmu.last_message());
        return;
    }
    let mut states = vec![0.0; instance(c).state_count()];
    let (mut rates, count) = (vec![f64::NAN; states.len()], states.len());
    // SAFETY: the component is alive, the arrays are as long as said.
    let statuses = unsafe {
        [
            (S::EXCHANGE.rates)(c, rates.as_mut_ptr(), count),
            (S::EXCHANGE.states)(c, states.as_mut_ptr(), count),
            (S::EXCHANGE.set_time)(c, time + 0.001),
            (S::EXCHANGE.set_states)(c, states.as_ptr(), count),
        ]
    };
    assert!(!statuses.contains(&Status::Fatal), "{:?}", fmu.last_message());
    assert!(statuses[0] != Status::Ok || rates.iter().all(|rate| rate.is_finite()));
}

#[test]
fn a_mutated_state_of_co_simulation_is_refused_and_changes_nothing_or_goes_on() {
    mutated_states_are_refused_or_go_on::<Fmu>(Kind::CoSimulation);
}

#[test]
fn a_mutated_state_of_model_exchange_is_refused_and_changes_nothing_or_goes_on() {
    mutated_states_are_refused_or_go_on::<Fmu>(Kind::ModelExchange);
}

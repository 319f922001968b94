//! Long flights and many instances: no leak, no growth, no drift.

use super::allocation::{allocations, bytes_held};
use super::surface::{Archive, Saved, Surface, instance};
use super::*;
use crate::aircraft::Aircraft;
use crate::structure::ReducedModel;

/// The smallest of the shipped aircraft: one strip on one beam in a wind tunnel, of two modes.
pub(crate) fn typical_section() -> ReducedModel {
    let text = include_str!("../../../aircraft/typical-section.toml");
    ReducedModel::new(&Aircraft::parse(text, "typical-section.toml").unwrap(), 2).unwrap()
}

/// Instantiated from what `unpacked` has in its folder `wing`.
pub(super) fn wing(unpacked: &Unpacked, guid: &str) -> Fmu {
    let uri = unpacked.uri("wing");
    let request =
        Request { name: Some("wing"), kind: 1, guid: Some(guid), uri: Some(&uri), logging_on: false };
    Fmu::request(&request)
}

/// A wing in a gust, at its first communication point.
struct Wing {
    fmu: Fmu,
    plunge: u32,
}

impl Wing {
    fn new() -> Self {
        Wing::instantiate(&Unpacked::of(&typical_section().to_bytes(), "wing"), &guid(&typical_section()))
    }

    fn instantiate(unpacked: &Unpacked, guid: &str) -> Self {
        let fmu = wing(unpacked, guid);
        let table = VariableTable::new(&typical_section());
        let references = ["airspeed", "altitude", "wind_down"].map(|name| table.reference(name).unwrap());
        assert_eq!(fmu.set_references(&references, &[20.0, 0.0, -0.5]), Status::Ok);
        let statuses = [fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()];
        assert_eq!(statuses, [Status::Ok; 3], "{:?}", fmu.log);
        Wing { fmu, plunge: table.reference("modal.q[1]").unwrap() }
    }

    fn plunge(&self) -> f64 {
        self.fmu.get_references(&[self.plunge]).unwrap()[0]
    }
}

/// Instances of one interface, most of their lives long, and of some an error.
pub(crate) fn a_thousand_instances_come_and_go<S: Surface>(kind: Kind) {
    let archive = Archive::new(Interface { version: S::VERSION, kind }, &typical_section());
    let references = archive.references(["airspeed", "altitude", "wind_down"]);
    let come_and_go = || {
        let fmu: S = archive.instantiate();
        assert_eq!(fmu.set_reals(&references, &[20.0, 0.0, -0.5]), Status::Ok);
        assert_eq!(fmu.initialise(), Status::Ok, "{:?}", fmu.last_message());
        let saved = Saved::of(&fmu);
        match kind {
            Kind::CoSimulation => {
                assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
                assert_eq!(saved.restore(), Status::Ok);
                assert_eq!(fmu.step(0.5, 0.01), Status::Error);
            }
            Kind::ModelExchange => {
                let mut rates = vec![0.0; instance(fmu.component()).state_count()];
                // SAFETY: the component is alive, the array is as long as said.
                let statuses = unsafe {
                    [
                        (S::EXCHANGE.enter)(fmu.component()),
                        (S::EXCHANGE.rates)(fmu.component(), rates.as_mut_ptr(), rates.len()),
                        saved.restore(),
                        (S::EXCHANGE.set_time)(fmu.component(), -7.0),
                    ]
                };
                assert_eq!(statuses, [Status::Ok, Status::Ok, Status::Ok, Status::Error]);
            }
        }
        assert_eq!(fmu.reset(), Status::Ok);
    };
    come_and_go();
    let held = bytes_held();
    (0..1000).for_each(|_| come_and_go());
    assert_eq!(bytes_held(), held);
    let kept: S = archive.instantiate();
    assert!(bytes_held() > held, "the count does not count");
    drop(kept);
}

#[test]
fn a_thousand_instances_for_co_simulation_come_and_go_without_a_leak() {
    a_thousand_instances_come_and_go::<Fmu>(Kind::CoSimulation);
}

#[test]
fn a_thousand_instances_for_model_exchange_come_and_go_without_a_leak() {
    a_thousand_instances_come_and_go::<Fmu>(Kind::ModelExchange);
}

/// What an importer does that integrates by itself, as often as in a minute of flight.
pub(crate) fn twenty_thousand_evaluations_allocate_nothing<S: Surface>() {
    let archive =
        Archive::new(Interface { version: S::VERSION, kind: Kind::ModelExchange }, &typical_section());
    let fmu: S = archive.instantiate();
    let starts = archive.references(["airspeed", "altitude"]);
    assert_eq!(fmu.set_reals(&starts, &[20.0, 0.0]), Status::Ok);
    assert_eq!(fmu.initialise(), Status::Ok);
    let (c, inputs) = (fmu.component(), archive.references(["wind_down", "wind_rate_down"]));
    let (outputs, mut values) = (archive.reals(), vec![f64::NAN; archive.reals().len()]);
    let mut x = vec![0.0; instance(c).state_count()];
    let (mut rates, count) = (x.clone(), x.len());
    // SAFETY: the component is alive, the array is as long as said.
    let begun = unsafe { [(S::EXCHANGE.enter)(c), (S::EXCHANGE.states)(c, x.as_mut_ptr(), count)] };
    assert_eq!(begun, [Status::Ok; 2]);
    let (held, asked) = (bytes_held(), allocations());
    for i in 0..20_000 {
        x[i % count] += 1e-6;
        let wind = 1e-3 * (i % 7) as f64;
        // SAFETY: the component is alive, the arrays are as long as said.
        let statuses = unsafe {
            [
                (S::EXCHANGE.set_time)(c, 3e-3 * i as f64),
                (S::EXCHANGE.set_states)(c, x.as_ptr(), count),
                fmu.set_reals(&inputs, &[wind, -wind]),
                (S::EXCHANGE.rates)(c, rates.as_mut_ptr(), count),
                fmu.get_reals(&outputs, &mut values),
            ]
        };
        assert_eq!(statuses, [Status::Ok; 5], "{:?}", fmu.last_message());
    }
    assert_eq!((bytes_held(), allocations()), (held, asked));
    assert!(rates.iter().chain(&values).all(|number| number.is_finite()));
}

#[test]
fn integrating_for_a_minute_allocates_nothing() {
    twenty_thousand_evaluations_allocate_nothing::<Fmu>();
}

/// More than an hour, whose communication points a master adds up with rounding.
#[test]
fn a_million_steps_take_no_memory_and_end_where_few_steps_end() {
    let wing = Wing::new();
    let size = 0.004;
    let (mut point, held, asked) = (0.0, bytes_held(), allocations());
    for _ in 0..1_000_000 {
        assert_eq!(wing.fmu.step(point, size), Status::Ok);
        point += size;
    }
    assert_eq!((bytes_held(), allocations()), (held, asked));
    assert!(point > 3600.0 && point != 4000.0, "{point}");

    let few = Wing::new();
    for i in 0..4 {
        assert_eq!(few.fmu.step(1000.0 * f64::from(i), 1000.0), Status::Ok);
    }
    let (many, few) = (wing.plunge(), few.plunge());
    assert!(few.abs() > 1e-3 && (many - few).abs() < 1e-9 * few.abs(), "{many} {few}");
}

/// A small flexible jet, its elevator at work.
fn jet_at_work() -> Fmu {
    let fmu = Fmu::initialising();
    for (name, value) in [("mode_family", 2), ("mode_count", 2), ("inflow_states", 2)] {
        assert_eq!(fmu.set_integer(name, value), Status::Ok);
    }
    assert_eq!(fmu.set(&[("elevator", -0.02)]), Status::Ok);
    assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
    fmu
}

/// What a master with step-size control does: it tries a step, goes back, and takes another.
#[test]
fn going_back_58_times_a_second_in_steps_of_30_microseconds_changes_nothing() {
    const SIZE: f64 = 3e-5;
    const STEPS: u32 = 33_334;
    let point = |i: u32| SIZE * f64::from(i);
    let uninterrupted = jet_at_work();
    for i in 0..STEPS {
        assert_eq!(uninterrupted.step(point(i), SIZE), Status::Ok);
    }
    let fmu = jet_at_work();
    let mut returns = 0;
    for i in 0..STEPS {
        if i % (STEPS / 58) == 0 {
            let saved = Saved::of(&fmu);
            assert_eq!(fmu.step(point(i), 4.1 * SIZE), Status::Ok);
            assert_eq!(fmu.set(&[("elevator", 0.1)]), Status::Ok);
            assert_eq!(saved.restore(), Status::Ok);
            returns += 1;
        }
        assert_eq!(fmu.step(point(i), SIZE), Status::Ok);
    }
    assert!(returns >= 58);
    assert_eq!(fmu.outputs(), uninterrupted.outputs());
}

#[test]
fn steps_of_zero_change_nothing() {
    let (fmu, other) = (jet_at_work(), jet_at_work());
    for i in 0..40 {
        let point = 0.007 * f64::from(i);
        let before = other.outputs();
        assert_eq!((other.step(point, 0.0), other.step(point, 0.0)), (Status::Ok, Status::Ok));
        assert_eq!(other.outputs(), before);
        assert_eq!((fmu.step(point, 0.007), other.step(point, 0.007)), (Status::Ok, Status::Ok));
    }
    assert_eq!(fmu.outputs(), other.outputs());
}

/// Within the 1e-9 of the time that masters may be off.
#[test]
fn communication_points_with_rounding_give_the_same_flight() {
    let (exact, rounded) = (jet_at_work(), jet_at_work());
    for i in 0..300 {
        let point = 0.01 * f64::from(i);
        let error = 4e-10 * point.max(1.0) * f64::from(i % 3 - 1);
        assert_eq!(exact.step(point, 0.01), Status::Ok);
        assert_eq!(rounded.step(point + error, 0.01), Status::Ok, "{:?}", rounded.log);
    }
    for name in ["attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up"] {
        let (exact, rounded) = (exact.get(name), rounded.get(name));
        assert!((exact - rounded).abs() < 1e-8 * exact.abs(), "{name}: {exact} {rounded}");
    }
}

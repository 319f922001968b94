//! What importers really do, without surprise.

use super::*;
use crate::variables::Value;

/// The jet where `uri` says, under a name.
fn request(name: &str, uri: &str, logger: Option<CallbackLogger>) -> Fmu {
    let guid = guid(jet());
    let request = Request { name: Some(name), kind: 1, guid: Some(&guid), uri: Some(uri), logging_on: true };
    Fmu::with_logger(&request, logger)
}

/// From instantiation through a little flight.
fn flown(fmu: &Fmu) -> Vec<u64> {
    assert!(!fmu.component.is_null(), "{:?}", fmu.log);
    let statuses = [fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit(), fmu.step(0.0, 0.02)];
    assert_eq!(statuses, [Status::Ok; 4], "{:?}", fmu.log);
    fmu.outputs()
}

#[test]
fn any_name_will_do_also_a_path_one_with_spaces_and_one_used_twice() {
    let unpacked = Unpacked::new("jet");
    let uri = unpacked.uri("jet");
    let names = [
        "/models/a jet.fmu",
        "C:\\models\\jet",
        " ",
        "Flugzeug Ä %s%n",
        "same",
        "same",
        &"long".repeat(9999),
    ];
    let fmus = names.map(|name| request(name, &uri, Some(variadic_logger())));
    let flights: Vec<_> = fmus.iter().map(flown).collect();
    assert!(flights.iter().all(|flight| *flight == flights[0]));
    for (fmu, name) in fmus.iter().zip(names) {
        assert_eq!(fmu.last_message().instance, name);
    }
}

#[test]
fn resources_are_found_however_the_location_is_written() {
    let unpacked = Unpacked::new("a {0} b");
    let path = format!("{}/a {{0}} b/resources", unpacked.0.display());
    let encoded = path.replace(' ', "%20").replace('{', "%7B").replace('}', "%7d");
    let expected = flown(&Fmu::new());
    for path in [path, encoded] {
        for before in ["file://", "file:", "file:///", "file://localhost", "FILE://"] {
            for after in ["", "/", "//"] {
                let uri = format!("{before}{path}{after}");
                assert_eq!(flown(&request("jet", &uri, None)), expected, "{uri}");
            }
        }
    }
}

/// All callbacks but the logger are always NULL in these tests.
#[test]
fn without_a_logger_and_any_other_callback_it_flies_and_refuses_as_always() {
    let unpacked = Unpacked::new("jet");
    let uri = unpacked.uri("jet");
    let silent = request("jet", &uri, None);
    assert_eq!(flown(&silent), flown(&request("jet", &uri, Some(variadic_logger()))));
    assert_eq!(silent.step(7.0, 0.1), Status::Error);
    assert_eq!(silent.set(&[("elevator", f64::NAN)]), Status::Error);
    assert!(silent.log.borrow().is_empty());
    assert!(request("jet", "file:///no/such/folder", None).component.is_null());
    let (name, guid, uri) =
        (CString::new("jet").unwrap(), CString::new(guid(jet())).unwrap(), CString::new(uri).unwrap());
    let callbacks = no_callbacks();
    // SAFETY: strings and callbacks live during the call; the callbacks may all be NULL.
    let component =
        unsafe { fmi2Instantiate(name.as_ptr(), 1, guid.as_ptr(), uri.as_ptr(), &callbacks, 1, 1) };
    let fmu = Fmu { component, log: Box::default() };
    drop((name, guid, uri));
    assert_eq!(flown(&fmu), flown(&Fmu::new()));
}

/// Every variable with its start, and whether it is an output.
fn variables() -> Vec<(u32, Type, Option<Value>, bool)> {
    let table = VariableTable::new(jet());
    table.iter().map(|(r, v)| (r, v.kind, v.start, matches!(v.slot, Slot::Output(_)))).collect()
}

fn set_integers(fmu: &Fmu, references: &[u32], values: &[c_int]) -> Status {
    // SAFETY: the component is alive, the arrays are equally long.
    unsafe { fmi2SetInteger(fmu.component, references.as_ptr(), references.len(), values.as_ptr()) }
}

/// Sets every parameter and input to its start, as some importers do with everything that the XML says.
fn set_all_starts(fmu: &Fmu, at_once: bool) {
    let (mut reals, mut integers) = ((Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
    for (reference, _, start, _) in variables() {
        match start {
            Some(Value::Real(x)) => {
                reals.0.push(reference);
                reals.1.push(x);
            }
            Some(Value::Integer(i)) => {
                integers.0.push(reference);
                integers.1.push(i);
            }
            Some(Value::Boolean(flag)) => {
                // SAFETY: the component is alive, the arrays have one element.
                let set = unsafe { fmi2SetBoolean(fmu.component, &reference, 1, &c_int::from(flag)) };
                assert_eq!(set, Status::Ok);
            }
            None => {}
        }
    }
    assert!(reals.0.len() > 10 && integers.0.len() > 4);
    if at_once {
        assert_eq!(fmu.set_references(&reals.0, &reals.1), Status::Ok);
        assert_eq!(set_integers(fmu, &integers.0, &integers.1), Status::Ok);
    } else {
        for (reference, value) in reals.0.iter().zip(&reals.1) {
            assert_eq!(fmu.set_references(&[*reference], &[*value]), Status::Ok);
        }
        for (reference, value) in integers.0.iter().zip(&integers.1) {
            assert_eq!(set_integers(fmu, &[*reference], &[*value]), Status::Ok);
        }
    }
}

#[test]
fn parameters_set_three_times_over_before_and_in_initialisation_are_as_set_last() {
    let expected = {
        let fmu = Fmu::initialising();
        assert_eq!(fmu.set(&[("airspeed", 140.0)]), Status::Ok);
        assert_eq!((fmu.exit(), fmu.step(0.0, 0.02)), (Status::Ok, Status::Ok));
        fmu.outputs()
    };
    let fmu = Fmu::new();
    set_all_starts(&fmu, true);
    assert_eq!(fmu.set_up(None, 0.0, None), Status::Ok);
    set_all_starts(&fmu, false);
    assert_eq!(fmu.enter(), Status::Ok);
    for airspeed in [150.0, 130.0, 140.0] {
        set_all_starts(&fmu, airspeed != 130.0);
        assert_eq!(fmu.set(&[("airspeed", airspeed)]), Status::Ok);
        assert!((fmu.get("air.speed") - airspeed).abs() < 1e-9);
    }
    assert_eq!((fmu.exit(), fmu.step(0.0, 0.02)), (Status::Ok, Status::Ok));
    assert_eq!(fmu.outputs(), expected);
}

/// As GEMSEO-FMU does; other values are still refused.
#[test]
fn parameters_may_be_written_again_with_the_same_values_before_every_step() {
    let flight = |writes_again: bool| {
        let fmu = Fmu::initialising();
        assert_eq!(fmu.set(&[("airspeed", 140.0)]), Status::Ok);
        assert_eq!(fmu.exit(), Status::Ok);
        for step in 0..5 {
            if writes_again {
                assert_eq!(fmu.set(&[("airspeed", 140.0), ("elevator", 0.01)]), Status::Ok);
                assert_eq!(fmu.set_integer("mode_count", 12), Status::Ok);
            } else {
                assert_eq!(fmu.set(&[("elevator", 0.01)]), Status::Ok);
            }
            assert_eq!(fmu.step(0.01 * f64::from(step), 0.01), Status::Ok);
        }
        fmu
    };
    let fmu = flight(true);
    assert_eq!(fmu.outputs(), flight(false).outputs());
    assert_eq!(fmu.set(&[("elevator", 0.0), ("airspeed", 140.1)]), Status::Error);
    fmu.assert_refused(&["`airspeed`", "fixed"]);
    // The tolerance, as it was set and as it reads under the tighter one of the experiment.
    let fmu = Fmu::new();
    assert_eq!([fmu.set_up(Some(1e-7), 0.0, None), fmu.enter(), fmu.exit()], [Status::Ok; 3]);
    assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
    for tolerance in [fmu.get("tolerance"), 1e-5] {
        assert_eq!(fmu.set(&[("tolerance", tolerance)]), Status::Ok);
    }
    assert_eq!(fmu.get("tolerance"), 1e-7);
    assert_eq!((fmu.set(&[("tolerance", 1e-6)]), fmu.step(0.01, 0.01)), (Status::Error, Status::Ok));
}

/// The same values, whether asked for once or twice, one by one or together, before or after.
#[test]
fn every_variable_can_be_read_twice_before_initialisation_ends_and_one_by_one() {
    let fmu = Fmu::initialising();
    let (integers, reals): (Vec<_>, Vec<_>) =
        variables().into_iter().partition(|(_, kind, ..)| *kind != Type::Real);
    let reals: Vec<u32> = reals.into_iter().map(|(reference, ..)| reference).collect();
    let one_by_one = |fmu: &Fmu| -> Vec<f64> {
        reals.iter().map(|reference| fmu.get_references(&[*reference]).unwrap()[0]).collect()
    };
    let first = one_by_one(&fmu);
    assert_eq!(one_by_one(&fmu), first);
    assert_eq!(fmu.get_references(&reals).unwrap(), first);
    for (reference, kind, start, is_output) in &integers {
        for _ in 0..2 {
            if *kind == Type::Boolean {
                let flag = fmu.get_booleans(&[*reference]).unwrap()[0];
                assert!(flag == 0 && (*is_output || *start == Some(Value::Boolean(false))));
                continue;
            }
            let mut value = 0;
            // SAFETY: the component is alive, the arrays have one element.
            assert_eq!(unsafe { fmi2GetInteger(fmu.component, reference, 1, &mut value) }, Status::Ok);
            assert_eq!(Some(Value::Integer(value)), *start);
        }
    }
    assert_eq!(fmu.exit(), Status::Ok);
    assert_eq!(one_by_one(&fmu), first);
    assert_eq!(fmu.get_references(&reals).unwrap(), first);
    assert_eq!(fmu.step(0.0, 0.02), Status::Ok);
    let unread = Fmu::flying();
    assert_eq!(unread.step(0.0, 0.02), Status::Ok);
    assert_eq!(fmu.outputs(), unread.outputs());
}

/// `fmi2SetupExperiment` of a master that knows no end, and one that never calls it.
#[test]
fn without_a_stop_time_and_without_an_experiment_it_flies_on() {
    let (without_stop, without_experiment) = (Fmu::flying(), Fmu::new());
    assert_eq!((without_experiment.enter(), without_experiment.exit()), (Status::Ok, Status::Ok));
    for fmu in [&without_stop, &without_experiment] {
        for i in 0..20 {
            assert_eq!(fmu.step(f64::from(i), 1.0), Status::Ok);
        }
    }
    assert_eq!(without_stop.outputs(), without_experiment.outputs());
}

//! Time and tolerance of an experiment.

use super::surface::Saved;
use super::*;

/// Set up as said, at its first communication point.
fn flying(tolerance: Option<f64>, start: f64, parameter: Option<f64>) -> Fmu {
    let fmu = Fmu::new();
    if let Some(tolerance) = parameter {
        assert_eq!(fmu.set(&[("tolerance", tolerance)]), Status::Ok);
    }
    assert_eq!((fmu.set_up(tolerance, start, None), fmu.enter()), (Status::Ok, Status::Ok));
    assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
    fmu
}

/// An elevator doublet and a rudder, both ramped, set every 10 ms; the outputs then and at the end.
fn manoeuvre(fmu: &Fmu, start: f64, point: impl Fn(u32) -> f64) -> Vec<Vec<u64>> {
    let flown = (0..60).map(|i| {
        let angle = if (10..30).contains(&i) { -0.05 } else { 0.02 };
        assert_eq!(fmu.set(&[("elevator", angle), ("wind_down", 0.05 * f64::from(i))]), Status::Ok);
        assert_eq!(fmu.set_rates(&[("elevator", 1, 0.3), ("rudder", 1, 0.01)]), Status::Ok);
        let (from, to) = (start + point(i), start + point(i + 1));
        assert_eq!(fmu.step(from, to - from), Status::Ok, "{:?}", fmu.log);
        let inputs = fmu.get_references(&["elevator", "rudder"].map(reference)).unwrap();
        [fmu.outputs(), inputs.into_iter().map(f64::to_bits).collect()].concat()
    });
    flown.collect()
}

#[test]
fn a_flight_from_calendar_time_has_the_bits_of_one_from_zero() {
    let steps = |i: u32| 0.01 * f64::from(i);
    let expected = manoeuvre(&flying(None, 0.0, None), 0.0, steps);
    for start in [1.7e9, 1.7e9 + 0.123, -86_400.5, 6.4e10, 0.005] {
        let flown = manoeuvre(&flying(None, start, None), start, steps);
        let differing = flown.iter().zip(&expected).position(|(flown, expected)| flown != expected);
        assert_eq!(differing, None, "from {start}");
    }
}

/// Masters that add up the size lose a part of it at every point; a size of 10 ms still has the same bits.
#[test]
fn steps_that_are_added_up_from_calendar_time_fly_like_those_from_zero() {
    for (size, count) in [(0.01, 60), (0.001, 35)] {
        let start = 1.7e9;
        let ([fmu, zero], mut point) = ([start, 0.0].map(|start| flying(None, start, None)), start);
        for i in 0..count {
            for fmu in [&fmu, &zero] {
                assert_eq!(fmu.set(&[("elevator", if i % 20 < 13 { 0.02 } else { 0.0 })]), Status::Ok);
            }
            let statuses = [fmu.step(point, size), zero.step(size * f64::from(i), size)];
            assert_eq!(statuses, [Status::Ok; 2], "{:?}", fmu.log);
            point += size;
            let close = |name: &str| (fmu.get(name) - zero.get(name)).abs() < 1e-5 * zero.get(name).abs();
            assert!(close("load_factor.z") && close("attitude.pitch"), "{size} {i}");
            assert!(size < 0.01 || fmu.outputs() == zero.outputs(), "{size} {i}");
        }
    }
}

#[test]
fn gaps_between_communication_points_are_noticed_at_calendar_time_too() {
    let start = 1.7e9;
    let fmu = flying(None, start, None);
    assert_eq!(fmu.step(start, 0.01), Status::Ok);
    assert_eq!(fmu.step(start + 0.02, 0.01), Status::Error);
    fmu.assert_refused(&["communication point: found 1700000000.02"]);
    assert_eq!(fmu.step(start + 0.01 + 5e-7, 0.01), Status::Ok);
    let mut time = 0.0;
    // SAFETY: the component is alive, the place is there.
    assert_eq!(unsafe { fmi2GetRealStatus(fmu.component, 2, &mut time) }, Status::Ok);
    assert!((time - (start + 0.02)).abs() < 1e-6, "{time}");
}

#[test]
fn the_tighter_of_two_tolerances_counts_and_is_what_the_variable_reads() {
    let fly = |fmu: &Fmu| manoeuvre(fmu, 0.0, |i| 0.01 * f64::from(i));
    let tight = fly(&flying(None, 0.0, Some(1e-9)));
    assert!(tight != fly(&flying(None, 0.0, None)));
    for (experiment, parameter) in [(1e-5, 1e-9), (1e-9, 1e-5), (1e-9, 1e-9), (0.5, 1e-9)] {
        let fmu = Fmu::new();
        assert_eq!(fmu.set_up(Some(experiment), 0.0, None), Status::Ok);
        assert_eq!((fmu.set(&[("tolerance", parameter)]), fmu.enter()), (Status::Ok, Status::Ok));
        assert_eq!(fmu.get("tolerance"), parameter);
        assert_eq!((fmu.exit(), fmu.get("tolerance")), (Status::Ok, 1e-9));
        let saved = Saved::of(&fmu);
        assert!(fly(&fmu) == tight, "{experiment:e} {parameter:e}");
        let other = Fmu::new();
        assert_eq!(Saved::from_bytes(&other, &saved.bytes()).unwrap().restore(), Status::Ok);
        assert!(other.get("tolerance") == 1e-9 && fly(&other) == tight, "{experiment:e} {parameter:e}");
    }
}

/// A saved state has both: the parameter can still become the looser one.
#[test]
fn a_state_before_the_flight_keeps_both_tolerances() {
    let fmu = Fmu::new();
    assert_eq!((fmu.set_up(Some(1e-6), 0.0, None), fmu.enter()), (Status::Ok, Status::Ok));
    assert_eq!(fmu.set(&[("tolerance", 1e-9)]), Status::Ok);
    let other = Fmu::new();
    assert_eq!(Saved::from_bytes(&other, &Saved::of(&fmu).bytes()).unwrap().restore(), Status::Ok);
    assert_eq!(other.get("tolerance"), 1e-9);
    assert_eq!((other.set(&[("tolerance", 1e-4)]), other.exit()), (Status::Ok, Status::Ok));
    assert_eq!(other.get("tolerance"), 1e-6);
}

#[test]
fn no_tolerance_asks_for_more_than_doubles_carry() {
    assert_eq!(flying(Some(1e-18), 0.0, None).get("tolerance"), 1e-12);
}

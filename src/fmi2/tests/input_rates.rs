//! Inputs that change between communication points: derivatives of inputs, and the rate of the wind as an input.

use std::f64::consts::PI;

use super::surface::Saved;
use super::*;

#[test]
fn an_input_with_a_derivative_ramps_until_it_is_set() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set_rates(&[("elevator", 1, 0.5)]), Status::Ok);
    for point in [0.0, 0.1] {
        assert_eq!(fmu.step(point, 0.1), Status::Ok);
    }
    assert!((fmu.get("elevator") - 0.1).abs() < 1e-12);
    assert!((fmu.get("surface.elevator") - fmu.get("trim.elevator") - 0.1).abs() < 1e-12);
    assert_eq!(fmu.set(&[("elevator", 0.0)]), Status::Ok);
    assert_eq!(fmu.step(0.2, 0.1), Status::Ok);
    assert_eq!(fmu.get("elevator"), 0.0);
}

#[test]
fn a_derivative_acts_whether_it_is_set_before_or_after_its_value() {
    let flight = |rate_first: bool| {
        let fmu = Fmu::initialising();
        for i in 0..20 {
            let angle = 1e-3 * f64::from(i);
            let rate = |fmu: &Fmu| assert_eq!(fmu.set_rates(&[("elevator", 1, 0.1 - angle)]), Status::Ok);
            if rate_first {
                rate(&fmu);
            }
            // What other inputs do is no matter, nor is a step of no size.
            assert_eq!(fmu.set(&[("elevator", angle), ("rudder", angle)]), Status::Ok);
            if !rate_first {
                rate(&fmu);
            }
            if i == 0 {
                assert_eq!(fmu.exit(), Status::Ok);
            }
            let point = 0.01 * f64::from(i);
            assert_eq!((fmu.step(point, 0.0), fmu.step(point, 0.01)), (Status::Ok, Status::Ok));
            let ramped = angle + 0.01 * (0.1 - angle);
            assert!((fmu.get("elevator") - ramped).abs() < 1e-15, "{i}");
        }
        fmu.outputs()
    };
    assert_eq!(flight(true), flight(false));
}

/// At the end of every cell of time: the slope found there in flight is the one that is found there anew.
#[test]
fn under_a_rate_a_flight_goes_on_with_its_bits_after_a_saved_state_a_derivative_or_a_refused_step() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set_rates(&[("aileron", 1, 0.07)]), Status::Ok);
    assert_eq!(fmu.set(&[("wind_rate_east", -1.3)]), Status::Ok);
    let mut states = Vec::new();
    for i in 0..30 {
        states.push(Saved::of(&fmu));
        assert_eq!(fmu.step(0.01 * f64::from(i), 0.01), Status::Ok);
    }
    let expected = fmu.outputs();
    let go_on = |fmu: &Fmu, from: u32| {
        (from..30).for_each(|i| assert_eq!(fmu.step(0.01 * f64::from(i), 0.01), Status::Ok));
        fmu.outputs()
    };
    for (i, state) in (0..).zip(&states) {
        assert_eq!(state.restore(), Status::Ok);
        assert_eq!(go_on(&fmu, i), expected, "restored after {i} steps");
        assert_eq!(state.restore(), Status::Ok);
        assert_eq!(fmu.step(0.01 * f64::from(i), 4000.0), Status::Error);
        assert_eq!(go_on(&fmu, i), expected, "refused after {i} steps");
        assert_eq!(state.restore(), Status::Ok);
        let [outputs, inputs] = [["load_factor.z"], ["elevator"]]
            .map(|[name]| vec![VariableTable::new(jet()).reference(name).unwrap()]);
        fmu.derivatives(&outputs, &inputs, &[1.0]).unwrap();
        assert_eq!(go_on(&fmu, i), expected, "asked for a derivative after {i} steps");
    }
}

#[test]
fn whether_a_derivative_was_set_at_this_point_is_part_of_the_state() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.step(0.0, 0.01), Status::Ok);
    assert_eq!(fmu.set_rates(&[("elevator", 1, 0.1)]), Status::Ok);
    let saved = Saved::of(&fmu);
    let go_on = |fmu: &Fmu| {
        assert_eq!((fmu.set(&[("elevator", 0.01)]), fmu.step(0.01, 0.01)), (Status::Ok, Status::Ok));
        fmu.outputs()
    };
    let expected = go_on(&fmu);
    assert!((fmu.get("elevator") - 0.011).abs() < 1e-15);
    let other = Fmu::new();
    let carried = Saved::from_bytes(&other, &saved.bytes()).unwrap();
    for (fmu, saved) in [(&fmu, &saved), (&other, &carried)] {
        assert_eq!(saved.restore(), Status::Ok);
        assert_eq!(go_on(fmu), expected);
    }
}

#[test]
fn derivatives_of_higher_order_are_left_out_with_a_warning_and_the_others_act() {
    let fmu = Fmu::flying();
    let rates = [("rudder", 2, 7.0), ("elevator", 1, 0.5), ("elevator", 3, 9.0)];
    assert_eq!(fmu.set_rates(&rates), Status::Warning);
    for (message, parts) in fmu.log.borrow().iter().zip([["`rudder`", "order 2"], ["`elevator`", "order 3"]])
    {
        assert_eq!((message.status, message.category.as_str()), (Status::Warning, "logStatusWarning"));
        assert!(parts.iter().all(|part| message.format.contains(part)), "{message:?}");
    }
    assert_eq!(fmu.log.borrow().len(), 2);
    let plain = Fmu::flying();
    assert_eq!(plain.set_rates(&[("elevator", 1, 0.5)]), Status::Ok);
    for fmu in [&fmu, &plain] {
        assert_eq!(fmu.step(0.0, 0.1), Status::Ok);
    }
    assert_eq!((fmu.get("rudder"), fmu.get("elevator")), (0.0, 0.05));
    assert_eq!(fmu.outputs(), plain.outputs());
}

/// A gust 1 − cos of 5 m/s and its rate.
fn gust(time: f64) -> (f64, f64) {
    let duration = 0.2;
    let angle = 2.0 * PI * (time / duration).clamp(0.0, 1.0);
    (-2.5 * (1.0 - angle.cos()), -5.0 * PI / duration * angle.sin())
}

/// Load factors through the gust, and all outputs at its end; `set` sets what stands for wind and rate.
fn through_the_gust(fmu: &Fmu, size: f64, set: impl Fn(&Fmu, f64, f64)) -> (Vec<f64>, Vec<u64>) {
    let steps = (0.3 / size).round() as u32;
    let load_factors = (0..steps).map(|i| {
        let point = f64::from(i) * size;
        let (wind, rate) = gust(point);
        set(fmu, wind, rate);
        let load_factor = fmu.get("load_factor.z");
        assert_eq!(fmu.step(point, size), Status::Ok, "{:?}", fmu.log);
        load_factor
    });
    (load_factors.collect(), fmu.outputs())
}

fn with_derivative(fmu: &Fmu, wind: f64, rate: f64) {
    assert_eq!(fmu.set(&[("wind_down", wind)]), Status::Ok);
    assert_eq!(fmu.set_rates(&[("wind_down", 1, rate)]), Status::Ok);
}

fn with_wind_rate(fmu: &Fmu, wind: f64, rate: f64) {
    assert_eq!(fmu.set(&[("wind_rate_down", rate), ("wind_down", wind)]), Status::Ok);
}

#[test]
fn a_gust_by_its_rate_as_an_input_has_the_bits_of_one_by_the_derivative() {
    let by_derivative = through_the_gust(&Fmu::flying(), 0.005, with_derivative);
    let fmu = Fmu::flying();
    assert!(through_the_gust(&fmu, 0.005, with_wind_rate) == by_derivative);

    // Half by each, restored in between into another instance.
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&[("wind_rate_down", -3.0), ("wind_rate_east", 1.0)]), Status::Ok);
    assert_eq!(fmu.set_rates(&[("wind_down", 1, -4.0), ("wind_rate_down", 1, 2.0)]), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.103), Status::Ok);
    let other = Fmu::new();
    assert_eq!(Saved::from_bytes(&other, &Saved::of(&fmu).bytes()).unwrap().restore(), Status::Ok);
    for fmu in [&fmu, &other] {
        assert_eq!(fmu.step(0.103, 0.097), Status::Ok);
        // W = (−3 − 4) t + ½ 2 t², and its rate.
        assert!((fmu.get("wind_down") - (-7.0 * 0.2 + 0.2 * 0.2)).abs() < 1e-14);
        assert!((fmu.get("wind_rate_down") - (-3.0 + 2.0 * 0.2)).abs() < 1e-14);
        assert!((fmu.get("wind_east") - 0.2).abs() < 1e-14);
    }
    assert_eq!(fmu.outputs(), other.outputs());
}

/// Measured, peak change of the jet's load factor against steps of 0.5 ms with the rate: 18 % off without it in
/// the same steps, 1.4 % with it in steps of 5 ms.
#[test]
fn a_gust_without_its_rate_is_a_fifth_wrong_in_load_factor_and_with_it_right() {
    let peak = |size, set: fn(&Fmu, f64, f64)| {
        let (load_factors, _) = through_the_gust(&Fmu::flying(), size, set);
        load_factors.into_iter().fold(0.0_f64, |peak, n| peak.max((n - 1.0).abs()))
    };
    let without = |fmu: &Fmu, wind: f64, _: f64| assert_eq!(fmu.set(&[("wind_down", wind)]), Status::Ok);
    let exact = peak(0.0005, with_wind_rate);
    let errors = [peak(0.005, with_wind_rate), peak(0.0005, without)].map(|peak| (peak / exact - 1.0).abs());
    println!("{exact} {errors:?}");
    assert!(errors[0] < 0.02 && errors[1] > 0.1, "{errors:?}");
}

#[test]
fn setting_the_rate_of_the_wind_alone_lets_it_go_on_from_where_it_is() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&[("wind_down", -1.0), ("wind_rate_down", -10.0)]), Status::Ok);
    assert_eq!(fmu.step(0.0, 0.1), Status::Ok);
    let acting = |fmu: &Fmu| fmu.get("air.alpha");
    let before = acting(&fmu);
    assert!((fmu.get("wind_down") + 2.0).abs() < 1e-14);
    assert_eq!(fmu.set(&[("wind_rate_down", 5.0)]), Status::Ok);
    assert!((acting(&fmu) - before).abs() < 1e-15, "{} {before}", acting(&fmu));
    assert_eq!(fmu.step(0.1, 0.1), Status::Ok);
    assert!((fmu.get("wind_down") + 1.5).abs() < 1e-14);
    // The rate stays when the wind is set, and goes on from there.
    assert_eq!(fmu.set(&[("wind_down", 0.0)]), Status::Ok);
    assert_eq!(fmu.step(0.2, 0.1), Status::Ok);
    assert!((fmu.get("wind_down") - 0.5).abs() < 1e-14);
}

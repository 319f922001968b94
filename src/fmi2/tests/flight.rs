use super::endurance::{typical_section, wing};
use super::*;
use crate::structure::ReducedModel;

fn fly(fmu: &Fmu, steps: u32, size: f64) {
    for i in 0..steps {
        assert_eq!(fmu.step(size * f64::from(i), size), Status::Ok, "{:?}", fmu.log);
    }
}

#[test]
fn outputs_can_be_read_before_initialisation_ends_and_follow_the_parameters() {
    let fmu = Fmu::initialising();
    let slow = fmu.get("trim.pitch");
    assert!((fmu.get("attitude.pitch") - slow).abs() < 1e-12);
    assert_eq!(fmu.set(&[("airspeed", 160.0)]), Status::Ok);
    let fast = fmu.get("trim.pitch");
    assert!(fast < slow, "{fast} {slow}");
    assert_eq!(fmu.exit(), Status::Ok);
    assert_eq!(fmu.get("trim.pitch"), fast);
    assert!((fmu.get("air.speed") - 160.0).abs() < 1e-9);
}

/// At 55 m/s the jet's trim needs an elevator that turns past its fuselage.
#[test]
fn a_trim_that_nobody_could_fly_stands_with_a_warning_that_names_quantity_value_and_limit() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("airspeed", 55.0)]), Status::Ok);
    let elevator = fmu.get("trim.elevator");
    assert_eq!(fmu.exit(), Status::Warning);
    let message = fmu.last_message();
    assert_eq!((message.status, message.category.as_str()), (Status::Warning, "logStatusWarning"));
    let named = format!("elevator {elevator:.4} rad ({:.1}°)", elevator.to_degrees());
    for part in ["the trim at 55 m/s and 7620 m", &named, "below -0.5236 rad (-30.0°), the usual limit"] {
        assert!(message.format.contains(part), "`{part}` is missing in: {}", message.format);
    }
    assert!(elevator < -30_f64.to_radians(), "{elevator}");
    fly(&fmu, 10, 0.01);
    // Within the limits nothing is said, after a reset too.
    assert_eq!((fmu.reset(), fmu.set_up(None, 0.0, None)), (Status::Ok, Status::Ok));
    assert_eq!((fmu.enter(), fmu.exit()), (Status::Ok, Status::Ok));
}

#[test]
fn without_inputs_the_flight_stays_level() {
    let fmu = Fmu::flying();
    fly(&fmu, 100, 0.01);
    assert!((fmu.get("attitude.pitch") - fmu.get("trim.pitch")).abs() < 1e-6);
    assert!((fmu.get("position.north") - 127.0).abs() < 1e-3);
    assert!((fmu.get("load_factor.z") - 1.0).abs() < 0.05);
}

#[test]
fn gaps_between_communication_points_are_refused_with_both_values_and_rounding_is_absorbed() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.step(0.0, 0.1), Status::Ok);
    assert_eq!(fmu.step(0.2, 0.1), Status::Error);
    fmu.assert_refused(&["found 0.2", "expected 0.1"]);
    assert_eq!(fmu.step(0.1 + 5e-11, 0.1), Status::Ok);
    assert_eq!(fmu.step(0.2, 0.0), Status::Ok);
    for size in [-0.1, f64::NAN, f64::INFINITY] {
        assert_eq!(fmu.step(0.2, size), Status::Error);
        fmu.assert_refused(&["step size"]);
    }
    assert_eq!(fmu.step(f64::NAN, 0.1), Status::Error);
    assert_eq!(fmu.step(0.2, 0.1), Status::Ok);
}

#[test]
fn no_step_passes_a_defined_stop_time() {
    let fmu = Fmu::new();
    assert_eq!(fmu.set_up(None, 1.0, Some(1.2)), Status::Ok);
    assert_eq!((fmu.enter(), fmu.exit()), (Status::Ok, Status::Ok));
    assert_eq!(fmu.step(1.0, 0.1), Status::Ok);
    assert_eq!(fmu.step(1.1, 0.2), Status::Error);
    fmu.assert_refused(&["1.2"]);
    assert_eq!(fmu.step(1.1, 0.1), Status::Ok);
}

#[test]
fn reset_and_the_same_calls_give_the_same_bits() {
    let fmu = Fmu::flying();
    let run = || {
        assert_eq!(fmu.set(&[("elevator", 0.02), ("wind_down", -1.0)]), Status::Ok);
        fly(&fmu, 20, 0.01);
        fmu.outputs()
    };
    let first = run();
    assert_eq!(fmu.reset(), Status::Ok);
    assert_eq!((fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()), (Status::Ok, Status::Ok, Status::Ok));
    assert_eq!(run(), first);
}

#[test]
fn instances_in_threads_fly_like_a_lone_one() {
    let run = || {
        let fmu = Fmu::flying();
        assert_eq!(fmu.set(&[("aileron", 0.02)]), Status::Ok);
        fly(&fmu, 10, 0.01);
        fmu.outputs()
    };
    let alone = run();
    let threads: Vec<_> = (0..2).map(|_| std::thread::spawn(run)).collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap(), alone);
    }
}

#[test]
fn an_input_that_would_ramp_beyond_all_numbers_is_refused() {
    let model = ReducedModel { controls: jet().controls.clone(), ..typical_section() };
    let fmu = wing(&Unpacked::of(&model.to_bytes(), "wing"), &guid(&model));
    assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()], [Status::Ok; 3]);
    let rudder = VariableTable::new(&model).reference("rudder").unwrap();
    // SAFETY: the component is alive, the arrays have one element.
    let status = unsafe { fmi2SetRealInputDerivatives(fmu.component, &rudder, 1, &1, &f64::MAX) };
    assert_eq!(status, Status::Ok);
    assert_eq!(fmu.step(0.0, 2.0), Status::Error);
    fmu.assert_refused(&["from t = 0 s to 2 s", "no longer finite"]);
    assert_eq!(fmu.get_references(&[rudder]), Ok(vec![0.0]));
    assert_eq!(fmu.step(0.0, 0.5), Status::Ok);
    assert_eq!(fmu.get_references(&[rudder]), Ok(vec![0.5 * f64::MAX]));
    // The wind by its rate too.
    let wind_rate = VariableTable::new(&model).reference("wind_rate_down").unwrap();
    assert_eq!(fmu.set_references(&[rudder, wind_rate], &[0.0, 1e308]), Status::Ok);
    assert_eq!(fmu.step(0.5, 10.0), Status::Error);
    fmu.assert_refused(&["from t = 0.5 s to 10.5 s", "no longer finite"]);
}

#[test]
fn parameters_are_fixed_once_the_flight_has_begun() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.set(&[("airspeed", 150.0)]), Status::Error);
    fmu.assert_refused(&["`airspeed`", "fixed"]);
    assert_eq!(fmu.set_integer("model", 5), Status::Error);
}

#[test]
fn a_trim_that_does_not_exist_is_refused_and_other_parameters_can_be_tried() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("airspeed", 1.0)]), Status::Ok);
    assert_eq!(fmu.exit(), Status::Error);
    fmu.assert_refused(&["fmi2ExitInitializationMode"]);
    assert_eq!(fmu.set(&[("airspeed", 127.0)]), Status::Ok);
    assert_eq!(fmu.exit(), Status::Ok);
}

#[test]
fn the_status_of_a_slave_that_never_waits_is_its_time() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.step(0.0, 0.25), Status::Ok);
    let (mut time, mut terminated) = (0.0, 7);
    // SAFETY: the component is alive, the places are there.
    unsafe {
        assert_eq!(fmi2GetRealStatus(fmu.component, 2, &mut time), Status::Ok);
        assert_eq!(fmi2GetBooleanStatus(fmu.component, 3, &mut terminated), Status::Ok);
        assert_eq!(fmi2GetRealStatus(fmu.component, 0, &mut time), Status::Discard);
        assert_eq!(fmi2GetStatus(fmu.component, 0, null_mut()), Status::Discard);
        assert_eq!(fmi2GetIntegerStatus(fmu.component, 0, null_mut()), Status::Discard);
        assert_eq!(fmi2GetStringStatus(fmu.component, 1, null_mut()), Status::Discard);
        assert_eq!(fmi2CancelStep(fmu.component), Status::Error);
    }
    assert_eq!((time, terminated), (0.25, 0));
}

#[test]
fn after_termination_outputs_can_still_be_read() {
    let fmu = Fmu::flying();
    assert_eq!(fmu.terminate(), Status::Ok);
    assert!(fmu.get("air.speed") > 100.0);
    assert_eq!(fmu.step(0.0, 0.1), Status::Error);
}

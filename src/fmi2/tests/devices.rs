//! Actuators, engines that lag and sampled sensors: parameters, Booleans, derivatives, saved states.

use super::surface::Saved;
use super::*;

/// In initialisation mode, with an actuator on the elevator, an engine that lags, and sampled sensors.
fn equipped() -> Fmu {
    let fmu = Fmu::initialising();
    let parameters = [
        ("actuator.elevator.frequency", 40.0),
        ("actuator.elevator.rate_limit", 0.7),
        ("actuator.elevator.maximum", 0.05),
        ("engine.left.time_constant", 0.5),
        ("sensor.period", 0.02),
        ("sensor.noise.rate", 1e-3),
    ];
    assert_eq!(fmu.set(&parameters), Status::Ok, "{:?}", fmu.log);
    assert_eq!([fmu.set_boolean("sensor.enabled", 1), fmu.set_integer("sensor.delay", 2)], [Status::Ok; 2]);
    fmu
}

#[test]
fn what_lags_or_is_sampled_does_not_depend_on_inputs_at_once_and_the_rest_does() {
    for fmu in [equipped(), {
        let fmu = equipped();
        assert_eq!([fmu.exit(), fmu.step(0.0, 0.35)], [Status::Ok; 2]);
        fmu
    }] {
        let accelerations = ["acceleration.x", "acceleration.z", "load_factor.z"];
        assert_eq!(fmu.by("elevator", &["surface.elevator", "actuator.elevator.rate"]), [0.0; 2]);
        assert_eq!(fmu.by("elevator", &accelerations), [0.0; 3]);
        assert_eq!(fmu.by("thrust_left", &["engine.left.thrust", "acceleration.x"]), [0.0; 2]);
        assert_eq!(fmu.by("wind_down", &["sensor.load_factor.z", "sensor.air.alpha"]), [0.0; 2]);
        let direct =
            [fmu.by("rudder", &["surface.rudder"])[0], fmu.by("thrust_right", &["engine.right.thrust"])[0]];
        assert!(direct.iter().all(|derivative| (derivative - 1.0).abs() < 1e-12), "{direct:?}");
        assert!(fmu.by("wind_down", &["load_factor.z"])[0] < -1e-3);
    }
}

#[test]
fn sensors_that_are_off_have_the_derivatives_of_what_they_mirror() {
    let fmu = Fmu::flying();
    let found = fmu.by("wind_down", &["sensor.load_factor.z", "load_factor.z"]);
    assert!(found[0] == found[1] && found[0] != 0.0, "{found:?}");
}

#[test]
fn where_a_limit_holds_outputs_follow_the_limit_and_not_the_command() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("actuator.elevator.maximum", 0.05), ("elevator", 0.4)]), Status::Ok);
    assert_eq!(fmu.set(&[("engine.left.maximum", 3e4), ("thrust_left", 5e4)]), Status::Ok);
    assert_eq!((fmu.get("surface.elevator"), fmu.get("engine.left.thrust")), (0.05, 3e4));
    assert_eq!(fmu.get_boolean("actuator.elevator.position_limited"), 1);
    assert_eq!(fmu.by("elevator", &["surface.elevator", "acceleration.z"]), [0.0; 2]);
    let by_the_limit = fmu.by("actuator.elevator.maximum", &["surface.elevator"])[0];
    let of_thrust = fmu.by("engine.left.maximum", &["engine.left.thrust"])[0];
    assert!(
        (by_the_limit - 1.0).abs() < 1e-9 && (of_thrust - 1.0).abs() < 1e-9,
        "{by_the_limit} {of_thrust}"
    );
    assert!(fmu.by("actuator.elevator.maximum", &["acceleration.z"])[0].abs() > 0.1);
}

#[test]
fn at_the_initialisation_outputs_of_sensors_follow_the_trim_and_the_rms_of_their_noise() {
    let fmu = equipped();
    let found = fmu.by("airspeed", &["sensor.air.speed", "sensor.attitude.pitch", "attitude.pitch"]);
    assert!((found[0] - 1.0).abs() < 1e-9 && found[1] == found[2], "{found:?}");
    // Noise number 0 of this channel.
    let by_rms = fmu.by("sensor.noise.rate", &["sensor.rate.y"])[0];
    assert!((by_rms - 1.768_671_3).abs() < 1e-7, "{by_rms}");
}

#[test]
fn booleans_of_actuators_are_read_in_flight_and_are_no_reals() {
    let fmu = equipped();
    assert_eq!((fmu.set(&[("elevator", 0.3)]), fmu.exit()), (Status::Ok, Status::Ok));
    let held = |fmu: &Fmu| {
        ["rate_limited", "position_limited"].map(|what| fmu.get_boolean(&format!("actuator.elevator.{what}")))
    };
    assert_eq!(held(&fmu), [0, 0]);
    assert_eq!((fmu.step(0.0, 0.05), held(&fmu)), (Status::Ok, [1, 0]));
    assert!((fmu.get("actuator.elevator.rate") - 0.7).abs() < 1e-15);
    assert_eq!((fmu.step(0.05, 0.5), held(&fmu)), (Status::Ok, [0, 1]));
    assert_eq!((fmu.get("surface.elevator"), fmu.get("actuator.elevator.rate")), (0.05, 0.0));
    let limited = reference("actuator.elevator.rate_limited");
    assert_eq!(fmu.get_references(&[limited]), Err(Status::Error));
    fmu.assert_refused(&["`actuator.elevator.rate_limited` is a Boolean, not a Real"]);
    assert_eq!(fmu.set_boolean("actuator.elevator.rate_limited", 1), Status::Error);
    fmu.assert_refused(&["`actuator.elevator.rate_limited` is an output"]);
}

#[test]
fn numbers_that_no_device_has_and_trims_that_none_can_hold_are_refused_by_name() {
    let fmu = Fmu::initialising();
    for (name, value, allowed) in [
        ("actuator.elevator.frequency", -1.0, "0 or 0.001 to 1000 rad/s"),
        ("actuator.elevator.frequency", 1e-300, "0 or 0.001 to 1000 rad/s"),
        ("actuator.rudder.rate_limit", 0.0, "0.000001 to 1000000000 rad/s"),
        ("engine.left.time_constant", -0.1, "0 to 10000 s"),
        ("sensor.noise.air_speed", -1.0, "0 to 1000000 m/s"),
    ] {
        assert_eq!(fmu.set(&[(name, value)]), Status::Error);
        fmu.assert_refused(&[&format!("`{name}`"), &format!("found {value}"), allowed]);
    }
    // Together they are wrong.
    assert_eq!(fmu.set_boolean("sensor.enabled", 1), Status::Ok);
    assert_eq!((fmu.set(&[("sensor.period", 0.025)]), fmu.exit()), (Status::Ok, Status::Error));
    fmu.assert_refused(&["sensor.period: found 0.025", "a multiple of 0.01"]);
    let limit = ("actuator.elevator.minimum", 0.2);
    assert_eq!((fmu.set(&[("sensor.period", 0.03), limit]), fmu.exit()), (Status::Ok, Status::Error));
    fmu.assert_refused(&["the trim needs actuator elevator at ", "`actuator.elevator.minimum` is 0.2 rad"]);
    assert_eq!((fmu.set(&[("actuator.elevator.minimum", -0.5)]), fmu.exit()), (Status::Ok, Status::Ok));
}

#[test]
fn a_saved_state_has_devices_and_their_parameters_and_flies_on_with_the_same_bits() {
    let (fmu, other) = (equipped(), Fmu::flying());
    assert_eq!((fmu.set(&[("elevator", -0.3)]), fmu.exit()), (Status::Ok, Status::Ok));
    assert_eq!(fmu.step(0.0, 0.053), Status::Ok);
    let bytes = Saved::of(&fmu).bytes();
    let saved = Saved::from_bytes(&other, &bytes).unwrap();
    assert_eq!(saved.restore(), Status::Ok, "{:?}", other.log);
    assert_eq!(other.get("actuator.elevator.frequency"), 40.0);
    for fmu in [&fmu, &other] {
        assert_eq!(fmu.step(0.053, 0.2), Status::Ok);
    }
    assert_eq!(fmu.outputs(), other.outputs());
}

//! Types of variables, and how many values there are.

use super::*;

#[test]
fn each_type_has_its_functions_and_others_are_refused_by_name() {
    let fmu = Fmu::new(Kind::CoSimulation);
    let i = fmu.instance;
    let [count, model, flag, speed] =
        ["mode_count", "model", "sensor.enabled", "airspeed"].map(|name| fmu.reference(name));
    let (mut integer, mut item, mut boolean) = (0, 0_i64, 9_u8);
    // SAFETY: the instance is alive, the arrays have one element, here and below.
    unsafe {
        assert_eq!(fmi3SetInt32(i, &count, 1, &7, 1), Status::Ok);
        assert_eq!(fmi3GetInt32(i, &count, 1, &mut integer, 1), Status::Ok);
        assert_eq!(fmi3SetInt64(i, &model, 1, &6, 1), Status::Ok);
        assert_eq!(fmi3GetInt64(i, &model, 1, &mut item, 1), Status::Ok);
        assert_eq!(fmi3SetBoolean(i, &flag, 1, &255, 1), Status::Ok);
        assert_eq!(fmi3GetBoolean(i, &flag, 1, &mut boolean, 1), Status::Ok);
    }
    assert_eq!((integer, item, boolean), (7, 6, 1));
    for (reference, text) in [
        (count, "`mode_count` is an Int32, not a Float64"),
        (model, "`model` is an Enumeration, which is read and written as an Int64, not a Float64"),
        (flag, "`sensor.enabled` is a Boolean, not a Float64"),
        (4_000_000, "value reference 4000000: there is no such variable"),
    ] {
        let fmu = Fmu::new(Kind::CoSimulation);
        assert_eq!(fmu.get_references(&[reference]), Err(Status::Error));
        fmu.assert_refused(&[text]);
    }
    let fmu = Fmu::new(Kind::CoSimulation);
    let mut byte = 0_i8;
    // SAFETY: as above.
    unsafe {
        assert_eq!(fmi3GetInt8(fmu.instance, &speed, 0, &mut byte, 0), Status::Ok);
        assert_eq!(fmi3GetInt8(fmu.instance, &speed, 1, &mut byte, 1), Status::Error);
    }
    fmu.assert_refused(&["fmi3GetInt8: `airspeed` is a Float64, not an Int8"]);
    let fmu = Fmu::new(Kind::CoSimulation);
    // SAFETY: as above.
    assert_eq!(unsafe { fmi3SetInt64(fmu.instance, &model, 1, &i64::MAX, 1) }, Status::Error);
    fmu.assert_refused(&["`model`: found", "6 (geometrically_exact)"]);
}

#[test]
fn there_are_as_many_values_as_variables() {
    for (count, values) in [(2, 3), (1, 0), (0, 1)] {
        let fmu = Fmu::new(Kind::CoSimulation);
        let mut room = [0.0; 3];
        // SAFETY: the instance is alive, the arrays are longer than said.
        let status =
            unsafe { fmi3GetFloat64(fmu.instance, [0, 1].as_ptr(), count, room.as_mut_ptr(), values) };
        assert_eq!(status, Status::Error);
        fmu.assert_refused(&[&format!("found {values} values for {count} scalar variables")]);
    }
    let fmu = Fmu::new(Kind::CoSimulation);
    assert_eq!(fmu.initialise(0.0), Status::Ok);
    let (factor, elevator) = (fmu.reference("load_factor.z"), fmu.reference("elevator"));
    let (seed, mut change) = ([1.0, 2.0], 0.0);
    // SAFETY: as above.
    unsafe {
        let derivative = |seeds: usize, place: &mut f64| {
            fmi3GetDirectionalDerivative(
                fmu.instance,
                &factor,
                1,
                &elevator,
                1,
                seed.as_ptr(),
                seeds,
                place,
                1,
            )
        };
        assert_eq!(derivative(1, &mut change), Status::Ok);
        assert!(change.abs() > 0.01, "{change}");
        assert_eq!(derivative(2, &mut change), Status::Error);
    }
    fmu.assert_refused(&["nSeed: found 2 values for 1 scalar variables"]);
}

#[test]
fn the_time_is_a_variable_and_is_not_set() {
    let fmu = Fmu::new(Kind::CoSimulation);
    assert_eq!(fmu.reference("time"), 1_000_000);
    assert_eq!(fmu.initialise(1.5), Status::Ok);
    assert_eq!(fmu.get("time"), 1.5);
    assert_eq!(fmu.step(1.5, 0.25), Status::Ok);
    assert_eq!(fmu.get("time"), 1.75);
    assert_eq!(fmu.set(&[("time", 2.0)]), Status::Error);
    fmu.assert_refused(&["`time` is set by the steps that are taken"]);
}

use super::*;

#[test]
fn inputs_and_parameters_read_back_what_was_set() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set(&[("elevator", 0.1), ("thrust_right", 5.0), ("airspeed", 150.0)]), Status::Ok);
    assert_eq!(fmu.set_integer("model", 3), Status::Ok);
    assert_eq!((fmu.get("elevator"), fmu.get("thrust_right"), fmu.get("airspeed")), (0.1, 5.0, 150.0));
    assert_eq!(fmu.get_integer("model"), Ok(3));
}

#[test]
fn a_refused_value_leaves_all_of_the_call_undone() {
    let fmu = Fmu::initialising();
    for (name, value, parts) in [
        ("rudder", f64::NAN, ["`rudder`", "NaN"]),
        ("rudder", f64::INFINITY, ["`rudder`", "inf"]),
        ("airspeed", -3.0, ["-3", "1 to 400"]),
        ("rate.x", 0.0, ["`rate.x`", "output"]),
    ] {
        assert_eq!(fmu.set(&[("elevator", 0.1), (name, value)]), Status::Error);
        fmu.assert_refused(&parts);
        assert_eq!(fmu.get("elevator"), 0.0);
    }
    assert_eq!(fmu.set_integer("model", 7), Status::Error);
    fmu.assert_refused(&["found 7", "1 (exact)", "6 (geometrically_exact)"]);
    assert_eq!(fmu.get_integer("model"), Ok(1));
}

#[test]
fn unknown_references_and_wrong_types_are_refused() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.get_references(&[0, 100_000]), Err(Status::Error));
    fmu.assert_refused(&["100000"]);
    assert_eq!(fmu.get_references(&[reference("model")]), Err(Status::Error));
    fmu.assert_refused(&["`model`", "Enumeration", "a Real"]);
    assert_eq!(fmu.set_integer("elevator", 1), Status::Error);
    fmu.assert_refused(&["`elevator`", "a Real"]);
    // SAFETY: the component is alive, the arrays have one element.
    assert_eq!(unsafe { fmi2GetBoolean(fmu.component, &0, 1, &mut 0) }, Status::Error);
    fmu.assert_refused(&["`elevator`", "a Boolean"]);
    // SAFETY: the component is alive, the array has one element; the refused call reads no values.
    assert_eq!(unsafe { fmi2SetString(fmu.component, &u32::MAX, 1, null()) }, Status::Error);
    fmu.assert_refused(&["4294967295"]);
}

#[test]
fn null_arrays_are_refused_unless_empty() {
    let fmu = Fmu::initialising();
    // SAFETY: the component is alive; NULL and absurd counts are what is tested.
    unsafe {
        assert_eq!(fmi2GetReal(fmu.component, null(), 0, null_mut()), Status::Ok);
        assert_eq!(fmi2SetReal(fmu.component, null(), 0, null()), Status::Ok);
        assert_eq!(fmi2GetBoolean(fmu.component, null(), 0, null_mut()), Status::Ok);
        assert_eq!(fmi2SetReal(fmu.component, &0, 1, null()), Status::Error);
        assert_eq!(fmi2GetReal(fmu.component, &0, 1, null_mut()), Status::Error);
        assert_eq!(fmi2GetReal(fmu.component, null(), 3, null_mut()), Status::Error);
        assert_eq!(fmi2SetReal(fmu.component, &0, usize::MAX, &0.0), Status::Error);
    }
    fmu.assert_refused(&["vr", "memory"]);
}

#[test]
fn only_inputs_have_derivatives_and_only_finite_ones_from_the_first_on() {
    let fmu = Fmu::initialising();
    assert_eq!(fmu.set_rates(&[("elevator", 1, 0.5)]), Status::Ok);
    for (name, order, value) in
        [("elevator", 0, 0.5), ("elevator", -1, 0.5), ("airspeed", 1, 0.5), ("elevator", 2, f64::NAN)]
    {
        assert_eq!(fmu.set_rates(&[("rudder", 1, 0.1), (name, order, value)]), Status::Error);
        fmu.assert_refused(&[name]);
    }
    assert_eq!((fmu.exit(), fmu.step(0.0, 0.1)), (Status::Ok, Status::Ok));
    assert_eq!((fmu.get("elevator"), fmu.get("rudder")), (0.05, 0.0));
}

#[test]
fn a_null_component_is_an_error() {
    // SAFETY: NULL is what is tested.
    assert_eq!(unsafe { fmi2DoStep(null_mut(), 0.0, 0.1, 1) }, Status::Error);
    // SAFETY: NULL is what is tested.
    unsafe { fmi2FreeInstance(null_mut()) };
}

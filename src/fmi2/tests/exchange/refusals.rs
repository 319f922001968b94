//! What an importer cannot ask for, and how it is told.

use super::surface::Saved;
use super::*;

/// Sets a Real, which is refused.
fn refuse_real(exchange: &Exchange, name: &str, value: f64, parts: &[&str]) {
    let reference = exchange.reference(name);
    assert_eq!(exchange.fmu.set_references(&[reference], &[value]), Status::Error, "{name}");
    exchange.fmu.assert_refused(&[&[&format!("`{name}`") as &str], parts].concat());
}

#[test]
fn what_belongs_to_co_simulation_is_refused_by_name() {
    let exchange = Exchange::new(jet());
    for (name, value) in [
        ("actuator.elevator.rate_limit", 1.0),
        ("actuator.elevator.minimum", -0.3),
        ("actuator.aileron.maximum", 0.3),
        ("engine.left.minimum", 0.0),
        ("engine.right.maximum", 3e4),
    ] {
        let reference = exchange.reference(name);
        assert_eq!(exchange.fmu.set_references(&[reference], &[value]), Status::Error, "{name}");
        exchange.fmu.assert_refused(&[name, &format!("found {value}"), "belongs to co-simulation"]);
    }
    let enabled = exchange.reference("sensor.enabled");
    // SAFETY: the component is alive, the arrays have one element.
    assert_eq!(unsafe { fmi2SetBoolean(exchange.fmu.component, &enabled, 1, &1) }, Status::Error);
    exchange.fmu.assert_refused(&["sensor.enabled: found true", "belongs to co-simulation"]);
    let states = exchange.reference("inflow_states");
    // SAFETY: as above.
    assert_eq!(unsafe { fmi2SetInteger(exchange.fmu.component, &states, 1, &3) }, Status::Error);
    exchange.fmu.assert_refused(&[
        "inflow_states: found 3, allowed is 0 or 5: a model exchange FMU has as many states as its aircraft file says",
    ]);
    assert!(exchange.table.iter().all(|(_, row)| row.name != "tolerance"));
    assert!(exchange.table.common().reference("tolerance").is_some());
}

#[test]
fn states_are_set_where_the_importer_integrates_alone() {
    let exchange = Exchange::new(jet());
    refuse_real(&exchange, "attitude.pitch", 0.1, &["is a state", "continuousTimeMode alone"]);
    let exchange = Exchange::flying(jet(), &[]);
    exchange.set(&[("attitude.pitch", 0.1), ("inflow[3,1]", 0.5)]);
    assert_eq!(exchange.get(&["attitude.pitch", "inflow[3,1]"]), [0.1, 0.5]);
    refuse_real(&exchange, "der(rate.y)", 0.1, &["is a rate and cannot be set"]);
    refuse_real(&exchange, "load_factor.z", 0.1, &["is an output and cannot be set"]);
    refuse_real(&exchange, "airspeed", 100.0, &["fixed parameter"]);
    refuse_real(&exchange, "velocity.x", f64::NAN, &["found NaN, allowed is any finite number, in m/s"]);
}

#[test]
fn wrong_counts_and_times_are_refused_with_both_numbers() {
    let exchange = Exchange::flying(jet(), &[]);
    let (c, mut x) = (exchange.fmu.component, exchange.states());
    let n = x.len();
    // SAFETY: the component is alive; no array is longer than said.
    unsafe {
        assert_eq!(fmi2SetContinuousStates(c, x.as_ptr(), n - 1), Status::Error);
        exchange.fmu.assert_refused(&[&format!("found {}, this FMU has {n}", n - 1)]);
        assert_eq!(fmi2GetDerivatives(c, x.as_mut_ptr(), 1), Status::Error);
        exchange.fmu.assert_refused(&["number of states: found 1"]);
        assert_eq!(fmi2GetEventIndicators(c, x.as_mut_ptr(), 1), Status::Error);
        exchange.fmu.assert_refused(&["number of event indicators: found 1, this FMU has 0"]);
        assert_eq!(fmi2GetEventIndicators(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi2SetTime(c, -1.0), Status::Error);
        exchange.fmu.assert_refused(&["time: found -1, allowed is the start time 0 s or later"]);
        assert_eq!(fmi2SetTime(c, f64::INFINITY), Status::Error);
        // The method of CVode looks ahead of the stop time.
        assert_eq!(fmi2SetTime(c, 1e6), Status::Ok);
        assert_eq!(fmi2DoStep(c, 0.0, 0.1, 1), Status::Error);
        exchange.fmu.assert_refused(&["belongs to co-simulation, and this is a model exchange FMU"]);
        let elevator = exchange.reference("elevator");
        assert_eq!(fmi2SetRealInputDerivatives(c, &elevator, 1, &1, &0.5), Status::Error);
        exchange.fmu.assert_refused(&["belongs to co-simulation"]);
    }
}

#[test]
fn states_beyond_the_model_are_discarded_with_reason_and_time_and_others_may_be_tried() {
    let exchange = Exchange::flying(jet(), &[]);
    let trim = exchange.states();
    let place = |name: &str| {
        let reference = exchange.reference(name);
        exchange.table.states().iter().position(|(_, own)| *own == reference).unwrap()
    };
    for (name, value, reason) in [
        ("velocity.x", -150.0, "from behind"),
        ("attitude.pitch", std::f64::consts::FRAC_PI_2, "the nose points straight up or down"),
        ("rate.x", f64::NAN, "no longer finite"),
        ("modal.q[1]", f64::INFINITY, "no longer finite"),
    ] {
        let mut x = trim.clone();
        x[place(name)] = value;
        exchange.set_states(0.25, &x);
        let mut rates = vec![0.0; x.len()];
        // SAFETY: the component is alive, the array is as long as said.
        let status = unsafe { fmi2GetDerivatives(exchange.fmu.component, rates.as_mut_ptr(), rates.len()) };
        assert_eq!(status, Status::Discard, "{name}");
        let message = exchange.fmu.last_message();
        assert!(message.format.contains(reason) && message.format.contains("0.25 s"), "{message:?}");
        let factor = exchange.reference("load_factor.z");
        assert_eq!(exchange.fmu.get_references(&[factor]), Err(Status::Discard));
        exchange.set_states(0.25, &trim);
        assert!(exchange.rates().iter().all(|rate| rate.is_finite()));
    }
}

#[test]
fn an_archive_of_the_other_kind_is_named() {
    let unpacked = Unpacked::new("jet");
    let token = description::token(EXCHANGE, jet(), &starts::usual(EXCHANGE, jet()));
    let (uri, usual) = (unpacked.uri("jet"), guid(jet()));
    for (kind, token, own) in [(1, &token, "model exchange"), (0, &usual, "co-simulation")] {
        let request =
            Request { name: Some("x"), kind, guid: Some(token), uri: Some(&uri), logging_on: false };
        let fmu = Fmu::request(&request);
        assert!(fmu.component.is_null());
        fmu.assert_refused(&[&format!("this archive is FMI 2.0 {own}, not FMI 2.0")]);
    }
}

/// What is saved at a time that was taken can be gone back to.
#[test]
fn a_state_saved_at_any_time_that_is_taken_leads_back() {
    let exchange = Exchange::flying(jet(), &[]);
    let c = exchange.fmu.component;
    for time in [1e12, 3.0, 0.0, -1e-10] {
        // SAFETY: the component is alive.
        assert_eq!(unsafe { fmi2SetTime(c, time) }, Status::Ok, "{:?}", exchange.fmu.log);
        let saved = Saved::of(&exchange.fmu);
        assert_eq!(saved.restore(), Status::Ok, "{time}: {:?}", exchange.fmu.log);
    }
    // SAFETY: as above.
    assert_eq!(unsafe { fmi2SetTime(c, 1.1e12) }, Status::Error);
    exchange.fmu.assert_refused(&["time: found 1100000000000, allowed is -1e12 to 1e12 s"]);
}

//! Derivatives of the FMU against the linear model of the library: by inputs at the trim, and by what the trim begins with.
//!
//! A unit for co-simulation has no continuous states, so that it gives no derivative by one alone. Where all of them follow a
//! parameter, A, B and C are seen together.

use nalgebra::DVector;

use super::*;
use crate::by_name::{Inflow, LinearModel, LinearName};
use crate::devices::Actuator;
use crate::plant::{ConditionSettings, ManoeuvreChoice};

/// With two modes and one inflow state, the same settings for both.
fn small() -> Settings {
    let mut settings = Settings::of(jet());
    (settings.plant.mode_count, settings.plant.inflow_states) = (2, 1);
    settings
}

/// In initialisation mode, with values of parameters.
fn initialising(values: &[(&str, f64)], choices: &[(&str, c_int)]) -> Fmu {
    let fmu = Fmu::new();
    for (name, value) in [("mode_count", 2), ("inflow_states", 1)].iter().chain(choices) {
        assert_eq!(fmu.set_integer(name, *value), Status::Ok, "{name}");
    }
    assert_eq!(fmu.set(values), Status::Ok);
    assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter()], [Status::Ok; 2]);
    fmu
}

fn place(names: &[LinearName], name: &str) -> usize {
    names.iter().position(|other| other.name == name).unwrap()
}

/// What counts as one of an input: 0.1 rad, 10 kN, 10 m/s.
fn usual(input: &LinearName) -> f64 {
    match input.unit {
        "rad" => 0.1,
        "N" => 1e4,
        _ => 10.0,
    }
}

/// Compares the derivatives of all outputs of the linear model by all its inputs, and by the rates of the wind.
fn compare(fmu: &Fmu, settings: &Settings) {
    assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
    let model = LinearModel::new(jet().clone(), settings, Inflow::Kept).unwrap();
    let outputs: Vec<u32> = model.outputs.iter().map(|name| reference(&name.name)).collect();
    let found = fmu.get_references(&outputs).unwrap();
    for ((name, found), expected) in model.outputs.iter().zip(found).zip(&model.y0) {
        assert!((found - expected).abs() < 1e-8 * (1.0 + expected.abs()), "{name:?}: {found}, {expected}");
    }
    let mut compared = 0;
    for (column, input) in model.inputs.iter().enumerate() {
        let rate = input.name.replace("wind_", "wind_rate_");
        for (known, matrix) in [(&input.name, &model.d), (&rate, &model.dd)] {
            if *known == input.name && std::ptr::eq(matrix, &model.dd) {
                assert_eq!(matrix.column(column).amax(), 0.0, "{known}");
                continue;
            }
            let derivatives = fmu.derivatives(&outputs, &[reference(known)], &[usual(input)]).unwrap();
            for ((row, name), found) in model.outputs.iter().enumerate().zip(derivatives) {
                let expected = usual(input) * matrix[(row, column)];
                // Loads and accelerations of what stands still beside what moves are rounded.
                let close = (found - expected).abs() <= 2e-7 * (expected.abs() + model.y0[row].abs() + 1.0);
                assert!(close, "d {}/d {known}: {found}, {expected}", name.name);
                compared += 1;
            }
        }
    }
    assert_eq!(compared, (model.inputs.len() + 3) * outputs.len());
}

#[test]
fn derivatives_by_inputs_at_the_trim_are_those_of_the_linear_model() {
    compare(&initialising(&[], &[]), &small());
}

#[test]
fn they_are_in_a_turn_on_another_heading_with_an_actuator_that_lags() {
    let values = [("heading", 0.7), ("condition.bank_angle", 0.3), ("actuator.elevator.frequency", 40.0)];
    let mut settings = small();
    settings.plant.heading = 0.7;
    settings.plant.condition = ConditionSettings {
        manoeuvre: ManoeuvreChoice::Turn,
        bank_angle: 0.3,
        ..ConditionSettings::default()
    };
    settings.actuators.set(0, Actuator { frequency: 40.0, ..settings.actuators.get(0) });
    compare(&initialising(&values, &[("condition.manoeuvre", 2)]), &settings);
}

/// At a trim x and u follow airspeed or altitude such that the flight stays steady: A x' + B u' = 0, y' = C x' + D u'. The FMU
/// does not show the inflow states: what they are makes their own rows rest, and is put into all others.
#[test]
fn derivatives_by_airspeed_and_altitude_leave_the_linear_model_at_rest() {
    let fmu = initialising(&[], &[]);
    let model = LinearModel::new(jet().clone(), &small(), Inflow::Kept).unwrap();
    let outputs: Vec<u32> = model.outputs.iter().map(|name| reference(&name.name)).collect();
    for (parameter, change) in [("airspeed", 10.0), ("altitude", 1000.0)] {
        let y = DVector::from(fmu.derivatives(&outputs, &[reference(parameter)], &[change]).unwrap());
        let of_output = |name: &str| y[place(&model.outputs, name)];
        let shown = model.states.iter().take_while(|name| !name.name.starts_with("inflow"));
        let shown: Vec<f64> = shown.map(|name| of_output(&name.name)).collect();
        let acting = |name: &LinearName| match name.name.strip_prefix("thrust_") {
            Some(engine) => of_output(&format!("engine.{engine}.thrust")),
            None if name.name.starts_with("wind_") => 0.0,
            None => of_output(&format!("surface.{}", name.name)),
        };
        let u = DVector::from_iterator(model.inputs.len(), model.inputs.iter().map(acting));
        let (motion, wake) = (shown.len(), model.states.len() - shown.len());
        let mut x = DVector::from(shown).resize_vertically(model.states.len(), 0.0);
        let forcing = &model.a * &x + &model.b * &u;
        let decay = model.a.view((motion, motion), (wake, wake)).into_owned();
        let lag = decay.lu().solve(&-forcing.rows(motion, wake)).unwrap();
        x.rows_mut(motion, wake).copy_from(&lag);
        assert!(x.amax() > 0.01 && lag.amax() > 0.1 && u.amax() > 100.0, "{parameter}");
        let parts =
            |a: &nalgebra::DMatrix<f64>, b: &nalgebra::DMatrix<f64>| (a.abs() * x.abs(), b.abs() * u.abs());
        let (by_states, by_inputs) = parts(&model.a, &model.b);
        for (row, (name, rate)) in model.states.iter().zip((&model.a * &x + &model.b * &u).iter()).enumerate()
        {
            let size = by_states[row] + by_inputs[row];
            assert!(rate.abs() <= 1e-6 * size + 1e-9, "{parameter}, {}: {rate} of {size}", name.name);
        }
        let (by_states, by_inputs) = parts(&model.c, &model.d);
        for (row, (name, found)) in
            model.outputs.iter().zip((&model.c * &x + &model.d * &u).iter()).enumerate()
        {
            let size = by_states[row] + by_inputs[row];
            let apart = (found - y[row]).abs();
            assert!(
                apart <= 1e-6 * size + 1e-9,
                "{parameter}, {}: {found}, {}, of {size}",
                name.name,
                y[row]
            );
        }
    }
}

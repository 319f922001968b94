//! Actuators and engines that lag, as further states of a linear model [theory: linearisation.lags, actuators.motion].

use crate::devices::Actuator;
use crate::flight::Settings;
use crate::structure::ReducedModel;
use crate::variables::OutputSlot;

use super::linear_model::LinearModel;
use super::linear_names::Name;

/// Puts the lags of some settings between the inputs of a model, which are controls, then engines, and what acts. The outputs
/// have these slots.
pub(super) fn append(
    linear: &mut LinearModel,
    slots: &[OutputSlot],
    model: &ReducedModel,
    settings: &Settings,
) {
    for (input, control) in model.controls.iter().enumerate() {
        let actuator = settings.actuators.get(input);
        if actuator.lags() {
            let rate = add_actuator(linear, input, &control.name, &actuator);
            for (row, _) in
                slots.iter().enumerate().filter(|(_, slot)| **slot == OutputSlot::ActuatorRate(input))
            {
                linear.c[(row, rate)] = 1.0;
            }
        }
    }
    for (number, engine) in model.engines.iter().enumerate() {
        let lag = settings.engines.get(number);
        if lag.lags() {
            let input = model.controls.len() + number;
            add_engine(linear, input, &engine.name, lag.time_constant);
        }
    }
}

/// How many states that puts into a model.
pub(super) fn count(model: &ReducedModel, settings: &Settings) -> usize {
    let actuators = (0..model.controls.len()).filter(|input| settings.actuators.get(*input).lags());
    let engines = (0..model.engines.len()).filter(|number| settings.engines.get(*number).lags());
    2 * actuators.count() + engines.count()
}

/// δ̈ = ω² (u − δ) − 2ζω δ̇; returns the place of δ̇.
fn add_actuator(linear: &mut LinearModel, input: usize, name: &str, actuator: &Actuator) -> usize {
    let state = |suffix, unit| Name { name: format!("actuator.{name}.{suffix}"), unit };
    let at_trim = linear.u0[input];
    let position = add_state(linear, state("position", "rad"), at_trim);
    let rate = add_state(linear, state("rate", "rad/s"), 0.0);
    act_instead(linear, position, input);
    let square = actuator.frequency * actuator.frequency;
    linear.a[(position, rate)] = 1.0;
    linear.a[(rate, position)] = -square;
    linear.a[(rate, rate)] = -2.0 * actuator.damping * actuator.frequency;
    linear.b[(rate, input)] = square;
    rate
}

/// Ṫ = (u − T)/τ.
fn add_engine(linear: &mut LinearModel, input: usize, name: &str, time_constant: f64) {
    let state = Name { name: format!("engine.{name}.lagged_thrust"), unit: "N" };
    let at_trim = linear.u0[input];
    let thrust = add_state(linear, state, at_trim);
    act_instead(linear, thrust, input);
    linear.a[(thrust, thrust)] = -1.0 / time_constant;
    linear.b[(thrust, input)] = 1.0 / time_constant;
}

/// Adds a state at rest on which nothing depends; returns its place.
pub(super) fn add_state(linear: &mut LinearModel, name: Name, at_trim: f64) -> usize {
    let LinearModel { a, b, c, bd, x0, states, .. } = linear;
    let place = states.len();
    a.resize_mut(place + 1, place + 1, 0.0);
    for of_inputs in [b, bd] {
        of_inputs.resize_mut(place + 1, of_inputs.ncols(), 0.0);
    }
    c.resize_mut(c.nrows(), place + 1, 0.0);
    x0.push(at_trim);
    states.push(name);
    place
}

/// Has a state do what an input did.
fn act_instead(linear: &mut LinearModel, state: usize, input: usize) {
    let LinearModel { a, b, c, d, .. } = linear;
    a.set_column(state, &b.column(input));
    c.set_column(state, &d.column(input));
    b.fill_column(input, 0.0);
    d.fill_column(input, 0.0);
}

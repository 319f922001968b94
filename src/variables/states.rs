//! Which variables the states of the motion are [theory: continuous-model.states].

use crate::flight::ContinuousState;
use crate::structure::ReducedModel;

use super::axis::Axis;
use super::output_slot::OutputSlot;
use super::table::NORTH_EAST_DOWN;
use super::unit::Unit;

/// What a state is called where it is no output.
pub(super) struct OwnName {
    pub name: String,
    pub unit: Unit,
    pub description: String,
}

/// A state is an output, or has a name of its own.
pub(super) enum StateVariable {
    Output(OutputSlot),
    Own(OwnName),
}

/// What a state of an aircraft is called.
pub(super) fn variable(state: ContinuousState, model: &ReducedModel) -> StateVariable {
    let own =
        |name: String, unit, description: String| StateVariable::Own(OwnName { name, unit, description });
    let output = StateVariable::Output;
    match state {
        ContinuousState::Position(axis) => output(OutputSlot::Position(Axis::ALL[axis])),
        ContinuousState::Attitude(axis) => output(OutputSlot::Attitude(Axis::ALL[axis])),
        ContinuousState::Velocity(axis) => output(OutputSlot::Velocity(Axis::ALL[axis])),
        ContinuousState::Rate(axis) => output(OutputSlot::Rate(Axis::ALL[axis])),
        ContinuousState::Coordinate(mode) => output(OutputSlot::ModalCoordinate(mode)),
        ContinuousState::CoordinateRate(mode) => output(OutputSlot::ModalRate(mode)),
        ContinuousState::SurfaceRate(control) => output(OutputSlot::ActuatorRate(control)),
        ContinuousState::Inflow { strip, number } => own(
            format!("inflow[{},{}]", strip + 1, number + 1),
            Unit::MetrePerSecond,
            format!(
                "Inflow state {} of strip {}, on {}",
                number + 1,
                strip + 1,
                model.strips[strip].component
            ),
        ),
        ContinuousState::Drift(axis) => own(
            format!("drift.{}", NORTH_EAST_DOWN[axis]),
            Unit::Metre,
            format!(
                "How far the air, and with it gust and turbulence, has gone towards {}",
                NORTH_EAST_DOWN[axis]
            ),
        ),
        ContinuousState::SurfaceAngle(control) => {
            let name = &model.controls[control].name;
            own(
                format!("actuator.{name}.position"),
                Unit::Radian,
                format!("Where the actuator of {name} is, if it lags; otherwise nothing depends on it"),
            )
        }
        ContinuousState::LaggedThrust(engine) => {
            let name = &model.engines[engine].name;
            own(
                format!("engine.{name}.lagged_thrust"),
                Unit::Newton,
                format!("Thrust of engine {name}, if it lags; otherwise nothing depends on it"),
            )
        }
    }
}

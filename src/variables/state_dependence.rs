//! What outputs and rates depend on where states are known beside inputs, as a model exchange FMU tells it to importers, who
//! take from it which entries of a Jacobian they ask for. More than what acts may be said, nothing less
//! [theory: continuous-model.dependence].

use crate::devices::{ActuatorSetting, EngineSetting};
use crate::flight::ContinuousState as S;

use super::air_quantity::AirQuantity;
use super::axis::Axis;
use super::dependence;
use super::output_slot::{OutputSlot, PlacementComponent};
use super::slot::{InputSlot, ParameterSlot};

/// Whether an output, none of a sensor, shows a state at the same instant.
pub(super) fn shows(output: OutputSlot, state: S) -> bool {
    match output {
        OutputSlot::Position(axis) => state == S::Position(axis.index()),
        OutputSlot::Attitude(axis) => state == S::Attitude(axis.index()),
        OutputSlot::Velocity(axis) => state == S::Velocity(axis.index()),
        OutputSlot::Rate(axis) => state == S::Rate(axis.index()),
        OutputSlot::ModalCoordinate(mode) => state == S::Coordinate(mode),
        OutputSlot::ModalRate(mode) => state == S::CoordinateRate(mode),
        OutputSlot::ActuatorRate(control) => state == S::SurfaceRate(control),
        OutputSlot::Control(control) => state == S::SurfaceAngle(control),
        OutputSlot::Thrust(engine) => state == S::LaggedThrust(engine),
        OutputSlot::Acceleration(_)
        | OutputSlot::LoadFactor(_)
        | OutputSlot::SpecificForce { .. }
        | OutputSlot::AngularAcceleration(_)
        | OutputSlot::LoadFactorAtCentre(_)
        | OutputSlot::LiftLoadFactor
        | OutputSlot::SectionLoad { .. } => true,
        OutputSlot::Quaternion(_) => matches!(state, S::Attitude(_)),
        OutputSlot::Path(_) => matches!(state, S::Attitude(_) | S::Velocity(_)),
        OutputSlot::Placement { component: PlacementComponent::Position(_), .. } => {
            matches!(state, S::Position(_) | S::Attitude(_) | S::Coordinate(_))
        }
        OutputSlot::Placement { component: PlacementComponent::Quaternion(_), .. } => {
            matches!(state, S::Attitude(_) | S::Coordinate(_))
        }
        OutputSlot::Air(AirQuantity::Density | AirQuantity::Pressure | AirQuantity::Temperature) => {
            state == S::Position(2)
        }
        // What is frozen in the air is met at a place in it.
        OutputSlot::Air(_) => {
            matches!(state, S::Position(_) | S::Attitude(_) | S::Velocity(_) | S::Drift(_))
        }
        OutputSlot::Wind(_) => matches!(state, S::Position(_) | S::Drift(_)),
        OutputSlot::Deflection { .. } => matches!(state, S::Coordinate(_)),
        OutputSlot::StationRate { .. } => {
            matches!(state, S::Rate(_) | S::Coordinate(_) | S::CoordinateRate(_))
        }
        // Nothing holds back what has no limits.
        OutputSlot::RateLimited(_) | OutputSlot::PositionLimited(_) => false,
        OutputSlot::GustPeakVelocity
        | OutputSlot::TrimPitch
        | OutputSlot::TrimControl(_)
        | OutputSlot::TrimThrust
        | OutputSlot::TrimClimbAngle
        | OutputSlot::TrimRoll
        | OutputSlot::TrimSideslip
        | OutputSlot::TrimAngleOfAttack
        | OutputSlot::TrimTurnRate
        | OutputSlot::TrimPitchRate
        | OutputSlot::TrimLoadFactor
        | OutputSlot::Sensor(_) => false,
    }
}

/// Whether an input acts on an output, none of a sensor, at the same instant where states are known.
pub(super) fn direct(output: OutputSlot, input: InputSlot) -> bool {
    match output {
        OutputSlot::ActuatorRate(_) | OutputSlot::RateLimited(_) | OutputSlot::PositionLimited(_) => false,
        _ => dependence::direct(output, input),
    }
}

/// Whether an output is a function of states alone, whatever the parameters.
pub(super) fn is_of_states_alone(output: OutputSlot) -> bool {
    matches!(
        output,
        OutputSlot::Position(_)
            | OutputSlot::Attitude(_)
            | OutputSlot::Quaternion(_)
            | OutputSlot::Velocity(_)
            | OutputSlot::Rate(_)
            | OutputSlot::Path(_)
            | OutputSlot::Placement { .. }
            | OutputSlot::Deflection { .. }
            | OutputSlot::StationRate { .. }
            | OutputSlot::ModalCoordinate(_)
            | OutputSlot::ModalRate(_)
    )
}

/// Whether the rate of a state follows from other states alone.
pub(super) fn is_kinematic(rate_of: S) -> bool {
    matches!(rate_of, S::Position(_) | S::Attitude(_) | S::Coordinate(_))
}

/// Whether the rate of a state depends on a state.
pub(super) fn moves(rate_of: S, state: S) -> bool {
    match rate_of {
        S::Position(_) => matches!(state, S::Attitude(_) | S::Velocity(_)),
        S::Attitude(_) => matches!(state, S::Attitude(_) | S::Rate(_)),
        S::Coordinate(mode) => state == S::CoordinateRate(mode),
        S::Velocity(_) | S::Rate(_) | S::CoordinateRate(_) => true,
        S::Inflow { strip, .. } => match state {
            S::Inflow { strip: other, .. } => other == strip,
            S::SurfaceRate(_) | S::LaggedThrust(_) => false,
            _ => true,
        },
        S::SurfaceAngle(control) => state == S::SurfaceRate(control),
        S::SurfaceRate(control) => [S::SurfaceAngle(control), S::SurfaceRate(control)].contains(&state),
        S::LaggedThrust(engine) => state == S::LaggedThrust(engine),
        // Of the next version's states nothing is known.
        S::Drift(_) => false,
    }
}

/// Whether the rate of a state depends on an input.
pub(super) fn pushes(rate_of: S, input: InputSlot) -> bool {
    match rate_of {
        S::Velocity(_) | S::Rate(_) | S::CoordinateRate(_) => true,
        S::Inflow { .. } => matches!(input, InputSlot::Control(_) | InputSlot::Wind(_)),
        S::Drift(axis) => input == InputSlot::Wind(Axis::ALL[axis]),
        S::SurfaceRate(control) => input == InputSlot::Control(control),
        S::LaggedThrust(engine) => input == InputSlot::Thrust(engine),
        S::Position(_) | S::Attitude(_) | S::Coordinate(_) | S::SurfaceAngle(_) => false,
    }
}

/// Whether a parameter acts on a state that is no output, at initialisation.
pub(super) fn starts(state: S, parameter: ParameterSlot) -> bool {
    match state {
        S::Inflow { .. } | S::LaggedThrust(_) | S::SurfaceAngle(_) => dependence::trims(parameter),
        _ => false,
    }
}

/// Whether a parameter acts on the rate of a state at initialisation.
pub(super) fn starts_rate(rate_of: S, parameter: ParameterSlot) -> bool {
    use ParameterSlot::{Airspeed, Heading, InputReference};
    match rate_of {
        S::Position(_) | S::Attitude(_) | S::Coordinate(_) => {
            parameter == Heading || dependence::trims(parameter)
        }
        S::Drift(_) => matches!(parameter, Airspeed | Heading),
        S::SurfaceAngle(_) => false,
        S::SurfaceRate(control) => {
            use ActuatorSetting::{Damping, Frequency};
            let own = |setting| matches!(setting, Damping | Frequency);
            matches!(parameter, ParameterSlot::Actuator { control: of, setting } if of == control && own(setting))
                || parameter == InputReference
                || dependence::trims(parameter)
        }
        S::LaggedThrust(engine) => {
            let own = EngineSetting::TimeConstant;
            matches!(parameter, ParameterSlot::Engine { engine: of, setting } if of == engine && setting == own)
                || parameter == InputReference
                || dependence::trims(parameter)
        }
        S::Velocity(_) | S::Rate(_) | S::CoordinateRate(_) | S::Inflow { .. } => {
            dependence::acts_on_forces(parameter)
        }
    }
}

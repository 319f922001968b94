//! What an output depends on, as the model description's `ModelStructure` tells it to importers, which
//! order calls and look for algebraic loops by it.

use crate::aircraft::TrimRole;
use crate::devices::{ActuatorSetting, EngineSetting};

use super::air_quantity::AirQuantity;
use super::axis::Axis;
use super::output_slot::{OutputSlot, PathQuantity, PlacementComponent};
use super::slot::{InputSlot, ParameterSlot, SensorSetting};

/// Whether an input acts on an output at the same instant: accelerations feel every force, by the apparent mass also
/// the rate of the wind; the flow feels the wind alone; positions, velocities and deformations are states and follow only by integration.
pub(super) fn direct(output: OutputSlot, input: InputSlot) -> bool {
    match output {
        OutputSlot::Acceleration(_)
        | OutputSlot::LoadFactor(_)
        | OutputSlot::SpecificForce { .. }
        | OutputSlot::AngularAcceleration(_)
        | OutputSlot::LoadFactorAtCentre(_)
        | OutputSlot::LiftLoadFactor
        | OutputSlot::SectionLoad { .. } => true,
        OutputSlot::Air(AirQuantity::Density | AirQuantity::Pressure | AirQuantity::Temperature) => false,
        OutputSlot::Air(_) => matches!(input, InputSlot::Wind(_)),
        OutputSlot::Wind(Axis::Z) => input == InputSlot::Wind(Axis::Z),
        OutputSlot::Wind(_) => matches!(input, InputSlot::Wind(Axis::X | Axis::Y)),
        OutputSlot::Control(control)
        | OutputSlot::ActuatorRate(control)
        | OutputSlot::RateLimited(control)
        | OutputSlot::PositionLimited(control) => input == InputSlot::Control(control),
        OutputSlot::Thrust(engine) => input == InputSlot::Thrust(engine),
        _ => false,
    }
}

/// Whether a parameter acts on the value of an output at initialisation, in the trimmed flight; `roles` has that of each
/// control.
pub(super) fn initial(output: OutputSlot, parameter: ParameterSlot, roles: &[Option<TrimRole>]) -> bool {
    use ParameterSlot::{Airspeed, Altitude, Heading, InputReference, TemperatureOffset};
    match output {
        OutputSlot::Position(Axis::Z) => parameter == Altitude,
        OutputSlot::Attitude(Axis::Z) => parameter == Heading,
        OutputSlot::Wind(_) => matches!(parameter, Heading | Airspeed),
        OutputSlot::GustPeakVelocity => {
            matches!(parameter, Altitude | TemperatureOffset | ParameterSlot::Gust(_))
        }
        OutputSlot::Position(_) | OutputSlot::ModalRate(_) => false,
        // In straight flight nothing turns; in a turn or a pull-up the rate is the trim's.
        OutputSlot::Rate(_) | OutputSlot::StationRate { .. } => trims(parameter),
        OutputSlot::Acceleration(_)
        | OutputSlot::LoadFactor(_)
        | OutputSlot::SpecificForce { .. }
        | OutputSlot::AngularAcceleration(_)
        | OutputSlot::LoadFactorAtCentre(_)
        | OutputSlot::LiftLoadFactor
        | OutputSlot::SectionLoad { .. } => acts_on_forces(parameter),
        OutputSlot::Air(AirQuantity::Pressure) => parameter == Altitude,
        OutputSlot::Air(AirQuantity::Density | AirQuantity::Temperature) => {
            matches!(parameter, Altitude | TemperatureOffset)
        }
        OutputSlot::Quaternion(_)
        | OutputSlot::Path(PathQuantity::Track)
        | OutputSlot::Placement {
            component: PlacementComponent::Position(Axis::X | Axis::Y) | PlacementComponent::Quaternion(_),
            ..
        } => parameter == Heading || trims(parameter),
        OutputSlot::Air(_) => parameter == Heading || trims(parameter),
        OutputSlot::ActuatorRate(control)
        | OutputSlot::RateLimited(control)
        | OutputSlot::PositionLimited(control) => {
            limits_control(parameter, control) || parameter == InputReference || trims(parameter)
        }
        OutputSlot::Control(control) if roles[control].is_none() => limits_control(parameter, control),
        OutputSlot::Control(control) => {
            limits_control(parameter, control) || parameter == InputReference || trims(parameter)
        }
        OutputSlot::Thrust(engine) => {
            limits_engine(parameter, engine) || parameter == InputReference || trims(parameter)
        }
        OutputSlot::Attitude(_)
        | OutputSlot::Velocity(_)
        | OutputSlot::Path(_)
        | OutputSlot::Placement { .. }
        | OutputSlot::Deflection { .. }
        | OutputSlot::ModalCoordinate(_)
        | OutputSlot::TrimPitch
        | OutputSlot::TrimControl(_)
        | OutputSlot::TrimThrust
        | OutputSlot::TrimClimbAngle
        | OutputSlot::TrimRoll
        | OutputSlot::TrimSideslip
        | OutputSlot::TrimAngleOfAttack
        | OutputSlot::TrimTurnRate
        | OutputSlot::TrimPitchRate
        | OutputSlot::TrimLoadFactor => trims(parameter),
        // Through what it mirrors.
        OutputSlot::Sensor(_) => false,
    }
}

/// Whether a parameter acts on forces and accelerations in the trimmed flight and under inputs there.
pub(super) fn acts_on_forces(parameter: ParameterSlot) -> bool {
    use ParameterSlot::{Sensor, StructuralDamping, Tolerance};
    !matches!(parameter, StructuralDamping | Tolerance | Sensor(_))
}

/// Whether a parameter of the sensors acts on the value of an output at initialisation.
pub(super) fn sampled(output: OutputSlot, setting: SensorSetting) -> bool {
    let acts = matches!(setting, SensorSetting::Enabled | SensorSetting::Noise(_) | SensorSetting::Seed);
    matches!(output, OutputSlot::Sensor(_)) && acts
}

/// Whether a parameter decides what a control does with its input at once.
fn limits_control(parameter: ParameterSlot, control: usize) -> bool {
    use ActuatorSetting::{Frequency, Maximum, Minimum};
    let acts = |setting| matches!(setting, Frequency | Minimum | Maximum);
    matches!(parameter, ParameterSlot::Actuator { control: of, setting } if of == control && acts(setting))
}

/// Whether a parameter decides what an engine does with its input at once.
fn limits_engine(parameter: ParameterSlot, engine: usize) -> bool {
    use EngineSetting::{Maximum, Minimum, TimeConstant};
    let acts = |setting| matches!(setting, TimeConstant | Minimum | Maximum);
    matches!(parameter, ParameterSlot::Engine { engine: of, setting } if of == engine && acts(setting))
}

/// The parameters that the trim depends on; inflow and damping vanish in steady flight.
pub(super) fn trims(parameter: ParameterSlot) -> bool {
    use ParameterSlot::{
        Airspeed, Altitude, Condition, LoadModes, ModeCount, ModeFamily, Model, StiffnessScale,
        TemperatureOffset,
    };
    matches!(
        parameter,
        Model
            | Airspeed
            | Altitude
            | TemperatureOffset
            | StiffnessScale
            | ModeFamily
            | ModeCount
            | LoadModes
            | Condition(_)
    )
}

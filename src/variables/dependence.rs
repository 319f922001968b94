//! What an output depends on, as the model description's `ModelStructure` tells it to importers, which
//! order calls and look for algebraic loops by it.

use crate::aircraft::TrimRole;

use super::{AirQuantity, Axis, InputSlot, OutputSlot, ParameterSlot, PathQuantity, PlacementComponent};

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
        OutputSlot::Control(control) => input == InputSlot::Control(control),
        OutputSlot::Thrust(engine) => input == InputSlot::Thrust(engine),
        _ => false,
    }
}

/// Whether a parameter acts on the value of an output at initialisation, in trimmed level flight; `roles` has that of each
/// control.
pub(super) fn initial(output: OutputSlot, parameter: ParameterSlot, roles: &[Option<TrimRole>]) -> bool {
    use ParameterSlot::{Altitude, Heading, InputReference, StructuralDamping, Tolerance};
    match output {
        OutputSlot::Position(Axis::Z) => parameter == Altitude,
        OutputSlot::Attitude(Axis::Z) => parameter == Heading,
        OutputSlot::Position(_)
        | OutputSlot::Rate(_)
        | OutputSlot::StationRate { .. }
        | OutputSlot::ModalRate(_) => false,
        OutputSlot::Acceleration(_)
        | OutputSlot::LoadFactor(_)
        | OutputSlot::SpecificForce { .. }
        | OutputSlot::AngularAcceleration(_)
        | OutputSlot::LoadFactorAtCentre(_)
        | OutputSlot::LiftLoadFactor
        | OutputSlot::SectionLoad { .. } => !matches!(parameter, StructuralDamping | Tolerance),
        OutputSlot::Air(AirQuantity::Density | AirQuantity::Pressure | AirQuantity::Temperature) => {
            parameter == Altitude
        }
        OutputSlot::Quaternion(_)
        | OutputSlot::Path(PathQuantity::Track)
        | OutputSlot::Placement {
            component: PlacementComponent::Position(Axis::X | Axis::Y) | PlacementComponent::Quaternion(_),
            ..
        } => parameter == Heading || trims(parameter),
        OutputSlot::Air(_) => parameter == Heading || trims(parameter),
        OutputSlot::Control(control) if roles[control].is_none() => false,
        OutputSlot::Control(_) | OutputSlot::Thrust(_) => parameter == InputReference || trims(parameter),
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
        | OutputSlot::TrimSideslip => trims(parameter),
    }
}

/// The parameters that the trim depends on; inflow and damping vanish in steady flight.
fn trims(parameter: ParameterSlot) -> bool {
    use ParameterSlot::{Airspeed, Altitude, LoadModes, ModeCount, ModeFamily, Model, StiffnessScale};
    matches!(parameter, Model | Airspeed | Altitude | StiffnessScale | ModeFamily | ModeCount | LoadModes)
}

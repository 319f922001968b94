//! Where the value of an output lives, in what is read of a flight.

use crate::aircraft::TrimRole;
use crate::devices::Holding;
use crate::flight::{Instant, Part};

use super::air_quantity::AirQuantity;
use super::axis::Axis;
use super::load_component::LoadComponent;
use super::value::Value;

/// A component of a station's deflection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeflectionComponent {
    /// Displacement along a body axis, m.
    Along(Axis),
    /// Displacement along −z, m.
    Up,
    /// rad.
    Twist,
}

/// A quantity of the path over the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in Path")]
#[non_exhaustive]
pub enum PathQuantity {
    ClimbAngle,
    Track,
    VerticalSpeed,
}

/// A number of a station's placement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlacementComponent {
    /// Its position towards north, east or down, m.
    Position(Axis),
    /// A part of its quaternion, the scalar first.
    Quaternion(usize),
}

/// An output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in Outputs and TrimPoint")]
#[non_exhaustive]
pub enum OutputSlot {
    Position(Axis),
    Attitude(Axis),
    Velocity(Axis),
    Rate(Axis),
    Acceleration(Axis),
    LoadFactor(Axis),
    /// A part of the attitude's, the scalar first.
    Quaternion(usize),
    AngularAcceleration(Axis),
    /// At the centre of mass.
    LoadFactorAtCentre(Axis),
    LiftLoadFactor,
    Path(PathQuantity),
    Placement {
        /// Index of the station.
        station: usize,
        component: PlacementComponent,
    },
    Air(AirQuantity),
    Wind(Axis),
    GustPeakVelocity,
    Deflection {
        /// Index of the station.
        station: usize,
        component: DeflectionComponent,
    },
    /// What an accelerometer at the station with this index reads.
    SpecificForce {
        station: usize,
        axis: Axis,
    },
    /// What a rate gyro at the station with this index reads.
    StationRate {
        station: usize,
        axis: Axis,
    },
    /// Section loads, which only outputs have that were asked for them.
    SectionLoad {
        /// Index of the cut.
        cut: usize,
        component: LoadComponent,
    },
    /// Of the mode with this index.
    ModalCoordinate(usize),
    /// Of the mode with this index.
    ModalRate(usize),
    /// The acting angle of the control with this index.
    Control(usize),
    /// Of the engine with this index.
    Thrust(usize),
    TrimPitch,
    /// The angle of the control with this role.
    TrimControl(TrimRole),
    TrimThrust,
    TrimClimbAngle,
    TrimRoll,
    TrimSideslip,
    TrimAngleOfAttack,
    TrimTurnRate,
    TrimPitchRate,
    TrimLoadFactor,
    /// Of the surface of the control with this index.
    ActuatorRate(usize),
    /// Whether the actuator of the control with this index moves as fast as it can.
    RateLimited(usize),
    /// Whether a stop holds the surface of the control with this index.
    PositionLimited(usize),
    /// What the channel with this index gives.
    Sensor(usize),
}

impl OutputSlot {
    /// The part of what is read at an instant that it is in.
    pub fn part(self) -> Part {
        match self {
            OutputSlot::Position(_)
            | OutputSlot::Attitude(_)
            | OutputSlot::Velocity(_)
            | OutputSlot::Rate(_)
            | OutputSlot::Acceleration(_)
            | OutputSlot::LoadFactor(_)
            | OutputSlot::AngularAcceleration(_)
            | OutputSlot::LiftLoadFactor
            | OutputSlot::Wind(_)
            | OutputSlot::GustPeakVelocity
            | OutputSlot::Deflection { .. }
            | OutputSlot::SpecificForce { .. }
            | OutputSlot::StationRate { .. }
            | OutputSlot::ModalCoordinate(_)
            | OutputSlot::ModalRate(_)
            | OutputSlot::Control(_)
            | OutputSlot::Thrust(_)
            | OutputSlot::ActuatorRate(_)
            | OutputSlot::RateLimited(_)
            | OutputSlot::PositionLimited(_) => Part::Usual,
            OutputSlot::Air(quantity) => quantity.part(),
            OutputSlot::Quaternion(_)
            | OutputSlot::Path(_)
            | OutputSlot::Placement { .. }
            | OutputSlot::LoadFactorAtCentre(_) => Part::Further,
            OutputSlot::SectionLoad { .. } => Part::SectionLoads,
            OutputSlot::Sensor(_) => Part::Sensors,
            OutputSlot::TrimPitch
            | OutputSlot::TrimControl(_)
            | OutputSlot::TrimThrust
            | OutputSlot::TrimClimbAngle
            | OutputSlot::TrimRoll
            | OutputSlot::TrimSideslip
            | OutputSlot::TrimAngleOfAttack
            | OutputSlot::TrimTurnRate
            | OutputSlot::TrimPitchRate
            | OutputSlot::TrimLoadFactor => Part::Trim,
        }
    }

    /// Whether it is an angle that jumps by a whole turn where it passes half a turn.
    pub fn turns(self) -> bool {
        match self {
            OutputSlot::Attitude(axis) => axis != Axis::Y,
            OutputSlot::Path(PathQuantity::Track) | OutputSlot::Air(AirQuantity::AngleOfAttack) => true,
            _ => false,
        }
    }

    /// Whether it is one of the section loads, which only outputs have that were asked for them.
    pub fn is_section_load(self) -> bool {
        matches!(self, OutputSlot::SectionLoad { .. })
    }

    /// The value at an instant of a flight of the model that the slot was made for.
    pub fn get(self, instant: &Instant) -> Value {
        match self {
            OutputSlot::RateLimited(control) => {
                Value::Boolean(instant.actuators[control].holding == Holding::Rate)
            }
            OutputSlot::PositionLimited(control) => {
                Value::Boolean(instant.actuators[control].holding == Holding::Stop)
            }
            real => Value::Real(real.number(instant)),
        }
    }

    /// The value as a number; of a Boolean 1 or 0.
    pub fn number(self, instant: &Instant) -> f64 {
        let Instant { outputs, trim, .. } = instant;
        match self {
            OutputSlot::Position(axis) => outputs.position[axis.index()],
            OutputSlot::Attitude(axis) => outputs.attitude[axis.index()],
            OutputSlot::Velocity(axis) => outputs.velocity[axis.index()],
            OutputSlot::Rate(axis) => outputs.rate[axis.index()],
            OutputSlot::Acceleration(axis) => outputs.acceleration[axis.index()],
            OutputSlot::LoadFactor(axis) => outputs.load_factor[axis.index()],
            OutputSlot::Wind(axis) => outputs.wind[axis.index()],
            OutputSlot::GustPeakVelocity => outputs.gust_peak_velocity,
            OutputSlot::Quaternion(part) => outputs.quaternion[part],
            OutputSlot::AngularAcceleration(axis) => outputs.angular_acceleration[axis.index()],
            OutputSlot::LoadFactorAtCentre(axis) => outputs.load_factor_cg[axis.index()],
            OutputSlot::LiftLoadFactor => outputs.lift_load_factor,
            OutputSlot::Path(PathQuantity::ClimbAngle) => outputs.path.climb_angle,
            OutputSlot::Path(PathQuantity::Track) => outputs.path.track,
            OutputSlot::Path(PathQuantity::VerticalSpeed) => outputs.path.vertical_speed,
            OutputSlot::Placement { station, component } => {
                let placement = &outputs.placements[station];
                match component {
                    PlacementComponent::Position(axis) => placement.position[axis.index()],
                    PlacementComponent::Quaternion(part) => placement.quaternion[part],
                }
            }
            OutputSlot::Air(quantity) => quantity.of(&outputs.air),
            OutputSlot::Deflection { station, component } => {
                let deflection = &outputs.deflections[station];
                match component {
                    DeflectionComponent::Along(axis) => deflection.displacement[axis.index()],
                    DeflectionComponent::Up => 0.0 - deflection.displacement.z,
                    DeflectionComponent::Twist => deflection.twist,
                }
            }
            OutputSlot::SpecificForce { station, axis } => {
                outputs.sensors[station].specific_force[axis.index()]
            }
            OutputSlot::StationRate { station, axis } => outputs.sensors[station].rate[axis.index()],
            OutputSlot::SectionLoad { cut, component } => {
                outputs.loads.known().map_or(f64::NAN, |loads| component.of(&loads[cut]))
            }
            OutputSlot::ModalCoordinate(mode) => outputs.modal_q[mode],
            OutputSlot::ModalRate(mode) => outputs.modal_q_dot[mode],
            OutputSlot::Control(control) => outputs.controls[control],
            OutputSlot::Thrust(engine) => outputs.thrust[engine],
            OutputSlot::TrimPitch => trim.pitch,
            OutputSlot::TrimControl(role) => trim.control(role),
            OutputSlot::TrimThrust => trim.thrust,
            OutputSlot::TrimClimbAngle => trim.climb_angle,
            OutputSlot::TrimRoll => trim.roll,
            OutputSlot::TrimSideslip => trim.sideslip,
            OutputSlot::TrimAngleOfAttack => trim.angle_of_attack(),
            OutputSlot::TrimTurnRate => trim.turn_rate,
            OutputSlot::TrimPitchRate => trim.pitch_rate,
            OutputSlot::TrimLoadFactor => trim.load_factor,
            OutputSlot::ActuatorRate(control) => instant.actuators[control].rate,
            OutputSlot::Sensor(channel) => instant.sensors[channel],
            OutputSlot::RateLimited(_) | OutputSlot::PositionLimited(_) => self.get(instant).number(),
        }
    }
}

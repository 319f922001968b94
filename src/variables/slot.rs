//! Where the value of a variable lives: a typed place in the inputs, the settings or the outputs.

use crate::aircraft::TrimRole;
use crate::equations::Fidelity;
use crate::flight::{InputReference, Inputs, Settings};
use crate::plant::{ModeSelection, Outputs, TrimPoint};

use super::air_quantity::AirQuantity;
use super::load_component::LoadComponent;

/// The value of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of a Real.
    Real(f64),
    /// Of an Integer, or of an Enumeration (from 1).
    Integer(i32),
    /// Of a Boolean.
    Boolean(bool),
}

/// The enumerations of the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EnumerationType {
    /// [`Fidelity`].
    Model,
    /// [`InputReference`].
    InputReference,
    /// [`ModeSelection`].
    ModeFamily,
}

impl EnumerationType {
    /// All enumerations, in the order of the model description.
    pub const ALL: [EnumerationType; 3] =
        [EnumerationType::Model, EnumerationType::InputReference, EnumerationType::ModeFamily];

    /// Name of the type.
    pub fn name(self) -> &'static str {
        match self {
            EnumerationType::Model => "Model",
            EnumerationType::InputReference => "InputReference",
            EnumerationType::ModeFamily => "ModeFamily",
        }
    }

    /// What the type is for.
    pub fn description(self) -> &'static str {
        match self {
            EnumerationType::Model => "Fidelity level of the equations of motion",
            EnumerationType::InputReference => "Meaning of the inputs of controls and thrusts",
            EnumerationType::ModeFamily => "Families of natural modes",
        }
    }

    /// Names and descriptions of the items; the value of the first is 1.
    pub fn items(self) -> &'static [(&'static str, &'static str)] {
        match self {
            EnumerationType::Model => &LEVELS,
            EnumerationType::InputReference => {
                &[("trim", "Inputs add to the trim values"), ("absolute", "Inputs replace the trim values")]
            }
            EnumerationType::ModeFamily => {
                &[("all", "Symmetric and antisymmetric modes"), ("symmetric", "Symmetric modes only")]
            }
        }
    }
}

/// Names and descriptions of the levels of fidelity.
const LEVELS: [(&str, &str); Fidelity::ALL.len()] = {
    let mut items = [("", ""); Fidelity::ALL.len()];
    let mut item = 0;
    while item < items.len() {
        items[item] = (Fidelity::ALL[item].name(), Fidelity::ALL[item].description());
        item += 1;
    }
    items
};

/// A coordinate: x, y, z; north, east, down; or roll, pitch, yaw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x, north, roll.
    X,
    /// y, east, pitch.
    Y,
    /// z, down, yaw.
    Z,
}

impl Axis {
    /// All three.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    fn index(self) -> usize {
        self as usize
    }
}

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

/// An input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in Inputs")]
#[non_exhaustive]
pub enum InputSlot {
    /// The angle of the control with this index.
    Control(usize),
    /// Of the engine with this index.
    Thrust(usize),
    Wind(Axis),
    WindRate(Axis),
}

/// A parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in Settings")]
#[non_exhaustive]
pub enum ParameterSlot {
    InputReference,
    Model,
    Airspeed,
    Altitude,
    Heading,
    StiffnessScale,
    StructuralDamping,
    ModeFamily,
    ModeCount,
    LoadModes,
    InflowStates,
    Tolerance,
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
    /// Of the mode with this index.
    /// Section loads, which only outputs have that were asked for them.
    SectionLoad {
        /// Index of the cut.
        cut: usize,
        component: LoadComponent,
    },
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
}

/// Where the value of a variable lives. It implies the FMI causality.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Slot {
    Input(InputSlot),
    Parameter(ParameterSlot),
    Output(OutputSlot),
}

impl InputSlot {
    /// The place in the inputs. `inputs` has the controls and engines of the model that the slot was made for.
    pub fn of(self, inputs: &mut Inputs) -> &mut f64 {
        match self {
            InputSlot::Control(control) => &mut inputs.controls[control],
            InputSlot::Thrust(engine) => &mut inputs.thrust[engine],
            InputSlot::Wind(axis) => &mut inputs.wind[axis.index()],
            InputSlot::WindRate(axis) => &mut inputs.wind_rate[axis.index()],
        }
    }

    /// The value in the inputs.
    pub fn get(self, inputs: &Inputs) -> f64 {
        match self {
            InputSlot::Control(control) => inputs.controls[control],
            InputSlot::Thrust(engine) => inputs.thrust[engine],
            InputSlot::Wind(axis) => inputs.wind[axis.index()],
            InputSlot::WindRate(axis) => inputs.wind_rate[axis.index()],
        }
    }
}

impl ParameterSlot {
    /// The value in the settings.
    pub fn get(self, settings: &Settings) -> Value {
        match self {
            ParameterSlot::InputReference => Value::Integer(settings.input_reference as i32 + 1),
            ParameterSlot::Model => Value::Integer(settings.plant.fidelity as i32 + 1),
            ParameterSlot::Airspeed => Value::Real(settings.plant.airspeed),
            ParameterSlot::Altitude => Value::Real(settings.plant.altitude),
            ParameterSlot::Heading => Value::Real(settings.plant.heading),
            ParameterSlot::StiffnessScale => Value::Real(settings.plant.stiffness_scale),
            ParameterSlot::StructuralDamping => Value::Real(settings.plant.structural_damping),
            ParameterSlot::ModeFamily => Value::Integer(settings.plant.mode_selection as i32 + 1),
            ParameterSlot::ModeCount => Value::Integer(saturating(settings.plant.mode_count)),
            ParameterSlot::LoadModes => Value::Boolean(settings.plant.load_modes),
            ParameterSlot::InflowStates => Value::Integer(saturating(settings.plant.inflow_states)),
            ParameterSlot::Tolerance => Value::Real(settings.tolerance),
        }
    }

    /// Changes the setting; a value of the wrong type or outside an enumeration changes nothing.
    pub fn set(self, settings: &mut Settings, value: Value) {
        match (self, value) {
            (ParameterSlot::InputReference, Value::Integer(1)) => {
                settings.input_reference = InputReference::Trim;
            }
            (ParameterSlot::InputReference, Value::Integer(2)) => {
                settings.input_reference = InputReference::Absolute;
            }
            (ParameterSlot::Model, Value::Integer(i)) => {
                let level = usize::try_from(i).ok().and_then(|i| Fidelity::ALL.get(i.checked_sub(1)?));
                settings.plant.fidelity = level.copied().unwrap_or(settings.plant.fidelity);
            }
            (ParameterSlot::ModeFamily, Value::Integer(1)) => {
                settings.plant.mode_selection = ModeSelection::All;
            }
            (ParameterSlot::ModeFamily, Value::Integer(2)) => {
                settings.plant.mode_selection = ModeSelection::Symmetric;
            }
            (ParameterSlot::ModeCount, Value::Integer(i)) => {
                settings.plant.mode_count = usize::try_from(i).unwrap_or(settings.plant.mode_count);
            }
            (ParameterSlot::LoadModes, Value::Boolean(flag)) => settings.plant.load_modes = flag,
            (ParameterSlot::InflowStates, Value::Integer(i)) => {
                settings.plant.inflow_states = usize::try_from(i).unwrap_or(settings.plant.inflow_states);
            }
            (ParameterSlot::Airspeed, Value::Real(x)) => settings.plant.airspeed = x,
            (ParameterSlot::Altitude, Value::Real(x)) => settings.plant.altitude = x,
            (ParameterSlot::Heading, Value::Real(x)) => settings.plant.heading = x,
            (ParameterSlot::StiffnessScale, Value::Real(x)) => settings.plant.stiffness_scale = x,
            (ParameterSlot::StructuralDamping, Value::Real(x)) => settings.plant.structural_damping = x,
            (ParameterSlot::Tolerance, Value::Real(x)) => settings.tolerance = x,
            _ => {}
        }
    }
}

fn saturating(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(i32::MAX)
}

impl OutputSlot {
    /// Whether it is one of the section loads, which only outputs have that were asked for them.
    pub fn is_section_load(self) -> bool {
        matches!(self, OutputSlot::SectionLoad { .. })
    }

    /// The value in the outputs of the model that the slot was made for; not a number where they have it not.
    pub fn get(self, outputs: &Outputs, trim: &TrimPoint) -> f64 {
        match self {
            OutputSlot::Position(axis) => outputs.position[axis.index()],
            OutputSlot::Attitude(axis) => outputs.attitude[axis.index()],
            OutputSlot::Velocity(axis) => outputs.velocity[axis.index()],
            OutputSlot::Rate(axis) => outputs.rate[axis.index()],
            OutputSlot::Acceleration(axis) => outputs.acceleration[axis.index()],
            OutputSlot::LoadFactor(axis) => outputs.load_factor[axis.index()],
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
        }
    }
}

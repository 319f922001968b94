//! Where the value of a variable lives: a typed place in the inputs, the settings or the outputs.

use crate::devices::{ActuatorSetting, EngineSetting};
use crate::equations::Fidelity;
use crate::flight::{InputReference, Inputs, NoiseKind, SensorSettings, Settings};
use crate::plant::ModeSelection;

use super::axis::Axis;
use super::condition_slot::ConditionSetting;
use super::gust_slot::{GustSetting, TurbulenceSetting};
use super::output_slot::OutputSlot;
use super::value::Value;

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
    TemperatureOffset,
    Heading,
    StiffnessScale,
    StructuralDamping,
    ModeFamily,
    ModeCount,
    LoadModes,
    InflowStates,
    Tolerance,
    Actuator {
        /// Index of its control.
        control: usize,
        setting: ActuatorSetting,
    },
    Engine {
        /// Its index.
        engine: usize,
        setting: EngineSetting,
    },
    Sensor(SensorSetting),
    Condition(ConditionSetting),
    Gust(GustSetting),
    Turbulence(TurbulenceSetting),
}

/// A parameter of the sensors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in SensorSettings")]
pub enum SensorSetting {
    Enabled,
    Period,
    TimeConstant,
    Delay,
    Noise(NoiseKind),
    Seed,
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
            ParameterSlot::TemperatureOffset => Value::Real(settings.plant.temperature_offset),
            ParameterSlot::Heading => Value::Real(settings.plant.heading),
            ParameterSlot::StiffnessScale => Value::Real(settings.plant.stiffness_scale),
            ParameterSlot::StructuralDamping => Value::Real(settings.plant.structural_damping),
            ParameterSlot::ModeFamily => Value::Integer(settings.plant.mode_selection as i32 + 1),
            ParameterSlot::ModeCount => Value::Integer(saturating(settings.plant.mode_count)),
            ParameterSlot::LoadModes => Value::Boolean(settings.plant.load_modes),
            ParameterSlot::InflowStates => Value::Integer(saturating(settings.plant.inflow_states)),
            ParameterSlot::Tolerance => Value::Real(settings.tolerance),
            ParameterSlot::Actuator { control, setting } => {
                Value::Real(*setting.of(&mut settings.actuators.get(control)))
            }
            ParameterSlot::Engine { engine, setting } => {
                Value::Real(*setting.of(&mut settings.engines.get(engine)))
            }
            ParameterSlot::Sensor(setting) => setting.get(&settings.sensors),
            ParameterSlot::Condition(setting) => setting.get(&settings.plant.condition),
            ParameterSlot::Gust(setting) => setting.get(&settings.gust),
            ParameterSlot::Turbulence(setting) => setting.get(&settings.turbulence),
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
            (ParameterSlot::TemperatureOffset, Value::Real(x)) => settings.plant.temperature_offset = x,
            (ParameterSlot::Heading, Value::Real(x)) => settings.plant.heading = x,
            (ParameterSlot::StiffnessScale, Value::Real(x)) => settings.plant.stiffness_scale = x,
            (ParameterSlot::StructuralDamping, Value::Real(x)) => settings.plant.structural_damping = x,
            (ParameterSlot::Tolerance, Value::Real(x)) => settings.tolerance = x,
            (ParameterSlot::Actuator { control, setting }, Value::Real(x)) => {
                let mut actuator = settings.actuators.get(control);
                *setting.of(&mut actuator) = x;
                settings.actuators.set(control, actuator);
            }
            (ParameterSlot::Engine { engine, setting }, Value::Real(x)) => {
                let mut lag = settings.engines.get(engine);
                *setting.of(&mut lag) = x;
                settings.engines.set(engine, lag);
            }
            (ParameterSlot::Sensor(setting), value) => setting.set(&mut settings.sensors, value),
            (ParameterSlot::Condition(setting), value) => setting.set(&mut settings.plant.condition, value),
            (ParameterSlot::Gust(setting), value) => setting.set(&mut settings.gust, value),
            (ParameterSlot::Turbulence(setting), value) => setting.set(&mut settings.turbulence, value),
            _ => {}
        }
    }
}

impl SensorSetting {
    fn get(self, sensors: &SensorSettings) -> Value {
        match self {
            SensorSetting::Enabled => Value::Boolean(sensors.enabled),
            SensorSetting::Period => Value::Real(sensors.period),
            SensorSetting::TimeConstant => Value::Real(sensors.time_constant),
            SensorSetting::Delay => Value::Integer(saturating(sensors.delay)),
            SensorSetting::Noise(kind) => Value::Real(sensors.noise[kind as usize]),
            SensorSetting::Seed => Value::Integer(i32::try_from(sensors.seed).unwrap_or(i32::MAX)),
        }
    }

    fn set(self, sensors: &mut SensorSettings, value: Value) {
        match (self, value) {
            (SensorSetting::Enabled, Value::Boolean(flag)) => sensors.enabled = flag,
            (SensorSetting::Period, Value::Real(x)) => sensors.period = x,
            (SensorSetting::TimeConstant, Value::Real(x)) => sensors.time_constant = x,
            (SensorSetting::Delay, Value::Integer(i)) => {
                sensors.delay = usize::try_from(i).unwrap_or(sensors.delay);
            }
            (SensorSetting::Noise(kind), Value::Real(x)) => sensors.noise[kind as usize] = x,
            (SensorSetting::Seed, Value::Integer(i)) => {
                sensors.seed = u32::try_from(i).unwrap_or(sensors.seed);
            }
            _ => {}
        }
    }
}

fn saturating(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(i32::MAX)
}

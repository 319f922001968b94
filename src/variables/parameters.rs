//! The rows of parameters.

use crate::aircraft::{ALTITUDES, TEMPERATURE_OFFSETS};
use crate::devices::{ActuatorSetting, EngineSetting};
use crate::flight::{NoiseKind, SensorSettings, Settings};
use crate::plant::PlantSettings;
use crate::structure::ReducedModel;

use super::conditions;
use super::enumeration::EnumerationType;
use super::gusts;
use super::row::parameter;
use super::slot::{ParameterSlot, SensorSetting, Slot};
use super::unit::Unit;
use super::variable::{Type, Variable};

/// All parameters of an aircraft, and where they start.
pub(super) fn parameters(model: &ReducedModel, start: &Settings) -> Vec<Variable> {
    use ParameterSlot as P;
    let airspeeds = model.support.airspeeds();
    let choice = |name, slot, kind: EnumerationType, text| {
        Variable { kind: Type::Enumeration(kind), ..parameter(name, slot, start, text) }
            .between(1.0, kind.items().len() as f64)
    };
    let count = |name, slot, max: usize, text| {
        Variable { kind: Type::Integer, ..parameter(name, slot, start, text) }.between(0.0, max as f64)
    };
    let real = |name, slot, unit, text| Variable { unit: Some(unit), ..parameter(name, slot, start, text) };
    let rows = vec![
        choice(
            "input_reference",
            P::InputReference,
            EnumerationType::InputReference,
            "Whether the inputs of controls and thrusts add to the trim values or replace them",
        ),
        choice("model", P::Model, EnumerationType::Model, "Fidelity level"),
        real(
            "airspeed",
            P::Airspeed,
            Unit::MetrePerSecond,
            "True airspeed of the trimmed flight at the start",
        )
        .between(*airspeeds.start(), *airspeeds.end()),
        real("altitude", P::Altitude, Unit::Metre, "Altitude of the trimmed flight at the start")
            .between(*ALTITUDES.start(), *ALTITUDES.end())
            .nominal(10_000.0),
        real(
            "temperature_offset",
            P::TemperatureOffset,
            Unit::Kelvin,
            "By how much the air is warmer than the standard atmosphere, at the same pressure",
        )
        .between(*TEMPERATURE_OFFSETS.start(), *TEMPERATURE_OFFSETS.end()),
        real("heading", P::Heading, Unit::Radian, "Initial yaw angle"),
        real("stiffness_scale", P::StiffnessScale, Unit::One, "Factor on all elastic properties")
            .at_least(1e-6),
        real("structural_damping", P::StructuralDamping, Unit::One, "Modal damping ratio of every mode")
            .at_least(0.0),
        choice("mode_family", P::ModeFamily, EnumerationType::ModeFamily, "Families of modes that take part"),
        count(
            "mode_count",
            P::ModeCount,
            model.natural_modes(),
            "Number of natural modes that take part, lowest first; of mirrored pairs both do",
        ),
        Variable {
            kind: Type::Boolean,
            ..parameter(
                "load_modes",
                P::LoadModes,
                start,
                "Whether the load modes that belong to those natural modes take part too",
            )
        },
        count(
            "inflow_states",
            P::InflowStates,
            PlantSettings::MOST_INFLOW_STATES,
            "Peters inflow states per strip; 0 is steady aerodynamics",
        ),
        real("tolerance", P::Tolerance, Unit::One, "Relative tolerance of the internal integrator")
            .between(1e-12, 0.1),
    ];
    let is_there = |row: &Variable| match row.slot {
        Slot::Parameter(P::Altitude | P::TemperatureOffset) => model.tunnel_air.is_none(),
        Slot::Parameter(P::LoadModes) => model.has_load_modes(),
        _ => true,
    };
    let mut rows: Vec<Variable> = rows.into_iter().filter(is_there).collect();
    rows.extend(actuators(model, start));
    rows.extend(engines(model, start));
    rows.extend(sensors(start));
    rows.extend(gusts::parameters(start));
    rows.extend(conditions::parameters(model, start));
    rows
}

/// Of the actuator of each control.
fn actuators(model: &ReducedModel, start: &Settings) -> Vec<Variable> {
    let row = |control: usize, name: &str, setting: ActuatorSetting| {
        let (unit, text) = match setting {
            ActuatorSetting::Frequency => (
                Unit::RadianPerSecond,
                "Natural frequency of the actuator; 0: none, the surface is the command",
            ),
            ActuatorSetting::Damping => (Unit::One, "Damping ratio of the actuator"),
            ActuatorSetting::RateLimit => {
                (Unit::RadianPerSecond, "Largest rate of the surface, where it lags; 1e9: none")
            }
            ActuatorSetting::Minimum => {
                (Unit::Radian, "Lower stop; -1e9: none; without a frequency of the command")
            }
            ActuatorSetting::Maximum => {
                (Unit::Radian, "Upper stop; 1e9: none; without a frequency of the command")
            }
        };
        let ([least, most], _) = setting.range();
        let slot = ParameterSlot::Actuator { control, setting };
        let name = format!("actuator.{name}.{}", setting.name());
        let min_beside_none = setting.least_beside_none();
        Variable { unit: Some(unit), min_beside_none, ..parameter(name, slot, start, text) }
            .between(least, most)
    };
    let controls = model.controls.iter().enumerate();
    controls
        .flat_map(|(i, control)| ActuatorSetting::ALL.map(|setting| row(i, &control.name, setting)))
        .collect()
}

/// Of each engine.
fn engines(model: &ReducedModel, start: &Settings) -> Vec<Variable> {
    let row = |engine: usize, name: &str, setting: EngineSetting| {
        let (unit, text) = match setting {
            EngineSetting::TimeConstant => {
                (Unit::Second, "Time constant of the thrust behind its command; 0: none")
            }
            EngineSetting::Minimum => (Unit::Newton, "Lower limit of the thrust's command; -1e9: none"),
            EngineSetting::Maximum => (Unit::Newton, "Upper limit of the thrust's command; 1e9: none"),
        };
        let ([least, most], _) = setting.range();
        let slot = ParameterSlot::Engine { engine, setting };
        let name = format!("engine.{name}.{}", setting.name());
        Variable { unit: Some(unit), ..parameter(name, slot, start, text) }.between(least, most)
    };
    let engines = model.engines.iter().enumerate();
    engines.flat_map(|(i, engine)| EngineSetting::ALL.map(|setting| row(i, &engine.name, setting))).collect()
}

/// Of the sensors.
fn sensors(start: &Settings) -> Vec<Variable> {
    let row = |name: &str, setting, kind, unit, text: &str| Variable {
        kind,
        unit,
        ..parameter(format!("sensor.{name}"), ParameterSlot::Sensor(setting), start, text)
    };
    let between =
        |range: std::ops::RangeInclusive<f64>, row: Variable| row.between(*range.start(), *range.end());
    let mut rows = vec![
        row(
            "enabled",
            SensorSetting::Enabled,
            Type::Boolean,
            None,
            "Whether sensor.* are sampled; otherwise they are the outputs that they mirror",
        ),
        between(
            SensorSettings::PERIODS,
            row(
                "period",
                SensorSetting::Period,
                Type::Real,
                Some(Unit::Second),
                "From one sample to the next, a multiple of 0.01 s",
            ),
        ),
        between(
            SensorSettings::TIME_CONSTANTS,
            row(
                "time_constant",
                SensorSetting::TimeConstant,
                Type::Real,
                Some(Unit::Second),
                "Lag of the sensors",
            ),
        ),
        row("delay", SensorSetting::Delay, Type::Integer, None, "Samples by which the sensors are late")
            .between(*SensorSettings::DELAYS.start() as f64, *SensorSettings::DELAYS.end() as f64),
    ];
    for kind in NoiseKind::ALL {
        let (unit, text) = match kind {
            NoiseKind::Attitude => (Unit::Radian, "attitude angles"),
            NoiseKind::Rate => (Unit::RadianPerSecond, "angular rates, of rate gyros at stations too"),
            NoiseKind::LoadFactor => (Unit::One, "load factors"),
            NoiseKind::SpecificForce => (Unit::MetrePerSecondSquared, "accelerometers at stations"),
            NoiseKind::AirAngle => (Unit::Radian, "angle of attack and sideslip"),
            NoiseKind::AirSpeed => (Unit::MetrePerSecond, "the airspeed"),
            NoiseKind::Position => (Unit::Metre, "the position"),
        };
        let (name, text) = (format!("noise.{}", kind.name()), format!("Rms of the noise of {text}"));
        let row = row(&name, SensorSetting::Noise(kind), Type::Real, Some(unit), &text);
        rows.push(between(SensorSettings::NOISES, row));
    }
    rows.push(
        row("seed", SensorSetting::Seed, Type::Integer, None, "Of all noise; other seeds, other noise")
            .between(0.0, f64::from(i32::MAX)),
    );
    rows
}

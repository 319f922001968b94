//! Which numbers describe actuators and engines, by the names and within the ranges that users have.

use super::actuator::Actuator;
use super::command::LIMITLESS;
use super::engine_lag::EngineLag;

/// A number of an [`Actuator`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the numbers are documented in Actuator")]
pub enum ActuatorSetting {
    Frequency,
    Damping,
    RateLimit,
    Minimum,
    Maximum,
}

/// A number of an [`EngineLag`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the numbers are documented in EngineLag")]
pub enum EngineSetting {
    TimeConstant,
    Minimum,
    Maximum,
}

impl ActuatorSetting {
    /// All of them.
    pub const ALL: [ActuatorSetting; 5] = [
        ActuatorSetting::Frequency,
        ActuatorSetting::Damping,
        ActuatorSetting::RateLimit,
        ActuatorSetting::Minimum,
        ActuatorSetting::Maximum,
    ];

    /// As the last part of a parameter's name.
    pub fn name(self) -> &'static str {
        match self {
            ActuatorSetting::Frequency => "frequency",
            ActuatorSetting::Damping => "damping",
            ActuatorSetting::RateLimit => "rate_limit",
            ActuatorSetting::Minimum => "minimum",
            ActuatorSetting::Maximum => "maximum",
        }
    }

    /// What is allowed, from … to, and its unit.
    pub fn range(self) -> ([f64; 2], &'static str) {
        match self {
            // Beyond, one could as well have none: ten radians of it pass in a cell of 10 ms.
            ActuatorSetting::Frequency => ([0.0, 1000.0], "rad/s"),
            ActuatorSetting::Damping => ([0.0, 100.0], "1"),
            ActuatorSetting::RateLimit => ([1e-6, LIMITLESS], "rad/s"),
            ActuatorSetting::Minimum | ActuatorSetting::Maximum => ([-LIMITLESS, LIMITLESS], "rad"),
        }
    }

    /// Where 0 stands for none: the least value beside it. Closed forms divide by it.
    pub fn least_beside_none(self) -> Option<f64> {
        (self == ActuatorSetting::Frequency).then_some(1e-3)
    }

    /// The number.
    pub fn of(self, actuator: &mut Actuator) -> &mut f64 {
        match self {
            ActuatorSetting::Frequency => &mut actuator.frequency,
            ActuatorSetting::Damping => &mut actuator.damping,
            ActuatorSetting::RateLimit => &mut actuator.rate_limit,
            ActuatorSetting::Minimum => &mut actuator.minimum,
            ActuatorSetting::Maximum => &mut actuator.maximum,
        }
    }
}

impl EngineSetting {
    /// All of them.
    pub const ALL: [EngineSetting; 3] =
        [EngineSetting::TimeConstant, EngineSetting::Minimum, EngineSetting::Maximum];

    /// As the last part of a parameter's name.
    pub fn name(self) -> &'static str {
        match self {
            EngineSetting::TimeConstant => "time_constant",
            EngineSetting::Minimum => "minimum",
            EngineSetting::Maximum => "maximum",
        }
    }

    /// What is allowed, from … to, and its unit.
    pub fn range(self) -> ([f64; 2], &'static str) {
        match self {
            EngineSetting::TimeConstant => ([0.0, 1e4], "s"),
            EngineSetting::Minimum | EngineSetting::Maximum => ([-LIMITLESS, LIMITLESS], "N"),
        }
    }

    /// The number.
    pub fn of(self, engine: &mut EngineLag) -> &mut f64 {
        match self {
            EngineSetting::TimeConstant => &mut engine.time_constant,
            EngineSetting::Minimum => &mut engine.minimum,
            EngineSetting::Maximum => &mut engine.maximum,
        }
    }
}

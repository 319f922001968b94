//! What stands between a computer and the aircraft: actuators, engines that lag, sampled sensors.
//!
//! [theory: actuators.command, actuators.motion, actuators.engines, sensors.lag, sensors.turns, sensors.noise]
//!
//! Each is a function of what it is given and of time; none sees the flight.

mod actuator;
mod command;
mod engine_lag;
mod noise;
mod sampling;
mod settings;
mod swing;

pub use actuator::{Actuator, Holding, Surface};
pub use command::{Command, LIMITLESS};
pub use engine_lag::EngineLag;
pub use noise::Noise;
pub use sampling::{Input, Samples, Sampling, within_half_a_turn};
pub use settings::{ActuatorSetting, EngineSetting};

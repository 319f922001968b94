//! All that is read of a flight at an instant: outputs of the plant, and of what stands between it and a computer.

use crate::plant::{Outputs, TrimPoint};

use super::acting::{Acting, ActuatorReading};
use super::moment::Moment;
use super::sensors::Sensors;
use super::steering::Steering;

/// What is read of a flight at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Of the aircraft.
    pub outputs: Outputs,
    /// With which the flight began.
    pub trim: TrimPoint,
    /// One per control.
    pub actuators: Vec<ActuatorReading>,
    /// One per [`Channel`](super::Channel), in its unit.
    pub sensors: Vec<f64>,
}

/// How much of what is read is that of the present under the present inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Freshness {
    /// Nothing.
    Stale,
    /// What control laws read at every step.
    Usual,
    /// Everything but section loads, which tell themselves.
    Complete,
}

impl Instant {
    /// Of these outputs, everything else at rest, with so many channels of sensors.
    pub(super) fn new(outputs: Outputs, trim: TrimPoint, channels: usize) -> Self {
        let actuators = vec![ActuatorReading::AT_REST; outputs.controls.len()];
        Instant { outputs, trim, actuators, sensors: vec![0.0; channels] }
    }

    /// Writes what actuators and sensors do at a time, beside the outputs at that time.
    pub(super) fn write_devices(
        &mut self,
        time: Moment,
        (steering, acting): (&Steering, &Acting),
        sensors: &Sensors,
    ) {
        self.write_actuators(time, steering, acting);
        self.write_sensors(time, sensors);
    }

    /// Of them the actuators.
    pub(super) fn write_actuators(&mut self, time: Moment, steering: &Steering, acting: &Acting) {
        steering.write_actuators(time, acting, &mut self.actuators);
    }

    /// Of them the sensors.
    pub(super) fn write_sensors(&mut self, time: Moment, sensors: &Sensors) {
        sensors.write(time, &self.outputs, &mut self.sensors);
    }
}

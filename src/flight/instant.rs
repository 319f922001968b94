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

/// A part of what is read at an instant, by the work that it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Known since the beginning.
    Trim,
    /// What control laws read at every step.
    Usual,
    /// Path, placements of stations, quaternions, the load factor at the centre of mass, the calibrated airspeed.
    Further,
    /// The channels of sensors.
    Sensors,
    /// At the cuts.
    SectionLoads,
}

/// Some parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    pub(super) usual: bool,
    pub(super) further: bool,
    pub(super) sensors: bool,
    pub(super) section_loads: bool,
}

/// How much of what is read is that of the present under the present inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Freshness {
    /// Nothing.
    Stale,
    /// These parts, but for section loads, which tell themselves.
    Of(Parts),
}

impl Parts {
    /// The outputs of the aircraft without section loads.
    pub(super) const OUTPUTS: Parts =
        Parts { usual: true, further: true, sensors: false, section_loads: false };
    /// All but section loads.
    pub(super) const INSTANT: Parts = Parts { sensors: true, ..Parts::OUTPUTS };

    /// These and one more.
    pub fn and(mut self, part: Part) -> Self {
        match part {
            Part::Trim => {}
            Part::Usual => self.usual = true,
            Part::Further => self.further = true,
            Part::Sensors => self.sensors = true,
            Part::SectionLoads => self.section_loads = true,
        }
        self
    }
}

impl Parts {
    /// Whether any of it is written from outputs of the plant.
    pub(super) fn needs_outputs(self) -> bool {
        self.usual || self.further || self.sensors || self.section_loads
    }
}

impl FromIterator<Part> for Parts {
    fn from_iter<I: IntoIterator<Item = Part>>(parts: I) -> Self {
        parts.into_iter().fold(Parts::default(), Parts::and)
    }
}

impl From<Part> for Parts {
    fn from(part: Part) -> Self {
        Parts::default().and(part)
    }
}

impl Freshness {
    /// The parts that are fresh, section loads aside.
    pub fn parts(self) -> Parts {
        match self {
            Freshness::Stale => Parts::default(),
            Freshness::Of(parts) => parts,
        }
    }
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

//! The rows of what actuators do and what sensors give.

use crate::flight::Channel;
use crate::structure::ReducedModel;

use super::output_slot::OutputSlot;
use super::row::output;
use super::slot::Slot;
use super::unit::Unit;
use super::variable::{Type, Variability, Variable};

/// Of the actuator of each control.
pub(super) fn actuators(model: &ReducedModel) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (i, control) in model.controls.iter().enumerate() {
        let name = &control.name;
        let flag = |suffix: &str, slot, text: &str| {
            let row = output(format!("actuator.{name}.{suffix}"), None, slot, text.to_owned());
            Variable { kind: Type::Boolean, variability: Variability::Discrete, ..row }
        };
        rows.extend([
            output(
                format!("actuator.{name}.rate"),
                Unit::RadianPerSecond,
                OutputSlot::ActuatorRate(i),
                format!("Rate of surface.{name}"),
            ),
            flag("rate_limited", OutputSlot::RateLimited(i), "Whether the surface moves as fast as it can"),
            flag("position_limited", OutputSlot::PositionLimited(i), "Whether a stop holds the surface"),
        ]);
    }
    rows
}

/// Of each channel of the sensors, of the unit and the range of the output that it mirrors; noise knows no range.
pub(super) fn sensor_channels(model: &ReducedModel, outputs: &[Variable]) -> Vec<Variable> {
    let mut rows = Vec::new();
    for (i, channel) in Channel::of(model).iter().enumerate() {
        let mirrored = outputs.iter().find(|row| row.name == channel.mirrored);
        rows.extend(mirrored.map(|mirrored| Variable {
            name: channel.name(),
            description: format!("{}, as its sensor gives it", mirrored.description),
            min: None,
            max: None,
            slot: Slot::Output(OutputSlot::Sensor(i)),
            ..mirrored.clone()
        }));
    }
    rows
}

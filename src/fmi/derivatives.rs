//! Directional derivatives: how the outputs at an instant change with the inputs, the states held, and at the initialisation
//! with the parameters too, the trim following.
//!
//! Inputs act on the outputs of an instant through forces and the flow at O, parameters through the trim; all that is smooth
//! and most of it linear, so that central differences of fourth order over small changes are exact to rounding.
//!
//! [theory: trim.tangent]

use std::f64::consts::TAU;

use crate::devices::{ActuatorSetting, EngineSetting};
use crate::flight::{Instant, Neighbours};
use crate::math::{WIDTHS, slope};
use crate::plant::PlantSettings;
use crate::variables::{
    GustSetting, InputSlot, OutputSlot, ParameterSlot, Place, SensorSetting, Slot, Value,
};

use super::instance::Instance;
use super::interface::Kind;
use super::life_cycle::State;
use super::refusal::Refusal;
use super::values::{Numbers, ValueReference};

/// Changes over which the outputs bend little, yet far beyond rounding: rad, N, m/s, m/s², m, K, rad, parts of the parameter.
const CONTROL_CHANGE: f64 = 0.01;
const THRUST_CHANGE: f64 = 1000.0;
const WIND_CHANGE: f64 = 0.1;
const WIND_RATE_CHANGE: f64 = 1.0;
const ALTITUDE_CHANGE: f64 = 1.0;
const TEMPERATURE_CHANGE: f64 = 0.1;
const HEADING_CHANGE: f64 = 1e-3;
const SHARE_CHANGED: f64 = 1e-3;
/// What is added is linear in its rms, and at most 8.6 times as much: so much of it moves no angle by half a turn.
const NOISE_CHANGE: f64 = 0.1;
const GUST_CHANGE: f64 = 0.1;
const ALLEVIATION_CHANGE: f64 = 1e-3;

/// The values of some outputs at [`WIDTHS`] of a change.
pub(super) type Sample = [Vec<f64>; 4];

impl Instance {
    /// The changes of unknowns along a direction of knowns: of outputs by inputs and, in initialisation mode, parameters; of
    /// model exchange of outputs and rates by states and inputs.
    pub fn derivatives(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        direction: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        match self.interface.kind {
            Kind::CoSimulation => self.flight_derivatives(unknowns, knowns, direction),
            Kind::ModelExchange => self.exchange_derivatives(unknowns, knowns, direction),
        }
    }

    /// The changes of the unknown outputs along a direction of known inputs and, in
    /// initialisation mode, parameters.
    pub(super) fn flight_derivatives(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        direction: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let outputs = unknowns.iter().map(|unknown| self.output(*unknown)).collect::<Result<Vec<_>, _>>()?;
        let (mut inputs, mut parameters) = (Vec::new(), Vec::new());
        for (known, &component) in knowns.iter().zip(direction) {
            match self.known(*known, component)? {
                Slot::Input(slot) => inputs.push((slot, component)),
                Slot::Parameter(slot) => parameters.push((slot, component)),
                Slot::Output(_) => {}
            }
        }
        self.flight()?;
        let mut derivatives = vec![0.0; outputs.len()];
        let turns: Vec<bool> =
            outputs.iter().map(|output| self.table.common().mirrored(*output).turns()).collect();
        // How many times as long the direction is as the usual change.
        let length = longest(inputs.iter().map(|(slot, component)| component / usual_change(*slot)));
        if length > 0.0 {
            let sample = self.sample_inputs(&outputs, &inputs, 1.0 / length)?;
            add_slopes(&mut derivatives, &turns, &sample, length);
        }
        let share = |(slot, component): &(ParameterSlot, f64)| component / self.usual_change(*slot);
        let length = longest(parameters.iter().map(share));
        if length > 0.0 {
            let sample = self.sample_parameters(&outputs, &parameters, 1.0 / length)?;
            add_slopes(&mut derivatives, &turns, &sample, length);
        }
        if derivatives.iter().all(|derivative| derivative.is_finite()) {
            Ok(derivatives)
        } else {
            Err(Refusal::error(format!("the derivatives are not finite at t = {} s", self.time)))
        }
    }

    /// The outputs while the inputs change by some widths of their components.
    fn sample_inputs(
        &mut self,
        outputs: &[OutputSlot],
        components: &[(InputSlot, f64)],
        scale: f64,
    ) -> Result<Sample, Refusal> {
        let (inputs, rates) = (self.inputs.clone(), self.rates.clone());
        let flight = self.flight()?;
        Ok(WIDTHS.map(|width| {
            let mut changed = inputs.clone();
            for (slot, component) in components {
                *slot.of(&mut changed) += width * scale * component;
            }
            let around = if want_loads(outputs) {
                flight.instant_with_loads_under(&changed, &rates)
            } else {
                flight.instant_under(&changed, &rates)
            };
            values(outputs, &around)
        }))
    }

    /// The outputs at the initialisation while the parameters change by some widths of their components.
    fn sample_parameters(
        &mut self,
        outputs: &[OutputSlot],
        components: &[(ParameterSlot, f64)],
        scale: f64,
    ) -> Result<Sample, Refusal> {
        let changed = WIDTHS.map(|width| {
            let mut settings = self.settings.clone();
            for (slot, component) in components {
                if let Value::Real(value) = slot.get(&settings) {
                    let reach = scale * component.abs();
                    // No tunnel blows backwards: from still air on the change is taken ahead.
                    let is_still = *slot == ParameterSlot::Airspeed && value < reach;
                    let middle = if is_still { value + reach } else { value };
                    slot.set(&mut settings, Value::Real(middle + width * scale * component));
                }
            }
            settings
        });
        let kept = self.neighbours.take().filter(|neighbours| neighbours.are_around(&self.settings));
        let neighbours = match kept {
            Some(neighbours) => neighbours,
            None => {
                let settings = self.settings.clone();
                Neighbours::new(self.flight()?, &settings)
            }
        };
        let around = self.neighbours.insert(neighbours).outputs(
            &changed,
            (&self.inputs, &self.rates),
            want_loads(outputs),
        );
        let sample = around.map(|around| around.map(|instant| values(outputs, &instant)));
        sample.ok_or_else(|| Refusal::error("the trim does not depend smoothly on these parameters"))
    }

    fn output(&self, reference: ValueReference) -> Result<OutputSlot, Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        match variable.slot {
            Place::Common(Slot::Output(slot)) => Ok(slot),
            _ => Err(Refusal::error(format!("`{}` is not an output: it has no derivatives", variable.name))),
        }
    }

    /// The place of a variable by which there are derivatives now.
    fn known(&self, reference: ValueReference, component: f64) -> Result<Slot, Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        let Place::Common(slot) = variable.slot else {
            return Err(Refusal::error(format!("`{}`: there are no derivatives by it", variable.name)));
        };
        let reason = match slot {
            Slot::Output(_) => {
                "is neither an input nor a parameter: there are no derivatives by it".to_owned()
            }
            Slot::Parameter(_) if self.state != State::InitializationMode => {
                "is a fixed parameter, not an input: there are derivatives by it only in initialisation mode"
                    .to_owned()
            }
            Slot::Parameter(ParameterSlot::Condition(_)) => {
                "is part of the flight condition: there are derivatives by airspeed, altitude, temperature_offset and heading, and none by it".to_owned()
            }
            _ if !component.is_finite() => {
                format!("has the component {component} in the direction, allowed are finite numbers")
            }
            slot => return Ok(slot),
        };
        Err(Refusal::error(format!("`{}` {reason}", variable.name)))
    }

    /// A change of a parameter, without end where nothing depends on it.
    fn usual_change(&self, parameter: ParameterSlot) -> f64 {
        let PlantSettings { airspeed, stiffness_scale, .. } = self.settings.plant;
        match parameter {
            ParameterSlot::Airspeed => SHARE_CHANGED * airspeed.max(1.0),
            ParameterSlot::Altitude => ALTITUDE_CHANGE,
            ParameterSlot::TemperatureOffset => TEMPERATURE_CHANGE,
            ParameterSlot::Heading => HEADING_CHANGE,
            ParameterSlot::StiffnessScale => SHARE_CHANGED * stiffness_scale,
            ParameterSlot::Actuator {
                setting: ActuatorSetting::Minimum | ActuatorSetting::Maximum, ..
            } => CONTROL_CHANGE,
            ParameterSlot::Engine { setting: EngineSetting::Minimum | EngineSetting::Maximum, .. } => {
                THRUST_CHANGE
            }
            ParameterSlot::Sensor(SensorSetting::Noise(_)) => NOISE_CHANGE,
            ParameterSlot::Gust(GustSetting::Peak | GustSetting::Gradient) => GUST_CHANGE,
            ParameterSlot::Gust(GustSetting::Alleviation) => ALLEVIATION_CHANGE,
            ParameterSlot::Gust(GustSetting::MaximumOperatingAltitude) => ALTITUDE_CHANGE,
            ParameterSlot::StructuralDamping
            | ParameterSlot::Tolerance
            | ParameterSlot::InputReference
            | ParameterSlot::Model
            | ParameterSlot::ModeFamily
            | ParameterSlot::ModeCount
            | ParameterSlot::LoadModes
            | ParameterSlot::Actuator { .. }
            | ParameterSlot::Engine { .. }
            | ParameterSlot::Sensor(_)
            // Gust and turbulence are still ahead.
            | ParameterSlot::Gust(_)
            | ParameterSlot::Condition(_)
            | ParameterSlot::Turbulence(_)
            | ParameterSlot::InflowStates => f64::INFINITY,
        }
    }
}

/// A change of an input.
pub(super) fn usual_change(input: InputSlot) -> f64 {
    match input {
        InputSlot::Control(_) => CONTROL_CHANGE,
        InputSlot::Thrust(_) => THRUST_CHANGE,
        InputSlot::Wind(_) => WIND_CHANGE,
        InputSlot::WindRate(_) => WIND_RATE_CHANGE,
    }
}

/// Whether some outputs are section loads.
fn want_loads(outputs: &[OutputSlot]) -> bool {
    outputs.iter().any(|slot| slot.is_section_load())
}

/// The values of some outputs.
fn values(outputs: &[OutputSlot], instant: &Instant) -> Vec<f64> {
    outputs.iter().map(|slot| slot.number(instant)).collect()
}

pub(super) fn longest(lengths: impl Iterator<Item = f64>) -> f64 {
    lengths.fold(0.0, |longest, length| longest.max(length.abs()))
}

/// Adds the derivatives of outputs, some of them angles that jump by whole turns, along a direction that is so many times as
/// long as the change that was sampled.
pub(super) fn add_slopes(derivatives: &mut [f64], turns: &[bool], sample: &Sample, length: f64) {
    for (place, (derivative, turns)) in derivatives.iter_mut().zip(turns).enumerate() {
        let values = sample.each_ref().map(|values| values[place]);
        *derivative += length * slope(if *turns { without_jumps(values) } else { values });
    }
}

/// Values of an angle without its jumps by a whole turn.
fn without_jumps(angles: [f64; 4]) -> [f64; 4] {
    angles.map(|angle| angles[0] + libm::remainder(angle - angles[0], TAU))
}

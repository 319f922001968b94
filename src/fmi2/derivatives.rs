//! Directional derivatives: how the outputs at an instant change with the inputs, the states held.
//!
//! Between a state and its outputs the inputs act through forces and the flow at O, all smooth and most of them
//! linear, so central differences with two widths (Richardson's extrapolation) are exact to rounding.

use super::instance::{Instance, Refusal};
use super::types::ValueReference;
use super::values::Family;
use crate::simulation::Inputs;
use crate::variables::{InputSlot, OutputSlot, Slot};

/// Shifts of the inputs over which the outputs bend little, yet far beyond rounding: rad, N, m/s, m/s².
const SURFACE_SHIFT: f64 = 0.01;
const THRUST_SHIFT: f64 = 1000.0;
const WIND_SHIFT: f64 = 0.1;
const WIND_RATE_SHIFT: f64 = 1.0;

impl Instance {
    /// `fmi2GetDirectionalDerivative`: the changes of the unknown outputs along a direction of known inputs.
    pub fn derivatives(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        direction: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let outputs = unknowns.iter().map(|unknown| self.output(*unknown)).collect::<Result<Vec<_>, _>>()?;
        let mut change = Inputs::zero(self.model.engines.len());
        let mut largest = 0.0_f64;
        for (known, component) in knowns.iter().zip(direction) {
            let slot = self.input(*known)?;
            if !component.is_finite() {
                let name = &self.variable(*known, Family::Real)?.name;
                return Err(Refusal::error(format!(
                    "`{name}`: found the change {component}, allowed are finite ones"
                )));
            }
            *slot.of(&mut change) += component;
            largest = largest.max((slot.of(&mut change).abs()) / usual_shift(slot));
        }
        self.flight()?;
        if largest == 0.0 {
            return Ok(vec![0.0; outputs.len()]);
        }
        let wide = self.central_differences(&outputs, &change, 1.0 / largest)?;
        let narrow = self.central_differences(&outputs, &change, 0.5 / largest)?;
        let extrapolated: Vec<f64> =
            narrow.iter().zip(wide).map(|(narrow, wide)| (4.0 * narrow - wide) / 3.0).collect();
        if extrapolated.iter().all(|derivative| derivative.is_finite()) {
            Ok(extrapolated)
        } else {
            Err(Refusal::error(format!("the derivatives are not finite at t = {}", self.time)))
        }
    }

    /// (y(u + width · change) − y(u − width · change)) / (2 · width).
    fn central_differences(
        &mut self,
        outputs: &[OutputSlot],
        change: &Inputs,
        width: f64,
    ) -> Result<Vec<f64>, Refusal> {
        let ahead = self.outputs_after(outputs, change, width)?;
        let behind = self.outputs_after(outputs, change, -width)?;
        Ok(ahead.iter().zip(behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * width)).collect())
    }

    /// The outputs with the inputs shifted by width · change; computed on a copy of the flight.
    fn outputs_after(
        &mut self,
        outputs: &[OutputSlot],
        change: &Inputs,
        width: f64,
    ) -> Result<Vec<f64>, Refusal> {
        let mut shifted = self.inputs.clone();
        shifted.add(width, change);
        let mut flight = self.flight()?.clone();
        flight.set_inputs(&shifted, &self.rates);
        let trim = *flight.trim();
        let present = flight.outputs();
        Ok(outputs.iter().map(|slot| slot.get(present, &trim)).collect())
    }

    fn output(&self, reference: ValueReference) -> Result<OutputSlot, Refusal> {
        let variable = self.variable(reference, Family::Real)?;
        match variable.slot {
            Slot::Output(slot) => Ok(slot),
            _ => Err(Refusal::error(format!("`{}` is not an output: it has no derivatives", variable.name))),
        }
    }
}

fn usual_shift(input: InputSlot) -> f64 {
    match input {
        InputSlot::Elevator | InputSlot::Aileron | InputSlot::AileronSymmetric | InputSlot::Rudder => {
            SURFACE_SHIFT
        }
        InputSlot::Thrust(_) => THRUST_SHIFT,
        InputSlot::Wind(_) => WIND_SHIFT,
        InputSlot::WindRate(_) => WIND_RATE_SHIFT,
    }
}

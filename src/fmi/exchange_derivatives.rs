//! Directional derivatives of model exchange: how outputs and rates change with states and inputs, by differences as those of
//! the library's linear models [theory: linearisation.differences, continuous-model.derivatives].

use crate::flight::{ContinuousModel, Parts};
use crate::math::WIDTHS;
use crate::variables::{InputSlot, OutputSlot, Place, Slot};

use super::derivatives::{Sample, add_slopes, longest, usual_change};
use super::exchange::discard;
use super::instance::Instance;
use super::refusal::Refusal;
use super::values::{Numbers, ValueReference};

/// Whose change is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unknown {
    Output(OutputSlot),
    /// Its change is its component in the direction.
    State(usize),
    Rate(usize),
}

/// What changes, with its component in the direction.
#[derive(Clone, Debug, Default)]
struct Direction {
    states: Vec<(usize, f64)>,
    inputs: Vec<(InputSlot, f64)>,
}

impl Instance {
    /// The changes of outputs and rates along a direction of states and inputs, in any order.
    pub(super) fn exchange_derivatives(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        direction: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let unknowns =
            unknowns.iter().map(|unknown| self.unknown(*unknown)).collect::<Result<Vec<_>, _>>()?;
        let mut along = Direction::default();
        for (known, &component) in knowns.iter().zip(direction) {
            self.add_known(*known, component, &mut along)?;
        }
        let turns = |unknown: &Unknown| match unknown {
            Unknown::Output(output) => self.table.common().mirrored(*output).turns(),
            Unknown::State(_) | Unknown::Rate(_) => false,
        };
        let turns: Vec<bool> = unknowns.iter().map(turns).collect();
        let widths = self.continuous()?.widths();
        let of_states = along.states.iter().map(|(place, component)| component / widths[*place]);
        let of_inputs = along.inputs.iter().map(|(slot, component)| component / usual_change(*slot));
        // How many times as long the direction is as the usual change.
        let length = longest(of_states.chain(of_inputs));
        let mut derivatives = vec![0.0; unknowns.len()];
        if length > 0.0 {
            let sample = self.sample_around(&unknowns, &along, 1.0 / length)?;
            add_slopes(&mut derivatives, &turns, &sample, length);
        }
        for (derivative, unknown) in derivatives.iter_mut().zip(&unknowns) {
            if let Unknown::State(place) = unknown {
                let own = along.states.iter().filter(|(known, _)| known == place);
                *derivative = own.map(|(_, component)| component).sum();
            }
        }
        Ok(derivatives)
    }

    fn unknown(&self, reference: ValueReference) -> Result<Unknown, Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        match variable.slot {
            Place::Common(Slot::Output(output)) => Ok(match self.table.state_of(output, reference) {
                Some(place) => Unknown::State(place),
                None => Unknown::Output(output),
            }),
            Place::Rate(place) => Ok(Unknown::Rate(place)),
            _ => {
                let reason = "is neither an output nor the rate of a state: it has no derivatives";
                Err(Refusal::error(format!("`{}` {reason}", variable.name)))
            }
        }
    }

    fn add_known(
        &self,
        reference: ValueReference,
        component: f64,
        along: &mut Direction,
    ) -> Result<(), Refusal> {
        let variable = self.variable(reference, Numbers::Real)?;
        let name = &variable.name;
        if !component.is_finite() {
            let reason =
                format!("has the component {component} in the direction, allowed are finite numbers");
            return Err(Refusal::error(format!("`{name}` {reason}")));
        }
        match variable.slot {
            Place::Common(Slot::Input(slot)) => along.inputs.push((slot, component)),
            Place::State(place) => along.states.push((place, component)),
            Place::Common(Slot::Output(output)) => match self.table.state_of(output, reference) {
                Some(place) => along.states.push((place, component)),
                None => {
                    let reason = "is neither a state nor an input: there are no derivatives by it";
                    return Err(Refusal::error(format!("`{name}` {reason}")));
                }
            },
            Place::Common(Slot::Parameter(_)) => {
                let reason = "is a fixed parameter: derivatives by it belong to co-simulation";
                return Err(Refusal::error(format!("`{name}` {reason}")));
            }
            Place::Rate(_) | Place::Time => {
                return Err(Refusal::error(format!("`{name}`: there are no derivatives by it")));
            }
        }
        Ok(())
    }

    /// The unknowns at [`WIDTHS`] of a direction that is so many times as long; then everything is as it was.
    fn sample_around(
        &mut self,
        unknowns: &[Unknown],
        along: &Direction,
        scale: f64,
    ) -> Result<Sample, Refusal> {
        let (time, inputs) = (self.time, self.inputs.clone());
        let model = self.continuous()?;
        let values = model.values().to_vec();
        let mut sample = Sample::default();
        let mut found = Ok(());
        for (width, place) in WIDTHS.into_iter().zip(&mut sample) {
            let (mut changed_values, mut changed_inputs) = (values.clone(), inputs.clone());
            for (state, component) in &along.states {
                changed_values[*state] += width * scale * component;
            }
            for (slot, component) in &along.inputs {
                *slot.of(&mut changed_inputs) += width * scale * component;
            }
            model.set_values(&changed_values);
            model.set_inputs(&changed_inputs);
            found = found.and(read(model, unknowns, time).map(|numbers| *place = numbers));
        }
        model.set_values(&values);
        model.set_inputs(&inputs);
        found.map(|()| sample)
    }
}

/// The unknowns where a model is.
fn read(model: &mut ContinuousModel, unknowns: &[Unknown], time: f64) -> Result<Vec<f64>, Refusal> {
    let parts: Parts = unknowns
        .iter()
        .filter_map(|unknown| match unknown {
            Unknown::Output(output) => Some(output.part()),
            Unknown::State(_) | Unknown::Rate(_) => None,
        })
        .collect();
    model.evaluate(parts, time).map_err(discard)?;
    let (instant, rates, values) = model.latest();
    let number = |unknown: &Unknown| match *unknown {
        Unknown::Output(output) => output.number(instant),
        Unknown::Rate(place) => rates[place],
        Unknown::State(place) => values[place],
    };
    Ok(unknowns.iter().map(number).collect())
}

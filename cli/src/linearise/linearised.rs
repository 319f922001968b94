//! An aircraft linearised as the options ask for it: the model, its modes, and what is said of both.

use std::sync::Arc;

use flexible_aircraft::aircraft::Support;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::{LinearContents, LinearModel, flight_modes};

use crate::diagnostics;
use crate::flown::{condition, trimmed};
use crate::numbers::fixed;

use super::inputs::Chosen;
use super::modes::Modes;
use super::wake::Wake;
use super::{Error, balanced};

/// A linear model as it is written.
pub struct Linearised {
    pub linear: LinearModel,
    /// Of the aircraft itself, before any reduction.
    pub modes: Modes,
    /// Of a reduced model: by how much its outputs are wrong at most.
    pub error_bound: Option<f64>,
    /// For people.
    pub told: String,
}

impl Linearised {
    /// Of an aircraft in the trim of some settings.
    ///
    /// # Errors
    /// When it cannot be trimmed, or not be reduced to so few states.
    pub fn new(
        model: &Arc<ReducedModel>,
        settings: &Settings,
        contents: LinearContents,
        wake: Wake,
        inputs: Chosen,
    ) -> Result<Self, Error> {
        trimmed(model, settings, 0.0)?;
        let mut linear = LinearModel::with(Arc::clone(model), settings, contents)?;
        let modes = Modes::new(model, &linear, flight_modes(Arc::clone(model), settings, contents.inflow)?);
        let eigenvalues = linear.eigenvalues().unwrap_or_else(|error| {
            diagnostics::warn(&error.to_string());
            Vec::new()
        });
        let mut told = modes.text(&eigenvalues) + "\n";
        let mut error_bound = None;
        inputs.choose(&mut linear);
        if let Wake::Balanced(order) = wake {
            let reduced = balanced::reduce(&linear, order)?;
            told = format!(
                "the modes of the aircraft, before its {} states are reduced:\n\n{told}",
                linear.states.len()
            );
            told += &(reduced.text() + "\n");
            error_bound = Some(reduced.bound);
            linear = reduced.model;
        }
        told.insert_str(0, &heading(model, settings, &linear));
        Ok(Linearised { linear, modes, error_bound, told })
    }
}

/// What was linearised, and how large it is.
fn heading(model: &ReducedModel, settings: &Settings, linear: &LinearModel) -> String {
    let manoeuvre = match model.support {
        Support::Free => settings.plant.condition.manoeuvre().name(!model.engines.is_empty()),
        Support::Clamped => "rest in the tunnel",
    };
    let [states, inputs, outputs] = [&linear.states, &linear.inputs, &linear.outputs].map(Vec::len);
    let condition = condition(model, settings);
    let planes = planes(&linear.gust_planes);
    format!(
        "{}: {manoeuvre}, {condition}\n{states} states, {inputs} inputs, {outputs} outputs\n{planes}\n",
        model.name
    )
}

/// Where a gust is given to the model, if it is.
fn planes(places: &[f64]) -> String {
    let [first, second, ..] = places else { return String::new() };
    let last = places[places.len() - 1];
    let (count, apart) = (places.len(), first - second);
    let [first, last, apart] = [*first, last, apart].map(|number| fixed(number, 4));
    format!("{count} gust planes, {first} to {last} m ahead of O, {apart} m apart\n")
}

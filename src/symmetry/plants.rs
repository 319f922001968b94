//! The plants of an aircraft, and which of them may fly [theory: symmetry.half, symmetry.unfolding].
//!
//! An aircraft with a mirror plane that nothing has ever moved out of symmetry needs half its strips, half its modes
//! and half its rigid motion. As soon as something acts on one side alone, the whole aircraft takes over for good.

use nalgebra::Vector3;

use crate::equations::Configuration;
use crate::plant::{Plant, ROUNDING, Trim, TrimCondition, TrimError};
use crate::structure::ReducedModel;

use super::even_controls::EvenControls;
use super::forms::{Form, Forms};
use super::half::{Counterpart, SymmetricHalf};
use super::unfolding::Unfolding;

/// The plant of each form of an aircraft.
///
/// ```
/// use flexible_aircraft::flight::Settings;
/// use flexible_aircraft::symmetry::Form;
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let settings = Settings::of(&jet);
/// let plants = settings.plants(&jet)?;
/// let half = plants.half().ok_or("the jet has a mirror plane")?;
/// assert!(half.layout().len() < plants.whole().layout().len());
/// // The trim is found with the half and stands for the whole.
/// let trimmed = plants.trim(&settings.trim_condition())?;
/// assert!(trimmed.form.is_symmetric());
/// assert_eq!(trimmed.trims.of(Form::of_symmetric(false)).state.len(), plants.whole().layout().len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plants {
    plants: Forms<Plant>,
    mirror: Option<Mirror>,
}

/// What relates the half to the whole.
#[derive(Clone, Debug)]
struct Mirror {
    unfolding: Unfolding,
    /// For each engine its mirror image.
    engines: Vec<usize>,
    /// When the controls act alike on both sides.
    controls: EvenControls,
}

/// A trim in each form, and the form that a flight from it begins in.
#[derive(Clone, Debug)]
pub struct Trimmed {
    /// In which the trim was found.
    pub form: Form,
    /// In each form.
    pub trims: Forms<Trim>,
}

/// What acts on an aircraft from an instant on: values at the instant and their rates.
pub trait Actions {
    /// The angle of a control, rad, and its rate, rad/s.
    fn angle(&self, control: usize) -> [f64; 2];
    /// The thrust of an engine, N, and its rate, N/s.
    fn thrust(&self, engine: usize) -> [f64; 2];
    /// Along the course: the wind, m/s, its rate, m/s², and the rate of that, m/s³.
    fn winds(&self) -> [Vector3<f64>; 3];
}

impl Plants {
    /// Of a model with these of its modes.
    pub fn new(model: &ReducedModel, modes: Vec<usize>, configuration: &Configuration) -> Self {
        let reduced = model.select(&modes);
        let half = SymmetricHalf::find(&reduced);
        let halved = half.as_ref().map(|half| {
            let packaged = half.modes.iter().map(|&mode| modes[mode]).collect();
            let equations = half.equations(configuration);
            let strips = packaged_strips(half, equations.strip_count());
            Plant::of_equations(equations, &half.model, packaged, strips)
        });
        let whole = Plant::of_selected(&reduced, configuration, modes);
        let mirror = half.zip(halved.as_ref()).map(|(half, halved)| Mirror {
            unfolding: Unfolding::new(&half, halved.layout(), whole.layout()),
            engines: half.engines,
            controls: half.controls,
        });
        Plants { plants: Forms::new(whole, halved), mirror }
    }

    /// The plant of each form.
    pub fn forms(&self) -> &Forms<Plant> {
        &self.plants
    }

    /// That of the whole aircraft.
    pub fn whole(&self) -> &Plant {
        self.plants.whole()
    }

    /// That of its half, if it has a mirror plane.
    pub fn half(&self) -> Option<&Plant> {
        self.plants.half()
    }

    /// The same plants, each changed alike.
    pub(crate) fn map(&self, change: impl FnMut(&Plant) -> Plant) -> Self {
        Plants { plants: self.plants.map(change), mirror: self.mirror.clone() }
    }

    /// The most states that any form has.
    pub fn most_states(&self) -> usize {
        self.plants.iter().fold(0, |most, plant| most.max(plant.layout().len()))
    }

    /// The form with the fewest states.
    pub fn simplest_form(&self) -> Form {
        if self.mirror.is_some() { Form::HALF } else { Form::WHOLE }
    }

    /// Trims the aircraft in its simplest form. Allocates.
    ///
    /// # Errors
    /// When there is no trim.
    pub fn trim(&self, condition: &TrimCondition) -> Result<Trimmed, Box<TrimError>> {
        let form = self.simplest_form();
        let trim = self.plants.of(form).trim(condition)?;
        let Some(Mirror { unfolding, .. }) = &self.mirror else {
            return Ok(Trimmed { form, trims: Forms::new(trim, None) });
        };
        let mut unfolded = Trim { state: Vec::new(), ..trim.clone() };
        unfolding.unfold(&trim.state, &mut unfolded.state);
        Ok(Trimmed { form, trims: Forms::new(unfolded, Some(trim)) })
    }

    /// The form that a state must have before something acts: that which it has, unless that is the half and what acts is
    /// not alike on both sides, but for rounding, or will not be.
    pub fn form_under(&self, form: Form, actions: &impl Actions) -> Form {
        match &self.mirror {
            Some(mirror) if form == Form::HALF && !mirror.are_symmetric(actions) => Form::WHOLE,
            _ => form,
        }
    }

    /// Writes a state in the form that [`form_under`](Self::form_under) has asked for, another one than it has.
    pub fn convert(&self, state: &[f64], converted: &mut Vec<f64>) {
        if let Some(Mirror { unfolding, .. }) = &self.mirror {
            unfolding.unfold(state, converted);
        }
    }
}

impl Mirror {
    /// Whether everything acts alike on both sides, but for rounding, and will [theory: symmetry.unfolding].
    fn are_symmetric(&self, actions: &impl Actions) -> bool {
        let are_alike = |a: f64, b: f64| (a - b).abs() <= ROUNDING * a.abs().max(b.abs());
        let mut engines = self.engines.iter().enumerate();
        let angles = self.controls.sums(|control| actions.angle(control)[0]);
        let rates = self.controls.sums(|control| actions.angle(control)[1]);
        // A radian is much, whatever the angles: of rates nothing is.
        let cancel = |[sum, size]: [f64; 2], much: f64| sum.abs() <= ROUNDING * size.max(much);
        angles.into_iter().all(|sum| cancel(sum, 1.0))
            && rates.into_iter().all(|sum| cancel(sum, 0.0))
            && actions.winds().into_iter().all(|wind| wind.y == 0.0)
            && engines.all(|(engine, &image)| {
                let pairs = actions.thrust(engine).into_iter().zip(actions.thrust(image));
                pairs.into_iter().all(|(thrust, other)| are_alike(thrust, other))
            })
    }
}

/// For each strip of a half, the lifting ones and those edge-on, the first of the whole aircraft that it is or stands for.
fn packaged_strips(half: &SymmetricHalf, lifting: usize) -> Vec<usize> {
    let stands_for = |strip: usize| {
        let is_it = |counterpart: &Counterpart| match *counterpart {
            Counterpart::Lifting { index, .. } => index == strip,
            Counterpart::EdgeOn(index) => lifting + index == strip,
        };
        half.strips.iter().position(is_it).unwrap_or(strip)
    };
    (0..lifting + half.edge_on.len()).map(stands_for).collect()
}

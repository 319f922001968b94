//! The plant of an aircraft that flies: in one form after the other, as what acts on it asks for [theory: symmetry.unfolding].

use crate::equations::{Controls, Workspace};
use crate::plant::{Course, Outputs, PackagedStrip, Plant, Trim};
use crate::strips::Resultant;

use super::actions::Actions;
use super::forms::{Form, Forms};
use super::plants::{Plants, Trimmed};

/// The plants of an aircraft, of which one flies, each with a workspace and with `M`, what marches it.
#[derive(Clone, Debug)]
pub struct FlyingPlant<M> {
    plants: Plants,
    /// Of the plant that flies.
    form: Form,
    /// That which was kept last.
    kept: Form,
    seats: Forms<Seat<M>>,
    /// Room for a state in another form, and for its rates.
    elsewhere: [Vec<f64>; 2],
}

#[derive(Clone, Debug)]
struct Seat<M> {
    workspace: Workspace,
    marcher: M,
}

/// The plant that flies, with its workspace.
#[derive(Debug)]
pub struct ActivePlant<'f> {
    plant: &'f Plant,
    workspace: &'f mut Workspace,
}

/// The plant in which a flight was recorded.
#[derive(Clone, Copy, Debug)]
pub struct RecordedPlant {
    form: Form,
    states: usize,
}

impl<M> FlyingPlant<M> {
    /// In the form in which the aircraft was trimmed; `march` makes what marches a plant about its trim.
    pub fn new(plants: Plants, trimmed: &Trimmed, mut march: impl FnMut(&Plant, &Trim) -> M) -> Self {
        let seat =
            |plant: &Plant, trim: &Trim| Seat { workspace: plant.workspace(), marcher: march(plant, trim) };
        let seats = plants.forms().zip_map(&trimmed.trims, seat);
        let room = plants.most_states();
        FlyingPlant {
            form: trimmed.form,
            kept: trimmed.form,
            seats,
            elsewhere: [(); 2].map(|()| Vec::with_capacity(room)),
            plants,
        }
    }

    /// The plants.
    pub fn plants(&self) -> &Plants {
        &self.plants
    }

    /// That which flies.
    pub fn plant(&self) -> &Plant {
        self.plants.forms().of(self.form)
    }

    /// What marches it.
    pub fn marcher(&self) -> &M {
        &self.seats.of(self.form).marcher
    }

    /// The plant that flies, to be evaluated, and what marches it.
    #[inline]
    pub fn active(&mut self) -> (ActivePlant<'_>, &mut M) {
        let Seat { workspace, marcher } = self.seats.of_mut(self.form);
        (ActivePlant { plant: self.plants.forms().of(self.form), workspace }, marcher)
    }

    /// The plant that flies, and what marches it.
    pub fn plant_and_marcher(&mut self) -> (&Plant, &mut M) {
        (self.plants.forms().of(self.form), &mut self.seats.of_mut(self.form).marcher)
    }

    /// Whether the motion has been symmetric and is computed so.
    pub fn is_symmetric(&self) -> bool {
        self.form.is_symmetric()
    }

    /// Whether the same plant flies on under what acts.
    pub fn stays_under(&self, actions: &impl Actions) -> bool {
        self.plants.unfolding_under(self.form, actions).is_none()
    }

    /// Has that plant fly on that can under what acts, and rewrites states for it; returns whether it is another one. Does
    /// not allocate where the states have room for those of any plant.
    pub fn take_actions<'s>(
        &mut self,
        actions: &impl Actions,
        states: impl IntoIterator<Item = &'s mut Vec<f64>>,
    ) -> bool {
        let Some((form, unfolding)) = self.plants.unfolding_under(self.form, actions) else { return false };
        let [unfolded, _] = &mut self.elsewhere;
        for state in states {
            unfolding.unfold(state, unfolded);
            state.clone_from(unfolded);
        }
        self.form = form;
        true
    }

    /// Writes the outputs at a state of the plant that flies under actions that ask for another one, and lets the first
    /// fly on. Does not allocate.
    pub fn write_outputs_under(
        &mut self,
        actions: &impl Actions,
        state: &[f64],
        controls: &Controls,
        course: Course,
        outputs: &mut Outputs,
    ) {
        let [unfolded, rates] = &mut self.elsewhere;
        let (form, state) = self.plants.taken(self.form, state, actions, unfolded);
        rates.resize(state.len(), 0.0);
        let (plant, workspace) = (self.plants.forms().of(form), &mut self.seats.of_mut(form).workspace);
        plant.rates(state, controls, rates, workspace);
        plant.write_outputs(state, controls, workspace, course, outputs);
    }

    /// The outputs at a state of the plant that flies under whatever acts. Allocates.
    pub fn outputs_under(
        &self,
        actions: &impl Actions,
        state: &[f64],
        controls: &Controls,
        course: Course,
    ) -> Outputs {
        self.plants.outputs_under(self.form, actions, state, controls, course)
    }

    /// Adds the section loads at a state of the plant that flies, which are those of the whole aircraft, to the outputs there.
    /// Does not allocate.
    pub fn write_loads(&mut self, state: &[f64], controls: &Controls, outputs: &mut Outputs) {
        let [unfolded, rates] = &mut self.elsewhere;
        let state = self.plants.unfolded(self.form, state, unfolded);
        rates.resize(state.len(), 0.0);
        let (plant, workspace) = (self.plants.whole(), &mut self.seats.of_mut(Form::WHOLE).workspace);
        plant.rates(state, controls, rates, workspace);
        plant.write_loads(state, controls, workspace, outputs);
    }

    /// Adds them to outputs. Allocates.
    pub fn add_loads(&self, state: &[f64], controls: &Controls, outputs: &mut Outputs) {
        self.plants.add_loads(self.form, state, controls, outputs);
    }

    /// What the air does to each strip of the whole aircraft at a state of the plant that flies. Allocates.
    pub fn strip_loads(&mut self, state: &[f64], controls: &Controls) -> Vec<Resultant> {
        let state = self.plants.unfolded(self.form, state, &mut self.elsewhere[0]);
        self.plants.whole().strip_loads_at(state, controls, &mut self.seats.of_mut(Form::WHOLE).workspace)
    }

    /// Keeps in mind which plant flies.
    pub fn keep(&mut self) {
        self.kept = self.form;
    }

    /// Lets the plant fly that did when it was [kept](Self::keep).
    pub fn restore_kept(&mut self) {
        self.form = self.kept;
    }

    /// The plant of a flight that was [symmetric](Self::is_symmetric) or not, if there is one.
    pub fn recorded(&self, is_symmetric: bool) -> Option<RecordedPlant> {
        // A flight that began aside has no seat for its half.
        let form = self.plants.form(is_symmetric).filter(|_| !is_symmetric || self.seats.half().is_some())?;
        Some(RecordedPlant { form, states: self.plants.forms().of(form).layout().len() })
    }

    /// Lets it fly.
    pub fn take_recorded(&mut self, recorded: RecordedPlant) {
        self.form = recorded.form;
    }
}

impl RecordedPlant {
    /// How many it has.
    pub fn states(self) -> usize {
        self.states
    }
}

impl ActivePlant<'_> {
    /// As [`Plant::rates`].
    #[inline(always)]
    pub fn rates(&mut self, state: &[f64], controls: &Controls, rates: &mut [f64]) {
        self.plant.rates(state, controls, rates, self.workspace);
    }

    /// As [`Plant::steer`].
    pub fn steer(&mut self, controls: &Controls, rates: &mut [f64]) {
        self.plant.steer(controls, rates, self.workspace);
    }

    /// As [`Plant::write_usual_outputs`], of the last evaluation.
    pub fn write_usual_outputs(
        &self,
        state: &[f64],
        controls: &Controls,
        course: Course,
        outputs: &mut Outputs,
    ) {
        self.plant.write_usual_outputs(state, controls, self.workspace, course, outputs);
    }

    /// As [`Plant::write_further_outputs`], of the last evaluation.
    pub fn write_further_outputs(&self, state: &[f64], course: Course, outputs: &mut Outputs) {
        self.plant.write_further_outputs(state, self.workspace, course, outputs);
    }

    /// As [`Plant::reversed_strip`].
    pub fn reversed_strip(&self, state: &[f64], controls: &Controls) -> Option<&PackagedStrip> {
        self.plant.reversed_strip(state, controls, self.workspace)
    }
}

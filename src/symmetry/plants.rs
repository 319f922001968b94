//! The plants of an aircraft, and which of them may fly [theory: symmetry.half, symmetry.unfolding].
//!
//! An aircraft with a mirror plane that nothing has ever moved out of symmetry needs half its strips, half its modes
//! and half its rigid motion. As soon as something acts on one side alone, the whole aircraft takes over for good.

use crate::aircraft::Support;
use crate::equations::{ClosesLoop, Configuration, Controls};
use crate::math::{ROUNDING, are_alike};
use crate::plant::{
    Course, LimitedTrimError, Outputs, Packaged, PackagedStrip, Plant, PlantSettings, SettingError, Trim,
    TrimCondition, TrimError, TrimLimits,
};
use crate::structure::{ModesInUse, ReducedModel};

use super::actions::Actions;
use super::even_controls::EvenControls;
use super::forms::{Form, Forms};
use super::half::SymmetricHalf;
use super::unfolding::Unfolding;

/// The plant of each form of an aircraft.
///
/// ```
/// use flexible_aircraft::plant::PlantSettings;
/// use flexible_aircraft::symmetry::Plants;
/// # use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
/// let settings = PlantSettings::of(&jet);
/// let plants = Plants::under(&jet, &settings)?;
/// let half = plants.half().ok_or("the jet has a mirror plane")?;
/// assert!(half.layout().len() < plants.whole().layout().len());
/// // The trim is found with the half and stands for the whole.
/// let trimmed = plants.trim(&settings.trim_condition())?;
/// assert!(trimmed.form.is_symmetric());
/// let whole = plants.form(false).ok_or("every aircraft has one")?;
/// assert_eq!(trimmed.trims.of(whole).state.len(), plants.whole().layout().len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plants {
    plants: Forms<Plant>,
    halving: Option<Halving>,
}

/// What relates the half to the whole.
#[derive(Clone, Debug)]
struct Halving {
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

impl Plants {
    /// Of a model with these of its modes.
    ///
    /// # Errors
    /// When the level is geometrically exact and the model's joints close loops.
    pub fn new(
        model: &ReducedModel,
        configuration: &Configuration,
        modes: &ModesInUse,
    ) -> Result<Self, ClosesLoop> {
        let reduced = model.in_use(modes);
        let half = SymmetricHalf::find(&reduced);
        let whole = Plant::of_modes(model, configuration, modes)?;
        let halve = |half: &SymmetricHalf| {
            let strips = half.stands_for.iter().map(|&strip| PackagedStrip::of(&reduced, strip));
            let (modes, packaged) = (modes.among(&half.modes), Packaged::whole(model, modes));
            let packaged = Packaged { modes, strips: strips.collect(), ..packaged };
            Ok(Plant::of_equations(half.equations(configuration)?, &half.model, packaged))
        };
        let halved = half.as_ref().map(halve).transpose()?;
        let halving = half.zip(halved.as_ref()).map(|(half, halved)| Halving {
            unfolding: Unfolding::new(&half, halved.layout(), whole.layout()),
            engines: half.engines,
            controls: half.controls,
        });
        Ok(Plants { plants: Forms::new(whole, halved), halving })
    }

    /// Of a model under some settings.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn under(model: &ReducedModel, settings: &PlantSettings) -> Result<Self, SettingError> {
        let modes = settings.choose_modes(model)?;
        Ok(Plants::new(model, &settings.configuration(model.support), &modes)?)
    }

    /// The plant of each form.
    pub(super) fn forms(&self) -> &Forms<Plant> {
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
        Plants { plants: self.plants.map(change), halving: self.halving.clone() }
    }

    /// The form of symmetric motion, if the aircraft has it, or that of any motion.
    pub fn form(&self, is_symmetric: bool) -> Option<Form> {
        match (is_symmetric, &self.halving) {
            (false, _) => Some(Form::WHOLE),
            (true, Some(_)) => Some(Form::HALF),
            (true, None) => None,
        }
    }

    /// The most states that any form has.
    pub(crate) fn most_states(&self) -> usize {
        self.plants.iter().fold(0, |most, plant| most.max(plant.layout().len()))
    }

    /// The form with the fewest states in which an aircraft can fly like that.
    fn form_of_trim(&self, condition: &TrimCondition) -> Form {
        let is_clamped = self.whole().support() == Support::Clamped;
        let is_half = self.halving.is_some() && (is_clamped || condition.manoeuvre.is_symmetric());
        if is_half { Form::HALF } else { Form::WHOLE }
    }

    /// Its plant, with which the trim is found.
    pub(crate) fn plant_of_trim(&self, condition: &TrimCondition) -> &Plant {
        self.plants.of(self.form_of_trim(condition))
    }

    /// Trims the aircraft in the simplest form that can fly like that. Allocates.
    ///
    /// # Errors
    /// When there is no trim.
    pub fn trim(&self, condition: &TrimCondition) -> Result<Trimmed, Box<TrimError>> {
        let (form, trim) = (self.form_of_trim(condition), self.plant_of_trim(condition).trim(condition)?);
        let Some(Halving { unfolding, .. }) = self.halving.as_ref().filter(|_| form == Form::HALF) else {
            return Ok(Trimmed { form, trims: Forms::new(trim, None) });
        };
        let mut unfolded = Trim { state: Vec::new(), ..trim.clone() };
        unfolding.unfold(&trim.state, &mut unfolded.state);
        Ok(Trimmed { form, trims: Forms::new(unfolded, Some(trim)) })
    }

    /// The plant with which a trim is found, and the trim, where controls and engines can give it. Allocates.
    ///
    /// # Errors
    /// As for [`Plant::trim_within`].
    pub fn trim_within(
        &self,
        condition: &TrimCondition,
        limits: &TrimLimits,
    ) -> (&Plant, Result<Trim, LimitedTrimError>) {
        let plant = self.plant_of_trim(condition);
        (plant, plant.trim_within(condition, limits))
    }

    /// The outputs at a trim of [its plant](Self::plant_of_trim) under other actions, in axes along a course. Allocates.
    pub(crate) fn outputs_at_trim(
        &self,
        (trim, condition): (&Trim, &TrimCondition),
        actions: &impl Actions,
        controls: &Controls,
        course: Course,
    ) -> Outputs {
        self.outputs_under(self.form_of_trim(condition), actions, &trim.state, controls, course)
    }

    /// Adds the section loads there to outputs. Allocates.
    pub(crate) fn add_loads_at_trim(
        &self,
        (trim, condition): (&Trim, &TrimCondition),
        controls: &Controls,
        outputs: &mut Outputs,
    ) {
        self.add_loads(self.form_of_trim(condition), &trim.state, controls, outputs);
    }

    /// The same at a state of some form.
    pub(super) fn outputs_under(
        &self,
        form: Form,
        actions: &impl Actions,
        state: &[f64],
        controls: &Controls,
        course: Course,
    ) -> Outputs {
        let mut unfolded = Vec::new();
        let (form, state) = self.taken(form, state, actions, &mut unfolded);
        let plant = self.plants.of(form);
        plant.outputs_along(course, state, controls, &mut plant.workspace())
    }

    /// Adds the section loads at a state of some form, which are those of the whole aircraft, to outputs. Allocates.
    ///
    /// [theory: section-loads.half]
    pub(super) fn add_loads(&self, form: Form, state: &[f64], controls: &Controls, outputs: &mut Outputs) {
        let mut unfolded = Vec::new();
        let state = self.unfolded(form, state, &mut unfolded);
        let (whole, mut workspace) = (self.whole(), self.whole().workspace());
        whole.rates(state, controls, &mut vec![0.0; state.len()], &mut workspace);
        whole.write_loads(state, controls, &workspace, outputs);
    }

    /// A state of some form as one of the whole aircraft; `room` has place for that.
    pub(super) fn unfolded<'s>(&self, form: Form, state: &'s [f64], room: &'s mut Vec<f64>) -> &'s [f64] {
        match self.halving.as_ref().filter(|_| form == Form::HALF) {
            Some(Halving { unfolding, .. }) => {
                unfolding.unfold(state, room);
                room
            }
            None => state,
        }
    }

    /// Into which form what acts unfolds a state, and how; none where it may keep the one it has. The half is left where
    /// something does not act alike on both sides, but for rounding, or will not.
    pub(super) fn unfolding_under(&self, form: Form, actions: &impl Actions) -> Option<(Form, &Unfolding)> {
        let halving = self.halving.as_ref().filter(|_| form == Form::HALF)?;
        (!halving.are_symmetric(actions)).then_some((Form::WHOLE, &halving.unfolding))
    }

    /// The form that a state must have before something acts, and the state in it; `room` has place for another form's.
    pub(super) fn taken<'s>(
        &self,
        form: Form,
        state: &'s [f64],
        actions: &impl Actions,
        room: &'s mut Vec<f64>,
    ) -> (Form, &'s [f64]) {
        match self.unfolding_under(form, actions) {
            None => (form, state),
            Some((form, unfolding)) => {
                unfolding.unfold(state, room);
                (form, room)
            }
        }
    }
}

impl Trimmed {
    /// The trim as it was found.
    pub fn trim(&self) -> &Trim {
        self.trims.of(self.form)
    }
}

impl Halving {
    /// Whether everything acts alike on both sides, but for rounding, and will [theory: symmetry.unfolding].
    fn are_symmetric(&self, actions: &impl Actions) -> bool {
        let mut engines = self.engines.iter().enumerate();
        let angles_of =
            |place: usize| self.controls.sums(move |control| actions.angle(control).values[place]);
        let mut rates = self.controls.sums(|control| actions.angle(control).rate);
        // A radian is much, whatever the angles: of rates nothing is.
        let cancel = |[sum, size]: [f64; 2], much: f64| sum.abs() <= ROUNDING * size.max(much);
        let (is_direct, places) = (actions.are_direct(), if actions.lag() { 0..3 } else { 0..1 });
        places.into_iter().all(|place| angles_of(place).all(|sum| cancel(sum, 1.0)))
            && rates.all(|sum| cancel(sum, 0.0))
            && (is_direct || self.controls.terms().all(|terms| actions.controls_move_alike(terms)))
            && actions.gust_is_in_plane()
            && actions.winds().into_iter().all(|wind| wind.y == 0.0)
            && engines.all(|(engine, &image)| {
                let (one, other) = (actions.thrust(engine), actions.thrust(image));
                let mut pairs = one.values.into_iter().zip(other.values).chain([(one.rate, other.rate)]);
                pairs.all(|(thrust, other)| are_alike(thrust, other, ROUNDING))
                    && (is_direct || actions.engines_move_alike(engine, image))
            })
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::symmetry::actions::Motion;

    /// What acts on two controls that are to move together and two engines.
    #[derive(Clone, Default)]
    struct Acting {
        angles: [Motion; 2],
        thrusts: [Motion; 2],
        part: bool,
        winds: [Vector3<f64>; 3],
        gusts_aside: bool,
    }

    impl Actions for Acting {
        fn are_direct(&self) -> bool {
            false
        }
        fn angle(&self, control: usize) -> Motion {
            self.angles[control]
        }
        fn thrust(&self, engine: usize) -> Motion {
            self.thrusts[engine]
        }
        fn lag(&self) -> bool {
            true
        }
        fn controls_move_alike(&self, _: &[(usize, f64)]) -> bool {
            !self.part
        }
        fn engines_move_alike(&self, _: usize, _: usize) -> bool {
            true
        }
        fn winds(&self) -> [Vector3<f64>; 3] {
            self.winds
        }
        fn gust_is_in_plane(&self) -> bool {
            !self.gusts_aside
        }
    }

    fn are_symmetric(acting: &Acting) -> bool {
        let layout = crate::equations::StateLayout::new(0, crate::strips::InflowLayout::new(0, 0, 0));
        let halving = Halving {
            unfolding: Unfolding::at_rest(&layout),
            engines: vec![1, 0],
            controls: EvenControls::of_rows(vec![vec![1.0, -1.0]]),
        };
        halving.are_symmetric(acting)
    }

    /// Both a little less than the rounding that is allowed and a little more.
    fn is_the_limit(allowed: f64, acting: impl Fn(f64) -> Acting) -> bool {
        let allows = |share: f64| are_symmetric(&acting(share * allowed));
        allows(0.0) && allows(0.9) && allows(-0.9) && !allows(1.1) && !allows(-1.1)
    }

    #[test]
    fn what_differs_by_sixteen_roundings_is_alike_and_by_more_is_not() {
        assert_eq!(ROUNDING, 16.0 * f64::EPSILON);
        // Angles count as shares of a radian where they are small, of their magnitudes where they are large; rates only so.
        for place in 0..3 {
            let pair = |angle: f64, apart: f64| {
                let mut acting = Acting::default();
                acting.angles.iter_mut().for_each(|motion| motion.values[place] = angle);
                acting.angles[0].values[place] += apart;
                acting
            };
            assert!(is_the_limit(ROUNDING, |apart| pair(0.25, apart)));
            assert!(is_the_limit(16.0 * ROUNDING, |apart| pair(8.0, apart)));
        }
        let rates = |apart: f64| {
            let mut acting = Acting::default();
            (acting.angles[0].rate, acting.angles[1].rate) = (0.25 + apart, 0.25);
            acting
        };
        assert!(is_the_limit(0.5 * ROUNDING, rates));
        // Thrusts and their rates count as shares of the larger one.
        for place in 0..4 {
            let thrusts = |apart: f64| {
                let mut acting = Acting::default();
                for (motion, thrust) in acting.thrusts.iter_mut().zip([4096.0 + apart, 4096.0]) {
                    *motion.values.get_mut(place).unwrap_or(&mut motion.rate) = thrust;
                }
                acting
            };
            assert!(is_the_limit(4096.0 * ROUNDING, thrusts));
        }
    }

    #[test]
    fn a_gust_from_the_side_and_what_devices_will_part_are_not_alike() {
        assert!(are_symmetric(&Acting::default()));
        assert!(!are_symmetric(&Acting { gusts_aside: true, ..Acting::default() }));
        assert!(!are_symmetric(&Acting { part: true, ..Acting::default() }));
    }

    #[test]
    fn wind_across_the_course_is_never_alike() {
        for place in 0..3 {
            let mut acting = Acting::default();
            acting.winds[place] = Vector3::new(3.0, 0.0, -2.0);
            assert!(are_symmetric(&acting));
            acting.winds[place].y = f64::MIN_POSITIVE;
            assert!(!are_symmetric(&acting));
        }
    }
}

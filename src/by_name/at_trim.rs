//! A trim as a flight has it, and the plant linearised there: names, lags.
//!
//! [theory: linearisation.inputs, linearisation.outputs, linearisation.lags, linearisation.all-states]

use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::Arc;

use crate::air::ImposedGust;
use crate::aircraft::Support;
use crate::devices::Holding;
use crate::flight::{ActuatorReading, Instant, Settings, Simulation, SimulationError, Way, way};
use crate::plant::{
    Course, GustColumns, Linearisation, Outputs, Plant, SettingError, Trim, TrimPoint, Unknown, UnknownsKept,
};
use crate::structure::ReducedModel;
use crate::symmetry::Plants;
use crate::variables::{OutputSlot, VariableTable};

use super::linear_model::{LinearContents, LinearModel};
use super::linear_names::{self, Name};
use super::{all_states, lags};

/// An aircraft in the trim with which a flight begins, before it is linearised there.
#[derive(Clone, Debug)]
pub(super) struct AtTrim {
    model: Arc<ReducedModel>,
    pub(super) settings: Settings,
    pub(super) plant: Plant,
    kept: UnknownsKept,
    pub(super) trim: Trim,
    course: Course,
    slots: Vec<OutputSlot>,
    names: Vec<Name>,
    instant: Instant,
    /// Of each output, but for section loads, which do not turn.
    middles: Vec<f64>,
    /// On which it meets gusts.
    pub(super) way: Way,
}

impl AtTrim {
    /// Trims an aircraft under some settings. Allocates.
    ///
    /// # Errors
    /// When a setting is out of range or no flight could begin with them.
    pub fn new(
        model: Arc<ReducedModel>,
        settings: &Settings,
        contents: LinearContents,
    ) -> Result<Self, SimulationError> {
        let settings = contents.inflow.of(settings);
        let kept = if contents.all_states { UnknownsKept::All } else { UnknownsKept::Felt };
        if kept == UnknownsKept::All {
            all_states::check(&settings.plant.condition.manoeuvre())?;
        }
        if model.support == Support::Clamped && settings.plant.airspeed == 0.0 {
            let allowed =
                "greater than 0 (m/s) for a linear model: the flow's angles have no derivatives at rest";
            let [setting, found] = ["airspeed", "0"].map(str::to_owned);
            return Err(SettingError { setting, found, allowed: allowed.to_owned() }.into());
        }
        // All that is checked before a flight, limits of actuators among it.
        Simulation::new(Arc::clone(&model), &settings, 0.0)?;
        let along_course = settings.plant.along_course();
        let plants = Plants::under(&model, &along_course)?;
        let trimmed = plants.trim(&along_course.trim_condition())?;
        let (plant, trim) = (plants.whole().clone(), trimmed.trims.whole().clone());
        let course = Course::new(settings.plant.heading).from(&trim.state[plant.layout().attitude()]);
        let outputs = linear_names::outputs(&VariableTable::new(&model), &settings);
        let (slots, names): (Vec<OutputSlot>, Vec<Name>) = outputs.into_iter().unzip();
        let at_trim = plant.outputs_along(course, &trim.state, &trim.controls, &mut plant.workspace());
        let instant = instant(at_trim, trim.point);
        let middles = slots.iter().map(|slot| slot.number(&instant)).collect();
        let way = way(&model, &settings, &plant, &trim);
        Ok(AtTrim { model, settings, plant, kept, trim, course, slots, names, instant, middles, way })
    }

    /// The linear model there.
    pub fn linear_model(&self) -> LinearModel {
        let found = self.plant.linear_model_with(self.kept, &self.trim, self.course, self.read());
        let table = VariableTable::new(&self.model);
        let mut linear = LinearModel::named(found, &self.plant, &table);
        linear.outputs.clone_from(&self.names);
        lags::append(&mut linear, &self.slots, &self.model, &self.settings);
        if self.kept == UnknownsKept::All {
            all_states::complete(&mut linear, self.course, &table);
        }
        linear
    }

    /// Which states of its linear model are the wake's: each strip's stand by themselves.
    pub fn wake(&self) -> Range<usize> {
        let unknowns = self.plant.unknowns(self.kept);
        let is_wake = |unknown: &Unknown| matches!(unknown, Unknown::Inflow { .. });
        // They stand last.
        unknowns.iter().position(is_wake).unwrap_or(unknowns.len())..unknowns.len()
    }

    /// What gusts along the track do, by their strength: a row for each state of the plant and each output.
    pub fn linear_gusts(&self, gusts: &[ImposedGust]) -> GustColumns {
        self.plant.linear_gusts(self.kept, &self.trim, self.course, (self.way.track, gusts), self.read())
    }

    /// Reads all outputs.
    fn read(&self) -> impl FnMut(&Outputs) -> Vec<f64> + '_ {
        let mut instant = self.instant.clone();
        move |outputs| {
            instant.outputs.clone_from(outputs);
            let values = self.slots.iter().zip(&self.middles).map(|(slot, &middle)| {
                let value = slot.number(&instant);
                if slot.turns() { middle + libm::remainder(value - middle, TAU) } else { value }
            });
            values.collect()
        }
    }
}

/// What is read of an aircraft on which nothing lags and nothing is sampled.
fn instant(outputs: Outputs, trim: TrimPoint) -> Instant {
    let at_rest = ActuatorReading { rate: 0.0, holding: Holding::None };
    Instant { actuators: vec![at_rest; outputs.controls.len()], sensors: Vec::new(), outputs, trim }
}

impl LinearModel {
    /// With the names of states and inputs.
    fn named(found: Linearisation, plant: &Plant, table: &VariableTable) -> Self {
        let Linearisation { unknowns, inputs, a, b, c, d, bd, dd, x0, u0, y0 } = found;
        LinearModel {
            a,
            b,
            c,
            d,
            bd,
            dd,
            x0,
            u0,
            y0,
            states: linear_names::states(&unknowns, plant, table),
            inputs: inputs.iter().map(|input| linear_names::input(*input, table)).collect(),
            outputs: Vec::new(),
            gust_planes: Vec::new(),
        }
    }
}

//! Flights that begin nearby: trimmed under slightly other settings, for derivatives of the outputs by them.
//!
//! [theory: trim.tangent]

use std::array::from_fn;
use std::sync::Arc;

use crate::plant::{Course, Outputs, Plant, Trim, TrimPoint, TrimTangents};
use crate::structure::ReducedModel;
use crate::symmetry::Plants;

use super::inputs::Inputs;
use super::moment::Moment;
use super::settings::Settings;
use super::simulation::Simulation;
use super::steering::Steering;

/// The neighbours of a flight at its beginning.
#[derive(Clone, Debug)]
pub struct Neighbours {
    model: Arc<ReducedModel>,
    /// Those of the flight in the middle.
    settings: Settings,
    /// Its plants.
    plants: Plants,
    tangents: TrimTangents,
    /// Its course.
    course: Course,
}

impl Neighbours {
    /// Of a flight that has been trimmed under these settings. Computes the trim's Jacobian.
    pub fn new(flight: &Simulation, settings: &Settings) -> Self {
        let plants = flight.flying.plants().clone();
        let condition = settings.plant.along_course().trim_condition();
        let tangents = TrimTangents::new(plants.simplest(), &condition, &flight.trimmed);
        Neighbours {
            model: Arc::clone(&flight.model),
            settings: settings.clone(),
            plants,
            tangents,
            course: flight.course,
        }
    }

    /// Whether these are the settings of the flight in the middle.
    pub fn are_around(&self, settings: &Settings) -> bool {
        self.settings == *settings
    }

    /// The outputs and the trims at the beginning of four flights under inputs and their rates. Airspeed, altitude, heading and
    /// stiffness of the flights lie along one change of the settings, by −1, −½, ½ and 1 of it; right to first order of
    /// the change. `with_loads` at the cuts, or without. `None` where the trim has no tangent.
    pub fn outputs(
        &self,
        changed: &[Settings; 4],
        inputs: (&Inputs, &Inputs),
        with_loads: bool,
    ) -> Option<[(Outputs, TrimPoint); 4]> {
        let around = changed.each_ref().map(|settings| {
            (self.varied(self.plants.simplest(), settings), settings.plant.along_course().trim_condition())
        });
        let trims = self.tangents.neighbours(&around)?;
        Some(from_fn(|place| {
            let (trim, settings) = (&trims[place], &changed[place]);
            (self.outputs_at(trim, settings, inputs, with_loads), trim.point)
        }))
    }

    /// At a trim under these settings.
    fn outputs_at(
        &self,
        trim: &Trim,
        settings: &Settings,
        (inputs, rates): (&Inputs, &Inputs),
        with_loads: bool,
    ) -> Outputs {
        let plants = self.plants.map(|plant| self.varied(plant, settings));
        let mut steering = Steering::new(trim.point, settings, &self.model);
        steering.set(inputs, rates, Moment::START);
        let mut controls = plants.simplest().neutral_controls();
        steering.write_at(Moment::START, &mut controls);
        let course = Course::new(settings.plant.heading).beside(self.course);
        let mut outputs = plants.outputs_at_trim(trim, &steering, &controls, course);
        if with_loads {
            plants.add_loads_at_trim(trim, &controls, &mut outputs);
        }
        outputs
    }

    /// A plant of the flight in the middle as it is under other settings.
    fn varied(&self, plant: &Plant, settings: &Settings) -> Plant {
        let tunnel_flow = settings.plant.along_course().configuration(self.model.support).tunnel_flow;
        plant.varied(tunnel_flow, settings.plant.stiffness_scale / self.settings.plant.stiffness_scale)
    }
}

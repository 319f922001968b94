//! Flights that begin nearby: trimmed under slightly other settings, for derivatives of the outputs by them.
//!
//! [theory: trim.tangent]

use std::array::from_fn;
use std::sync::Arc;

use crate::plant::{Course, Plant, Trim, TrimTangents};
use crate::structure::ReducedModel;
use crate::symmetry::Plants;

use super::actions::Acts;
use super::inputs::Inputs;
use super::instant::Instant;
use super::moment::Moment;
use super::sensors::Sensors;
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
        let tangents = TrimTangents::new(plants.plant_of_trim(&condition), &condition, &flight.trimmed);
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

    /// What is read at the beginning of four flights under inputs and their rates. Airspeed, altitude, the air's
    /// temperature, heading and stiffness of the flights lie along one change of the settings, by −1, −½, ½ and 1 of it; right to first order of
    /// the change. `with_loads` at the cuts, or without. `None` where the trim has no tangent.
    pub fn outputs(
        &self,
        changed: &[Settings; 4],
        inputs: (&Inputs, &Inputs),
        with_loads: bool,
    ) -> Option<[Instant; 4]> {
        let around = changed.each_ref().map(|settings| {
            let condition = settings.plant.along_course().trim_condition();
            (self.varied(self.plants.plant_of_trim(&condition), settings), condition)
        });
        let trims = self.tangents.neighbours(&around)?;
        Some(from_fn(|place| {
            let (trim, settings) = (&trims[place], &changed[place]);
            self.instant_at(trim, settings, inputs, with_loads)
        }))
    }

    /// At a trim under these settings.
    fn instant_at(
        &self,
        trim: &Trim,
        settings: &Settings,
        (inputs, rates): (&Inputs, &Inputs),
        with_loads: bool,
    ) -> Instant {
        let plants = self.plants.map(|plant| self.varied(plant, settings));
        let condition = settings.plant.along_course().trim_condition();
        let plant = plants.plant_of_trim(&condition);
        let mut steering = Steering::new(trim, settings, &self.model);
        steering.set(inputs, rates, Moment::START);
        let course = Course::new(settings.plant.heading).beside(self.course);
        let sensors = Sensors::new(&self.model, &settings.sensors, || {
            plant.outputs_along(course, &trim.state, &trim.controls, &mut plant.workspace())
        });
        let acting = steering.at_rest();
        let mut controls = plant.neutral_controls();
        steering.write_at(Moment::START, acting, &mut controls);
        let mut outputs =
            plants.outputs_at_trim((trim, &condition), &Acts::new(&steering, acting), &controls, course);
        if with_loads {
            plants.add_loads_at_trim((trim, &condition), &controls, &mut outputs);
        }
        // The gust itself is still ahead.
        let density = plant.air(&trim.state).density;
        outputs.gust_peak_velocity = settings.gust.peak_velocity(settings.plant.altitude, density);
        let mut instant = Instant::new(outputs, trim.point, sensors.count());
        instant.write_devices(Moment::START, (&steering, acting), &sensors);
        instant
    }

    /// A plant of the flight in the middle as it is under other settings.
    fn varied(&self, plant: &Plant, settings: &Settings) -> Plant {
        let tunnel_flow = settings.plant.along_course().configuration(self.model.support).tunnel_flow;
        let stiffness = settings.plant.stiffness_scale / self.settings.plant.stiffness_scale;
        let mut varied = plant.varied(tunnel_flow, stiffness);
        varied.take_temperature_offset(settings.plant.temperature_offset);
        varied
    }
}

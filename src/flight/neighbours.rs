//! Flights that begin nearby: trimmed under slightly other settings, for derivatives of the outputs by them.
//!
//! [theory: trim.tangent]

use std::array::from_fn;

use crate::plant::{Course, Outputs, Plant, Trim, TrimPoint, TrimTangents};
use crate::symmetry::Plants;

use super::inputs::Inputs;
use super::settings::Settings;
use super::simulation::Simulation;
use super::steering::Steering;

/// The neighbours of a flight at its beginning.
#[derive(Clone, Debug)]
pub struct Neighbours {
    /// Those of the flight in the middle.
    settings: Settings,
    /// Its plants.
    plants: Plants,
    tangents: TrimTangents,
    /// Stands at one neighbour after the other.
    flight: Simulation,
}

impl Neighbours {
    /// Of a flight that has been trimmed under these settings. Computes the trim's Jacobian.
    pub fn new(flight: &Simulation, settings: &Settings) -> Self {
        let flight = flight.clone();
        let plants = flight.plants.clone();
        let condition = settings.along_course().trim_condition();
        let tangents =
            TrimTangents::new(plants.forms().of(plants.simplest_form()), &condition, &flight.trimmed);
        Neighbours { settings: settings.clone(), plants, tangents, flight }
    }

    /// Whether these are the settings of the flight in the middle.
    pub fn are_around(&self, settings: &Settings) -> bool {
        self.settings == *settings
    }

    /// Reads the outputs under inputs and their rates at the beginning of four flights, whose airspeed, altitude, heading and
    /// stiffness lie along one change of the settings, by [`WIDTHS`](crate::plant::WIDTHS) of it; right to first order of
    /// the change. `None` where the trim has no tangent.
    pub fn read<T>(
        &mut self,
        changed: &[Settings; 4],
        (inputs, rates): (&Inputs, &Inputs),
        mut read: impl FnMut(&Outputs, &TrimPoint) -> T,
    ) -> Option<[T; 4]> {
        let trimmed = self.plants.forms().of(self.plants.simplest_form());
        let around = changed
            .each_ref()
            .map(|settings| (self.varied(trimmed, settings), settings.along_course().trim_condition()));
        let trims = self.tangents.neighbours(&around)?;
        Some(from_fn(|place| {
            self.stand_at(&trims[place], &changed[place]);
            self.flight.set_inputs(inputs, rates);
            let trim = *self.flight.trim();
            read(self.flight.outputs(), &trim)
        }))
    }

    /// Has the flight begin at a trim under these settings, inputs zero.
    fn stand_at(&mut self, trim: &Trim, settings: &Settings) {
        let varied = self.plants.map(|plant| self.varied(plant, settings));
        let Simulation { plants, form, course, steering, path, model, .. } = &mut self.flight;
        *form = varied.simplest_form();
        *plants = varied;
        *course = Course::new(settings.heading);
        *steering = Steering::new(trim.point, settings, model);
        path.present.resize(trim.state.len());
        path.present.state.copy_from_slice(&trim.state);
        path.begin_here();
        self.flight.forget_evaluation();
    }

    /// A plant of the flight in the middle as it is under other settings.
    fn varied(&self, plant: &Plant, settings: &Settings) -> Plant {
        let tunnel_flow = settings.along_course().configuration(&self.flight.model).tunnel_flow;
        plant.varied(tunnel_flow, settings.stiffness_scale / self.settings.stiffness_scale)
    }
}

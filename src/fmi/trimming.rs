//! What moves in an instance is made when it is first needed, for it must be trimmed.

use std::sync::Arc;

use crate::aircraft::Support;
use crate::flight::{ContinuousModel, Settings, Simulation};
use crate::plant::LimitExceeded;
use crate::structure::ReducedModel;

use super::instance::{Experiment, Instance};
use super::interface::Kind;
use super::motion::Motion;
use super::refusal::Refusal;
use super::status::Status;

impl Instance {
    /// What moves under the present parameters and inputs, trimmed at the start time if it is new.
    pub(super) fn motion(&mut self) -> Result<&mut Motion, Refusal> {
        match self.motion {
            Some(ref mut motion) => Ok(motion),
            None => {
                let motion = self.new_motion()?;
                Ok(self.motion.insert(motion))
            }
        }
    }

    /// The flight, where the FMU integrates.
    pub(super) fn flight(&mut self) -> Result<&mut Simulation, Refusal> {
        match self.motion()? {
            Motion::Flight(flight) => Ok(flight),
            Motion::Continuous(_) => Err(Refusal::error("there is no flight in a model exchange FMU")),
        }
    }

    /// The equations, where the importer integrates.
    pub(super) fn continuous(&mut self) -> Result<&mut ContinuousModel, Refusal> {
        match self.motion()? {
            Motion::Continuous(model) => Ok(model),
            Motion::Flight(_) => Err(Refusal::error("a co-simulation FMU integrates by itself")),
        }
    }

    /// A warning of what is beyond the aircraft's limits in the trim.
    pub(super) fn limits_warning(&mut self) -> Result<Option<String>, Refusal> {
        let (model, settings) = (Arc::clone(&self.model), self.settings.clone());
        Ok(LimitExceeded::warning(self.motion()?.limits_exceeded(), &model, &settings.plant))
    }

    fn new_motion(&self) -> Result<Motion, Refusal> {
        let motion = match self.interface.kind {
            Kind::CoSimulation => {
                let mut flight = self.trimmed(&self.settings, &self.experiment)?;
                flight.set_inputs(&self.inputs, &self.rates);
                Motion::Flight(Box::new(flight))
            }
            Kind::ModelExchange => {
                let mut model = self.continuous_under(&self.settings)?;
                model.set_inputs(&self.inputs);
                Motion::Continuous(Box::new(model))
            }
        };
        let ReducedModel { support, controls, engines, .. } = &*self.model;
        let text = match support {
            Support::Free => format!("trimmed: {}", motion.trim().describe(controls, !engines.is_empty())),
            Support::Clamped => "at rest in the tunnel's flow".to_owned(),
        };
        self.log.write(Status::Ok, &text);
        Ok(motion)
    }

    pub(super) fn trimmed(
        &self,
        settings: &Settings,
        experiment: &Experiment,
    ) -> Result<Simulation, Refusal> {
        let tolerance = experiment.tolerance_in_use(settings);
        let settings = Settings { tolerance, ..settings.clone() };
        Simulation::new(self.model.clone(), &settings, experiment.start)
            .map_err(|error| Refusal::error(error.to_string()))
    }

    pub(super) fn continuous_under(&self, settings: &Settings) -> Result<ContinuousModel, Refusal> {
        ContinuousModel::new(&self.model, settings).map_err(|error| Refusal::error(error.to_string()))
    }

    /// Has what moves feel the present inputs.
    pub(super) fn pass_inputs_on(&mut self) {
        match &mut self.motion {
            Some(Motion::Flight(flight)) => flight.set_inputs(&self.inputs, &self.rates),
            Some(Motion::Continuous(model)) => model.set_inputs(&self.inputs),
            None => {}
        }
    }

    /// Reads the inputs as their rates have left them.
    pub(super) fn take_inputs_of_flight(&mut self) {
        if let Some(Motion::Flight(flight)) = &self.motion {
            flight.write_inputs(&mut self.inputs);
        }
    }
}

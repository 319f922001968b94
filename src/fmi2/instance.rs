//! An instance of the FMU, without any C: life cycle, experiment and steps.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;

use super::life_cycle::{Function, State};
use super::logger::Logger;
use super::types::Status;
use super::{RESOURCE_FILE, guid, identity, resource};
use crate::simulation::{Inputs, LATEST, Settings, Simulation};
use crate::structure::{ReducedModel, StructureError};
use crate::variables::{VariableTable, start_settings};

/// Why a call is refused, and with which status.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// `Error` or `Discard`.
    pub status: Status,
    /// For the log.
    pub reason: String,
}

impl Refusal {
    /// The call is wrong.
    pub fn error(reason: impl Into<String>) -> Self {
        Refusal { status: Status::Error, reason: reason.into() }
    }

    /// The call is right, but this slave cannot answer.
    pub fn discard(reason: impl Into<String>) -> Self {
        Refusal { status: Status::Discard, reason: reason.into() }
    }
}

/// Why no instance can be made.
#[derive(Debug, thiserror::Error)]
pub enum InstantiationError {
    /// The location is not that of a directory.
    #[error(transparent)]
    Location(#[from] resource::ResourceError),
    /// The model is not there or not readable.
    #[error("resource {}: {source}", path.display())]
    Read {
        /// Of the model.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The file is not a model of this version.
    #[error("resource {}: {source}", path.display())]
    Model {
        /// Of the model.
        path: PathBuf,
        /// What is wrong with it.
        source: StructureError,
    },
    /// The importer's model description belongs to another FMU.
    #[error("guid: the model description given has `{found}`, this FMU is `{expected}`")]
    Guid {
        /// Given.
        found: String,
        /// Of this FMU.
        expected: String,
    },
}

/// What `fmi2SetupExperiment` says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Experiment {
    /// Wins over the parameter when given.
    pub tolerance: Option<f64>,
    /// s.
    pub start: f64,
    /// s; no step may pass it.
    pub stop: Option<f64>,
}

impl Experiment {
    /// Why it cannot be flown. FMI 2.0 lets time begin below 0.
    pub fn objection(&self) -> Option<String> {
        let Experiment { tolerance, start, stop } = *self;
        if let Some(found) = tolerance.filter(|tolerance| !(*tolerance > 0.0 && *tolerance < 1.0)) {
            return Some(format!("tolerance: found {found}, allowed is a number between 0 and 1, exclusive"));
        }
        if !is_time(start) {
            let allowed = format!("allowed is -{LATEST:e} to {LATEST:e} s: {GRID_REASON}");
            return Some(format!("start time: found {start}, {allowed}"));
        }
        let found = stop.filter(|stop| !(is_time(*stop) && *stop >= start))?;
        let allowed = format!("allowed is the start time {start} to {LATEST:e} s: {GRID_REASON}");
        Some(format!("stop time: found {found}, {allowed}"))
    }
}

const GRID_REASON: &str = "beyond, numbers are too coarse for the simulation's grid of time";

/// Whether a number can be a time, s; not-a-number cannot.
pub(super) fn is_time(time: f64) -> bool {
    time.abs() <= LATEST
}

/// An instance of the FMU.
#[derive(Debug)]
pub struct Instance {
    pub(super) model: Arc<ReducedModel>,
    pub(super) identity: u128,
    pub(super) table: VariableTable,
    pub(super) logger: Logger,
    pub(super) state: State,
    pub(super) experiment: Experiment,
    pub(super) settings: Settings,
    pub(super) inputs: Inputs,
    /// Rates of change of the inputs, from `fmi2SetRealInputDerivatives`.
    pub(super) rates: Inputs,
    /// The communication point that has been reached, s.
    pub(super) time: f64,
    /// Made when first needed, for it must be trimmed; made anew when a parameter changes.
    pub(super) flight: Option<Simulation>,
}

/// Communication points may differ by this fraction (of the time, at least of 1 s): masters add up steps.
pub(super) const TIME_SLACK: f64 = 1e-9;

impl Instance {
    /// Reads the model from the resources and compares the guid.
    ///
    /// # Errors
    /// When the resources are not there or of another FMU.
    pub fn new(
        resource_location: &[u8],
        given_guid: &str,
        logger: Logger,
    ) -> Result<Self, InstantiationError> {
        let path = resource::directory(resource_location)?.join(RESOURCE_FILE);
        let bytes =
            std::fs::read(&path).map_err(|source| InstantiationError::Read { path: path.clone(), source })?;
        let model =
            ReducedModel::from_bytes(&bytes).map_err(|source| InstantiationError::Model { path, source })?;
        let expected = guid(&model);
        if given_guid != expected {
            return Err(InstantiationError::Guid { found: given_guid.to_owned(), expected });
        }
        let instance = Instance::of_model(model, logger);
        instance.logger.log(Status::Ok, &format!("instantiated the aircraft `{}`", instance.model.name));
        Ok(instance)
    }

    /// In the state instantiated, with all variables at their starts.
    pub(super) fn of_model(model: ReducedModel, logger: Logger) -> Self {
        let engines = model.engines.len();
        Instance {
            identity: identity(&model),
            table: VariableTable::new(&model),
            logger,
            state: State::Instantiated,
            experiment: Experiment::default(),
            settings: start_settings(&model),
            inputs: Inputs::zero(engines),
            rates: Inputs::zero(engines),
            time: 0.0,
            flight: None,
            model: Arc::new(model),
        }
    }

    /// Runs the body of a function if the life cycle allows it; logs what is refused; turns a panic into
    /// `Fatal`, after which the instance can only be freed.
    pub fn call(
        &mut self,
        function: Function,
        body: impl FnOnce(&mut Self) -> Result<(), Refusal>,
    ) -> Status {
        if let Some(objection) = function.objection(self.state) {
            self.logger.log(Status::Error, &objection);
            return Status::Error;
        }
        // The instance is not used again after a panic, so a state broken halfway does no harm.
        match catch_unwind(AssertUnwindSafe(|| body(self))) {
            Ok(Ok(())) => Status::Ok,
            Ok(Err(refusal)) => {
                self.logger.log(refusal.status, &format!("{}: {}", function.name(), refusal.reason));
                refusal.status
            }
            Err(panic) => {
                self.state = State::Fatal;
                self.logger.log(Status::Fatal, &format!("{}: {}", function.name(), panic_text(&*panic)));
                Status::Fatal
            }
        }
    }

    /// `fmi2SetupExperiment`.
    pub fn set_up_experiment(&mut self, experiment: Experiment) -> Result<(), Refusal> {
        if let Some(objection) = experiment.objection() {
            return Err(Refusal::error(objection));
        }
        self.experiment = experiment;
        self.time = experiment.start;
        Ok(())
    }

    /// `fmi2EnterInitializationMode`.
    pub fn enter_initialization(&mut self) {
        self.state = State::InitializationMode;
    }

    /// `fmi2ExitInitializationMode`: trims, unless an output has been read already.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        self.flight()?;
        self.state = State::StepComplete;
        Ok(())
    }

    /// `fmi2Terminate`.
    pub fn terminate(&mut self) {
        self.state = State::Terminated;
        self.logger.log(Status::Ok, &format!("terminated at t = {} s", self.time));
    }

    /// `fmi2Reset`: as after instantiation; the log settings stay.
    pub fn reset(&mut self) {
        let engines = self.model.engines.len();
        self.state = State::Instantiated;
        self.experiment = Experiment::default();
        self.settings = start_settings(&self.model);
        self.inputs = Inputs::zero(engines);
        self.rates = Inputs::zero(engines);
        self.time = 0.0;
        self.flight = None;
        self.logger.log(Status::Ok, "reset");
    }

    /// `fmi2DoStep`, without allocating when it succeeds.
    pub fn do_step(&mut self, point: f64, size: f64) -> Result<(), Refusal> {
        let slack = TIME_SLACK * self.time.abs().max(1.0);
        if !size.is_finite() || size < 0.0 {
            let reason = format!("step size: found {size}, allowed is a finite number that is not negative");
            return Err(Refusal::error(reason));
        }
        if !point.is_finite() || (point - self.time).abs() > slack {
            let reason = format!("communication point: found {point}, expected {}", self.time);
            return Err(Refusal::error(reason));
        }
        let end = if size > 0.0 { self.time.max(point + size) } else { self.time };
        if !is_time(end) {
            let reason = format!("the step to {end} passes {LATEST:e} s: {GRID_REASON}");
            return Err(Refusal::error(reason));
        }
        if let Some(stop) = self.experiment.stop.filter(|stop| end > stop + slack) {
            return Err(Refusal::error(format!("the step to {end} passes the stop time {stop}")));
        }
        let began = self.time;
        if let Err(error) = self.flight()?.advance_to(end) {
            return Err(Refusal::error(format!("in the step from t = {began} s to {end} s: {error}")));
        }
        // The simulation knows that the inputs have ramped; this is for reading them.
        self.inputs.add(end - began, &self.rates);
        self.time = end;
        Ok(())
    }

    /// The flight under the present parameters and inputs, trimmed at the start time if it is new.
    pub(super) fn flight(&mut self) -> Result<&mut Simulation, Refusal> {
        match self.flight {
            Some(ref mut flight) => Ok(flight),
            None => {
                let flight = self.new_flight()?;
                Ok(self.flight.insert(flight))
            }
        }
    }

    fn new_flight(&self) -> Result<Simulation, Refusal> {
        let mut flight = self.trimmed(&self.settings, &self.experiment)?;
        flight.set_inputs(&self.inputs, &self.rates);
        let trim = flight.trim();
        let text = format!(
            "trimmed: pitch {} rad, elevator {} rad, thrust per engine {} N",
            trim.pitch, trim.elevator, trim.thrust
        );
        self.logger.log(Status::Ok, &text);
        Ok(flight)
    }

    pub(super) fn trimmed(
        &self,
        settings: &Settings,
        experiment: &Experiment,
    ) -> Result<Simulation, Refusal> {
        let tolerance = experiment.tolerance.unwrap_or(settings.tolerance);
        let settings = Settings { tolerance, ..settings.clone() };
        Simulation::new(self.model.clone(), &settings, experiment.start)
            .map_err(|error| Refusal::error(error.to_string()))
    }
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("internal error, please report it: {}", text.unwrap_or("no message"))
}

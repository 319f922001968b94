//! An instance of the FMU: life cycle, experiment and steps.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::aircraft::Support;
use crate::flight::{Inputs, LATEST, Neighbours, Settings, Simulation, resolution};
use crate::plant::LimitExceeded;
use crate::structure::{ReducedModel, StructureError};
use crate::variables::{Slot, VariableTable};

use super::description::{guid_of, identity};
use super::life_cycle::{Operation, State};
use super::log::{Category, Log};
use super::resource::RESOURCE_FILE;
use super::starts::{self, STARTS_FILE, StartsError};
use super::status::Status;

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
    /// The file of starts does not say what it should.
    #[error("resource {}: {source}", path.display())]
    Starts {
        /// Of the file.
        path: PathBuf,
        /// What is wrong with it.
        source: StartsError,
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

/// What the importer says of the experiment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Experiment {
    /// The tighter of it and the parameter counts.
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
        let found = stop.filter(|stop| stop.is_nan() || *stop < start)?;
        Some(format!("stop time: found {found}, allowed is the start time {start} s or later"))
    }
}

impl Experiment {
    /// The tighter of its tolerance and that of the parameter.
    pub fn tolerance_in_use(&self, settings: &Settings) -> f64 {
        self.tolerance.unwrap_or(settings.tolerance).min(settings.tolerance).max(TIGHTEST)
    }

    /// By how much a communication point may miss a time (s) that it should be, s: masters add up steps, and round.
    pub fn slack(&self, time: f64) -> f64 {
        1e-9 * (time - self.start).clamp(0.0, 1e6) + resolution(time)
    }
}

const GRID_REASON: &str = "beyond, doubles are too coarse for the simulation's grid of 10 ms";

/// Whether a number can be a time that is flown, s; not-a-number cannot.
pub(super) fn is_time(time: f64) -> bool {
    time.abs() <= LATEST
}

/// The tightest tolerance in use, whatever is asked for: the smallest that the parameter may have. Rounding comes next.
const TIGHTEST: f64 = 1e-12;

/// An instance of the FMU.
#[derive(Debug)]
pub struct Instance {
    pub(super) model: Arc<ReducedModel>,
    pub(super) identity: u128,
    pub(super) table: VariableTable,
    pub(crate) log: Log,
    pub(crate) state: State,
    pub(crate) experiment: Experiment,
    pub(super) settings: Settings,
    /// Of the settings.
    starts: Settings,
    pub(super) inputs: Inputs,
    /// Rates of change of the inputs that the importer gives beside their values.
    pub(super) rates: Inputs,
    /// Which of them, by value reference, were given at the present communication point: setting the input's value
    /// does not end them.
    pub(super) rate_is_new: Vec<bool>,
    /// The communication point that has been reached, s.
    pub(crate) time: f64,
    /// Made when first needed, for it must be trimmed; made anew when a parameter changes.
    pub(super) flight: Option<Simulation>,
    /// What the call in progress will warn of.
    warnings: Vec<String>,
    /// For derivatives by parameters, once they have been asked for, until the initialisation ends.
    pub(super) neighbours: Option<Neighbours>,
}

impl Instance {
    /// Reads the model from the resources and compares the guid.
    ///
    /// # Errors
    /// When the resources are not there or of another FMU.
    pub fn new(resources: &Path, given_guid: &str, log: Log) -> Result<Self, InstantiationError> {
        let path = resources.join(RESOURCE_FILE);
        let bytes =
            std::fs::read(&path).map_err(|source| InstantiationError::Read { path: path.clone(), source })?;
        let model =
            ReducedModel::from_bytes(&bytes).map_err(|source| InstantiationError::Model { path, source })?;
        let starts = read_starts(resources, &model)?;
        let instance = Instance::of_model(model, starts, log);
        let expected = guid_of(instance.identity);
        if given_guid != expected {
            return Err(InstantiationError::Guid { found: given_guid.to_owned(), expected });
        }
        instance.log.write(Status::Ok, &format!("instantiated the aircraft `{}`", instance.model.name));
        Ok(instance)
    }

    /// In the state instantiated, with all variables at their starts.
    fn of_model(model: ReducedModel, starts: Settings, log: Log) -> Self {
        let table = VariableTable::starting(&model, &starts);
        let input_count =
            table.iter().filter(|(_, variable)| matches!(variable.slot, Slot::Input(_))).count();
        Instance {
            identity: identity(&model, &starts),
            table,
            log,
            state: State::Instantiated,
            experiment: Experiment::default(),
            settings: starts.clone(),
            starts,
            inputs: Inputs::zero(&model),
            rates: Inputs::zero(&model),
            rate_is_new: vec![false; input_count],
            time: 0.0,
            flight: None,
            warnings: Vec::new(),
            neighbours: None,
            model: Arc::new(model),
        }
    }

    /// Runs the body of an operation if the life cycle allows it; logs what is refused; turns a panic into
    /// `Fatal`, after which the instance can only be freed.
    pub fn call(
        &mut self,
        operation: Operation,
        body: impl FnOnce(&mut Self) -> Result<(), Refusal>,
    ) -> Status {
        if let Some(objection) = operation.objection(self.state) {
            self.log.refuse(operation, objection);
            return Status::Error;
        }
        // The instance is not used again after a panic, so a state broken halfway does no harm.
        match catch_unwind(AssertUnwindSafe(|| body(self))) {
            Ok(Ok(())) if self.warnings.is_empty() => Status::Ok,
            Ok(Ok(())) => {
                for warning in std::mem::take(&mut self.warnings) {
                    self.log.write_of(operation, Status::Warning, &warning);
                }
                Status::Warning
            }
            Ok(Err(refusal)) => {
                self.warnings.clear();
                self.log.write_of(operation, refusal.status, &refusal.reason);
                refusal.status
            }
            Err(panic) => {
                self.state = State::Fatal;
                self.log.write_of(operation, Status::Fatal, &panic_text(&*panic));
                Status::Fatal
            }
        }
    }

    /// Has the call in progress end with a warning if it succeeds, and this in the log.
    pub(super) fn warn(&mut self, warning: String) {
        self.warnings.push(warning);
    }

    /// Chooses log categories by name (none given: all), or warnings and errors only when off.
    pub fn choose_log(&mut self, logging_on: bool, categories: &[String]) -> Result<(), Refusal> {
        let named = |name: &String| {
            let category = Category::ALL.into_iter().find(|category| category.name() == name);
            category.ok_or_else(|| {
                let allowed = Category::ALL.map(Category::name).join(", ");
                Refusal::error(format!("category: found `{name}`, allowed are {allowed}"))
            })
        };
        let chosen = categories.iter().map(named).collect::<Result<Vec<_>, _>>()?;
        self.log.choose(logging_on, &chosen);
        Ok(())
    }

    /// Takes the experiment.
    pub fn set_up_experiment(&mut self, experiment: Experiment) -> Result<(), Refusal> {
        if let Some(objection) = experiment.objection() {
            return Err(Refusal::error(objection));
        }
        self.experiment = experiment;
        self.time = experiment.start;
        Ok(())
    }

    /// Begins initialisation.
    pub fn enter_initialization(&mut self) {
        self.state = State::InitializationMode;
    }

    /// Ends initialisation: trims, unless an output has been read already. Warns of a trim beyond the aircraft's limits.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        let (model, settings) = (Arc::clone(&self.model), self.settings.clone());
        let warning = LimitExceeded::warning(self.flight()?.limits_exceeded(), &model, &settings.plant);
        self.neighbours = None;
        self.state = State::StepComplete;
        if let Some(warning) = warning {
            self.warn(warning);
        }
        Ok(())
    }

    /// Ends the simulation.
    pub fn terminate(&mut self) {
        self.state = State::Terminated;
        self.log.write(Status::Ok, &format!("terminated at t = {} s", self.time));
    }

    /// As after instantiation; the log settings stay.
    pub fn reset(&mut self) {
        self.state = State::Instantiated;
        self.experiment = Experiment::default();
        self.settings = self.starts.clone();
        self.inputs = Inputs::zero(&self.model);
        self.rates = Inputs::zero(&self.model);
        self.rate_is_new.fill(false);
        self.time = 0.0;
        self.flight = None;
        self.neighbours = None;
        self.log.write(Status::Ok, "reset");
    }

    /// Flies one communication step, without allocating when it succeeds.
    pub fn do_step(&mut self, point: f64, size: f64) -> Result<(), Refusal> {
        if !size.is_finite() || size < 0.0 {
            let reason = format!("step size: found {size}, allowed is a finite number that is not negative");
            return Err(Refusal::error(reason));
        }
        let began = self.time;
        if !point.is_finite() || (point - began).abs() > self.experiment.slack(began) {
            let reason = format!("communication point: found {point}, expected {began}");
            return Err(Refusal::error(reason));
        }
        let end = if size > 0.0 { began.max(point + size) } else { began };
        if !is_time(end) {
            let reason = format!("the step to {end} passes {LATEST:e} s: {GRID_REASON}");
            return Err(Refusal::error(reason));
        }
        if let Some(stop) = self.experiment.stop.filter(|stop| end > stop + self.experiment.slack(end)) {
            return Err(Refusal::error(format!("the step to {end} passes the stop time {stop}")));
        }
        // A master that is off by its rounding and does not step stays.
        let point = if size > 0.0 { point } else { began };
        if let Err(error) = self.flight()?.step(point, size) {
            return Err(Refusal::error(format!("in the step from t = {began} s to {end} s: {error}")));
        }
        if let Some(flight) = &self.flight {
            flight.write_inputs(&mut self.inputs);
        }
        if end > began {
            self.rate_is_new.fill(false);
        }
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
        let ReducedModel { support, controls, engines, .. } = &*self.model;
        let text = match support {
            Support::Free => format!("trimmed: {}", flight.trim().describe(controls, !engines.is_empty())),
            Support::Clamped => "at rest in the tunnel's flow".to_owned(),
        };
        self.log.write(Status::Ok, &text);
        Ok(flight)
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
}

/// Where the parameters start: as the file among the resources says, if there is one.
fn read_starts(resources: &Path, model: &ReducedModel) -> Result<Settings, InstantiationError> {
    let path = resources.join(STARTS_FILE);
    match std::fs::read_to_string(&path) {
        Ok(text) => starts::read(&text, model).map_err(|source| InstantiationError::Starts { path, source }),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Settings::of(model)),
        Err(source) => Err(InstantiationError::Read { path, source }),
    }
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("internal error, please report it: {}", text.unwrap_or("no message"))
}

//! An instance of the FMU: life cycle and experiment.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::flight::{Inputs, LATEST, Neighbours, Settings, resolution};
use crate::structure::{ReducedModel, StructureError};
use crate::variables::{ArchiveTable, Place, Slot};

use super::description::{identity, token_of};
use super::interface::{Interface, Kind, Version};
use super::life_cycle::State;
use super::log::{Category, Log};
use super::motion::Motion;
use super::operation::Operation;
use super::refusal::Refusal;
use super::resource::RESOURCE_FILE;
use super::starts::{self, STARTS_FILE, StartsError};
use super::status::Status;

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
    #[error("{name}: the model description given has `{found}`, this FMU is `{expected}`")]
    Token {
        /// What the version of FMI calls it.
        name: &'static str,
        /// Given.
        found: String,
        /// Of this FMU.
        expected: String,
    },
    /// The archive is for something else.
    #[error("this archive is {own}, not {asked}")]
    Interface {
        /// What it is for.
        own: Interface,
        /// What was asked for.
        asked: Interface,
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

pub(super) const GRID_REASON: &str = "beyond, doubles are too coarse for the simulation's grid of 10 ms";

/// Whether a number can be a time that is flown, s; not-a-number cannot.
pub(super) fn is_time(time: f64) -> bool {
    time.abs() <= LATEST
}

/// The tightest tolerance in use, whatever is asked for: the smallest that the parameter may have. Rounding comes next.
const TIGHTEST: f64 = 1e-12;

/// An instance of the FMU.
#[derive(Debug)]
pub struct Instance {
    pub(super) interface: Interface,
    pub(super) model: Arc<ReducedModel>,
    pub(super) identity: u128,
    pub(super) table: ArchiveTable,
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
    /// That has been reached, s.
    pub(crate) time: f64,
    /// Made when first needed, for it must be trimmed; made anew when a parameter changes.
    pub(super) motion: Option<Motion>,
    /// What the call in progress will warn of.
    warnings: Vec<String>,
    /// For derivatives by parameters, once they have been asked for, until the initialisation ends.
    pub(super) neighbours: Option<Neighbours>,
}

impl Instance {
    /// Reads the model from the resources and compares the token.
    ///
    /// # Errors
    /// When the resources are not there, of another FMU or of another kind.
    pub fn new(
        interface: Interface,
        resources: &Path,
        given_token: &str,
        log: Log,
    ) -> Result<Self, InstantiationError> {
        let path = resources.join(RESOURCE_FILE);
        let bytes =
            std::fs::read(&path).map_err(|source| InstantiationError::Read { path: path.clone(), source })?;
        let model =
            ReducedModel::from_bytes(&bytes).map_err(|source| InstantiationError::Model { path, source })?;
        let of = |interface: Interface| {
            let starts = read_starts(interface, resources, &model)?;
            let table = ArchiveTable::new(&model, &starts, interface.extent());
            let identity = identity(interface, &model, &starts, &table);
            Ok((starts, table, identity))
        };
        let (starts, table, identity) = of(interface)?;
        let expected = token_of(identity);
        if given_token != expected {
            let is_of = |other: &Interface| of(*other).is_ok_and(|(.., id)| token_of(id) == given_token);
            let others = Interface::ALL.into_iter().filter(|other| *other != interface);
            return Err(match others.into_iter().find(is_of) {
                Some(own) => InstantiationError::Interface { own, asked: interface },
                None => InstantiationError::Token {
                    name: match interface.version {
                        Version::V2 => "guid",
                        Version::V3 => "instantiation token",
                    },
                    found: given_token.to_owned(),
                    expected,
                },
            });
        }
        let instance = Instance::of_model(interface, (model, table, identity), starts, log);
        instance.log.write(Status::Ok, &format!("instantiated the aircraft `{}`", instance.model.name));
        Ok(instance)
    }

    /// In the state instantiated, with all variables at their starts.
    fn of_model(
        interface: Interface,
        (model, table, identity): (ReducedModel, ArchiveTable, u128),
        starts: Settings,
        log: Log,
    ) -> Self {
        let is_input = |place: Place| matches!(place, Place::Common(Slot::Input(_)));
        let input_count = table.iter().filter(|(_, variable)| is_input(variable.slot)).count();
        Instance {
            interface,
            identity,
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
            motion: None,
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
        if let Some(objection) = operation.objection(self.interface, self.state) {
            self.log.refuse(operation, objection);
            self.end_by_error();
            return Status::Error;
        }
        let has_been_trimmed = self.motion.is_some();
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
                if !has_been_trimmed {
                    // Or a saved state would tell of a call that was refused.
                    self.motion = None;
                }
                self.log.write_of(operation, refusal.status, &refusal.reason);
                if refusal.status == Status::Error {
                    self.end_by_error();
                }
                refusal.status
            }
            Err(panic) => {
                self.state = State::Fatal;
                self.log.write_of(operation, Status::Fatal, &panic_text(&*panic));
                Status::Fatal
            }
        }
    }

    /// A wrong call ends an instance of FMI 3.0 (3.0.2, 2.3.1) and leaves one of FMI 2.0 as it was.
    fn end_by_error(&mut self) {
        if self.interface.version == Version::V3 && self.state != State::Fatal {
            self.state = State::Terminated;
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
        if experiment != self.experiment {
            self.motion = None;
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
        let warning = self.limits_warning()?;
        self.neighbours = None;
        self.state = match self.interface.kind {
            Kind::CoSimulation => State::StepComplete,
            Kind::ModelExchange => State::EventMode,
        };
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
        self.motion = None;
        self.neighbours = None;
        self.log.write(Status::Ok, "reset");
    }
}

/// Where the parameters start: as the file among the resources says, if there is one.
fn read_starts(
    interface: Interface,
    resources: &Path,
    model: &ReducedModel,
) -> Result<Settings, InstantiationError> {
    let path = resources.join(STARTS_FILE);
    match std::fs::read_to_string(&path) {
        Ok(text) => starts::read(&text, interface, model)
            .map_err(|source| InstantiationError::Starts { path, source }),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(starts::usual(interface, model)),
        Err(source) => Err(InstantiationError::Read { path, source }),
    }
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("internal error, please report it: {}", text.unwrap_or("no message"))
}

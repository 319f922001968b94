//! The C ABI driven as an importer drives it, through the exported functions.

pub(crate) mod allocation;
mod derivatives;
mod devices;
pub(crate) mod endurance;
pub(crate) mod exchange;
mod flight;
mod importers;
mod initial_derivatives;
mod input_rates;
mod instantiation;
mod joints;
mod life_cycle;
mod linear_model;
mod load_modes;
pub(crate) mod mutated;
pub(crate) mod random;
mod reading;
mod state;
pub(crate) mod surface;
mod time;
mod variables;

use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::PathBuf;
use std::ptr::{null, null_mut};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::exports::*;
use super::types::{CallbackFunctions, CallbackLogger, Component, FmuState, Status};
use crate::flight::Settings;
use crate::fmi::description;
use crate::fmi::operation::Operation;
use crate::fmi::{Interface, Kind, RESOURCE_FILE, Version, starts};
use crate::structure::ReducedModel;
use crate::structure::test_jet::jet;
use crate::variables::{Slot, Type, Variable, VariableTable};

/// Of the FMU of an aircraft whose parameters start as its own.
fn guid(model: &ReducedModel) -> String {
    description::token(Interface::USUAL, model, &Settings::of(model))
}

/// The function by which an operation is asked for.
fn name(operation: Operation) -> &'static str {
    operation.name(Version::V2).expect("an operation of FMI 2.0")
}

/// The operations that FMI 2.0 has.
fn operations() -> impl Iterator<Item = Operation> {
    Operation::ALL.iter().copied().filter(|operation| operation.name(Version::V2).is_some())
}

/// Those of an importer that gives none.
fn no_callbacks() -> CallbackFunctions {
    CallbackFunctions {
        logger: None,
        allocate_memory: None,
        free_memory: None,
        step_finished: None,
        component_environment: null_mut(),
    }
}

/// A message as the importer's logger gets it.
#[derive(Clone, Debug, PartialEq)]
struct Message {
    instance: String,
    status: Status,
    category: String,
    format: String,
}

type Log = RefCell<Vec<Message>>;

extern "C" fn logger(
    environment: *mut c_void,
    instance: *const c_char,
    status: Status,
    category: *const c_char,
    format: *const c_char,
) {
    // SAFETY: the FMU passes NUL-terminated strings, and as environment what the tests gave it: a `Log`.
    let (log, [instance, category, format]) = unsafe {
        let texts =
            [instance, category, format].map(|text| CStr::from_ptr(text).to_str().unwrap().to_owned());
        (&*environment.cast::<Log>(), texts)
    };
    log.borrow_mut().push(Message { instance, status, category, format });
}

fn variadic_logger() -> CallbackLogger {
    let plain = logger as *const ();
    // SAFETY: on the platforms that the tests run on, a caller that passes no variadic arguments calls a
    // variadic function like any other; importers with ctypes rely on the same.
    unsafe { std::mem::transmute::<*const (), CallbackLogger>(plain) }
}

/// A directory that is removed in the end, with the model in `resources/`.
pub(crate) struct Unpacked(PathBuf);

impl Unpacked {
    fn new(name: &str) -> Self {
        static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
        Unpacked::of(BYTES.get_or_init(|| jet().to_bytes()), name)
    }

    /// With these bytes as the model.
    fn of(model: &[u8], name: &str) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let unique = format!("fmi2-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let root = std::env::temp_dir().join(unique);
        let resources = root.join(name).join("resources");
        std::fs::create_dir_all(&resources).unwrap();
        std::fs::write(resources.join(RESOURCE_FILE), model).unwrap();
        Unpacked(root)
    }

    fn uri(&self, name: &str) -> String {
        format!("file://{}/{name}/resources", self.0.display())
    }
}

impl Drop for Unpacked {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// An instance with its log.
struct Fmu {
    component: Component,
    log: Box<Log>,
}

/// What `fmi2Instantiate` is given.
#[derive(Debug)]
struct Request<'a> {
    name: Option<&'a str>,
    kind: c_int,
    guid: Option<&'a str>,
    uri: Option<&'a str>,
    logging_on: bool,
}

impl Fmu {
    /// Calls `fmi2Instantiate`; the component may be NULL.
    fn request(request: &Request) -> Fmu {
        Fmu::with_logger(request, Some(variadic_logger()))
    }

    /// The same with any logger, or none.
    fn with_logger(request: &Request, logger: Option<CallbackLogger>) -> Fmu {
        let log: Box<Log> = Box::default();
        let callbacks = CallbackFunctions {
            logger,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: (&raw const *log).cast_mut().cast(),
        };
        let [name, guid, uri] = [request.name, request.guid, request.uri]
            .map(|text| text.map(|text| CString::new(text).unwrap()));
        let pointer = |text: &Option<CString>| text.as_ref().map_or(null(), |text| text.as_ptr());
        let (name, guid, uri) = (pointer(&name), pointer(&guid), pointer(&uri));
        // SAFETY: strings and callbacks live during the call, the log as long as the instance.
        let component = unsafe {
            fmi2Instantiate(name, request.kind, guid, uri, &callbacks, 0, c_int::from(request.logging_on))
        };
        Fmu { component, log }
    }

    /// For co-simulation, in the state instantiated.
    fn new() -> Fmu {
        Fmu::of(Kind::CoSimulation, jet())
    }

    /// Of a kind and an aircraft, in the state instantiated.
    fn of(kind: Kind, model: &ReducedModel) -> Fmu {
        let unpacked = Unpacked::of(&model.to_bytes(), "aircraft");
        let interface = Interface { version: Version::V2, kind };
        let token = description::token(interface, model, &starts::usual(interface, model));
        let request = Request {
            name: Some("jet"),
            kind: match kind {
                Kind::ModelExchange => 0,
                Kind::CoSimulation => 1,
            },
            guid: Some(&token),
            uri: Some(&unpacked.uri("aircraft")),
            logging_on: false,
        };
        let fmu = Fmu::request(&request);
        assert!(!fmu.component.is_null(), "{:?}", fmu.log);
        fmu
    }

    /// In initialisation mode.
    fn initialising() -> Fmu {
        let fmu = Fmu::new();
        assert_eq!(fmu.set_up(None, 0.0, None), Status::Ok);
        assert_eq!(fmu.enter(), Status::Ok);
        fmu
    }

    /// At the first communication point.
    fn flying() -> Fmu {
        let fmu = Fmu::initialising();
        assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
        fmu
    }

    fn set_up(&self, tolerance: Option<f64>, start: f64, stop: Option<f64>) -> Status {
        let flag = |option: Option<f64>| c_int::from(option.is_some());
        let (tolerance_defined, stop_defined) = (flag(tolerance), flag(stop));
        let (tolerance, stop) = (tolerance.unwrap_or_default(), stop.unwrap_or_default());
        // SAFETY: the component is alive.
        unsafe {
            fmi2SetupExperiment(self.component, tolerance_defined, tolerance, start, stop_defined, stop)
        }
    }

    fn enter(&self) -> Status {
        // SAFETY: the component is alive.
        unsafe { fmi2EnterInitializationMode(self.component) }
    }

    fn exit(&self) -> Status {
        // SAFETY: the component is alive.
        unsafe { fmi2ExitInitializationMode(self.component) }
    }

    fn step(&self, point: f64, size: f64) -> Status {
        // SAFETY: the component is alive.
        unsafe { fmi2DoStep(self.component, point, size, 1) }
    }

    fn terminate(&self) -> Status {
        // SAFETY: the component is alive.
        unsafe { fmi2Terminate(self.component) }
    }

    fn reset(&self) -> Status {
        // SAFETY: the component is alive.
        unsafe { fmi2Reset(self.component) }
    }

    fn set_references(&self, references: &[u32], values: &[f64]) -> Status {
        // SAFETY: the component is alive, the arrays are equally long.
        unsafe { fmi2SetReal(self.component, references.as_ptr(), references.len(), values.as_ptr()) }
    }

    fn set(&self, pairs: &[(&str, f64)]) -> Status {
        let references: Vec<u32> = pairs.iter().map(|(name, _)| reference(name)).collect();
        let values: Vec<f64> = pairs.iter().map(|(_, value)| *value).collect();
        self.set_references(&references, &values)
    }

    /// `fmi2SetRealInputDerivatives`: names, orders and values.
    fn set_rates(&self, rates: &[(&str, c_int, f64)]) -> Status {
        let references: Vec<u32> = rates.iter().map(|(name, ..)| reference(name)).collect();
        let orders: Vec<c_int> = rates.iter().map(|(_, order, _)| *order).collect();
        let values: Vec<f64> = rates.iter().map(|(.., value)| *value).collect();
        let (references, count) = (references.as_ptr(), references.len());
        // SAFETY: the component is alive, the arrays are equally long.
        unsafe {
            fmi2SetRealInputDerivatives(self.component, references, count, orders.as_ptr(), values.as_ptr())
        }
    }

    fn set_integer(&self, name: &str, value: c_int) -> Status {
        // SAFETY: the component is alive, the arrays have one element.
        unsafe { fmi2SetInteger(self.component, &reference(name), 1, &value) }
    }

    fn get_references(&self, references: &[u32]) -> Result<Vec<f64>, Status> {
        let mut values = vec![0.0; references.len()];
        // SAFETY: the component is alive, the arrays are equally long.
        let status = unsafe {
            fmi2GetReal(self.component, references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        if status == Status::Ok { Ok(values) } else { Err(status) }
    }

    fn get(&self, name: &str) -> f64 {
        self.get_references(&[reference(name)])
            .unwrap_or_else(|status| panic!("{name}: {status:?} {:?}", self.log))[0]
    }

    fn get_integer(&self, name: &str) -> Result<c_int, Status> {
        let mut value = 0;
        // SAFETY: the component is alive, the arrays have one element.
        let status = unsafe { fmi2GetInteger(self.component, &reference(name), 1, &mut value) };
        if status == Status::Ok { Ok(value) } else { Err(status) }
    }

    fn set_boolean(&self, name: &str, value: c_int) -> Status {
        // SAFETY: the component is alive, the arrays have one element.
        unsafe { fmi2SetBoolean(self.component, &reference(name), 1, &value) }
    }

    fn get_booleans(&self, references: &[u32]) -> Result<Vec<c_int>, Status> {
        let mut values = vec![-1; references.len()];
        // SAFETY: the component is alive, the arrays are equally long.
        let status = unsafe {
            fmi2GetBoolean(self.component, references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        if status == Status::Ok { Ok(values) } else { Err(status) }
    }

    fn get_boolean(&self, name: &str) -> c_int {
        self.get_booleans(&[reference(name)]).unwrap()[0]
    }

    /// All outputs, bit for bit.
    fn outputs(&self) -> Vec<u64> {
        let table = VariableTable::new(jet());
        let reals = self.get_references(&outputs_of(&table, Type::Real)).unwrap();
        let flags = self.get_booleans(&outputs_of(&table, Type::Boolean)).unwrap();
        reals.into_iter().map(f64::to_bits).chain(flags.into_iter().map(|flag| flag as u64)).collect()
    }

    fn last_message(&self) -> Message {
        self.log.borrow().last().expect("nothing was logged").clone()
    }

    /// The last message is an error and contains all these parts.
    fn assert_refused(&self, parts: &[&str]) {
        let message = self.last_message();
        assert_eq!((message.status, message.category.as_str()), (Status::Error, "logStatusError"));
        for part in parts {
            assert!(message.format.contains(part), "`{part}` is missing in: {}", message.format);
        }
    }
}

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: the component is NULL or alive, and not used after this.
        unsafe { fmi2FreeInstance(self.component) };
    }
}

/// A flight for tests of other versions, of which every call succeeds.
pub(crate) struct Flying(Fmu);

impl Flying {
    /// Of the jet, before its initialisation.
    pub fn new() -> Self {
        Flying(Fmu::new())
    }

    /// Sets Reals.
    pub fn set(&self, pairs: &[(&str, f64)]) {
        assert_eq!(self.0.set(pairs), Status::Ok, "{:?}", self.0.log);
    }

    /// Begins at a time, s.
    pub fn initialise(&self, start: f64) {
        assert_eq!(self.0.set_up(None, start, None), Status::Ok);
        assert_eq!((self.0.enter(), self.0.exit()), (Status::Ok, Status::Ok), "{:?}", self.0.log);
    }

    /// Flies on.
    pub fn step(&self, point: f64, size: f64) {
        assert_eq!(self.0.step(point, size), Status::Ok, "{:?}", self.0.log);
    }

    /// Values of Reals.
    pub fn get(&self, references: &[u32]) -> Vec<f64> {
        self.0.get_references(references).unwrap()
    }
}

fn reference(name: &str) -> u32 {
    VariableTable::new(jet()).reference(name).unwrap_or_else(|| panic!("no variable `{name}`"))
}

/// The outputs of a type.
fn outputs_of(table: &VariableTable, kind: Type) -> Vec<u32> {
    let is_wanted = |v: &Variable| v.kind == kind && matches!(v.slot, Slot::Output(_));
    table.iter().filter(|(_, v)| is_wanted(v)).map(|(reference, _)| reference).collect()
}

/// The state of an instance.
fn saved(instance: &crate::fmi::instance::Instance) -> crate::fmi::saved_state::SavedState {
    let mut saved = crate::fmi::saved_state::SavedState::default();
    instance.save_into(&mut saved);
    saved
}

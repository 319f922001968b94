//! The C ABI driven as an importer drives it, through the exported functions.

mod co_simulation;
mod endurance;
mod exchange;
mod instantiation;
mod life_cycle;
mod mutated;
mod random;
mod surface;
mod variables;

use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::PathBuf;
use std::ptr::{null, null_mut};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::exports::*;
use super::types::{Instance, LogMessageCallback, Status};
use crate::fmi::{Interface, Kind, RESOURCE_FILE, Version, description, starts};
use crate::structure::ReducedModel;
use crate::structure::test_jet::jet;
use crate::variables::{ArchiveTable, Type, Variable};

/// A message as the importer's logger gets it.
#[derive(Clone, Debug, PartialEq)]
struct Message {
    status: Status,
    category: String,
    text: String,
}

type Log = RefCell<Vec<Message>>;

unsafe extern "C" fn logger(
    environment: *mut c_void,
    status: Status,
    category: *const c_char,
    text: *const c_char,
) {
    // SAFETY: the FMU passes NUL-terminated strings, and as environment what the tests gave it: a `Log`.
    let (log, [category, text]) = unsafe {
        let texts = [category, text].map(|text| CStr::from_ptr(text).to_str().unwrap().to_owned());
        (&*environment.cast::<Log>(), texts)
    };
    log.borrow_mut().push(Message { status, category, text });
}

/// A folder of resources that is removed in the end.
struct Resources(PathBuf);

impl Resources {
    fn of(model: &ReducedModel) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let unique = format!("fmi3-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(unique);
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(RESOURCE_FILE), model.to_bytes()).unwrap();
        Resources(folder)
    }

    fn path(&self) -> String {
        self.0.to_str().unwrap().to_owned()
    }
}

impl Drop for Resources {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// What an instantiating function is given.
#[derive(Clone, Debug)]
struct Request {
    kind: Kind,
    token: Option<String>,
    path: Option<String>,
    event_mode_used: u8,
    intermediate_variables: usize,
    logging_on: u8,
}

impl Request {
    fn of(kind: Kind, model: &ReducedModel, resources: &Resources) -> Self {
        let interface = Interface { version: Version::V3, kind };
        Request {
            kind,
            token: Some(description::token(interface, model, &starts::usual(interface, model))),
            path: Some(resources.path()),
            event_mode_used: 0,
            intermediate_variables: 0,
            logging_on: 0,
        }
    }
}

/// An instance with its log and its variables.
struct Fmu {
    instance: Instance,
    log: Box<Log>,
    table: ArchiveTable,
}

impl Fmu {
    /// Instantiates; the instance may be NULL.
    fn request(request: &Request, model: &ReducedModel) -> Fmu {
        Fmu::with_logger(request, model, Some(logger))
    }

    /// The same with any logger, or none.
    fn with_logger(request: &Request, model: &ReducedModel, logger: Option<LogMessageCallback>) -> Fmu {
        let log: Box<Log> = Box::default();
        let environment = (&raw const *log).cast_mut().cast();
        let [token, path] =
            [&request.token, &request.path].map(|text| text.clone().map(|text| CString::new(text).unwrap()));
        let pointer = |text: &Option<CString>| text.as_ref().map_or(null(), |text| text.as_ptr());
        let (name, token, path) = (c"".as_ptr(), pointer(&token), pointer(&path));
        // SAFETY: strings live during the call, the log as long as the instance.
        let instance = unsafe {
            match request.kind {
                Kind::CoSimulation => fmi3InstantiateCoSimulation(
                    name,
                    token,
                    path,
                    0,
                    request.logging_on,
                    request.event_mode_used,
                    1,
                    null(),
                    request.intermediate_variables,
                    environment,
                    logger,
                    None,
                ),
                Kind::ModelExchange => fmi3InstantiateModelExchange(
                    name,
                    token,
                    path,
                    0,
                    request.logging_on,
                    environment,
                    logger,
                ),
            }
        };
        let interface = Interface { version: Version::V3, kind: request.kind };
        let table = ArchiveTable::new(model, &starts::usual(interface, model), interface.extent());
        Fmu { instance, log, table }
    }

    /// Of the jet, in the state Instantiated.
    fn new(kind: Kind) -> Fmu {
        Fmu::of(kind, jet())
    }

    /// Of any aircraft.
    fn of(kind: Kind, model: &ReducedModel) -> Fmu {
        let resources = Resources::of(model);
        let fmu = Fmu::request(&Request::of(kind, model, &resources), model);
        assert!(!fmu.instance.is_null(), "{:?}", fmu.log);
        fmu
    }

    fn reference(&self, name: &str) -> u32 {
        let found = self.table.iter().find(|(_, row)| row.name == name);
        found.unwrap_or_else(|| panic!("no variable `{name}`")).0
    }

    /// Begins at a time, s.
    fn initialise(&self, start: f64) -> Status {
        // SAFETY: the instance is alive.
        unsafe {
            match fmi3EnterInitializationMode(self.instance, 0, 0.0, start, 0, 0.0) {
                Status::Ok => fmi3ExitInitializationMode(self.instance),
                refused => refused,
            }
        }
    }

    fn step(&self, point: f64, size: f64) -> Status {
        let (mut flags, mut reached) = ([9_u8; 3], f64::NAN);
        let [events, ends, returns] = &mut flags;
        // SAFETY: the instance is alive, the places are there.
        let status =
            unsafe { fmi3DoStep(self.instance, point, size, 1, events, ends, returns, &mut reached) };
        if status == Status::Ok {
            assert_eq!(flags, [0; 3]);
            assert!((reached - point - size).abs() < 1e-9, "{reached}");
        }
        status
    }

    fn set(&self, pairs: &[(&str, f64)]) -> Status {
        let references: Vec<u32> = pairs.iter().map(|(name, _)| self.reference(name)).collect();
        let values: Vec<f64> = pairs.iter().map(|(_, value)| *value).collect();
        let count = references.len();
        // SAFETY: the instance is alive, the arrays are as long as said.
        unsafe { fmi3SetFloat64(self.instance, references.as_ptr(), count, values.as_ptr(), count) }
    }

    fn get_references(&self, references: &[u32]) -> Result<Vec<f64>, Status> {
        let (mut values, count) = (vec![0.0; references.len()], references.len());
        // SAFETY: the instance is alive, the arrays are as long as said.
        let status =
            unsafe { fmi3GetFloat64(self.instance, references.as_ptr(), count, values.as_mut_ptr(), count) };
        if status == Status::Ok { Ok(values) } else { Err(status) }
    }

    fn get(&self, name: &str) -> f64 {
        self.get_references(&[self.reference(name)])
            .unwrap_or_else(|status| panic!("{name}: {status:?} {:?}", self.log))[0]
    }

    fn last_message(&self) -> Message {
        self.log.borrow().last().expect("nothing was logged").clone()
    }

    /// The last message is an error and contains all these parts.
    fn assert_refused(&self, parts: &[&str]) {
        let message = self.last_message();
        assert_eq!((message.status, message.category.as_str()), (Status::Error, "logStatusError"));
        for part in parts {
            assert!(message.text.contains(part), "`{part}` is missing in: {}", message.text);
        }
    }
}

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: the instance is NULL or alive, and not used after this.
        unsafe { fmi3FreeInstance(self.instance) };
    }
}

/// References of the Float64 variables of a table that are wanted.
fn reals(table: &ArchiveTable, wanted: impl Fn(&Variable<crate::variables::Place>) -> bool) -> Vec<u32> {
    let is_real = |row: &Variable<_>| row.kind == Type::Real;
    table.iter().filter(|(_, row)| is_real(row) && wanted(row)).map(|(reference, _)| reference).collect()
}

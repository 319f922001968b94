//! What an importer does with an instance, whatever the version of FMI and the kind: for tests that drive all of them.

use crate::fmi::instance::Instance;
use crate::sealed::{CHECKSUM, HEADER, hash};
use crate::variables::ArchiveTable;

use super::*;

/// How an instance is made.
pub(crate) struct Instantiation<'a> {
    pub kind: Kind,
    pub model: &'a ReducedModel,
    pub token: &'a str,
    /// Of the resources.
    pub folder: &'a str,
    pub logging_on: bool,
    pub has_logger: bool,
    /// One of a few that each version has.
    pub flaw: Option<u8>,
}

/// A version of FMI: an instance with its log.
pub(crate) trait Surface: Sized {
    const VERSION: Version;
    const STATES: StateFunctions;
    const EXCHANGE: ExchangeFunctions;

    /// The component may be NULL.
    fn instantiate(request: &Instantiation) -> Self;

    /// To be freed with it.
    fn component(&self) -> Component;

    /// How many messages there have been of something that is not as it should be.
    fn complaint_count(&self) -> usize;

    /// Its status and text.
    fn last_message(&self) -> Option<(Status, String)>;

    /// Forgets them.
    fn forget_messages(&self);

    /// From instantiated on to the end of the initialisation.
    fn initialise(&self) -> Status;

    /// Back to instantiated.
    fn reset(&self) -> Status;

    /// One of co-simulation.
    fn step(&self, point: f64, size: f64) -> Status;

    /// As many values as references.
    fn set_reals(&self, references: &[u32], values: &[f64]) -> Status;

    /// As many values as references.
    fn get_reals(&self, references: &[u32], values: &mut [f64]) -> Status;
}

/// The functions of saved states, which differ between the versions in their names.
pub(crate) struct StateFunctions {
    pub get: unsafe extern "C" fn(Component, *mut FmuState) -> Status,
    pub set: unsafe extern "C" fn(Component, FmuState) -> Status,
    pub free: unsafe extern "C" fn(Component, *mut FmuState) -> Status,
    pub size: unsafe extern "C" fn(Component, FmuState, *mut usize) -> Status,
    pub serialise: unsafe extern "C" fn(Component, FmuState, *mut u8, usize) -> Status,
    pub deserialise: unsafe extern "C" fn(Component, *const u8, usize, *mut FmuState) -> Status,
}

/// The functions of model exchange that differ between the versions in their names.
pub(crate) struct ExchangeFunctions {
    pub enter: unsafe extern "C" fn(Component) -> Status,
    pub set_time: unsafe extern "C" fn(Component, f64) -> Status,
    pub set_states: unsafe extern "C" fn(Component, *const f64, usize) -> Status,
    pub states: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
    pub rates: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
    pub nominals: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
    pub indicators: unsafe extern "C" fn(Component, *mut f64, usize) -> Status,
}

unsafe extern "C" fn serialise(c: Component, state: FmuState, bytes: *mut u8, size: usize) -> Status {
    // SAFETY: as of the function called.
    unsafe { fmi2SerializeFMUstate(c, state, bytes.cast(), size) }
}

unsafe extern "C" fn deserialise(
    c: Component,
    bytes: *const u8,
    size: usize,
    place: *mut FmuState,
) -> Status {
    // SAFETY: as of the function called.
    unsafe { fmi2DeSerializeFMUstate(c, bytes.cast(), size, place) }
}

impl Surface for Fmu {
    const VERSION: Version = Version::V2;
    const STATES: StateFunctions = StateFunctions {
        get: fmi2GetFMUstate,
        set: fmi2SetFMUstate,
        free: fmi2FreeFMUstate,
        size: fmi2SerializedFMUstateSize,
        serialise,
        deserialise,
    };
    const EXCHANGE: ExchangeFunctions = ExchangeFunctions {
        enter: fmi2EnterContinuousTimeMode,
        set_time: fmi2SetTime,
        set_states: fmi2SetContinuousStates,
        states: fmi2GetContinuousStates,
        rates: fmi2GetDerivatives,
        nominals: fmi2GetNominalsOfContinuousStates,
        indicators: fmi2GetEventIndicators,
    };

    fn instantiate(request: &Instantiation) -> Self {
        let kind = match request.kind {
            Kind::ModelExchange => 0,
            Kind::CoSimulation => 1,
        };
        let uri = format!("file://{}", request.folder);
        let good = Request {
            name: Some("/a b/%s/é"),
            kind,
            guid: Some(request.token),
            uri: Some(&uri),
            logging_on: request.logging_on,
        };
        let request_to_make = match request.flaw {
            None => good,
            Some(0) => Request { name: None, ..good },
            Some(1) => Request { kind: 7, ..good },
            Some(2) => Request { guid: Some("%n"), ..good },
            Some(_) => Request { uri: None, ..good },
        };
        Fmu::with_logger(&request_to_make, request.has_logger.then(variadic_logger))
    }

    fn component(&self) -> Component {
        self.component
    }

    fn complaint_count(&self) -> usize {
        self.log.borrow().iter().filter(|message| message.status != Status::Ok).count()
    }

    fn last_message(&self) -> Option<(Status, String)> {
        self.log.borrow().last().map(|message| (message.status, message.format.clone()))
    }

    fn forget_messages(&self) {
        self.log.borrow_mut().clear();
    }

    fn initialise(&self) -> Status {
        let statuses = [self.set_up(None, 0.0, None), self.enter(), self.exit()];
        statuses.into_iter().find(|status| *status != Status::Ok).unwrap_or(Status::Ok)
    }

    fn reset(&self) -> Status {
        Fmu::reset(self)
    }

    fn step(&self, point: f64, size: f64) -> Status {
        Fmu::step(self, point, size)
    }

    fn set_reals(&self, references: &[u32], values: &[f64]) -> Status {
        self.set_references(references, values)
    }

    fn get_reals(&self, references: &[u32], values: &mut [f64]) -> Status {
        assert_eq!(references.len(), values.len());
        // SAFETY: the component is alive, the arrays are equally long.
        unsafe { fmi2GetReal(self.component, references.as_ptr(), values.len(), values.as_mut_ptr()) }
    }
}

/// A saved state, freed in the end.
pub(crate) struct Saved<'a, S: Surface> {
    fmu: &'a S,
    pub state: FmuState,
}

impl<'a, S: Surface> Saved<'a, S> {
    pub fn of(fmu: &'a S) -> Self {
        let mut state = null_mut();
        // SAFETY: the component is alive.
        assert_eq!(unsafe { (S::STATES.get)(fmu.component(), &mut state) }, Status::Ok);
        Saved { fmu, state }
    }

    pub fn from_bytes(fmu: &'a S, bytes: &[u8]) -> Result<Self, Status> {
        let mut state = null_mut();
        // SAFETY: the component is alive, the array is as long as said.
        let status =
            unsafe { (S::STATES.deserialise)(fmu.component(), bytes.as_ptr(), bytes.len(), &mut state) };
        if status == Status::Ok { Ok(Saved { fmu, state }) } else { Err(status) }
    }

    pub fn bytes(&self) -> Vec<u8> {
        let (c, mut size) = (self.fmu.component(), 0);
        // SAFETY: component and state are alive.
        assert_eq!(unsafe { (S::STATES.size)(c, self.state, &mut size) }, Status::Ok);
        let mut bytes = vec![0; size];
        // SAFETY: component and state are alive, the array is as long as said.
        assert_eq!(unsafe { (S::STATES.serialise)(c, self.state, bytes.as_mut_ptr(), size) }, Status::Ok);
        bytes
    }

    pub fn restore(&self) -> Status {
        // SAFETY: component and state are alive.
        unsafe { (S::STATES.set)(self.fmu.component(), self.state) }
    }
}

impl<S: Surface> Drop for Saved<'_, S> {
    fn drop(&mut self) {
        // SAFETY: component and state are alive; the state is not used after this.
        let status = unsafe { (S::STATES.free)(self.fmu.component(), &mut self.state) };
        assert_eq!(status, Status::Ok);
        assert!(self.state.is_null());
    }
}

/// What is behind a component.
pub(crate) fn instance(component: Component) -> &'static mut Instance {
    // SAFETY: a component is an `Instance`; the reference is given up before the next call into the FMU.
    unsafe { &mut *component.cast::<Instance>() }
}

/// Makes length and checksum of a state right, so that everything else is put to the test.
pub(crate) fn fit_checksum(bytes: &mut [u8]) {
    let Some(end) = bytes.len().checked_sub(CHECKSUM) else { return };
    let length = bytes.len() as u64;
    if end >= HEADER {
        bytes[8..16].copy_from_slice(&length.to_le_bytes());
    }
    let checksum = hash(&bytes[..end]);
    bytes[end..].copy_from_slice(&checksum.to_le_bytes());
}

/// An aircraft as an archive has it: its folder of resources and its token.
pub(crate) struct Archive {
    pub interface: Interface,
    pub model: ReducedModel,
    pub token: String,
    unpacked: Unpacked,
}

impl Archive {
    /// In a folder whose name asks for escapes.
    pub fn new(interface: Interface, model: &ReducedModel) -> Self {
        let token = description::token(interface, model, &starts::usual(interface, model));
        let unpacked = Unpacked::of(&model.to_bytes(), "a {b}");
        Archive { interface, model: model.clone(), token, unpacked }
    }

    /// Without a flaw.
    pub fn request<'a>(&'a self, folder: &'a str) -> Instantiation<'a> {
        Instantiation {
            kind: self.interface.kind,
            model: &self.model,
            token: &self.token,
            folder,
            logging_on: false,
            has_logger: true,
            flaw: None,
        }
    }

    /// Of the resources.
    pub fn folder(&self) -> String {
        self.unpacked.uri("a {b}").replace("file://", "")
    }

    /// References of all Reals that can be read.
    pub fn reals(&self) -> Vec<u32> {
        let table = self.table();
        let is_real = |row: &Variable<_>| row.kind == Type::Real;
        table.iter().filter(|(_, row)| is_real(row)).map(|(reference, _)| reference).collect()
    }

    /// Of variables by name.
    pub fn references<const N: usize>(&self, names: [&str; N]) -> [u32; N] {
        let table = self.table();
        names.map(|name| {
            let found = table.iter().find(|(_, row)| row.name == name);
            found.unwrap_or_else(|| panic!("no variable `{name}`")).0
        })
    }

    fn table(&self) -> ArchiveTable {
        ArchiveTable::new(&self.model, &starts::usual(self.interface, &self.model), self.interface.extent())
    }

    /// An instance in the state instantiated.
    pub fn instantiate<S: Surface>(&self) -> S {
        let fmu = S::instantiate(&self.request(&self.folder()));
        assert!(!fmu.component().is_null(), "{:?}", fmu.last_message());
        fmu
    }
}

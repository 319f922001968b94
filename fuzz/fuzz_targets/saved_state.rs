//! Any bytes as a serialised state, with a length, an identity and a checksum that fit: they are refused, or the
//! flight goes on from there; a refused state leaves the instance as it was, but that an error ends one of FMI 3.0. The
//! first byte says of which version of FMI and of which kind the instance is.

#![no_main]

use std::cell::OnceCell;
use std::ffi::CString;
use std::ptr::{null, null_mut};

use flexible_aircraft::fmi::{Interface, Kind, RESOURCE_FILE, Version, description, starts};
use flexible_aircraft::variables::{ArchiveTable, Type};
use flexible_aircraft_fuzz as support;
use libfuzzer_sys::fuzz_target;
use support::functions::{ERROR, FATAL, Functions, Handle, OK, fmi2Instantiate};
use support::functions::{fmi3InstantiateCoSimulation, fmi3InstantiateModelExchange};
use support::{hash, wing};

/// An instance, the bytes of a good state in flight, and the references of its Reals.
struct Fmu {
    interface: Interface,
    functions: Functions,
    component: Handle,
    good: Vec<u8>,
    reals: Vec<u32>,
    state_count: usize,
}

impl Fmu {
    fn new(interface: Interface) -> Self {
        let model = wing();
        let folder = std::env::temp_dir().join(format!("flexible-aircraft-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(RESOURCE_FILE), model.to_bytes()).unwrap();
        let text = |text: String| CString::new(text).unwrap();
        let starts = starts::usual(interface, &model);
        let token = text(description::token(interface, &model, &starts));
        let (uri, path) = (text(format!("file://{}", folder.display())), text(folder.display().to_string()));
        let (name, token, uri, path) = (c"fuzz".as_ptr(), token.as_ptr(), uri.as_ptr(), path.as_ptr());
        let no = null_mut();
        // SAFETY: strings and callbacks live during the call, and all callbacks may be NULL.
        let component = unsafe {
            match (interface.version, interface.kind) {
                (Version::V2, Kind::CoSimulation) => fmi2Instantiate(name, 1, token, uri, &[null(); 5], 0, 0),
                (Version::V2, Kind::ModelExchange) => {
                    fmi2Instantiate(name, 0, token, uri, &[null(); 5], 0, 0)
                }
                (Version::V3, Kind::CoSimulation) => {
                    fmi3InstantiateCoSimulation(name, token, path, 0, 0, 0, 0, null(), 0, no, no, no)
                }
                (Version::V3, Kind::ModelExchange) => {
                    fmi3InstantiateModelExchange(name, token, path, 0, 0, no, no)
                }
            }
        };
        assert!(!component.is_null());
        std::fs::remove_dir_all(&folder).unwrap();
        let table = ArchiveTable::new(&model, &starts, interface.extent());
        let reals = table.iter().filter(|(_, row)| row.kind == Type::Real);
        let mut fmu = Fmu {
            interface,
            functions: Functions::of(interface.version),
            component,
            reals: reals.map(|(reference, _)| reference).collect(),
            state_count: table.states().len(),
            good: Vec::new(),
        };
        fmu.take_off();
        fmu.good = fmu.state();
        fmu
    }

    /// In flight, 12 ms after its start, or where the importer begins to integrate.
    fn take_off(&self) {
        // SAFETY: the component is alive.
        unsafe {
            assert_eq!((self.functions.initialise)(self.component), OK);
            assert_eq!((self.functions.exit_initialization)(self.component), OK);
            let moved = match self.interface.kind {
                Kind::CoSimulation => (self.functions.step)(self.component, 0.0, 0.012),
                Kind::ModelExchange => (self.functions.enter_continuous_time)(self.component),
            };
            assert_eq!(moved, OK);
        }
    }

    /// The present state as bytes.
    fn state(&self) -> Vec<u8> {
        let (mut state, mut size) = (null_mut(), 0);
        // SAFETY: component and state are alive, the array is as long as said.
        unsafe {
            assert_eq!((self.functions.get_state)(self.component, &mut state), OK);
            assert_eq!((self.functions.state_size)(self.component, state, &mut size), OK);
            let mut bytes = vec![0; size];
            assert_eq!((self.functions.serialise)(self.component, state, bytes.as_mut_ptr(), size), OK);
            assert_eq!((self.functions.free_state)(self.component, &mut state), OK);
            bytes
        }
    }

    /// Tries to go on from bytes; whether that was possible.
    fn restore(&self, bytes: &[u8]) -> bool {
        let mut state = null_mut();
        // SAFETY: component and state are alive, the array is as long as said.
        unsafe {
            let made = (self.functions.deserialise)(self.component, bytes.as_ptr(), bytes.len(), &mut state);
            if made != OK {
                assert_eq!(made, ERROR);
                return false;
            }
            let status = (self.functions.set_state)(self.component, state);
            assert!(status < FATAL);
            assert_eq!((self.functions.free_state)(self.component, &mut state), OK);
            status == OK
        }
    }

    /// After a refusal everything is as it was, in FMI 3.0 but for the state of the life cycle, whose byte follows the header.
    fn assert_good(&self) {
        let (mut state, end) = (self.state(), self.good.len() - CHECKSUM);
        if self.interface.version == Version::V3 && state.len() == self.good.len() {
            state[HEADER] = self.good[HEADER];
            state[end..].copy_from_slice(&self.good[end..]);
        }
        assert_eq!(state, self.good);
    }

    /// Reads, and steps or evaluates; nothing that comes back as good is not a number.
    fn go_on(&self) {
        let mut values = vec![0.0; self.reals.len()];
        for size in [0.003, 0.012] {
            // SAFETY: the component is alive, the arrays are as long as said.
            unsafe {
                let got = (self.functions.get_reals)(self.component, &self.reals, &mut values);
                assert!(got < FATAL && (got != OK || values.iter().all(|x| x.is_finite())));
                match self.interface.kind {
                    Kind::CoSimulation => {
                        let time = (self.functions.time)(self.component, self.reals.last().copied());
                        if let Some(time) = time {
                            assert!((self.functions.step)(self.component, time, size) < FATAL);
                        }
                    }
                    Kind::ModelExchange => self.evaluate(),
                }
            }
        }
    }

    fn evaluate(&self) {
        let (mut states, mut rates) = (vec![0.0; self.state_count], vec![f64::NAN; self.state_count]);
        // SAFETY: the component is alive, the arrays are as long as said.
        unsafe {
            let found = (self.functions.rates)(self.component, rates.as_mut_ptr(), rates.len());
            assert!(found < FATAL && (found != OK || rates.iter().all(|rate| rate.is_finite())));
            assert!((self.functions.states)(self.component, states.as_mut_ptr(), states.len()) < FATAL);
            assert!((self.functions.set_states)(self.component, states.as_ptr(), states.len()) < FATAL);
        }
    }
}

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: the component is alive and not used after this.
        unsafe { (self.functions.free)(self.component) };
    }
}

const HEADER: usize = 32;
const CHECKSUM: usize = 16;

/// Puts into `data`, where there is room, what only a checksum would find: mark, length and identity of a good state, and the
/// checksum.
fn fitted(data: &[u8], good: &[u8]) -> Vec<u8> {
    let mut bytes = data.to_vec();
    let length = bytes.len();
    if length < HEADER + CHECKSUM {
        return bytes;
    }
    bytes[..HEADER].copy_from_slice(&good[..HEADER]);
    bytes[8..16].copy_from_slice(&(length as u64).to_le_bytes());
    let end = length - CHECKSUM;
    let checksum = hash(&bytes[..end]);
    bytes[end..].copy_from_slice(&checksum.to_le_bytes());
    bytes
}

thread_local! {
    static FMUS: OnceCell<[Fmu; 4]> = const { OnceCell::new() };
}

fn seeds() {
    for (i, interface) in Interface::ALL.into_iter().enumerate() {
        let bytes = [&[i as u8][..], &Fmu::new(interface).state()].concat();
        support::seed("saved_state", &format!("seed{i}"), &bytes);
    }
}

fuzz_target!(init: seeds(), |data: &[u8]| {
    let Some((first, data)) = data.split_first() else { return };
    FMUS.with(|fmus| {
        let fmu = &fmus.get_or_init(|| Interface::ALL.map(Fmu::new))[usize::from(first % 4)];
        assert!(fmu.restore(&fmu.good));
        assert!(!fmu.restore(data) || data == fmu.good, "raw bytes were taken for a state");
        fmu.assert_good();
        assert!(fmu.restore(&fmu.good));
        if fmu.restore(&fitted(data, &fmu.good)) {
            fmu.go_on();
            let state = fmu.state();
            assert!(fmu.restore(&state), "the instance does not take its own state");
        } else {
            fmu.assert_good();
        }
    });
});

//! Any bytes as a serialised state, with a length, an identity and a checksum that fit: they are refused, or the
//! flight goes on from there; a refused state leaves the instance as it was.

#![no_main]

use std::cell::OnceCell;
use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::{null, null_mut};

use flexible_aircraft::fmi::{RESOURCE_FILE, description};
use flexible_aircraft::variables::{Slot, Type, VariableTable};
use flexible_aircraft_fuzz as support;
use libfuzzer_sys::fuzz_target;
use support::{hash, wing};

/// `fmi2Component` or `fmi2FMUstate`.
type Handle = *mut c_void;

const OK: c_int = 0;
const FATAL: c_int = 4;

// SAFETY: as in fmi2Functions.h; the library is linked in, `description::guid` sees to that.
unsafe extern "C" {
    fn fmi2Instantiate(
        name: *const c_char,
        kind: c_int,
        guid: *const c_char,
        resources: *const c_char,
        callbacks: *const [*const c_void; 5],
        visible: c_int,
        logging_on: c_int,
    ) -> Handle;
    fn fmi2FreeInstance(component: Handle);
    fn fmi2SetupExperiment(
        component: Handle,
        tolerance_defined: c_int,
        tolerance: f64,
        start: f64,
        stop_defined: c_int,
        stop: f64,
    ) -> c_int;
    fn fmi2EnterInitializationMode(component: Handle) -> c_int;
    fn fmi2ExitInitializationMode(component: Handle) -> c_int;
    fn fmi2Reset(component: Handle) -> c_int;
    fn fmi2DoStep(component: Handle, point: f64, size: f64, no_set_state: c_int) -> c_int;
    fn fmi2GetRealStatus(component: Handle, kind: c_int, value: *mut f64) -> c_int;
    fn fmi2GetReal(component: Handle, references: *const u32, count: usize, values: *mut f64) -> c_int;
    fn fmi2GetFMUstate(component: Handle, state: *mut Handle) -> c_int;
    fn fmi2SetFMUstate(component: Handle, state: Handle) -> c_int;
    fn fmi2FreeFMUstate(component: Handle, state: *mut Handle) -> c_int;
    fn fmi2SerializedFMUstateSize(component: Handle, state: Handle, size: *mut usize) -> c_int;
    fn fmi2SerializeFMUstate(component: Handle, state: Handle, bytes: *mut u8, size: usize) -> c_int;
    fn fmi2DeSerializeFMUstate(component: Handle, bytes: *const u8, size: usize, state: *mut Handle)
    -> c_int;
}

/// An instance, the bytes of a good state in flight, and the references of its Reals.
struct Fmu {
    component: Handle,
    good: Vec<u8>,
    reals: Vec<u32>,
}

impl Fmu {
    fn new() -> Self {
        let model = wing();
        let folder = std::env::temp_dir().join(format!("flexible-aircraft-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(RESOURCE_FILE), model.to_bytes()).unwrap();
        let text = |text: String| CString::new(text).unwrap();
        let (guid, uri) = (text(description::guid(&model)), text(format!("file://{}", folder.display())));
        // SAFETY: strings and callbacks live during the call, and all callbacks may be NULL.
        let component =
            unsafe { fmi2Instantiate(c"fuzz".as_ptr(), 1, guid.as_ptr(), uri.as_ptr(), &[null(); 5], 0, 0) };
        assert!(!component.is_null());
        std::fs::remove_dir_all(&folder).unwrap();
        let table = VariableTable::new(&model);
        let is_real = |kind: Type| kind == Type::Real;
        let reals = table.iter().filter(|(_, v)| is_real(v.kind) && matches!(v.slot, Slot::Output(_)));
        let mut fmu =
            Fmu { component, reals: reals.map(|(reference, _)| reference).collect(), good: Vec::new() };
        fmu.take_off();
        fmu.good = fmu.state();
        fmu
    }

    /// In flight, 12 ms after its start.
    fn take_off(&self) {
        // SAFETY: the component is alive.
        let statuses = unsafe {
            [
                fmi2Reset(self.component),
                fmi2SetupExperiment(self.component, 0, 0.0, 0.0, 0, 0.0),
                fmi2EnterInitializationMode(self.component),
                fmi2ExitInitializationMode(self.component),
                fmi2DoStep(self.component, 0.0, 0.012, 0),
            ]
        };
        assert_eq!(statuses, [OK; 5]);
    }

    /// The present state as bytes.
    fn state(&self) -> Vec<u8> {
        let (mut state, mut size) = (null_mut(), 0);
        // SAFETY: component and state are alive, the array is as long as said.
        unsafe {
            assert_eq!(fmi2GetFMUstate(self.component, &mut state), OK);
            assert_eq!(fmi2SerializedFMUstateSize(self.component, state, &mut size), OK);
            let mut bytes = vec![0; size];
            assert_eq!(fmi2SerializeFMUstate(self.component, state, bytes.as_mut_ptr(), size), OK);
            assert_eq!(fmi2FreeFMUstate(self.component, &mut state), OK);
            bytes
        }
    }

    /// Tries to go on from bytes; whether that was possible.
    fn restore(&self, bytes: &[u8]) -> bool {
        let mut state = null_mut();
        // SAFETY: component and state are alive, the array is as long as said.
        unsafe {
            if fmi2DeSerializeFMUstate(self.component, bytes.as_ptr(), bytes.len(), &mut state) != OK {
                return false;
            }
            let status = fmi2SetFMUstate(self.component, state);
            assert!(status < FATAL);
            assert_eq!(fmi2FreeFMUstate(self.component, &mut state), OK);
            status == OK
        }
    }

    /// Reads and steps; nothing that comes back as good is not a number.
    fn go_on(&self) {
        let (mut values, mut time) = (vec![0.0; self.reals.len()], 0.0);
        // SAFETY: the component is alive, the arrays are equally long.
        unsafe {
            let known = fmi2GetRealStatus(self.component, 2, &mut time) == OK;
            for size in [0.003, 0.012] {
                let got = fmi2GetReal(self.component, self.reals.as_ptr(), values.len(), values.as_mut_ptr());
                assert!(got < FATAL && (got != OK || values.iter().all(|x| x.is_finite())));
                if known {
                    assert!(fmi2DoStep(self.component, time, size, 0) < FATAL);
                    assert_eq!(fmi2GetRealStatus(self.component, 2, &mut time), OK);
                }
            }
        }
    }
}

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: the component is alive and not used after this.
        unsafe { fmi2FreeInstance(self.component) };
    }
}

/// Puts into `data`, where there is room, what only a checksum would find: mark, length and identity of a good state, and the
/// checksum.
fn fitted(data: &[u8], good: &[u8]) -> Vec<u8> {
    const HEADER: usize = 32;
    const CHECKSUM: usize = 16;
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
    static FMU: OnceCell<Fmu> = const { OnceCell::new() };
}

fuzz_target!(init: support::seed("saved_state", &Fmu::new().state()), |data: &[u8]| {
    FMU.with(|fmu| {
        let fmu = fmu.get_or_init(Fmu::new);
        assert!(fmu.restore(&fmu.good));
        assert!(!fmu.restore(data) || data == fmu.good, "raw bytes were taken for a state");
        assert_eq!(fmu.state(), fmu.good);
        if fmu.restore(&fitted(data, &fmu.good)) {
            fmu.go_on();
            let state = fmu.state();
            assert!(fmu.restore(&state), "the instance does not take its own state");
        } else {
            assert_eq!(fmu.state(), fmu.good);
        }
    });
});

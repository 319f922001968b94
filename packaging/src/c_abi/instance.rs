//! One aircraft in an FMU: the calls of its life cycle.

use std::ffi::c_void;
use std::ptr::NonNull;
use std::rc::Rc;

use super::ValueReference;
use super::interface::{Callbacks, FALSE, Functions, Log, STATUS_NAMES, Status, TRUE, drain};
use crate::FmuError;

/// One aircraft in an FMU; freed when dropped.
pub struct Instance<'fmu> {
    pub(super) functions: &'fmu Functions,
    pub(super) component: NonNull<c_void>,
    pub(super) log: Rc<Log>,
    pub(super) _callbacks: Rc<Callbacks>,
}

impl Instance<'_> {
    /// `fmi2SetupExperiment`: start time, s, and the tolerance of the integrator where one is wanted.
    ///
    /// # Errors
    /// When the FMU refuses; the error carries its log. This holds for all methods of an instance.
    pub fn setup_experiment(&mut self, start: f64, tolerance: Option<f64>) -> Result<(), FmuError> {
        let defined = if tolerance.is_some() { TRUE } else { FALSE };
        let setup = self.functions.setup_experiment;
        // SAFETY: `component` is alive until `drop`, here and in all calls below.
        let status = unsafe {
            setup(self.component.as_ptr(), defined, tolerance.unwrap_or_default(), start, FALSE, 0.0)
        };
        self.checked("fmi2SetupExperiment", status)
    }

    /// `fmi2EnterInitializationMode`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn enter_initialization_mode(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.enter_initialization_mode)(self.component.as_ptr()) };
        self.checked("fmi2EnterInitializationMode", status)
    }

    /// `fmi2ExitInitializationMode`: the aircraft is trimmed here.
    ///
    /// # Errors
    /// When the FMU refuses, for example because there is no trim.
    pub fn exit_initialization_mode(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.exit_initialization_mode)(self.component.as_ptr()) };
        self.checked("fmi2ExitInitializationMode", status)
    }

    /// Starts the flight with the parameters set so far: the three calls from set-up to the end of
    /// initialisation.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn initialise(&mut self, start: f64, tolerance: Option<f64>) -> Result<(), FmuError> {
        self.setup_experiment(start, tolerance)?;
        self.enter_initialization_mode()?;
        self.exit_initialization_mode()
    }

    /// `fmi2Terminate`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn terminate(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.terminate)(self.component.as_ptr()) };
        self.checked("fmi2Terminate", status)
    }

    /// `fmi2Reset`: back to the state after instantiation.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn reset(&mut self) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.reset)(self.component.as_ptr()) };
        self.checked("fmi2Reset", status)
    }

    /// `fmi2DoStep` from `time` by `step`, s.
    ///
    /// # Errors
    /// When the FMU refuses, for example because the flight left the model's validity.
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<(), FmuError> {
        // SAFETY: as in `setup_experiment`.
        let status = unsafe { (self.functions.do_step)(self.component.as_ptr(), time, step, TRUE) };
        self.checked("fmi2DoStep", status)
    }

    /// `fmi2GetReal` into `values`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_real(&self, references: &[ValueReference], values: &mut [f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let get = self.functions.get_real;
        // SAFETY: as in `setup_experiment`; both arrays have `references.len()` elements.
        let status = unsafe {
            get(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        self.checked("fmi2GetReal", status)
    }

    /// `fmi2SetReal`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_real(&mut self, references: &[ValueReference], values: &[f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let set = self.functions.set_real;
        // SAFETY: as in `get_real`.
        let status =
            unsafe { set(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_ptr()) };
        self.checked("fmi2SetReal", status)
    }

    /// `fmi2GetInteger` into `values`, enumerations too.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_integer(&self, references: &[ValueReference], values: &mut [i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let get = self.functions.get_integer;
        // SAFETY: as in `get_real`.
        let status = unsafe {
            get(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        self.checked("fmi2GetInteger", status)
    }

    /// `fmi2SetInteger`, enumerations too.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_integer(&mut self, references: &[ValueReference], values: &[i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let set = self.functions.set_integer;
        // SAFETY: as in `get_real`.
        let status =
            unsafe { set(self.component.as_ptr(), references.as_ptr(), references.len(), values.as_ptr()) };
        self.checked("fmi2SetInteger", status)
    }

    /// The log lines since the last refused call, which are then forgotten.
    pub fn take_log(&mut self) -> String {
        drain(&self.log)
    }

    fn checked(&self, function: &'static str, status: Status) -> Result<(), FmuError> {
        if status == 0 || status == 1 {
            return Ok(());
        }
        let known = usize::try_from(status).ok().and_then(|status| STATUS_NAMES.get(status));
        let status = known.copied().unwrap_or("an unknown status");
        Err(FmuError::Refused { function, status, log: drain(&self.log) })
    }
}

fn same_length(references: &[ValueReference], values: usize) -> Result<(), FmuError> {
    if references.len() == values {
        Ok(())
    } else {
        Err(FmuError::Lengths { references: references.len(), values })
    }
}

impl Drop for Instance<'_> {
    fn drop(&mut self) {
        // SAFETY: the instance is alive and nobody can use it afterwards; its library is still loaded,
        // because `functions` borrows from the `Fmu`.
        unsafe { (self.functions.free_instance)(self.component.as_ptr()) };
    }
}

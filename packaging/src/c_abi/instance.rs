//! One aircraft in an FMU: the calls of its life cycle, called alike in both versions of FMI.

use std::ffi::{c_int, c_void};
use std::ptr::NonNull;
use std::rc::Rc;

use super::functions::Functions;
use super::log::{Log, drain};
use super::value_reference::ValueReference;
use super::{fmi2, fmi3};
use crate::FmuError;

/// One aircraft in an FMU; freed when dropped.
pub struct Instance<'fmu> {
    pub(super) functions: &'fmu Functions,
    pub(super) component: NonNull<c_void>,
    /// How many an importer integrates.
    pub(super) states: usize,
    pub(super) log: Rc<Log>,
    pub(super) _callbacks: Rc<fmi2::Callbacks>,
}

impl Instance<'_> {
    /// Starts the flight with the parameters set so far: the calls from set-up to the end of initialisation, where the
    /// aircraft is trimmed. The start time, s, and the tolerance of the integrator where one is wanted.
    ///
    /// # Errors
    /// When the FMU refuses, for example because there is no trim; the error carries its log. This holds for all methods of an
    /// instance.
    pub fn initialise(&mut self, start: f64, tolerance: Option<f64>) -> Result<(), FmuError> {
        let (component, value) = (self.component.as_ptr(), tolerance.unwrap_or_default());
        match self.functions {
            Functions::V2(functions) => {
                let defined = if tolerance.is_some() { fmi2::TRUE } else { fmi2::FALSE };
                let setup = functions.setup_experiment;
                // SAFETY: `component` is alive until `drop`, here and in all calls below.
                let status = unsafe { setup(component, defined, value, start, fmi2::FALSE, 0.0) };
                self.checked("fmi2SetupExperiment", status)?;
                // SAFETY: as above.
                let status = unsafe { (functions.enter_initialization_mode)(component) };
                self.checked("fmi2EnterInitializationMode", status)?;
                // SAFETY: as above.
                let status = unsafe { (functions.exit_initialization_mode)(component) };
                self.checked("fmi2ExitInitializationMode", status)
            }
            Functions::V3(functions) => {
                let defined = fmi3::Boolean::from(tolerance.is_some());
                let enter = functions.enter_initialization_mode;
                // SAFETY: as above.
                let status = unsafe { enter(component, defined, value, start, fmi3::FALSE, 0.0) };
                self.checked("fmi3EnterInitializationMode", status)?;
                // SAFETY: as above.
                let status = unsafe { (functions.exit_initialization_mode)(component) };
                self.checked("fmi3ExitInitializationMode", status)
            }
        }
    }

    /// `fmi2Terminate`, `fmi3Terminate`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn terminate(&mut self) -> Result<(), FmuError> {
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2Terminate", functions.terminate),
            Functions::V3(functions) => ("fmi3Terminate", functions.terminate),
        };
        // SAFETY: as in `initialise`.
        let status = unsafe { function(self.component.as_ptr()) };
        self.checked(name, status)
    }

    /// `fmi2Reset`, `fmi3Reset`: back to the state after instantiation.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn reset(&mut self) -> Result<(), FmuError> {
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2Reset", functions.reset),
            Functions::V3(functions) => ("fmi3Reset", functions.reset),
        };
        // SAFETY: as in `initialise`.
        let status = unsafe { function(self.component.as_ptr()) };
        self.checked(name, status)
    }

    /// `fmi2DoStep`, `fmi3DoStep` from `time` by `step`, s.
    ///
    /// # Errors
    /// When the FMU refuses, for example because the flight left the model's validity.
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<(), FmuError> {
        let component = self.component.as_ptr();
        match self.functions {
            Functions::V2(functions) => {
                // SAFETY: as in `initialise`.
                let status = unsafe { (functions.do_step)(component, time, step, fmi2::TRUE) };
                self.checked("fmi2DoStep", status)
            }
            Functions::V3(functions) => {
                let (mut event, mut end, mut early) = (fmi3::FALSE, fmi3::FALSE, fmi3::FALSE);
                let mut reached = time;
                // SAFETY: as in `initialise`; the results are places of their types.
                let status = unsafe {
                    let step_on = functions.do_step;
                    step_on(
                        component,
                        time,
                        step,
                        fmi3::TRUE,
                        &raw mut event,
                        &raw mut end,
                        &raw mut early,
                        &raw mut reached,
                    )
                };
                self.checked("fmi3DoStep", status)
            }
        }
    }

    /// `fmi2GetReal`, `fmi3GetFloat64` into `values`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_real(&self, references: &[ValueReference], values: &mut [f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let (component, count) = (self.component.as_ptr(), references.len());
        // SAFETY: as in `initialise`; both arrays have `count` elements.
        let (name, status) = unsafe {
            let (references, values) = (references.as_ptr(), values.as_mut_ptr());
            match self.functions {
                Functions::V2(f) => ("fmi2GetReal", (f.get_real)(component, references, count, values)),
                Functions::V3(f) => {
                    ("fmi3GetFloat64", (f.get_float64)(component, references, count, values, count))
                }
            }
        };
        self.checked(name, status)
    }

    /// `fmi2SetReal`, `fmi3SetFloat64`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_real(&mut self, references: &[ValueReference], values: &[f64]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let (component, count) = (self.component.as_ptr(), references.len());
        // SAFETY: as in `get_real`.
        let (name, status) = unsafe {
            let (references, values) = (references.as_ptr(), values.as_ptr());
            match self.functions {
                Functions::V2(f) => ("fmi2SetReal", (f.set_real)(component, references, count, values)),
                Functions::V3(f) => {
                    ("fmi3SetFloat64", (f.set_float64)(component, references, count, values, count))
                }
            }
        };
        self.checked(name, status)
    }

    /// `fmi2GetInteger`, which enumerations are too, `fmi3GetInt32`, which they are not, into `values`.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn get_integer(&self, references: &[ValueReference], values: &mut [i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let (component, count) = (self.component.as_ptr(), references.len());
        // SAFETY: as in `get_real`.
        let (name, status) = unsafe {
            let (references, values) = (references.as_ptr(), values.as_mut_ptr());
            match self.functions {
                Functions::V2(f) => ("fmi2GetInteger", (f.get_integer)(component, references, count, values)),
                Functions::V3(f) => {
                    ("fmi3GetInt32", (f.get_int32)(component, references, count, values, count))
                }
            }
        };
        self.checked(name, status)
    }

    /// `fmi2SetInteger`, which enumerations are too, `fmi3SetInt32`, which they are not.
    ///
    /// # Errors
    /// When the numbers of references and values differ or the FMU refuses.
    pub fn set_integer(&mut self, references: &[ValueReference], values: &[i32]) -> Result<(), FmuError> {
        same_length(references, values.len())?;
        let (component, count) = (self.component.as_ptr(), references.len());
        // SAFETY: as in `get_real`.
        let (name, status) = unsafe {
            let (references, values) = (references.as_ptr(), values.as_ptr());
            match self.functions {
                Functions::V2(f) => ("fmi2SetInteger", (f.set_integer)(component, references, count, values)),
                Functions::V3(f) => {
                    ("fmi3SetInt32", (f.set_int32)(component, references, count, values, count))
                }
            }
        };
        self.checked(name, status)
    }

    /// The log lines since the last refused call, which are then forgotten.
    pub fn take_log(&mut self) -> String {
        drain(&self.log)
    }

    pub(super) fn checked(&self, function: &'static str, status: c_int) -> Result<(), FmuError> {
        if status == 0 || status == 1 {
            return Ok(());
        }
        let status = self.functions.status_name(status);
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
        let free = match self.functions {
            Functions::V2(functions) => functions.free_instance,
            Functions::V3(functions) => functions.free_instance,
        };
        // SAFETY: the instance is alive and nobody can use it afterwards; its library is still loaded,
        // because `functions` borrows from the `Fmu`.
        unsafe { free(self.component.as_ptr()) };
    }
}

//! The calls of an importer that integrates: model exchange.

use super::functions::Functions;
use super::instance::Instance;
use super::{fmi2, fmi3};
use crate::FmuError;

/// After so many updates of discrete states an FMU that wants another one will never come to rest.
const UPDATES: usize = 100;

impl Instance<'_> {
    /// From the event mode in which initialisation leaves an FMU for model exchange to the mode in which it is integrated:
    /// discrete states are updated until none is left to be.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn enter_continuous_time(&mut self) -> Result<(), FmuError> {
        for _ in 0..UPDATES {
            if !self.update_discrete_states()? {
                break;
            }
        }
        let (name, function) = match self.functions {
            Functions::V2(f) => ("fmi2EnterContinuousTimeMode", f.enter_continuous_time_mode),
            Functions::V3(f) => ("fmi3EnterContinuousTimeMode", f.enter_continuous_time_mode),
        };
        // SAFETY: `component` is alive until `drop`, here and in all calls below.
        let status = unsafe { function(self.component.as_ptr()) };
        self.checked(name, status)
    }

    /// Whether they are to be updated once more.
    fn update_discrete_states(&mut self) -> Result<bool, FmuError> {
        let component = self.component.as_ptr();
        match self.functions {
            Functions::V2(functions) => {
                let mut event = fmi2::EventInfo::default();
                // SAFETY: as above; the result is a place of its type.
                let status = unsafe { (functions.new_discrete_states)(component, &raw mut event) };
                self.checked("fmi2NewDiscreteStates", status)?;
                Ok(event.new_discrete_states_needed != fmi2::FALSE)
            }
            Functions::V3(functions) => {
                let [mut again, mut end, mut nominals, mut values, mut defined] = [fmi3::FALSE; 5];
                let mut next = 0.0;
                // SAFETY: as above; the results are places of their types.
                let status = unsafe {
                    let update = functions.update_discrete_states;
                    update(
                        component,
                        &raw mut again,
                        &raw mut end,
                        &raw mut nominals,
                        &raw mut values,
                        &raw mut defined,
                        &raw mut next,
                    )
                };
                self.checked("fmi3UpdateDiscreteStates", status)?;
                Ok(again != fmi3::FALSE)
            }
        }
    }

    /// `fmi2SetTime`, `fmi3SetTime`, s.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn set_time(&mut self, time: f64) -> Result<(), FmuError> {
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2SetTime", functions.set_time),
            Functions::V3(functions) => ("fmi3SetTime", functions.set_time),
        };
        // SAFETY: as above.
        let status = unsafe { function(self.component.as_ptr(), time) };
        self.checked(name, status)
    }

    /// `fmi2SetContinuousStates`, `fmi3SetContinuousStates`: x.
    ///
    /// # Errors
    /// When there are not as many numbers as states, or the FMU refuses.
    pub fn set_states(&mut self, x: &[f64]) -> Result<(), FmuError> {
        self.check_states(x.len())?;
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2SetContinuousStates", functions.set_continuous_states),
            Functions::V3(functions) => ("fmi3SetContinuousStates", functions.set_continuous_states),
        };
        // SAFETY: as above; the array has as many elements as it says.
        let status = unsafe { function(self.component.as_ptr(), x.as_ptr(), x.len()) };
        self.checked(name, status)
    }

    /// `fmi2GetContinuousStates`, `fmi3GetContinuousStates`: x.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn states(&self) -> Result<Vec<f64>, FmuError> {
        let mut x = vec![0.0; self.states];
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2GetContinuousStates", functions.get_continuous_states),
            Functions::V3(functions) => ("fmi3GetContinuousStates", functions.get_continuous_states),
        };
        // SAFETY: as above; the array has as many elements as it says.
        let status = unsafe { function(self.component.as_ptr(), x.as_mut_ptr(), x.len()) };
        self.checked(name, status).map(|()| x)
    }

    /// `fmi2GetDerivatives`, `fmi3GetContinuousStateDerivatives`: ẋ into `rates`.
    ///
    /// # Errors
    /// When there are not as many numbers as states, or the FMU refuses.
    pub fn rates(&self, rates: &mut [f64]) -> Result<(), FmuError> {
        self.check_states(rates.len())?;
        let (name, function) = match self.functions {
            Functions::V2(functions) => ("fmi2GetDerivatives", functions.get_derivatives),
            Functions::V3(functions) => {
                ("fmi3GetContinuousStateDerivatives", functions.get_continuous_state_derivatives)
            }
        };
        // SAFETY: as above; the array has as many elements as it says.
        let status = unsafe { function(self.component.as_ptr(), rates.as_mut_ptr(), rates.len()) };
        self.checked(name, status)
    }

    fn check_states(&self, values: usize) -> Result<(), FmuError> {
        if values == self.states { Ok(()) } else { Err(FmuError::States { states: self.states, values }) }
    }
}

//! FMI 3.0 for tests that drive all versions.

use super::*;
use crate::fmi2::tests::surface::{ExchangeFunctions, Instantiation, StateFunctions, Surface};

impl Surface for Fmu {
    const VERSION: Version = Version::V3;
    const STATES: StateFunctions = StateFunctions {
        get: fmi3GetFMUState,
        set: fmi3SetFMUState,
        free: fmi3FreeFMUState,
        size: fmi3SerializedFMUStateSize,
        serialise: fmi3SerializeFMUState,
        deserialise: fmi3DeserializeFMUState,
    };
    const EXCHANGE: ExchangeFunctions = ExchangeFunctions {
        enter: fmi3EnterContinuousTimeMode,
        set_time: fmi3SetTime,
        set_states: fmi3SetContinuousStates,
        states: fmi3GetContinuousStates,
        rates: fmi3GetContinuousStateDerivatives,
        nominals: fmi3GetNominalsOfContinuousStates,
        indicators: fmi3GetEventIndicators,
    };

    fn instantiate(request: &Instantiation) -> Self {
        let good = Request {
            kind: request.kind,
            token: Some(request.token.to_owned()),
            path: Some(request.folder.to_owned()),
            event_mode_used: 0,
            intermediate_variables: 0,
            logging_on: u8::from(request.logging_on),
        };
        let request_to_make = match (request.flaw, request.kind) {
            (None, _) => good,
            (Some(0), _) => Request { token: None, ..good },
            (Some(1), _) => Request { token: Some("#n".to_owned()), ..good },
            (Some(2), Kind::CoSimulation) => Request { event_mode_used: 1, ..good },
            (Some(3), Kind::CoSimulation) => Request { intermediate_variables: 1, ..good },
            (Some(2), Kind::ModelExchange) => Request { path: Some("/nowhere/#".to_owned()), ..good },
            (Some(_), _) => Request { path: None, ..good },
        };
        Fmu::with_logger(&request_to_make, request.model, request.has_logger.then_some(logger))
    }

    fn component(&self) -> Instance {
        self.instance
    }

    fn complaint_count(&self) -> usize {
        self.log.borrow().iter().filter(|message| message.status != Status::Ok).count()
    }

    fn last_message(&self) -> Option<(Status, String)> {
        self.log.borrow().last().map(|message| (message.status, message.text.clone()))
    }

    fn forget_messages(&self) {
        self.log.borrow_mut().clear();
    }

    fn initialise(&self) -> Status {
        Fmu::initialise(self, 0.0)
    }

    fn reset(&self) -> Status {
        // SAFETY: the instance is alive.
        unsafe { fmi3Reset(self.instance) }
    }

    fn step(&self, point: f64, size: f64) -> Status {
        Fmu::step(self, point, size)
    }

    fn set_reals(&self, references: &[u32], values: &[f64]) -> Status {
        let count = references.len();
        assert_eq!(count, values.len());
        // SAFETY: the instance is alive, the arrays are equally long.
        unsafe { fmi3SetFloat64(self.instance, references.as_ptr(), count, values.as_ptr(), count) }
    }

    fn get_reals(&self, references: &[u32], values: &mut [f64]) -> Status {
        let count = references.len();
        assert_eq!(count, values.len());
        // SAFETY: the instance is alive, the arrays are equally long.
        unsafe { fmi3GetFloat64(self.instance, references.as_ptr(), count, values.as_mut_ptr(), count) }
    }
}

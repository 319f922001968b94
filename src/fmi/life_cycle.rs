//! The life cycle of an instance: what may be asked of it in which state.
//!
//! The table is that of the FMI 2.0 standard's co-simulation state machine (FMI 2.0.4, 4.2.4), for a slave
//! that computes while it is called and undoes a call that fails: it never is in the standard's states
//! stepInProgress, stepFailed, stepCanceled or error, so those have no name here.

/// State of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Made, or reset.
    Instantiated,
    /// Between entering and leaving the initialisation.
    InitializationMode,
    /// At a communication point (the standard's stepComplete, also slaveInitialized).
    StepComplete,
    /// After its end: only to be read, reset or freed.
    Terminated,
    /// Something broke inside: only to be freed.
    Fatal,
}

impl State {
    /// All states.
    pub const ALL: [State; 5] = [
        State::Instantiated,
        State::InitializationMode,
        State::StepComplete,
        State::Terminated,
        State::Fatal,
    ];

    /// The name that the standard gives it.
    pub fn name(self) -> &'static str {
        match self {
            State::Instantiated => "instantiated",
            State::InitializationMode => "initializationMode",
            State::StepComplete => "stepComplete",
            State::Terminated => "terminated",
            State::Fatal => "fatal",
        }
    }
}

/// What can be asked of an instance; to free it is missing, for that is allowed always.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    SetDebugLogging,
    SetupExperiment,
    EnterInitializationMode,
    ExitInitializationMode,
    Terminate,
    Reset,
    GetReal,
    GetInteger,
    GetBoolean,
    GetString,
    SetReal,
    SetInteger,
    SetBoolean,
    SetString,
    GetFMUstate,
    SetFMUstate,
    FreeFMUstate,
    SerializedFMUstateSize,
    SerializeFMUstate,
    DeSerializeFMUstate,
    GetDirectionalDerivative,
    SetRealInputDerivatives,
    GetRealOutputDerivatives,
    DoStep,
    CancelStep,
    GetStatus,
    GetRealStatus,
    GetIntegerStatus,
    GetBooleanStatus,
    GetStringStatus,
    EnterEventMode,
    NewDiscreteStates,
    EnterContinuousTimeMode,
    CompletedIntegratorStep,
    SetTime,
    SetContinuousStates,
    GetDerivatives,
    GetEventIndicators,
    GetContinuousStates,
    GetNominalsOfContinuousStates,
}

/// The table: operation, its function in FMI 2.0, the states in which it may be asked for.
const TABLE: [(Operation, &str, &[State]); 40] = {
    use Operation as O;
    use State::{InitializationMode, Instantiated, StepComplete, Terminated};
    const ALIVE: &[State] = &[Instantiated, InitializationMode, StepComplete, Terminated];
    const READABLE: &[State] = &[InitializationMode, StepComplete, Terminated];
    const SETTABLE: &[State] = &[Instantiated, InitializationMode, StepComplete];
    const STEPPED: &[State] = &[StepComplete, Terminated];
    const MODEL_EXCHANGE: &[State] = &[];
    [
        (O::SetDebugLogging, "fmi2SetDebugLogging", ALIVE),
        (O::SetupExperiment, "fmi2SetupExperiment", &[Instantiated]),
        (O::EnterInitializationMode, "fmi2EnterInitializationMode", &[Instantiated]),
        (O::ExitInitializationMode, "fmi2ExitInitializationMode", &[InitializationMode]),
        (O::Terminate, "fmi2Terminate", &[StepComplete]),
        (O::Reset, "fmi2Reset", ALIVE),
        (O::GetReal, "fmi2GetReal", READABLE),
        (O::GetInteger, "fmi2GetInteger", READABLE),
        (O::GetBoolean, "fmi2GetBoolean", READABLE),
        (O::GetString, "fmi2GetString", READABLE),
        (O::SetReal, "fmi2SetReal", SETTABLE),
        (O::SetInteger, "fmi2SetInteger", SETTABLE),
        (O::SetBoolean, "fmi2SetBoolean", SETTABLE),
        (O::SetString, "fmi2SetString", SETTABLE),
        (O::GetFMUstate, "fmi2GetFMUstate", ALIVE),
        (O::SetFMUstate, "fmi2SetFMUstate", ALIVE),
        (O::FreeFMUstate, "fmi2FreeFMUstate", ALIVE),
        (O::SerializedFMUstateSize, "fmi2SerializedFMUstateSize", ALIVE),
        (O::SerializeFMUstate, "fmi2SerializeFMUstate", ALIVE),
        (O::DeSerializeFMUstate, "fmi2DeSerializeFMUstate", ALIVE),
        (O::GetDirectionalDerivative, "fmi2GetDirectionalDerivative", READABLE),
        (O::SetRealInputDerivatives, "fmi2SetRealInputDerivatives", SETTABLE),
        (O::GetRealOutputDerivatives, "fmi2GetRealOutputDerivatives", STEPPED),
        (O::DoStep, "fmi2DoStep", &[StepComplete]),
        (O::CancelStep, "fmi2CancelStep", &[]),
        (O::GetStatus, "fmi2GetStatus", STEPPED),
        (O::GetRealStatus, "fmi2GetRealStatus", STEPPED),
        (O::GetIntegerStatus, "fmi2GetIntegerStatus", STEPPED),
        (O::GetBooleanStatus, "fmi2GetBooleanStatus", STEPPED),
        (O::GetStringStatus, "fmi2GetStringStatus", STEPPED),
        (O::EnterEventMode, "fmi2EnterEventMode", MODEL_EXCHANGE),
        (O::NewDiscreteStates, "fmi2NewDiscreteStates", MODEL_EXCHANGE),
        (O::EnterContinuousTimeMode, "fmi2EnterContinuousTimeMode", MODEL_EXCHANGE),
        (O::CompletedIntegratorStep, "fmi2CompletedIntegratorStep", MODEL_EXCHANGE),
        (O::SetTime, "fmi2SetTime", MODEL_EXCHANGE),
        (O::SetContinuousStates, "fmi2SetContinuousStates", MODEL_EXCHANGE),
        (O::GetDerivatives, "fmi2GetDerivatives", MODEL_EXCHANGE),
        (O::GetEventIndicators, "fmi2GetEventIndicators", MODEL_EXCHANGE),
        (O::GetContinuousStates, "fmi2GetContinuousStates", MODEL_EXCHANGE),
        (O::GetNominalsOfContinuousStates, "fmi2GetNominalsOfContinuousStates", MODEL_EXCHANGE),
    ]
};

impl Operation {
    /// All operations.
    pub fn all() -> impl Iterator<Item = Operation> {
        TABLE.into_iter().map(|(operation, _, _)| operation)
    }

    /// Its function in C.
    pub fn name(self) -> &'static str {
        TABLE[self as usize].1
    }

    /// Why it may not be asked for in a state, or `None` when it may.
    pub fn objection(self, state: State) -> Option<String> {
        let (_, name, allowed) = TABLE[self as usize];
        if allowed.contains(&state) {
            return None;
        }
        Some(if self == Operation::CancelStep {
            format!("{name}: no step is in progress, for every fmi2DoStep finishes before it returns")
        } else if allowed.is_empty() {
            format!("{name}: belongs to model exchange, and this is a co-simulation FMU")
        } else {
            let allowed: Vec<_> = allowed.iter().map(|state| state.name()).collect();
            format!("{name}: not allowed in state {}, allowed in {}", state.name(), allowed.join(", "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_finds_its_own_row() {
        for (index, (operation, name, _)) in TABLE.iter().enumerate() {
            assert_eq!(*operation as usize, index, "{name}");
            assert_eq!(*name, format!("fmi2{operation:?}"));
        }
    }

    #[test]
    fn nothing_is_allowed_after_a_fatal_error() {
        for (operation, name, _) in TABLE {
            assert!(operation.objection(State::Fatal).is_some(), "{name}");
        }
    }

    #[test]
    fn steps_are_taken_only_between_initialisation_and_termination() {
        let allowed: Vec<_> =
            State::ALL.into_iter().filter(|s| Operation::DoStep.objection(*s).is_none()).collect();
        assert_eq!(allowed, [State::StepComplete]);
    }

    #[test]
    fn an_objection_names_the_function_the_state_and_what_is_allowed() {
        let objection = Operation::SetupExperiment.objection(State::Terminated).unwrap();
        for part in ["fmi2SetupExperiment", "terminated", "instantiated"] {
            assert!(objection.contains(part), "{objection}");
        }
    }
}

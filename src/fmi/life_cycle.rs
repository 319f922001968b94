//! The life cycle of an instance: what may be asked of it in which state.
//!
//! The table is that of the standard's state machine of co-simulation (FMI 2.0.4, 4.2.4), for a slave
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

/// The table: the states in which each operation may be asked for.
const TABLE: [(Operation, &[State]); 40] = {
    use Operation as O;
    use State::{InitializationMode, Instantiated, StepComplete, Terminated};
    const ALIVE: &[State] = &[Instantiated, InitializationMode, StepComplete, Terminated];
    const READABLE: &[State] = &[InitializationMode, StepComplete, Terminated];
    const SETTABLE: &[State] = &[Instantiated, InitializationMode, StepComplete];
    const STEPPED: &[State] = &[StepComplete, Terminated];
    const MODEL_EXCHANGE: &[State] = &[];
    [
        (O::SetDebugLogging, ALIVE),
        (O::SetupExperiment, &[Instantiated]),
        (O::EnterInitializationMode, &[Instantiated]),
        (O::ExitInitializationMode, &[InitializationMode]),
        (O::Terminate, &[StepComplete]),
        (O::Reset, ALIVE),
        (O::GetReal, READABLE),
        (O::GetInteger, READABLE),
        (O::GetBoolean, READABLE),
        (O::GetString, READABLE),
        (O::SetReal, SETTABLE),
        (O::SetInteger, SETTABLE),
        (O::SetBoolean, SETTABLE),
        (O::SetString, SETTABLE),
        (O::GetFMUstate, ALIVE),
        (O::SetFMUstate, ALIVE),
        (O::FreeFMUstate, ALIVE),
        (O::SerializedFMUstateSize, ALIVE),
        (O::SerializeFMUstate, ALIVE),
        (O::DeSerializeFMUstate, ALIVE),
        (O::GetDirectionalDerivative, READABLE),
        (O::SetRealInputDerivatives, SETTABLE),
        (O::GetRealOutputDerivatives, STEPPED),
        (O::DoStep, &[StepComplete]),
        (O::CancelStep, &[]),
        (O::GetStatus, STEPPED),
        (O::GetRealStatus, STEPPED),
        (O::GetIntegerStatus, STEPPED),
        (O::GetBooleanStatus, STEPPED),
        (O::GetStringStatus, STEPPED),
        (O::EnterEventMode, MODEL_EXCHANGE),
        (O::NewDiscreteStates, MODEL_EXCHANGE),
        (O::EnterContinuousTimeMode, MODEL_EXCHANGE),
        (O::CompletedIntegratorStep, MODEL_EXCHANGE),
        (O::SetTime, MODEL_EXCHANGE),
        (O::SetContinuousStates, MODEL_EXCHANGE),
        (O::GetDerivatives, MODEL_EXCHANGE),
        (O::GetEventIndicators, MODEL_EXCHANGE),
        (O::GetContinuousStates, MODEL_EXCHANGE),
        (O::GetNominalsOfContinuousStates, MODEL_EXCHANGE),
    ]
};

impl Operation {
    /// All operations.
    pub fn all() -> impl Iterator<Item = Operation> {
        TABLE.into_iter().map(|(operation, _)| operation)
    }

    /// Why it may not be asked for in a state, or `None` when it may.
    pub fn objection(self, found: State) -> Option<Objection> {
        let (_, allowed) = TABLE[self as usize];
        match (self, allowed) {
            (_, allowed) if allowed.contains(&found) => None,
            (Operation::CancelStep, _) => Some(Objection::NoStepInProgress),
            (_, []) => Some(Objection::ModelExchange),
            (_, allowed) => Some(Objection::State { found, allowed }),
        }
    }
}

/// Why an operation may not be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objection {
    /// There is never a step to be canceled.
    NoStepInProgress,
    /// It is of the other kind of FMU.
    ModelExchange,
    /// Not now.
    State {
        /// In which the instance is.
        found: State,
        /// In which it would have to be.
        allowed: &'static [State],
    },
}

impl Objection {
    /// In words; `step` is what the importer's version of FMI calls the function that steps.
    pub fn text(&self, step: &str) -> String {
        match self {
            Objection::NoStepInProgress => {
                format!("no step is in progress, for every {step} finishes before it returns")
            }
            Objection::ModelExchange => {
                "belongs to model exchange, and this is a co-simulation FMU".to_owned()
            }
            Objection::State { found, allowed } => {
                let allowed: Vec<_> = allowed.iter().map(|state| state.name()).collect();
                format!("not allowed in state {}, allowed in {}", found.name(), allowed.join(", "))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_finds_its_own_row() {
        for (index, (operation, _)) in TABLE.iter().enumerate() {
            assert_eq!(*operation as usize, index, "{operation:?}");
        }
    }

    #[test]
    fn nothing_is_allowed_after_a_fatal_error() {
        for operation in Operation::all() {
            assert!(operation.objection(State::Fatal).is_some(), "{operation:?}");
        }
    }

    #[test]
    fn steps_are_taken_only_between_initialisation_and_termination() {
        let allowed: Vec<_> =
            State::ALL.into_iter().filter(|s| Operation::DoStep.objection(*s).is_none()).collect();
        assert_eq!(allowed, [State::StepComplete]);
    }

    #[test]
    fn an_objection_names_the_state_and_what_is_allowed() {
        let text = |operation: Operation| operation.objection(State::Terminated).unwrap().text("goOn");
        let found = text(Operation::SetupExperiment);
        assert_eq!(found, "not allowed in state terminated, allowed in instantiated");
        assert!(text(Operation::CancelStep).contains("every goOn finishes"));
        assert!(text(Operation::SetTime).contains("belongs to model exchange"));
    }
}

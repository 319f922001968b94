//! The life cycle of an instance: which function may be called in which state.
//!
//! The table is that of the FMI 2.0 standard's co-simulation state machine (FMI 2.0.4, 4.2.4), for a slave
//! that computes while it is called and undoes a call that fails: it never is in the standard's states
//! stepInProgress, stepFailed, stepCanceled or error, so those have no name here.

/// State of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Made, or reset.
    Instantiated,
    /// Between `fmi2EnterInitializationMode` and `fmi2ExitInitializationMode`.
    InitializationMode,
    /// At a communication point (the standard's stepComplete, also slaveInitialized).
    StepComplete,
    /// After `fmi2Terminate`: only to be read, reset or freed.
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

/// A function that is called on an instance: `fmi2<name>`. `fmi2FreeInstance` is missing: it is allowed always.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
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

/// The table: function, its name, the states in which it may be called.
const TABLE: [(Function, &str, &[State]); 40] = {
    use Function as F;
    use State::{InitializationMode, Instantiated, StepComplete, Terminated};
    const ALIVE: &[State] = &[Instantiated, InitializationMode, StepComplete, Terminated];
    const READABLE: &[State] = &[InitializationMode, StepComplete, Terminated];
    const SETTABLE: &[State] = &[Instantiated, InitializationMode, StepComplete];
    const STEPPED: &[State] = &[StepComplete, Terminated];
    const MODEL_EXCHANGE: &[State] = &[];
    [
        (F::SetDebugLogging, "fmi2SetDebugLogging", ALIVE),
        (F::SetupExperiment, "fmi2SetupExperiment", &[Instantiated]),
        (F::EnterInitializationMode, "fmi2EnterInitializationMode", &[Instantiated]),
        (F::ExitInitializationMode, "fmi2ExitInitializationMode", &[InitializationMode]),
        (F::Terminate, "fmi2Terminate", &[StepComplete]),
        (F::Reset, "fmi2Reset", ALIVE),
        (F::GetReal, "fmi2GetReal", READABLE),
        (F::GetInteger, "fmi2GetInteger", READABLE),
        (F::GetBoolean, "fmi2GetBoolean", READABLE),
        (F::GetString, "fmi2GetString", READABLE),
        (F::SetReal, "fmi2SetReal", SETTABLE),
        (F::SetInteger, "fmi2SetInteger", SETTABLE),
        (F::SetBoolean, "fmi2SetBoolean", SETTABLE),
        (F::SetString, "fmi2SetString", SETTABLE),
        (F::GetFMUstate, "fmi2GetFMUstate", ALIVE),
        (F::SetFMUstate, "fmi2SetFMUstate", ALIVE),
        (F::FreeFMUstate, "fmi2FreeFMUstate", ALIVE),
        (F::SerializedFMUstateSize, "fmi2SerializedFMUstateSize", ALIVE),
        (F::SerializeFMUstate, "fmi2SerializeFMUstate", ALIVE),
        (F::DeSerializeFMUstate, "fmi2DeSerializeFMUstate", ALIVE),
        (F::GetDirectionalDerivative, "fmi2GetDirectionalDerivative", READABLE),
        (F::SetRealInputDerivatives, "fmi2SetRealInputDerivatives", SETTABLE),
        (F::GetRealOutputDerivatives, "fmi2GetRealOutputDerivatives", STEPPED),
        (F::DoStep, "fmi2DoStep", &[StepComplete]),
        (F::CancelStep, "fmi2CancelStep", &[]),
        (F::GetStatus, "fmi2GetStatus", STEPPED),
        (F::GetRealStatus, "fmi2GetRealStatus", STEPPED),
        (F::GetIntegerStatus, "fmi2GetIntegerStatus", STEPPED),
        (F::GetBooleanStatus, "fmi2GetBooleanStatus", STEPPED),
        (F::GetStringStatus, "fmi2GetStringStatus", STEPPED),
        (F::EnterEventMode, "fmi2EnterEventMode", MODEL_EXCHANGE),
        (F::NewDiscreteStates, "fmi2NewDiscreteStates", MODEL_EXCHANGE),
        (F::EnterContinuousTimeMode, "fmi2EnterContinuousTimeMode", MODEL_EXCHANGE),
        (F::CompletedIntegratorStep, "fmi2CompletedIntegratorStep", MODEL_EXCHANGE),
        (F::SetTime, "fmi2SetTime", MODEL_EXCHANGE),
        (F::SetContinuousStates, "fmi2SetContinuousStates", MODEL_EXCHANGE),
        (F::GetDerivatives, "fmi2GetDerivatives", MODEL_EXCHANGE),
        (F::GetEventIndicators, "fmi2GetEventIndicators", MODEL_EXCHANGE),
        (F::GetContinuousStates, "fmi2GetContinuousStates", MODEL_EXCHANGE),
        (F::GetNominalsOfContinuousStates, "fmi2GetNominalsOfContinuousStates", MODEL_EXCHANGE),
    ]
};

impl Function {
    /// All functions.
    pub fn all() -> impl Iterator<Item = Function> {
        TABLE.into_iter().map(|(function, _, _)| function)
    }

    /// Its name in C.
    pub fn name(self) -> &'static str {
        TABLE[self as usize].1
    }

    /// Why it may not be called in a state, or `None` when it may.
    pub fn objection(self, state: State) -> Option<String> {
        let (_, name, allowed) = TABLE[self as usize];
        if allowed.contains(&state) {
            return None;
        }
        Some(if self == Function::CancelStep {
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
    fn every_function_finds_its_own_row() {
        for (index, (function, name, _)) in TABLE.iter().enumerate() {
            assert_eq!(*function as usize, index, "{name}");
            assert_eq!(*name, format!("fmi2{function:?}"));
        }
    }

    #[test]
    fn nothing_is_allowed_after_a_fatal_error() {
        for (function, name, _) in TABLE {
            assert!(function.objection(State::Fatal).is_some(), "{name}");
        }
    }

    #[test]
    fn steps_are_taken_only_between_initialisation_and_termination() {
        let allowed: Vec<_> =
            State::ALL.into_iter().filter(|s| Function::DoStep.objection(*s).is_none()).collect();
        assert_eq!(allowed, [State::StepComplete]);
    }

    #[test]
    fn an_objection_names_the_function_the_state_and_what_is_allowed() {
        let objection = Function::SetupExperiment.objection(State::Terminated).unwrap();
        for part in ["fmi2SetupExperiment", "terminated", "instantiated"] {
            assert!(objection.contains(part), "{objection}");
        }
    }
}

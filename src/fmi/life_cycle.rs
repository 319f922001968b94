//! The life cycle of an instance: what may be asked of it in which state.
//!
//! The tables are those of the standards' state machines (FMI 2.0.4, 3.2.3 and 4.2.4; FMI 3.0.2, 2.3.1, 3.2 and 4.2), for an
//! FMU that computes while it is called and has neither events nor clocks of its own: it never is in a state stepInProgress,
//! stepFailed, stepCanceled or error, in Configuration or Reconfiguration Mode, so those have no name here.

use super::interface::{Interface, Kind, Version};
use super::operation::Operation;

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
    /// Of model exchange: between stretches of time.
    EventMode,
    /// Of model exchange: the importer integrates.
    ContinuousTimeMode,
}

impl State {
    /// All states.
    pub const ALL: [State; 7] = [
        State::Instantiated,
        State::InitializationMode,
        State::StepComplete,
        State::Terminated,
        State::Fatal,
        State::EventMode,
        State::ContinuousTimeMode,
    ];

    /// The name that a version of the standard gives it.
    pub fn name(self, version: Version) -> &'static str {
        match (self, version) {
            (State::Instantiated, Version::V2) => "instantiated",
            (State::InitializationMode, Version::V2) => "initializationMode",
            (State::StepComplete, Version::V2) => "stepComplete",
            (State::EventMode, Version::V2) => "eventMode",
            (State::ContinuousTimeMode, Version::V2) => "continuousTimeMode",
            (State::Terminated, Version::V2) => "terminated",
            (State::Instantiated, Version::V3) => "Instantiated",
            (State::InitializationMode, Version::V3) => "Initialization Mode",
            (State::StepComplete, Version::V3) => "Step Mode",
            (State::EventMode, Version::V3) => "Event Mode",
            (State::ContinuousTimeMode, Version::V3) => "Continuous-Time Mode",
            (State::Terminated, Version::V3) => "Terminated",
            (State::Fatal, _) => "fatal",
        }
    }

    /// Whether an instance of some kind can be in it.
    pub fn is_of(self, kind: Kind) -> bool {
        match self {
            State::StepComplete => kind == Kind::CoSimulation,
            State::EventMode | State::ContinuousTimeMode => kind == Kind::ModelExchange,
            _ => true,
        }
    }
}

/// Why an operation is refused in every state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Never {
    /// There is never a step to be canceled.
    NoStepInProgress,
    /// It is of an FMU that the importer integrates.
    ModelExchange,
    /// It is of an FMU that integrates by itself.
    CoSimulation,
    /// Nothing happens between communication points.
    NoEventMode,
    /// All parameters leave the structure as it is.
    NoStructuralParameters,
    /// There are none.
    NoClocks,
    /// Outputs come without.
    NoOutputDerivatives,
    /// There are directional ones alone.
    NoAdjointDerivatives,
    /// They are the same as in the model description.
    DependenciesDoNotChange,
    /// The version of FMI has no such function.
    Unknown,
}

/// Why an operation may not be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objection {
    /// Whenever.
    Never(Never),
    /// Not now.
    State {
        /// In which the instance is.
        found: State,
        /// In which it would have to be.
        allowed: &'static [State],
    },
}

use State::{
    ContinuousTimeMode as Continuous, EventMode as Event, InitializationMode as Init, Instantiated as Made,
    StepComplete as Step, Terminated as Ended,
};

/// The states of one kind, and of the other.
type OfKinds = [&'static [State]; 2];

const ALIVE: OfKinds = [&[Made, Init, Step, Ended], &[Made, Init, Event, Continuous, Ended]];
const READABLE: OfKinds = [&[Init, Step, Ended], &[Init, Event, Continuous, Ended]];
const SETTABLE: OfKinds = [&[Made, Init, Step], &[Made, Init, Event, Continuous]];
const BEFORE: &[State] = &[Made, Init];

impl Operation {
    /// The states in which it may be asked for.
    fn allowed(self, Interface { version, kind }: Interface) -> Result<&'static [State], Never> {
        use Operation as O;
        let is_v3 = version == Version::V3;
        let of = |states: OfKinds| Ok(states[kind as usize]);
        let simulated = |states: &'static [State]| match kind {
            Kind::CoSimulation => Ok(states),
            Kind::ModelExchange => Err(Never::CoSimulation),
        };
        let exchanged = |states: &'static [State]| match (kind, version) {
            (Kind::ModelExchange, _) => Ok(states),
            (Kind::CoSimulation, _) => Err(Never::ModelExchange),
        };
        let at_events = |states: &'static [State]| match (kind, version) {
            (Kind::CoSimulation, Version::V3) => Err(Never::NoEventMode),
            _ => exchanged(states),
        };
        if self.name(version).is_none() {
            return Err(Never::Unknown);
        }
        match self {
            O::SetDebugLogging
            | O::Reset
            | O::GetFMUstate
            | O::SetFMUstate
            | O::FreeFMUstate
            | O::SerializedFMUstateSize
            | O::SerializeFMUstate
            | O::DeSerializeFMUstate => of(ALIVE),
            O::SetupExperiment | O::EnterInitializationMode => Ok(&[Made]),
            O::ExitInitializationMode => Ok(&[Init]),
            O::Terminate => of([&[Step], &[Event, Continuous]]),
            O::GetReal
            | O::GetInteger
            | O::GetInt64
            | O::GetBoolean
            | O::GetString
            | O::GetFloat32
            | O::GetInt8
            | O::GetUInt8
            | O::GetInt16
            | O::GetUInt16
            | O::GetUInt32
            | O::GetUInt64
            | O::GetBinary => of(if is_v3 { ALIVE } else { READABLE }),
            O::SetReal => of(SETTABLE),
            O::SetInteger
            | O::SetInt64
            | O::SetBoolean
            | O::SetString
            | O::SetFloat32
            | O::SetInt8
            | O::SetUInt8
            | O::SetInt16
            | O::SetUInt16
            | O::SetUInt32
            | O::SetUInt64
            | O::SetBinary => of(if is_v3 { [BEFORE; 2] } else { [SETTABLE[0], BEFORE] }),
            O::GetDirectionalDerivative => of(READABLE),
            O::GetAdjointDerivative => Err(Never::NoAdjointDerivatives),
            O::GetNumberOfVariableDependencies | O::GetVariableDependencies => {
                Err(Never::DependenciesDoNotChange)
            }
            O::SetRealInputDerivatives => simulated(SETTABLE[0]),
            O::GetRealOutputDerivatives if is_v3 => simulated(&[]).and(Err(Never::NoOutputDerivatives)),
            O::GetRealOutputDerivatives
            | O::GetStatus
            | O::GetRealStatus
            | O::GetIntegerStatus
            | O::GetBooleanStatus
            | O::GetStringStatus => simulated(&[Step, Ended]),
            O::DoStep => simulated(&[Step]),
            O::CancelStep => simulated(&[]).and(Err(Never::NoStepInProgress)),
            O::EnterStepMode => simulated(&[]).and(Err(Never::NoEventMode)),
            O::EnterEventMode => at_events(if is_v3 { &[Continuous] } else { &[Event, Continuous] }),
            O::NewDiscreteStates | O::EvaluateDiscreteStates => at_events(&[Event]),
            O::EnterContinuousTimeMode => exchanged(&[Event]),
            O::CompletedIntegratorStep | O::SetContinuousStates => exchanged(&[Continuous]),
            // The time may be told before the first stretch, too.
            O::SetTime => exchanged(&[Event, Continuous]),
            O::GetDerivatives | O::GetEventIndicators | O::GetContinuousStates => exchanged(READABLE[1]),
            O::GetNominalsOfContinuousStates
            | O::GetNumberOfContinuousStates
            | O::GetNumberOfEventIndicators => exchanged(ALIVE[1]),
            O::EnterConfigurationMode | O::ExitConfigurationMode => Err(Never::NoStructuralParameters),
            O::GetClock
            | O::SetClock
            | O::GetIntervalDecimal
            | O::GetIntervalFraction
            | O::GetShiftDecimal
            | O::GetShiftFraction
            | O::SetIntervalDecimal
            | O::SetIntervalFraction
            | O::SetShiftDecimal
            | O::SetShiftFraction
            | O::ActivateModelPartition => Err(Never::NoClocks),
        }
    }

    /// Why it may not be asked for in a state, or `None` when it may.
    pub fn objection(self, interface: Interface, found: State) -> Option<Objection> {
        match self.allowed(interface) {
            Err(never) => Some(Objection::Never(never)),
            Ok(allowed) if allowed.contains(&found) => None,
            Ok(allowed) => Some(Objection::State { found, allowed }),
        }
    }
}

impl Objection {
    /// In words of a version of FMI.
    pub fn text(self, version: Version) -> String {
        match self {
            Objection::Never(Never::NoStepInProgress) => {
                let step = Operation::DoStep.name(version).unwrap_or_default();
                format!("no step is in progress, for every {step} finishes before it returns")
            }
            Objection::Never(never) => never.text().to_owned(),
            Objection::State { found, allowed } => {
                let allowed: Vec<_> = allowed.iter().map(|state| state.name(version)).collect();
                format!("not allowed in state {}, allowed in {}", found.name(version), allowed.join(", "))
            }
        }
    }
}

impl Never {
    fn text(self) -> &'static str {
        match self {
            Never::NoStepInProgress => "no step is in progress",
            Never::ModelExchange => "belongs to model exchange, and this is a co-simulation FMU",
            Never::CoSimulation => "belongs to co-simulation, and this is a model exchange FMU",
            Never::NoEventMode => "this FMU has no event mode",
            Never::NoStructuralParameters => "this FMU has no structural parameters to be configured",
            Never::NoClocks => "this FMU has no clocks",
            Never::NoOutputDerivatives => "this FMU provides no derivatives of outputs by time (order 0)",
            Never::NoAdjointDerivatives => {
                "this FMU provides no adjoint derivatives; it provides directional ones"
            }
            Never::DependenciesDoNotChange => {
                "this FMU has no dependencies but those that its model description says"
            }
            Never::Unknown => "this version of FMI has no such function",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_allowed_after_a_fatal_error() {
        for interface in Interface::ALL {
            for operation in Operation::ALL {
                assert!(operation.objection(interface, State::Fatal).is_some(), "{operation:?}");
            }
        }
    }

    #[test]
    fn no_operation_is_allowed_in_a_state_of_the_other_kind() {
        for interface in Interface::ALL {
            for state in State::ALL.into_iter().filter(|state| !state.is_of(interface.kind)) {
                for operation in Operation::ALL {
                    assert!(operation.objection(interface, state).is_some(), "{operation:?} {state:?}");
                }
            }
        }
    }

    #[test]
    fn steps_are_taken_only_between_initialisation_and_termination() {
        let is_allowed = |state: &State| Operation::DoStep.objection(Interface::USUAL, *state).is_none();
        let allowed: Vec<_> = State::ALL.into_iter().filter(is_allowed).collect();
        assert_eq!(allowed, [State::StepComplete]);
    }

    #[test]
    fn an_objection_names_the_state_and_what_is_allowed() {
        let text = |operation: Operation| {
            let objection = operation.objection(Interface::USUAL, State::Terminated);
            objection.unwrap().text(Version::V2)
        };
        let found = text(Operation::SetupExperiment);
        assert_eq!(found, "not allowed in state terminated, allowed in instantiated");
        assert!(text(Operation::CancelStep).contains("DoStep finishes before it returns"));
        assert!(text(Operation::SetTime).contains("belongs to model exchange"));
    }
}

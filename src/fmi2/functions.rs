//! What FMI 2.0 calls the functions by which an importer asks for operations.

use crate::fmi::life_cycle::Operation;

/// The function in C.
pub fn name(operation: Operation) -> &'static str {
    match operation {
        Operation::SetDebugLogging => "fmi2SetDebugLogging",
        Operation::SetupExperiment => "fmi2SetupExperiment",
        Operation::EnterInitializationMode => "fmi2EnterInitializationMode",
        Operation::ExitInitializationMode => "fmi2ExitInitializationMode",
        Operation::Terminate => "fmi2Terminate",
        Operation::Reset => "fmi2Reset",
        Operation::GetReal => "fmi2GetReal",
        Operation::GetInteger => "fmi2GetInteger",
        Operation::GetBoolean => "fmi2GetBoolean",
        Operation::GetString => "fmi2GetString",
        Operation::SetReal => "fmi2SetReal",
        Operation::SetInteger => "fmi2SetInteger",
        Operation::SetBoolean => "fmi2SetBoolean",
        Operation::SetString => "fmi2SetString",
        Operation::GetFMUstate => "fmi2GetFMUstate",
        Operation::SetFMUstate => "fmi2SetFMUstate",
        Operation::FreeFMUstate => "fmi2FreeFMUstate",
        Operation::SerializedFMUstateSize => "fmi2SerializedFMUstateSize",
        Operation::SerializeFMUstate => "fmi2SerializeFMUstate",
        Operation::DeSerializeFMUstate => "fmi2DeSerializeFMUstate",
        Operation::GetDirectionalDerivative => "fmi2GetDirectionalDerivative",
        Operation::SetRealInputDerivatives => "fmi2SetRealInputDerivatives",
        Operation::GetRealOutputDerivatives => "fmi2GetRealOutputDerivatives",
        Operation::DoStep => "fmi2DoStep",
        Operation::CancelStep => "fmi2CancelStep",
        Operation::GetStatus => "fmi2GetStatus",
        Operation::GetRealStatus => "fmi2GetRealStatus",
        Operation::GetIntegerStatus => "fmi2GetIntegerStatus",
        Operation::GetBooleanStatus => "fmi2GetBooleanStatus",
        Operation::GetStringStatus => "fmi2GetStringStatus",
        Operation::EnterEventMode => "fmi2EnterEventMode",
        Operation::NewDiscreteStates => "fmi2NewDiscreteStates",
        Operation::EnterContinuousTimeMode => "fmi2EnterContinuousTimeMode",
        Operation::CompletedIntegratorStep => "fmi2CompletedIntegratorStep",
        Operation::SetTime => "fmi2SetTime",
        Operation::SetContinuousStates => "fmi2SetContinuousStates",
        Operation::GetDerivatives => "fmi2GetDerivatives",
        Operation::GetEventIndicators => "fmi2GetEventIndicators",
        Operation::GetContinuousStates => "fmi2GetContinuousStates",
        Operation::GetNominalsOfContinuousStates => "fmi2GetNominalsOfContinuousStates",
    }
}

/// The names of all functions that the shared library exports.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    let without_instance = ["fmi2GetTypesPlatform", "fmi2GetVersion", "fmi2Instantiate", "fmi2FreeInstance"];
    without_instance.into_iter().chain(Operation::all().map(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_called_as_their_functions_are() {
        for operation in Operation::all() {
            assert_eq!(name(operation), format!("fmi2{operation:?}"));
        }
    }
}

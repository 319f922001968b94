//! What can be asked of an instance, and what each version of FMI calls the function by which it is asked.

use super::interface::Version;

/// The operations, each with its function in FMI 2.0 and in FMI 3.0.
macro_rules! operations {
    ($($name:ident: $two:expr, $three:expr;)*) => {
        /// What can be asked of an instance; to free it is missing, for that is allowed always.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Operation {
            $($name,)*
        }

        impl Operation {
            /// All operations.
            pub const ALL: &[Operation] = &[$(Operation::$name,)*];

            /// The function of a version of FMI, if it has one.
            pub fn name(self, version: Version) -> Option<&'static str> {
                let names: [Option<&'static str>; 2] = match self {
                    $(Operation::$name => [$two, $three],)*
                };
                match version {
                    Version::V2 => names[0],
                    Version::V3 => names[1],
                }
            }
        }
    };
}

operations! {
    SetDebugLogging: Some("fmi2SetDebugLogging"), Some("fmi3SetDebugLogging");
    SetupExperiment: Some("fmi2SetupExperiment"), None;
    EnterInitializationMode: Some("fmi2EnterInitializationMode"), Some("fmi3EnterInitializationMode");
    ExitInitializationMode: Some("fmi2ExitInitializationMode"), Some("fmi3ExitInitializationMode");
    Terminate: Some("fmi2Terminate"), Some("fmi3Terminate");
    Reset: Some("fmi2Reset"), Some("fmi3Reset");
    GetReal: Some("fmi2GetReal"), Some("fmi3GetFloat64");
    GetInteger: Some("fmi2GetInteger"), Some("fmi3GetInt32");
    GetInt64: None, Some("fmi3GetInt64");
    GetBoolean: Some("fmi2GetBoolean"), Some("fmi3GetBoolean");
    GetString: Some("fmi2GetString"), Some("fmi3GetString");
    GetFloat32: None, Some("fmi3GetFloat32");
    GetInt8: None, Some("fmi3GetInt8");
    GetUInt8: None, Some("fmi3GetUInt8");
    GetInt16: None, Some("fmi3GetInt16");
    GetUInt16: None, Some("fmi3GetUInt16");
    GetUInt32: None, Some("fmi3GetUInt32");
    GetUInt64: None, Some("fmi3GetUInt64");
    GetBinary: None, Some("fmi3GetBinary");
    SetReal: Some("fmi2SetReal"), Some("fmi3SetFloat64");
    SetInteger: Some("fmi2SetInteger"), Some("fmi3SetInt32");
    SetInt64: None, Some("fmi3SetInt64");
    SetBoolean: Some("fmi2SetBoolean"), Some("fmi3SetBoolean");
    SetString: Some("fmi2SetString"), Some("fmi3SetString");
    SetFloat32: None, Some("fmi3SetFloat32");
    SetInt8: None, Some("fmi3SetInt8");
    SetUInt8: None, Some("fmi3SetUInt8");
    SetInt16: None, Some("fmi3SetInt16");
    SetUInt16: None, Some("fmi3SetUInt16");
    SetUInt32: None, Some("fmi3SetUInt32");
    SetUInt64: None, Some("fmi3SetUInt64");
    SetBinary: None, Some("fmi3SetBinary");
    GetFMUstate: Some("fmi2GetFMUstate"), Some("fmi3GetFMUState");
    SetFMUstate: Some("fmi2SetFMUstate"), Some("fmi3SetFMUState");
    FreeFMUstate: Some("fmi2FreeFMUstate"), Some("fmi3FreeFMUState");
    SerializedFMUstateSize: Some("fmi2SerializedFMUstateSize"), Some("fmi3SerializedFMUStateSize");
    SerializeFMUstate: Some("fmi2SerializeFMUstate"), Some("fmi3SerializeFMUState");
    DeSerializeFMUstate: Some("fmi2DeSerializeFMUstate"), Some("fmi3DeserializeFMUState");
    GetDirectionalDerivative: Some("fmi2GetDirectionalDerivative"), Some("fmi3GetDirectionalDerivative");
    GetAdjointDerivative: None, Some("fmi3GetAdjointDerivative");
    GetNumberOfVariableDependencies: None, Some("fmi3GetNumberOfVariableDependencies");
    GetVariableDependencies: None, Some("fmi3GetVariableDependencies");
    SetRealInputDerivatives: Some("fmi2SetRealInputDerivatives"), None;
    GetRealOutputDerivatives: Some("fmi2GetRealOutputDerivatives"), Some("fmi3GetOutputDerivatives");
    DoStep: Some("fmi2DoStep"), Some("fmi3DoStep");
    CancelStep: Some("fmi2CancelStep"), None;
    GetStatus: Some("fmi2GetStatus"), None;
    GetRealStatus: Some("fmi2GetRealStatus"), None;
    GetIntegerStatus: Some("fmi2GetIntegerStatus"), None;
    GetBooleanStatus: Some("fmi2GetBooleanStatus"), None;
    GetStringStatus: Some("fmi2GetStringStatus"), None;
    EnterStepMode: None, Some("fmi3EnterStepMode");
    EnterEventMode: Some("fmi2EnterEventMode"), Some("fmi3EnterEventMode");
    NewDiscreteStates: Some("fmi2NewDiscreteStates"), Some("fmi3UpdateDiscreteStates");
    EvaluateDiscreteStates: None, Some("fmi3EvaluateDiscreteStates");
    EnterContinuousTimeMode: Some("fmi2EnterContinuousTimeMode"), Some("fmi3EnterContinuousTimeMode");
    CompletedIntegratorStep: Some("fmi2CompletedIntegratorStep"), Some("fmi3CompletedIntegratorStep");
    SetTime: Some("fmi2SetTime"), Some("fmi3SetTime");
    SetContinuousStates: Some("fmi2SetContinuousStates"), Some("fmi3SetContinuousStates");
    GetDerivatives: Some("fmi2GetDerivatives"), Some("fmi3GetContinuousStateDerivatives");
    GetEventIndicators: Some("fmi2GetEventIndicators"), Some("fmi3GetEventIndicators");
    GetContinuousStates: Some("fmi2GetContinuousStates"), Some("fmi3GetContinuousStates");
    GetNominalsOfContinuousStates: Some("fmi2GetNominalsOfContinuousStates"), Some("fmi3GetNominalsOfContinuousStates");
    GetNumberOfContinuousStates: None, Some("fmi3GetNumberOfContinuousStates");
    GetNumberOfEventIndicators: None, Some("fmi3GetNumberOfEventIndicators");
    EnterConfigurationMode: None, Some("fmi3EnterConfigurationMode");
    ExitConfigurationMode: None, Some("fmi3ExitConfigurationMode");
    GetClock: None, Some("fmi3GetClock");
    SetClock: None, Some("fmi3SetClock");
    GetIntervalDecimal: None, Some("fmi3GetIntervalDecimal");
    GetIntervalFraction: None, Some("fmi3GetIntervalFraction");
    GetShiftDecimal: None, Some("fmi3GetShiftDecimal");
    GetShiftFraction: None, Some("fmi3GetShiftFraction");
    SetIntervalDecimal: None, Some("fmi3SetIntervalDecimal");
    SetIntervalFraction: None, Some("fmi3SetIntervalFraction");
    SetShiftDecimal: None, Some("fmi3SetShiftDecimal");
    SetShiftFraction: None, Some("fmi3SetShiftFraction");
    ActivateModelPartition: None, Some("fmi3ActivateModelPartition");
}

impl Version {
    /// The names of all functions that a shared library exports for it.
    pub fn function_names(self) -> impl Iterator<Item = &'static str> {
        let without_instance: &[&str] = match self {
            Version::V2 => &["fmi2GetTypesPlatform", "fmi2GetVersion", "fmi2Instantiate", "fmi2FreeInstance"],
            Version::V3 => &[
                "fmi3GetVersion",
                "fmi3InstantiateCoSimulation",
                "fmi3InstantiateModelExchange",
                "fmi3InstantiateScheduledExecution",
                "fmi3FreeInstance",
            ],
        };
        let of_instances = Operation::ALL.iter().filter_map(move |operation| operation.name(self));
        without_instance.iter().copied().chain(of_instances)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_versions_have_as_many_functions_as_their_standards() {
        assert_eq!(Version::V2.function_names().count(), 44);
        assert_eq!(Version::V3.function_names().count(), 75);
    }
}

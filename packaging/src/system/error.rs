//! Why FMUs do not make a system.

use std::path::PathBuf;

use flexible_aircraft::fmi::Interface;

use super::experiment::Experiment;
use crate::FileError;
use crate::model_description::VariableType;

/// Why FMUs do not make a system.
#[derive(Debug, thiserror::Error)]
pub enum SystemError {
    /// A name that would not do as a file name or in an endpoint.
    #[error("found the component name `{0}`, allowed are letters, digits, underscores and hyphens")]
    ComponentName(String),
    /// Two components of one name.
    #[error("found two components named `{0}`; each needs a name of its own")]
    TwoComponents(String),
    /// A file that is no FMU.
    #[error("{}: not an FMU of FMI 2.0 or 3.0: {reason}", path.display())]
    Fmu {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A file that cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A setting that libcosim cannot take.
    #[error(
        "{given}: libcosim has no enumerations, so that its own system structure cannot set one; an SSP archive can"
    )]
    EnumerationForOsp {
        /// As it was given.
        given: String,
    },
    /// A component that libcosim does not take.
    #[error(
        "`{component}` is an FMU of {found}: libcosim takes {}, so that its own system structure can have no other; an SSP archive can",
        Interface::USUAL
    )]
    InterfaceForOsp {
        /// Its name.
        component: String,
        /// What it is.
        found: Interface,
    },
    /// Step or end that cannot be.
    #[error(
        "found a step of {} s and an end at {} s, allowed is a step greater than 0 and an end no earlier than one step",
        .0.step, .0.stop_time
    )]
    Experiment(Experiment),
    /// Connections or settings that do not fit the model descriptions.
    #[error("{}", lines(.0))]
    Misfits(Vec<Misfit>),
}

/// A connection or a setting, as it was given, and what is wrong with it.
#[derive(Debug)]
pub struct Misfit {
    /// As it was given.
    pub given: String,
    /// What is wrong with it.
    pub error: ConnectionError,
}

/// What is wrong with a connection or a setting.
#[derive(Debug, thiserror::Error)]
pub enum ConnectionError {
    /// No such component.
    #[error("found the component `{found}`, allowed here: {allowed}")]
    UnknownComponent {
        /// What was given.
        found: String,
        /// All there are.
        allowed: String,
    },
    /// No such variable.
    #[error("`{component}` has no variable `{found}`; the nearest are {nearest}")]
    UnknownVariable {
        /// Name of the component.
        component: String,
        /// What was given.
        found: String,
        /// Names like it.
        nearest: String,
    },
    /// Not one output and one input.
    #[error("found {first} and {second}; a connection joins an output and an input")]
    Causality {
        /// The first end and what it is.
        first: String,
        /// The second end and what it is.
        second: String,
    },
    /// Not one number.
    #[error("found {found}, an array of {dimensions}; a connection or a setting is of one number")]
    Array {
        /// The variable and what it is.
        found: String,
        /// Its size.
        dimensions: String,
    },
    /// Two types of number.
    #[error("the output is of type {output}, the input of type {input}; both ends need the same type")]
    Type {
        /// Of the output.
        output: String,
        /// Of the input.
        input: String,
    },
    /// Two units.
    #[error(
        "the output is in {output}, the input in {input}; masters do not convert units, so both ends need the same"
    )]
    Unit {
        /// Of the output.
        output: String,
        /// Of the input.
        input: String,
    },
    /// An input that has an output already.
    #[error("the input `{input}` is fed by `{by}` already")]
    FedTwice {
        /// The input.
        input: String,
        /// The output that feeds it.
        by: String,
    },
    /// Not to be set from outside.
    #[error("found {found}; parameters and inputs that are not connected can be set, once")]
    NotSettable {
        /// The variable and what it is.
        found: String,
    },
    /// A value of another type.
    #[error("found the value `{found}`; {allowed}")]
    Value {
        /// What was given.
        found: String,
        /// What can be.
        allowed: String,
    },
}

impl ConnectionError {
    pub(super) fn types(output: VariableType, input: VariableType) -> Self {
        ConnectionError::Type { output: output.to_string(), input: input.to_string() }
    }
}

fn lines(misfits: &[Misfit]) -> String {
    let lines: Vec<String> =
        misfits.iter().map(|Misfit { given, error }| format!("{given}: {error}")).collect();
    lines.join("\nerror: ")
}

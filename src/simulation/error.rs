//! Why a flight cannot start or go on.

/// Why a flight cannot start or go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// A setting is outside its range.
    #[error("{setting}: found {found}, allowed is {allowed}")]
    Setting {
        /// Name of the FMI parameter.
        setting: &'static str,
        /// What was given.
        found: String,
        /// What is allowed.
        allowed: String,
    },
}

//! A setting of a plant that is outside its range.

use crate::air::OutOfRange;
use crate::equations::ClosesLoop;

/// A setting that is outside its range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{setting}: found {found}, allowed is {allowed}")]
pub struct SettingError {
    /// Name of the FMI parameter.
    pub setting: String,
    /// What was given.
    pub found: String,
    /// What is allowed.
    pub allowed: String,
}

impl From<ClosesLoop> for SettingError {
    fn from(ClosesLoop { found, allowed, joint }: ClosesLoop) -> Self {
        let allowed = format!("{allowed}: {joint} closes a loop");
        SettingError { setting: "model".to_owned(), found: found.to_owned(), allowed }
    }
}

impl From<OutOfRange> for SettingError {
    fn from(OutOfRange { setting, found, allowed }: OutOfRange) -> Self {
        SettingError { setting: setting.to_owned(), found: found.to_string(), allowed: allowed.to_owned() }
    }
}

//! A setting of the air that is outside its range.

/// Which one, what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{setting}: found {found}, allowed is {allowed}")]
pub struct OutOfRange {
    /// Name of the parameter.
    pub setting: &'static str,
    /// What was given.
    pub found: f64,
    /// For people, with the unit.
    pub allowed: &'static str,
}

impl OutOfRange {
    /// Refuses a number that is not finite or not inside.
    pub(super) fn unless(
        setting: &'static str,
        found: f64,
        inside: bool,
        allowed: &'static str,
    ) -> Result<(), OutOfRange> {
        if found.is_finite() && inside { Ok(()) } else { Err(OutOfRange { setting, found, allowed }) }
    }
}

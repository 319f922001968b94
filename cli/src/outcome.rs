//! How a command ended that did what was asked.

/// Whether there is something to say of what was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// There is not.
    Clean,
    /// Something is unusual, or not as it was asked for; it was said.
    Remarks,
}

impl From<()> for Outcome {
    fn from((): ()) -> Self {
        Outcome::Clean
    }
}

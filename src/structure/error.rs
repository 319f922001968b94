//! What can go wrong between an aircraft and its reduced model.

/// Why a structure could not be reduced, or a reduced model not be read.
#[derive(Debug, thiserror::Error)]
pub enum StructureError {
    /// The bytes are not an undamaged reduced model of this version.
    #[error("not a reduced model of this version: {0}")]
    Bytes(String),
}

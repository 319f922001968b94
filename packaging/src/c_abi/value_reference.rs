//! How variables are asked for.

/// A value reference: the address of a variable.
pub type ValueReference = u32;

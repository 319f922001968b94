//! From beams and masses to modes, modal integrals and strain-energy tensors.

mod error;
mod reduced;

pub use error::StructureError;
pub use reduced::{Mode, ModeFamily, ModeShapes, ReducedEngine, ReducedModel, ReducedStation};

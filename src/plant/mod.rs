//! What is asked of the equations of motion: trims, linear motion, sensors [5.1; physics.md §6].

mod free_modes;
mod linearisation;
mod sensors;
mod trim;
mod trim_error;
mod trim_search;
mod trim_tangent;

pub(crate) use free_modes::FreeModes;
pub use linearisation::{EigenvaluesNotFound, StateMatrix, Unknown};
pub use sensors::{BodyMotion, Sensors};
pub use trim::{Trim, TrimCondition, TrimPoint};
pub use trim_error::{TrimError, TrimFailure};
pub use trim_tangent::{TrimTangents, WIDTHS, slope};

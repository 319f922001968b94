//! What is asked of the equations of motion: trims, linear motion, sensors.
//!
//! [theory: trim.steady-flight, linearisation.state-matrix, outputs.sensors; thesis §5.1]

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

//! Flutter and divergence: how the roots of the linearised motion move as the airspeed grows.
//!
//! At each airspeed of a range the aircraft is trimmed and [linearised](crate::dynamics::StateMatrix). Its
//! roots are told apart by following each from speed to speed, never by sorting them: `condensed` eliminates
//! the wake from the eigenvalue problem and finds a root near a known one, `continuation` follows a root with
//! steps as small as its shape demands, `sweep` does so over the range and finds where roots become unstable.
//! A tool for the desk: everything here allocates.

mod condensed;
mod continuation;
mod sweep;

pub use condensed::Root;
pub use sweep::{Branch, Crossing, CrossingKind, SkipReason, Skipped, Sweep};

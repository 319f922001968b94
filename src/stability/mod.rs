//! Flutter and divergence: how the roots of the linearised motion move as the airspeed grows; and what they are called in flight.
//!
//! [theory: stability.branches, stability.modes]
//!
//! At each airspeed of a range the aircraft is trimmed and [linearised](crate::plant::StateMatrix). Its
//! roots are told apart by following each from speed to speed, never by sorting them: `condensed` eliminates
//! the wake from the eigenvalue problem and finds a root near a known one, `continuation` follows a root with
//! steps as small as its shape demands, `between` has the motion between two airspeeds, `tracks` follows all over the range and finds where roots become unstable,
//! `losses` where the equilibrium that is linearised is lost, `unstable` lists every speed that has an unstable root. `flight_modes` names those of
//! one trim, or from one trim to the next.
//! A tool for the desk: everything here allocates.

mod between;
mod condensed;
mod continuation;
mod equilibrium;
mod flight_modes;
mod losses;
mod mode_names;
mod points;
mod sweep;
mod tracks;
mod unstable;

pub use nalgebra::Complex;

pub use condensed::Root;
pub use flight_modes::{FlightMode, FlightModes};
pub use losses::{EquilibriumLoss, LossKind};
pub use mode_names::{FlightModeKind, FlightModeName};
pub use points::{SkipReason, Skipped};
pub use sweep::{Sweep, SweepError};
pub use tracks::{Branch, Crossing, CrossingKind};
pub use unstable::{Onset, UnstableRange};

//! The equations of motion of the flexible aircraft at five fidelity levels, and its trim [2; physics.md §2–6].

mod air_loads;
mod around;
mod attitude;
mod controls;
mod edge_on;
mod equations;
#[cfg(test)]
pub(crate) mod evaluations;
mod fidelity;
mod forces;
mod free_modes;
mod freedom;
mod in_plane;
mod in_space;
mod inertia;
mod layout;
mod linear_solve;
mod linearisation;
mod mechanics;
mod propulsion;
mod rotation;
mod sensors;
mod square_matrix;
mod strip_loads;
mod strip_sums;
mod strips;
mod structural_forces;
mod trim;
mod trim_error;
mod trim_search;
mod trim_tangent;
mod workspace;

pub use attitude::Attitude;
pub use controls::Controls;
pub use equations::{Configuration, EquationsOfMotion};
pub use fidelity::{Fidelity, Terms};
pub(crate) use free_modes::FreeModes;
pub use inertia::RigidMotion;
pub use layout::StateLayout;
pub use linearisation::{EigenvaluesNotFound, StateMatrix, Unknown};
pub use mechanics::Mechanics;
pub(crate) use propulsion::combine;
pub use sensors::{BodyMotion, Sensors};
pub use trim::{Trim, TrimCondition, TrimPoint};
pub use trim_error::{TrimError, TrimFailure};
pub use trim_tangent::{TrimTangents, WIDTHS, slope};
pub use workspace::Workspace;

#[cfg(test)]
mod tests;

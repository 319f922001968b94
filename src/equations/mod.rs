//! The equations of motion of the flexible aircraft at five fidelity levels.
//!
//! [theory: equations-of-motion.rows, equations-of-motion.levels; thesis §2.2–2.4]

mod acting;
mod around;
mod controls;
#[cfg(test)]
pub(crate) mod evaluations;
mod fidelity;
mod forces;
mod layout;
mod mechanics;
mod of_motion;
mod propulsion;
mod rates;
mod structural_forces;
mod superposed_inertia;
mod workspace;

pub use controls::Controls;
pub use fidelity::{Fidelity, Terms};
pub use layout::StateLayout;
pub use mechanics::Mechanics;
pub use of_motion::{Configuration, EquationsOfMotion};
pub use workspace::Workspace;

#[cfg(test)]
mod tests;

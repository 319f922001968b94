//! The equations of motion of the flexible aircraft at six fidelity levels.
//!
//! [theory: equations-of-motion.rows, equations-of-motion.levels; thesis §2.2–2.4]
//!
//! ```
//! use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Workspace};
//! use flexible_aircraft::{Aircraft, ReducedModel};
//! use nalgebra::Vector3;
//!
//! let jet = ReducedModel::new(&Aircraft::read("aircraft/generic-business-jet.toml")?, 4)?;
//! let equations = EquationsOfMotion::new(&jet, &Configuration {
//!     fidelity: Fidelity::Exact,
//!     stiffness_scale: 1.0,
//!     structural_damping: 0.0,
//!     inflow_states: 2,
//!     temperature_offset: 0.0,
//!     tunnel_flow: Vector3::zeros(),
//! })?;
//! let mut state = vec![0.0; equations.layout().len()];
//! state[equations.layout().attitude()][0] = 1.0; // level, at rest, not deformed
//! let (mut rates, mut workspace) = (vec![0.0; state.len()], Workspace::new(&equations));
//! equations.rates(&state, &equations.neutral_controls(), &mut rates, &mut workspace);
//! let fall = rates[equations.layout().velocity()][2]; // m/s², down
//! // The wings have to push the air aside, which weighs something.
//! assert!(0.95 * jet.gravity < fall && fall < jet.gravity, "{fall}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod acting;
mod around;
mod assembly;
mod centre_of_mass;
mod controls;
mod cuts;
mod deformation;
#[cfg(test)]
pub(crate) mod evaluations;
mod fidelity;
mod forces;
mod layout;
mod mechanics;
mod of_motion;
mod propulsion;
mod rates;
mod section_loads;
mod station_loads;
mod workspace;

pub(crate) use centre_of_mass::CentreOfMass;
pub use controls::Controls;
pub use cuts::SectionLoads;
pub use fidelity::{ClosesLoop, Fidelity, Terms};
pub use layout::StateLayout;
pub use mechanics::Mechanics;
pub use of_motion::{Configuration, EquationsOfMotion};
pub(crate) use station_loads::{StationLoad, StationLoads};
pub use workspace::Workspace;

#[cfg(test)]
pub(crate) mod tests;

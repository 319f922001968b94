//! Aerodynamic strips: sections with their inflow and flaps, side by side on the deformed aircraft.
//!
//! [theory: air-loads.flow, air-loads.distribution, inflow.state; thesis §4.1]

mod air_loads;
mod edge_on;
mod flap;
mod flap_factor;
mod group;
mod in_plane;
mod in_space;
mod inflow;
mod inflow_layout;
mod loads;
mod section;
mod sums;

pub(crate) use air_loads::SumLoads;
pub use flap::FlapEffect;
pub(crate) use flap_factor::FlapFactor;
pub(crate) use group::{Strips, Surroundings};
pub use inflow::{InflowStates, PetersInflow};
pub use inflow_layout::{GroupInflow, InflowLayout};
pub(crate) use sums::StripSums;

//! Aerodynamic strips: sections with their inflow and flaps, side by side on the deformed aircraft.
//!
//! [theory: air-loads.flow, air-loads.distribution, inflow.state, gusts.chord; thesis §4.1]

mod aerofoil;
mod air_loads;
mod all_strips;
mod edge_on;
mod flap_factor;
mod group;
mod gust_at_strips;
mod in_plane;
mod in_space;
mod inflow;
mod inflow_layout;
mod penetration;
mod resultants;
mod strip_loads;
mod sums;
mod surroundings;

pub(crate) use air_loads::SumLoads;
pub(crate) use all_strips::Strips;
pub(crate) use flap_factor::FlapFactor;
pub(crate) use gust_at_strips::GustAtStrips;
pub use inflow::{InflowStates, PetersInflow};
pub use inflow_layout::{GroupInflow, InflowLayout};
pub(crate) use penetration::Penetrate;
pub(crate) use resultants::Accelerated;
pub use resultants::Resultant;
pub(crate) use sums::StripSums;
pub(crate) use surroundings::Surroundings;

#[cfg(test)]
mod tests;

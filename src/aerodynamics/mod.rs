//! Air and aerofoil sections: atmosphere, Peters inflow, flaps, section loads [4.1; physics.md §4].
//!
//! Everything here is two-dimensional and per unit width; how a strip moves and where its loads go is
//! [`dynamics`](crate::dynamics)' business.

mod atmosphere;
mod flap;
mod inflow;
mod section;

pub use atmosphere::{Air, STANDARD_GRAVITY};
pub use flap::FlapEffect;
pub(crate) use inflow::WakeFlow;
pub use inflow::{InflowStates, PetersInflow};
pub(crate) use section::{FlapLoads, LocalFlow, Section, SectionLoads};

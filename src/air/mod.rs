//! The air: the atmosphere, and how it moves at a point [theory: air.atmosphere, air.tunnel, air.wind].

mod atmosphere;
mod flow;

pub use atmosphere::{Air, STANDARD_GRAVITY};
pub use flow::UniformFlow;
pub(crate) use flow::{MetAir, MetAt, UniformlyMet};

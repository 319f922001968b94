//! The air: the atmosphere, and how it moves at a point [4.1; physics.md §4].

mod atmosphere;
mod flow;

pub use atmosphere::{Air, STANDARD_GRAVITY};
pub use flow::UniformFlow;
pub(crate) use flow::{MetAir, MetAt, UniformlyMet};

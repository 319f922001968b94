//! The air: the atmosphere [4.1; physics.md §4].

mod atmosphere;

pub use atmosphere::{Air, STANDARD_GRAVITY};

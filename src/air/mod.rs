//! The air: the atmosphere [theory: air.atmosphere, air.tunnel].

mod atmosphere;

pub use atmosphere::{Air, STANDARD_GRAVITY};

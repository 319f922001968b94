//! Symmetry: the one room that knows that half the aircraft can fly for the whole [theory: symmetry.half].

mod actions;
mod even_controls;
mod flying;
mod forms;
mod half;
mod half_sections;
mod plants;
mod unfolding;

pub use actions::{Actions, Motion};
pub use even_controls::EvenControls;
pub(crate) use flying::{ActivePlant, FlyingPlant};
pub use forms::{Form, Forms};
pub use half::{Counterpart, SymmetricHalf};
pub use plants::{Plants, Trimmed};

#[cfg(test)]
mod tests;

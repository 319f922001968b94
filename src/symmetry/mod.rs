//! The aircraft whose motion is its own mirror image: half of it flies for the whole (physics.md §1).

mod even_controls;
mod half;

pub use even_controls::EvenControls;
pub use half::{Counterpart, SymmetricHalf};

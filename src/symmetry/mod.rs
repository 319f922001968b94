//! The aircraft whose motion is its own mirror image: half of it flies for the whole (physics.md §1).

mod half;

pub use half::{Counterpart, SymmetricHalf};

//! The aircraft whose motion is its own mirror image: half of it flies for the whole [theory: symmetry.half].

mod half;

pub use half::{Counterpart, SymmetricHalf};

//! How the deformed aircraft moves [2.1; physics.md §2].

mod freedom;
mod rigid_motion;
mod superposition;
mod velocities;

pub(crate) use freedom::RigidFreedom;
pub use rigid_motion::RigidMotion;
pub(crate) use superposition::combine;
pub(crate) use velocities::{ASIDE, GeneralisedVector, GeneralisedVectorMut, IN_PLANE, velocities};

//! How the deformed aircraft moves [theory: frames.displacement, frames.velocity; thesis eq. 2.1, 2.2].

mod freedom;
mod rigid_motion;
mod superposition;

pub(crate) use freedom::RigidFreedom;
pub use rigid_motion::RigidMotion;
pub(crate) use superposition::combine;

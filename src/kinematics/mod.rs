//! How the deformed aircraft moves [theory: frames.displacement, frames.velocity; thesis eq. 2.1, 2.2].

mod freedom;
mod linear;
mod rigid_motion;
mod sections;
mod velocities;

pub(crate) use freedom::RigidFreedom;
pub(crate) use linear::Superposition;
pub use rigid_motion::RigidMotion;
pub(crate) use sections::{Bias, Section, SectionMotion, Sections, SectionsInPlane, SectionsInSpace, Turn};
pub(crate) use velocities::{ASIDE, GeneralisedVector, GeneralisedVectorMut, IN_PLANE, velocities};

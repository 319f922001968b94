//! How the deformed aircraft moves [theory: kinematics.sections, frames.velocity; thesis eq. 2.1, 2.2].

#[cfg_attr(not(test), allow(dead_code, reason = "no level of fidelity has it yet"))]
mod exact;
mod freedom;
mod kind;
mod linear;
mod rigid_motion;
mod sections;
#[cfg(test)]
pub(crate) mod test_kind;
mod velocities;

#[cfg_attr(not(test), allow(unused_imports, reason = "no level of fidelity has it yet"))]
pub(crate) use exact::GeometricallyExact;
pub(crate) use freedom::RigidFreedom;
pub(crate) use kind::{Coordinates, Inertia, Kinematics};
pub(crate) use linear::Superposition;
pub use rigid_motion::RigidMotion;
pub(crate) use sections::{Bias, Section, SectionMotion, Sections, SectionsInPlane, SectionsInSpace, Turn};
pub(crate) use velocities::{ASIDE, GeneralisedVector, GeneralisedVectorMut, IN_PLANE, velocities};

/// The kind by which aircraft move, at all levels of fidelity.
pub(crate) type Kind = Superposition;

/// What it writes for an instant.
pub(crate) type Memory = <Kind as Kinematics>::Memory;

/// What mass does that moves so.
pub(crate) type KindInertia = <Kind as Kinematics>::Inertia;

//! How the deformed aircraft moves [theory: kinematics.sections, frames.velocity; thesis eq. 2.1, 2.2].

mod exact;
mod freedom;
mod kind;
mod linear;
mod of_kind;
mod rigid_motion;
mod sections;
#[cfg(test)]
pub(crate) mod test_kind;
mod velocities;

#[cfg(test)]
pub(crate) use exact::GeometricallyExact;
pub(crate) use freedom::RigidFreedom;
pub(crate) use kind::{Coordinates, Inertia, Kinematics};
#[cfg(test)]
pub(crate) use linear::Superposition;
pub(crate) use of_kind::{AnyInertia, AnyKind, AnyMemory, OfKind, by_kind};
pub use rigid_motion::RigidMotion;
pub(crate) use sections::{
    Bias, Carried, CarriesMass, Pose, Section, SectionMotion, Sections, SectionsInPlane, SectionsInSpace,
    Turn,
};
pub(crate) use velocities::{ASIDE, GeneralisedVector, GeneralisedVectorMut, IN_PLANE, velocities};

//! What can go wrong between an aircraft and its reduced model.

use super::ModeKind;

/// Why a structure could not be reduced, or a reduced model not be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StructureError {
    /// A bay's inertia violates the triangle inequality.
    #[error(
        "mass bay {bay}: its inertia is not that of any mass distribution (one principal moment exceeds the sum of the others)"
    )]
    UnphysicalInertia {
        /// Index of the bay.
        bay: usize,
    },
    /// The stiffness matrix is not positive definite.
    #[error(
        "the structure clamped at node 0 can move without strain: its stiffness matrix is not positive definite"
    )]
    Mechanism,
    /// The eigensolver did not converge.
    #[error("the natural modes did not converge")]
    EigenvaluesNotFound,
    /// More modes were asked for than the masses allow.
    #[error("{wanted} {kind} were asked for, the structure has {available}")]
    TooFewModes {
        /// Asked for.
        wanted: usize,
        /// Of these.
        kind: ModeKind,
        /// Possible.
        available: usize,
    },
    /// Symmetric modes were asked for.
    #[error("symmetric modes were asked for, the structure has no mirror plane y = 0")]
    NoMirrorPlane,
    /// More modes were asked for than the strain energy can hold.
    #[error(
        "{wanted} modes are needed, at most {most} are possible: the quartic strain energy has n⁴/24 coefficients"
    )]
    TooManyModes {
        /// Asked for.
        wanted: usize,
        /// Allowed.
        most: usize,
    },
    /// The aircraft flies geometrically exactly unless someone asks for another level, and has loops.
    #[error(
        "{joint} closes a loop, and level \"geometrically_exact\" has none: \"exact\" is a level that has"
    )]
    Loop {
        /// The joint.
        joint: String,
    },
    /// A cut for section loads is within a loop.
    #[error(
        "the cut \"{cut}\" is within the loop that is closed by {joint}: summation has no unique answer there"
    )]
    CutInLoop {
        /// Name of the cut.
        cut: String,
        /// The joint.
        joint: String,
    },
    /// The aircraft's numbers are too large or too small to be computed with.
    #[error(
        "the reduced model has numbers that are not finite: the aircraft's stiffnesses or masses are too large or too small"
    )]
    NotFinite,
    /// The bytes are not a reduced model.
    #[error("not a reduced model: {0}")]
    Bytes(&'static str),
}

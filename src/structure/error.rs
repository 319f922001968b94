//! What can go wrong between an aircraft and its reduced model.

/// Why a structure could not be reduced, or a reduced model not be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
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
    #[error("{wanted} modes were asked for, the structure has {available}")]
    TooFewModes {
        /// Asked for.
        wanted: usize,
        /// Possible.
        available: usize,
    },
    /// The bytes are not a reduced model.
    #[error("not a reduced model: {0}")]
    Bytes(&'static str),
}

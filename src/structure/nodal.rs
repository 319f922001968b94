//! Linear forms on what the two nodes of an element do [theory: structure.beam].

use nalgebra::{SMatrix, SVector};

/// The 12 nodal unknowns of an element, or a linear form on them.
pub type NodalRow = SVector<f64, 12>;

/// Rows that map nodal unknowns to a vector.
pub type NodalMap = SMatrix<f64, 3, 12>;

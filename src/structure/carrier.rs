//! What something that is attached to the structure hangs on [theory: kinematics.sections, geometrically-exact.half].

use serde::{Deserialize, Serialize};

/// A section that carries something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Carrier {
    /// Which of the sections.
    pub section: usize,
    /// Whether that is the mirror image of what carries it, and moves so.
    pub mirrored: bool,
}

impl Carrier {
    /// The section itself.
    pub(super) fn own(section: usize) -> Self {
        Carrier { section, mirrored: false }
    }
}

//! What support and symmetry leave free of the rigid motion [theory: equations-of-motion.freedom, symmetry.freedom].

use super::velocities::{IN_PLANE, RIGID, velocities};

/// Which components of v and ω move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigidFreedom {
    /// All six.
    All,
    /// Those in the mirror plane y = 0: v_x, v_z and ω_y.
    InPlane,
    /// None.
    Held,
}

impl RigidFreedom {
    /// Their places in ν = [v; ω; q̇].
    pub fn components(self) -> &'static [usize] {
        match self {
            RigidFreedom::All => &[0, 1, 2, 3, 4, 5],
            RigidFreedom::InPlane => &IN_PLANE,
            RigidFreedom::Held => &[],
        }
    }

    /// Axes along which it translates, and axes about which it turns.
    pub const fn motions(self) -> [&'static [usize]; 2] {
        match self {
            RigidFreedom::All => [&[0, 1, 2], &[0, 1, 2]],
            RigidFreedom::InPlane => [&[0, 2], &[1]],
            RigidFreedom::Held => [&[], &[]],
        }
    }

    /// The axes about which there can be any rate: of a held aircraft it may be prescribed.
    pub fn axes(self) -> &'static [usize] {
        match self {
            RigidFreedom::All | RigidFreedom::Held => &[0, 1, 2],
            RigidFreedom::InPlane => &[1],
        }
    }

    /// Place among them of an axis that moves.
    pub fn place(self, axis: usize) -> usize {
        match self {
            RigidFreedom::All | RigidFreedom::Held => axis,
            RigidFreedom::InPlane => 0,
        }
    }

    /// How many components that move are translations.
    pub fn translations(self) -> usize {
        self.motions()[0].len()
    }

    /// Places in ν of all that moves, with the generalised coordinates.
    pub fn moving(self, modes: usize) -> Vec<usize> {
        self.components().iter().copied().chain(RIGID..velocities(modes)).collect()
    }
}

//! The terms that each level of fidelity keeps [theory: equations-of-motion.levels; thesis §2.4].

pub use crate::aircraft::Fidelity;

/// What is evaluated on the deformed aircraft ("hat"), and which parts of the strain energy count.
///
/// ```
/// use flexible_aircraft::equations::Fidelity;
///
/// let terms = Fidelity::Inconsistent.terms();
/// assert!(terms.deformed_mass && !terms.quartic_energy);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terms {
    /// The mass matrix.
    pub deformed_mass: bool,
    /// Inertial forcing with its q̇ terms, and the arms of gravity, thrust and air loads.
    pub deformed_forcing: bool,
    /// ½K₁(q)q.
    pub cubic_energy: bool,
    /// ⅓K₂(q)q.
    pub quartic_energy: bool,
    /// Strains superpose, not displacements: finite kinematics, and each coordinate's own ω²q as elastic force.
    pub superposed_strains: bool,
}

impl Fidelity {
    /// The table of [theory: equations-of-motion.levels].
    pub fn terms(self) -> Terms {
        let (deformed_mass, deformed_forcing, cubic_energy, quartic_energy) = match self {
            Fidelity::Exact => (true, true, true, true),
            Fidelity::ConsistentlyLinearised => (false, true, true, false),
            Fidelity::Inconsistent | Fidelity::GeometricallyExact => (true, true, false, false),
            Fidelity::RuthlesslyLinearised | Fidelity::Rigid => (false, false, false, false),
        };
        let superposed_strains = self == Fidelity::GeometricallyExact;
        Terms { deformed_mass, deformed_forcing, cubic_energy, quartic_energy, superposed_strains }
    }
}

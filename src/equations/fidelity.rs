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

/// A level that knows no loops, for a model in which a joint closes one.
///
/// [theory: geometrically-exact.sections, limits-of-validity.loops]
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("model: found {found}, allowed is {allowed}: {joint} closes a loop")]
pub struct ClosesLoop {
    /// Name of the level.
    pub found: &'static str,
    /// Names of the levels that fly loops.
    pub allowed: String,
    /// One of the joints, in words.
    pub joint: String,
}

impl Fidelity {
    /// That equations of this level can be those of a model with such joints.
    ///
    /// # Errors
    /// Of the geometrically exact level, when there is a joint.
    pub(crate) fn flies(self, joints: &[String]) -> Result<(), ClosesLoop> {
        match (self, joints.first()) {
            (Fidelity::GeometricallyExact, Some(joint)) => Err(ClosesLoop {
                found: self.name(),
                allowed: Fidelity::OF_THESIS.map(Fidelity::name).join(", "),
                joint: joint.clone(),
            }),
            _ => Ok(()),
        }
    }

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

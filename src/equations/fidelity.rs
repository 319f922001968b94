//! The five fidelity levels and the terms that each keeps [theory: equations-of-motion.levels; thesis §2.4].

/// How much of the nonlinear dynamics a model keeps.
///
/// ```
/// use flexible_aircraft::equations::Fidelity;
///
/// let terms = Fidelity::Inconsistent.terms();
/// assert!(terms.deformed_mass && !terms.quartic_energy);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Fidelity {
    /// E: all inertial and geometric nonlinearities.
    Exact,
    /// CL: undeformed mass matrix, deformed forcing, strain energy to third order.
    ConsistentlyLinearised,
    /// I: exact inertia, linear elasticity.
    Inconsistent,
    /// RL: undeformed inertia and arms, linear elasticity.
    RuthlesslyLinearised,
    /// No deformation.
    Rigid,
}

/// What is evaluated on the deformed aircraft ("hat"), and which parts of the strain energy count.
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
}

impl Fidelity {
    /// All levels, in the order of the FMI enumeration (1-based there).
    pub const ALL: [Fidelity; 5] = [
        Fidelity::Exact,
        Fidelity::ConsistentlyLinearised,
        Fidelity::Inconsistent,
        Fidelity::RuthlesslyLinearised,
        Fidelity::Rigid,
    ];

    /// The thesis' letters.
    pub fn symbol(self) -> &'static str {
        match self {
            Fidelity::Exact => "E",
            Fidelity::ConsistentlyLinearised => "CL",
            Fidelity::Inconsistent => "I",
            Fidelity::RuthlesslyLinearised => "RL",
            Fidelity::Rigid => "Rigid",
        }
    }

    /// For people, beside the letters.
    pub fn in_words(self) -> &'static str {
        match self {
            Fidelity::Exact => "exact",
            Fidelity::ConsistentlyLinearised => "consistently linearised",
            Fidelity::Inconsistent => "inconsistent",
            Fidelity::RuthlesslyLinearised => "ruthlessly linearised",
            Fidelity::Rigid => "no deformation",
        }
    }

    /// The table of [theory: equations-of-motion.levels].
    pub fn terms(self) -> Terms {
        let (deformed_mass, deformed_forcing, cubic_energy, quartic_energy) = match self {
            Fidelity::Exact => (true, true, true, true),
            Fidelity::ConsistentlyLinearised => (false, true, true, false),
            Fidelity::Inconsistent => (true, true, false, false),
            Fidelity::RuthlesslyLinearised | Fidelity::Rigid => (false, false, false, false),
        };
        Terms { deformed_mass, deformed_forcing, cubic_energy, quartic_energy }
    }
}

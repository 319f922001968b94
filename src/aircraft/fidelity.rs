//! The six levels of fidelity at which an aircraft can fly: their names and what each is for.
//!
//! [theory: equations-of-motion.levels; thesis §2.4]

use serde::{Deserialize, Serialize};

/// How much of the nonlinear dynamics a model keeps.
///
/// ```
/// use flexible_aircraft::aircraft::{Aircraft, Fidelity};
///
/// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?;
/// assert_eq!((jet.fidelity, jet.fidelity.name()), (Fidelity::Exact, "exact"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
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
    /// GE: strains superpose, positions and turns follow by finite kinematics; for wings that bend visibly.
    GeometricallyExact,
}

impl Fidelity {
    /// All levels, in the order of the FMI enumeration (1-based there).
    pub const ALL: [Fidelity; 6] = [
        Fidelity::Exact,
        Fidelity::ConsistentlyLinearised,
        Fidelity::Inconsistent,
        Fidelity::RuthlesslyLinearised,
        Fidelity::Rigid,
        Fidelity::GeometricallyExact,
    ];

    /// That of a file that names none.
    pub const USUAL: Fidelity = Fidelity::GeometricallyExact;

    /// Those that the thesis compares.
    pub const OF_THESIS: [Fidelity; 5] = [
        Fidelity::Exact,
        Fidelity::ConsistentlyLinearised,
        Fidelity::Inconsistent,
        Fidelity::RuthlesslyLinearised,
        Fidelity::Rigid,
    ];

    /// The name in files, on the command line and in the FMU.
    pub const fn name(self) -> &'static str {
        match self {
            Fidelity::Exact => "exact",
            Fidelity::ConsistentlyLinearised => "consistently_linearised",
            Fidelity::Inconsistent => "inconsistent",
            Fidelity::RuthlesslyLinearised => "ruthlessly_linearised",
            Fidelity::Rigid => "rigid",
            Fidelity::GeometricallyExact => "geometrically_exact",
        }
    }

    /// What it keeps, in a line.
    pub const fn description(self) -> &'static str {
        match self {
            Fidelity::Exact => "All inertial and geometric nonlinearities of superposed displacements",
            Fidelity::ConsistentlyLinearised => "Undeformed mass matrix, strain energy to third order",
            Fidelity::Inconsistent => "Exact inertia with linear elasticity",
            Fidelity::RuthlesslyLinearised => "Undeformed inertia and moment arms, linear elasticity",
            Fidelity::Rigid => "No deformation",
            Fidelity::GeometricallyExact => {
                "Superposed strains, finite rotations: for wings that bend visibly"
            }
        }
    }

    /// The level of a name.
    pub fn named(name: &str) -> Option<Self> {
        Fidelity::ALL.into_iter().find(|level| level.name() == name)
    }

    /// The thesis' letters, and GE.
    pub fn symbol(self) -> &'static str {
        match self {
            Fidelity::Exact => "E",
            Fidelity::ConsistentlyLinearised => "CL",
            Fidelity::Inconsistent => "I",
            Fidelity::RuthlesslyLinearised => "RL",
            Fidelity::Rigid => "Rigid",
            Fidelity::GeometricallyExact => "GE",
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
            Fidelity::GeometricallyExact => "geometrically exact",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_stands_at_its_number_and_has_a_name_of_its_own() {
        for (number, level) in Fidelity::ALL.into_iter().enumerate() {
            assert_eq!((level as usize, Fidelity::named(level.name())), (number, Some(level)));
        }
        assert_eq!(Fidelity::named("Exact"), None);
    }
}

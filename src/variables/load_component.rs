//! The six components of section loads [theory: section-loads.components].

use crate::equations::SectionLoads;

use super::unit::Unit;

/// A component of the loads at a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the components are documented in SectionLoads")]
#[non_exhaustive]
pub enum LoadComponent {
    Shear,
    ShearChordwise,
    Axial,
    Torsion,
    Bending,
    BendingChordwise,
}

impl LoadComponent {
    /// All six, forces first.
    pub const ALL: [LoadComponent; 6] = [
        LoadComponent::Shear,
        LoadComponent::ShearChordwise,
        LoadComponent::Axial,
        LoadComponent::Torsion,
        LoadComponent::Bending,
        LoadComponent::BendingChordwise,
    ];

    /// As it ends the names of variables.
    pub fn name(self) -> &'static str {
        match self {
            LoadComponent::Shear => "shear",
            LoadComponent::ShearChordwise => "shear_chordwise",
            LoadComponent::Axial => "axial",
            LoadComponent::Torsion => "torsion",
            LoadComponent::Bending => "bending",
            LoadComponent::BendingChordwise => "bending_chordwise",
        }
    }

    /// Of its values.
    pub fn unit(self) -> Unit {
        match self {
            LoadComponent::Shear | LoadComponent::ShearChordwise | LoadComponent::Axial => Unit::Newton,
            LoadComponent::Torsion | LoadComponent::Bending | LoadComponent::BendingChordwise => {
                Unit::NewtonMetre
            }
        }
    }

    /// Of the loads at a cut, N or N·m.
    pub fn of(self, loads: &SectionLoads) -> f64 {
        match self {
            LoadComponent::Shear => loads.shear,
            LoadComponent::ShearChordwise => loads.shear_chordwise,
            LoadComponent::Axial => loads.axial,
            LoadComponent::Torsion => loads.torsion,
            LoadComponent::Bending => loads.bending,
            LoadComponent::BendingChordwise => loads.bending_chordwise,
        }
    }
}

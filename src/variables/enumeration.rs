//! The enumerations of the parameters, with their items.

use crate::equations::Fidelity;

/// The enumerations of the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EnumerationType {
    /// [`Fidelity`].
    Model,
    /// [`InputReference`](crate::flight::InputReference).
    InputReference,
    /// [`ModeSelection`](crate::plant::ModeSelection).
    ModeFamily,
}

impl EnumerationType {
    /// All enumerations, in the order of the model description.
    pub const ALL: [EnumerationType; 3] =
        [EnumerationType::Model, EnumerationType::InputReference, EnumerationType::ModeFamily];

    /// Name of the type.
    pub fn name(self) -> &'static str {
        match self {
            EnumerationType::Model => "Model",
            EnumerationType::InputReference => "InputReference",
            EnumerationType::ModeFamily => "ModeFamily",
        }
    }

    /// What the type is for.
    pub fn description(self) -> &'static str {
        match self {
            EnumerationType::Model => "Fidelity level of the equations of motion",
            EnumerationType::InputReference => "Meaning of the inputs of controls and thrusts",
            EnumerationType::ModeFamily => "Families of natural modes",
        }
    }

    /// Names and descriptions of the items; the value of the first is 1.
    pub fn items(self) -> &'static [(&'static str, &'static str)] {
        match self {
            EnumerationType::Model => &LEVELS,
            EnumerationType::InputReference => {
                &[("trim", "Inputs add to the trim values"), ("absolute", "Inputs replace the trim values")]
            }
            EnumerationType::ModeFamily => {
                &[("all", "Symmetric and antisymmetric modes"), ("symmetric", "Symmetric modes only")]
            }
        }
    }
}

/// Names and descriptions of the levels of fidelity.
const LEVELS: [(&str, &str); Fidelity::ALL.len()] = {
    let mut items = [("", ""); Fidelity::ALL.len()];
    let mut item = 0;
    while item < items.len() {
        items[item] = (Fidelity::ALL[item].name(), Fidelity::ALL[item].description());
        item += 1;
    }
    items
};

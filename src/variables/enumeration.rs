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
    /// [`GustShape`](crate::air::GustShape).
    GustShape,
    /// [`GustCriterion`](crate::air::GustCriterion).
    GustCriterion,
    /// [`Spectrum`](crate::air::Spectrum).
    TurbulenceSpectrum,
    /// [`TurbulenceComponents`](crate::air::TurbulenceComponents).
    TurbulenceComponents,
    /// [`ManoeuvreChoice`](crate::plant::ManoeuvreChoice).
    Manoeuvre,
    /// [`Lateral`](crate::plant::Lateral).
    Lateral,
}

impl EnumerationType {
    /// All enumerations, in the order of the model description.
    pub const ALL: [EnumerationType; 9] = [
        EnumerationType::Model,
        EnumerationType::InputReference,
        EnumerationType::ModeFamily,
        EnumerationType::GustShape,
        EnumerationType::GustCriterion,
        EnumerationType::TurbulenceSpectrum,
        EnumerationType::TurbulenceComponents,
        EnumerationType::Manoeuvre,
        EnumerationType::Lateral,
    ];

    /// Name of the type.
    pub fn name(self) -> &'static str {
        match self {
            EnumerationType::Model => "Model",
            EnumerationType::InputReference => "InputReference",
            EnumerationType::ModeFamily => "ModeFamily",
            EnumerationType::GustShape => "GustShape",
            EnumerationType::GustCriterion => "GustCriterion",
            EnumerationType::TurbulenceSpectrum => "TurbulenceSpectrum",
            EnumerationType::TurbulenceComponents => "TurbulenceComponents",
            EnumerationType::Manoeuvre => "Manoeuvre",
            EnumerationType::Lateral => "Lateral",
        }
    }

    /// What the type is for.
    pub fn description(self) -> &'static str {
        match self {
            EnumerationType::Model => "Fidelity level of the equations of motion",
            EnumerationType::InputReference => "Meaning of the inputs of controls and thrusts",
            EnumerationType::ModeFamily => "Families of natural modes",
            EnumerationType::GustShape => "Shape of a single gust",
            EnumerationType::GustCriterion => "What the peak of a single gust follows from",
            EnumerationType::TurbulenceSpectrum => "Spectrum of continuous turbulence",
            EnumerationType::TurbulenceComponents => "Components of the turbulence that blow",
            EnumerationType::Manoeuvre => "Flight that is trimmed at the start",
            EnumerationType::Lateral => "What is given of a straight flight",
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
            EnumerationType::GustShape => {
                &[("none", "No gust"), ("one_minus_cosine", "Half the peak times 1 - cos(pi s/gradient)")]
            }
            EnumerationType::GustCriterion => &[
                ("peak", "The parameter gust.peak"),
                ("cs25_vc", "CS 25.341(a) at the design cruising speed"),
                ("cs25_vd", "CS 25.341(a) at the design dive speed: half of it"),
            ],
            EnumerationType::TurbulenceSpectrum => &[
                ("none", "No turbulence"),
                ("dryden", "Dryden, as MIL-F-8785C"),
                ("von_karman", "Von Karman, as MIL-F-8785C and CS-25"),
            ],
            EnumerationType::TurbulenceComponents => &[
                ("all", "Along the track, to the right, and down"),
                ("vertical", "Down alone"),
                ("lateral", "To the right alone"),
            ],
            EnumerationType::Manoeuvre => &[
                ("straight", "A straight path"),
                ("turn", "A turn without lateral load factor"),
                ("pull_up", "A pull-up or push-over, for a moment"),
            ],
            EnumerationType::Lateral => {
                &[("sideslip", "condition.sideslip is given"), ("bank", "condition.bank_angle is given")]
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

//! Controls: what a pilot or a control law moves, by the names of the aircraft file.

use serde::{Deserialize, Serialize};

use super::limits::{Bound, Bounds};

/// An input that turns flaps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Control {
    /// Name of its input; of its outputs `surface.<name>` and, with a role, `trim.<name>`.
    pub name: String,
    /// What it is, for people, for example "Elevator deflection".
    pub description: String,
    /// What a positive angle does, in words, for example "nose-down".
    pub positive: String,
    /// Angles that trims should stay within, rad.
    pub limits: Bounds,
    /// What it holds in trims.
    pub role: Option<TrimRole>,
    /// How its gains pass to the mirror image of a component.
    pub mirroring: Mirroring,
}

/// How the gains of a control pass to the mirror image of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mirroring {
    /// Both sides turn alike: an elevator's.
    Same,
    /// With the other sign: ailerons'.
    Opposite,
    /// Each side has gains of its own.
    None,
}

impl Control {
    /// What users should know beside what it is and where it is positive: sides, role, limits.
    ///
    /// ```
    /// # use flexible_aircraft::Aircraft;
    /// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?;
    /// assert_eq!(jet.controls[2].facts(), ["acts alike on both sides"]);
    /// assert_eq!(jet.controls[0].facts()[1], "holds pitch in trim");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn facts(&self) -> Vec<String> {
        let sides = match self.mirroring {
            Mirroring::Same => "acts alike on both sides",
            Mirroring::Opposite => "acts with opposite signs on the two sides",
            Mirroring::None => "acts on each side by itself",
        };
        let role = self.role.map(|role| format!("holds {} in trim", role.word()));
        let facts = [Some(sides.to_owned()), role, self.limits_in_words()];
        facts.into_iter().flatten().collect()
    }

    /// Those that the aircraft file gives, or that a trim can exceed.
    fn limits_in_words(&self) -> Option<String> {
        let Bounds { minimum, maximum } = self.limits;
        let is_given = [minimum, maximum].iter().any(|end| matches!(end, Bound::Given(_)));
        // Degrees were read: their last digits are those of the way through radians.
        let degrees = |end: Bound| end.value().map(|angle| libm::round(angle.to_degrees() * 1e9) / 1e9);
        let range = match (degrees(minimum), degrees(maximum)) {
            (Some(low), Some(high)) => format!("{low} to {high} deg"),
            (Some(low), None) => format!("{low} deg and above"),
            (None, Some(high)) => format!("{high} deg and below"),
            (None, None) => return None,
        };
        let what = if is_given { "limits" } else { "the usual limits" };
        let text = || format!("has {what} of {range}, which change no flight");
        (is_given || self.role.is_some()).then(text)
    }
}

/// About which axis a control holds a trimmed aircraft; at most one of an aircraft has each role.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TrimRole {
    /// About y, in every flight: an elevator's.
    Pitch,
    /// About x, where the aircraft would roll: the ailerons'.
    Roll,
    /// About z, where the aircraft would yaw: a rudder's.
    Yaw,
}

impl TrimRole {
    /// All roles.
    pub const ALL: [TrimRole; 3] = [TrimRole::Pitch, TrimRole::Roll, TrimRole::Yaw];

    /// As aircraft files write it.
    pub const fn word(self) -> &'static str {
        match self {
            TrimRole::Pitch => "pitch",
            TrimRole::Roll => "roll",
            TrimRole::Yaw => "yaw",
        }
    }
}

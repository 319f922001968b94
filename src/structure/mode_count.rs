//! How many modes an aircraft is reduced to: the one rule for everybody who asks.

use super::{ModeFamily, StructureError};

/// How many modes an aircraft is to be reduced to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeCount {
    /// So many; where the structure has fewer that is an error, which says how many it has.
    Asked(usize),
    /// So many, or all where the structure has fewer: nobody asked for a number.
    Usual(usize),
}

/// Which modes are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// Those of all families together.
    All,
    /// Symmetric ones.
    Symmetric,
}

impl From<usize> for ModeCount {
    fn from(asked: usize) -> Self {
        ModeCount::Asked(asked)
    }
}

impl ModeCount {
    /// What was asked for, if anything was; else what is usual.
    pub fn asked_or_usual(asked: Option<usize>, usual: usize) -> Self {
        asked.map_or(ModeCount::Usual(usual), ModeCount::Asked)
    }

    /// How many of the lowest modes hold so many of a kind.
    ///
    /// # Errors
    /// When there are not so many, or no strain energy can hold them.
    pub(super) fn lowest(
        self,
        kind: ModeKind,
        families: impl Iterator<Item = ModeFamily> + Clone,
    ) -> Result<usize, StructureError> {
        if kind == ModeKind::Symmetric && families.clone().any(|family| family == ModeFamily::Unsymmetric) {
            return Err(StructureError::NoMirrorPlane);
        }
        let counted = families.enumerate().filter(|(_, family)| match kind {
            ModeKind::All => true,
            ModeKind::Symmetric => *family == ModeFamily::Symmetric,
        });
        let available = counted.clone().count();
        let wanted = match self {
            ModeCount::Asked(wanted) if wanted > available => {
                return Err(StructureError::TooFewModes { wanted, kind, available });
            }
            ModeCount::Asked(wanted) => wanted,
            ModeCount::Usual(usual) => usual.min(available),
        };
        let needed = counted.take(wanted).last().map_or(0, |(place, _)| place + 1);
        if needed > MOST_MODES {
            return Err(StructureError::TooManyModes { wanted: needed, most: MOST_MODES });
        }
        Ok(needed)
    }
}

impl std::fmt::Display for ModeKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ModeKind::All => "modes",
            ModeKind::Symmetric => "symmetric modes",
        })
    }
}

/// The most modes that a model can have: the quartic strain energy then has 9 million coefficients, which are 73 MB of
/// an FMU, and a flight with all of them needs ten times as much memory.
pub const MOST_MODES: usize = 120;

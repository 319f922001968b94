//! How many modes an aircraft is reduced to: the one rule for everybody who asks [theory: structure.mode-count].

use super::{ModeFamily, ModeKind, StructureError};

/// How many modes an aircraft is to be reduced to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeCount {
    /// So many; where the structure has fewer that is an error, which says how many it has.
    Asked(usize),
    /// So many, or all where the structure has fewer: nobody asked for a number.
    Usual(usize),
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
    /// When there are not so many.
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
        Ok(counted.take(wanted).last().map_or(0, |(place, _)| place + 1))
    }
}

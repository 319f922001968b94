//! Section loads as outputs, which nobody pays for who does not ask [theory: section-loads.summation].

use crate::equations::SectionLoads;

/// The loads at all cuts of an aircraft at one instant, if somebody asked for them.
#[derive(Clone, Debug, PartialEq)]
pub struct CutLoads {
    at_cuts: Vec<SectionLoads>,
    are_known: bool,
}

impl CutLoads {
    /// Unknown, at so many cuts.
    pub(super) fn unknown(cuts: usize) -> Self {
        CutLoads { at_cuts: vec![SectionLoads::default(); cuts], are_known: false }
    }

    /// One for each cut of the model; `None` where nobody asked for them.
    pub fn known(&self) -> Option<&[SectionLoads]> {
        self.are_known.then_some(&self.at_cuts)
    }

    /// Another instant has come.
    pub(super) fn forget(&mut self) {
        if self.are_known {
            self.at_cuts.fill(SectionLoads::default());
            self.are_known = false;
        }
    }

    /// Takes what is written there.
    pub(super) fn take(&mut self, write: impl FnOnce(&mut [SectionLoads])) {
        write(&mut self.at_cuts);
        self.are_known = true;
    }
}

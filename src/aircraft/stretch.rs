//! Stretches of a component, and the pieces of elements that their ends cut.

use super::model::Attachment;

/// A stretch of a component between two fractions of its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Stretch {
    /// Whether a piece that no end of the stretch cuts is part of it.
    pub(super) fn holds(&self, piece: &Piece) -> bool {
        self.from < piece.middle && piece.middle < self.to
    }
}

/// An element, or the part of one between two cuts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) element: usize,
    /// Where it begins and ends, as fractions of the element's length.
    pub(super) ends: [f64; 2],
    /// Its middle as a fraction of the component's length.
    pub(super) middle: f64,
}

impl Piece {
    /// The part of the element that it is: 1 for a whole one.
    pub(super) fn share(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The place at a fraction of its own length.
    pub(super) fn at(&self, fraction: f64) -> Attachment {
        Attachment { beam: self.element, fraction: self.ends[0] + fraction * self.share() }
    }
}

//! CONM1, CONM2.

use super::super::mistakes::Origin;
use super::reader::Reader;

/// A mass at a grid, in the deck's units.
#[derive(Clone, Debug)]
pub struct LumpCard {
    pub origin: Origin,
    pub grid: i64,
    pub frame: i64,
    pub content: LumpContent,
}

#[derive(Clone, Debug)]
pub enum LumpContent {
    /// Mass, place of its centre from the grid (or in the basic frame, where `frame` is −1), inertia about the centre:
    /// I11, I21, I22, I31, I32, I33, products as integrals, without the sign of the matrix.
    Body { mass: f64, place: [f64; 3], inertia: [f64; 6] },
    /// The lower half of a matrix about the grid, row by row.
    Matrix([f64; 21]),
}

pub fn conm2(card: &Reader) -> Option<LumpCard> {
    let id = card.id()?;
    let [grid, frame] = [card.integer(1, "G"), card.integer_or(2, "CID", 0)];
    let mass = card.real_or(3, "M", 0.0)?;
    let place = card.vector(4, ["X1", "X2", "X3"])?;
    let mut inertia = [0.0; 6];
    for (term, name) in ["I11", "I21", "I22", "I31", "I32", "I33"].into_iter().enumerate() {
        inertia[term] = card.real_or(8 + term, name, 0.0)?;
    }
    let content = LumpContent::Body { mass, place, inertia };
    Some(LumpCard { origin: card.origin("CONM2", id), grid: grid?, frame: frame?, content })
}

pub fn conm1(card: &Reader) -> Option<LumpCard> {
    let id = card.id()?;
    let [grid, frame] = [card.integer(1, "G"), card.integer_or(2, "CID", 0)];
    let mut terms = [0.0; 21];
    for (index, term) in terms.iter_mut().enumerate() {
        *term = card.real_or(3 + index, "M", 0.0)?;
    }
    let content = LumpContent::Matrix(terms);
    Some(LumpCard { origin: card.origin("CONM1", id), grid: grid?, frame: frame?, content })
}

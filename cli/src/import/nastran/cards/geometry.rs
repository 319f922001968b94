//! GRID, GRDSET, CORD1R, CORD2R, CORD2C.

use super::super::mistakes::Origin;
use super::reader::Reader;

/// A point as its card has it.
#[derive(Clone, Debug)]
pub struct Grid {
    pub origin: Origin,
    /// The frame of its place.
    pub place_frame: i64,
    pub place: [f64; 3],
    /// The frame of its displacements.
    pub displacement_frame: i64,
    /// Components that are held.
    pub held: String,
}

/// What GRDSET says of fields that GRID leaves blank.
#[derive(Clone, Debug, Default)]
pub struct GridDefaults {
    place_frame: i64,
    displacement_frame: i64,
    held: String,
}

/// A frame as its card has it.
#[derive(Clone, Debug)]
pub struct FrameCard {
    pub origin: Origin,
    pub shape: FrameShape,
    pub by: FrameBy,
}

/// What its numbers mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameShape {
    Rectangular,
    /// r, θ in degrees, z.
    Cylindrical,
}

/// Its origin, a point on its z axis, a point in its x–z plane.
#[derive(Clone, Debug)]
pub enum FrameBy {
    Grids([i64; 3]),
    Points { frame: i64, points: [[f64; 3]; 3] },
}

pub fn defaults(card: &Reader) -> Option<GridDefaults> {
    Some(GridDefaults {
        place_frame: card.integer_or(1, "CP", 0)?,
        displacement_frame: card.integer_or(5, "CD", 0)?,
        held: card.text(6).to_owned(),
    })
}

pub fn grid(card: &Reader, defaults: &GridDefaults) -> Option<Grid> {
    let id = card.id()?;
    let held = card.text(6);
    let [place_frame, displacement_frame] = [
        card.integer_or(1, "CP", defaults.place_frame),
        card.integer_or(5, "CD", defaults.displacement_frame),
    ];
    Some(Grid {
        origin: card.origin("GRID", id),
        place_frame: place_frame?,
        place: card.vector(2, ["X1", "X2", "X3"])?,
        displacement_frame: displacement_frame?,
        held: components(card, 6, "PS", if held.is_empty() { &defaults.held } else { held })?,
    })
}

/// Digits 1 to 6; 0 and blank are none.
pub fn components(card: &Reader, index: usize, name: &str, text: &str) -> Option<String> {
    if text.chars().all(|digit| ('0'..='6').contains(&digit)) {
        return Some(text.replace('0', ""));
    }
    card.wrong(index, name, format!("found {text}"), "digits from 1 to 6 are allowed")
}

/// One or two frames on grids.
pub fn by_grids(card: &Reader, found: &mut Vec<(i64, FrameCard)>) -> Option<()> {
    for first in [0, 4] {
        if first > 0 && card.is_blank(first) {
            continue;
        }
        let id = card.integer(first, "CID")?;
        let [a, b, c] = [1, 2, 3].map(|field| card.integer(first + field, ["G1", "G2", "G3"][field - 1]));
        let by = FrameBy::Grids([a?, b?, c?]);
        found.push((id, FrameCard { origin: card.origin("CORD1R", id), shape: FrameShape::Rectangular, by }));
    }
    Some(())
}

pub fn by_points(card: &Reader, (name, shape): (&'static str, FrameShape)) -> Option<(i64, FrameCard)> {
    let id = card.id()?;
    let frame = card.integer_or(1, "RID", 0);
    let points = [
        card.vector(2, ["A1", "A2", "A3"])?,
        card.vector(5, ["B1", "B2", "B3"])?,
        card.vector(8, ["C1", "C2", "C3"])?,
    ];
    Some((
        id,
        FrameCard { origin: card.origin(name, id), shape, by: FrameBy::Points { frame: frame?, points } },
    ))
}

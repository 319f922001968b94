//! CBAR, CBEAM, CROD.

use super::super::mistakes::{Field, Origin, Remarks};
use super::geometry::components;
use super::reader::Reader;

/// An element between two grids.
#[derive(Clone, Debug)]
pub struct Element {
    pub origin: Origin,
    pub kind: ElementKind,
    pub property: i64,
    pub grids: [i64; 2],
    /// None of rods.
    pub orientation: Option<Orientation>,
    pub offsets: [Offset; 2],
    /// What its ends do not hold.
    pub pins: [Option<Pin>; 2],
}

/// Components in which the end of an element is free, in its own axes, and the field that says so.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    pub free: [bool; 6],
    /// None of rods, whose ends are free in all rotations.
    pub field: Option<Field>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementKind {
    Bar,
    Beam,
    Rod,
}

/// Where plane 1 of an element lies.
#[derive(Clone, Debug)]
pub enum Orientation {
    /// A vector, in the displacement frame of the first grid or in the basic one.
    Vector { numbers: [f64; 3], is_basic: bool },
    /// Towards a grid from the first one.
    Grid(i64),
}

/// From a grid to the end of the element.
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    pub numbers: [f64; 3],
    /// In the element's own frame, not in the grid's.
    pub is_of_element: bool,
}

/// What BAROR or BEAMOR says of fields that CBAR or CBEAM leaves blank.
#[derive(Clone, Debug)]
pub struct BeamDefaults {
    property: Option<i64>,
    frames: [char; 3],
    orientation: Option<Orientation>,
}

impl Default for BeamDefaults {
    fn default() -> Self {
        BeamDefaults { property: None, frames: ['G'; 3], orientation: None }
    }
}

pub fn defaults(card: &Reader) -> Option<BeamDefaults> {
    let property = if card.is_blank(1) { None } else { Some(card.integer(1, "PID")?) };
    let frames = frames(card, ['G'; 3])?;
    let has_orientation = (4..7).any(|index| !card.is_blank(index));
    let orientation = if has_orientation { Some(orientation(card, frames[0] == 'B')?) } else { None };
    Some(BeamDefaults { property, frames, orientation })
}

pub fn bar_or_beam(
    card: &Reader,
    (name, kind): (&'static str, ElementKind),
    defaults: &BeamDefaults,
    remarks: &mut Remarks,
) -> Option<Element> {
    let id = card.id()?;
    let [property, one, other] = [
        card.integer_or(1, "PID", defaults.property.unwrap_or(id)),
        card.integer(2, "GA"),
        card.integer(3, "GB"),
    ];
    let frames = frames(card, defaults.frames)?;
    let offsets = [card.vector(10, ["W1A", "W2A", "W3A"])?, card.vector(13, ["W1B", "W2B", "W3B"])?];
    let grids = [one?, other?];
    if grids[0] == grids[1] {
        return card.wrong(3, "GB", format!("found {} at both ends", grids[0]), "two grids are allowed");
    }
    let is_basic = frames[0] == 'B';
    let usual = match &defaults.orientation {
        Some(Orientation::Vector { numbers, .. }) => {
            Some(Orientation::Vector { numbers: *numbers, is_basic })
        }
        usual => usual.clone(),
    };
    let usual = usual.filter(|_| (4..7).all(|index| card.is_blank(index)));
    let orientation = usual.or_else(|| orientation(card, is_basic))?;
    let pins = [pin(card, id, (8, "PA"))?, pin(card, id, (9, "PB"))?];
    if kind == ElementKind::Beam {
        for (index, name) in
            [(16, "SA"), (17, "SB")].into_iter().filter(|(index, _)| !matches!(card.text(*index), "" | "0"))
        {
            remarks.field((card.card, id), (index, name), "warping is not held");
        }
    }
    let offset = |end: usize| Offset { numbers: offsets[end], is_of_element: frames[end + 1] == 'O' };
    Some(Element {
        origin: card.origin(name, id),
        kind,
        property: property?,
        grids,
        orientation: Some(orientation),
        offsets: [offset(0), offset(1)],
        pins,
    })
}

fn pin(card: &Reader, id: i64, (index, name): (usize, &str)) -> Option<Option<Pin>> {
    let digits = components(card, index, name, card.text(index))?;
    if digits.is_empty() {
        return Some(None);
    }
    let free = ['1', '2', '3', '4', '5', '6'].map(|digit| digits.contains(digit));
    let field = Field::of((card.card, id), (index, name), digits);
    Some(Some(Pin { free, field: Some(field) }))
}

/// The letters of OFFT: of the orientation, of the offsets.
fn frames(card: &Reader, usual: [char; 3]) -> Option<[char; 3]> {
    let text = card.text(7).to_uppercase();
    // BIT of a CBEAM is a number and has to do with p-elements; in old decks 1 and 2 say that a vector or a grid stands before it.
    if matches!(text.as_str(), "" | "1" | "2") || text.contains('.') {
        return Some(usual);
    }
    let letters: Vec<char> = text.chars().collect();
    match letters.as_slice() {
        &[v @ ('G' | 'B'), a @ ('G' | 'O'), b @ ('G' | 'O')] => Some([v, a, b]),
        _ => card.wrong(
            7,
            "OFFT",
            format!("found {text}"),
            "GGG, GGO, GOG, GOO or the same with B in front is allowed",
        ),
    }
}

fn orientation(card: &Reader, is_basic: bool) -> Option<Orientation> {
    let first = card.text(4);
    let is_grid = card.is_blank(5) && card.is_blank(6) && !first.is_empty() && !first.contains('.');
    if is_grid {
        return Some(Orientation::Grid(card.integer(4, "G0")?));
    }
    let numbers = card.vector(4, ["X1", "X2", "X3"])?;
    if numbers == [0.0; 3] {
        return card.wrong(
            4,
            "X1",
            "found no direction",
            "a vector or a grid is needed that shows where plane 1 lies",
        );
    }
    Some(Orientation::Vector { numbers, is_basic })
}

pub fn rod(card: &Reader) -> Option<Element> {
    let id = card.id()?;
    let [property, one, other] =
        [card.integer_or(1, "PID", id), card.integer(2, "G1"), card.integer(3, "G2")];
    let grids = [one?, other?];
    if grids[0] == grids[1] {
        return card.wrong(3, "G2", format!("found {} at both ends", grids[0]), "two grids are allowed");
    }
    let rod_end = Some(Pin { free: [false, false, false, true, true, true], field: None });
    let none = Offset { numbers: [0.0; 3], is_of_element: false };
    Some(Element {
        origin: card.origin("CROD", id),
        kind: ElementKind::Rod,
        property: property?,
        grids,
        orientation: None,
        offsets: [none.clone(), none],
        pins: [rod_end.clone(), rod_end],
    })
}

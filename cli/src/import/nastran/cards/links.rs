//! RBE2, RBAR, RBE3, SPC1, SPC, CBUSH, PBUSH: what is rigid, what is held.

use super::super::deck;
use super::super::mistakes::{Origin, Remarks};
use super::geometry::components;
use super::reader::{Ids, Reader};

/// Grids that move as one body.
#[derive(Clone, Debug)]
pub struct Rigid {
    pub origin: Origin,
    pub grid: i64,
    pub others: Ids,
}

/// A grid that others carry in shares.
#[derive(Clone, Debug)]
pub struct Spread {
    pub origin: Origin,
    pub grid: i64,
    /// Grids with their weights.
    pub carriers: Vec<(i64, f64)>,
}

/// Components of grids that are held.
#[derive(Clone, Debug)]
pub struct Constraint {
    pub origin: Origin,
    pub set: i64,
    pub components: String,
    pub grids: Ids,
}

/// Springs between two grids, or between one and the ground.
#[derive(Clone, Debug)]
pub struct Bush {
    pub origin: Origin,
    pub property: i64,
    pub grids: [Option<i64>; 2],
    pub frame: Option<i64>,
}

/// Stiffnesses along and about three axes; none where nothing stands.
#[derive(Clone, Debug)]
pub struct BushProperty {
    pub stiffness: [f64; 6],
}

const ALL: &str = "123456";

fn is_all(components: &str) -> bool {
    ALL.chars().all(|digit| components.contains(digit))
}

pub fn rbe2(card: &Reader, remarks: &mut Remarks) -> Option<Rigid> {
    let id = card.id()?;
    let grid = card.integer(1, "GN");
    let held = components(card, 2, "CM", card.text(2))?;
    let others = card.ids(3, "GM")?;
    if !is_all(&held) {
        let said = format!("found {held}: links are held rigid in all six components");
        remarks.field((card.card, id), (2, "CM"), said);
    }
    Some(Rigid { origin: card.origin("RBE2", id), grid: grid?, others })
}

pub fn rbar(card: &Reader, remarks: &mut Remarks) -> Option<Rigid> {
    let id = card.id()?;
    let grid = card.integer(1, "GA");
    let other = card.integer(2, "GB");
    let ends = [card.text(3), card.text(4)];
    if !ends.iter().any(|end| is_all(end)) {
        let said = format!("found {} and {}: links are held rigid in all six components", ends[0], ends[1]);
        remarks.field((card.card, id), (3, "CNA"), said);
    }
    Some(Rigid { origin: card.origin("RBAR", id), grid: grid?, others: Ids::of(other?) })
}

pub fn rbe3(card: &Reader, remarks: &mut Remarks) -> Option<Spread> {
    let id = card.id()?;
    let grid = card.integer(2, "REFGRID")?;
    let mut carriers = Vec::new();
    let mut weight = 0.0;
    let mut index = 4;
    while index < card.card.len() {
        let text = card.text(index).to_uppercase();
        if text == "ALPHA" {
            break;
        }
        if text == "UM" {
            remarks.field((card.card, id), (index, "UM"), "other dependent components are not held");
            break;
        }
        if text.contains('.') {
            weight = card.not_negative(index, "WT", 1.0)?;
            // The components that follow it.
            index += 2;
            continue;
        }
        if !text.is_empty() {
            carriers.push((card.integer(index, "G")?, weight));
        }
        index += 1;
    }
    carriers.retain(|(_, weight)| *weight > 0.0);
    let [of_reference, of_carriers] =
        [components(card, 3, "REFC", card.text(3))?, components(card, 5, "C1", card.text(5))?];
    if carriers.len() == 1 && !(is_all(&of_reference) && is_all(&of_carriers)) {
        let said =
            format!("found {of_reference} of {of_carriers}: links are held rigid in all six components");
        remarks.field((card.card, id), (3, "REFC"), said);
    }
    if carriers.is_empty() {
        return card.wrong(
            4,
            "WT1",
            "found no grid with a weight",
            "a weight above 0, components and grids are needed",
        );
    }
    Some(Spread { origin: card.origin("RBE3", id), grid, carriers })
}

pub fn spc1(card: &Reader) -> Option<Constraint> {
    let set = card.integer(0, "SID")?;
    let components = components(card, 1, "C", card.text(1))?;
    let grids = card.ids(2, "G")?;
    Some(Constraint { origin: card.origin("SPC1", set), set, components, grids })
}

/// One or two grids, each with components.
pub fn spc(card: &Reader, found: &mut Vec<Constraint>) -> Option<()> {
    let set = card.integer(0, "SID")?;
    for first in [1, 4].into_iter().filter(|first| !card.is_blank(*first)) {
        let grids = Ids::of(card.integer(first, "G")?);
        let components = components(card, first + 1, "C", card.text(first + 1))?;
        found.push(Constraint { origin: card.origin("SPC", set), set, components, grids });
    }
    Some(())
}

pub fn cbush(card: &Reader) -> Option<Bush> {
    let id = card.id()?;
    let property = card.integer_or(1, "PID", id);
    let grid = |index: usize, name: &str| {
        if matches!(card.text(index), "" | "0") { Some(None) } else { card.integer(index, name).map(Some) }
    };
    let grids = [grid(2, "GA")?, grid(3, "GB")?];
    let frame = if card.is_blank(7) { None } else { Some(card.integer(7, "CID")?) };
    if grids == [None; 2] {
        return card.wrong(2, "GA", "found no grid", "a grid is needed");
    }
    Some(Bush { origin: card.origin("CBUSH", id), property: property?, grids, frame })
}

pub fn pbush(card: &Reader) -> Option<(i64, BushProperty)> {
    let id = card.id()?;
    let mut stiffness = [0.0; 6];
    for first in (1..card.card.len()).step_by(deck::DATA) {
        if card.text(first).eq_ignore_ascii_case("K") {
            for (axis, name) in ["K1", "K2", "K3", "K4", "K5", "K6"].into_iter().enumerate() {
                stiffness[axis] = match card.text(first + 1 + axis).to_uppercase().as_str() {
                    "RIGID" => f64::INFINITY,
                    _ => card.not_negative(first + 1 + axis, name, 0.0)?,
                };
            }
        }
    }
    Some((id, BushProperty { stiffness }))
}

//! AERO, AEROS, CAERO1, AEFACT, SPLINE1, SPLINE2, SPLINE4, SPLINE5, SET1, AESURF, AELIST, AELINK.

use std::f64::consts::FRAC_PI_2;

use super::super::mistakes::{Origin, Remarks};
use super::reader::{Ids, Reader};

/// Boxes of a panel along its span, and along its chord.
const MOST_BOXES: i64 = 300;

/// What AEROS says, and AERO of the airspeed.
#[derive(Clone, Debug, Default)]
pub struct Reference {
    /// The frame whose x points along the flow, with its card; none where neither card is there.
    pub frame: Option<(i64, Origin)>,
    pub chord: Option<f64>,
    pub span: Option<f64>,
    pub area: Option<f64>,
    pub airspeed: Option<f64>,
    /// The card that says that half of the aircraft is meant.
    pub half: Option<Origin>,
}

/// A panel as its card has it.
#[derive(Clone, Debug)]
pub struct PanelCard {
    pub origin: Origin,
    pub frame: i64,
    pub spanwise: Division,
    pub chordwise: Division,
    /// Its leading edge, inboard and outboard.
    pub corners: [[f64; 3]; 2],
    pub chords: [f64; 2],
}

/// How a panel is cut into boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Division {
    Equal(usize),
    /// By an AEFACT.
    List(i64),
}

/// Which grids carry which boxes.
#[derive(Clone, Debug)]
pub struct Spline {
    pub origin: Origin,
    pub panel: i64,
    pub boxes: SplineBoxes,
    pub set: i64,
}

/// Which boxes of its panel a spline moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineBoxes {
    /// Those of a rectangle from the first to the last of them, where the card names them.
    Corners([Option<i64>; 2]),
    /// Those of an AELIST.
    List(i64),
}

/// Numbers with the card that lists them.
#[derive(Clone, Debug)]
pub struct List {
    pub origin: Origin,
    pub ids: Ids,
}

/// A control surface.
#[derive(Clone, Debug)]
pub struct SurfaceCard {
    pub origin: Origin,
    pub label: String,
    /// Hinge frame and list of boxes.
    pub parts: Vec<(i64, i64)>,
    pub effectiveness: f64,
    /// Least and greatest angle, rad.
    pub limits: Option<[f64; 2]>,
}

/// A control surface that others turn: its angle and theirs, each by its coefficient, sum to zero.
#[derive(Clone, Debug)]
pub struct LinkCard {
    pub origin: Origin,
    pub dependent: String,
    pub others: Vec<(String, f64)>,
}

/// All of the air.
#[derive(Debug, Default)]
pub struct AeroCards {
    pub reference: Reference,
    pub panels: Vec<PanelCard>,
    pub fractions: std::collections::BTreeMap<i64, Vec<f64>>,
    pub splines: Vec<Spline>,
    pub sets: std::collections::BTreeMap<i64, List>,
    pub surfaces: Vec<SurfaceCard>,
    pub links: Vec<LinkCard>,
    pub boxes: std::collections::BTreeMap<i64, List>,
}

pub fn aero(card: &Reader, reference: &mut Reference, remarks: &mut Remarks) -> Option<()> {
    let origin = Origin { id: card.integer_or(0, "ACSID", 0)?, ..card.origin("AERO", 0) };
    reference.frame.get_or_insert((origin.id, origin));
    reference.airspeed = card.optional(1, "VELOCITY")?.filter(|airspeed| *airspeed > 0.0);
    symmetries(card, 4, (reference, remarks))
}

/// SYMXZ, and SYMXY behind it.
fn symmetries(
    card: &Reader,
    first: usize,
    (reference, remarks): (&mut Reference, &mut Remarks),
) -> Option<()> {
    let name = if first == 4 { "AERO" } else { "AEROS" };
    if card.integer_or(first, "SYMXZ", 0)? != 0 {
        reference.half.get_or_insert(card.origin(name, 0));
    }
    let ground = card.integer_or(first + 1, "SYMXY", 0)?;
    if ground != 0 {
        let said = format!("found {ground}: an image of the flow in the ground is not held");
        remarks.field((card.card, 0), (first + 1, "SYMXY"), said);
    }
    Some(())
}

pub fn aeros(card: &Reader, reference: &mut Reference, remarks: &mut Remarks) -> Option<()> {
    let origin = Origin { id: card.integer_or(0, "ACSID", 0)?, ..card.origin("AEROS", 0) };
    reference.frame = Some((origin.id, origin));
    reference.chord = Some(card.positive(2, "REFC")?);
    reference.span = Some(card.positive(3, "REFB")?);
    reference.area = Some(card.positive(4, "REFS")?);
    symmetries(card, 5, (reference, remarks))
}

pub fn panel(card: &Reader) -> Option<PanelCard> {
    let id = card.id()?;
    let frame = card.integer_or(2, "CP", 0);
    let spanwise = division(card, [(3, "NSPAN"), (5, "LSPAN")])?;
    let chordwise = division(card, [(4, "NCHORD"), (6, "LCHORD")])?;
    let inboard = card.vector(8, ["X1", "Y1", "Z1"])?;
    let root = card.not_negative(11, "X12", 0.0)?;
    let outboard = card.vector(12, ["X4", "Y4", "Z4"])?;
    let tip = card.not_negative(15, "X43", 0.0)?;
    if root + tip <= 0.0 {
        return card.wrong(
            11,
            "X12",
            "found chords of 0 at both ends",
            "a chord above 0 is needed at one of them",
        );
    }
    let chords = [root, tip];
    Some(PanelCard {
        origin: card.origin("CAERO1", id),
        frame: frame?,
        spanwise,
        chordwise,
        corners: [inboard, outboard],
        chords,
    })
}

/// Says of bodies beside panels that they are not held.
pub fn bodies(card: &Reader, remarks: &mut Remarks) {
    if let Some(index) = (1..card.card.len()).find(|index| !matches!(card.text(*index), "" | "0")) {
        let id = card.integer(0, "PID").unwrap_or(0);
        remarks.field((card.card, id), (index, "B1"), "bodies beside panels are not read");
    }
}

fn division(card: &Reader, [(number, name), (list, list_name)]: [(usize, &str); 2]) -> Option<Division> {
    let count = card.integer_or(number, name, 0)?;
    if count == 0 {
        let id = card.integer_or(list, list_name, 0)?;
        if id <= 0 {
            return card.wrong(
                number,
                name,
                "found no number of boxes and no list",
                format!("{name} or {list_name} is needed"),
            );
        }
        return Some(Division::List(id));
    }
    if (1..=MOST_BOXES).contains(&count) {
        return Some(Division::Equal(count as usize));
    }
    card.wrong(number, name, format!("found {count}"), format!("1 to {MOST_BOXES} is allowed"))
}

pub fn fractions(card: &Reader) -> Option<(i64, Vec<f64>)> {
    let id = card.id()?;
    let given = (1..card.card.len()).filter(|&index| !card.is_blank(index));
    let fractions: Vec<f64> = given.map(|index| card.real(index, "D")).collect::<Option<_>>()?;
    if fractions.len() as i64 > MOST_BOXES + 1 {
        return card.wrong(
            1,
            "D1",
            format!("found {} fractions", fractions.len()),
            format!("{} are allowed", MOST_BOXES + 1),
        );
    }
    Some((id, fractions))
}

pub fn spline(card: &Reader, name: &'static str) -> Option<Spline> {
    let id = card.id()?;
    let [panel, set] = [card.integer(1, "CAERO"), card.integer(4, "SETG")];
    let optional = |index: usize, name: &str| match card.is_blank(index) {
        true => Some(None),
        false => card.integer(index, name).map(Some),
    };
    let boxes = match name {
        "SPLINE4" | "SPLINE5" => SplineBoxes::List(card.integer(2, "AELIST")?),
        _ => SplineBoxes::Corners([optional(2, "BOX1")?, optional(3, "BOX2")?]),
    };
    Some(Spline { origin: card.origin(name, id), panel: panel?, boxes, set: set? })
}

pub fn list(card: &Reader, (name, field): (&'static str, &str)) -> Option<(i64, List)> {
    let id = card.id()?;
    Some((id, List { origin: card.origin(name, id), ids: card.ids(1, field)? }))
}

pub fn surface(card: &Reader, remarks: &mut Remarks) -> Option<SurfaceCard> {
    let id = card.id()?;
    let label = card.text(1).to_owned();
    if label.is_empty() {
        return card.wrong(1, "LABEL", "found nothing", "a name is needed");
    }
    let mut parts = vec![(card.integer(2, "CID1")?, card.integer(3, "ALID1")?)];
    // Editors write CID2 = 0 where there is no second list.
    if !matches!((card.text(4), card.text(5)), ("" | "0", "" | "0")) {
        parts.push((card.integer(4, "CID2")?, card.integer(5, "ALID2")?));
    }
    let effectiveness = card.real_or(6, "EFF", 1.0)?;
    if effectiveness <= 0.0 {
        return card.wrong(6, "EFF", format!("found {effectiveness}"), "a number above 0 is allowed");
    }
    if card.text(7).eq_ignore_ascii_case("NOLDW") {
        let said = "found NOLDW: its lift is that of a flap of a thin aerofoil all the same";
        remarks.field((card.card, id), (7, "LDW"), said);
    }
    let limits = limits(card, id, remarks)?;
    for (index, name) in [(12, "HMLLIM"), (13, "HMULIM"), (14, "TQLLIM"), (15, "TQULIM")] {
        if !card.is_blank(index) {
            remarks.field((card.card, id), (index, name), "hinge moments are not limited here");
        }
    }
    Some(SurfaceCard { origin: card.origin("AESURF", id), label, parts, effectiveness, limits })
}

pub fn link(card: &Reader) -> Option<LinkCard> {
    // That of a trim, or ALWAYS.
    let id = if card.text(0).eq_ignore_ascii_case("ALWAYS") { 0 } else { card.integer_or(0, "ID", 0)? };
    let label = |index: usize, name: &str| match card.text(index) {
        "" => card.wrong(index, name, "found nothing", "the LABEL of an AESURF is needed"),
        label => Some(label.to_owned()),
    };
    let dependent = label(1, "LABLD")?;
    let mut others = Vec::new();
    for (number, index) in (2..card.card.len().max(3)).step_by(2).enumerate() {
        let other = label(index, &format!("LABL{}", number + 1))?;
        others.push((other, card.real(index + 1, &format!("C{}", number + 1))?));
    }
    Some(LinkCard { origin: card.origin("AELINK", id), dependent, others })
}

/// Least and greatest angle: one that is not given is a right angle, as in Nastran, and more than that no flap turns here.
fn limits(card: &Reader, id: i64, remarks: &mut Remarks) -> Option<Option<[f64; 2]>> {
    let given = [card.optional(10, "PLLIM")?, card.optional(11, "PULIM")?];
    if given == [None, None] {
        return Some(None);
    }
    let [low, high] = [given[0].unwrap_or(-FRAC_PI_2), given[1].unwrap_or(FRAC_PI_2)];
    let held = [low.max(-FRAC_PI_2), high.min(FRAC_PI_2)];
    if low > high {
        let allowed = "a least angle below the greatest is allowed, rad";
        return card.wrong(10, "PLLIM", format!("found {low} to {high} rad"), allowed);
    }
    if low == high || held[0] > 0.0 || held[1] < 0.0 {
        let why = if low == high { "which let it turn nowhere" } else { "between which 0 is not" };
        let said = format!("found limits from {low} to {high} rad, {why}: they are not held");
        remarks.field((card.card, id), (10, "PLLIM"), said);
        return Some(None);
    }
    if held != [low, high] {
        remarks.note(format!(
            "AESURF {id}: its limits, {low} to {high} rad, are held as {:.3} to {:.3} deg: flaps turn up to 90 deg here",
            held[0].to_degrees(),
            held[1].to_degrees()
        ));
    }
    Some(Some(held))
}

//! PBAR, PBARL, PBEAM, PBEAML, PROD, MAT1.

use super::super::mistakes::{Origin, Remarks};
use super::super::sections::{Section, Shape};
use super::reader::Reader;

/// I12² is less than I1 I2 by this share at least.
const DEFINITE: f64 = 1e-9;

/// A property of elements, in the deck's units.
#[derive(Clone, Debug)]
pub struct Property {
    pub origin: Origin,
    pub material: i64,
    pub section: Section,
    /// Per length.
    pub other_mass: f64,
    /// Of what is not structure, about its own centre, per length.
    pub other_inertia: f64,
    /// (y, z) of the neutral axis and of other mass from the shear centre, which is on the element's axis.
    pub neutral_axis: [f64; 2],
    pub other_mass_centre: [f64; 2],
}

/// Isotropic and elastic.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Young's modulus and shear modulus.
    pub young: f64,
    pub shear: f64,
    pub density: f64,
}

pub fn pbar(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let section = Section {
        area: card.not_negative(2, "A", 0.0)?,
        i1: card.not_negative(3, "I1", 0.0)?,
        i2: card.not_negative(4, "I2", 0.0)?,
        torsion: card.not_negative(5, "J", 0.0)?,
        i12: card.real_or(18, "I12", 0.0)?,
    };
    positive_definite(card, 18, &section)?;
    let other_mass = card.not_negative(6, "NSM", 0.0)?;
    shear_areas(card, id, 16, remarks)?;
    Some(Property {
        origin: card.origin("PBAR", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
        neutral_axis: [0.0; 2],
        other_mass_centre: [0.0; 2],
    })
}

/// Some energy for every bending.
fn positive_definite(card: &Reader, index: usize, section: &Section) -> Option<()> {
    let Section { i1, i2, i12, .. } = *section;
    if i12 == 0.0 || i12 * i12 < (1.0 - DEFINITE) * i1 * i2 {
        return Some(());
    }
    let allowed = format!("less than the root of I1 times I2, {:.6e}, is allowed", libm::sqrt(i1 * i2));
    card.wrong(index, "I12", format!("found {i12}"), allowed)
}

/// Says of shear areas that they are not held.
fn shear_areas(card: &Reader, id: i64, first: usize, remarks: &mut Remarks) -> Option<()> {
    for (index, name) in [(first, "K1"), (first + 1, "K2")] {
        let factor = card.real_or(index, name, 0.0)?;
        if factor != 0.0 {
            let said = format!("found {factor}: flexibility in shear is not held, beams are slender here");
            remarks.field((card.card, id), (index, name), said);
        }
    }
    Some(())
}

pub fn prod(card: &Reader) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let section = Section {
        area: card.not_negative(2, "A", 0.0)?,
        torsion: card.not_negative(3, "J", 0.0)?,
        ..Section::default()
    };
    let other_mass = card.not_negative(5, "NSM", 0.0)?;
    Some(Property {
        origin: card.origin("PROD", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
        neutral_axis: [0.0; 2],
        other_mass_centre: [0.0; 2],
    })
}

fn shape(card: &Reader) -> Option<Shape> {
    let name = card.text(3).to_uppercase();
    Shape::named(&name)
        .or_else(|| card.wrong(3, "TYPE", format!("found {name}"), format!("{} is allowed", Shape::NAMES)))
}

/// The section whose dimensions begin at a field.
fn shaped(
    card: &Reader,
    shape: Shape,
    first: usize,
    otherwise: Option<&[f64]>,
) -> Option<(Section, Vec<f64>)> {
    let mut dimensions = Vec::with_capacity(shape.dimensions());
    for number in 0..shape.dimensions() {
        let (index, name) = (first + number, format!("DIM{}", number + 1));
        dimensions.push(match otherwise {
            Some(otherwise) => card.real_or(index, &name, otherwise[number])?,
            None => card.real(index, &name)?,
        });
    }
    match shape.section(&dimensions) {
        Ok(section) => Some((section, dimensions)),
        Err(bad) => {
            let (index, name) = (first + bad.index, format!("DIM{}", bad.index + 1));
            card.wrong(index, &name, format!("found {}", dimensions[bad.index]), bad.allowed)
        }
    }
}

pub fn pbarl(card: &Reader) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let shape = shape(card)?;
    let (section, _) = shaped(card, shape, 8, None)?;
    let other_mass = card.not_negative(8 + shape.dimensions(), "NSM", 0.0)?;
    Some(Property {
        origin: card.origin("PBARL", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
        neutral_axis: [0.0; 2],
        other_mass_centre: [0.0; 2],
    })
}

/// A station of a beam: where it is, from 0 to 1, its section and other mass per length.
#[derive(Clone, Copy)]
struct Station {
    at: f64,
    section: Section,
    other_mass: f64,
}

/// On the line from one station at 0 to another one at 1.
fn between(from: &Station, to: &Station, at: f64) -> Station {
    Station {
        at,
        section: Section::mean(&[(from.section, 1.0 - at), (to.section, at)]),
        other_mass: from.other_mass + at * (to.other_mass - from.other_mass),
    }
}

/// The mean along the beam of what is linear between stations.
fn mean(card: &Reader, id: i64, mut stations: Vec<Station>, remarks: &mut Remarks) -> (Section, f64) {
    stations.sort_by(|one, other| one.at.total_cmp(&other.at));
    let [last, first] = [stations.len() - 1, 0];
    if stations.len() == 1 {
        return (stations[0].section, stations[0].other_mass);
    }
    let weight = |place: usize| {
        let before = if place > first { stations[place].at - stations[place - 1].at } else { stations[0].at };
        let after =
            if place < last { stations[place + 1].at - stations[place].at } else { 1.0 - stations[last].at };
        let share = |gap: f64, is_end: bool| if is_end { gap } else { 0.5 * gap };
        share(before, place == first) + share(after, place == last)
    };
    let weights: Vec<f64> = (0..stations.len()).map(weight).collect();
    let sections: Vec<(Section, f64)> =
        stations.iter().map(|station| station.section).zip(weights.iter().copied()).collect();
    let mass = stations.iter().zip(&weights).map(|(station, weight)| weight * station.other_mass).sum();
    if stations.iter().any(|station| station.section != stations[0].section) {
        let said = "the section changes along the element: its mean is held, elements are uniform here";
        remarks.field((card.card, id), (0, "PID"), said);
    }
    (Section::mean(&sections), mass)
}

fn place(card: &Reader, index: usize) -> Option<f64> {
    let at = card.real_or(index, "X/XB", 1.0)?;
    if (0.0..=1.0).contains(&at) {
        Some(at)
    } else {
        card.wrong(index, "X/XB", format!("found {at}"), "0 to 1 is allowed")
    }
}

pub fn pbeaml(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let shape = shape(card)?;
    let count = shape.dimensions();
    let (section, dimensions) = shaped(card, shape, 8, None)?;
    let other_mass = card.not_negative(8 + count, "NSM", 0.0)?;
    let mut stations = vec![Station { at: 0.0, section, other_mass }];
    let mut first = 8 + count + 1;
    while first < card.card.len() {
        let at = place(card, first + 1)?;
        let (section, _) = shaped(card, shape, first + 2, Some(&dimensions))?;
        let other_mass = card.not_negative(first + 2 + count, "NSM", other_mass)?;
        stations.push(Station { at, section, other_mass });
        first += count + 3;
    }
    if !shape.is_doubly_symmetric() {
        let said = "its shear centre may be apart from its centroid: both are held on the grid line";
        remarks.field((card.card, id), (3, "TYPE"), said);
    }
    let (section, other_mass) = mean(card, id, stations, remarks);
    Some(Property {
        origin: card.origin("PBEAML", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
        neutral_axis: [0.0; 2],
        other_mass_centre: [0.0; 2],
    })
}

pub fn pbeam(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let root = beam_station(card, 2, None)?;
    let mut stations = vec![Station { at: 0.0, ..root }];
    let is_station =
        |line: usize| matches!(card.text(8 * line).to_uppercase().as_str(), "YES" | "YESA" | "NO");
    // Stresses of end A stand on the second line, unless it is a station.
    let mut line = if is_station(1) { 1 } else { 2 };
    let mut lines = Vec::new();
    while is_station(line) {
        lines.push((place(card, 8 * line + 1)?, 8 * line + 2));
        let has_stresses = card.text(8 * line).eq_ignore_ascii_case("YES");
        line += if has_stresses { 2 } else { 1 };
    }
    // End B first: what is blank between the ends is on the line from A to B.
    lines.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    for (at, field) in lines {
        let otherwise = match stations.get(1).filter(|end| end.at == 1.0) {
            Some(end) => between(&stations[0], end, at),
            None => Station { at, ..stations[0] },
        };
        let station = beam_station(card, field, Some(&otherwise))?;
        stations.push(Station { at, ..station });
    }
    let first = 8 * line;
    let other_inertia = beam_rest(card, id, first, remarks)?;
    let other_mass_centre = apart(card, id, (first + 8, ["M1", "M2"]), remarks)?;
    let neutral_axis = apart(card, id, (first + 12, ["N1", "N2"]), remarks)?;
    let (section, other_mass) = mean(card, id, stations, remarks);
    Some(Property {
        origin: card.origin("PBEAM", id),
        material: material?,
        section,
        other_mass,
        other_inertia,
        neutral_axis,
        other_mass_centre,
    })
}

/// Six numbers from a field on; where nothing stands, those of another station.
fn beam_station(card: &Reader, first: usize, otherwise: Option<&Station>) -> Option<Station> {
    let root = otherwise.map_or(Section::default(), |station| station.section);
    let mass = otherwise.map_or(0.0, |station| station.other_mass);
    let section = Section {
        area: card.not_negative(first, "A", root.area)?,
        i1: card.not_negative(first + 1, "I1", root.i1)?,
        i2: card.not_negative(first + 2, "I2", root.i2)?,
        i12: card.real_or(first + 3, "I12", root.i12)?,
        torsion: card.not_negative(first + 4, "J", root.torsion)?,
    };
    positive_definite(card, first + 3, &section)?;
    Some(Station { at: 1.0, section, other_mass: card.not_negative(first + 5, "NSM", mass)? })
}

/// A place from the shear centre at both ends; the mean of the two, of which end B has that of end A where nothing stands.
fn apart(
    card: &Reader,
    id: i64,
    (first, names): (usize, [&str; 2]),
    remarks: &mut Remarks,
) -> Option<[f64; 2]> {
    let mut place = [0.0; 2];
    for (axis, name) in names.into_iter().enumerate() {
        let at_a = card.real_or(first + axis, &format!("{name}(A)"), 0.0)?;
        let name = format!("{name}(B)");
        let at_b = card.real_or(first + 2 + axis, &name, at_a)?;
        if at_a != at_b {
            let said =
                format!("found {at_b}, and {at_a} at end A: the mean is held, elements are uniform here");
            remarks.field((card.card, id), (first + 2 + axis, &name), said);
        }
        place[axis] = 0.5 * (at_a + at_b);
    }
    Some(place)
}

/// The last two lines: what is not held of them is said; the inertia per length is.
fn beam_rest(card: &Reader, id: i64, first: usize, remarks: &mut Remarks) -> Option<f64> {
    shear_areas(card, id, first, remarks)?;
    if card.is_blank(first) && card.is_blank(first + 1) {
        remarks.note(format!("PBEAM {id}: K1 and K2 are blank, for which Nastran takes 1; beams have no flexibility in shear here"));
    }
    let at_a = card.not_negative(first + 4, "NSI(A)", 0.0)?;
    let at_b = card.not_negative(first + 5, "NSI(B)", at_a)?;
    let unheld = [
        (2, "S1", "shear relief of taper"),
        (3, "S2", "shear relief of taper"),
        (6, "CW(A)", "warping"),
        (7, "CW(B)", "warping"),
    ];
    for (offset, name, what) in unheld {
        let number = card.real_or(first + offset, name, 0.0)?;
        if number != 0.0 {
            remarks.field(
                (card.card, id),
                (first + offset, name),
                format!("found {number}: {what} is not held"),
            );
        }
    }
    Some(0.5 * (at_a + at_b))
}

pub fn mat1(card: &Reader, remarks: &mut Remarks) -> Option<(i64, Material)> {
    let id = card.id()?;
    let damping = card.real_or(7, "GE", 0.0)?;
    if damping != 0.0 {
        let said = format!(
            "found {damping}: damping of materials is not held; the parameter structural_damping is one ratio for all modes"
        );
        remarks.field((card.card, id), (7, "GE"), said);
    }
    let [young, shear, ratio] = [card.optional(1, "E")?, card.optional(2, "G")?, card.optional(3, "NU")?];
    if ratio.is_none() && (young.is_none() || shear.is_none()) {
        remarks.note(format!(
            "MAT1 {id} has one modulus and no NU: the other one is that of NU = 0 here, and 0 in Nastran"
        ));
    }
    let (young, shear) = match (young, shear, ratio) {
        (Some(young), Some(shear), _) => (young, shear),
        (Some(young), None, ratio) => (young, 0.5 * young / (1.0 + ratio.unwrap_or(0.0))),
        (None, Some(shear), ratio) => (2.0 * shear * (1.0 + ratio.unwrap_or(0.0)), shear),
        (None, None, _) => return card.wrong(1, "E", "found neither E nor G", "one of them is needed"),
    };
    for (index, name, modulus) in [(1, "E", young), (2, "G", shear)] {
        if !(modulus > 0.0 && modulus.is_finite()) {
            return card.wrong(
                index,
                name,
                format!("found a modulus of {modulus}"),
                "a modulus above 0 is allowed",
            );
        }
    }
    Some((id, Material { young, shear, density: card.not_negative(4, "RHO", 0.0)? }))
}

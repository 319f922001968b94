//! PBAR, PBARL, PBEAM, PBEAML, PROD, MAT1.

use super::super::mistakes::{Origin, Remarks};
use super::super::sections::{Section, Shape};
use super::reader::Reader;

/// A property of elements, in the deck's units.
#[derive(Clone, Debug)]
pub struct Property {
    pub origin: Origin,
    pub material: i64,
    pub section: Section,
    /// Per length.
    pub other_mass: f64,
    /// Of what is not structure, about the beam's axis, per length.
    pub other_inertia: f64,
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
    let other_mass = card.not_negative(6, "NSM", 0.0)?;
    shear_areas(card, id, 16, remarks)?;
    Some(Property {
        origin: card.origin("PBAR", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
    })
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
    })
}

fn shape(card: &Reader) -> Option<Shape> {
    let name = card.text(3).to_uppercase();
    Shape::named(&name)
        .or_else(|| card.wrong(3, "TYPE", format!("found {name}"), format!("{} is allowed", Shape::NAMES)))
}

/// What is said once of shapes.
const NO_SHEAR: &str = "PBARL and PBEAML: Nastran finds factors of shear from their shapes; beams have no flexibility in shear here";

/// The section whose dimensions begin at a field.
fn shaped(card: &Reader, shape: Shape, first: usize) -> Option<Section> {
    let dimension = |number: usize| card.real(first + number, &format!("DIM{}", number + 1));
    let dimensions: Vec<f64> = (0..shape.dimensions()).map(dimension).collect::<Option<_>>()?;
    of_dimensions(card, (shape, &dimensions), first)
}

fn of_dimensions(card: &Reader, (shape, dimensions): (Shape, &[f64]), first: usize) -> Option<Section> {
    shape.section(dimensions).map_or_else(
        |bad| {
            let (index, name) = (first + bad.index, format!("DIM{}", bad.index + 1));
            card.wrong(index, &name, format!("found {}", dimensions[bad.index]), bad.allowed)
        },
        Some,
    )
}

pub fn pbarl(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let shape = shape(card)?;
    let section = shaped(card, shape, 8)?;
    remarks.note(NO_SHEAR);
    let other_mass = card.not_negative(8 + shape.dimensions(), "NSM", 0.0)?;
    Some(Property {
        origin: card.origin("PBARL", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
    })
}

/// What a station of a beam has, each where it is given.
struct Station {
    /// From 0 to 1.
    at: f64,
    given: Vec<Option<f64>>,
}

/// The numbers of all stations, from end A to end B: what is blank at B is that of A, between them it is on the line from A to B.
fn filled(mut stations: Vec<Station>) -> Vec<(f64, Vec<f64>)> {
    stations.sort_by(|one, other| one.at.total_cmp(&other.at));
    let at_a: Vec<f64> = stations[0].given.iter().map(|number| number.unwrap_or(0.0)).collect();
    if stations[stations.len() - 1].at < 1.0 {
        stations.push(Station { at: 1.0, given: vec![None; at_a.len()] });
    }
    let of_b = &stations[stations.len() - 1].given;
    let at_b: Vec<f64> = std::iter::zip(of_b, &at_a).map(|(given, at_a)| given.unwrap_or(*at_a)).collect();
    let numbers = |station: &Station| {
        let line = std::iter::zip(&at_a, &at_b).map(|(a, b)| a + station.at * (b - a));
        std::iter::zip(&station.given, line).map(|(given, line)| given.unwrap_or(line)).collect()
    };
    stations.iter().map(|station| (station.at, numbers(station))).collect()
}

/// The mean along the beam of what is straight between stations: the sum of ½ (f of one + f of the next) times the way between them.
fn mean(
    (card, id): (&Reader, i64),
    stations: &[(f64, Section, f64)],
    remarks: &mut Remarks,
) -> (Section, f64) {
    let mut weights = vec![0.0; stations.len()];
    for place in 1..stations.len() {
        let half = 0.5 * (stations[place].0 - stations[place - 1].0);
        weights[place - 1] += half;
        weights[place] += half;
    }
    if stations.iter().any(|(_, section, _)| *section != stations[0].1) {
        let said = "the section changes along the element: its mean is held, elements are uniform here";
        remarks.field((card.card, id), (0, "PID"), said);
    }
    let sections: Vec<(Section, f64)> =
        std::iter::zip(stations, &weights).map(|((_, section, _), weight)| (*section, *weight)).collect();
    let mass = std::iter::zip(stations, &weights).map(|((_, _, mass), weight)| weight * mass).sum();
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
    shaped(card, shape, 8)?;
    let station = |at: f64, first: usize| {
        let dimension = |number: usize| card.optional(first + number, &format!("DIM{}", number + 1));
        let mut given = (0..count).map(dimension).collect::<Option<Vec<_>>>()?;
        card.not_negative(first + count, "NSM", 0.0)?;
        given.push(card.optional(first + count, "NSM")?);
        Some(Station { at, given })
    };
    let mut stations = vec![station(0.0, 8)?];
    let mut first = 8 + count + 1;
    while first < card.card.len() {
        stations.push(station(place(card, first + 1)?, first + 2)?);
        first += count + 3;
    }
    if !shape.is_doubly_symmetric() {
        let said = "its shear centre may be apart from its centroid: both are held on the grid line";
        remarks.field((card.card, id), (3, "TYPE"), said);
    }
    let mut sections = Vec::new();
    for (at, numbers) in filled(stations) {
        let section = of_dimensions(card, (shape, &numbers[..count]), 8)?;
        sections.push((at, section, numbers[count]));
    }
    remarks.note(NO_SHEAR);
    let (section, other_mass) = mean((card, id), &sections, remarks);
    Some(Property {
        origin: card.origin("PBEAML", id),
        material: material?,
        section,
        other_mass,
        other_inertia: 0.0,
    })
}

pub fn pbeam(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let mut stations = vec![beam_station(card, 2, 0.0)?];
    let is_station =
        |line: usize| matches!(card.text(8 * line).to_uppercase().as_str(), "YES" | "YESA" | "NO");
    // Stresses of end A stand on the second line, unless it is a station.
    let mut line = if is_station(1) { 1 } else { 2 };
    while is_station(line) {
        stations.push(beam_station(card, 8 * line + 2, place(card, 8 * line + 1)?)?);
        let has_stresses = card.text(8 * line).eq_ignore_ascii_case("YES");
        line += if has_stresses { 2 } else { 1 };
    }
    let other_inertia = beam_rest(card, id, 8 * line, remarks)?;
    let section = |numbers: &[f64]| Section {
        area: numbers[0],
        i1: numbers[1],
        i2: numbers[2],
        i12: numbers[3],
        torsion: numbers[4],
    };
    let stations: Vec<(f64, Section, f64)> =
        filled(stations).iter().map(|(at, numbers)| (*at, section(numbers), numbers[5])).collect();
    let (section, other_mass) = mean((card, id), &stations, remarks);
    Some(Property {
        origin: card.origin("PBEAM", id),
        material: material?,
        section,
        other_mass,
        other_inertia,
    })
}

/// Six numbers from a field on: area, I1, I2, I12, J, other mass.
fn beam_station(card: &Reader, first: usize, at: f64) -> Option<Station> {
    let mut given = Vec::with_capacity(6);
    for (number, name) in ["A", "I1", "I2", "I12", "J", "NSM"].into_iter().enumerate() {
        if name != "I12" {
            card.not_negative(first + number, name, 0.0)?;
        }
        given.push(card.optional(first + number, name)?);
    }
    Some(Station { at, given })
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
        (8, "M1(A)", "other mass apart from the axis"),
        (9, "M2(A)", "other mass apart from the axis"),
        (10, "M1(B)", "other mass apart from the axis"),
        (11, "M2(B)", "other mass apart from the axis"),
        (12, "N1(A)", "a neutral axis apart from the shear centre"),
        (13, "N2(A)", "a neutral axis apart from the shear centre"),
        (14, "N1(B)", "a neutral axis apart from the shear centre"),
        (15, "N2(B)", "a neutral axis apart from the shear centre"),
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
            "found {damping}: damping of materials is not held; the parameter structural_damping is one for all"
        );
        remarks.field((card.card, id), (7, "GE"), said);
    }
    let [young, shear, ratio] = [card.optional(1, "E")?, card.optional(2, "G")?, card.optional(3, "NU")?];
    if ratio.is_none() && (young.is_none() || shear.is_none()) {
        remarks.note(format!(
            "MAT1 {id} has one modulus and no NU: the other one is that of NU = 0 here; in Nastran it is 0"
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

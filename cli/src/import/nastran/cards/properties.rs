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

impl Property {
    /// All on the element's axis.
    fn new(origin: Origin, material: i64, section: Section, other_mass: f64) -> Self {
        Property {
            origin,
            material,
            section,
            other_mass,
            other_inertia: 0.0,
            neutral_axis: [0.0; 2],
            other_mass_centre: [0.0; 2],
        }
    }
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
    Some(Property::new(card.origin("PBAR", id), material?, section, other_mass))
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
    Some(Property::new(card.origin("PROD", id), material?, section, other_mass))
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
    Some(Property::new(card.origin("PBARL", id), material?, section, other_mass))
}

/// A station of a beam.
struct Station<Number> {
    /// From 0 to 1.
    at: f64,
    /// The field of its first number.
    first: usize,
    numbers: Vec<Number>,
}

/// The numbers of all stations, from end A to end B: what is blank at B is that of A, between them it is on the line from A to B.
fn filled(mut stations: Vec<Station<Option<f64>>>) -> Vec<Station<f64>> {
    stations.sort_by(|one, other| one.at.total_cmp(&other.at));
    let at_a: Vec<f64> = stations[0].numbers.iter().map(|number| number.unwrap_or(0.0)).collect();
    if stations[stations.len() - 1].at < 1.0 {
        stations.push(Station { at: 1.0, first: stations[0].first, numbers: vec![None; at_a.len()] });
    }
    let of_b = &stations[stations.len() - 1].numbers;
    let at_b: Vec<f64> = std::iter::zip(of_b, &at_a).map(|(given, at_a)| given.unwrap_or(*at_a)).collect();
    let numbers = |Station { at, first, numbers }: &Station<Option<f64>>| {
        let line = std::iter::zip(&at_a, &at_b).map(|(a, b)| a + at * (b - a));
        let numbers = std::iter::zip(numbers, line).map(|(given, line)| given.unwrap_or(line)).collect();
        Station { at: *at, first: *first, numbers }
    };
    stations.iter().map(numbers).collect()
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
    let changes = [
        ("the section", stations.iter().any(|(_, section, _)| *section != stations[0].1)),
        ("other mass (NSM)", stations.iter().any(|(.., mass)| *mass != stations[0].2)),
    ];
    for (what, _) in changes.into_iter().filter(|(_, changes)| *changes) {
        let said = format!("{what} changes along the element: its mean is held, elements are uniform here");
        remarks.field((card.card, id), (0, "PID"), said);
    }
    let sections: Vec<(Section, f64)> =
        std::iter::zip(stations, &weights).map(|((_, section, _), weight)| (*section, *weight)).collect();
    let mass = std::iter::zip(stations, &weights).map(|((_, _, mass), weight)| weight * mass).sum();
    (Section::mean(&sections), mass)
}

/// Where a station is, from 0 to 1, where no other one is.
fn another_place(card: &Reader, index: usize, others: &[Station<Option<f64>>]) -> Option<f64> {
    let at = card.real_or(index, "X/XB", 1.0)?;
    if !(0.0..=1.0).contains(&at) {
        return card.wrong(index, "X/XB", format!("found {at}"), "0 to 1 is allowed");
    }
    if others.iter().any(|other| other.at == at) {
        let allowed = "a place is allowed where no other station is, above 0";
        return card.wrong(index, "X/XB", format!("found {at} a second time"), allowed);
    }
    Some(at)
}

pub fn pbeaml(card: &Reader, remarks: &mut Remarks) -> Option<Property> {
    let id = card.id()?;
    let material = card.integer(1, "MID");
    let shape = shape(card)?;
    let count = shape.dimensions();
    shaped(card, shape, 8)?;
    let station = |at: f64, first: usize| {
        let dimension = |number: usize| card.optional(first + number, &format!("DIM{}", number + 1));
        let mut numbers = (0..count).map(dimension).collect::<Option<Vec<_>>>()?;
        card.not_negative(first + count, "NSM", 0.0)?;
        numbers.push(card.optional(first + count, "NSM")?);
        Some(Station { at, first, numbers })
    };
    let mut stations = vec![station(0.0, 8)?];
    let mut first = 8 + count + 1;
    while first < card.card.len() {
        let at = another_place(card, first + 1, &stations)?;
        stations.push(station(at, first + 2)?);
        first += count + 3;
    }
    if !shape.is_doubly_symmetric() {
        let said = "its shear centre may be apart from its centroid: both are held on the grid line";
        remarks.field((card.card, id), (3, "TYPE"), said);
    }
    let mut sections = Vec::new();
    for Station { at, first, numbers } in filled(stations) {
        let section = of_dimensions(card, (shape, &numbers[..count]), first)?;
        sections.push((at, section, numbers[count]));
    }
    remarks.note(NO_SHEAR);
    let (section, other_mass) = mean((card, id), &sections, remarks);
    Some(Property::new(card.origin("PBEAML", id), material?, section, other_mass))
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
        let at = another_place(card, 8 * line + 1, &stations)?;
        stations.push(beam_station(card, 8 * line + 2, at)?);
        let has_stresses = card.text(8 * line).eq_ignore_ascii_case("YES");
        line += if has_stresses { 2 } else { 1 };
    }
    let rest = 8 * line;
    let other_inertia = beam_rest(card, id, rest, remarks)?;
    let other_mass_centre = apart(card, id, (rest + 8, ["M1", "M2"]), remarks)?;
    let neutral_axis = apart(card, id, (rest + 12, ["N1", "N2"]), remarks)?;
    let mut sections = Vec::new();
    for Station { at, first, numbers } in filled(stations) {
        let section = Section {
            area: numbers[0],
            i1: numbers[1],
            i2: numbers[2],
            i12: numbers[3],
            torsion: numbers[4],
        };
        positive_definite(card, first + 3, &section)?;
        sections.push((at, section, numbers[5]));
    }
    let (section, other_mass) = mean((card, id), &sections, remarks);
    let on_axis = Property::new(card.origin("PBEAM", id), material?, section, other_mass);
    Some(Property { other_inertia, neutral_axis, other_mass_centre, ..on_axis })
}

/// Six numbers from a field on: area, I1, I2, I12, J, other mass.
fn beam_station(card: &Reader, first: usize, at: f64) -> Option<Station<Option<f64>>> {
    let mut numbers = Vec::with_capacity(6);
    for (number, name) in ["A", "I1", "I2", "I12", "J", "NSM"].into_iter().enumerate() {
        if name != "I12" {
            card.not_negative(first + number, name, 0.0)?;
        }
        numbers.push(card.optional(first + number, name)?);
    }
    Some(Station { at, first, numbers })
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
    if at_a != at_b {
        let said = format!("found {at_b}, and {at_a} at end A: the mean is held, elements are uniform here");
        remarks.field((card.card, id), (first + 5, "NSI(B)"), said);
    }
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

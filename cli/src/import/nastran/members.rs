//! Elements in body axes and SI: where they begin and end, their axes, stiffness and mass per length.

use nalgebra::{Matrix3, Vector3};

use super::cards::{Cards, Element, ElementKind, Material, Offset, Orientation, Pin, Property};
use super::frames::World;
use super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::sections::Section;
use super::stiffness::Stiffness;
use super::units::Units;

/// Shorter elements have no direction, m.
const SHORTEST: f64 = 1e-6;

/// Of one element, kg.
const HEAVIEST: f64 = 1e9;

/// From the shear centre, m.
const FARTHEST: f64 = 100.0;

/// How much stiffer than what it has an element is held where its card gives no stiffness.
const HELD: f64 = 1e3;

/// An element.
#[derive(Clone, Debug)]
pub struct Member {
    pub origin: Origin,
    pub grids: [i64; 2],
    /// m.
    pub ends: [Vector3<f64>; 2],
    /// Across the element, in plane 1.
    pub y_axis: Vector3<f64>,
    /// The direction that it comes from: that of the card.
    pub y_written: Vector3<f64>,
    pub stiffness: Stiffness,
    /// kg/m.
    pub mass_by_length: f64,
    /// Where its mass is, from the line between its ends, m.
    pub mass_centre: Vector3<f64>,
    /// About the axis through the centre of its mass, kg m, as a disc has it.
    pub inertia_by_length: f64,
    /// Of masses that are apart from their common centre, kg m.
    pub apart_by_length: Matrix3<f64>,
    /// Components in which its ends are free, and the field that says so.
    pub pins: [Option<Pin>; 2],
    /// Whether its property gives a torsional stiffness.
    pub resists_twist: bool,
}

impl Member {
    pub fn span(&self) -> Vector3<f64> {
        self.ends[1] - self.ends[0]
    }

    pub fn length(&self) -> f64 {
        self.span().norm()
    }

    pub fn mass(&self) -> f64 {
        self.mass_by_length * self.length()
    }
}

/// All elements of the deck.
pub fn members(
    (cards, world, units): (&Cards, &World, &Units),
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Member> {
    let mut making = Making { cards, world, units, mistakes, remarks };
    cards.elements.iter().filter_map(|element| making.member(element)).collect()
}

struct Making<'a> {
    cards: &'a Cards,
    world: &'a World,
    units: &'a Units,
    mistakes: &'a mut Mistakes,
    remarks: &'a mut Remarks,
}

impl Making<'_> {
    fn member(&mut self, element: &Element) -> Option<Member> {
        let [one, other] = element.grids.map(|grid| self.grid(element, grid));
        let grids = [one?, other?];
        let (property, material) = self.property(element)?;
        let ends = self.ends(element, grids)?;
        let span = ends[1] - ends[0];
        if span.norm() < SHORTEST {
            let found = format!("found a length of {} m", span.norm());
            self.mistakes.of_origin(
                &element.origin,
                "GA, GB",
                found,
                format!("{SHORTEST} m or more is allowed"),
            );
            return None;
        }
        let x = span.normalize();
        let y = match &element.orientation {
            Some(orientation) => self.plane_1(element, orientation, &x)?,
            None => any_across(&x),
        };
        let section = of_kind(element.kind, property.section);
        let written =
            element.orientation.as_ref().and_then(|orientation| self.direction(element, orientation));
        let y_written = written.map_or(y, |written| written.normalize());
        let stiffness = self.stiffness(element, (&property, &section, &material), span.norm())?;
        let density = material.density;
        let own = if element.kind == ElementKind::Beam { density * (section.i1 + section.i2) } else { 0.0 };
        let masses =
            [density * section.area, property.other_mass].map(|mass| mass * self.units.mass_by_length());
        let places = [property.neutral_axis, property.other_mass_centre]
            .map(|[along_y, along_z]| (y * along_y + x.cross(&y) * along_z) * self.units.length);
        let mass_by_length = masses[0] + masses[1];
        let (mass_centre, apart_by_length) = common(masses, places);
        let inertia_by_length = (own + property.other_inertia) * self.units.mass * self.units.length;
        let mass = mass_by_length * span.norm();
        // What is no number counts as too far.
        let farthest = places.iter().map(Vector3::norm).max_by(f64::total_cmp).unwrap_or(0.0);
        if farthest.is_nan() || farthest > FARTHEST {
            let found = format!("found a place {farthest:.4e} m from the shear centre");
            let allowed = format!("up to {FARTHEST} m is allowed; --units says what the deck's units are");
            self.mistakes.of_origin(&property.origin, "M1, M2, N1, N2", found, allowed);
            return None;
        }
        if !(0.0..=HEAVIEST).contains(&mass) || !inertia_by_length.is_finite() {
            let found = format!("found a mass of {mass:.4e} kg");
            let allowed = format!("up to {HEAVIEST:e} kg is allowed; --units says what the deck's units are");
            self.mistakes.of_origin(&element.origin, "PID", found, allowed);
            return None;
        }
        Some(Member {
            origin: element.origin.clone(),
            grids: element.grids,
            ends,
            y_axis: y,
            y_written,
            stiffness,
            mass_by_length,
            mass_centre,
            inertia_by_length,
            apart_by_length,
            pins: element.pins.clone(),
            resists_twist: property.section.torsion > 0.0,
        })
    }

    fn grid(&mut self, element: &Element, grid: i64) -> Option<Vector3<f64>> {
        let place = self.world.grid(grid);
        if place.is_none() && !self.cards.grids.contains_key(&grid) {
            self.mistakes.missing(&element.origin, "GA, GB", grid, Needed::Grid);
        }
        place
    }

    fn property(&mut self, element: &Element) -> Option<(Property, Material)> {
        let kinds: &[&str] = match element.kind {
            ElementKind::Bar => &["PBAR", "PBARL"],
            ElementKind::Beam => &["PBEAM", "PBEAML"],
            ElementKind::Rod => &["PROD"],
        };
        let found = self
            .cards
            .properties
            .get(&element.property)
            .filter(|property| kinds.contains(&property.origin.card));
        let Some(property) = found else {
            let allowed = format!("a {} of the deck is needed", kinds.join(" or "));
            self.mistakes.of_origin(&element.origin, "PID", format!("found {}", element.property), allowed);
            return None;
        };
        let Some(material) = self.cards.materials.get(&property.material) else {
            self.mistakes.missing(&property.origin, "MID", property.material, Needed::Card("a MAT1"));
            return None;
        };
        Some((property.clone(), *material))
    }

    fn ends(&self, element: &Element, grids: [Vector3<f64>; 2]) -> Option<[Vector3<f64>; 2]> {
        let mut ends = grids;
        for (end, Offset { numbers, is_of_element }) in element.offsets.iter().enumerate() {
            if *numbers == [0.0; 3] {
                continue;
            }
            let axes = if *is_of_element {
                self.element_axes(element, grids)?
            } else {
                self.world.displacement_axes(element.grids[end])?
            };
            ends[end] += axes * Vector3::from(*numbers) * self.world.length();
        }
        Some(ends)
    }

    /// From grid to grid, without offsets.
    fn element_axes(&self, element: &Element, grids: [Vector3<f64>; 2]) -> Option<Matrix3<f64>> {
        let x = (grids[1] - grids[0]).try_normalize(0.0)?;
        let y = across(&x, &self.direction(element, element.orientation.as_ref()?)?)?;
        Some(Matrix3::from_columns(&[x, y, x.cross(&y)]))
    }

    fn direction(&self, element: &Element, orientation: &Orientation) -> Option<Vector3<f64>> {
        match orientation {
            Orientation::Vector { numbers, is_basic: true } => {
                Some(self.world.basic_axes() * Vector3::from(*numbers))
            }
            Orientation::Vector { numbers, .. } => {
                Some(self.world.displacement_axes(element.grids[0])? * Vector3::from(*numbers))
            }
            Orientation::Grid(grid) => Some(self.world.grid(*grid)? - self.world.grid(element.grids[0])?),
        }
    }

    /// The y axis of the element: across it in plane 1.
    fn plane_1(
        &mut self,
        element: &Element,
        orientation: &Orientation,
        x: &Vector3<f64>,
    ) -> Option<Vector3<f64>> {
        let direction = self.direction(element, orientation);
        let y = direction.as_ref().and_then(|direction| across(x, direction));
        if y.is_none() {
            let (found, allowed) = match orientation {
                Orientation::Grid(grid) if direction.is_none() => {
                    (format!("found {grid}"), "a GRID of the deck is needed")
                }
                _ => ("found a direction along the element".to_owned(), "a direction across it is needed"),
            };
            self.mistakes.of_origin(&element.origin, "X1, X2, X3", found, allowed);
        }
        y
    }

    fn stiffness(
        &mut self,
        element: &Element,
        (property, section, material): (&Property, &Section, &Material),
        length: f64,
    ) -> Option<Stiffness> {
        let bending = self.units.bending();
        let given = Stiffness {
            ea: material.young * section.area * self.units.axial(),
            gj: material.shear * section.torsion * bending,
            ei_y: material.young * section.i2 * bending,
            ei_z: material.young * section.i1 * bending,
            ei_yz: material.young * section.i12 * bending,
            tension_axis: property.neutral_axis.map(|place| place * self.units.length),
        };
        let most = [given.gj, given.ei_y, given.ei_z, given.ea * length * length * 1e-6]
            .into_iter()
            .fold(0.0, f64::max);
        if most <= 0.0 {
            let allowed = "a property is needed that resists something";
            self.mistakes.of_origin(&element.origin, "PID", "found no stiffness at all", allowed);
            return None;
        }
        let mut lacking = Vec::new();
        let mut held = |number: f64, otherwise: f64, name: &'static str| {
            if number > 0.0 {
                return number;
            }
            lacking.push(name);
            otherwise
        };
        let stiffness = Stiffness {
            ea: held(given.ea, HELD * most / (length * length) * 1e3, "A"),
            gj: held(given.gj, HELD * most, "J"),
            ei_y: held(given.ei_y, HELD * most, "I2"),
            ei_z: held(given.ei_z, HELD * most, "I1"),
            ..given
        }
        .without_rounding();
        if !lacking.is_empty() {
            let said = format!(
                "found no {}: held as if rigid there, for a beam here resists everything",
                lacking.join(", ")
            );
            self.remarks.card_once(&property.origin, "stiffness", said);
        }
        let all = [stiffness.ea, stiffness.gj, stiffness.ei_y, stiffness.ei_z];
        if let Some(bad) = all.into_iter().find(|number| !(1e-6..=1e15).contains(number)) {
            let found = format!("found a stiffness of {bad:.4e} in SI (N, N m²)");
            self.mistakes.of_origin(
                &property.origin,
                "stiffness",
                found,
                "1e-6 to 1e15 is allowed; --units says what the deck's units are",
            );
            return None;
        }
        Some(stiffness)
    }
}

/// A rod bends here: like a solid round one of its area.
fn of_kind(kind: ElementKind, section: Section) -> Section {
    if kind != ElementKind::Rod {
        return section;
    }
    let second = section.area * section.area / (4.0 * std::f64::consts::PI);
    let torsion = if section.torsion > 0.0 { section.torsion } else { 2.0 * second };
    Section { i1: second, i2: second, torsion, ..section }
}

/// The centre of two masses from where each is, and what they have about it.
fn common(masses: [f64; 2], places: [Vector3<f64>; 2]) -> (Vector3<f64>, Matrix3<f64>) {
    let whole = masses[0] + masses[1];
    if whole <= 0.0 {
        return (Vector3::zeros(), Matrix3::zeros());
    }
    let apart = places[1] - places[0];
    let reduced = masses[0] * masses[1] / whole;
    let inertia = Matrix3::identity() * apart.norm_squared() - apart * apart.transpose();
    (places[0] + apart * (masses[1] / whole), inertia * reduced)
}

/// The part of a direction across another one.
pub fn across(x: &Vector3<f64>, direction: &Vector3<f64>) -> Option<Vector3<f64>> {
    let part = direction - x * x.dot(direction);
    (part.norm() > 1e-6 * direction.norm()).then(|| part.normalize())
}

/// Some direction across a unit vector.
pub fn any_across(x: &Vector3<f64>) -> Vector3<f64> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let least = axes.into_iter().min_by(|one, other| x.dot(one).abs().total_cmp(&x.dot(other).abs()));
    let least = least.unwrap_or_else(Vector3::x);
    (least - x * x.dot(&least)).normalize()
}

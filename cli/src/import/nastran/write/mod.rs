//! The aircraft as a file that people read: TOML, with the cards that each part comes from beside it.

mod component;
mod control;
mod joint;
mod law;
mod surface;

use super::aero::{Control, Role, Surface};
use super::members::Member;
use super::pairs::Side;
use super::structure::{PlacedLump, Structure};
use crate::commented::{self, comment};
use crate::numbers::Plain;

/// Where comments begin that stand behind a value.
const COLUMN: usize = 40;

/// What is written.
pub struct Written<'a> {
    /// For people.
    pub name: &'a str,
    /// What stands in the head of the file, line by line.
    pub heading: &'a [String],
    pub is_clamped: bool,
    pub is_symmetric: bool,
    /// m/s and m, with what they come from.
    pub airspeed: (f64, String),
    pub altitude: (f64, String),
    /// Chord, area, span as the deck has them.
    pub reference: [Option<f64>; 3],
    pub structure: &'a Structure,
    pub names: &'a [String],
    pub sides: &'a [Side],
    pub surfaces: &'a [Surface],
    pub controls: &'a [Control],
    pub roles: &'a [Option<Role>],
    pub engines: &'a [Engine],
    /// Where a member comes from, as `wing.bdf:12`.
    pub shown: &'a dyn Fn(&super::mistakes::Origin) -> String,
}

/// Thrust at a grid.
#[derive(Clone, Debug)]
pub struct Engine {
    pub name: String,
    pub component: usize,
    pub node: usize,
    pub offset: nalgebra::Vector3<f64>,
}

/// The text of the file.
pub fn file(written: &Written) -> String {
    let mut text: String =
        written.heading.iter().map(|line| format!("# {line}").trim_end().to_owned() + "\n").collect();
    text += "\n";
    text += &top(written);
    let moved = control::Moved::new(written);
    text += &control::controls(written, &moved);
    for (place, side) in written.sides.iter().enumerate() {
        if !matches!(side, Side::Image { .. }) {
            text += &component::text(written, place, &moved);
        }
    }
    text += &joint::joints(written);
    text += &engines(written);
    text += &watched(written);
    text.trim_end().to_owned() + "\n"
}

fn top(written: &Written) -> String {
    let support = if written.is_clamped { "clamped" } else { "free" };
    let model = if written.structure.joints.is_empty() {
        "model = \"geometrically_exact\"\n".to_owned()
    } else {
        comment(joint::WHY_EXACT) + "model = \"exact\"\n"
    };
    let mut text = format!(
        "format = 1\nname = {}\nsupport = \"{support}\"\nmode_basis = \"bending_torsion\"\n{model}",
        toml::Value::String(written.name.to_owned())
    );
    text += &beside(&format!("airspeed_m_s = {}", number(written.airspeed.0)), &written.airspeed.1);
    text += &beside(&format!("altitude_m = {}", number(written.altitude.0)), &written.altitude.1);
    if written.is_symmetric {
        text += "symmetric = true\n";
    }
    if written.reference.iter().any(Option::is_some) {
        text += "\n[reference]\n";
        for (name, given) in ["chord_m", "area_m2", "span_m"].into_iter().zip(written.reference) {
            if let Some(given) = given {
                text += &format!("{name} = {}\n", number(given));
            }
        }
    }
    text + "\n"
}

fn engines(written: &Written) -> String {
    let one = |engine: &Engine| {
        let (component, distance) = written.place(engine.component, engine.node);
        let offset = match engine.offset {
            offset if offset.norm() > 0.0 => format!("offset_m = {}\n", vector(&offset)),
            _ => String::new(),
        };
        format!(
            "[[engine]]\nname = \"{}\"\ncomponent = \"{component}\"\nat_m = {}\n{offset}direction = [1, 0, 0]\n\n",
            engine.name,
            number(distance)
        )
    };
    written.engines.iter().map(one).collect()
}

/// Stations at the tips of surfaces, cuts where their first element begins.
fn watched(written: &Written) -> String {
    let with_strips = |place: &usize| {
        let side = written.sides[*place];
        let own = match side {
            Side::Image { of } => of,
            _ => *place,
        };
        written.surfaces.iter().any(|surface| surface.component == own)
    };
    let places: Vec<usize> = (0..written.names.len()).filter(with_strips).collect();
    let sided = |name: &str, what: &str| match name.rsplit_once('_') {
        Some((surface, side @ ("right" | "left"))) => format!("{surface}_{what}_{side}"),
        _ => format!("{name}_{what}"),
    };
    let station = |&place: &usize| {
        let name = &written.names[place];
        format!("[[station]]\nname = \"{}\"\ncomponent = \"{name}\"\nat = 1\n\n", sided(name, "tip"))
    };
    let cut = |&place: &usize| {
        let name = &written.names[place];
        let at = number(written.root(place));
        format!("[[cut]]\nname = \"{}\"\ncomponent = \"{name}\"\nat = {at}\n\n", sided(name, "root"))
    };
    let within = written.structure.elements_in_loops();
    let (in_loops, free): (Vec<&usize>, Vec<&usize>) =
        places.iter().partition(|place| within[**place].contains(&true));
    let mut text: String = places.iter().map(station).chain(free.into_iter().map(cut)).collect();
    if !in_loops.is_empty() {
        let names: Vec<&str> = in_loops.into_iter().map(|&place| written.names[place].as_str()).collect();
        text += &comment(&format!(
            "No [[cut]] at the root of {}: within a loop no summation gives its loads.",
            names.join(", ")
        ));
    }
    text
}

impl Written<'_> {
    /// The member of an element.
    fn member(&self, component: usize, element: usize) -> Option<&Member> {
        let member = self.structure.components[component].elements[element].member?;
        self.structure.members.get(member)
    }

    /// Where the first element of the deck begins, beyond rigid links, as a fraction of the length.
    fn root(&self, component: usize) -> f64 {
        let component = &self.structure.components[component];
        let first = component.elements.iter().position(|element| element.member.is_some()).unwrap_or(0);
        let distances = component.distances();
        distances[first] / distances[distances.len() - 1]
    }

    fn lumps(&self, component: usize) -> impl Iterator<Item = &PlacedLump> {
        self.structure.lumps.iter().filter(move |lump| lump.component == component)
    }

    /// A component's name, and how far along it a node is, m.
    fn place(&self, component: usize, node: usize) -> (&str, f64) {
        (&self.names[component], self.structure.components[component].distances()[node])
    }
}

/// A line with a comment behind it.
fn beside(text: &str, comment: &str) -> String {
    commented::beside(text, comment, COLUMN)
}

/// With twelve digits: what rounding has left over does not show.
fn number(number: f64) -> String {
    // PROOF: what is written as a number is read as one; the number itself stands in for any doubt.
    Plain(format!("{number:.11e}").parse().unwrap_or(number)).to_string()
}

/// What is less than rounding of the largest is 0.
fn vector(v: &nalgebra::Vector3<f64>) -> String {
    let smallest = 1e-12 * v.amax();
    let numbers =
        [v.x, v.y, v.z].map(|along| if along.abs() <= smallest { "0".to_owned() } else { number(along) });
    format!("[{}]", numbers.join(", "))
}

fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|one| number(*one)).collect();
    format!("[{}]", numbers.join(", "))
}

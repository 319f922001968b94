//! A component: axis, stiffness, masses.

use nalgebra::{Matrix3, Vector3};

use super::super::members::Member;
use super::super::pairs::Side;
use super::super::stiffness::Stiffness;
use super::super::structure::{
    Component, ComponentHinge, HALVES, LIGHTEST, MadeFor, NodeRef, PlacedLump, Springs, turned_inertia,
};
use super::control::Moved;
use super::law::per_element;
use super::{Written, beside, list, number, surface, vector};
use crate::commented::comment;

/// Elements whose spans differ by less than this share of their length are alike.
const ALIKE: f64 = 1e-9;

/// Of one segment of an axis.
const MOST_ELEMENTS: usize = 1000;

/// Couplings and distances that are less than this are rounding, N m² and m.
const NOTHING: f64 = 1e-12;

pub fn text(written: &Written, place: usize, moved: &Moved) -> String {
    let component = &written.structure.components[place];
    let mut text = format!("# {} {}\n\n", "-".repeat(64), written.names[place].trim_end_matches("_right"));
    text += &comment(&source(written, place));
    text += &format!("[[component]]\nname = \"{}\"\n", written.names[place]);
    if let Side::Written { image } = written.sides[place] {
        text += &format!("mirror = \"{}\"\n", written.names[image]);
    }
    text += &attachment(written, component);
    let (corners, counts) = corners(component);
    let axis: Vec<String> = corners.iter().map(vector).collect();
    text += &match axis.as_slice() {
        short if short.len() <= 4 => format!("axis_m = [{}]\n", short.join(", ")),
        long => format!(
            "axis_m = [\n{}]\n",
            long.iter().map(|point| format!("    {point},\n")).collect::<String>()
        ),
    };
    text += &match counts.as_slice() {
        [one] => format!("elements = {one}\n"),
        several => format!("elements = {several:?}\n"),
    };
    text += &format!("y_axis = {}\n", vector(&component.y_axis));
    text += &stiffness(component);
    text += &component.hinge.as_ref().map(|hinge| of_hinge(written, hinge)).unwrap_or_default();
    text += &masses_of_elements(written, place);
    for lump in written.lumps(place) {
        text += &of_lump(written, component, lump);
    }
    for surface in written.surfaces.iter().filter(|surface| surface.component == place) {
        text += &surface::text(written, surface, moved);
    }
    text + "\n"
}

/// The cards that it comes from.
fn source(written: &Written, place: usize) -> String {
    if let Some(MadeFor { origin, .. }) = &written.structure.components[place].made_for {
        return format!(
            "no beam of the deck: {origin} ({}) is on this one, which is rigid: 1e5 times as stiff as what is beside it",
            (written.shown)(origin)
        );
    }
    let count = written.structure.components[place].elements.len();
    let members: Vec<_> = (0..count).filter_map(|element| written.member(place, element)).collect();
    let links = count - members.len();
    let links = match links {
        0 => String::new(),
        1 => "; 1 rigid link, as an element 1e5 times as stiff as those beside it".to_owned(),
        several => format!("; {several} rigid links, as elements 1e5 times as stiff as those beside them"),
    };
    match (members.first(), members.last()) {
        (Some(first), Some(last)) if members.len() > 1 => {
            format!(
                "{} to {} ({} elements, from {}){links}",
                first.origin,
                last.origin,
                members.len(),
                (written.shown)(&first.origin)
            )
        }
        (Some(only), _) => format!("{} ({}){links}", only.origin, (written.shown)(&only.origin)),
        _ => format!("no element of the deck{links}"),
    }
}

fn attachment(written: &Written, component: &Component) -> String {
    match component.parent {
        NodeRef::Origin => "attached_to = \"origin\"\n".to_owned(),
        NodeRef::Node { component, node } => {
            let distances = written.structure.components[component].distances();
            let at = distances[node] / distances[distances.len() - 1];
            let parent = &written.names[component];
            format!("attached_to = {{ component = \"{parent}\", at = {} }}\n", number(at))
        }
    }
}

/// Corners of the axis from its root, and how many elements lie between two of them: like ones on one line are told once.
fn corners(component: &Component) -> (Vec<Vector3<f64>>, Vec<usize>) {
    let root = component.points[0];
    let mut corners = vec![Vector3::zeros()];
    let mut counts: Vec<usize> = Vec::new();
    let mut before: Option<Vector3<f64>> = None;
    for ends in component.points.windows(2) {
        let span = ends[1] - ends[0];
        let is_alike = before.is_some_and(|before| (span - before).norm() <= ALIKE * span.norm());
        let to = ends[1] - root;
        match counts.last_mut().filter(|count| is_alike && **count < MOST_ELEMENTS) {
            Some(count) => {
                *count += 1;
                corners.pop();
            }
            None => {
                counts.push(1);
                before = Some(span);
            }
        }
        corners.push(to);
    }
    (corners, counts)
}

fn stiffness(component: &Component) -> String {
    let values = |of: fn(&Stiffness) -> f64| -> Vec<f64> {
        component.elements.iter().map(|element| of(&element.stiffness)).collect()
    };
    let law = |name: &str, of: fn(&Stiffness) -> f64| format!("{name} = {}\n", per_element(&values(of)));
    let if_any = |name: &str, of: fn(&Stiffness) -> f64| {
        if values(of).iter().all(|value| value.abs() <= NOTHING) { String::new() } else { law(name, of) }
    };
    law("EA_N", |of| of.ea)
        + &law("GJ_N_m2", |of| of.gj)
        + &law("EI_y_N_m2", |of| of.ei_y)
        + &law("EI_z_N_m2", |of| of.ei_z)
        + &if_any("EI_yz_N_m2", |of| of.ei_yz)
        + &if_any("tension_axis_y_m", |of| of.tension_axis[0])
        + &if_any("tension_axis_z_m", |of| of.tension_axis[1])
}

/// Springs at the root.
fn of_hinge(written: &Written, hinge: &ComponentHinge) -> String {
    let source = format!("{} ({}){}", hinge.origin, (written.shown)(&hinge.origin), hinge.said);
    let springs = match &hinge.springs {
        Springs::About { axis, stiffness } => {
            format!("axis = {}\nstiffness_N_m_per_rad = {}\n", vector(axis), number(*stiffness))
        }
        Springs::AboutLocalAxes(stiffnesses) => format!("stiffnesses_N_m_per_rad = {}\n", list(stiffnesses)),
    };
    beside("\n[component.hinge]", &source) + &springs
}

/// Masses of elements, each at two places that have its mass, centre and inertia; those with like inertias and places beside the axis are told together.
fn masses_of_elements(written: &Written, place: usize) -> String {
    let component = &written.structure.components[place];
    let distances = component.distances();
    let mut groups: Vec<(Matrix3<f64>, Vector3<f64>, Vec<usize>)> = Vec::new();
    for element in 0..component.elements.len() {
        let Some(member) = written.member(place, element).filter(|member| member.mass() >= LIGHTEST) else {
            continue;
        };
        let (inertia, centre) = (turned_inertia(member) * 0.5, member.mass_centre);
        let is_like = |(other, place, _): &&mut (Matrix3<f64>, Vector3<f64>, Vec<usize>)| {
            (inertia - *other).amax() <= 1e-11 * inertia.amax() && (centre - *place).amax() <= NOTHING
        };
        match groups.iter_mut().find(is_like) {
            Some((.., elements)) => elements.push(element),
            None => groups.push((inertia, centre, vec![element])),
        }
    }
    let mut text = String::new();
    for (inertia, centre, elements) in groups {
        let mut at = Vec::new();
        let mut masses = Vec::new();
        for element in elements {
            let [from, to] = [distances[element], distances[element + 1]];
            let half = 0.5 * written.member(place, element).map_or(0.0, Member::mass);
            for share in HALVES {
                at.push(from + share * (to - from));
                masses.push(half);
            }
        }
        let is_one = masses.iter().all(|mass| (mass - masses[0]).abs() <= 1e-11 * masses[0]);
        let masses = if is_one { number(masses[0]) } else { list(&masses) };
        text += &beside(
            "\n[[component.point_masses]]",
            "of elements: two places each have its mass, centre and inertia",
        );
        text += &format!("at_m = {}\nmass_kg = {masses}\n", list(&at));
        if centre.norm() > NOTHING {
            text += &format!("offset_m = {}\n", vector(&centre));
        }
        text += &of_inertia(&inertia);
    }
    text
}

fn of_lump(written: &Written, component: &Component, lump: &PlacedLump) -> String {
    let origin = &lump.lump.origin;
    let source = format!("{origin}, GRID {} ({})", lump.lump.grid, (written.shown)(origin));
    let mut text = beside("\n[[component.point_masses]]", &source);
    text += &format!(
        "at_m = {}\nmass_kg = {}\n",
        number(component.distances()[lump.node]),
        number(lump.lump.mass)
    );
    if lump.offset.norm() > 1e-12 {
        text += &format!("offset_m = {}\n", vector(&lump.offset));
    }
    text + &of_inertia(&lump.lump.inertia)
}

/// Moments and products; none where there is no inertia.
fn of_inertia(inertia: &Matrix3<f64>) -> String {
    let largest = inertia.amax();
    if largest <= 0.0 {
        return String::new();
    }
    let moments: Vector3<f64> = inertia.diagonal();
    let mut text = format!("inertia_kg_m2 = {}\n", vector(&moments));
    let products = Vector3::new(inertia[(0, 1)], inertia[(0, 2)], inertia[(1, 2)]);
    if products.amax() > 1e-12 * largest {
        text += &format!("products_kg_m2 = {}\n", vector(&products));
    }
    text
}

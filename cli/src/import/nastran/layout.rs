//! Names for people: what a component is by where it lies and which way it runs.

use nalgebra::Vector3;

use super::names::Names;
use super::structure::{Component, ComponentElement, NodeRef, Structure};

/// Places that are nearer to the plane of symmetry than this share of the aircraft are in it.
pub const IN_PLANE: f64 = 1e-6;

/// Surfaces that are apart along x by more than this share of the aircraft are not one wing.
const APART: f64 = 0.1;

/// A rigid link along the plane of symmetry that is longer than this share of the aircraft is a rigid body.
const BODY: f64 = 0.25;

/// Which way a component runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Aside,
    Upright,
    Along,
}

/// The distance of the farthest node from O, m.
pub fn size(structure: &Structure) -> f64 {
    structure.components.iter().flat_map(|component| &component.points).map(Vector3::norm).fold(0.0, f64::max)
}

/// A component's nodes without the rigid links that it begins and ends with: a fin may begin with one as long as the fuselage.
fn own(component: &Component) -> &[Vector3<f64>] {
    if component.made_for.is_some() && component.points.len() > 2 {
        return &component.points[1..];
    }
    let of_deck = |element: &ComponentElement| element.member.is_some();
    let first = component.elements.iter().position(of_deck);
    let last = component.elements.iter().rposition(of_deck);
    first.zip(last).map_or(&component.points, |(first, last)| &component.points[first..last + 2])
}

/// The mean of a component's own nodes.
pub fn middle(component: &Component) -> Vector3<f64> {
    let own = own(component);
    own.iter().sum::<Vector3<f64>>() / own.len() as f64
}

fn reach(component: &Component) -> Vector3<f64> {
    let own = own(component);
    own[own.len() - 1] - own[0]
}

fn way(component: &Component) -> Way {
    let reach = reach(component).abs();
    if reach.y >= 0.5 * reach.norm() && reach.y >= reach.z {
        Way::Aside
    } else if reach.z >= reach.x {
        Way::Upright
    } else {
        Way::Along
    }
}

/// The name of each component.
pub fn names(structure: &Structure) -> Vec<String> {
    let size = size(structure);
    let aside = structure.components.iter().filter(|component| is_surface(component));
    let aside = aside.filter(|component| inner(structure, component).is_none());
    let wing = aside.max_by(|one, other| reach(one).y.abs().total_cmp(&reach(other).y.abs()));
    let mut names = Names::default();
    let mut bases: Vec<&'static str> = Vec::new();
    let mut given = Vec::new();
    for component in &structure.components {
        let inner = inner(structure, component).map(|inner| bases[inner]);
        let base = inner.and_then(outer).unwrap_or_else(|| base(component, wing, size));
        bases.push(base);
        let y = middle(component).y;
        given.push(if y.abs() <= IN_PLANE * size || base == "root" {
            names.free(base, "beam")
        } else {
            names.on_side(base, if y > 0.0 { "right" } else { "left" })
        });
    }
    given
}

fn is_surface(component: &Component) -> bool {
    way(component) == Way::Aside && !is_link(component) && !component.is_strut
}

/// The component at whose tip another one goes on, beyond rigid links, if both run aside to the same side.
fn inner(structure: &Structure, component: &Component) -> Option<usize> {
    let place = of_parent(structure, component).filter(|_| is_surface(component))?;
    let inner = &structure.components[place];
    (is_surface(inner) && reach(inner).y * reach(component).y > 0.0).then_some(place)
}

/// The component that one hangs on at its last node, beyond rigid links.
fn of_parent(structure: &Structure, component: &Component) -> Option<usize> {
    let NodeRef::Node { component: place, node } = component.parent else { return None };
    let parent = &structure.components[place];
    if is_link(parent) {
        return of_parent(structure, parent);
    }
    (node + 1 == parent.points.len()).then_some(place)
}

/// What goes on at the tip of one.
fn outer(base: &'static str) -> Option<&'static str> {
    Some(match base {
        "wing" | "wing_outer" => "wing_outer",
        "tail" | "tail_outer" => "tail_outer",
        "canard" | "canard_outer" => "canard_outer",
        _ => return None,
    })
}

fn is_link(component: &Component) -> bool {
    component.made_for.is_none() && component.elements.iter().all(|element| element.member.is_none())
}

fn base(component: &Component, wing: Option<&Component>, size: f64) -> &'static str {
    let is_in_plane = middle(component).y.abs() <= IN_PLANE * size;
    let length = reach(component).norm();
    let is_body = is_in_plane && way(component) == Way::Along && length > BODY * size;
    if is_link(component) && !is_body {
        return if length < 1e-6 { "root" } else { "link" };
    }
    if component.is_strut {
        return "strut";
    }
    match (way(component), wing) {
        (Way::Aside, Some(wing)) => {
            let behind = middle(wing).x - middle(component).x;
            if behind > APART * size && reach(component).y.abs() < 0.7 * reach(wing).y.abs() {
                "tail"
            } else if behind < -APART * size {
                "canard"
            } else {
                "wing"
            }
        }
        (Way::Aside, None) => "wing",
        (Way::Upright, _) if reach(component).z < 0.0 => "fin",
        (Way::Upright, _) => "pylon",
        (Way::Along, _) if !is_in_plane => "boom",
        (Way::Along, _) if reach(component).x > 0.0 => "fuselage_front",
        (Way::Along, _) => "fuselage_aft",
    }
}

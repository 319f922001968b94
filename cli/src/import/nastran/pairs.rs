//! Which components are mirror images of each other in y = 0, so that one is written for both.

use nalgebra::{Matrix3, Vector3};

use super::aero::{Flap, Surface};
use super::layout::{IN_PLANE, middle, size};
use super::members::Member;
use super::stiffness::Stiffness;
use super::structure::{Component, ComponentHinge, NodeRef, PlacedLump, Springs, Structure};

/// Numbers that differ by less than this share are alike: decks are written with six digits.
const ALIKE: f64 = 2e-6;

/// With more components none is looked for.
const MOST: usize = 1000;

/// What a component is to another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// In the plane of symmetry, or without image.
    Alone,
    /// It is written, and its image is the other one.
    Written { image: usize },
    /// It is the image of the other one.
    Image { of: usize },
}

/// The side of each component.
pub fn sides(structure: &Structure, surfaces: &[Surface]) -> Vec<Side> {
    let count = structure.components.len();
    let mut sides = vec![Side::Alone; count];
    if count > MOST {
        return sides;
    }
    let mirror = Mirror { structure, surfaces, size: size(structure) };
    for one in 0..count {
        if sides[one] != Side::Alone || middle(&structure.components[one]).y.abs() <= IN_PLANE * mirror.size {
            continue;
        }
        let image = (one + 1..count)
            .find(|&other| sides[other] == Side::Alone && mirror.components([one, other], &sides));
        if let Some(other) = image {
            let is_right = middle(&structure.components[one]).y > 0.0;
            let (right, left) = if is_right { (one, other) } else { (other, one) };
            (sides[right], sides[left]) = (Side::Written { image: left }, Side::Image { of: right });
        }
    }
    sides
}

/// Whether each component is in the plane or has an image: what is then asked of masses, the reader of the file finds.
pub fn is_mirrored(structure: &Structure, sides: &[Side]) -> bool {
    let size = size(structure);
    let in_plane =
        |component: &Component| component.points.iter().all(|point| point.y.abs() <= IN_PLANE * size);
    structure
        .components
        .iter()
        .zip(sides)
        .all(|(component, side)| *side != Side::Alone || in_plane(component))
}

struct Mirror<'a> {
    structure: &'a Structure,
    surfaces: &'a [Surface],
    size: f64,
}

impl Mirror<'_> {
    fn components(&self, pair: [usize; 2], sides: &[Side]) -> bool {
        let [one, other] = pair.map(|place| &self.structure.components[place]);
        one.elements.len() == other.elements.len()
            && self.parents([one, other], sides)
            && std::iter::zip(&one.points, &other.points).all(|(one, other)| self.places(one, other))
            && vector(&one.y_axis).cross(&other.y_axis).norm() <= ALIKE
            && hinges(one.hinge.as_ref(), other.hinge.as_ref())
            && std::iter::zip(&one.elements, &other.elements).all(|(one_element, other_element)| {
                let member = |member: Option<usize>| member.map(|member| &self.structure.members[member]);
                let masses = match (member(one_element.member), member(other_element.member)) {
                    (Some(one), Some(other)) => self.masses(one, other),
                    (one, other) => one.is_none() && other.is_none(),
                };
                let image = one_element.stiffness.mirrored();
                let is_about = vector(&one.y_axis).dot(&other.y_axis) < 0.0;
                masses
                    && stiffnesses(
                        &if is_about { image.turned_about() } else { image },
                        &other_element.stiffness,
                    )
            })
            && self.lumps(pair)
            && self.surfaces(pair)
    }

    fn parents(&self, [one, other]: [&Component; 2], sides: &[Side]) -> bool {
        match (one.parent, other.parent) {
            (NodeRef::Origin, NodeRef::Origin) => true,
            (
                NodeRef::Node { component: one, node },
                NodeRef::Node { component: other, node: other_node },
            ) => {
                let is_image = match sides[one] {
                    Side::Alone => {
                        one == other
                            && self.structure.components[one].points[node].y.abs() <= IN_PLANE * self.size
                    }
                    Side::Written { image } => image == other,
                    Side::Image { of } => of == other,
                };
                is_image && node == other_node
            }
            _ => false,
        }
    }

    fn places(&self, one: &Vector3<f64>, other: &Vector3<f64>) -> bool {
        (vector(one) - other).norm() <= ALIKE * self.size
    }

    /// Of elements.
    fn masses(&self, one: &Member, other: &Member) -> bool {
        let apart = turned(&one.apart_by_length) - other.apart_by_length;
        alike(one.mass(), other.mass())
            && alike(one.inertia_by_length, other.inertia_by_length)
            && self.places(&one.mass_centre, &other.mass_centre)
            && apart.norm() <= ALIKE * one.apart_by_length.norm()
    }

    fn lumps(&self, pair: [usize; 2]) -> bool {
        let [ones, mut others] = pair.map(|place| {
            self.structure.lumps.iter().filter(|lump| lump.component == place).collect::<Vec<_>>()
        });
        let fits = |one: &PlacedLump, other: &PlacedLump| {
            let inertia = turned(&one.lump.inertia) - other.lump.inertia;
            one.node == other.node
                && alike(one.lump.mass, other.lump.mass)
                && self.places(&one.offset, &other.offset)
                && inertia.norm() <= ALIKE * one.lump.inertia.norm()
        };
        ones.len() == others.len()
            && ones.iter().all(|one| {
                let found = others.iter().position(|other| fits(one, other));
                found.map(|place| others.swap_remove(place)).is_some()
            })
    }

    fn surfaces(&self, pair: [usize; 2]) -> bool {
        let [ones, others] = pair.map(|place| {
            self.surfaces.iter().filter(|surface| surface.component == place).collect::<Vec<_>>()
        });
        let lists = |one: &[f64], other: &[f64], slack: f64| {
            one.len() == other.len()
                && std::iter::zip(one, other).all(|(one, other)| (one - other).abs() <= slack)
        };
        let widths = |one: &Option<Vec<f64>>, other: &Option<Vec<f64>>| match (one, other) {
            (Some(one), Some(other)) => lists(one, other, ALIKE * self.size),
            (one, other) => one.is_none() && other.is_none(),
        };
        ones.len() == others.len()
            && std::iter::zip(ones, others).all(|(one, other)| {
                alike(1.0 + one.from, 1.0 + other.from)
                    && alike(1.0 + one.to, 1.0 + other.to)
                    && lists(&one.at, &other.at, ALIKE)
                    && lists(&one.chords, &other.chords, ALIKE * self.size)
                    && lists(&one.elastic_axes, &other.elastic_axes, 10.0 * ALIKE)
                    && widths(&one.widths, &other.widths)
                    && spans(one.span_axis.as_ref(), other.span_axis.as_ref())
                    && flaps(one.flap.as_ref(), other.flap.as_ref())
            })
    }
}

fn vector(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(v.x, -v.y, v.z)
}

fn turned(inertia: &Matrix3<f64>) -> Matrix3<f64> {
    let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
    mirror * inertia * mirror
}

fn alike(one: f64, other: f64) -> bool {
    (one - other).abs() <= ALIKE * one.abs().max(other.abs())
}

fn stiffnesses(one: &Stiffness, other: &Stiffness) -> bool {
    let places = |[one_y, one_z]: [f64; 2], [y, z]: [f64; 2]| alike(one_y, y) && alike(one_z, z);
    alike(one.ea, other.ea)
        && alike(one.gj, other.gj)
        && alike(one.ei_y, other.ei_y)
        && alike(one.ei_z, other.ei_z)
        && (one.ei_yz - other.ei_yz).abs() <= ALIKE * one.ei_y.max(one.ei_z)
        && places(one.tension_axis, other.tension_axis)
}

/// A hinge turns about a line, to which way that points is nothing.
fn hinges(one: Option<&ComponentHinge>, other: Option<&ComponentHinge>) -> bool {
    match (one.map(|hinge| &hinge.springs), other.map(|hinge| &hinge.springs)) {
        (None, None) => true,
        (
            Some(Springs::About { axis: one, stiffness }),
            Some(Springs::About { axis: other, stiffness: other_stiffness }),
        ) => vector(one).cross(other).norm() <= ALIKE && alike(*stiffness, *other_stiffness),
        (Some(Springs::AboutLocalAxes(one)), Some(Springs::AboutLocalAxes(other))) => {
            std::iter::zip(one, other).all(|(one, other)| alike(*one, *other))
        }
        _ => false,
    }
}

/// Span axes point to the right on both sides.
fn spans(one: Option<&Vector3<f64>>, other: Option<&Vector3<f64>>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (Vector3::new(-one.x, one.y, -one.z) - other).norm() <= 10.0 * ALIKE,
        (one, other) => one.is_none() && other.is_none(),
    }
}

/// What moves them may differ.
fn flaps(one: Option<&Flap>, other: Option<&Flap>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => {
            (one.hinge - other.hinge).abs() <= 10.0 * ALIKE && alike(one.effectiveness, other.effectiveness)
        }
        (one, other) => one.is_none() && other.is_none(),
    }
}

//! How the axes of a cut lie on the undeformed aircraft [theory: section-loads.axes].

use nalgebra::Vector3;

use crate::aircraft::{CROSSING, Strip};

use super::assembly::Structure;

/// Cosine of the sweep from which on a beam runs across its strips: 80°.
const ACROSS: f64 = 0.173_648_177_666_930_33;

/// Sine of the angle below which two directions are one.
const SAME_DIRECTION: f64 = 1e-3;

/// Components of a direction that differ by less are equally large.
const EQUALLY_LARGE: f64 = 1e-9;

/// t, u, c and the axis of torsion, ±t.
pub(super) struct Axes {
    pub(super) along: Vector3<f64>,
    pub(super) up: Vector3<f64>,
    pub(super) chordwise: Vector3<f64>,
    pub(super) torsion: Vector3<f64>,
}

impl Axes {
    /// At an element: of a lifting surface, if the cut is through one, else of a body.
    pub(super) fn new(structure: &Structure, beam: usize) -> Self {
        let along = direction(structure, beam);
        Axes::of_surface(&strips_at(structure, beam), along).unwrap_or_else(|| Axes::of_body(along))
    }

    /// Of a lifting surface, whose strips have a common span that runs along the beam.
    fn of_surface(strips: &[&Strip], along: Vector3<f64>) -> Option<Self> {
        let first = strips.first()?;
        if strips.iter().any(|strip| strip.span.dot(&first.span).abs() < CROSSING) {
            return None;
        }
        let (forward, span) = (first.forward, first.span);
        let up = across(&-forward.cross(&span), &along)?;
        let chordwise = facing(up.cross(&along), &forward);
        let torsion = facing(along, &span);
        (chordwise.dot(&forward) > ACROSS).then_some(Axes { along, up, chordwise, torsion })
    }

    /// Of a body, by the axis that it runs along most of all: sideways as a wing, upright as a fin, else as a fuselage.
    fn of_body(along: Vector3<f64>) -> Self {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        let [lengthwise, sideways, upright] = [along.x, along.y, along.z].map(f64::abs);
        let largest = lengthwise.max(sideways).max(upright) - EQUALLY_LARGE;
        let (upwards, aside, about) = if sideways >= largest {
            (-z, x, y)
        } else if upright >= largest {
            (x, y, -z)
        } else {
            (-z, y, x)
        };
        // The beam does not run along this axis most of all, so that it has a part across the beam.
        let up = across(&upwards, &along).unwrap_or_default();
        Axes { along, up, chordwise: facing(up.cross(&along), &aside), torsion: facing(along, &about) }
    }
}

/// The strips on the element at a cut; where it has none, on the nearest one that has, as far as the component goes on in
/// nearly the same direction.
fn strips_at<'a>(structure: &Structure<'a>, own: usize) -> Vec<&'a Strip> {
    let aircraft = structure.aircraft;
    let along = direction(structure, own);
    let goes_on = |beam: &usize| {
        aircraft.beams[*beam].component == aircraft.beams[own].component
            && direction(structure, *beam).dot(&along) > CROSSING
    };
    let first = (0..own).rev().take_while(goes_on).last().unwrap_or(own);
    let last = (own + 1..aircraft.beams.len()).take_while(goes_on).last().unwrap_or(own);
    let strips: Vec<&Strip> =
        aircraft.strips.iter().filter(|strip| (first..=last).contains(&strip.attachment.beam)).collect();
    let middle = |beam: usize| structure.geometry[beam].position(0.5);
    let away = |beam: usize| (middle(beam) - middle(own)).norm();
    let beams = strips.iter().map(|strip| strip.attachment.beam);
    let nearest = beams.min_by(|one, other| away(*one).total_cmp(&away(*other)));
    strips.into_iter().filter(|strip| Some(strip.attachment.beam) == nearest).collect()
}

/// Of an element, from its first node to its second.
fn direction(structure: &Structure, beam: usize) -> Vector3<f64> {
    structure.geometry[beam].axes.row(0).transpose()
}

/// A vector or its opposite, whichever has a part along a direction.
fn facing(vector: Vector3<f64>, direction: &Vector3<f64>) -> Vector3<f64> {
    if vector.dot(direction) < 0.0 { -vector } else { vector }
}

/// The part of a unit vector across a direction, at length 1; `None` where it is along it.
fn across(vector: &Vector3<f64>, along: &Vector3<f64>) -> Option<Vector3<f64>> {
    (vector - along * along.dot(vector)).try_normalize(SAME_DIRECTION)
}

//! Which components are lifting surfaces, and their strips.

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Strip;
use nalgebra::Vector3;

/// Cosine of the angle between span and beam below which a strip lies across a body: 60°.
const ALONG: f64 = 0.5;

/// The strips of a component, from its root on.
pub fn strips(aircraft: &Aircraft, component: usize) -> Vec<&Strip> {
    let is_on_it = |strip: &&Strip| aircraft.component_of(strip.attachment.beam) == Some(component);
    let mut strips: Vec<&Strip> = aircraft.strips.iter().filter(is_on_it).collect();
    strips.sort_by(|one, other| place(one).total_cmp(&place(other)));
    strips
}

/// Whether a component is a wing, a tail or a fin: strips run along it.
pub fn is_lifting(aircraft: &Aircraft, component: usize) -> bool {
    strips(aircraft, component).iter().any(|strip| runs_along(aircraft, strip))
}

/// Whether the span of a strip runs along the beam that carries it.
pub fn runs_along(aircraft: &Aircraft, strip: &Strip) -> bool {
    strip.span.dot(&direction(aircraft, strip.attachment.beam)).abs() > ALONG
}

/// The direction against which a strip lifts, of length 1: n = forward × span [theory: air-loads.flow].
pub fn normal(strip: &Strip) -> Vector3<f64> {
    strip.forward.cross(&strip.span)
}

/// The elements of a component, root first.
pub fn elements(aircraft: &Aircraft, component: usize) -> std::ops::Range<usize> {
    let first = aircraft.components[component].first_beam;
    first..first + aircraft.components[component].nodes.len() - 1
}

/// Of an element, at length 1.
pub fn direction(aircraft: &Aircraft, beam: usize) -> Vector3<f64> {
    let [from, to] = aircraft.beams[beam].nodes.map(|node| aircraft.nodes[node]);
    (to - from).normalize()
}

/// Where a strip is along its component, in elements.
fn place(strip: &Strip) -> f64 {
    strip.attachment.beam as f64 + strip.attachment.fraction
}

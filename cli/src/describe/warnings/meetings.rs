//! Nodes in one place that nothing joins: components form a tree, and those that only meet do not touch.
//!
//! Not told are nodes that short elements join, as the link of 1 mm there and back by which several beams hang on one hinge.

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Joint;

/// Elements up to this long, m, make one place of what they are between: as far as joints reach, and rounding.
const SHORT: f64 = 1.01 * Joint::REACH;

/// A pair of components with nodes in one place, the first of their nodes; of mirrored pairs one.
pub fn unjoined(aircraft: &Aircraft) -> Vec<String> {
    let components = &aircraft.components;
    let mut told: Vec<[usize; 2]> = Vec::new();
    let mut warnings = Vec::new();
    for one in 0..components.len() {
        for other in one + 1..components.len() {
            let pair = [one, other];
            let image = pair.map(|component| components[component].image.unwrap_or(component));
            let is_told = told.contains(&image) || told.contains(&[image[1], image[0]]);
            let meeting = if is_told { None } else { meeting(aircraft, pair) };
            if let Some(places) = meeting {
                told.push(pair);
                warnings.push(text(aircraft, pair, places));
            }
        }
    }
    warnings
}

/// Where along two components nodes are in one place that are neither one nor joined, as fractions of their lengths.
fn meeting(aircraft: &Aircraft, pair: [usize; 2]) -> Option<[f64; 2]> {
    let [ones, others] = pair.map(|component| &aircraft.components[component].nodes);
    let pairs = ones.iter().flat_map(|&one| others.iter().map(move |&other| [one, other]));
    let is_near =
        |&[one, other]: &[usize; 2]| (aircraft.nodes[one] - aircraft.nodes[other]).norm() <= Joint::REACH;
    let meeting = pairs.into_iter().filter(is_near).find(|nodes| !are_one(aircraft, *nodes))?;
    let mut places = [0.0; 2];
    for ((place, component), node) in places.iter_mut().zip(pair).zip(meeting) {
        *place = fraction(aircraft, component, node);
    }
    Some(places)
}

/// Whether two nodes are the same, or joints or short elements join them, be it by others in the same place.
fn are_one(aircraft: &Aircraft, [one, other]: [usize; 2]) -> bool {
    let mut reached = vec![one];
    let mut next = 0;
    while next < reached.len() {
        let joints = aircraft.joints.iter().map(Joint::nodes);
        let beams = aircraft.beams.iter().map(|beam| beam.nodes);
        let is_short =
            |[from, to]: &[usize; 2]| (aircraft.nodes[*from] - aircraft.nodes[*to]).norm() <= SHORT;
        for [from, to] in joints.chain(beams.filter(is_short)) {
            for (from, to) in [(from, to), (to, from)] {
                if from == reached[next] && !reached.contains(&to) {
                    reached.push(to);
                }
            }
        }
        next += 1;
    }
    reached.contains(&other)
}

/// Of a component's length at one of its nodes.
fn fraction(aircraft: &Aircraft, component: usize, node: usize) -> f64 {
    let nodes = &aircraft.components[component].nodes;
    let lengths = nodes.windows(2).map(|pair| (aircraft.nodes[pair[1]] - aircraft.nodes[pair[0]]).norm());
    let inboard = nodes.iter().position(|other| *other == node).unwrap_or(0);
    let whole: f64 = lengths.clone().sum();
    lengths.take(inboard).fold(0.0, |sum, length| sum + length) / whole
}

fn text(aircraft: &Aircraft, pair: [usize; 2], places: [f64; 2]) -> String {
    let [one, other] = pair.map(|component| aircraft.components[component].name.as_str());
    let [at, other_at] = places.map(crate::numbers::short);
    format!(
        "{one} at {at} and {other} at {other_at} of their lengths are in one place and do not touch, usual is a [[joint]] there: component = \"{one}\", \
         at = {at}, joined_to = {{ component = \"{other}\", at = {other_at} }}"
    )
}

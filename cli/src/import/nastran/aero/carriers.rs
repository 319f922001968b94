//! Panels that no beam of the deck runs along, as tails and foreplanes on a rigid body: each gets a rigid beam of its own, from that node of
//! its grids, else of the aircraft, that is nearest.

use nalgebra::Vector3;

use super::super::mistakes::Remarks;
use super::super::structure::{MadeFor, NodeRef, Structure};
use super::panel::{CarriedBy, Panel};
use super::runs::beside;

/// With more of them it is no stick model.
const MOST: usize = 200;

/// Strips of each, where the panel has as many or more.
const MOST_STRIPS: usize = 10;

/// Where the beam runs, as a fraction of the chord, if its node is beside the panel.
const AXIS: f64 = 0.5;

/// Panels that are farther away, m, are not reached.
const FARTHEST: f64 = 100.0;

/// Ends of a panel nearer than this to a node, m, begin there.
const AT_NODE: f64 = 1e-3;

/// Adds a beam for each panel that has none.
pub fn carry(structure: &mut Structure, panels: &[Panel], remarks: &mut Remarks) {
    let without = panels.iter().enumerate().filter(|panel| beside(structure, *panel).is_empty());
    let without: Vec<(usize, &Panel)> = without.take(MOST).collect();
    for (place, panel) in without {
        let middle = panel.outline.at(0.5, AXIS);
        let distance = |node: &NodeRef| (structure.place_of(*node) - middle).norm();
        let nodes = nodes(structure, panel);
        // Of several in one place the first, however the grids are listed.
        let order =
            |one: &NodeRef, other: &NodeRef| distance(one).total_cmp(&distance(other)).then(one.cmp(other));
        let nearest = nodes.into_iter().min_by(order);
        let Some(node) = nearest.filter(|node| distance(node) + panel.outline.span().norm() <= FARTHEST)
        else {
            continue;
        };
        let at = structure.place_of(node);
        let points: Vec<Vector3<f64>> = points(panel, &at);
        let [x, y, z] = [at.x, at.y, at.z];
        remarks.note(format!("{}: no beam runs along it: a rigid one carries it, from the node at x {x:.4}, y {y:.4}, z {z:.4} m in body axes", panel.origin));
        let made_for = MadeFor { panel: place, origin: panel.origin.clone() };
        structure.add_stick(node, points.into_iter(), made_for);
    }
}

/// Those that may carry a panel.
fn nodes(structure: &Structure, panel: &Panel) -> Vec<NodeRef> {
    match &panel.carried_by {
        CarriedBy::Grids(grids) => structure.nodes_of(grids).into_iter().collect(),
        CarriedBy::Between(grids) => structure.nodes_of(grids).into_iter().collect(),
        CarriedBy::Nearest => structure.nodes().collect(),
    }
}

/// Of the beam behind a node, from the end of the panel that is nearer: it goes on from the node where that is within the chord there.
fn points(panel: &Panel, node: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let outline = &panel.outline;
    let mut edges = panel.strips();
    if edges.len() > MOST_STRIPS + 1 {
        edges = (0..=MOST_STRIPS).map(|edge| edge as f64 / MOST_STRIPS as f64).collect();
    }
    let [from, to] = [0.0, 1.0].map(|end| (outline.at(end, AXIS) - node).norm());
    if to < from {
        edges.reverse();
    }
    let own = outline.chord_fraction(node, edges[0]);
    let axis = if (0.0..=1.0).contains(&own) { own } else { AXIS };
    let places = edges.into_iter().map(|edge| outline.at(edge, axis));
    places.skip_while(|place| (place - node).norm() < AT_NODE).collect()
}

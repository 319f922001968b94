//! Panels that no beam of the deck runs along, as tails and foreplanes on a rigid body: each gets a rigid beam of its own, from that node of
//! its grids, else of the aircraft, that is nearest.

use nalgebra::Vector3;

use super::super::mistakes::Remarks;
use super::super::structure::{MadeFor, NodeRef, Structure};
use super::panel::{CarriedBy, Panel};
use super::runs::beside;

/// With more of them it is no stick model.
const MOST: usize = 200;

/// Strips of each, where the panel has as many or more; each is so wide or wider, m.
const MOST_STRIPS: usize = 10;
const NARROWEST: f64 = 1e-3;

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
        let span = panel.outline.span().norm();
        let strips = (panel.strips().len() - 1).min(MOST_STRIPS).min((span / NARROWEST) as usize);
        let Some((node, distance)) = nearest(structure, panel) else { continue };
        if strips == 0 || distance + span > FARTHEST {
            continue;
        }
        let at = structure.place_of(node);
        let [x, y, z] = [at.x, at.y, at.z];
        remarks.note(format!("{}: no beam runs along it: a rigid one carries it, from the node at x {x:.4}, y {y:.4}, z {z:.4} m in body axes", panel.origin));
        let made_for = MadeFor { panel: place, origin: panel.origin.clone() };
        structure.add_stick(node, points((panel, strips), &at).into_iter(), made_for);
    }
}

/// Of those nodes that may carry a panel the one that is nearest, and how far it is, m; of several in one place the first, however the grids
/// are listed.
fn nearest(structure: &Structure, panel: &Panel) -> Option<(NodeRef, f64)> {
    let middle = panel.outline.at(0.5, AXIS);
    let with_distance = |node: NodeRef| (node, (structure.place_of(node) - middle).norm());
    let order =
        |one: &(NodeRef, f64), other: &(NodeRef, f64)| one.1.total_cmp(&other.1).then(one.0.cmp(&other.0));
    nodes(structure, panel).into_iter().map(with_distance).min_by(order)
}

/// Those that may carry a panel.
fn nodes(structure: &Structure, panel: &Panel) -> Vec<NodeRef> {
    match &panel.carried_by {
        CarriedBy::Grids(grids) => structure.nodes_of(grids).into_iter().collect(),
        CarriedBy::Between(grids) => structure.nodes_of(grids).into_iter().collect(),
        CarriedBy::Nearest => structure.nodes_of_deck().collect(),
    }
}

/// Of the beam behind a node, from the end of the panel that is nearer: it goes on from the node where that is within the chord there.
fn points((panel, strips): (&Panel, usize), node: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let outline = &panel.outline;
    let mut edges: Vec<f64> = (0..=strips).map(|edge| edge as f64 / strips as f64).collect();
    let [from, to] = [0.0, 1.0].map(|end| (outline.at(end, AXIS) - node).norm());
    if to < from {
        edges.reverse();
    }
    let own = outline.chord_fraction(node, edges[0]);
    let axis = if (0.0..=1.0).contains(&own) { own } else { AXIS };
    let places = edges.into_iter().map(|edge| outline.at(edge, axis));
    places.skip_while(|place| (place - node).norm() < AT_NODE).collect()
}

//! Joints where chains close loops [theory: structure.joints].

use super::super::members::Member;
use super::super::mistakes::{Origin, Remarks};
use super::growth::{Growth, NEAR_BY_LENGTH};
use super::pins;
use super::tree::Tree;
use super::{NodeRef, Structure};

/// Nodes that are farther apart are joined over a rigid link, m: the format takes 1 mm.
const APART: f64 = 5e-4;

/// Two nodes that move together.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The element that ends there, and its grid.
    pub origin: Origin,
    pub grid: i64,
    /// Component and node, first that of the element.
    pub ends: [(usize, usize); 2],
    /// Rotations about body axes that they share.
    pub rotations: [bool; 3],
}

/// Joins the ends of chains to what they meet.
pub fn close(growth: &mut Growth, (tree, members): (&Tree, &[Member]), remarks: &mut Remarks) -> Vec<Joint> {
    let mut joints = Vec::new();
    for closing in &tree.closings {
        let member = &members[closing.tip.0];
        let grid = member.grids[closing.tip.1];
        let tip = growth.ports[closing.own].first().copied();
        let slack = APART.min(NEAR_BY_LENGTH * member.length());
        let target = tip.and_then(|(place, _)| growth.port(closing.joined_to, &place, slack));
        let (Some((place, tip)), Some((at, target))) = (tip, target) else { continue };
        let gap = (place - at).norm();
        let target =
            if gap > slack { growth.add_link((at, target), place, closing.joined_to) } else { target };
        let rotations = pins::joint(members, closing).rotations;
        let ends = [tip, target].map(|node| match node {
            NodeRef::Origin => (0, 0),
            NodeRef::Node { component, node } => (component, node),
        });
        joints.push(Joint { origin: member.origin.clone(), grid, ends, rotations });
    }
    tell(&joints, remarks);
    joints
}

fn tell(joints: &[Joint], remarks: &mut Remarks) {
    let why = "and model = \"exact\", for the geometrically exact level has no loops";
    match joints {
        [] => {}
        [one] => remarks
            .note(format!("{} closes a loop at GRID {}: a [[joint]] there, {why}", one.origin, one.grid)),
        several => {
            let at = |joint: &Joint| format!("{} at GRID {}", joint.origin, joint.grid);
            let all = several.iter().map(at).collect::<Vec<_>>().join(", ");
            remarks.note(format!("{} loops are closed, by {all}: a [[joint]] at each, {why}", several.len()));
        }
    }
}

impl Structure {
    /// Of each component which of its elements are part of a loop.
    pub fn elements_in_loops(&self) -> Vec<Vec<bool>> {
        let mut within: Vec<Vec<bool>> =
            self.components.iter().map(|component| vec![false; component.elements.len()]).collect();
        for joint in &self.joints {
            let ways = joint.ends.map(|end| self.way(end));
            for (one, other) in [(0, 1), (1, 0)] {
                for element in ways[one].iter().filter(|element| !ways[other].contains(element)) {
                    within[element.0][element.1] = true;
                }
            }
        }
        within
    }

    /// The elements between O and a node.
    fn way(&self, (component, node): (usize, usize)) -> Vec<(usize, usize)> {
        let mut way: Vec<(usize, usize)> = (0..node).map(|element| (component, element)).collect();
        let mut at = component;
        // Components hang on earlier ones alone.
        while let NodeRef::Node { component, node } = self.components[at].parent {
            way.extend((0..node).map(|element| (component, element)));
            at = component;
        }
        way
    }
}

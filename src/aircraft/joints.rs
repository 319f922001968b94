//! Which nodes move together [theory: structure.joints].
//!
//! A joint is written once: where its components have mirror images it is there on both sides.

use super::components::{BESIDE_A_HINGE, at_node, component_named, nodes_allowed};
use super::error::{Place, Problem, Report};
use super::fidelity::Fidelity;
use super::model::{Aircraft, Joint, JointEnd};
use super::schema::{FileSpec, JointEndSpec, JointSpec};

/// Nodes nearer to the plane y = 0 are in it, m.
const IN_PLANE: f64 = 1e-9;

/// A node by the place of its component among all and its own there, counted from the root.
type Node = (usize, usize);

/// The joints of a file with their places there, images after those that are written; what is wrong is reported.
pub(super) fn joints(specs: &[JointSpec], aircraft: &Aircraft, report: &Report) -> Vec<(Joint, Place)> {
    let mut joints: Vec<(Joint, Place)> = Vec::new();
    for spec in specs {
        let [one, other] = [&spec.ends[0], &spec.ends[1]].map(|end| node(end, aircraft, report));
        let (Some(one), Some(other)) = (one, other) else { continue };
        let joint = aircraft.joint([one, other], spec);
        if !may_be(&joint, &spec.place, aircraft, report) {
            continue;
        }
        if let Some((known, _)) = joints.iter().find(|(known, _)| is_of(known, joint.nodes())) {
            let found = format!("found {joint} a second time, beside {known}");
            let allowed =
                "one joint of two nodes is allowed; with mirrored components it is on both sides by itself";
            report.add(Problem::DuplicateName, &spec.place, found, allowed);
            continue;
        }
        let image = aircraft.image_of_node(one).zip(aircraft.image_of_node(other));
        let image = image.map(|(one, other)| aircraft.joint([one, other], spec));
        let image = image.filter(|image| !is_of(image, joint.nodes()));
        joints.push((joint, spec.place.clone()));
        joints.extend(image.map(|image| (image, spec.place.clone())));
    }
    joints
}

/// Geometrically exact kinematics knows no loops.
pub(super) fn level(file: &FileSpec, aircraft: &Aircraft, joints: &[Place], report: &Report) {
    let (Some(joint), Some(place)) = (aircraft.joints.first(), joints.first()) else { return };
    if file.fidelity != Fidelity::GeometricallyExact {
        return;
    }
    let others = Fidelity::OF_THESIS.map(|level| format!("\"{}\"", level.name())).join(", ");
    let name = Fidelity::GeometricallyExact.name();
    let found = match &file.fidelity_place {
        Some(_) => format!("found \"{name}\" with {joint}, which closes a loop"),
        None => format!("found {joint}, which closes a loop, and no model, which is \"{name}\" then"),
    };
    let exact = Fidelity::Exact.name();
    let allowed =
        format!("that level has no loops: write model = \"{exact}\"; allowed with joints: {others}");
    report.add(Problem::Contradiction, file.fidelity_place.as_ref().unwrap_or(place), found, allowed);
}

/// The node that an end names.
fn node(end: &JointEndSpec, aircraft: &Aircraft, report: &Report) -> Option<Node> {
    let names = aircraft.components.iter().map(|component| component.name.as_str());
    let component = component_named(&end.component, names, report)?;
    let distances = aircraft.distances(&aircraft.components[component]);
    let length = distances[distances.len() - 1];
    let fractions = || distances.iter().map(|node| node / length);
    let node = at_node(fractions(), end.at.value);
    if node.is_none() {
        let found = format!("found {}, where \"{}\" has no node", end.at.value, end.component.value);
        let allowed = nodes_allowed(fractions(), end.at.value);
        report.add(Problem::Disconnected, &end.at.place, found, allowed);
    }
    let node = node?;
    if node == 0 && aircraft.beams[aircraft.components[component].first_beam].hinge.is_some() {
        let found = format!("found the root of \"{}\", where a hinge is", end.component.value);
        report.add(Problem::Disconnected, &end.at.place, found, BESIDE_A_HINGE);
        return None;
    }
    Some((component, node))
}

/// Whether two nodes can be joined.
fn may_be(joint: &Joint, place: &Place, aircraft: &Aircraft, report: &Report) -> bool {
    let [one, other] = joint.nodes();
    if one == other {
        let found = format!("found {joint}, which are one node");
        report.add(
            Problem::Contradiction,
            place,
            found,
            "two nodes are allowed that do not hang together yet",
        );
        return false;
    }
    let apart = (aircraft.nodes[one] - aircraft.nodes[other]).norm();
    if apart > Joint::REACH {
        let [from, to] = [one, other].map(|node| {
            let at = aircraft.nodes[node];
            format!("[{:.3}, {:.3}, {:.3}]", at.x, at.y, at.z)
        });
        let found = format!("found {joint}, {:.1} mm apart: at {from} and {to} m", apart * 1e3);
        report.add(Problem::Disconnected, place, found, "nodes at most 1 mm apart are allowed");
        return false;
    }
    true
}

/// Whether a joint is of these two nodes.
fn is_of(joint: &Joint, nodes: [usize; 2]) -> bool {
    let [one, other] = joint.nodes();
    nodes == [one, other] || nodes == [other, one]
}

impl Aircraft {
    /// That of two nodes which stand where a file says, or of their images.
    fn joint(&self, nodes: [Node; 2], spec: &JointSpec) -> Joint {
        let end = |end: usize| {
            let (component, node) = nodes[end];
            let component = &self.components[component];
            let (component, node) = (component.name.clone(), component.nodes[node]);
            JointEnd { component, at: spec.ends[end].at.value, node }
        };
        Joint { ends: [end(0), end(1)], rotations: spec.rotations }
    }

    /// The mirror image of a node, if it has one: that of its component, or itself in the plane.
    fn image_of_node(&self, (component, node): Node) -> Option<Node> {
        let Some(image) = self.components[component].image else {
            let is_in_plane = self.nodes[self.components[component].nodes[node]].y.abs() <= IN_PLANE;
            return is_in_plane.then_some((component, node));
        };
        Some((image, node))
    }
}

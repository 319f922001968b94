//! The nodes of the skeleton: the aircraft, its joints in the jig shape with what drives them in their extras, stations and flaps.

use gltf::json::{Index, Node, Value};
use serde_json::json;

use super::super::View;
use super::document::{Document, extras};
use super::joints::{Joints, triple};
use super::{about, axes, leaders};

/// Nodes of a document.
pub struct Skeleton {
    /// The whole aircraft: O and the body axes.
    pub root: Index<Node>,
    /// In the order of the joints.
    pub joints: Vec<Index<Node>>,
}

impl Skeleton {
    /// Adds them; where displacements are sums of mode shapes, each joint has those of all modes.
    pub fn add(document: &mut Document, view: &View, joints: &Joints<'_>, is_linear: bool) -> Self {
        let airframe = &view.airframe;
        let places = joints.places();
        let leaders = leaders::of_sections(airframe);
        let mut sections = Vec::new();
        let mut flaps = vec![None; joints.flaps.len()];
        for (section, name) in joints.names().into_iter().enumerate() {
            let mut children = Vec::new();
            let of_it = airframe.stations.iter().enumerate().filter(|(_, at)| **at == section);
            for (station, _) in of_it {
                children.push(document.root.push(station_node(&airframe.aircraft.stations[station].name)));
            }
            for (number, joint) in joints.flaps.iter().enumerate().filter(|(_, one)| one.section == section) {
                let node = document.root.push(Node {
                    name: Some(joints.flap_name(joint)),
                    translation: Some(axes::vector(&joint.offset)),
                    extras: extras(&joints.flap_extras(joint)),
                    ..Node::default()
                });
                flaps[number] = Some(node);
                children.push(node);
            }
            let mut told = json!({ "stations": leaders::extras(airframe, &leaders[section]) });
            if is_linear {
                told["modes"] = modes(view, section);
            }
            sections.push(document.root.push(Node {
                name: Some(name),
                translation: Some(axes::vector(&places[section])),
                children: (!children.is_empty()).then_some(children),
                extras: extras(&told),
                ..Node::default()
            }));
        }
        let root = document.root.push(Node {
            name: Some(about::ROOT.to_owned()),
            children: Some(sections.clone()),
            extras: extras(&about::skeleton(view, is_linear)),
            ..Node::default()
        });
        Skeleton { root, joints: sections.into_iter().chain(flaps.into_iter().flatten()).collect() }
    }
}

/// A node where a station is, and its axes.
fn station_node(name: &str) -> Node {
    Node {
        name: Some(format!("station {name}")),
        extras: extras(&json!({ "station": name })),
        ..Node::default()
    }
}

/// Displacement and rotation vector of a section for each mode, per unit of its coordinate.
fn modes(view: &View, section: usize) -> Value {
    let station = &view.model.stations[view.airframe.named[0] + section];
    let shapes = (0..view.model.modes.len()).map(|mode| station.shapes.of_mode(mode));
    let (displacement, rotation): (Vec<_>, Vec<_>) =
        shapes.map(|[displacement, rotation]| (triple(&displacement), triple(&rotation))).unzip();
    json!({ "displacement": displacement, "rotation": rotation })
}

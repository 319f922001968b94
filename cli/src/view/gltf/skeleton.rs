//! The aircraft as a skeleton with a skin: joints in the jig shape, and in their extras what drives them.

use gltf::json::{Index, Mesh, Node, Scene, Skin, Value};
use serde_json::json;

use super::super::View;
use super::super::show::Show;
use super::document::{Document, Numbers, extras};
use super::joints::{Joints, triple};
use super::{about, animation, axes, leaders, mesh};

/// Nodes of a document.
pub struct Skeleton {
    /// The whole aircraft: O and the body axes.
    pub root: Index<Node>,
    /// In the order of the joints.
    pub joints: Vec<Index<Node>>,
}

/// The file: an animation for each show; where displacements are sums of mode shapes, each joint has those of all modes.
pub fn file(view: &View, shows: &[Show], is_linear: bool) -> Vec<u8> {
    let joints = Joints::of(&view.airframe);
    let mut document = Document::new();
    let skeleton = Skeleton::add(&mut document, view, &joints, is_linear);
    let skinned = add_skin(&mut document, view, &joints, &skeleton);
    let scene = document.root.push(Scene {
        name: Some(view.airframe.aircraft.name.clone()),
        nodes: vec![skeleton.root, skinned],
        extensions: None,
        extras: None,
    });
    document.root.scene = Some(scene);
    for show in shows {
        animation::add(&mut document, show, &joints, &skeleton);
    }
    document.file()
}

impl Skeleton {
    fn add(document: &mut Document, view: &View, joints: &Joints<'_>, is_linear: bool) -> Self {
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

/// Adds the mesh and the joints on which it hangs.
fn add_skin(document: &mut Document, view: &View, joints: &Joints<'_>, skeleton: &Skeleton) -> Index<Node> {
    let shape = joints.shape();
    let primitives = shape.surfaces().map(|surface| mesh::primitive(document, surface, true, &[])).collect();
    let name = view.airframe.aircraft.name.clone();
    let mesh = document.root.push(Mesh {
        primitives,
        name: Some(name.clone()),
        weights: None,
        extensions: None,
        extras: None,
    });
    // From the aircraft to the joint in the jig shape, where nothing is turned.
    let unmoved = joints.places().into_iter().map(|place| {
        let [x, y, z] = axes::vector(&-place);
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, z, 1.0]
    });
    let unmoved: Vec<[f32; 16]> = unmoved.collect();
    let unmoved = document.add_alone(Numbers::matrices(&unmoved), None);
    let skin = document.root.push(Skin {
        joints: skeleton.joints.clone(),
        inverse_bind_matrices: Some(unmoved),
        skeleton: Some(skeleton.root),
        name: None,
        extensions: None,
        extras: None,
    });
    document.root.push(Node {
        name: Some(format!("{name}, skin")),
        mesh: Some(mesh),
        skin: Some(skin),
        ..Node::default()
    })
}

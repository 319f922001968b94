//! The aircraft as a skeleton with a skin, and its shows as animations.

use gltf::json::{Index, Mesh, Node, Scene, Skin};

use super::super::View;
use super::super::show::Show;
use super::document::{Document, Numbers};
use super::joints::Joints;
use super::rig::Skeleton;
use super::{animation, axes, mesh};

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

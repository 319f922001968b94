//! The aircraft as one mesh with targets: one for each mode, one for each control, all of them linear.

use gltf::json::{Mesh, Node, Scene};
use nalgebra::Vector3;
use serde_json::{Value, json};

use super::super::View;
use super::about;
use super::document::{Document, extras};
use super::joints::{Joints, digits};
use super::mesh::{self, Moved};
use super::shape::Vertex;

/// The largest displacement by a mode whose weight is 1, in parts of the airframe's size.
const AMPLITUDE: f64 = 0.05;

const DRIVEN: &str = "weight of a target = the FMU's output / scale; linear, from the jig shape: all levels of fidelity but \
     geometrically_exact";

/// What a target moves by.
enum Target {
    /// A mode, so many units of its coordinate.
    Mode { mode: usize, scale: f64 },
    /// A control, 1 rad.
    Control(usize),
}

/// The file.
pub fn file(view: &View) -> Vec<u8> {
    let joints = Joints::of(&view.airframe);
    let targets = targets(view);
    let shape = joints.shape();
    let mut document = Document::new();
    let moved: Vec<_> =
        targets.iter().map(|target| |vertex: &Vertex| target.displacements(view, &joints, vertex)).collect();
    let moved: Vec<Moved<'_>> = moved.iter().map(|moved| moved as Moved<'_>).collect();
    let surfaces = shape.surfaces();
    let primitives = surfaces.map(|surface| mesh::primitive(&mut document, surface, false, &moved)).collect();
    let told: Vec<Value> = targets.iter().map(|target| target.extras(view)).collect();
    let names: Vec<&Value> = told.iter().map(|target| &target["output"]).collect();
    let mesh = document.root.push(Mesh {
        primitives,
        name: Some(view.airframe.aircraft.name.clone()),
        weights: (!targets.is_empty()).then(|| vec![0.0; targets.len()]),
        extensions: None,
        extras: extras(&json!({ "targetNames": names, "targets": told })),
    });
    let mut said = about::common(view);
    said.insert("drivenByTargets".to_owned(), json!(DRIVEN));
    let node = document.root.push(Node {
        name: Some(about::ROOT.to_owned()),
        mesh: Some(mesh),
        extras: extras(&said.into()),
        ..Node::default()
    });
    let scene = document.root.push(Scene {
        name: Some(view.airframe.aircraft.name.clone()),
        nodes: vec![node],
        extensions: None,
        extras: None,
    });
    document.root.scene = Some(scene);
    document.file()
}

fn targets(view: &View) -> Vec<Target> {
    let View { airframe, model, .. } = view;
    let stations = &model.stations[airframe.at_sections()];
    let mode = |mode| {
        let moved = stations.iter().map(|station| station.shapes.of_mode(mode)[0].norm());
        let largest = moved.fold(f64::MIN_POSITIVE, f64::max);
        Target::Mode { mode, scale: digits(AMPLITUDE * airframe.size() / largest) }
    };
    let controls = (0..airframe.aircraft.controls.len()).map(Target::Control);
    (0..model.modes.len()).map(mode).chain(controls).collect()
}

impl Target {
    /// Of a vertex and of its normal, with a weight of 1.
    fn displacements(&self, view: &View, joints: &Joints<'_>, vertex: &Vertex) -> [Vector3<f64>; 2] {
        let [moved, turned, from] = match self {
            Target::Mode { mode, scale } => {
                let section = joints.section(vertex.joint);
                let station = &view.model.stations[view.airframe.named[0] + section];
                let [displacement, rotation] = station.shapes.of_mode(*mode);
                [displacement * *scale, rotation * *scale, view.airframe.sections[section].position]
            }
            Target::Control(control) => {
                let flap = vertex.joint.checked_sub(view.airframe.sections.len());
                let Some(joint) = flap.map(|flap| &joints.flaps[flap]) else { return Default::default() };
                let gain = joint.flap.gains.iter().find(|(other, _)| other == control);
                let gain = gain.map_or(0.0, |(_, gain)| *gain);
                let pivot = view.airframe.sections[joint.section].position + joint.offset;
                [Vector3::zeros(), joint.flap.axis * gain, pivot]
            }
        };
        [moved + turned.cross(&(vertex.place - from)), turned.cross(&vertex.normal)]
    }

    fn extras(&self, view: &View) -> Value {
        match self {
            Target::Mode { mode, scale } => json!({
                "output": about::output(*mode),
                "scale": scale,
                "unit": "kg^(1/2) m",
            }),
            Target::Control(control) => json!({
                "output": format!("surface.{}", view.airframe.aircraft.controls[*control].name),
                "scale": 1.0,
                "unit": "rad",
            }),
        }
    }
}

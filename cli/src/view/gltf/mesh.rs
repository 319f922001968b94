//! The skin of the aircraft as a mesh: places, normals and materials, hung on joints or moved by targets.

use std::collections::BTreeMap;

use gltf::json::buffer::Target;
use gltf::json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf::json::mesh::{Mode, MorphTarget, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Index, Material};

use super::axes;
use super::document::{Document, Numbers};
use super::shape::{Paint, Surface, Vertex};

/// How surfaces reflect.
const ROUGHNESS: f32 = 0.6;

/// Displacements of a vertex and of its normal.
pub type Moved<'m> = &'m dyn Fn(&Vertex) -> [nalgebra::Vector3<f64>; 2];

/// A surface on the undeformed aircraft, with its material; its vertices hang on joints, or targets move them.
pub fn primitive(
    document: &mut Document,
    surface: &Surface,
    hangs_on_joints: bool,
    targets: &[Moved<'_>],
) -> Primitive {
    let vertices = || surface.vertices.iter();
    let of_vertices = Some(Target::ArrayBuffer);
    let vectors =
        |document: &mut Document, all: Vec<[f32; 3]>| document.add_alone(Numbers::vectors(&all), of_vertices);
    let places = vectors(document, vertices().map(|vertex| axes::vector(&vertex.place)).collect());
    let normals = vectors(document, vertices().map(|vertex| axes::vector(&vertex.normal)).collect());
    let mut attributes = vec![(Semantic::Positions, places), (Semantic::Normals, normals)];
    if hangs_on_joints {
        let joints = Numbers::joints(vertices().map(|vertex| vertex.joint));
        attributes.push((Semantic::Joints(0), document.add_alone(joints, of_vertices)));
        let whole = Numbers::quaternions(&vec![[1.0, 0.0, 0.0, 0.0]; surface.vertices.len()]);
        attributes.push((Semantic::Weights(0), document.add_alone(whole, of_vertices)));
    }
    let indices = document.add_alone(Numbers::indices(&surface.triangles), Some(Target::ElementArrayBuffer));
    let targets = targets.iter().map(|moved| {
        let all: Vec<_> = vertices().map(*moved).collect();
        let [positions, normals] = [0, 1]
            .map(|part| vectors(document, all.iter().map(|moved| axes::vector(&moved[part])).collect()));
        MorphTarget { positions: Some(positions), normals: Some(normals), tangents: None }
    });
    let targets: Vec<MorphTarget> = targets.collect();
    let attributes = attributes.into_iter().map(|(name, numbers)| (Checked::Valid(name), numbers));
    Primitive {
        attributes: attributes.collect::<BTreeMap<_, _>>(),
        extensions: None,
        extras: None,
        indices: Some(indices),
        material: Some(material(document, surface.paint)),
        mode: Checked::Valid(Mode::Triangles),
        targets: (!targets.is_empty()).then_some(targets),
    }
}

fn material(document: &mut Document, paint: Paint) -> Index<Material> {
    let [red, green, blue] = paint.colour();
    document.root.push(Material {
        name: Some(paint.name().to_owned()),
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor([red, green, blue, 1.0]),
            metallic_factor: StrengthFactor(0.0),
            roughness_factor: StrengthFactor(ROUGHNESS),
            ..PbrMetallicRoughness::default()
        },
        ..Material::default()
    })
}

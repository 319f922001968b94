//! Files read back as an engine does: nodes, animations at a frame, the skin where its joints are.

use gltf::Glb;
use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};
use serde_json::Value;

/// A file.
pub struct File {
    pub json: Value,
    numbers: Vec<u8>,
}

impl File {
    pub fn read(bytes: &[u8]) -> Self {
        let glb = Glb::from_slice(bytes).unwrap();
        File { json: serde_json::from_slice(&glb.json).unwrap(), numbers: glb.bin.unwrap().into_owned() }
    }

    pub fn list(&self, name: &str) -> &[Value] {
        self.json[name].as_array().unwrap()
    }

    /// Rows of numbers that an accessor reads.
    pub fn rows(&self, accessor: &Value) -> Vec<Vec<f64>> {
        let accessor = &self.json["accessors"][number(accessor)];
        let view = &self.json["bufferViews"][number(&accessor["bufferView"])];
        let begin = number(&view["byteOffset"]) + number(&accessor["byteOffset"]);
        let width = match accessor["type"].as_str().unwrap() {
            "SCALAR" => 1,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let read = |at: usize| match number(&accessor["componentType"]) {
            5126 => f64::from(f32::from_le_bytes(self.numbers[begin + 4 * at..][..4].try_into().unwrap())),
            5125 => f64::from(u32::from_le_bytes(self.numbers[begin + 4 * at..][..4].try_into().unwrap())),
            _ => f64::from(u16::from_le_bytes(self.numbers[begin + 2 * at..][..2].try_into().unwrap())),
        };
        (0..number(&accessor["count"]))
            .map(|row| (0..width).map(|part| read(width * row + part)).collect())
            .collect()
    }

    pub fn vectors(&self, accessor: &Value) -> Vec<Vector3<f64>> {
        self.rows(accessor).iter().map(|row| Vector3::from_column_slice(row)).collect()
    }

    /// Poses of all nodes below their parents at a frame of an animation.
    pub fn locals(&self, animation: usize, frame: usize) -> Vec<Isometry3<f64>> {
        let mut locals: Vec<Isometry3<f64>> = self.list("nodes").iter().map(rest).collect();
        let animation = &self.json["animations"][animation];
        for channel in animation["channels"].as_array().unwrap() {
            let sampler = &animation["samplers"][number(&channel["sampler"])];
            let rows = self.rows(&sampler["output"]);
            assert_eq!(rows.len(), self.rows(&sampler["input"]).len());
            let row = &rows[frame.min(rows.len() - 1)];
            let local = &mut locals[number(&channel["target"]["node"])];
            match channel["target"]["path"].as_str().unwrap() {
                "translation" => local.translation = Translation3::new(row[0], row[1], row[2]),
                _ => local.rotation = quaternion(row),
            }
        }
        locals
    }

    /// Poses of all nodes of which the local ones are known.
    pub fn worlds(&self, locals: &[Isometry3<f64>]) -> Vec<Isometry3<f64>> {
        let mut worlds = locals.to_vec();
        let mut waiting: Vec<(usize, Isometry3<f64>)> = self.list("scenes")[0]["nodes"]
            .as_array()
            .unwrap()
            .iter()
            .map(|node| (number(node), Isometry3::identity()))
            .collect();
        while let Some((node, parent)) = waiting.pop() {
            worlds[node] = parent * locals[node];
            let children = self.list("nodes")[node]["children"].as_array();
            waiting.extend(children.into_iter().flatten().map(|child| (number(child), worlds[node])));
        }
        worlds
    }

    /// Places of all vertices of the skin where nodes are.
    pub fn skinned(&self, worlds: &[Isometry3<f64>]) -> Vec<Vector3<f64>> {
        let skin = &self.list("skins")[0];
        let unmoved = self.rows(&skin["inverseBindMatrices"]);
        let joints: Vec<usize> = skin["joints"].as_array().unwrap().iter().map(number).collect();
        let mut places = Vec::new();
        for primitive in self.primitives() {
            let of = |name: &str| self.rows(&primitive["attributes"][name]);
            for ((place, hung), weights) in of("POSITION").iter().zip(of("JOINTS_0")).zip(of("WEIGHTS_0")) {
                assert_eq!(weights, [1.0, 0.0, 0.0, 0.0]);
                let joint = hung[0] as usize;
                let moved = |axis: usize| unmoved[joint][12 + axis] + place[axis];
                let in_joint = Point3::new(moved(0), moved(1), moved(2));
                places.push((worlds[joints[joint]] * in_joint).coords);
            }
        }
        places
    }

    pub fn primitives(&self) -> &[Value] {
        self.list("meshes")[0]["primitives"].as_array().unwrap()
    }

    /// The node with a name.
    pub fn node(&self, name: &str) -> usize {
        let mut found = self.list("nodes").iter().enumerate().filter(|(_, node)| node["name"] == name);
        let node = found.next().unwrap().0;
        assert!(found.next().is_none(), "two nodes are called {name}");
        node
    }
}

/// The pose of a node that nothing moves.
fn rest(node: &Value) -> Isometry3<f64> {
    let place = node.get("translation").map_or(Vector3::zeros(), vector);
    let turn = node.get("rotation").map_or(UnitQuaternion::identity(), |turn| {
        quaternion(&[0, 1, 2, 3].map(|part| turn[part].as_f64().unwrap()))
    });
    Isometry3::from_parts(place.into(), turn)
}

/// x, y, z, w.
fn quaternion(parts: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(parts[3], parts[0], parts[1], parts[2]))
}

pub fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap()))
}

pub fn number(value: &Value) -> usize {
    value.as_u64().unwrap_or(0) as usize
}

//! A document of glTF as it grows: JSON and the numbers that it points to, in one binary file.

use std::borrow::Cow;

use gltf::binary::{Glb, Header};
use gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use gltf::json::buffer::{Target, View};
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Accessor, Buffer, Extras, Index, Root, Value};
use serde_json::json;
use serde_json::value::to_raw_value;

/// What a buffer begins at multiples of.
const BLOCK: usize = 4;

/// A document and its numbers.
pub struct Document {
    pub root: Root,
    bytes: Vec<u8>,
}

/// Numbers that an accessor reads.
pub struct Numbers {
    bytes: Vec<u8>,
    count: usize,
    component: ComponentType,
    kind: Type,
    /// Of each component from the least to the greatest.
    bounds: Option<[Value; 2]>,
}

impl Document {
    pub fn new() -> Self {
        let mut root = Root::default();
        root.asset.version = "2.0".to_owned();
        root.asset.generator = Some(format!("flexair {}", env!("CARGO_PKG_VERSION")));
        Document { root, bytes: Vec::new() }
    }

    /// Begins a block, to which numbers are added until the next one.
    pub fn begin(&mut self, target: Option<Target>) {
        self.bytes.resize(self.bytes.len().next_multiple_of(BLOCK), 0);
        self.root.push(View {
            buffer: Index::new(0),
            byte_length: USize64(0),
            byte_offset: Some(USize64::from(self.bytes.len())),
            byte_stride: None,
            name: None,
            target: target.map(Checked::Valid),
            extensions: None,
            extras: None,
        });
    }

    /// Numbers in the block that was begun last.
    pub fn add(&mut self, numbers: Numbers) -> Index<Accessor> {
        let place = self.root.buffer_views.len() - 1;
        let view = &mut self.root.buffer_views[place];
        let begin = view.byte_offset.map_or(0, |offset| offset.0) as usize;
        self.bytes.resize(self.bytes.len().next_multiple_of(BLOCK), 0);
        let offset = self.bytes.len() - begin;
        self.bytes.extend(numbers.bytes);
        view.byte_length = USize64::from(self.bytes.len() - begin);
        let [min, max] = numbers.bounds.map_or([None, None], |bounds| bounds.map(Some));
        self.root.push(Accessor {
            buffer_view: Some(Index::new(place as u32)),
            byte_offset: Some(USize64::from(offset)),
            count: USize64::from(numbers.count),
            component_type: Checked::Valid(GenericComponentType(numbers.component)),
            type_: Checked::Valid(numbers.kind),
            min,
            max,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: None,
        })
    }

    /// Numbers in a block of their own.
    pub fn add_alone(&mut self, numbers: Numbers, target: Option<Target>) -> Index<Accessor> {
        self.begin(target);
        self.add(numbers)
    }

    /// As a file.
    pub fn file(mut self) -> Vec<u8> {
        self.root.push(Buffer {
            byte_length: USize64::from(self.bytes.len()),
            name: None,
            uri: None,
            extensions: None,
            extras: None,
        });
        // PROOF: all keys are text, and memory takes every byte.
        let json = self.root.to_vec().expect("a document becomes text");
        let header = Header { magic: *b"glTF", version: 2, length: 0 };
        let glb = Glb { header, json: Cow::Owned(json), bin: Some(Cow::Owned(self.bytes)) };
        // PROOF: as above.
        glb.to_vec().expect("writing to memory succeeds")
    }
}

impl Numbers {
    /// With their least and greatest.
    pub fn vectors(vectors: &[[f32; 3]]) -> Self {
        let bound = |better: fn(f32, f32) -> f32| {
            let best =
                vectors.iter().copied().reduce(|one, other| [0, 1, 2].map(|i| better(one[i], other[i])));
            json!(best.unwrap_or_default())
        };
        let bounds = Some([bound(f32::min), bound(f32::max)]);
        Numbers { bounds, ..Numbers::floats(vectors, Type::Vec3) }
    }

    pub fn quaternions(quaternions: &[[f32; 4]]) -> Self {
        Numbers::floats(quaternions, Type::Vec4)
    }

    /// Column by column.
    pub fn matrices(matrices: &[[f32; 16]]) -> Self {
        Numbers::floats(matrices, Type::Mat4)
    }

    /// Ascending times, s.
    pub fn times(times: &[f32]) -> Self {
        let ends = [times.first(), times.last()].map(|end| json!([end.copied().unwrap_or(0.0)]));
        let rows: Vec<[f32; 1]> = times.iter().map(|&time| [time]).collect();
        Numbers { bounds: Some(ends), ..Numbers::floats(&rows, Type::Scalar) }
    }

    /// Places of vertices.
    pub fn indices(indices: &[[u32; 3]]) -> Self {
        Numbers {
            bytes: indices.iter().flatten().flat_map(|index| index.to_le_bytes()).collect(),
            count: 3 * indices.len(),
            component: ComponentType::U32,
            kind: Type::Scalar,
            bounds: None,
        }
    }

    /// The joint on which each of some vertices hangs alone.
    pub fn joints(joints: impl Iterator<Item = usize>) -> Self {
        let bytes: Vec<u8> =
            joints.flat_map(|joint| [joint as u16, 0, 0, 0]).flat_map(u16::to_le_bytes).collect();
        let count = bytes.len() / 8;
        Numbers { bytes, count, component: ComponentType::U16, kind: Type::Vec4, bounds: None }
    }

    fn floats<const N: usize>(rows: &[[f32; N]], kind: Type) -> Self {
        Numbers {
            bytes: rows.iter().flatten().flat_map(|number| number.to_le_bytes()).collect(),
            count: rows.len(),
            component: ComponentType::F32,
            kind,
            bounds: None,
        }
    }
}

/// What stands beside an element for whoever reads it.
pub fn extras(value: &Value) -> Extras {
    // PROOF: all keys are text.
    Some(to_raw_value(value).expect("a value becomes text"))
}

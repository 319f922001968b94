//! Shows as animations: each joint as it was recorded, flaps as their controls turn them, the whole aircraft on the root.

use gltf::json::animation::{Channel, Interpolation, Property, Sampler, Target};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Animation, Index, Node};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::json;

use super::super::recording::{POSE, Recording};
use super::super::show::Show;
use super::axes;
use super::document::{Document, Numbers, extras};
use super::joints::Joints;
use super::rig::Skeleton;

/// An animation as it grows.
struct Film<'d> {
    document: &'d mut Document,
    channels: Vec<Channel>,
    samplers: Vec<Sampler>,
    /// Of all frames.
    times: Index<Accessor>,
    /// Of the first alone, where something stays.
    begin: Option<Index<Accessor>>,
}

/// Adds the animation of a show, which begins at 0 s.
pub fn add(document: &mut Document, show: &Show, joints: &Joints<'_>, skeleton: &Skeleton) {
    let recording = &show.recording;
    let times: Vec<f32> = (0..recording.frames).map(|frame| (frame as f64 * show.step) as f32).collect();
    document.begin(None);
    let times = document.add(Numbers::times(&times));
    let mut film = Film { document, channels: Vec::new(), samplers: Vec::new(), times, begin: None };
    film.add_root(recording, skeleton.root);
    film.add_sections(recording, joints, skeleton);
    film.add_flaps(recording, joints, skeleton);
    let Film { channels, samplers, .. } = film;
    document.root.push(Animation {
        channels,
        samplers,
        name: Some(show.name.clone()),
        extensions: None,
        extras: extras(&json!({
            "kind": show.kind.name(),
            "level": show.level,
            "start": show.start,
            "loops": show.loops,
            "facts": show.facts,
        })),
    });
}

impl Film<'_> {
    /// The whole aircraft, from where O is in the first frame: always all frames, as an animation needs some.
    fn add_root(&mut self, recording: &Recording, root: Index<Node>) {
        let origin = vector(&recording.body);
        let poses = || recording.body.chunks_exact(POSE);
        let places: Vec<[f32; 3]> = poses().map(|pose| axes::vector(&(vector(pose) - origin))).collect();
        let turns: Vec<[f32; 4]> = poses().map(|pose| axes::quaternion(&turn(&pose[3..]))).collect();
        self.push((root, Property::Translation), Numbers::vectors(&places), self.times);
        self.push((root, Property::Rotation), Numbers::quaternions(&turns), self.times);
    }

    fn add_sections(&mut self, recording: &Recording, joints: &Joints<'_>, skeleton: &Skeleton) {
        let sections = &joints.airframe.sections;
        for (section, (rest, &node)) in sections.iter().zip(&skeleton.joints).enumerate() {
            let poses = || {
                let frames = recording.poses.chunks_exact(POSE * sections.len());
                frames.map(|frame| &frame[POSE * section..][..POSE])
            };
            let places: Vec<[f32; 3]> = poses().map(|pose| axes::vector(&vector(pose))).collect();
            let turns: Vec<[f32; 4]> = poses().map(|pose| axes::quaternion(&turn(&pose[3..]))).collect();
            let rest = axes::vector(&rest.position);
            self.add((node, Property::Translation), (&places, rest), Numbers::vectors);
            self.add_turns(node, &turns);
        }
    }

    fn add_flaps(&mut self, recording: &Recording, joints: &Joints<'_>, skeleton: &Skeleton) {
        let controls = joints.airframe.aircraft.controls.len().max(1);
        let nodes = &skeleton.joints[joints.airframe.sections.len()..];
        for (joint, &node) in joints.flaps.iter().zip(nodes) {
            let frames = recording.controls.chunks_exact(controls);
            let turn = |angles| UnitQuaternion::from_scaled_axis(joint.flap.axis * joint.flap.angle(angles));
            let turns: Vec<[f32; 4]> = frames.map(|angles| axes::quaternion(&turn(angles))).collect();
            self.add_turns(node, &turns);
        }
    }

    fn add_turns(&mut self, node: Index<Node>, turns: &[[f32; 4]]) {
        self.add((node, Property::Rotation), (turns, [0.0, 0.0, 0.0, 1.0]), Numbers::quaternions);
    }

    /// Adds what a node does; nothing where it rests, one frame where it stays.
    fn add<const N: usize>(
        &mut self,
        target: (Index<Node>, Property),
        (values, rest): (&[[f32; N]], [f32; N]),
        numbers: fn(&[[f32; N]]) -> Numbers,
    ) {
        let Some(first) = values.first() else { return };
        if values.iter().any(|value| value != first) {
            self.push(target, numbers(values), self.times);
        } else if *first != rest {
            let document = &mut *self.document;
            let begin = *self.begin.get_or_insert_with(|| document.add(Numbers::times(&[0.0])));
            self.push(target, numbers(&values[..1]), begin);
        }
    }

    fn push(&mut self, (node, path): (Index<Node>, Property), numbers: Numbers, times: Index<Accessor>) {
        let sampler = Index::new(self.samplers.len() as u32);
        self.samplers.push(Sampler {
            input: times,
            output: self.document.add(numbers),
            interpolation: Checked::Valid(Interpolation::Linear),
            extensions: None,
            extras: None,
        });
        let target = Target { node, path: Checked::Valid(path), extensions: None, extras: None };
        self.channels.push(Channel { sampler, target, extensions: None, extras: None });
    }
}

fn vector(parts: &[f64]) -> Vector3<f64> {
    Vector3::new(parts[0], parts[1], parts[2])
}

fn turn(parts: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(parts[0], parts[1], parts[2], parts[3]))
}

//! The loops that joints close in the tree of beams [theory: structure.joints, section-loads.loops].

use super::branches::Branches;
use super::model::{Aircraft, Cut, Joint};

impl Aircraft {
    /// Of each element whether it is part of a loop.
    pub fn elements_in_loops(&self) -> Vec<bool> {
        let mut within = vec![false; self.beams.len()];
        if !self.joints.is_empty() {
            let branches = Branches::of(self);
            let loops = self.joints.iter().flat_map(|joint| branches.between(joint.nodes()));
            for node in loops {
                within
                    .iter_mut()
                    .zip(&self.beams)
                    .filter(|(_, beam)| beam.nodes[1] == node)
                    .for_each(|(on, _)| *on = true);
            }
        }
        within
    }

    /// The joint that closes a loop through which a cut goes, if one does: summation has no unique answer there.
    pub(crate) fn loop_through(&self, cut: &Cut) -> Option<&Joint> {
        if self.joints.is_empty() {
            return None;
        }
        let branches = Branches::of(self);
        let last = self.beams[cut.attachment.beam].nodes[1];
        let ends_here = cut.attachment.fraction >= 1.0;
        let is_outboard = |node: usize| cut.outboard.iter().any(|&beam| self.beams[beam].nodes[1] == node);
        self.joints.iter().find(|joint| {
            let [one, other] = joint.nodes();
            is_outboard(one) != is_outboard(other)
                || (ends_here && branches.between([one, other]).contains(&last))
        })
    }

    /// Of each node which rotations each of its joints shares, in an order of theirs: what a node's image must have too.
    pub(crate) fn rotations_joined(&self) -> Vec<Vec<[bool; 3]>> {
        let mut joined = vec![Vec::new(); self.nodes.len()];
        for joint in &self.joints {
            joint.nodes().into_iter().for_each(|node| joined[node].push(joint.rotations));
        }
        joined.iter_mut().for_each(|rotations| rotations.sort_unstable());
        joined
    }

    /// Whether the image of a joint is a joint, given those of nodes.
    pub(crate) fn is_mirrored(&self, joint: &Joint, images: &[Option<usize>]) -> bool {
        let [Some(one), Some(other)] = joint.nodes().map(|node| images[node]) else { return false };
        let is_image = |joint: &&Joint| {
            let nodes = joint.nodes();
            nodes == [one, other] || nodes == [other, one]
        };
        self.joints.iter().filter(is_image).any(|image| image.rotations == joint.rotations)
    }
}

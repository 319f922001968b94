//! Nodal unknowns that joints make one: T of x = T y, before it is split by families [theory: structure.joints].

use crate::aircraft::Aircraft;

/// Of all unknowns, six at each node and those of the clamped one first, which are equal by joints.
pub(super) struct SharedUnknowns {
    /// The first of those that each is equal to: itself without joints.
    first: Vec<usize>,
}

/// Unknowns that are one number, without those of the clamped node: ascending.
pub(super) struct Shared {
    pub unknowns: Vec<usize>,
    /// Of each in a column of length 1.
    pub share: f64,
}

/// Six of the clamped node.
const CLAMPED: usize = 6;

impl SharedUnknowns {
    pub fn of(aircraft: &Aircraft) -> Self {
        let mut first: Vec<usize> = (0..6 * aircraft.nodes.len()).collect();
        for joint in &aircraft.joints {
            let [one, other] = joint.nodes();
            let axes = (0..3).chain((0..3).filter(|&axis| joint.rotations[axis]).map(|axis| 3 + axis));
            for axis in axes {
                let ends = [first[6 * one + axis], first[6 * other + axis]];
                let (kept, given_up) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
                first.iter_mut().filter(|unknown| **unknown == given_up).for_each(|unknown| *unknown = kept);
            }
        }
        SharedUnknowns { first }
    }

    /// The columns of T, by the unknowns in which they are not zero.
    pub fn columns(&self) -> Vec<Vec<(usize, f64)>> {
        let led =
            (1..self.first.len() / 6).flat_map(|node| (0..6).filter_map(move |axis| self.led_by(node, axis)));
        led.map(|shared| shared.column(1.0).collect()).collect()
    }

    /// The first of the unknowns that one of a node is equal to, by its number among those of all nodes.
    pub fn first(&self, node: usize, axis: usize) -> usize {
        self.first[6 * node + axis]
    }

    /// All that are equal to one of a node which is the first of them; `None` where it is not, or is at rest with O.
    pub fn led_by(&self, node: usize, axis: usize) -> Option<Shared> {
        let leader = 6 * node + axis;
        (self.first[leader] == leader && leader >= CLAMPED).then(|| self.of_first(leader))
    }

    /// All that are equal to a first one.
    pub fn of_first(&self, leader: usize) -> Shared {
        let equal = (leader..self.first.len()).filter(|&unknown| self.first[unknown] == leader);
        let unknowns: Vec<usize> = equal.map(|unknown| unknown - CLAMPED).collect();
        let share = 1.0 / (unknowns.len() as f64).sqrt();
        Shared { unknowns, share }
    }
}

impl Shared {
    /// A column of T, or its part on one side: all of them with this part of their share.
    pub fn column(&self, part: f64) -> impl Iterator<Item = (usize, f64)> {
        self.unknowns.iter().map(move |&unknown| (unknown, part * self.share))
    }
}

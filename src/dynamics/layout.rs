//! The layout of the state vector: nobody else computes an index.

use std::ops::Range;

use crate::lanes::LANES;

/// Where each part of the state stands: position, attitude quaternion, v, ω, q, q̇, inflow group by group of
/// four strips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateLayout {
    modes: usize,
    strip_groups: usize,
    inflow_states: usize,
}

impl StateLayout {
    /// Of `modes` generalised coordinates and groups of four strips with `inflow_states` each.
    pub fn new(modes: usize, strip_groups: usize, inflow_states: usize) -> Self {
        StateLayout { modes, strip_groups, inflow_states }
    }

    /// Number of states.
    pub fn len(&self) -> usize {
        self.inflow().end
    }

    /// A flight always has states.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Number of generalised coordinates in use.
    pub fn modes(&self) -> usize {
        self.modes
    }

    /// Length of ν = [v; ω; q̇].
    pub fn velocities(&self) -> usize {
        6 + self.modes
    }

    /// ρ: of O, north-east-down, m.
    pub fn position(&self) -> Range<usize> {
        0..3
    }

    /// Unit quaternion (scalar first) that turns body into inertial components.
    pub fn attitude(&self) -> Range<usize> {
        3..7
    }

    /// v: of O, body axes, m/s.
    pub fn velocity(&self) -> Range<usize> {
        7..10
    }

    /// ω, body axes, rad/s.
    pub fn rate(&self) -> Range<usize> {
        10..13
    }

    /// q.
    pub fn coordinates(&self) -> Range<usize> {
        13..13 + self.modes
    }

    /// q̇.
    pub fn coordinate_rates(&self) -> Range<usize> {
        13 + self.modes..13 + 2 * self.modes
    }

    /// η̃ of all strips, m/s.
    pub fn inflow(&self) -> Range<usize> {
        let start = 13 + 2 * self.modes;
        start..start + self.strip_groups * self.inflow_states * LANES
    }

    /// η̃ of one group of strips, state by state, m/s.
    pub fn group_inflow(&self, group: usize) -> Range<usize> {
        let numbers = self.inflow_states * LANES;
        let start = 13 + 2 * self.modes + group * numbers;
        start..start + numbers
    }

    /// The groups of states that share a unit, for error norms.
    pub fn groups(&self) -> [Range<usize>; 7] {
        [
            self.position(),
            self.attitude(),
            self.velocity(),
            self.rate(),
            self.coordinates(),
            self.coordinate_rates(),
            self.inflow(),
        ]
    }
}

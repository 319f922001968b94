//! The layout of the state vector: nobody else computes an index [theory: frames.state].

use std::ops::Range;

use crate::kinematics::velocities;
use crate::strips::InflowLayout;

/// Where each part of the state stands: first the inflow of all strips, so that each group's numbers begin where a
/// register fits; then position, attitude quaternion, v, ω, q, q̇.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateLayout {
    inflow: InflowLayout,
    modes: usize,
}

impl StateLayout {
    /// Of `modes` generalised coordinates and some inflow states.
    pub fn new(modes: usize, inflow: InflowLayout) -> Self {
        StateLayout { inflow, modes }
    }

    /// Number of states.
    pub fn len(&self) -> usize {
        self.coordinate_rates().end
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
        velocities(self.modes)
    }

    /// ν of a state. Allocates.
    pub fn velocities_of(&self, state: &[f64]) -> Vec<f64> {
        [self.velocity(), self.rate(), self.coordinate_rates()].map(|part| &state[part]).concat()
    }

    /// ρ: of O, north-east-down, m.
    pub fn position(&self) -> Range<usize> {
        let start = self.inflow().end;
        start..start + 3
    }

    /// Unit quaternion (scalar first) that turns body into inertial components.
    pub fn attitude(&self) -> Range<usize> {
        let start = self.position().end;
        start..start + 4
    }

    /// v: of O, body axes, m/s.
    pub fn velocity(&self) -> Range<usize> {
        let start = self.attitude().end;
        start..start + 3
    }

    /// ω, body axes, rad/s.
    pub fn rate(&self) -> Range<usize> {
        let start = self.velocity().end;
        start..start + 3
    }

    /// All of the rigid motion: position, attitude, v and ω.
    pub fn rigid(&self) -> Range<usize> {
        self.position().start..self.rate().end
    }

    /// q.
    #[inline(always)]
    pub fn coordinates(&self) -> Range<usize> {
        let start = self.rate().end;
        start..start + self.modes
    }

    /// q̇.
    #[inline(always)]
    pub fn coordinate_rates(&self) -> Range<usize> {
        let start = self.coordinates().end;
        start..start + self.modes
    }

    /// All but the inflow, in the same order in every layout of as many modes.
    pub fn structure(&self) -> Range<usize> {
        self.position().start..self.coordinate_rates().end
    }

    /// η̃ of all strips, m/s.
    pub fn inflow(&self) -> Range<usize> {
        self.inflow.all()
    }

    /// Where among the states, from the first on, the inflow of each strip stands.
    #[inline(always)]
    pub fn inflow_layout(&self) -> &InflowLayout {
        &self.inflow
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

//! The layout of the state vector: nobody else computes an index.

use std::ops::Range;

use crate::aerodynamics::InflowStates;
use crate::lanes::LANES;

/// Where each part of the state stands. First the inflow of groups of eight strips, so that each group's numbers begin
/// where a register fits: the real states of all groups, the real parts of their complex ones, the imaginary parts. Then
/// position, attitude quaternion, v, ω, q, q̇.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateLayout {
    modes: usize,
    strip_groups: usize,
    real_lags: usize,
    lag_pairs: usize,
}

/// The places of one group's inflow states, state by state and lane by lane.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroupInflow {
    /// Real states.
    pub real: Range<usize>,
    /// Real parts of the complex states.
    pub re: Range<usize>,
    /// Imaginary parts of the complex states.
    pub im: Range<usize>,
}

impl StateLayout {
    /// Of `modes` generalised coordinates and groups of eight strips, each strip with `real_lags` real and
    /// `lag_pairs` complex inflow states.
    pub fn new(modes: usize, strip_groups: usize, real_lags: usize, lag_pairs: usize) -> Self {
        StateLayout { modes, strip_groups, real_lags, lag_pairs }
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
        6 + self.modes
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
        self.inflow_real().start..self.inflow_im().end
    }

    /// The real states of all strips.
    #[inline(always)]
    pub fn inflow_real(&self) -> Range<usize> {
        0..self.strip_groups * self.real_lags * LANES
    }

    /// The real parts of the complex states of all strips.
    #[inline(always)]
    pub fn inflow_re(&self) -> Range<usize> {
        let start = self.inflow_real().end;
        start..start + self.strip_groups * self.lag_pairs * LANES
    }

    /// The imaginary parts of the complex states of all strips.
    #[inline(always)]
    pub fn inflow_im(&self) -> Range<usize> {
        let start = self.inflow_re().end;
        start..start + self.strip_groups * self.lag_pairs * LANES
    }

    /// η̃ of one group of strips.
    #[inline(always)]
    pub fn group_inflow(&self, group: usize) -> GroupInflow {
        let part = |range: Range<usize>, states: usize| {
            let start = range.start + group * states * LANES;
            start..start + states * LANES
        };
        GroupInflow {
            real: part(self.inflow_real(), self.real_lags),
            re: part(self.inflow_re(), self.lag_pairs),
            im: part(self.inflow_im(), self.lag_pairs),
        }
    }

    /// Places of η̃ of one strip: its real states, then real and imaginary part of each complex one.
    pub fn strip_inflow(&self, strip: usize) -> Vec<usize> {
        let GroupInflow { real, re, im } = self.group_inflow(strip / LANES);
        let lane = strip % LANES;
        let pairs = re.zip(im).skip(lane).step_by(LANES).flat_map(|(re, im)| [re, im]);
        real.skip(lane).step_by(LANES).chain(pairs).collect()
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

impl GroupInflow {
    /// The group's part of a state.
    #[inline(always)]
    pub fn read<'a>(&self, state: &'a [f64]) -> InflowStates<&'a [f64]> {
        InflowStates {
            real: &state[self.real.clone()],
            re: &state[self.re.clone()],
            im: &state[self.im.clone()],
        }
    }

    /// The group's part of a vector of the state's layout, to be written.
    #[inline(always)]
    pub fn write<'a>(&self, state: &'a mut [f64]) -> InflowStates<&'a mut [f64]> {
        let (before_im, im) = state.split_at_mut(self.im.start);
        let (before_re, re) = before_im.split_at_mut(self.re.start);
        InflowStates {
            real: &mut before_re[self.real.clone()],
            re: &mut re[..self.re.len()],
            im: &mut im[..self.im.len()],
        }
    }
}

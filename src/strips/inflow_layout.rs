//! Where the inflow states of all strips stand, in the order in which wide vectors read them.
//!
//! [theory: inflow.complex, frames.state]

use std::ops::Range;

use crate::math::LANES;

use super::inflow::InflowStates;

/// Places of the inflow states: the real states of all groups of eight strips, the real parts of their complex ones, the
/// imaginary parts. Each group's numbers begin where a register fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InflowLayout {
    groups: usize,
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

impl InflowLayout {
    /// Of groups of eight strips, each strip with `real_lags` real and `lag_pairs` complex inflow states.
    pub fn new(groups: usize, real_lags: usize, lag_pairs: usize) -> Self {
        InflowLayout { groups, real_lags, lag_pairs }
    }

    /// η̃ of all strips, m/s.
    pub fn all(&self) -> Range<usize> {
        self.real().start..self.im().end
    }

    /// The real states of all strips.
    #[inline(always)]
    pub fn real(&self) -> Range<usize> {
        0..self.groups * self.real_lags * LANES
    }

    /// The real parts of the complex states of all strips.
    #[inline(always)]
    pub fn re(&self) -> Range<usize> {
        let start = self.real().end;
        start..start + self.groups * self.lag_pairs * LANES
    }

    /// The imaginary parts of the complex states of all strips.
    #[inline(always)]
    pub fn im(&self) -> Range<usize> {
        let start = self.re().end;
        start..start + self.groups * self.lag_pairs * LANES
    }

    /// η̃ of one group of strips.
    #[inline(always)]
    pub fn of_group(&self, group: usize) -> GroupInflow {
        let part = |range: Range<usize>, states: usize| {
            let start = range.start + group * states * LANES;
            start..start + states * LANES
        };
        GroupInflow {
            real: part(self.real(), self.real_lags),
            re: part(self.re(), self.lag_pairs),
            im: part(self.im(), self.lag_pairs),
        }
    }

    /// Places of η̃ of one strip: its real states, then real and imaginary part of each complex one.
    pub fn of_strip(&self, strip: usize) -> Vec<usize> {
        let GroupInflow { real, re, im } = self.of_group(strip / LANES);
        let lane = strip % LANES;
        let pairs = re.zip(im).skip(lane).step_by(LANES).flat_map(|(re, im)| [re, im]);
        real.skip(lane).step_by(LANES).chain(pairs).collect()
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

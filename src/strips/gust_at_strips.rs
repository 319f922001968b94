//! What a frozen gust is at all strips at an instant [theory: gusts.chord].

use nalgebra::Vector3;

use crate::math::EightVectors;

/// What a gust is at eight strips, body axes, m/s.
#[derive(Clone, Debug)]
pub(crate) struct EightGusts {
    /// W̄.
    pub(crate) mean: EightVectors,
    /// W̄₁.
    pub(crate) change: EightVectors,
}

/// What a gust is at all strips at an instant.
#[derive(Clone, Debug)]
pub struct GustAtStrips {
    /// In groups of eight.
    pub(super) groups: Vec<EightGusts>,
    /// Those edge-on.
    pub(super) edge_on: Vec<EightGusts>,
}

impl GustAtStrips {
    /// Room for that at so many groups of strips, and of strips edge-on.
    pub fn new([groups, edge_on]: [usize; 2]) -> Self {
        let none = Vector3::zeros();
        let calm = || EightGusts {
            mean: EightVectors::of::<()>(&[], |()| none, none),
            change: EightVectors::of::<()>(&[], |()| none, none),
        };
        GustAtStrips {
            groups: (0..groups).map(|_| calm()).collect(),
            edge_on: (0..edge_on).map(|_| calm()).collect(),
        }
    }

    /// At a group of strips.
    #[inline(always)]
    pub(crate) fn of_group(&self, group: usize) -> &EightGusts {
        &self.groups[group]
    }

    /// At a group of strips edge-on.
    #[inline(always)]
    pub(crate) fn edge_on(&self, group: usize) -> &EightGusts {
        &self.edge_on[group]
    }
}

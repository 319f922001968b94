//! How the state of the half becomes that of the whole [theory: symmetry.unfolding].

use crate::equations::StateLayout;

use super::half::{Counterpart, SymmetricHalf};

/// For each place of the whole its source in the half and a sign; what has no source is at rest.
#[derive(Clone, Debug)]
pub(super) struct Unfolding {
    sources: Vec<Option<(usize, f64)>>,
}

impl Unfolding {
    /// From states of one layout, those of a half, to states of another, those of the whole.
    pub fn new(half: &SymmetricHalf, from: &StateLayout, to: &StateLayout) -> Self {
        let mut sources = vec![None; to.len()];
        for (place, source) in to.rigid().zip(from.rigid()) {
            sources[place] = Some((source, 1.0));
        }
        for (kept, &mode) in half.modes.iter().enumerate().take(from.modes()) {
            sources[to.coordinates().start + mode] = Some((from.coordinates().start + kept, 1.0));
            sources[to.coordinate_rates().start + mode] = Some((from.coordinate_rates().start + kept, 1.0));
        }
        for (strip, counterpart) in half.strips.iter().enumerate() {
            let Counterpart::Lifting { index, sign } = *counterpart else { continue };
            let places = to.inflow_layout().of_strip(strip).into_iter();
            for (place, source) in places.zip(from.inflow_layout().of_strip(index)) {
                sources[place] = Some((source, sign));
            }
        }
        Unfolding { sources }
    }

    /// To states of a layout that are all at rest.
    #[cfg(test)]
    pub fn at_rest(to: &StateLayout) -> Self {
        Unfolding { sources: vec![None; to.len()] }
    }

    /// Writes a state of the half as one of the whole.
    pub fn unfold(&self, half: &[f64], whole: &mut Vec<f64>) {
        let number = |source: &Option<(usize, f64)>| source.map_or(0.0, |(place, sign)| sign * half[place]);
        whole.clear();
        whole.extend(self.sources.iter().map(number));
    }
}

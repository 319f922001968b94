//! Every analysed airspeed with an unstable root, whether a crossing leads to it or not.

use nalgebra::Complex;

use super::condensed::Root;
use super::losses::EquilibriumLoss;
use super::points::UNSTABLE;
use super::tracks::{Analysed, Branch, Crossing};

/// Neighbouring analysed airspeeds at which a root is unstable.
#[derive(Clone, Debug, PartialEq)]
pub struct UnstableRange {
    /// The first of them, m/s.
    pub first: f64,
    /// The last of them, m/s.
    pub last: f64,
    /// Index of the branch; none for eigenvalues that no branch has reached.
    pub branch: Option<usize>,
    /// The eigenvalue at `first`, 1/s.
    pub at_first: Complex<f64>,
    /// The eigenvalue of greatest growth among them, 1/s.
    pub fastest: Complex<f64>,
    /// How it came to be unstable at `first`.
    pub onset: Onset,
}

/// How a root came to be unstable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Onset {
    /// It is so at the first airspeed analysed.
    FirstAnalysed,
    /// Airspeeds after this one, m/s, could not be analysed, and it is so at the next.
    AfterGap(f64),
    /// It crosses the stability limit at this airspeed, m/s.
    Crossing(f64),
    /// The equilibrium was lost at this airspeed, m/s.
    Loss(f64),
    /// It appears after this analysed airspeed, m/s, without a crossing that was found.
    Unseen(f64),
}

/// All ranges, by their first airspeed.
pub(super) fn ranges(
    analysed: &[Analysed],
    branches: &[Branch],
    crossings: &[Crossing],
    losses: &[EquilibriumLoss],
) -> Vec<UnstableRange> {
    let onset = |index: usize, branch: Option<usize>| {
        let Analysed { airspeed, after_gap, .. } = analysed[index];
        let Some(before) = index.checked_sub(1).map(|before| analysed[before].airspeed) else {
            return Onset::FirstAnalysed;
        };
        if after_gap {
            return Onset::AfterGap(before);
        }
        let is_here = |speed: f64| before <= speed && speed <= airspeed;
        let leads_here = |c: &&Crossing| c.is_onset && Some(c.branch) == branch && is_here(c.airspeed);
        let is_lost_here = |loss: &&EquilibriumLoss| is_here(loss.between[0]);
        if let Some(crossing) = crossings.iter().find(leads_here) {
            Onset::Crossing(crossing.airspeed)
        } else if let Some(loss) = losses.iter().find(is_lost_here) {
            Onset::Loss(loss.between[0])
        } else {
            Onset::Unseen(before)
        }
    };
    let mut ranges: Vec<UnstableRange> = Vec::new();
    let mut collect = |branch: Option<usize>, growths: &mut dyn Iterator<Item = Option<Complex<f64>>>| {
        let mut open: Option<UnstableRange> = None;
        for ((index, point), growth) in analysed.iter().enumerate().zip(growths) {
            if growth.is_none() || point.after_gap {
                ranges.extend(open.take());
            }
            let Some(eigenvalue) = growth else { continue };
            let range = open.get_or_insert_with(|| UnstableRange {
                first: point.airspeed,
                last: point.airspeed,
                branch,
                at_first: eigenvalue,
                fastest: eigenvalue,
                onset: onset(index, branch),
            });
            range.last = point.airspeed;
            if eigenvalue.re > range.fastest.re {
                range.fastest = eigenvalue;
            }
        }
        ranges.extend(open);
    };
    for (branch, Branch { roots }) in branches.iter().enumerate() {
        let unstable = |root: &Root| (root.eigenvalue.re > UNSTABLE).then_some(root.eigenvalue);
        collect(Some(branch), &mut roots.iter().map(|root| root.as_ref().and_then(unstable)));
    }
    let fastest = |point: &Analysed| point.unreached.iter().copied().max_by(|a, b| a.re.total_cmp(&b.re));
    collect(None, &mut analysed.iter().map(fastest));
    ranges.sort_by(|a, b| a.first.total_cmp(&b.first));
    ranges
}

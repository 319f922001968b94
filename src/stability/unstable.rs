//! Every analysed airspeed with an unstable root, whether a crossing leads to it or not [theory: stability.unstable].

use nalgebra::Complex;

use super::condensed::Root;
use super::losses::EquilibriumLoss;
use super::points::UNSTABLE;
use super::tracks::{Analysed, Branch, BranchEnd, Crossing};

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
    /// It begins to grow at this airspeed, m/s, where it leaves another root.
    Begins(f64),
    /// It appears after this analysed airspeed, m/s, without a crossing that was found.
    Unseen(f64),
}

/// What the ranges are made of.
pub(super) struct Findings<'a> {
    pub analysed: &'a [Analysed],
    pub branches: &'a [Branch],
    pub ends: &'a [BranchEnd],
    pub crossings: &'a [Crossing],
    pub losses: &'a [EquilibriumLoss],
}

impl Findings<'_> {
    /// All ranges, by their first airspeed.
    pub fn ranges(&self) -> Vec<UnstableRange> {
        let mut ranges = Vec::new();
        for (index, branch) in self.branches.iter().enumerate() {
            let unstable = |root: &Root| (root.eigenvalue.re > UNSTABLE).then_some(root.eigenvalue);
            let growths = branch.roots.iter().map(|root| root.as_ref().and_then(unstable));
            self.collect(Some(index), growths, &mut ranges);
        }
        let fastest = |at: &Analysed| at.unreached.iter().copied().max_by(|a, b| a.re.total_cmp(&b.re));
        self.collect(None, self.analysed.iter().map(fastest), &mut ranges);
        ranges.sort_by(|a, b| a.first.total_cmp(&b.first));
        ranges
    }

    /// The ranges of one branch, of which the unstable eigenvalue at each airspeed is given.
    fn collect(
        &self,
        branch: Option<usize>,
        eigenvalues: impl Iterator<Item = Option<Complex<f64>>>,
        ranges: &mut Vec<UnstableRange>,
    ) {
        let mut open: Option<UnstableRange> = None;
        for ((index, at), eigenvalue) in self.analysed.iter().enumerate().zip(eigenvalues) {
            if eigenvalue.is_none() || at.after_gap {
                ranges.extend(open.take());
            }
            let Some(eigenvalue) = eigenvalue else { continue };
            let range = open.get_or_insert_with(|| UnstableRange {
                first: at.airspeed,
                last: at.airspeed,
                branch,
                at_first: eigenvalue,
                fastest: eigenvalue,
                onset: self.onset(index, branch),
            });
            range.last = at.airspeed;
            if eigenvalue.re > range.fastest.re {
                range.fastest = eigenvalue;
            }
        }
        ranges.extend(open);
    }

    /// How a branch came to be unstable between an airspeed and the one before it.
    fn onset(&self, index: usize, branch: Option<usize>) -> Onset {
        let Analysed { airspeed, after_gap, .. } = self.analysed[index];
        let Some(before) = index.checked_sub(1).map(|before| self.analysed[before].airspeed) else {
            return Onset::FirstAnalysed;
        };
        if after_gap {
            return Onset::AfterGap(before);
        }
        let is_here = |speed: f64| before <= speed && speed <= airspeed;
        let leads_here = |c: &&Crossing| c.is_onset && Some(c.branch) == branch && is_here(c.airspeed);
        if let Some(crossing) = self.crossings.iter().find(leads_here) {
            Onset::Crossing(crossing.airspeed)
        } else if let Some(loss) = self.losses.iter().find(|loss| is_here(loss.between[0])) {
            Onset::Loss(loss.between[0])
        } else if let Some(end) =
            self.ends.iter().find(|end| Some(end.branch) == branch && end.interval + 1 == index)
        {
            Onset::Begins(end.last.airspeed)
        } else {
            Onset::Unseen(before)
        }
    }
}

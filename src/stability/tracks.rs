//! The branches of a sweep, as they are being followed from speed to speed.
//!
//! [theory: stability.branches, stability.crossings]
//!
//! At the first speed each root of the motion with its wake frozen is followed to the moving wake; these roots
//! (rigid motion and structure) are then followed from speed to speed. To miss none, all eigenvalues of the
//! whole state matrix are computed at each speed too: an unstable one that no branch has reached (divergence
//! often comes out of the wake's roots) begins a branch of its own, followed both ways.

use std::collections::VecDeque;
use std::sync::Arc;

use nalgebra::Complex;

use super::between::Between;
use super::condensed::{Condensed, Root};
use super::continuation::{Ended, follow};
use super::losses::{EquilibriumLoss, LossKind};
use super::points::{AnalysedSpeed, Motions, UNSTABLE};

/// Roots slower than this at a crossing do not oscillate, 1/s.
const STATIC: f64 = 1e-5;

/// Crossings are found to this relative accuracy.
const CROSSING_ACCURACY: f64 = 1e-7;

/// Largest step of a second try, where two branches came to the same root.
const CAREFUL_STEP: f64 = 1.0 / 32.0;

/// An eigenvalue that is no nearer than this to any root, relative to it, has been reached by none.
const REACHED: f64 = 1e-3;

/// Shapes on both sides of a gap that agree more than this are taken for those of one root.
const ALIKE: f64 = 0.9;

/// Numbers of the motions that are kept at hand, 256 MB of them, for branches that are followed back.
const KEPT_NUMBERS: usize = 1 << 25;

/// One root over the range.
#[derive(Clone, Debug)]
pub struct Branch {
    /// At each airspeed of the sweep; none where it has not begun or has ended: where a pair becomes two real
    /// roots, or two real roots a pair. Over airspeeds that were not analysed it goes on with the root of its shape.
    pub roots: Vec<Option<Root>>,
}

/// An airspeed at which a branch crosses the stability limit.
#[derive(Clone, Debug)]
pub struct Crossing {
    /// m/s.
    pub airspeed: f64,
    /// There.
    pub root: Root,
    /// Oscillating or static.
    pub kind: CrossingKind,
    /// Whether the branch is unstable above, not below.
    pub is_onset: bool,
    /// Index of the branch.
    pub branch: usize,
}

/// How an aircraft becomes unstable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingKind {
    /// A complex pair crosses the imaginary axis.
    Flutter,
    /// A real root goes through zero.
    Divergence,
}

/// An airspeed of the range, as far as the branches have come.
pub(super) struct Analysed {
    pub airspeed: f64,
    /// Whether the speed before it in the range was skipped, or is none.
    pub after_gap: bool,
    /// Unstable eigenvalues that no branch has reached, 1/s.
    pub unreached: Vec<Complex<f64>>,
}

/// The branches and what they have been followed over.
pub(super) struct Tracks<'a> {
    aircraft: Motions<'a>,
    pub branches: Vec<Branch>,
    pub analysed: Vec<Analysed>,
    /// The latest motions.
    problems: VecDeque<Arc<Condensed>>,
    /// The motions after the lower point of the interval in which a branch was followed last.
    between: Option<(usize, Between)>,
    /// Where branches begin or end within an interval.
    pub ends: Vec<BranchEnd>,
}

/// The last root of a branch that could be followed no further, because it meets or joins another one.
pub(super) struct BranchEnd {
    pub branch: usize,
    /// The lower one of the points between which it is.
    pub interval: usize,
    pub last: Place,
}

/// A root at an airspeed, m/s.
#[derive(Clone)]
pub(super) struct Place {
    pub airspeed: f64,
    pub root: Root,
}

impl<'a> Tracks<'a> {
    pub fn new(aircraft: Motions<'a>) -> Self {
        let (branches, analysed) = (Vec::new(), Vec::new());
        Tracks { aircraft, branches, analysed, problems: VecDeque::new(), between: None, ends: Vec::new() }
    }

    /// Follows the branches to the next point; `after_gap` when the speed before it was skipped, or is none.
    pub fn add(&mut self, point: &AnalysedSpeed, after_gap: bool) {
        let index = self.analysed.len();
        self.analysed.push(Analysed { airspeed: point.airspeed, after_gap, unreached: Vec::new() });
        self.problems.push_back(Arc::clone(&point.problem));
        while self.problems.len() > 2 && self.problems.len() * point.problem.numbers() > KEPT_NUMBERS {
            self.problems.pop_front();
        }
        for branch in &mut self.branches {
            branch.roots.push(None);
        }
        if after_gap {
            self.begin(index);
        } else {
            self.advance(index);
        }
        self.begin_unstable(index, &point.unstable);
        let unreached = point.unstable.iter().filter(|&&eigenvalue| !self.is_reached(index, eigenvalue));
        self.analysed[index].unreached = unreached.copied().collect();
    }

    /// The motion at a point, where it is still at hand.
    fn problem(&self, index: usize) -> Option<Arc<Condensed>> {
        let first = self.analysed.len() - self.problems.len();
        self.problems.get(index.checked_sub(first)?).cloned()
    }

    /// Begins a branch for each root of rigid motion and structure: from the frozen to the moving wake.
    fn begin(&mut self, index: usize) {
        let Some(problem) = self.problem(index) else { return };
        let mut reached: Vec<Root> = Vec::new();
        for frozen in problem.frozen_roots() {
            let path = |coupling| Some(Arc::new(problem.with_coupling(coupling)));
            let root = follow(&frozen, 1.0, path);
            reached.extend(root.ok().filter(|root| !reached.iter().any(|other| same(root, other))));
        }
        for root in reached {
            match self.alike(index, &root) {
                Some(branch) => self.branches[branch].roots[index] = Some(root),
                None => {
                    self.begin_branch(index, root);
                }
            }
        }
    }

    /// After a gap: the branch whose root before it has the shape of a root after it, if there is one.
    fn alike(&self, index: usize, root: &Root) -> Option<usize> {
        let before = index.checked_sub(1)?;
        let free = self.branches.iter().enumerate().filter(|(_, branch)| branch.roots[index].is_none());
        let problem = self.problem(index)?;
        let agreements = free.filter_map(|(place, branch)| {
            Some((place, problem.agreement(branch.roots[before].as_ref()?, root)))
        });
        let (place, agreement) = agreements.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (agreement > ALIKE).then_some(place)
    }

    /// Continues all branches from the point before; where two come to the same root, with small steps.
    fn advance(&mut self, index: usize) {
        let present: Vec<Option<Root>> =
            self.branches.iter().map(|branch| branch.roots[index - 1].clone()).collect();
        let step = |tracks: &mut Self, root: &Option<Root>, largest| {
            root.as_ref().map(|root| tracks.step(root, (index - 1, index), largest))
        };
        let next: Vec<_> = present.iter().map(|root| step(self, root, 1.0)).collect();
        for (branch, followed) in next.iter().enumerate() {
            let meets = |other: usize| match (followed, &next[other]) {
                (Some(Ok(root)), Some(Ok(other))) => same(root, other),
                _ => false,
            };
            let is_shared = (0..next.len()).any(|other| other != branch && meets(other));
            let followed =
                if is_shared { step(self, &present[branch], CAREFUL_STEP) } else { followed.clone() };
            match followed {
                Some(Ok(root)) => self.branches[branch].roots[index] = Some(root),
                Some(Err(last)) => self.ends.push(BranchEnd { branch, interval: index - 1, last }),
                None => {}
            }
        }
    }

    /// Begins a branch at each unstable eigenvalue that none has reached, and follows it back.
    fn begin_unstable(&mut self, index: usize, unstable: &[Complex<f64>]) {
        let Some(problem) = self.problem(index) else { return };
        for &eigenvalue in unstable {
            let reached: Vec<Root> =
                self.branches.iter().filter_map(|branch| branch.roots[index].clone()).collect();
            let shared = reached.iter().filter(|root| root.is_at(eigenvalue)).count();
            let multiplicity = unstable.iter().filter(|&&other| near(other, eigenvalue)).count();
            if shared >= multiplicity {
                continue;
            }
            if let Some(root) = problem.root_at(eigenvalue, &reached) {
                let branch = self.begin_branch(index, root);
                self.follow_back(branch, index);
            }
        }
    }

    /// Follows a branch to lower speeds, until it ends or joins another.
    fn follow_back(&mut self, branch: usize, begin: usize) {
        for index in (0..begin).rev() {
            if self.analysed[index + 1].after_gap {
                return;
            }
            let Some(root) = self.branches[branch].roots[index + 1].clone() else { return };
            let mut followed = self.step(&root, (index + 1, index), 1.0);
            if followed.as_ref().is_ok_and(|root| self.has(index, root)) {
                followed = self.step(&root, (index + 1, index), CAREFUL_STEP);
            }
            let last = match followed {
                Ok(root) if self.has(index, &root) => Place { airspeed: self.analysed[index].airspeed, root },
                Ok(root) => {
                    self.branches[branch].roots[index] = Some(root);
                    continue;
                }
                Err(last) => last,
            };
            return self.ends.push(BranchEnd { branch, interval: index, last });
        }
    }

    /// Whether some branch has this root at a point.
    fn has(&self, index: usize, root: &Root) -> bool {
        self.branches.iter().filter_map(|branch| branch.roots[index].as_ref()).any(|other| same(root, other))
    }

    fn begin_branch(&mut self, index: usize, root: Root) -> usize {
        let mut roots = vec![None; self.analysed.len()];
        roots[index] = Some(root);
        self.branches.push(Branch { roots });
        self.branches.len() - 1
    }

    fn is_reached(&self, index: usize, eigenvalue: Complex<f64>) -> bool {
        let is_it = |root: &Root| {
            root.is_at(eigenvalue) || (root.eigenvalue - eigenvalue).norm() <= REACHED * eigenvalue.norm()
        };
        self.branches.iter().filter_map(|branch| branch.roots[index].as_ref()).any(is_it)
    }

    /// Follows a root from one point to the next or the one before; where it ends on the way, to there.
    fn step(&mut self, root: &Root, (from, to): (usize, usize), largest_step: f64) -> Result<Root, Place> {
        let interval = from.min(to);
        let last = self.between.take().filter(|(other, _)| *other == interval);
        let (_, mut between) = last.unwrap_or_else(|| {
            let points = [interval, interval + 1];
            let ends = points.map(|index| self.problem(index));
            (interval, Between::new(points.map(|index| self.analysed[index].airspeed), ends))
        });
        let path = |place: f64| between.at(if from < to { place } else { 1.0 - place }, self.aircraft);
        let followed = follow(root, largest_step, path);
        self.between = Some((interval, between));
        let [begin, end] = [from, to].map(|index| self.analysed[index].airspeed);
        followed.map_err(|Ended { place, root }| Place { airspeed: begin + place * (end - begin), root })
    }

    /// Where branches change their stability, by airspeed. Where the equilibrium jumps, roots cross nothing.
    pub fn crossings(&self, losses: &[EquilibriumLoss]) -> Vec<Crossing> {
        let jumps = losses.iter().filter(|loss| matches!(loss.kind, LossKind::Jump { .. }));
        let jumps: Vec<[f64; 2]> = jumps.map(|loss| loss.between).collect();
        let mut crossings = Vec::new();
        for (branch, interval) in
            (0..self.branches.len()).flat_map(|b| (1..self.analysed.len()).map(move |i| (b, i - 1)))
        {
            let Some([below, above]) = self.both_sides(branch, interval) else { continue };
            let is_onset = is_unstable(&above.root);
            if is_unstable(&below.root) == is_onset {
                continue;
            }
            let Some(Place { airspeed, root }) = self.bisect(below, above) else { continue };
            let slack = CROSSING_ACCURACY * airspeed;
            if jumps.iter().any(|[low, high]| low - slack <= airspeed && airspeed <= high + slack) {
                continue;
            }
            let is_static = root.eigenvalue.im.abs() < STATIC;
            let kind = if is_static { CrossingKind::Divergence } else { CrossingKind::Flutter };
            crossings.push(Crossing { airspeed, root, kind, is_onset, branch });
        }
        crossings.sort_by(|a, b| a.airspeed.total_cmp(&b.airspeed));
        // A branch that joins another one may have a crossing of that.
        crossings.dedup_by(|later, earlier| {
            later.airspeed - earlier.airspeed <= CROSSING_ACCURACY * later.airspeed
                && later.is_onset == earlier.is_onset
                && near(later.root.eigenvalue, earlier.root.eigenvalue)
        });
        crossings
    }

    /// The lowest and the highest place of a branch in an interval; none where it is not in it, or where what is between was not analysed.
    fn both_sides(&self, branch: usize, interval: usize) -> Option<[Place; 2]> {
        let points = &self.analysed[interval..interval + 2];
        if points[1].after_gap {
            return None;
        }
        let roots = &self.branches[branch].roots[interval..interval + 2];
        let place = |side: usize| {
            let airspeed = points[side].airspeed;
            roots[side].clone().map(|root| Place { airspeed, root })
        };
        let is_here = |end: &&BranchEnd| end.branch == branch && end.interval == interval;
        let end = || self.ends.iter().find(is_here).map(|end| end.last.clone());
        match [place(0), place(1)] {
            [Some(below), Some(above)] => Some([below, above]),
            [Some(below), None] => Some([below, end()?]),
            [None, Some(above)] => Some([end()?, above]),
            [None, None] => None,
        }
    }

    /// Halves an interval around a crossing, of which the roots at both ends are known. Near an end another root may be so close that
    /// this one is lost to it from there: of what is reached from both ends, that counts whose growth is nearest to their mean. Where nothing is
    /// reached, as between two real roots and the pair that they become, the crossing is looked for on the unstable side. None where it is not
    /// there, or a trim is missing.
    fn bisect(&self, mut below: Place, mut above: Place) -> Option<Place> {
        let ends_unstable = is_unstable(&above.root);
        let mut is_enclosed = true;
        while above.airspeed - below.airspeed > CROSSING_ACCURACY * above.airspeed {
            let airspeed = 0.5 * (below.airspeed + above.airspeed);
            let problem = self.aircraft.problem(airspeed)?;
            let reached = self.reached_between([&below, &above], airspeed, &problem);
            let becomes_above = reached.as_ref().is_some_and(is_unstable) == ends_unstable;
            let half = if becomes_above { &mut above } else { &mut below };
            if !reached.as_ref().is_some_and(is_unstable) {
                is_enclosed = reached.is_some();
            }
            *half = Place { airspeed, root: reached.unwrap_or_else(|| half.root.clone()) };
        }
        is_enclosed.then_some(below)
    }

    /// The root of the motion at an airspeed between two others, followed from both.
    fn reached_between(&self, ends: [&Place; 2], at: f64, problem: &Arc<Condensed>) -> Option<Root> {
        let from = |Place { airspeed, root }: &Place| {
            let path = |place| match place {
                1.0 => Some(Arc::clone(problem)),
                _ => self.aircraft.problem(airspeed + place * (at - airspeed)),
            };
            follow(root, 1.0, path).ok()
        };
        let mean = ends.iter().map(|end| end.root.eigenvalue.re).sum::<f64>() / 2.0;
        let off = |root: &Root| (root.eigenvalue.re - mean).abs();
        ends.into_iter().filter_map(from).min_by(|one, other| off(one).total_cmp(&off(other)))
    }
}

fn is_unstable(root: &Root) -> bool {
    root.eigenvalue.re > UNSTABLE
}

/// Whether two roots are one: eigenvalue and shape.
fn same(one: &Root, other: &Root) -> bool {
    one.is_at(other.eigenvalue) && one.shape.dotc(&other.shape).norm_sqr() > 0.5
}

fn near(one: Complex<f64>, other: Complex<f64>) -> bool {
    (one - other).norm() <= 1e-6 * (1.0 + other.norm())
}

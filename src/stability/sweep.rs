//! All roots of an aircraft over a range of airspeeds, and where they become unstable.
//!
//! At the first speed each root of the motion with its wake frozen is followed to the moving wake; these roots
//! (rigid motion and structure) are then followed from speed to speed. To miss none, all eigenvalues of the
//! whole state matrix are computed at each speed too: an unstable one that no branch has reached (divergence
//! often comes out of the wake's roots) begins a branch of its own, followed both ways.
//!
//! **Caveat.** A root that is unstable only between two neighbouring speeds of the range is not noticed.

use std::collections::HashMap;
use std::sync::Arc;
use std::thread;

use nalgebra::Complex;

use crate::dynamics::{EigenvaluesNotFound, StateMatrix, Unknown};
use crate::simulation::{Settings, SimulationError};
use crate::structure::ReducedModel;

use super::condensed::{Condensed, Root};
use super::continuation::follow;

/// Growth that counts as unstable, 1/s: above the rounding of eigenvalues that are zero. The height of a free
/// aircraft has one, for at the same dynamic pressure it is in trim at any height; so has an undamped mode.
const UNSTABLE: f64 = 1e-6;

/// Roots slower than this at a crossing do not oscillate, 1/s.
const STATIC: f64 = 1e-5;

/// Crossings are found to this relative accuracy.
const CROSSING_ACCURACY: f64 = 1e-7;

/// Largest step of a second try, where two branches came to the same root.
const CAREFUL_STEP: f64 = 1.0 / 32.0;

/// The roots of an aircraft over a range of airspeeds.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Ascending airspeeds at which the aircraft is trimmed, m/s.
    pub airspeeds: Vec<f64>,
    /// The speeds of the range that are missing there.
    pub skipped: Vec<Skipped>,
    /// What each component of a root's shape is.
    pub unknowns: Vec<Unknown>,
    /// The roots, each followed over the range.
    pub branches: Vec<Branch>,
    /// Where branches become unstable or stable again, by airspeed.
    pub crossings: Vec<Crossing>,
}

/// One root over the range.
#[derive(Clone, Debug)]
pub struct Branch {
    /// At each airspeed of the sweep; none where it has not begun or has ended: where a pair becomes two real
    /// roots, or two real roots a pair.
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

/// A speed of the range that could not be analysed.
#[derive(Clone, Debug, PartialEq)]
pub struct Skipped {
    /// m/s.
    pub airspeed: f64,
    /// Why.
    pub reason: SkipReason,
}

/// Why a speed could not be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SkipReason {
    /// There is no trim.
    #[error(transparent)]
    Trim(#[from] SimulationError),
    /// The eigensolver failed.
    #[error(transparent)]
    Eigenvalues(#[from] EigenvaluesNotFound),
}

impl Sweep {
    /// Follows the roots of a model under the settings over ascending airspeeds, which replace the settings'.
    ///
    /// # Errors
    /// When a setting is out of range. Speeds without trim are skipped.
    pub fn new(
        model: &ReducedModel,
        settings: &Settings,
        airspeeds: &[f64],
    ) -> Result<Self, SimulationError> {
        for &airspeed in airspeeds {
            Settings { airspeed, ..settings.clone() }.choose_modes(model)?;
        }
        let aircraft = Family { model, settings };
        let (mut points, mut skipped): (Vec<Point>, Vec<Skipped>) = (Vec::new(), Vec::new());
        let mut after_gap = true;
        for (point, &airspeed) in aircraft.points(airspeeds).into_iter().zip(airspeeds) {
            match point {
                Ok(point) => points.push(Point { after_gap, ..point }),
                Err(reason) => skipped.push(Skipped { airspeed, reason }),
            }
            after_gap = points.last().is_none_or(|point| point.airspeed != airspeed);
        }
        let mut tracks = Tracks::new(aircraft, &points);
        tracks.follow_all();
        let crossings = tracks.crossings();
        Ok(Sweep {
            airspeeds: points.iter().map(|point| point.airspeed).collect(),
            skipped,
            unknowns: points.first().map_or(Vec::new(), |point| point.unknowns.clone()),
            branches: tracks.branches,
            crossings,
        })
    }
}

/// The linearised motions of one aircraft, one for each airspeed.
#[derive(Clone, Copy)]
struct Family<'a> {
    model: &'a ReducedModel,
    settings: &'a Settings,
}

/// The motion at one airspeed of the range.
struct Point {
    airspeed: f64,
    problem: Arc<Condensed>,
    unknowns: Vec<Unknown>,
    /// One of each unstable pair.
    unstable: Vec<Complex<f64>>,
    /// Whether the speed before it in the range was skipped, or is none.
    after_gap: bool,
}

impl Family<'_> {
    fn state_matrix(&self, airspeed: f64) -> Result<StateMatrix, SimulationError> {
        let settings = Settings { airspeed, ..self.settings.clone() };
        let equations = settings.equations(self.model)?;
        let trim = equations.trim(&settings.trim_condition())?;
        Ok(equations.linearise(&trim))
    }

    /// The points of the range, computed side by side.
    fn points(&self, airspeeds: &[f64]) -> Vec<Result<Point, SkipReason>> {
        let workers = thread::available_parallelism().map_or(1, usize::from);
        let share = airspeeds.len().div_ceil(workers).max(1);
        let analyse = |part: &[f64]| part.iter().map(|&airspeed| self.point(airspeed)).collect::<Vec<_>>();
        thread::scope(|scope| {
            let parts: Vec<_> =
                airspeeds.chunks(share).map(|part| scope.spawn(move || analyse(part))).collect();
            let join = |part: thread::ScopedJoinHandle<'_, _>| {
                part.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            parts.into_iter().flat_map(join).collect()
        })
    }

    fn point(&self, airspeed: f64) -> Result<Point, SkipReason> {
        let matrix = self.state_matrix(airspeed)?;
        let mut unstable = matrix.eigenvalues()?;
        unstable.retain(|eigenvalue| eigenvalue.re > UNSTABLE && eigenvalue.im >= 0.0);
        let in_shape = |unknown: &&Unknown| !matches!(unknown, Unknown::Inflow { .. });
        Ok(Point {
            airspeed,
            problem: Arc::new(Condensed::new(&matrix)),
            unknowns: matrix.unknowns.iter().filter(in_shape).copied().collect(),
            unstable,
            after_gap: false,
        })
    }
}

/// The branches, as they are being followed.
struct Tracks<'a> {
    aircraft: Family<'a>,
    points: &'a [Point],
    branches: Vec<Branch>,
    /// Problems at speeds between the points of the present interval, by the bits of the airspeed.
    between: HashMap<u64, Option<Arc<Condensed>>>,
}

impl<'a> Tracks<'a> {
    fn new(aircraft: Family<'a>, points: &'a [Point]) -> Self {
        Tracks { aircraft, points, branches: Vec::new(), between: HashMap::new() }
    }

    /// Goes through the range once.
    fn follow_all(&mut self) {
        for index in 0..self.points.len() {
            self.between.clear();
            if self.points[index].after_gap {
                self.begin(index);
            } else {
                self.advance(index);
            }
            self.begin_unstable(index);
        }
    }

    /// Begins a branch for each root of rigid motion and structure: from the frozen to the moving wake.
    fn begin(&mut self, index: usize) {
        let problem = &self.points[index].problem;
        let mut reached: Vec<Root> = Vec::new();
        for frozen in problem.frozen_roots() {
            let path = |coupling| Some(Arc::new(problem.with_coupling(coupling)));
            let root = follow(&frozen, 1.0, path);
            reached.extend(root.filter(|root| !reached.iter().any(|other| same(root, other))));
        }
        for root in reached {
            self.begin_branch(index, root);
        }
    }

    /// Continues all branches from the point before; where two come to the same root, with small steps.
    fn advance(&mut self, index: usize) {
        let present: Vec<Option<Root>> =
            self.branches.iter().map(|branch| branch.roots[index - 1].clone()).collect();
        let step = |tracks: &mut Self, root: &Option<Root>, largest| {
            root.as_ref().and_then(|root| tracks.step(root, (index - 1, index), largest))
        };
        let next: Vec<Option<Root>> = present.iter().map(|root| step(self, root, 1.0)).collect();
        for (branch, root) in next.iter().enumerate() {
            let meets = |other: usize| match (root, &next[other]) {
                (Some(root), Some(other)) => same(root, other),
                _ => false,
            };
            let is_shared = (0..next.len()).any(|other| other != branch && meets(other));
            let root = if is_shared { step(self, &present[branch], CAREFUL_STEP) } else { root.clone() };
            self.branches[branch].roots[index] = root;
        }
    }

    /// Begins a branch at each unstable eigenvalue that none has reached, and follows it back.
    fn begin_unstable(&mut self, index: usize) {
        let point = &self.points[index];
        for &eigenvalue in &point.unstable {
            let reached: Vec<Root> =
                self.branches.iter().filter_map(|branch| branch.roots[index].clone()).collect();
            let shared = reached.iter().filter(|root| root.is_at(eigenvalue)).count();
            let multiplicity = point.unstable.iter().filter(|&&other| near(other, eigenvalue)).count();
            if shared >= multiplicity {
                continue;
            }
            if let Some(root) = point.problem.root_at(eigenvalue, &reached) {
                let branch = self.begin_branch(index, root);
                self.follow_back(branch, index);
            }
        }
    }

    /// Follows a branch to lower speeds, until it ends or joins another.
    fn follow_back(&mut self, branch: usize, begin: usize) {
        for index in (0..begin).rev() {
            if self.points[index + 1].after_gap {
                return;
            }
            let Some(root) = self.branches[branch].roots[index + 1].clone() else { return };
            let Some(root) = self.step(&root, (index + 1, index), 1.0) else { return };
            let others = self.branches.iter().filter_map(|other| other.roots[index].as_ref());
            if others.into_iter().any(|other| same(&root, other)) {
                return;
            }
            self.branches[branch].roots[index] = Some(root);
        }
    }

    fn begin_branch(&mut self, index: usize, root: Root) -> usize {
        let mut roots = vec![None; self.points.len()];
        roots[index] = Some(root);
        self.branches.push(Branch { roots });
        self.branches.len() - 1
    }

    /// Follows a root from one point to another.
    fn step(&mut self, root: &Root, (from, to): (usize, usize), largest_step: f64) -> Option<Root> {
        let (from, to) = (&self.points[from], &self.points[to]);
        let width = to.airspeed - from.airspeed;
        let (aircraft, between) = (self.aircraft, &mut self.between);
        follow(root, largest_step, |place| {
            if place == 1.0 {
                return Some(Arc::clone(&to.problem));
            }
            let airspeed = from.airspeed + place * width;
            let problem = || Some(Arc::new(Condensed::new(&aircraft.state_matrix(airspeed).ok()?)));
            between.entry(airspeed.to_bits()).or_insert_with(problem).clone()
        })
    }

    /// Where branches change their stability, by airspeed.
    fn crossings(&self) -> Vec<Crossing> {
        let mut crossings = Vec::new();
        for (branch, Branch { roots }) in self.branches.iter().enumerate() {
            for (points, pair) in self.points.windows(2).zip(roots.windows(2)) {
                if let [Some(below), Some(above)] = pair
                    && is_unstable(below) != is_unstable(above)
                {
                    let (airspeed, root) = self.bisect([points[0].airspeed, points[1].airspeed], below);
                    let is_static = root.eigenvalue.im.abs() < STATIC;
                    let kind = if is_static { CrossingKind::Divergence } else { CrossingKind::Flutter };
                    crossings.push(Crossing { airspeed, root, kind, is_onset: is_unstable(above), branch });
                }
            }
        }
        crossings.sort_by(|a, b| a.airspeed.total_cmp(&b.airspeed));
        crossings
    }

    /// Halves an interval around a crossing, of which the root at the lower end is known.
    fn bisect(&self, [mut low, mut high]: [f64; 2], below: &Root) -> (f64, Root) {
        let mut root = below.clone();
        while high - low > CROSSING_ACCURACY * high {
            let middle = 0.5 * (low + high);
            let path = |place: f64| {
                let matrix = self.aircraft.state_matrix(low + place * (middle - low)).ok()?;
                Some(Arc::new(Condensed::new(&matrix)))
            };
            match follow(&root, 1.0, path) {
                Some(next) if is_unstable(&next) == is_unstable(below) => (low, root) = (middle, next),
                Some(_) => high = middle,
                None => break,
            }
        }
        (low, root)
    }
}

fn is_unstable(root: &Root) -> bool {
    root.eigenvalue.re > UNSTABLE
}

/// Whether two roots are one: eigenvalue and shape.
fn same(one: &Root, other: &Root) -> bool {
    one.is_at(other.eigenvalue) && one.agreement(other) > 0.5
}

fn near(one: Complex<f64>, other: Complex<f64>) -> bool {
    (one - other).norm() <= 1e-6 * (1.0 + other.norm())
}

//! The modes of an aircraft in flight with their names: phugoid, short period, Dutch roll, roll, spiral, those of the structure.
//!
//! [theory: stability.modes]
//!
//! In the whole motion the inflow takes so large a part in every mode that what leads it does not tell the mode. With an
//! inflow that follows the motion at once it does: there modes get their names, and from there each is followed to the inflow as it
//! is. What comes to other roots from the side of a frozen wake are modes too. A rigid mode that is among neither, for its root is one of the
//! wake's own, is given as it was before, and marked.
//! From one flight to the next, as into a turn, names go with the modes that are most alike.

use std::sync::Arc;

use nalgebra::{Complex, DVector};

use crate::plant::{StateMatrix, Unknown};

use super::condensed::{Condensed, Root};
use super::continuation::follow;
use super::mode_names::{self, FlightModeKind, FlightModeName, Portrait, kinds, names};

/// Largest step from an inflow that follows the motion at once, ε = 0, to that as it is, ε = 1, of the root of ε.
const LARGEST_STEP: f64 = 0.25;

/// A mode in which the motion takes part less than this is one of the wake's own.
const LOST: f64 = 0.02;

/// Eigenvalues are told apart in proportion to this and their size, 1/s.
const SLOW: f64 = 0.05;

/// Modes of two flights that are at least so far apart are not one.
const UNLIKE: f64 = 1.0;

/// A mode of an aircraft in flight.
#[derive(Clone, Debug, PartialEq)]
pub struct FlightMode {
    /// What it is called.
    pub name: FlightModeName,
    /// Its eigenvalue, the upper one of a pair, and its shape.
    pub root: Root,
    /// Whether the eigenvalue is that of an inflow that follows the motion at once, for with its own the mode is lost among the
    /// wake's.
    pub is_quasi_steady: bool,
    /// How much each unknown of the motion takes part: |w_i v_i| of the left and right eigenvector, 1 in sum with those of the inflow.
    pub participations: Vec<f64>,
    /// How much of the rigid motion that takes part is aside, from 0 (symmetric) to 1; none where none takes part.
    pub share_aside: Option<f64>,
    /// The left eigenvector's part of the motion, by which modes of two flights are compared.
    left: DVector<Complex<f64>>,
}

impl FlightMode {
    /// λ, 1/s, the upper one of a pair.
    pub fn eigenvalue(&self) -> Complex<f64> {
        self.root.eigenvalue
    }
}

/// The modes of an aircraft in a trim, slowest first.
///
/// ```
/// use flexible_aircraft::equations::Fidelity;
/// use flexible_aircraft::plant::{Plant, PlantSettings};
/// use flexible_aircraft::stability::FlightModes;
/// # use flexible_aircraft::Aircraft;
///
/// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
/// let settings = PlantSettings { fidelity: Fidelity::Rigid, ..PlantSettings::of(&jet) };
/// let plant = Plant::under(&jet, &settings)?;
/// let trim = plant.trim(&settings.trim_condition())?;
/// let modes = FlightModes::new(&plant.linearise(&trim));
/// let phugoid = modes.named("phugoid").ok_or("the jet has one")?;
/// assert!((phugoid.eigenvalue().im - 0.114).abs() < 2e-3); // rad/s
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct FlightModes {
    /// What the numbers of shapes and participations belong to.
    pub unknowns: Vec<Unknown>,
    /// Slowest first.
    pub modes: Vec<FlightMode>,
}

/// A root that is to be a mode.
struct Found {
    /// None yet of an elastic one.
    kind: Option<FlightModeKind>,
    portrait: Portrait,
    seen: Seen,
    is_quasi_steady: bool,
}

/// A root with its left shape and what takes part in it.
struct Seen {
    root: Root,
    left: DVector<Complex<f64>>,
    participations: Vec<f64>,
}

impl FlightModes {
    /// Of the motion linearised about a trim, named by what takes part: of symmetric motion, or one that is not far from it. A rigid
    /// mode that grows where the inflow follows at once and is found nowhere else is left out.
    pub fn new(matrix: &StateMatrix) -> Self {
        let (problem, unknowns) = (Condensed::new(matrix), motion_of(matrix));
        let (mut found, mut lost): (Vec<Found>, Vec<Found>) = Default::default();
        for start in with_instant_inflow(matrix) {
            match arrived(&problem, &start.seen.root, Path::Lag, &found) {
                Some(seen) => found.push(Found { seen, is_quasi_steady: false, ..start }),
                None => lost.push(start),
            }
        }
        for start in problem.frozen_roots().iter().filter(|root| root.eigenvalue.im > 0.0) {
            let of_frozen = arrived(&problem, start, Path::Coupling, &found);
            found.extend(of_frozen.map(|seen| seen.by_itself(&unknowns)));
        }
        only_pair_is_dutch_roll(&mut found);
        let is_missed = |start: &Found| {
            let kind = start.kind.filter(|_| start.seen.root.eigenvalue.re < 0.0);
            kind.is_some_and(|kind| found.iter().all(|other| other.kind != Some(kind)))
        };
        let missed: Vec<Found> = lost.into_iter().filter(is_missed).collect();
        found.extend(missed);
        found.sort_by(|a, b| a.seen.root.eigenvalue.norm().total_cmp(&b.seen.root.eigenvalue.norm()));
        let names = names(found.iter().map(|mode| mode.kind));
        let modes = found.into_iter().zip(names).map(|(mode, name)| mode.named(name)).collect();
        FlightModes { unknowns, modes }
    }

    /// The same modes with the names of those of another flight not far from this one that are most alike. What is like none there
    /// keeps its own name if no other mode has it, and is an elastic mode with a higher number if not.
    pub fn named_after(mut self, before: &FlightModes) -> Self {
        let mut given: Vec<Option<FlightModeName>> = vec![None; self.modes.len()];
        for (there, here) in alike(&before.modes, &self.modes) {
            given[here] = Some(before.modes[there].name);
        }
        let elastic_before = before.modes.iter().map(|mode| mode.name).filter(FlightModeName::is_elastic);
        let mut taken: Vec<FlightModeName> = given.iter().flatten().copied().chain(elastic_before).collect();
        for (mode, given) in self.modes.iter_mut().zip(given) {
            mode.name = given.unwrap_or_else(|| {
                let own = Some(mode.name).filter(|own| !taken.contains(own));
                let name = own.unwrap_or_else(|| FlightModeName::elastic_beyond(&taken));
                taken.push(name);
                name
            });
        }
        self
    }

    /// The mode with a name, as in `Dutch roll` or `elastic 2`.
    pub fn named(&self, name: &str) -> Option<&FlightMode> {
        self.modes.iter().find(|mode| mode.name.to_string() == name)
    }
}

/// The modes where the inflow follows at once, with their kinds by what takes part; none where it leaves no motion.
fn with_instant_inflow(matrix: &StateMatrix) -> Vec<Found> {
    let Some(motion) = matrix.with_instant_inflow() else { return Vec::new() };
    let problem = Condensed::new(&motion);
    let seen: Vec<Seen> =
        problem.frozen_roots().into_iter().filter_map(|root| Seen::new(&problem, root.upper())).collect();
    let portraits: Vec<Portrait> = seen.iter().map(|seen| seen.portrait(&motion.unknowns)).collect();
    let kinds = kinds(&portraits);
    let found = seen.into_iter().zip(portraits).zip(kinds);
    found.map(|((seen, portrait), kind)| Found { kind, portrait, seen, is_quasi_steady: true }).collect()
}

/// Of the pairs aside that were found from either side.
fn only_pair_is_dutch_roll(found: &mut [Found]) {
    let portraits: Vec<Portrait> = found.iter().map(|mode| mode.portrait).collect();
    let mut kinds: Vec<_> = found.iter().map(|mode| mode.kind).collect();
    mode_names::only_pair_is_dutch_roll(&portraits, &mut kinds);
    found.iter_mut().zip(kinds).for_each(|(mode, kind)| mode.kind = kind);
}

/// What the shapes of a motion are made of.
fn motion_of(matrix: &StateMatrix) -> Vec<Unknown> {
    let in_shape = |unknown: &&Unknown| !matches!(unknown, Unknown::Inflow { .. });
    matrix.unknowns.iter().filter(in_shape).copied().collect()
}

/// From which problem a root comes to that with the inflow as it is.
#[derive(Clone, Copy)]
enum Path {
    /// From an inflow that follows at once, ε = 0, over the root of ε.
    Lag,
    /// From a frozen wake, κ = 0.
    Coupling,
}

/// A root with the inflow as it is, another than those that have arrived before, and none of the wake's own.
fn arrived(problem: &Condensed, start: &Root, path: Path, others: &[Found]) -> Option<Seen> {
    let root = match path {
        Path::Lag => follow(start, LARGEST_STEP, |place| Some(Arc::new(problem.with_lag(place * place)))),
        Path::Coupling => follow(start, 1.0, |coupling| Some(Arc::new(problem.with_coupling(coupling)))),
    }
    .ok()?;
    let root = root.upper();
    if others.iter().any(|other| other.seen.root.is_at(root.eigenvalue)) {
        return None;
    }
    Seen::new(problem, root).filter(|seen| seen.participations.iter().sum::<f64>() > LOST)
}

impl Seen {
    fn new(problem: &Condensed, root: Root) -> Option<Self> {
        let left = problem.left_shape(&root)?;
        let participations = problem.participations(&root, &left);
        Some(Seen { root, left, participations })
    }

    /// By what takes part of the motion.
    fn portrait(&self, unknowns: &[Unknown]) -> Portrait {
        let motion: f64 = self.participations.iter().sum();
        let shares: Vec<f64> = self.participations.iter().map(|share| share / motion).collect();
        Portrait::new(self.root.eigenvalue.im > 0.0, unknowns, &shares)
    }

    /// As the mode that it seems to be with the inflow as it is.
    fn by_itself(self, unknowns: &[Unknown]) -> Found {
        let portrait = self.portrait(unknowns);
        Found { kind: portrait.kind(), portrait, seen: self, is_quasi_steady: false }
    }
}

impl Found {
    fn named(self, name: FlightModeName) -> FlightMode {
        let Found { portrait, seen: Seen { root, left, participations }, is_quasi_steady, .. } = self;
        let share_aside = portrait.share_aside();
        FlightMode { name, root, is_quasi_steady, participations, share_aside, left }
    }
}

/// Which of some modes go on as which of others: those that are most alike first, and none that are not alike.
fn alike(from: &[FlightMode], to: &[FlightMode]) -> Vec<(usize, usize)> {
    let pairs = (0..from.len()).flat_map(|a| (0..to.len()).map(move |b| (a, b)));
    let mut pairs: Vec<_> = pairs.map(|(a, b)| (distance(&from[a], &to[b]), a, b)).collect();
    pairs.retain(|(distance, ..)| *distance < UNLIKE);
    pairs.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut gone, mut taken) = (vec![false; from.len()], vec![false; to.len()]);
    let mut matched = Vec::new();
    for (_, a, b) in pairs {
        if !gone[a] && !taken[b] {
            (gone[a], taken[b]) = (true, true);
            matched.push((a, b));
        }
    }
    matched
}

/// How far a mode is from another: eigenvalues by their size, shapes by left against right ones, which asks no units.
fn distance(from: &FlightMode, to: &FlightMode) -> f64 {
    let [here, there] = [from.root.eigenvalue, to.root.eigenvalue];
    let across = from.left.dot(&to.root.shape).norm() * to.left.dot(&from.root.shape).norm();
    let along = from.left.dot(&from.root.shape).norm() * to.left.dot(&to.root.shape).norm();
    (there - here).norm() / (here.norm() + SLOW) + 1.0 - (across / along).min(1.0)
}

//! The modes of an aircraft in flight with their names: phugoid, short period, Dutch roll, roll, spiral, those of the structure.
//!
//! [theory: stability.modes]
//!
//! In the whole motion the inflow takes so large a part in every mode that what leads it does not tell the mode. With an
//! inflow that follows the motion at once it does: there modes get their names, and from there each is followed to the inflow as it
//! is. A rigid mode that does not arrive, or arrives as one of the wake's own, is given as it was before, and marked; one of the structure is
//! looked for from the side of a frozen wake.
//! From one flight to the next, as into a turn, names go with the modes that are most alike.

use std::sync::Arc;

use nalgebra::{Complex, DVector};

use crate::plant::{StateMatrix, Unknown};

use super::condensed::{Condensed, Root};
use super::continuation::follow;
use super::mode_names::{FlightModeKind, FlightModeName, Portrait, names};

/// Largest step from an inflow that follows the motion at once, ε = 0, to that as it is, ε = 1, of the root of ε.
const LARGEST_STEP: f64 = 0.25;

/// A mode in which the motion takes part less than this is one of the wake's own.
const LOST: f64 = 0.02;

/// Shapes that agree less are not of one mode of the structure.
const ALIKE: f64 = 0.1;

/// Eigenvalues are told apart in proportion to this and their size, 1/s.
const SLOW: f64 = 0.05;

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
    /// By which they are known in another flight.
    pub names: ModeNames,
}

/// The names of modes in a trim, with what tells them in the next: the modes of an inflow that follows the motion at once.
#[derive(Clone, Debug)]
pub struct ModeNames(Vec<Instant>);

/// A root with an inflow that follows the motion at once.
#[derive(Clone, Debug)]
struct Instant {
    root: Root,
    left: DVector<Complex<f64>>,
    participations: Vec<f64>,
    share_aside: Option<f64>,
    name: FlightModeName,
}

impl FlightModes {
    /// Of the motion linearised about a trim, named by what takes part: of symmetric motion, or one that is not far from it.
    pub fn new(matrix: &StateMatrix) -> Self {
        let mut modes = FlightModes::with_names(matrix, ModeNames::new(matrix));
        modes.number_elastic();
        modes
    }

    /// Of the motion linearised about a trim, with the names that its modes have already.
    pub fn with_names(matrix: &StateMatrix, names: ModeNames) -> Self {
        let problem = Condensed::new(matrix);
        let mut modes: Vec<FlightMode> = Vec::with_capacity(names.0.len());
        let mut lost: Vec<&Instant> = Vec::new();
        for start in &names.0 {
            match arrived(&problem, &start.root, LARGEST_STEP, Path::Lag, &modes) {
                Some(found) => modes.push(start.mode(found, false)),
                None => lost.push(start),
            }
        }
        let (elastic, rigid): (Vec<&Instant>, Vec<&Instant>) =
            lost.into_iter().partition(|start| start.is_elastic());
        modes.extend(
            rigid
                .into_iter()
                .map(|start| start.mode((start.root.clone(), start.participations.clone()), true)),
        );
        let unknowns = motion_of(matrix);
        find_elastic((&problem, &unknowns), &elastic, names.0.len(), &mut modes);
        modes.sort_by(|a, b| a.eigenvalue().norm().total_cmp(&b.eigenvalue().norm()));
        FlightModes { unknowns, modes, names }
    }

    /// The same modes with the names of those of another flight not far from this one that are most alike.
    pub fn named_after(mut self, before: &ModeNames) -> Self {
        let names = before.others(&self.names);
        self.rename(&names);
        self
    }

    /// The mode with a name, as in `Dutch roll` or `elastic 2`.
    pub fn named(&self, name: &str) -> Option<&FlightMode> {
        self.modes.iter().find(|mode| mode.name.to_string() == name)
    }

    /// Numbers elastic modes as they come.
    fn number_elastic(&mut self) {
        let is_elastic = |mode: &&FlightMode| matches!(mode.name.kind, FlightModeKind::Elastic(_));
        let numbered = self.modes.iter().filter(is_elastic).zip(1..).map(|(mode, number)| {
            (mode.name, FlightModeName { kind: FlightModeKind::Elastic(number), number: None })
        });
        let names: Vec<_> = numbered.collect();
        self.rename(&names);
    }

    fn rename(&mut self, names: &[(FlightModeName, FlightModeName)]) {
        let new =
            |old: FlightModeName| names.iter().find(|(name, _)| *name == old).map_or(old, |name| name.1);
        self.modes.iter_mut().for_each(|mode| mode.name = new(mode.name));
        self.names.0.iter_mut().for_each(|mode| mode.name = new(mode.name));
    }
}

impl ModeNames {
    /// By what takes part.
    pub fn new(matrix: &StateMatrix) -> Self {
        let Some(problem) = Condensed::new(matrix).with_instant_inflow() else {
            return ModeNames(Vec::new());
        };
        let unknowns = motion_of(matrix);
        let with_left = |root: Root| {
            let left = problem.left_shape(&root)?;
            let participations = problem.participations(&root, &left);
            let portrait = Portrait::new(root.eigenvalue.im > 0.0, &unknowns, &participations);
            Some(((root, left, participations), portrait))
        };
        let (roots, portraits): (Vec<_>, Vec<Portrait>) =
            problem.frozen_roots().into_iter().filter_map(with_left).unzip();
        let named = roots.into_iter().zip(names(&portraits)).zip(&portraits);
        let instant = named.map(|(((root, left, participations), name), portrait)| {
            let share_aside = portrait.share_aside();
            Instant { root, left, participations, share_aside, name }
        });
        ModeNames(instant.collect())
    }

    /// Those of the modes that are most alike in a flight before, not far from this one; where there are more than there, those
    /// that are left have names by what takes part.
    pub fn after(matrix: &StateMatrix, before: &ModeNames) -> Self {
        let mut names = ModeNames::new(matrix);
        let renamed = before.others(&names);
        let new =
            |old: FlightModeName| renamed.iter().find(|(name, _)| *name == old).map_or(old, |name| name.1);
        names.0.iter_mut().for_each(|mode| mode.name = new(mode.name));
        names
    }

    /// For each name of modes in another flight the one that the mode most alike has here.
    fn others(&self, there: &ModeNames) -> Vec<(FlightModeName, FlightModeName)> {
        let matched = alike(&self.0, &there.0);
        matched.into_iter().map(|(here, other)| (there.0[other].name, self.0[here].name)).collect()
    }
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

/// A root and its participations with the inflow as it is, another than those that have arrived before, and none of the wake's own.
fn arrived(
    problem: &Condensed,
    start: &Root,
    largest_step: f64,
    path: Path,
    others: &[FlightMode],
) -> Option<(Root, Vec<f64>)> {
    let root = follow(start, largest_step, |place| {
        Some(Arc::new(match path {
            Path::Lag => problem.with_lag(place * place),
            Path::Coupling => problem.with_coupling(place),
        }))
    })?;
    let same = |mode: &FlightMode| !mode.is_quasi_steady && mode.root.is_at(root.eigenvalue);
    if others.iter().any(same) {
        return None;
    }
    let left = problem.left_shape(&root)?;
    let participations = problem.participations(&root, &left);
    (participations.iter().sum::<f64>() > LOST).then_some((root, participations))
}

/// Finds modes of the structure from the side of a frozen wake, for an inflow that follows at once is as good as none of its own at
/// their frequencies: those that did not arrive have their names by the best agreement of shapes, others have numbers beyond so many.
fn find_elastic(
    (problem, unknowns): (&Condensed, &[Unknown]),
    lost: &[&Instant],
    known: usize,
    modes: &mut Vec<FlightMode>,
) {
    let mut lost = lost.to_vec();
    let mut number = known;
    for start in problem.frozen_roots().iter().filter(|root| root.eigenvalue.im > 0.0) {
        let Some((root, participations)) = arrived(problem, start, 1.0, Path::Coupling, modes) else {
            continue;
        };
        if root.eigenvalue.im == 0.0 {
            continue;
        }
        let agreement = |place: usize| lost[place].root.agreement(&root);
        let nearest = (0..lost.len()).max_by(|&a, &b| agreement(a).total_cmp(&agreement(b)));
        match nearest.filter(|&place| agreement(place) > ALIKE) {
            Some(nearest) => modes.push(lost.remove(nearest).mode((root, participations), false)),
            None => {
                number += 1;
                let name = FlightModeName { kind: FlightModeKind::Elastic(number), number: None };
                let share_aside = Portrait::new(true, unknowns, &participations).share_aside();
                modes.push(FlightMode { name, root, is_quasi_steady: false, participations, share_aside });
            }
        }
    }
}

impl Instant {
    fn is_elastic(&self) -> bool {
        matches!(self.name.kind, FlightModeKind::Elastic(_))
    }

    /// The mode of its name that has this root with these participations.
    fn mode(&self, (root, participations): (Root, Vec<f64>), is_quasi_steady: bool) -> FlightMode {
        let Instant { name, share_aside, .. } = *self;
        FlightMode { name, root, is_quasi_steady, participations, share_aside }
    }
}

/// Which of some modes go on as which of others: those that are most alike first.
fn alike(from: &[Instant], to: &[Instant]) -> Vec<(usize, usize)> {
    let pairs = (0..from.len()).flat_map(|a| (0..to.len()).map(move |b| (a, b)));
    let mut pairs: Vec<_> = pairs.map(|(a, b)| (distance(&from[a], &to[b]), a, b)).collect();
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
fn distance(from: &Instant, to: &Instant) -> f64 {
    let [here, there] = [from.root.eigenvalue, to.root.eigenvalue];
    let across = from.left.dot(&to.root.shape).norm() * to.left.dot(&from.root.shape).norm();
    let along = from.left.dot(&from.root.shape).norm() * to.left.dot(&to.root.shape).norm();
    (there - here).norm() / (here.norm() + SLOW) + 1.0 - (across / along).min(1.0)
}

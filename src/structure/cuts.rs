//! Cuts through the reduced aircraft: where they are, how their axes lie, what is outboard.
//!
//! [theory: section-loads.outboard, section-loads.axes]

use nalgebra::{DMatrix, Vector3};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Aircraft, Cut, MassBay};

use super::ModeShapes;
use super::assembly::Structure;
use super::carrier::Carrier;
use super::cut_axes::Axes;
use super::poses::linear_poses;
use super::sections::{RigidBody, SectionTree, steps};

/// By how much axes may differ from length 1 and right angles.
pub(super) const ROUNDING: f64 = 1e-9;

/// A cut with its axes on the undeformed aircraft, which turn with its section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedCut {
    /// Its outputs are `loads.<name>.*`.
    pub name: String,
    /// The component that is cut.
    pub component: String,
    /// Where along it, as a fraction of its length: at a node.
    pub at: f64,
    /// The fraction that was asked for.
    pub asked: f64,
    /// Undeformed, body axes, m.
    pub position: Vector3<f64>,
    /// The nearest of the sections on the way to O, or the one in this place.
    pub section: usize,
    /// Relative to that: Dλ and Dφ [theory: geometrically-exact.sections].
    pub steps: ModeShapes,
    /// t, outboard along the beam.
    pub along: Vector3<f64>,
    /// u, up; to the left of a fin, ahead of an upright body.
    pub up: Vector3<f64>,
    /// c, to the leading edge; to the right of a body that does not run sideways.
    pub chordwise: Vector3<f64>,
    /// ±t, about which torsion is positive: nose-up, of a fin or an upright body nose-left.
    pub torsion: Vector3<f64>,
    /// What hangs outboard.
    pub outboard: Outboard,
}

/// What is outboard of a cut, by numbers in the reduced model, ascending.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Outboard {
    /// Strips.
    pub strips: Vec<usize>,
    /// Engines.
    pub engines: Vec<usize>,
    /// Stations, on which point loads may act.
    pub stations: Vec<usize>,
    /// Masses.
    pub masses: Vec<usize>,
}

/// The mass of a bay on its section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedMass {
    /// The section that carries it.
    pub carrier: Carrier,
    /// Of that, undeformed, body axes, m.
    pub position: Vector3<f64>,
    /// What it weighs, and where.
    pub body: RigidBody,
}

/// All bays.
pub(super) fn reduced_masses(structure: &Structure, tree: &SectionTree) -> Vec<ReducedMass> {
    let reduce = |bay: &MassBay| {
        let carrier = Carrier::own(tree.at(bay.attachment));
        let position = tree.sections[carrier.section].position;
        ReducedMass { carrier, position, body: RigidBody::of(bay) }
    };
    structure.aircraft.bays.iter().map(reduce).collect()
}

/// All cuts.
pub(super) fn reduced_cuts(
    structure: &Structure,
    tree: &SectionTree,
    shapes: &DMatrix<f64>,
) -> Vec<ReducedCut> {
    let aircraft = structure.aircraft;
    if aircraft.cuts.is_empty() {
        return Vec::new();
    }
    let poses = linear_poses(&tree.sections);
    let reduce = |cut: &Cut| {
        let geometry = &structure.geometry[cut.attachment.beam];
        let position = geometry.position(cut.attachment.fraction);
        let section = tree.at(cut.attachment);
        let arm = position - tree.sections[section].position;
        let Axes { along, up, chordwise, torsion } = Axes::new(structure, cut.attachment.beam);
        ReducedCut {
            name: cut.name.clone(),
            component: cut.component.clone(),
            at: cut.at,
            asked: cut.asked,
            position,
            section,
            steps: steps(&poses[section], &structure.shapes_at(cut.attachment, shapes), &arm),
            along,
            up,
            chordwise,
            torsion,
            outboard: Outboard::of(aircraft, cut),
        }
    };
    aircraft.cuts.iter().map(reduce).collect()
}

impl ReducedCut {
    /// What no cut has through an aircraft with so many strips, engines, stations and masses, if it has such a thing.
    pub(super) fn fault(&self, counts: [usize; 4]) -> Option<&'static str> {
        let along_component = 0.0..=1.0;
        if ![self.at, self.asked].iter().all(|at| along_component.contains(at)) {
            Some("a cut is at no fraction of a component's length from 0 to 1")
        } else if !self.position.iter().all(|x| x.is_finite()) {
            Some("the place of a cut is not finite")
        } else if !self.has_axes() {
            Some("the axes of a cut are not of length 1 and at right angles")
        } else if !self.outboard.is_among(counts) {
            Some("what is outboard of a cut is not there, or not in ascending order")
        } else {
            None
        }
    }

    fn has_axes(&self) -> bool {
        let ReducedCut { along, up, chordwise, torsion, .. } = self;
        let are_across = |one: &Vector3<f64>, other: &Vector3<f64>| one.dot(other).abs() < ROUNDING;
        [along, up, chordwise].into_iter().all(is_unit)
            && are_across(along, up)
            && are_across(up, chordwise)
            && are_across(chordwise, along)
            && (torsion == along || *torsion == -along)
    }
}

/// Whether a vector is a direction.
pub(super) fn is_unit(vector: &Vector3<f64>) -> bool {
    (vector.norm() - 1.0).abs() < ROUNDING
}

impl Outboard {
    /// Whether there is all of it where there are so many strips, engines, stations and masses, each once, in order.
    fn is_among(&self, counts: [usize; 4]) -> bool {
        let Outboard { strips, engines, stations, masses } = self;
        [strips, engines, stations, masses].into_iter().zip(counts).all(|(numbers, count)| {
            numbers.is_sorted_by(|one, next| one < next) && numbers.last().is_none_or(|last| *last < count)
        })
    }

    fn of(aircraft: &Aircraft, cut: &Cut) -> Self {
        let chosen = |beams: &mut dyn Iterator<Item = usize>| {
            let outboard = beams.enumerate().filter(|(_, beam)| cut.outboard.contains(beam));
            outboard.map(|(index, _)| index).collect()
        };
        Outboard {
            strips: chosen(&mut aircraft.strips.iter().map(|strip| strip.attachment.beam)),
            engines: chosen(&mut aircraft.engines.iter().map(|engine| engine.attachment.beam)),
            stations: chosen(&mut aircraft.stations.iter().map(|station| station.attachment.beam)),
            masses: chosen(&mut aircraft.bays.iter().map(|bay| bay.attachment.beam)),
        }
    }
}

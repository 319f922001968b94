//! Cuts through the reduced aircraft: where they are, how their axes lie, what is outboard.
//!
//! [theory: section-loads.outboard, section-loads.axes]

use nalgebra::{DMatrix, Vector3};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Aircraft, Cut, MassBay, Strip};

use super::ModeShapes;
use super::assembly::Structure;
use super::carrier::Carrier;
use super::poses::linear_poses;
use super::sections::{RigidBody, SectionTree, steps};

/// Cosine of the angle from which on spans do not run along each other: 45°, as surfaces may share a stretch.
const CROSSING: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Sine of the angle below which two directions are one.
const SAME_DIRECTION: f64 = 1e-3;

/// A cut with its axes on the undeformed aircraft, which turn with its section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedCut {
    /// Its outputs are `loads.<name>.*`.
    pub name: String,
    /// The component that is cut.
    pub component: String,
    /// Where along it, as a fraction of its length.
    pub at: f64,
    /// Undeformed, body axes, m.
    pub position: Vector3<f64>,
    /// The nearest of the sections on the way to O, or the one in this place.
    pub section: usize,
    /// Relative to that: Dλ and Dφ [theory: geometrically-exact.sections].
    pub steps: ModeShapes,
    /// t, outboard along the beam.
    pub along: Vector3<f64>,
    /// u, up; to the left of a fin.
    pub up: Vector3<f64>,
    /// c, to the leading edge; to the right of a body.
    pub chordwise: Vector3<f64>,
    /// ±t, about which torsion is positive: nose-up.
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
        let along = geometry.axes.row(0).transpose();
        let Axes { up, chordwise, torsion } = Axes::new(aircraft, cut, &along);
        ReducedCut {
            name: cut.name.clone(),
            component: cut.component.clone(),
            at: cut.at,
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

impl Outboard {
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

/// How the axes across a cut lie.
struct Axes {
    up: Vector3<f64>,
    chordwise: Vector3<f64>,
    torsion: Vector3<f64>,
}

impl Axes {
    /// Of a lifting surface, if the component is one, else of a body [theory: section-loads.axes].
    fn new(aircraft: &Aircraft, cut: &Cut, along: &Vector3<f64>) -> Self {
        let on_component = |strip: &&Strip| aircraft.beams[strip.attachment.beam].component == cut.component;
        let strips: Vec<&Strip> = aircraft.strips.iter().filter(on_component).collect();
        Axes::of_surface(&strips, along).unwrap_or_else(|| Axes::of_body(along))
    }

    /// Of a lifting surface, whose strips have a common span that runs along the beam.
    fn of_surface(strips: &[&Strip], along: &Vector3<f64>) -> Option<Self> {
        let first = strips.first()?;
        if strips.iter().any(|strip| strip.span.dot(&first.span).abs() < CROSSING) {
            return None;
        }
        let (forward, span) = (first.forward, first.span);
        let up = across(&-forward.cross(&span), along)?;
        let chordwise = up.cross(along);
        let ahead = chordwise.dot(&forward);
        let sense = if along.dot(&span) < 0.0 { -1.0 } else { 1.0 };
        (ahead.abs() > SAME_DIRECTION).then(|| Axes {
            up,
            chordwise: chordwise * ahead.signum(),
            torsion: along * sense,
        })
    }

    /// Of a body: up, or forward where the beam is upright; to the right; torsion about an axis ahead.
    fn of_body(along: &Vector3<f64>) -> Self {
        let up = across(&-Vector3::z(), along).or_else(|| across(&Vector3::x(), along)).unwrap_or_default();
        let chordwise = up.cross(along);
        Axes {
            up,
            chordwise: if chordwise.y < 0.0 { -chordwise } else { chordwise },
            torsion: if along.x < 0.0 { -along } else { *along },
        }
    }
}

/// The part of a unit vector across a direction, at length 1; `None` where it is along it.
fn across(vector: &Vector3<f64>, along: &Vector3<f64>) -> Option<Vector3<f64>> {
    (vector - along * along.dot(vector)).try_normalize(SAME_DIRECTION)
}

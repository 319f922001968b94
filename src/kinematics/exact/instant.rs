//! The sections of an aircraft that moves geometrically exactly, and the same at an instant.

use nalgebra::Vector3;

use crate::math::{Arithmetic, LANES};
use crate::structure::{BeamSection, Carrier, ModeShapes, ReducedCut, ReducedModel, ReducedStrip};

use super::super::kind::Coordinates;
use super::super::sections::{CarriesMass, Pose, Section, Sections, SectionsInPlane, SectionsInSpace};
use super::attached::Attached;
use super::bodies::Bodies;
use super::cut::CutBeyond;
use super::eight::{EightSections, EightStrips};
use super::tree::{MovingTree, Tree};

/// Where the strains are sums of the modes' own, and positions and rotations follow from them by finite kinematics.
///
/// [theory: geometrically-exact.sections]
#[derive(Clone, Debug)]
pub struct GeometricallyExact {
    modes: usize,
    tree: Tree,
    bodies: Bodies,
    strip_count: usize,
    strips: Vec<EightStrips>,
    edge_on: Vec<EightStrips>,
    engines: Vec<Attached>,
    stations: Vec<Attached>,
    masses: Vec<Attached>,
    cuts: Vec<CutBeyond>,
    /// Of any strip by a small unit coordinate, m and rad.
    largest: [f64; 2],
}

/// What an evaluation writes.
#[derive(Clone, Debug)]
pub struct ExactMemory {
    tree: MovingTree,
    strips: Vec<EightSections>,
    edge_on: Vec<EightSections>,
}

/// The sections at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a> {
    kinematics: &'a GeometricallyExact,
    memory: &'a ExactMemory,
}

impl GeometricallyExact {
    /// Of a model, and of other strips with the same modes that flow in the mirror plane meets edge-on.
    pub fn of(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        let modes = model.modes.len();
        let kept = Kept::new(model, edge_on);
        let sections: Vec<&BeamSection> =
            kept.sections.iter().map(|&section| &model.sections[section]).collect();
        let parents: Vec<usize> = sections.iter().map(|section| kept.places[section.parent]).collect();
        let tree = Tree::new(&sections, &parents, modes);
        let order = tree.order();
        let place = |section: usize| order.places[kept.places[section]];
        let attached = |at_rest: Vector3<f64>, carrier: Carrier| {
            let section = &model.sections[carrier.section].position;
            let at = place(carrier.section);
            Attached::new(at_rest, Carrier { section: at, ..carrier }, section, order.modes_at(at))
        };
        let strip = |strips: &[ReducedStrip]| {
            let at: Vec<usize> = strips.iter().map(|strip| place(strip.section)).collect();
            EightStrips::new(strips, &at, order, modes)
        };
        let cut = |cut: &ReducedCut| {
            CutBeyond::new(model, cut, |section| kept.has[section].then(|| place(section)))
        };
        GeometricallyExact {
            modes,
            bodies: Bodies::new(&sections, order),
            strip_count: model.strips.len(),
            strips: model.strips.chunks(LANES).map(strip).collect(),
            edge_on: edge_on.chunks(LANES).map(strip).collect(),
            engines: model.engines.iter().map(|at| attached(at.position, at.carrier)).collect(),
            stations: model.stations.iter().map(|at| attached(at.position, at.carrier)).collect(),
            masses: model.masses.iter().map(|at| attached(at.position, at.carrier)).collect(),
            cuts: model.cuts.iter().map(cut).collect(),
            largest: [largest(&model.strips, &[0, 1, 2]), largest(&model.strips, &[0, 1, 2, 3, 4, 5])],
            tree,
        }
    }

    /// Room for an evaluation, of the undeformed aircraft at rest.
    pub fn room(&self) -> ExactMemory {
        let eights = |strips: &[EightStrips]| strips.iter().map(EightStrips::resting).collect();
        ExactMemory {
            tree: self.tree.at_rest(),
            strips: eights(&self.strips),
            edge_on: eights(&self.edge_on),
        }
    }

    /// Writes the tree at some q and q̇, and gathers from it the sections of the strips.
    #[inline(always)]
    pub fn write<S: Arithmetic>(&self, simd: S, at: Coordinates, memory: &mut ExactMemory) {
        self.tree.write(simd, at, &mut memory.tree);
        let lifting = self.strips.iter().zip(&mut memory.strips);
        for (strips, written) in lifting.chain(self.edge_on.iter().zip(&mut memory.edge_on)) {
            strips.write(simd, &memory.tree, written);
        }
    }

    /// At the q and q̇ of the last evaluation.
    #[inline(always)]
    pub fn at<'a>(&'a self, memory: &'a ExactMemory) -> Instant<'a> {
        Instant { kinematics: self, memory }
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.modes
    }

    /// The largest displacement of any strip by a small unit coordinate, m, and the largest displacement or rotation.
    pub fn largest(&self) -> [f64; 2] {
        self.largest
    }
}

/// The largest of some rows of the shapes of any strip.
fn largest(strips: &[ReducedStrip], rows: &[usize]) -> f64 {
    let of_rows = |shapes: &ModeShapes| {
        let numbers = rows.iter().flat_map(|&row| shapes.row(row));
        numbers.fold(0.0_f64, |largest, number| largest.max(number.abs()))
    };
    strips.iter().fold(0.0, |largest, strip| largest.max(of_rows(&strip.shapes)))
}

/// The sections on the way from O to those that carry anything, in their order.
struct Kept {
    sections: Vec<usize>,
    /// Where each of all sections stands among them.
    places: Vec<usize>,
    /// Whether it does.
    has: Vec<bool>,
}

impl Kept {
    fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        let strips = model.strips.iter().chain(edge_on).map(|strip| strip.section);
        let engines = model.engines.iter().map(|engine| engine.carrier.section);
        let stations = model.stations.iter().map(|station| station.carrier.section);
        let mut needed: Vec<bool> = model.sections.iter().map(|section| section.body.mass > 0.0).collect();
        strips.chain(engines).chain(stations).for_each(|section| needed[section] = true);
        needed[0] = true;
        for section in (0..needed.len()).rev() {
            if needed[section] {
                needed[model.sections[section].parent] = true;
            }
        }
        let sections: Vec<usize> = (0..needed.len()).filter(|&section| needed[section]).collect();
        let mut places = vec![0; needed.len()];
        for (place, &section) in sections.iter().enumerate() {
            places[section] = place;
        }
        Kept { sections, places, has: needed }
    }
}

#[cfg(test)]
impl ExactMemory {
    /// The evaluated tree.
    pub fn tree(&self) -> &MovingTree {
        &self.tree
    }
}

#[cfg(test)]
impl GeometricallyExact {
    /// In which order sections are evaluated.
    pub fn order(&self) -> &super::strands::Strands {
        self.tree.order()
    }
}

impl<'a> Instant<'a> {
    /// The evaluated tree.
    #[inline(always)]
    pub fn tree(&self) -> &'a MovingTree {
        &self.memory.tree
    }

    /// All mass.
    #[inline(always)]
    pub fn bodies(&self) -> &'a Bodies {
        &self.kinematics.bodies
    }
}

impl Sections for Instant<'_> {
    #[inline(always)]
    fn of_strips(&self, group: usize) -> impl SectionsInSpace + SectionsInPlane {
        &self.memory.strips[group]
    }

    #[inline(always)]
    fn edge_on(&self, group: usize) -> impl SectionsInPlane {
        &self.memory.edge_on[group]
    }

    fn engines(&self) -> impl Iterator<Item = impl Section> {
        self.kinematics.engines.iter().map(|place| place.now(&self.memory.tree))
    }

    fn stations(&self) -> impl Iterator<Item = impl Section> {
        self.kinematics.stations.iter().map(|place| place.now(&self.memory.tree))
    }

    fn masses(&self) -> impl Iterator<Item = impl CarriesMass> {
        self.kinematics.masses.iter().map(|place| place.now(&self.memory.tree))
    }

    fn cuts(&self, q: &[f64]) -> impl Iterator<Item = Pose> {
        self.kinematics.cuts.iter().map(|cut| cut.now(&self.memory.tree, q))
    }

    fn strip_displacements(&self) -> impl Iterator<Item = Vector3<f64>> {
        self.memory.strips.iter().flat_map(EightSections::displacements).take(self.kinematics.strip_count)
    }
}

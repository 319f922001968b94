//! The sections of an aircraft that moves by superposition, and the same at an instant.

use std::ops::Range;

use nalgebra::Vector3;
use pulp::Scalar;

use crate::math::{LANES, Window};
use crate::structure::{
    ModeShapes, ReducedCut, ReducedMass, ReducedModel, ReducedStrip, linear_pose_after, linear_poses,
};

use super::super::kind::Coordinates;
use super::super::sections::{CarriesMass, Pose, Section, Sections, SectionsInPlane, SectionsInSpace};
use super::eight::{EightEdgeOn, EightSections, Superposed};
use super::section::{LinearSection, SuperposedSection};

/// The sections of an aircraft that moves by superposition.
#[derive(Clone, Debug)]
pub struct Superposition {
    strip_count: usize,
    strips: Vec<EightSections>,
    edge_on: Vec<EightEdgeOn>,
    engines: Vec<LinearSection>,
    stations: Vec<LinearSection>,
    masses: Vec<LinearSection>,
    cuts: Vec<LinearSection>,
}

/// The same at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a> {
    sections: &'a Superposition,
    /// q and q̇.
    pub coordinates: Coordinates<'a>,
}

impl Superposition {
    /// Of a model, and of other strips with the same modes that flow in the mirror plane meets edge-on.
    pub fn of(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        let modes = model.modes.len();
        let section = |position, shapes: &ModeShapes| LinearSection::new(position, shapes.clone());
        // Nobody asks what masses do where there are no cuts: their sums are constants.
        let masses: &[ReducedMass] = if model.cuts.is_empty() { &[] } else { &model.masses };
        let poses = if model.cuts.is_empty() { Vec::new() } else { linear_poses(&model.sections) };
        let mass = |mass: &ReducedMass| section(mass.position, &poses[mass.carrier.section]);
        let cut = |ReducedCut { section: at, steps, position, .. }: &ReducedCut| {
            let arm = position - model.sections[*at].position;
            LinearSection::new(*position, linear_pose_after(&poses[*at], steps, &arm))
        };
        Superposition {
            strip_count: model.strips.len(),
            strips: model.strips.chunks(LANES).map(|strips| EightSections::new(strips, modes)).collect(),
            edge_on: edge_on.chunks(LANES).map(|strips| EightEdgeOn::new(strips, modes)).collect(),
            engines: model.engines.iter().map(|engine| section(engine.position, &engine.shapes)).collect(),
            stations: model.stations.iter().map(|place| section(place.position, &place.shapes)).collect(),
            masses: masses.iter().map(mass).collect(),
            cuts: model.cuts.iter().map(cut).collect(),
        }
    }

    /// At some q and q̇.
    #[inline(always)]
    pub fn at<'a>(&'a self, coordinates: Coordinates<'a>) -> Instant<'a> {
        Instant { sections: self, coordinates }
    }

    /// The largest of some of the rows Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z of any strip, m or rad.
    pub fn largest(&self, rows: Range<usize>) -> f64 {
        self.strips.iter().fold(0.0, |largest, eight| eight.largest(rows.clone()).max(largest))
    }
}

impl<'a> Instant<'a> {
    #[inline(always)]
    fn of<T>(self, sections: &'a T) -> Superposed<'a, T> {
        Superposed { sections, coordinates: self.coordinates }
    }

    fn single(self, section: &'a LinearSection) -> SuperposedSection<'a> {
        section.at(self.coordinates)
    }
}

impl Sections for Instant<'_> {
    #[inline(always)]
    fn of_strips(&self, group: usize) -> impl SectionsInSpace + SectionsInPlane {
        self.of(&self.sections.strips[group])
    }

    #[inline(always)]
    fn edge_on(&self, group: usize) -> impl SectionsInPlane {
        self.of(&self.sections.edge_on[group])
    }

    fn engines(&self) -> impl Iterator<Item = impl Section> {
        self.sections.engines.iter().map(|section| self.single(section))
    }

    fn stations(&self) -> impl Iterator<Item = impl Section> {
        self.sections.stations.iter().map(|section| self.single(section))
    }

    fn masses(&self) -> impl Iterator<Item = impl CarriesMass> {
        self.sections.masses.iter().map(|section| self.single(section))
    }

    fn cuts(&self, _: &[f64]) -> impl Iterator<Item = Pose> {
        self.sections.cuts.iter().map(|section| self.single(section).pose())
    }

    fn strip_displacements(&self) -> impl Iterator<Item = Vector3<f64>> {
        let groups = self.sections.strips.iter().flat_map(|eight| {
            let eight = self.of(eight);
            Window::all(Scalar::new()).map(move |window| {
                let [displacement, ..] = eight.sums(window);
                displacement.vector()
            })
        });
        groups.take(self.sections.strip_count)
    }
}

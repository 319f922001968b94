//! The aircraft with a station at every section that is drawn and a cut at every node beside loops: their outputs are poses and section loads at
//! each level of fidelity, as the library says them.

use std::ops::Range;

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::{Attachment, Cut};
use nalgebra::Vector3;

/// Parts of an element within which a place is its end.
const AT_NODE: f64 = 1e-9;

/// An aircraft that is watched all over.
pub struct Airframe {
    /// Its stations are those of the file, then one at each section; its cuts those of the file, then all nodes of all components but
    /// within loops.
    pub aircraft: Aircraft,
    /// How many stations and cuts are those of the file.
    pub named: [usize; 2],
    pub sections: Vec<Section>,
    /// The sections of nodes, component by component, root first.
    pub nodes: Vec<Vec<usize>>,
    /// The cuts at them, where loads have an answer.
    cuts_at: Vec<Vec<Option<usize>>>,
    /// Of each strip.
    pub strips: Vec<usize>,
    pub engines: Vec<usize>,
    /// Of those of the file.
    pub stations: Vec<usize>,
    pub cuts: Vec<usize>,
}

/// A place whose pose is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// On the undeformed aircraft, body axes, m.
    pub position: Vector3<f64>,
    /// The component and how far along it, in elements from the root.
    pub component: usize,
    pub along: f64,
}

impl Airframe {
    /// Of an aircraft as a file has it.
    pub fn new(aircraft: &Aircraft) -> Self {
        let mut places = Places { aircraft, sections: Vec::new(), attachments: Vec::new() };
        let nodes: Vec<Vec<usize>> = (0..aircraft.components.len()).map(|one| places.nodes(one)).collect();
        let strips = aircraft.strips.iter().map(|strip| places.section(strip.attachment)).collect();
        let engines = aircraft.engines.iter().map(|engine| places.section(engine.attachment)).collect();
        let stations = aircraft.stations.iter().map(|station| places.section(station.attachment)).collect();
        let cuts = aircraft.cuts.iter().map(|cut| places.section(cut.attachment)).collect();
        let Places { sections, attachments, .. } = places;
        let named = [aircraft.stations.len(), aircraft.cuts.len()];
        let mut watched = aircraft.clone();
        for (number, attachment) in attachments.into_iter().enumerate() {
            // Names of files have no blanks.
            watched.stations.push(aircraft.station_at(format!("section {number}"), attachment));
        }
        let mut cuts_at: Vec<Vec<Option<usize>>> =
            nodes.iter().map(|nodes| vec![None; nodes.len()]).collect();
        for (component, cuts_at) in aircraft.components.iter().zip(&mut cuts_at) {
            for cut in aircraft.cuts_along(&component.name).unwrap_or_default() {
                cuts_at[node_of(&cut, component.first_beam)] = Some(watched.cuts.len());
                watched.cuts.push(cut);
            }
        }
        Airframe { aircraft: watched, named, sections, nodes, cuts_at, strips, engines, stations, cuts }
    }

    /// The stations that are at the sections.
    pub fn at_sections(&self) -> Range<usize> {
        self.named[0]..self.aircraft.stations.len()
    }

    /// The cuts between which a section lies, and how far it is from the first to the second; `None` within a loop, where loads
    /// have no answer.
    pub fn cuts_around(&self, section: usize) -> Option<([usize; 2], f64)> {
        let Section { component, along, .. } = self.sections[section];
        let cuts = &self.cuts_at[component];
        let first = (along as usize).min(cuts.len() - 1);
        let share = along - first as f64;
        let next = if share > 0.0 { cuts[first + 1] } else { cuts[first] };
        Some(([cuts[first]?, next?], share))
    }

    /// Whether there are sections that have no cuts around them.
    pub fn has_loops(&self) -> bool {
        !self.aircraft.joints.is_empty()
    }

    /// From one end of the airframe to the other along the axis in which it is largest, m.
    pub fn size(&self) -> f64 {
        let strips = self.aircraft.strips.iter().zip(&self.strips);
        let edges = strips.flat_map(|(strip, &section)| {
            let middle = self.sections[section].position + strip.forward * strip.elastic_axis_aft_of_midchord;
            [-1.0, 1.0].map(|end| middle + strip.forward * (end * strip.semichord))
        });
        let points = edges.chain(self.sections.iter().map(|section| section.position));
        let (low, high) = points.fold(
            (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)),
            |(low, high), point| (low.inf(&point), high.sup(&point)),
        );
        (high - low).max().max(f64::MIN_POSITIVE)
    }
}

/// The node at which a cut along a component stands, counted from the root.
fn node_of(cut: &Cut, first_beam: usize) -> usize {
    cut.attachment.beam - first_beam + usize::from(cut.attachment.fraction > 0.5)
}

/// Sections as they are found, each once.
struct Places<'a> {
    aircraft: &'a Aircraft,
    sections: Vec<Section>,
    attachments: Vec<Attachment>,
}

impl Places<'_> {
    /// Those of the nodes of a component, root first.
    fn nodes(&mut self, component: usize) -> Vec<usize> {
        let first = self.aircraft.components[component].first_beam;
        let last = first + self.aircraft.components[component].nodes.len() - 2;
        let root = Attachment { beam: first, fraction: 0.0 };
        let ends = (first..=last).map(|beam| Attachment { beam, fraction: 1.0 });
        std::iter::once(root).chain(ends).map(|place| self.section(place)).collect()
    }

    /// That at a place.
    fn section(&mut self, attachment: Attachment) -> usize {
        let Attachment { beam, fraction } = attachment;
        // PROOF: each element is of a component; where that were not so, the place would be drawn with the first.
        let component = self.aircraft.component_of(beam).unwrap_or(0);
        let elements = (beam - self.aircraft.components[component].first_beam) as f64 + fraction;
        let rounded = elements.round();
        let along = if (elements - rounded).abs() < AT_NODE { rounded } else { elements };
        let is_there = |other: &Section| other.component == component && other.along == along;
        if let Some(known) = self.sections.iter().position(is_there) {
            return known;
        }
        let [from, to] = self.aircraft.beams[beam].nodes.map(|node| self.aircraft.nodes[node]);
        self.sections.push(Section { position: from + (to - from) * fraction, component, along });
        self.attachments.push(attachment);
        self.sections.len() - 1
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    pub fn jet() -> Aircraft {
        let path = format!("{}/../aircraft/generic-business-jet.toml", env!("CARGO_MANIFEST_DIR"));
        Aircraft::read(path).unwrap()
    }

    #[test]
    fn every_strip_node_engine_and_station_of_the_jet_has_a_section() {
        let (jet, airframe) = (jet(), Airframe::new(&jet()));
        let nodes: usize = jet.components.iter().map(|component| component.nodes.len()).sum();
        assert_eq!(airframe.nodes.iter().map(Vec::len).sum::<usize>(), nodes);
        assert_eq!(airframe.at_sections().len(), airframe.sections.len());
        assert_eq!(airframe.aircraft.cuts.len(), jet.cuts.len() + nodes);
        for (strip, &section) in jet.strips.iter().zip(&airframe.strips) {
            let at = airframe.aircraft.stations[airframe.named[0] + section].attachment;
            assert_eq!(at, strip.attachment);
        }
        for (component, nodes) in jet.components.iter().zip(&airframe.nodes) {
            for (&node, &section) in component.nodes.iter().zip(nodes) {
                assert!((jet.nodes[node] - airframe.sections[section].position).norm() < 1e-12);
            }
        }
        assert!((24.0..27.0).contains(&airframe.size()), "{}", airframe.size());
    }

    #[test]
    fn a_section_lies_between_the_cuts_of_its_element() {
        let airframe = Airframe::new(&jet());
        for (section, Section { component, along, .. }) in airframe.sections.iter().enumerate() {
            let ([inner, outer], share) = airframe.cuts_around(section).unwrap();
            let cuts = [inner, outer].map(|cut| &airframe.aircraft.cuts[cut]);
            let name = &airframe.aircraft.components[*component].name;
            assert!(cuts.iter().all(|cut| cut.component == *name));
            assert!(
                (0.0..1.0).contains(&share) && cuts[0].name.ends_with(&format!("{:02}", *along as usize))
            );
        }
    }
}

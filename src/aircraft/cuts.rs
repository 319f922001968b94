//! Where the airframe can be cut in thought, and what is outboard of a cut [theory: section-loads.outboard].

use super::components::component_named;
use super::error::{Problem, Report};
use super::model::{Aircraft, Attachment, Component, Cut};
use super::schema::CutSpec;

/// Nodes whose distances to a place differ by less than this share of the component's length are equally near.
const EQUALLY_NEAR: f64 = 1e-9;

/// The cuts of a file; what hangs on no component is reported.
pub(super) fn cuts(specs: &[CutSpec], aircraft: &Aircraft, report: &Report) -> Vec<Cut> {
    let cut = |spec: &CutSpec| {
        let names = aircraft.components.iter().map(|component| component.name.as_str());
        let component = component_named(&spec.component, names, report)?;
        let node = aircraft.node_nearest(component, spec.at);
        let cut = Cut { asked: spec.at, ..aircraft.cut(&spec.name.value, component, node) };
        if let Some(joint) = aircraft.loop_through(&cut) {
            let found = format!("found a cut within the loop that is closed by {joint}");
            let allowed = "a cut beside loops is allowed: within one the structure is statically indeterminate, summation has no \
                           unique answer";
            report.add(Problem::Contradiction, &spec.name.place, found, allowed);
        }
        Some(cut)
    };
    specs.iter().filter_map(cut).collect()
}

impl Aircraft {
    /// Cuts at every node of a component, named after it and numbered from its root: `wing_right_00` and on; none within loops, where
    /// summation has no unique answer. `None` without such a component.
    ///
    /// ```
    /// # use flexible_aircraft::{Aircraft, ReducedModel};
    /// # use flexible_aircraft::plant::{Plant, PlantSettings};
    /// let mut wing = Aircraft::read("aircraft/goland-wing.toml")?;
    /// wing.cuts = wing.cuts_along("wing").ok_or("no such component")?;
    /// let model = ReducedModel::new(&wing, 4)?;
    /// let settings = PlantSettings::of(&model);
    /// let plant = Plant::under(&model, &settings)?;
    /// let trim = plant.trim(&settings.trim_condition())?;
    /// let loads = plant.loads_at(&trim.state, &trim.controls, &mut plant.workspace());
    /// assert_eq!(loads.len(), wing.nodes.len());
    /// assert!(loads.windows(2).all(|nodes| nodes[1].bending.abs() <= nodes[0].bending.abs()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cuts_along(&self, component: &str) -> Option<Vec<Cut>> {
        let index = self.components.iter().position(|other| other.name == component)?;
        let nodes = self.components[index].nodes.len();
        let digits = (nodes - 1).to_string().len().max(2);
        let cut = |node| self.cut(&format!("{component}_{node:0digits$}"), index, node);
        Some((0..nodes).map(cut).filter(|cut| self.loop_through(cut).is_none()).collect())
    }

    /// A cut at a node of a component, counted from its root.
    fn cut(&self, name: &str, component: usize, node: usize) -> Cut {
        let cut = &self.components[component];
        let elements = cut.nodes.len() - 1;
        let attachment = if node < elements {
            Attachment { beam: cut.first_beam + node, fraction: 0.0 }
        } else {
            Attachment { beam: cut.first_beam + elements - 1, fraction: 1.0 }
        };
        let distances = self.distances(cut);
        let at = distances[node] / distances[elements];
        let mut outboard = Vec::new();
        self.add_outboard(component, node, &mut outboard);
        outboard.sort_unstable();
        Cut { name: name.to_owned(), component: cut.name.clone(), at, asked: at, attachment, outboard }
    }

    /// Adds the elements of a component beyond one of its nodes, and those of all that hangs there or beyond.
    fn add_outboard(&self, component: usize, node: usize, elements: &mut Vec<usize>) {
        let Component { first_beam, nodes, .. } = &self.components[component];
        elements.extend(first_beam + node..first_beam + nodes.len() - 1);
        for (child, Component { parent, .. }) in self.components.iter().enumerate() {
            if parent.is_some_and(|(other, at)| other == component && at >= node) {
                self.add_outboard(child, 0, elements);
            }
        }
    }

    /// The node of a component, counted from its root, that is nearest to a fraction of its length; of two the inner one.
    fn node_nearest(&self, component: usize, at: f64) -> usize {
        let distances = self.distances(&self.components[component]);
        let length = distances[distances.len() - 1];
        let away = |node: usize| (distances[node] / length - at).abs();
        (1..distances.len()).fold(
            0,
            |best, node| {
                if away(node) < away(best) - EQUALLY_NEAR { node } else { best }
            },
        )
    }

    /// How far each node of a component is from its root along the axis, m.
    pub(super) fn distances(&self, component: &Component) -> Vec<f64> {
        let mut distances = vec![0.0];
        for ends in component.nodes.windows(2) {
            let before = distances[distances.len() - 1];
            distances.push(before + (self.nodes[ends[1]] - self.nodes[ends[0]]).norm());
        }
        distances
    }
}

//! Which beams run along a panel: stretches of components on which its fraction goes one way.

use nalgebra::Vector3;

use super::super::structure::{Component, NodeRef, Structure};
use super::panel::{CarriedBy, Panel, SAME};

/// Elements whose direction has at least this cosine with the span of a panel can carry it.
const SPANWISE: f64 = 0.3;

/// What the format takes of the beam's place along the chord.
pub const ELASTIC_AXES: std::ops::RangeInclusive<f64> = -1.0..=2.0;

/// Part of a component that runs along a panel: its nodes, and the fractions of the panel there.
pub struct Run {
    pub component: usize,
    /// The first of its nodes.
    pub first: usize,
    pub fractions: Vec<f64>,
}

impl Run {
    fn ends(&self) -> [f64; 2] {
        [self.fractions[0], self.fractions[self.fractions.len() - 1]]
    }

    pub fn from(&self) -> f64 {
        self.ends()[0].min(self.ends()[1])
    }

    pub fn to(&self) -> f64 {
        self.ends()[0].max(self.ends()[1])
    }

    /// The place between its nodes where the panel has a fraction: an element of the component, and the share of it.
    pub fn place(&self, fraction: f64) -> (usize, f64) {
        let last = self.fractions.len() - 2;
        let holds = |pair: &[f64]| (pair[0] - fraction) * (pair[1] - fraction) <= 0.0;
        let element = self.fractions.windows(2).position(holds).unwrap_or({
            let [begin, end] = self.ends().map(|end| (end - fraction).abs());
            if begin < end { 0 } else { last }
        });
        let [begin, end] = [self.fractions[element], self.fractions[element + 1]];
        (self.first + element, ((fraction - begin) / (end - begin)).clamp(0.0, 1.0))
    }

    /// Where along the component, as a fraction of its length, the panel has a fraction.
    pub fn along(&self, component: &Component) -> impl Fn(f64) -> f64 + '_ {
        let distances = component.distances();
        move |fraction| {
            let (element, share) = self.place(fraction);
            let at = distances[element] + share * (distances[element + 1] - distances[element]);
            let along = at / distances[distances.len() - 1];
            // Rounding of a panel that begins or ends with the beam.
            let end = along.round();
            if (along - end).abs() < 1e-3 * SAME { end } else { along }
        }
    }

    /// The point of the component there, m from O.
    pub fn point(&self, component: &Component, fraction: f64) -> Vector3<f64> {
        let (element, share) = self.place(fraction);
        component.points[element].lerp(&component.points[element + 1], share)
    }

    /// The panel's fractions at two places along the component, in ascending order.
    pub fn across(&self, component: &Component, ends: [f64; 2]) -> [f64; 2] {
        let distances = component.distances();
        let nodes = &distances[self.first..self.first + self.fractions.len()];
        let [one, other] = ends.map(|end| {
            let at = (end * distances[distances.len() - 1]).clamp(nodes[0], nodes[nodes.len() - 1]);
            let element = nodes.windows(2).position(|pair| at <= pair[1]).unwrap_or(nodes.len() - 2);
            let share = (at - nodes[element]) / (nodes[element + 1] - nodes[element]);
            self.fractions[element] + share * (self.fractions[element + 1] - self.fractions[element])
        });
        [one.min(other), one.max(other)]
    }

    /// Whether it runs where the format has a beam in the chords of the panel, somewhere at least.
    fn is_beside(&self, component: &Component, panel: &Panel) -> bool {
        let [from, to] = [self.from().max(0.0), self.to().min(1.0)];
        [from, 0.5 * (from + to), to].into_iter().any(|fraction| {
            let place = self.point(component, fraction);
            ELASTIC_AXES.contains(&panel.outline.chord_fraction(&place, fraction))
        })
    }

    /// Whether a gap beside what the run carries is less than half of its element there.
    pub fn is_near(&self, gap: &[f64; 2], ends: &[f64; 2]) -> bool {
        let at = if gap[1] <= ends[0] + SAME { ends[0] } else { ends[1] };
        let (element, _) = self.place(at);
        let place = element - self.first;
        let width = (self.fractions[place + 1] - self.fractions[place]).abs();
        gap[1] - gap[0] <= 0.5 * width
    }
}

/// All that may carry a panel: a beam that was made for it, else those of its grids, else those beside it.
pub fn beside(structure: &Structure, (place, panel): (usize, &Panel)) -> Vec<Run> {
    let is_own =
        |component: &Component| component.made_for.as_ref().is_some_and(|made_for| made_for.panel == place);
    let of_component = |component: usize| runs(&structure.components[component], component, panel);
    if let Some(own) = structure.components.iter().position(is_own) {
        return of_component(own);
    }
    let all = candidates(structure, panel).into_iter().flat_map(of_component);
    all.filter(|run| run.is_beside(&structure.components[run.component], panel)).collect()
}

/// Components that may carry a panel.
fn candidates(structure: &Structure, panel: &Panel) -> Vec<usize> {
    let component = |node: NodeRef| match node {
        NodeRef::Origin => None,
        NodeRef::Node { component, .. } => Some(component),
    };
    let mut found: Vec<usize> = match &panel.carried_by {
        CarriedBy::Grids(grids) => {
            // A beam that begins at a node of another one has it too.
            let nodes = structure.nodes_of(grids);
            let begins = |component: &Component| nodes.contains(&component.parent);
            let beginning =
                (0..structure.components.len()).filter(|&place| begins(&structure.components[place]));
            nodes.iter().copied().filter_map(component).chain(beginning).collect()
        }
        CarriedBy::Between(grids) => {
            let nodes = structure.nodes_of(grids).into_iter().filter_map(component);
            nodes.flat_map(|component| structure.with_parents(component)).collect()
        }
        CarriedBy::Nearest => nearest(structure, panel),
    };
    found.sort_unstable();
    found.dedup();
    found
}

/// The components beside the middles of the panel's boxes.
fn nearest(structure: &Structure, panel: &Panel) -> Vec<usize> {
    let span = panel.outline.span().normalize();
    let strips = panel.strips();
    let middles = strips.windows(2).map(|edges| 0.5 * (edges[0] + edges[1]));
    middles
        .filter_map(|fraction| {
            let place = panel.outline.at(fraction, 0.4);
            let distance = |component: &Component| {
                let elements =
                    component.points.windows(2).filter(|ends| is_spanwise(&(ends[1] - ends[0]), &span));
                elements.map(|ends| distance(&place, [&ends[0], &ends[1]])).fold(f64::INFINITY, f64::min)
            };
            let distances = structure.components.iter().map(distance).enumerate();
            distances
                .filter(|(_, distance)| distance.is_finite())
                .min_by(|one, other| one.1.total_cmp(&other.1))
        })
        .map(|(component, _)| component)
        .collect()
}

fn distance(place: &Vector3<f64>, [from, to]: [&Vector3<f64>; 2]) -> f64 {
    let along = to - from;
    let share = ((place - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (place - from - along * share).norm()
}

fn is_spanwise(along: &Vector3<f64>, span: &Vector3<f64>) -> bool {
    along.dot(span).abs() > SPANWISE * along.norm()
}

/// The runs of elements of a component along which a panel's fraction goes one way.
fn runs(component: &Component, place: usize, panel: &Panel) -> Vec<Run> {
    let span = panel.outline.span().normalize();
    let ways: Vec<i8> = component
        .points
        .windows(2)
        .map(|ends| {
            let along = ends[1] - ends[0];
            if is_spanwise(&along, &span) { if along.dot(&span) > 0.0 { 1 } else { -1 } } else { 0 }
        })
        .collect();
    let mut runs = Vec::new();
    let mut first = 0;
    while first < ways.len() {
        let length = ways[first..].iter().take_while(|way| **way == ways[first]).count();
        if ways[first] != 0 {
            let nodes = &component.points[first..=first + length];
            let run = Run {
                component: place,
                first,
                fractions: nodes.iter().map(|node| panel.outline.fraction(node)).collect(),
            };
            if run.from() < 1.0 - SAME && run.to() > SAME {
                runs.push(run);
            }
        }
        first += length;
    }
    runs
}

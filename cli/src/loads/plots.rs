//! Envelopes over the span of components, and bending against torsion at cuts.

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::ReducedCut;
use flexible_aircraft::variables::LoadComponent;

use super::Analysis;
use super::envelope::{Carried, Envelope};
use crate::chart::{Axis, Chart, Curve, Window};

/// What is drawn over the span: the word in file names, and the component.
pub const ALONG: [(&str, LoadComponent); 3] = [
    ("shear", LoadComponent::Shear),
    ("bending", LoadComponent::Bending),
    ("torsion", LoadComponent::Torsion),
];

/// Flights that a plot bears.
const MOST_FLIGHTS: usize = 8;

/// N and N·m are many.
const KILO: f64 = 1e-3;

/// The components that the file cuts, in its order; all where it cuts none. Of some no node can be cut: they are within loops.
pub fn components(aircraft: &Aircraft) -> Vec<&str> {
    let is_cut =
        |name: &str| aircraft.cuts.is_empty() || aircraft.cuts.iter().any(|cut| cut.component == name);
    let has_cuts = |name: &str| aircraft.cuts_along(name).is_some_and(|cuts| !cuts.is_empty());
    let names = aircraft.components.iter().map(|component| component.name.as_str());
    names.filter(|name| is_cut(name) && has_cuts(name)).collect()
}

/// Of each of them the envelopes of each quantity over its length.
pub fn along(analysis: &Analysis, aircraft: &Aircraft) -> Vec<Chart> {
    let charts = components(aircraft).into_iter().flat_map(|component| {
        ALONG.map(|(quantity, load)| along_component(analysis, component, quantity, load))
    });
    charts.collect()
}

fn along_component(analysis: &Analysis, component: &str, quantity: &str, load: LoadComponent) -> Chart {
    let place = LoadComponent::ALL.iter().position(|other| *other == load).unwrap_or_default();
    let nodes = analysis.model.cuts.iter().enumerate().skip(analysis.named);
    let nodes: Vec<(f64, &Envelope)> = nodes
        .filter(|(_, cut)| cut.component == component)
        .filter_map(|(index, cut)| Some((cut.at, analysis.envelopes.of(index)?)))
        .collect();
    let curve = |label: &str, value: &dyn Fn(&Envelope) -> f64| Curve {
        label: label.to_owned(),
        points: nodes.iter().map(|(at, envelope)| (*at, value(envelope) * KILO)).collect(),
    };
    let curves = vec![
        curve("most", &|envelope| envelope.most[place].loads[place]),
        curve("least", &|envelope| envelope.least[place].loads[place]),
        curve("at the beginning", &|envelope| envelope.start[place]),
    ];
    let unit = if load == LoadComponent::Shear { "kN" } else { "kN m" };
    Chart {
        title: format!("{component}: {quantity} over the span"),
        x: Axis::new("fraction of the length, from the root (1)", Window::new(0.0, 1.0)),
        y: Axis::new(
            format!("{quantity} ({unit})"),
            Window::around(curves.iter().flat_map(|c| c.points.iter().map(|p| p.1))),
        ),
        curves,
        marks: Vec::new(),
        frame: None,
    }
}

/// At each cut of the file: how bending and torsion go together in each flight.
pub fn bending_over_torsion(analysis: &Analysis) -> Vec<Chart> {
    let cuts = analysis.model.cuts.iter().enumerate().take(analysis.named);
    let chart = |(index, cut): (usize, &ReducedCut)| {
        let curve = |flight: &Carried| {
            let points = flight.path(index).iter().map(|(x, y)| (x * KILO, y * KILO)).collect();
            Curve { label: analysis.cases.names[flight.case()].clone(), points }
        };
        let curves: Vec<Curve> = drawn(analysis, index).map(curve).collect();
        let points = || curves.iter().flat_map(|curve| curve.points.iter());
        Chart {
            title: format!("{}: bending against torsion", cut.name),
            x: Axis::new("torsion (kN m)", Window::around(points().map(|point| point.0))),
            y: Axis::new("bending (kN m)", Window::around(points().map(|point| point.1))),
            curves,
            marks: Vec::new(),
            frame: None,
        }
    };
    cuts.map(chart).collect()
}

/// The flights that are drawn at a cut: all where they are few, otherwise those that set the envelope of torsion and bending.
fn drawn(analysis: &Analysis, cut: usize) -> impl Iterator<Item = &Carried> {
    let sets_it = move |flight: &&Carried| {
        let Some(Envelope { most, least, .. }) = analysis.envelopes.of(cut) else { return false };
        let extremes = LoadComponent::ALL.into_iter().zip(most.iter().zip(least));
        let mut drawn =
            extremes.filter(|(load, _)| matches!(load, LoadComponent::Torsion | LoadComponent::Bending));
        drawn.any(|(_, (most, least))| [most, least].iter().any(|extreme| extreme.case == flight.case()))
    };
    let few = analysis.flights.len() <= MOST_FLIGHTS;
    analysis.flights.iter().filter(move |flight| few || sets_it(flight))
}

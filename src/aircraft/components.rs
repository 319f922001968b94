//! Which of the components a file speaks of.

use super::document::Located;
use super::error::{Problem, Report};

/// A place is that of a node within this share of the component's length: numbers are written with some digits.
const AT_NODE: f64 = 1e-6;

/// The node at a fraction, if there is one, of those at these.
pub(super) fn at_node(fractions: impl Iterator<Item = f64>, found: f64) -> Option<usize> {
    let away = fractions.map(|fraction| (fraction - found).abs()).enumerate();
    let nearest = away.min_by(|(_, one), (_, other)| one.total_cmp(other));
    nearest.filter(|(_, away)| *away < AT_NODE).map(|(node, _)| node)
}

/// What is allowed in place of a root that has a hinge: before it is a node of something else, and beyond it none.
pub(super) const BESIDE_A_HINGE: &str = "a node beyond the hinge is allowed, or what that component hangs on";

/// What is allowed where a fraction is that of no node: of these, which ascend.
pub(super) fn nodes_allowed(fractions: impl Iterator<Item = f64>, found: f64) -> String {
    let fractions: Vec<f64> = fractions.collect();
    let away = |fraction: &f64| (fraction - found).abs();
    let nearest = fractions.iter().copied().min_by(|one, other| away(one).total_cmp(&away(other)));
    let nearest = nearest.map_or_else(String::new, |nearest| format!(" ({nearest} is the nearest)"));
    let count = fractions.len();
    format!("the fraction of one of its {count} nodes is allowed, 0 and 1 among them{nearest}")
}

/// The place among all components of the one with a name; where there is none, that is reported.
pub(super) fn component_named<'n>(
    name: &Located<String>,
    components: impl Iterator<Item = &'n str>,
    report: &Report,
) -> Option<usize> {
    let names: Vec<&str> = components.collect();
    let place = names.iter().position(|other| *other == name.value);
    if place.is_none() {
        let found = format!("found \"{}\", which is not a component", name.value);
        report.add(Problem::UnknownName, &name.place, found, format!("allowed: {}", names.join(", ")));
    }
    place
}

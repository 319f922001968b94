//! Which of the components a file speaks of.

use super::document::Located;
use super::error::{Problem, Report};

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

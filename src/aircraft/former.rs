//! Files from before controls had tables: four inputs could be named without being described. They are told what to write.

use super::document::Located;
use super::error::{Problem, Report};
use super::schema::FileSpec;

/// The inputs that there were, and the lines of a `[[control]]` that say the same.
const FORMER: [(&str, &[&str]); 4] = [
    ("elevator", &["positive = \"nose-down\"", "mirror = \"same\"", "trim = \"pitch\""]),
    ("aileron", &["positive = \"rolls right\"", "mirror = \"opposite\"", "trim = \"roll\""]),
    ("aileron_symmetric", &["positive = \"trailing edges down\"", "mirror = \"same\""]),
    ("rudder", &["positive = \"nose right\"", "mirror = \"opposite\"", "trim = \"yaw\""]),
];

/// Whether a file could name this input without describing it.
pub(super) fn is_former(name: &str) -> bool {
    FORMER.iter().any(|(former, _)| *former == name)
}

/// Complains about former inputs in a file without any control, once, with the tables that it needs.
pub(super) fn controls(file: &FileSpec, report: &Report) {
    if !file.controls.is_empty() || !file.has_all_controls {
        return;
    }
    let surfaces = file.components.iter().flat_map(|component| &component.surfaces);
    let uses = || surfaces.clone().flat_map(|surface| &surface.moves).map(|used| &used.control);
    let Some(first) = uses().find(|used| is_former(&used.value)) else { return };
    let used = FORMER.iter().filter(|(name, _)| uses().any(|used: &Located<String>| used.value == *name));
    let tables: String = used.map(|(name, lines)| table(name, lines, file)).collect();
    let found = format!("found \"{}\", which is no [[control]]", first.value);
    let allowed = "controls have tables of their own now: add these lines at the end of the file, or anywhere at its top level \
                   before another table in double brackets";
    report.add(Problem::UnknownName, &first.place, found, format!("{allowed}\n{tables}"));
}

/// The table of one control, after an empty line.
fn table(name: &str, lines: &[&str], file: &FileSpec) -> String {
    let limits = file.former_limits.iter().filter(|limits| limits.name == name);
    let limits = limits.flat_map(|limits| limits.lines.iter().map(String::as_str));
    let lines = lines.iter().copied().chain(limits).map(|line| format!("{line}\n"));
    format!("\n[[control]]\nname = \"{name}\"\n{}", lines.collect::<String>())
}

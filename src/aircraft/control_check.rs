//! Names, roles and uses of the controls of a file.

use super::control::Control;
use super::document::Located;
use super::error::{Place, Problem, Report};
use super::schema::{ComponentSpec, ControlSpec, FileSpec, Mirroring, MoveSpec};

/// Names of letters, digits and underscores that a variable has whatever the aircraft, and that of the time.
pub(crate) const TAKEN: &[&str] = &[
    "time",
    "wind_north",
    "wind_east",
    "wind_down",
    "wind_rate_north",
    "wind_rate_east",
    "wind_rate_down",
    "input_reference",
    "model",
    "airspeed",
    "altitude",
    "heading",
    "stiffness_scale",
    "structural_damping",
    "mode_family",
    "mode_count",
    "inflow_states",
    "tolerance",
];

/// What stands behind `trim.` without being a control.
pub(crate) const TAKEN_BY_TRIM: &[&str] = &["pitch", "roll", "beta", "thrust", "climb_angle"];

/// What has to be written for a control that a file could use without naming it, before controls had tables.
const FORMER: [(&str, &str); 4] = [
    ("elevator", "positive = \"nose-down\", mirror = \"same\", trim = \"pitch\""),
    ("aileron", "positive = \"rolls right\", mirror = \"opposite\", trim = \"roll\""),
    ("aileron_symmetric", "positive = \"trailing edges down\", mirror = \"same\""),
    ("rudder", "positive = \"nose right\", mirror = \"opposite\", trim = \"yaw\""),
];

/// Complains about names that variables have, roles given twice, and uses that make no sense.
pub(super) fn controls(file: &FileSpec, report: &Report) {
    for (index, spec) in file.controls.iter().enumerate() {
        name(spec, file, report);
        role(spec, &file.controls[..index], report);
    }
    let mut missing = Vec::new();
    for component in &file.components {
        for used in component.surfaces.iter().flat_map(|surface| &surface.moves) {
            match file.controls.iter().find(|spec| spec.control.name == used.control.value) {
                Some(spec) => side(spec.mirroring, used, component, report),
                None if missing.contains(&&used.control.value) => {}
                None => {
                    missing.push(&used.control.value);
                    unknown(&used.control, &file.controls, report);
                }
            }
        }
    }
}

/// No other variable has its name, nor the names of its outputs.
fn name(spec: &ControlSpec, file: &FileSpec, report: &Report) {
    let Control { name, role, .. } = &spec.control;
    let is_thrust =
        name.strip_prefix("thrust_").is_some_and(|of| file.engines.iter().any(|e| e.name.value == of));
    let taken = if is_thrust || TAKEN.contains(&name.as_str()) {
        name.clone()
    } else if role.is_some() && TAKEN_BY_TRIM.contains(&name.as_str()) {
        format!("trim.{name}")
    } else {
        return;
    };
    let found = format!("found the name \"{name}\", and `{taken}` is another variable");
    report.add(Problem::DuplicateName, &spec.name.place, found, "a name that no variable has is allowed");
}

/// None of those before has the same role.
fn role(spec: &ControlSpec, before: &[ControlSpec], report: &Report) {
    let Some(place) = &spec.role_place else { return };
    if let Some(other) = before.iter().find(|other| other.control.role == spec.control.role) {
        let found = format!("found a role that \"{}\" has already", other.control.name);
        report.add(Problem::Contradiction, place, found, "one control for each role is allowed");
    }
}

/// A side is given where the two sides have gains of their own, and only there.
fn side(mirroring: Mirroring, used: &MoveSpec, component: &ComponentSpec, report: &Report) {
    let name = &used.control.value;
    let contradict = |place: &Place, found: String, allowed: &str| {
        report.add(Problem::Contradiction, place, found, allowed);
    };
    match (mirroring, &component.mirror, &used.hand) {
        (Mirroring::None, Some(_), None) => {
            let found = format!("found no side for \"{name}\", which has mirror = \"none\"");
            let allowed = "\"right\" or \"left\" is needed: of the component and its mirror image the one that it moves";
            report.add(Problem::MissingField, &used.place.within("side"), found, allowed);
        }
        (Mirroring::None, None, Some(hand)) => {
            let found = "found a side on a component without mirror image".to_owned();
            contradict(&hand.place, found, "no side is allowed here");
        }
        (Mirroring::Same | Mirroring::Opposite, _, Some(hand)) => {
            let found = format!("found a side for \"{name}\", whose gains pass to mirror images");
            contradict(&hand.place, found, "a side is allowed for controls with mirror = \"none\"");
        }
        _ => {}
    }
}

/// Complains about a name that is no control's.
fn unknown(used: &Located<String>, controls: &[ControlSpec], report: &Report) {
    let name = &used.value;
    let names: Vec<&str> = controls.iter().map(|spec| spec.control.name.as_str()).collect();
    let allowed = match FORMER.iter().find(|(former, _)| former == name) {
        Some((_, fields)) => format!(
            "controls have tables of their own now: [[control]] with name = \"{name}\", {fields} is needed"
        ),
        None if names.is_empty() => format!("a [[control]] with name = \"{name}\" is needed"),
        None => format!("allowed: {}", names.join(", ")),
    };
    let found = format!("found \"{name}\", which is no [[control]]");
    report.add(Problem::UnknownName, &used.place, found, allowed);
}

//! Names, roles and uses of the controls of a file.

use super::control::{Control, Mirroring, TrimRole};
use super::document::Located;
use super::error::{Place, Problem, Report};
use super::former;
use super::geometry::SAME_PLACE;
use super::model::Aircraft;
use super::roles::Effect;
use super::schema::{ComponentSpec, ControlSpec, FileSpec, MoveSpec};
use super::stretch::Stretch;

/// Names of letters, digits and underscores that a variable has whatever the aircraft, and that of the time: no control has one of these.
pub const TAKEN: &[&str] = &[
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
    "temperature_offset",
    "heading",
    "stiffness_scale",
    "structural_damping",
    "mode_family",
    "mode_count",
    "load_modes",
    "inflow_states",
    "tolerance",
];

/// What stands behind `trim.` without being a control: no control with a role has one of these names.
pub const TAKEN_BY_TRIM: &[&str] =
    &["pitch", "roll", "beta", "thrust", "climb_angle", "alpha", "turn_rate", "pitch_rate", "load_factor"];

/// Complains about names that variables have, roles given twice, and uses that make no sense.
pub(super) fn controls(file: &FileSpec, report: &Report) {
    // What could not be read might have named any.
    let is_whole = report.is_empty();
    for (index, spec) in file.controls.iter().enumerate() {
        name(spec, file, report);
        role(spec, &file.controls[..index], report);
        if is_whole && moves_of(file, &spec.control.name).next().is_none() {
            let found = format!("found \"{}\", which moves no flap: no surface names it", spec.control.name);
            let allowed = "a control is allowed that a surface has as input, or no [[control]] of this name";
            report.add(Problem::Unused, &spec.name.place, found, allowed);
        }
    }
    let mut missing = Vec::new();
    for component in &file.components {
        for surface in &component.surfaces {
            used_once(&surface.moves, report);
        }
        for used in component.surfaces.iter().flat_map(|surface| &surface.moves) {
            match file.controls.iter().find(|spec| spec.control.name == used.control.value) {
                Some(spec) => side(spec.mirroring, used, component, report),
                None if missing.contains(&&used.control.value) => {}
                None => {
                    missing.push(&used.control.value);
                    unknown(&used.control, file, report);
                }
            }
        }
    }
}

/// What a control moves.
fn moves_of<'f>(file: &'f FileSpec, control: &str) -> impl Iterator<Item = &'f MoveSpec> {
    let surfaces = file.components.iter().flat_map(|component| &component.surfaces);
    surfaces.flat_map(|surface| &surface.moves).filter(move |used| used.control.value == control)
}

/// No control moves a stretch of a surface twice.
fn used_once(moves: &[MoveSpec], report: &Report) {
    for (index, later) in moves.iter().enumerate() {
        let is_again = |earlier: &&MoveSpec| {
            let hands = [earlier, &later].map(|used| used.hand.as_ref().map(|hand| hand.value));
            earlier.control.value == later.control.value
                && overlap(&earlier.stretch, &later.stretch)
                && (hands[0].is_none() || hands[1].is_none() || hands[0] == hands[1])
        };
        if let Some(earlier) = moves[..index].iter().find(is_again) {
            let Stretch { from, to } = earlier.stretch;
            let found = format!(
                "found \"{}\" a second time on a stretch that it moves from {from} to {to}",
                later.control.value
            );
            let allowed = "a control is allowed once on each stretch: the sum of the gains";
            report.add(Problem::Overlap, &later.control.place, found, allowed);
        }
    }
}

/// Whether two stretches share some of their component.
fn overlap(one: &Stretch, other: &Stretch) -> bool {
    one.to.min(other.to) - one.from.max(other.from) > SAME_PLACE
}

/// Complains about roles that the flaps of a control cannot play.
pub(super) fn roles(aircraft: &Aircraft, file: &FileSpec, report: &Report) {
    for (index, spec) in file.controls.iter().enumerate() {
        let (Some(place), Some(role)) = (&spec.role_place, spec.control.role) else { continue };
        let effect = Effect::of(aircraft, index);
        let name = &spec.control.name;
        if effect.can_hold(role) || effect.is_none() {
            continue;
        }
        let (found, allowed) = match role {
            TrimRole::Pitch => (
                format!(
                    "found the role of pitch for \"{name}\", whose flaps on both sides act against each other: it cannot pitch"
                ),
                "flaps of a wing or a tailplane that act alike on both sides are allowed with it, as of mirror = \"same\"",
            ),
            TrimRole::Roll | TrimRole::Yaw => (
                format!(
                    "found the role of {} for \"{name}\", whose flaps act alike on both sides: it can neither roll nor yaw",
                    role.word()
                ),
                "flaps that act against each other, as of mirror = \"opposite\", or those of a fin are allowed with it",
            ),
        };
        report.add(Problem::Contradiction, place, found, allowed);
    }
}

/// No other variable has its name, nor the names of its outputs.
fn name(spec: &ControlSpec, file: &FileSpec, report: &Report) {
    let Control { name, role, .. } = &spec.control;
    let is_thrust =
        name.strip_prefix("thrust_").is_some_and(|of| file.engines.iter().any(|e| e.name.value == of));
    let (taken, what) = if is_thrust {
        (name.clone(), "the thrust of an engine of this aircraft")
    } else if name == "time" {
        (name.clone(), "what every table of a flight begins with")
    } else if TAKEN.contains(&name.as_str()) {
        (name.clone(), "a variable of every aircraft")
    } else if role.is_some() && TAKEN_BY_TRIM.contains(&name.as_str()) {
        (format!("trim.{name}"), "a variable of every trim, and would be this control's too")
    } else {
        return;
    };
    let found = format!("found the name \"{name}\", and `{taken}` is {what}");
    report.add(Problem::DuplicateName, &spec.name.place, found, "another name is allowed");
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
fn side(mirroring: Option<Mirroring>, used: &MoveSpec, component: &ComponentSpec, report: &Report) {
    let name = &used.control.value;
    let contradict = |place: &Place, found: String, allowed: &str| {
        report.add(Problem::Contradiction, place, found, allowed);
    };
    match (mirroring, &component.mirror, &used.hand) {
        (Some(Mirroring::None), Some(_), None) => {
            let found = format!("found no side for \"{name}\", which has mirror = \"none\"");
            let allowed = "\"right\" or \"left\" is needed: of the component and its mirror image the one that it moves";
            report.add(Problem::MissingField, &used.place.within("side"), found, allowed);
        }
        (Some(Mirroring::None), None, Some(hand)) => {
            let found = "found a side on a component without mirror image".to_owned();
            contradict(&hand.place, found, "no side is allowed here");
        }
        (Some(Mirroring::Same | Mirroring::Opposite), _, Some(hand)) => {
            let found = format!("found a side for \"{name}\", whose gains pass to mirror images");
            contradict(&hand.place, found, "a side is allowed for controls with mirror = \"none\"");
        }
        _ => {}
    }
}

/// Complains about a name that is no control's.
fn unknown(used: &Located<String>, file: &FileSpec, report: &Report) {
    // Files from before controls had tables are told what to write by `former`.
    if !file.has_all_controls || (file.controls.is_empty() && former::is_former(&used.value)) {
        return;
    }
    let name = &used.value;
    let names: Vec<&str> = file.controls.iter().map(|spec| spec.control.name.as_str()).collect();
    let allowed = match names.as_slice() {
        [] => format!("a [[control]] with name = \"{name}\" is needed"),
        names => format!("allowed: {}", names.join(", ")),
    };
    let found = format!("found \"{name}\", which is no [[control]]");
    report.add(Problem::UnknownName, &used.place, found, allowed);
}

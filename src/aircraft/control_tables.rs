//! The tables `[[control]]` of an aircraft file.

use super::control::{Control, Mirroring, TrimRole};
use super::document::{Table, Value};
use super::error::Problem;
use super::format::{control as fields, file};
use super::limit_tables::{CONTROL_LIMITS, read_control_limits};
use super::limits::Bounds;
use super::schema::ControlSpec;

/// The controls in the order of the file, and whether these are all: what else is wrong with one does not hide its name.
pub(super) fn read_controls(table: &Table) -> (Vec<ControlSpec>, bool) {
    let tables = table.tables(&file::CONTROLS);
    let controls: Vec<ControlSpec> = tables.iter().filter_map(read_control).collect();
    // Where the field is no list of tables there are none of them.
    let is_readable =
        table.optional(&file::CONTROLS).is_none_or(|value| value.is_empty_list()) || !tables.is_empty();
    let has_all = is_readable && controls.len() == tables.len();
    (controls, has_all)
}

/// A control with a name; where something else was complained about, something stands in its place.
fn read_control(table: &Table) -> Option<ControlSpec> {
    let mirrorings = [
        (fields::SAME.word, Mirroring::Same),
        (fields::OPPOSITE.word, Mirroring::Opposite),
        (fields::NONE.word, Mirroring::None),
    ];
    let roles = TrimRole::ALL.map(|role| (role.word(), role));
    let name = table.required(&fields::NAME).and_then(|v| v.located(Value::name));
    let description = table.optional(&fields::DESCRIPTION).and_then(|v| v.phrase());
    let positive = table.required(&fields::POSITIVE).and_then(|v| v.phrase());
    let mirroring = table.required(&fields::MIRROR).and_then(|v| v.one_of(&mirrorings));
    let role = table.optional(&fields::TRIM).and_then(|v| v.located(|v| v.one_of(&roles)));
    let limits = read_control_limits(table);
    if table.optional(&fields::TRIM).is_none() {
        check_neutral(table, &limits);
    }
    let name = name?;
    Some(ControlSpec {
        control: Control {
            name: name.value.clone(),
            description: description.unwrap_or_else(|| format!("Angle of {}", name.value)),
            positive: positive.unwrap_or_default(),
            limits,
            role: role.as_ref().map(|role| role.value),
            mirroring: mirroring.unwrap_or(Mirroring::None),
        },
        mirroring,
        name,
        role_place: role.map(|role| role.place),
    })
}

/// A control without a role is neutral in every trim.
fn check_neutral(table: &Table, limits: &Bounds) {
    let [minimum, maximum] = CONTROL_LIMITS;
    let (low, high) = (limits.minimum.value(), limits.maximum.value());
    let is_above = low.is_some_and(|low| low > 0.0);
    // What is upside down has been complained about.
    let is_upside_down = low.zip(high).is_some_and(|(low, high)| low >= high);
    if is_upside_down || limits.exceeded_by(0.0).is_none() {
        return;
    }
    let value = table.optional(if is_above { minimum } else { maximum });
    let found = "found a limit that excludes 0, where a control without a role stands in every trim";
    let allowed =
        "limits with 0 between them are allowed, others with a role: trim = \"pitch\", \"roll\" or \"yaw\"";
    let place = value.map_or_else(|| table.place.clone(), |value| value.place);
    table.report.add(Problem::Contradiction, &place, found, allowed);
}

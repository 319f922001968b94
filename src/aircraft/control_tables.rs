//! The tables `[[control]]` of an aircraft file.

use super::control::{Control, TrimRole};
use super::document::{Table, Value};
use super::limit_tables::read_control_limits;
use super::schema::{ControlSpec, Mirroring};

/// What `[[control]]` may hold.
const CONTROL: &[&str] = &["name", "description", "positive", "mirror", "trim", "minimum_deg", "maximum_deg"];

/// The controls in the order of the file.
pub(super) fn read_controls(file: &Table) -> Vec<Option<ControlSpec>> {
    file.tables("control", CONTROL).iter().map(read_control).collect()
}

fn read_control(table: &Table) -> Option<ControlSpec> {
    let mirrorings =
        [("same", Mirroring::Same), ("opposite", Mirroring::Opposite), ("none", Mirroring::None)];
    let roles = [("pitch", TrimRole::Pitch), ("roll", TrimRole::Roll), ("yaw", TrimRole::Yaw)];
    let name = table.required("name").and_then(|v| v.located(Value::name));
    let description = table.optional("description").and_then(|v| v.text());
    let positive = table.required("positive").and_then(|v| v.text());
    let mirroring = table.required("mirror").and_then(|v| v.one_of(&mirrorings));
    let role = table.optional("trim").and_then(|v| v.located(|v| v.one_of(&roles)));
    let limits = read_control_limits(table);
    let name = name?;
    Some(ControlSpec {
        control: Control {
            name: name.value.clone(),
            description: description.unwrap_or_else(|| format!("Angle of {}", name.value)),
            positive: positive?,
            limits,
            role: role.as_ref().map(|role| role.value),
        },
        mirroring: mirroring?,
        name,
        role_place: role.map(|role| role.place),
    })
}

//! What an aircraft file says of the wind tunnel around a clamped aircraft [theory: air.tunnel].

use nalgebra::Vector3;

use super::document::{Located, Table, Value};
use super::error::Problem;
use super::format::allowed::PITCH_DEG;
use super::format::file;
use super::model::TunnelAir;

/// `density_kg_m3` and, with it alone, `temperature_K`.
pub(super) fn read_air(table: &Table) -> Option<Located<TunnelAir>> {
    let temperature = table.number(&file::TEMPERATURE_FIELD);
    let Some(density) = table.optional(&file::DENSITY_FIELD) else {
        if let Some(temperature) = table.optional(&file::TEMPERATURE_FIELD) {
            let found = "found a temperature without density_kg_m3";
            let allowed =
                "both together are allowed; at an altitude_m the air has that of the standard atmosphere";
            table.report.add(Problem::Contradiction, &temperature.place, found, allowed);
        }
        return None;
    };
    for field in [&file::ALTITUDE_FIELD, &file::OFFSET_FIELD] {
        if let Some(value) = table.optional(field) {
            let found = format!("found \"{}\" and \"density_kg_m3\"", field.name);
            table.report.add(Problem::Contradiction, &value.place, found, "one of the two is allowed");
        }
    }
    density.located(|value| Some(TunnelAir { density: value.number()?, temperature }))
}

/// Roll, pitch and yaw, rad.
pub(super) fn read_mount(value: &Value) -> Option<Vector3<f64>> {
    let degrees = value.vector()?;
    if !PITCH_DEG.range.contains(degrees.y) {
        let found = format!("found a pitch of {}", degrees.y);
        value.report.add(Problem::OutOfRange, &value.place, found, PITCH_DEG.text());
        return None;
    }
    Some(degrees.map(f64::to_radians))
}

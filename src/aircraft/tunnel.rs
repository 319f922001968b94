//! What an aircraft file says of the wind tunnel around a clamped aircraft [theory: air.tunnel].

use nalgebra::Vector3;

use super::allowed::{DENSITY, TEMPERATURE, TURN_DEG};
use super::document::{Located, Table, Value};
use super::error::Problem;
use super::model::TunnelAir;

/// `density_kg_m3` and, with it alone, `temperature_K`.
pub(super) fn read_air(table: &Table) -> Option<Located<TunnelAir>> {
    let temperature = table.number_or("temperature_K", &TEMPERATURE, 288.15);
    let Some(density) = table.optional("density_kg_m3") else {
        if let Some(temperature) = table.optional("temperature_K") {
            let found = "found a temperature without density_kg_m3";
            let allowed =
                "both together are allowed; at an altitude_m the air has that of the standard atmosphere";
            table.report.add(Problem::Contradiction, &temperature.place, found, allowed);
        }
        return None;
    };
    if let Some(altitude) = table.optional("altitude_m") {
        let found = "found \"altitude_m\" and \"density_kg_m3\"";
        table.report.add(Problem::Contradiction, &altitude.place, found, "one of the two is allowed");
    }
    density.located(|value| Some(TunnelAir { density: value.number(&DENSITY)?, temperature }))
}

/// Roll, pitch and yaw, rad.
pub(super) fn read_mount(value: &Value) -> Option<Vector3<f64>> {
    let degrees = value.vector(&TURN_DEG)?;
    if degrees.y.abs() > 89.0 {
        let found = format!("found a pitch of {}", degrees.y);
        value.report.add(
            Problem::OutOfRange,
            &value.place,
            found,
            "a pitch in degrees from -89 to 89 is allowed",
        );
        return None;
    }
    Some(degrees.map(f64::to_radians))
}

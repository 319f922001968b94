//! Tables of continuous turbulence: as comma-separated values, as JSON.

use flexible_aircraft::structure::ReducedModel;
use serde_json::{Value, json};

use super::{Direction, Found, Row};
use crate::numbers::Plain;

/// Every output in each direction.
pub fn csv(found: &Found) -> String {
    let mut text =
        "direction_deg,output,unit,trim,a_bar_per_m_s,n0_hz,u_sigma_m_s,least,greatest\n".to_owned();
    for direction in &found.directions {
        for Row { output, trim, rms, crossings, limits } in found.rows(direction) {
            let numbers = [trim, rms, crossings, found.velocity, limits[0], limits[1]];
            let numbers = numbers.map(|number| Plain(number).to_string()).join(",");
            text += &format!("{},{},{},{numbers}\n", Plain(direction.degrees), output.name, output.unit);
        }
    }
    text
}

/// The same, with the turbulence.
pub fn json(model: &ReducedModel, found: &Found) -> String {
    let rows = |direction: &Direction| -> Vec<Value> {
        let row = |Row { output, trim, rms, crossings, limits }: Row| {
            json!({
                "output": output.name,
                "unit": output.unit,
                "trim": trim,
                "a_bar_per_m_s": rms,
                "n0_hz": crossings,
                "least": limits[0],
                "greatest": limits[1],
            })
        };
        found.rows(direction).map(row).collect()
    };
    let direction = |direction: &Direction| {
        let frequencies = &direction.outputs.frequencies;
        json!({
            "direction_deg": direction.degrees,
            "frequencies": frequencies.len(),
            "frequency_range_rad_s": [frequencies.first(), frequencies.last()],
            "moved": direction.outputs.moved,
            "outputs": rows(direction),
        })
    };
    let all = json!({
        "aircraft": model.name,
        "spectrum": found.spectrum(),
        "scale_m": found.turbulence.length(),
        "u_sigma_m_s": found.velocity,
        "warnings": found.warnings,
        "directions": found.directions.iter().map(direction).collect::<Vec<_>>(),
    });
    format!("{all:#}\n")
}

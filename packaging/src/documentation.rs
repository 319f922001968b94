//! The documentation page of an FMU: a template filled with the aircraft's picture and its variables.

use std::fmt::Write;

use flexible_aircraft::aircraft::{Aircraft, Support};
use quick_xml::escape::escape;

use crate::model_description::Variable;
use crate::plan_view;

const TEMPLATE: &str = include_str!("../../modelDescription/documentation.html");

/// The page, which needs no other file.
pub(crate) fn page(aircraft: &Aircraft, variables: &[Variable]) -> String {
    TEMPLATE
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{support}}", &support(aircraft))
        .replace("{{plan_view}}", &plan_view::svg(aircraft))
        .replace("{{variables}}", &rows(variables))
        .replace("{{aircraft}}", &escape(aircraft.name.as_str()))
}

/// What happens with the default parameters, and what the parameters of the flight mean.
fn support(aircraft: &Aircraft) -> String {
    match aircraft.support {
        Support::Free => {
            let level = if aircraft.engines.is_empty() {
                "straight, and glides at <code>trim.climb_angle</code>"
            } else {
                "straight and level"
            };
            format!(
                "With the default parameters and all inputs zero the aircraft flies trimmed, {level}: it is trimmed when \
                 initialisation ends, and surface and thrust inputs count from the trim values \
                 (<code>input_reference = trim</code>). One that is not symmetric is banked by <code>trim.roll</code>."
            )
        }
        Support::Clamped => {
            let air = match aircraft.tunnel_air {
                Some(air) => format!("its air has {} kg/m³", air.density),
                None => "<code>altitude</code> chooses its air".to_owned(),
            };
            format!(
                "The aircraft is clamped at O in a wind tunnel: it does not move as a whole, and stands as its file says. \
                 <code>airspeed</code> is the speed of the tunnel's flow, {air}, and <code>heading</code> turns aircraft and \
                 flow together. Incidence comes from <code>wind_down</code> or from the aircraft file alone. When \
                 initialisation ends the aircraft is in equilibrium with the flow; there is nothing to trim, so all \
                 <code>trim.*</code> are 0, and surface and thrust inputs are the values themselves."
            )
        }
    }
}

fn rows(variables: &[Variable]) -> String {
    let mut rows = String::new();
    for Variable { name, causality, unit, start, description, .. } in variables {
        let [name, causality, unit, start, description] =
            [name, causality, unit, start, description].map(|text| escape(text.as_str()));
        // Writing to a `String` cannot fail.
        let _ = writeln!(
            rows,
            "<tr><td><code>{name}</code></td><td>{causality}</td><td>{unit}</td><td>{start}</td>\
             <td>{description}</td></tr>"
        );
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_says_how_the_aircraft_is_held() {
        let text = include_str!("../../aircraft/generic-business-jet.toml");
        let mut aircraft = Aircraft::parse(text, "jet").unwrap();
        let free = page(&aircraft, &[]);
        aircraft.support = Support::Clamped;
        let clamped = page(&aircraft, &[]);
        assert!(free.contains("flies trimmed") && !free.contains("wind tunnel"));
        assert!(clamped.contains("wind tunnel") && !clamped.contains("flies trimmed"));
        assert!(!free.contains("{{") && !clamped.contains("{{"));
    }

    #[test]
    fn a_variable_becomes_a_row_and_marks_are_escaped() {
        let variable = Variable {
            name: "modal.q[1]".into(),
            causality: "output".into(),
            description: "a < b".into(),
            ..Variable::default()
        };
        let row =
            "<tr><td><code>modal.q[1]</code></td><td>output</td><td></td><td></td><td>a &lt; b</td></tr>\n";
        assert_eq!(rows(&[variable]), row);
    }
}

//! The documentation page of an FMU: a template filled with the aircraft's picture and its variables.

use std::fmt::Write;

use flexible_aircraft::aircraft::Aircraft;
use quick_xml::escape::escape;

use crate::model_description::Variable;
use crate::plan_view;

const TEMPLATE: &str = include_str!("../../modelDescription/documentation.html");

/// The page, which needs no other file.
pub(crate) fn page(aircraft: &Aircraft, variables: &[Variable]) -> String {
    TEMPLATE
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{plan_view}}", &plan_view::svg(aircraft))
        .replace("{{variables}}", &rows(variables))
        .replace("{{aircraft}}", &escape(aircraft.name.as_str()))
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

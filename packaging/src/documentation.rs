//! The documentation page of an FMU: a template filled with the aircraft's picture and its variables.

use std::fmt::Write;

use flexible_aircraft::aircraft::{Aircraft, Control, Support};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{Slot, Type, Value, Variable, VariableTable};
use quick_xml::escape::escape;

use crate::plan_view;

const TEMPLATE: &str = include_str!("../../modelDescription/documentation.html");

/// How a flight begins otherwise than straight and level.
const CONDITIONS: &str = "<p>The parameters <code>condition.*</code> have the flight begin otherwise than straight and level: in a climb \
     (<code>climb_angle</code>), a coordinated turn (<code>manoeuvre = turn</code>, by <code>bank_angle</code> or \
     <code>load_factor</code>, negative to the left), a pull-up (<code>pull_up</code>, by <code>load_factor</code>; for a moment, since gravity \
     turns away), with sideslip or bank (<code>lateral</code>), or without the thrust of one engine (<code>failed_engine</code>, by its number). The \
     trim is then that of this flight, and inputs add to it.</p>\n";

/// What positive section loads do.
const SIGNS_OF_LOADS: &str = "<li><code>loads.*</code> are force and moment of all that acts outboard of a cut, in the axes of its \
     deformed section. <code>shear</code> is positive upwards (on a fin to the left), <code>shear_chordwise</code> forward (of a body to \
     the right), <code>axial</code> outboard; <code>torsion</code> nose-up (on a fin nose-left, of a body about its forward axis), \
     <code>bending</code> raises the tip, <code>bending_chordwise</code> moves it forward.</li>\n";

/// How far they go.
const LIMITS_OF_LOADS: &str = "<li>Strips and bays are lumps: near the root of a beam section loads jump from one to the next. They are \
     sums of what acts, not stress resultants of the modes, which converge slowly with the number of modes. Where components \
     meet at O they sum to zero, but with <code>consistently_linearised</code> in manoeuvres and with \
     <code>ruthlessly_linearised</code>, which do not balance there.</li>\n";

/// What the outputs that share the first part of their name are.
const OUTPUT_GROUPS: [(&str, &str); 21] = [
    ("position", "Position"),
    ("attitude", "Attitude"),
    ("velocity", "Velocity"),
    ("rate", "Angular velocity"),
    ("acceleration", "Rate of change of the velocity components"),
    ("load_factor", "Load factor"),
    ("load_factor_cg", "Load factor at the centre of mass"),
    ("angular_acceleration", "Rate of change of the angular velocity"),
    ("path", "Path over the ground"),
    ("loads", "What sections carry"),
    ("air", "Flow at O"),
    ("wind", "Velocity of the air at O"),
    ("gust", "The single gust"),
    ("deflection", "Deflections of the stations"),
    ("station", "Accelerometers and rate gyros at the stations, where they are and how they stand"),
    ("modal", "Modal coordinates"),
    ("surface", "Acting surface angles"),
    ("engine", "Acting thrusts"),
    ("trim", "Trim"),
    ("actuator", "What actuators do"),
    ("sensor", "What sensors give"),
];

/// Variables that stand in one table.
#[derive(Debug, PartialEq)]
struct Group<'a> {
    title: String,
    /// Where links lead.
    anchor: &'a str,
    variables: Vec<&'a Variable>,
}

/// The page, which needs no other file.
pub(crate) fn page(aircraft: &Aircraft, model: &ReducedModel, starts: &Settings) -> String {
    let table = VariableTable::starting(model, starts);
    let groups = groups(&table);
    TEMPLATE
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{support}}", &support(aircraft))
        .replace("{{controls}}", &controls(aircraft))
        .replace("{{conditions}}", if aircraft.support == Support::Free { CONDITIONS } else { "" })
        .replace("{{loads}}", if model.cuts.is_empty() { "" } else { SIGNS_OF_LOADS })
        .replace("{{limits_of_loads}}", if model.cuts.is_empty() { "" } else { LIMITS_OF_LOADS })
        .replace("{{level}}", starts.plant.fidelity.name())
        .replace("{{facts}}", &facts(aircraft, model))
        .replace("{{plan_view}}", &plan_view::svg(aircraft))
        .replace("{{contents}}", &contents(&groups))
        .replace("{{variables}}", &groups.iter().map(section).collect::<String>())
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
                 initialisation ends, and control and thrust inputs count from the trim values \
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
                 <code>trim.*</code> are 0, and control and thrust inputs are the values themselves."
            )
        }
    }
}

/// What positive angles of the controls do, and what else users should know of them.
fn controls(aircraft: &Aircraft) -> String {
    let line = |control: &Control| {
        let positive = escape(control.positive.as_str());
        let facts = control.facts().join("; ");
        format!("<li>Positive <code>{}</code>: {positive}. It {facts}.</li>\n", control.name)
    };
    aircraft.controls.iter().map(line).collect()
}

/// The aircraft in numbers.
fn facts(aircraft: &Aircraft, model: &ReducedModel) -> String {
    let mass: f64 = aircraft.bays.iter().map(|bay| bay.mass).sum();
    let count = |number: usize, one: &str, many: &str| match number {
        1 => format!("1 {one}"),
        _ => format!("{number} {many}"),
    };
    let frequency = model.modes.iter().map(|mode| mode.angular_frequency / std::f64::consts::TAU);
    let lowest = frequency.fold(f64::INFINITY, f64::min);
    let natural = model.natural_modes();
    let load_modes = match model.modes.len() - natural {
        0 => String::new(),
        loads => format!("; {} beside them", count(loads, "load mode", "load modes")),
    };
    format!(
        "{mass:.0} kg, {}, {}, {}, {}{}{load_modes}.",
        count(aircraft.beams.len(), "beam element", "beam elements"),
        count(aircraft.strips.len(), "aerodynamic strip", "aerodynamic strips"),
        count(aircraft.engines.len(), "engine", "engines"),
        count(natural, "mode", "modes"),
        if lowest.is_finite() { format!(" from {lowest:.3} Hz on (clamped at O)") } else { String::new() }
    )
}

/// Inputs, parameters, then outputs by the first part of their names, all in the order of the table.
fn groups(table: &VariableTable) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for (_, variable) in table.iter() {
        let anchor = match variable.slot {
            Slot::Input(_) => "inputs",
            Slot::Parameter(_) => "parameters",
            Slot::Output(_) => variable.name.split('.').next().unwrap_or_default(),
        };
        match groups.iter_mut().find(|group| group.anchor == anchor) {
            Some(group) => group.variables.push(variable),
            None => groups.push(Group { title: title(anchor), anchor, variables: vec![variable] }),
        }
    }
    groups
}

fn title(anchor: &str) -> String {
    match anchor {
        "inputs" => "Inputs".to_owned(),
        "parameters" => "Parameters".to_owned(),
        part => {
            let known = OUTPUT_GROUPS.iter().find(|(name, _)| *name == part);
            format!("{}: <code>{part}.*</code>", known.map_or("Outputs", |(_, title)| *title))
        }
    }
}

fn contents(groups: &[Group]) -> String {
    let link = |group: &Group| {
        let name = match group.anchor {
            "inputs" => "inputs".to_owned(),
            "parameters" => "parameters".to_owned(),
            part => format!("<code>{part}.*</code>"),
        };
        format!("<a href=\"#{}\">{name}</a>\n", group.anchor)
    };
    groups.iter().map(link).collect()
}

/// A heading and a table. A narrow screen shows each row as a paragraph, in which the cells say what they are.
fn section(group: &Group) -> String {
    let Group { title, anchor, variables } = group;
    let cells = |variable: &Variable| {
        let unit = variable.unit.map_or("", |unit| unit.name()).to_owned();
        [
            ("unit", unit),
            ("start", start(variable)),
            ("min", limit(variable, variable.min)),
            ("max", limit(variable, variable.max)),
        ]
    };
    let columns = ["unit", "start", "min", "max"];
    let used =
        [0, 1, 2, 3].map(|column| variables.iter().any(|variable| !cells(variable)[column].1.is_empty()));
    let heads: String = columns
        .iter()
        .zip(used)
        .filter(|(_, used)| *used)
        .map(|(name, _)| format!("<th>{name}</th>"))
        .collect();
    let mut section = format!(
        "<h3 id=\"{anchor}\">{title}</h3>\n<table class=\"variables\">\n<thead><tr><th>name</th>{heads}<th>meaning</th></tr></thead>\n"
    );
    for variable in variables {
        let cells: String = cells(variable)
            .iter()
            .zip(used)
            .filter(|(_, used)| *used)
            .map(|((name, text), _)| format!("<td data-name=\"{name}\">{}</td>", escape(text.as_str())))
            .collect();
        // PROOF: writing to a string does not fail.
        let _ = writeln!(
            section,
            "<tr><td><code>{}</code></td>{cells}<td>{}</td></tr>",
            escape(variable.name.as_str()),
            meaning(variable)
        );
    }
    section + "</table>\n"
}

fn start(variable: &Variable) -> String {
    match variable.start {
        Some(Value::Integer(number)) => number.to_string(),
        Some(Value::Real(number)) => plain(number),
        Some(Value::Boolean(flag)) => flag.to_string(),
        None => String::new(),
    }
}

/// Of enumerations the list of items says it.
fn limit(variable: &Variable, limit: Option<f64>) -> String {
    match variable.kind {
        Type::Enumeration(_) | Type::Boolean => String::new(),
        Type::Real | Type::Integer => limit.map(plain).unwrap_or_default(),
    }
}

/// As a reader would write it: 7620, 0.1, 1e-5.
fn plain(number: f64) -> String {
    if number != 0.0 && number.abs() < 1e-3 { format!("{number:e}") } else { number.to_string() }
}

fn meaning(variable: &Variable) -> String {
    let mut meaning = escape(variable.description.as_str()).into_owned();
    if let Type::Enumeration(enumeration) = variable.kind {
        meaning += "<ol>";
        for (item, text) in enumeration.items() {
            meaning += &format!("<li><code>{item}</code>: {}</li>", escape(*text));
        }
        meaning += "</ol>";
    }
    meaning
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jet() -> Aircraft {
        let text = include_str!("../../aircraft/generic-business-jet.toml");
        Aircraft::parse(text, "jet").unwrap()
    }

    fn page_of(aircraft: &Aircraft) -> String {
        let model = ReducedModel::new(aircraft, 4).unwrap();
        page(aircraft, &model, &Settings::of(&model))
    }

    #[test]
    fn the_page_says_how_the_aircraft_is_held() {
        let mut aircraft = jet();
        let free = page_of(&aircraft);
        aircraft.support = Support::Clamped;
        let clamped = page_of(&aircraft);
        assert!(free.contains("flies trimmed") && !free.contains("wind tunnel"));
        assert!(free.contains("a coordinated turn") && !clamped.contains("a coordinated turn"));
        assert!(clamped.contains("wind tunnel") && !clamped.contains("flies trimmed"));
        assert!(!free.contains("{{") && !clamped.contains("{{"));
    }

    #[test]
    fn the_page_says_what_gusts_actuators_sensors_and_loads_mean_and_how_far_they_go() {
        let mut aircraft = jet();
        let with_cuts = page_of(&aircraft);
        for said in [
            "<code>gust.shape = one_minus_cosine</code>",
            "<code>turbulence.seed</code>",
            "<code>actuator.*.frequency</code>",
            "<code>sensor.enabled</code>",
            "waves down to πc/2",
            "below waves of 8&nbsp;m",
            "not for a flap that several controls move",
            "<code>torsion</code> nose-up",
            "section loads jump",
        ] {
            assert!(with_cuts.contains(said), "{said}");
        }
        aircraft.cuts.clear();
        let without = page_of(&aircraft);
        assert!(!without.contains("<code>loads.*</code>") && !without.contains("section loads"));
    }

    #[test]
    fn the_page_says_what_positive_angles_of_the_aircrafts_own_controls_do() {
        let mut aircraft = jet();
        let expected = "<li>Positive <code>elevator</code>: nose-down. It acts alike on both sides; holds pitch in trim; has the usual \
                         limits of -30 to 30 deg, which change no flight.</li>";
        assert!(page_of(&aircraft).contains(expected));
        let canard = &mut aircraft.controls[0];
        (canard.name, canard.description) = ("canard".to_owned(), "Canard angle".to_owned());
        canard.positive = "up & away".to_owned();
        let page = page_of(&aircraft);
        assert!(
            page.contains("<li>Positive <code>canard</code>: up &amp; away. It ")
                && !page.contains("elevator")
        );
    }

    #[test]
    fn every_variable_stands_once_in_the_table_of_its_group() {
        let model = ReducedModel::new(&jet(), 4).unwrap();
        let table = VariableTable::new(&model);
        let groups = groups(&table);
        assert_eq!(groups.iter().map(|group| group.variables.len()).sum::<usize>(), table.iter().count());
        let names: Vec<&str> = groups.iter().map(|group| group.anchor).collect();
        assert_eq!(&names[..4], ["inputs", "parameters", "position", "attitude"]);
        // A group that this page does not know would have no title of its own.
        for name in &names[2..] {
            assert!(OUTPUT_GROUPS.iter().any(|(known, _)| known == name), "{name}");
        }
        let page = page(&jet(), &model, &Settings::of(&model));
        for name in names {
            assert_eq!(page.matches(&format!("id=\"{name}\"")).count(), 1, "{name}");
            assert_eq!(page.matches(&format!("href=\"#{name}\"")).count(), 1, "{name}");
        }
    }

    #[test]
    fn a_row_has_unit_start_limits_and_the_numbers_and_names_of_an_enumeration() {
        let page = page_of(&jet());
        let row = |name: &str| {
            let rows = page.lines().filter(|line| line.starts_with(&format!("<tr><td><code>{name}</code>")));
            rows.collect::<Vec<_>>().concat()
        };
        for cell in ["\"unit\">m<", "\"start\">7620<", "\"min\">-1000<", "\"max\">20000<"] {
            assert!(row("altitude").contains(cell), "{cell}: {}", row("altitude"));
        }
        assert!(row("model").contains("\"start\">1<"));
        // The list counts from 1, as the enumeration does.
        assert!(row("model").contains("<ol><li><code>exact</code>: "), "{}", row("model"));
        assert_eq!(row("model").matches("<li>").count(), 6);
        assert!(row("tolerance").contains("\"min\">1e-12<"));
        assert!(!row("attitude.pitch").contains("\"start\""), "outputs have no start");
    }

    #[test]
    fn the_page_fits_a_phone_and_needs_no_other_file() {
        let page = page_of(&jet());
        assert!(page.contains("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"));
        assert!(page.contains("@media (max-width:"));
        for external in ["src=", "url(http", "@import", "<link", "href=\"http"] {
            assert!(!page.contains(external), "{external}");
        }
    }
}

//! The documentation page of an FMU: a template filled with the aircraft's picture and its variables.

use std::fmt::Write;

use flexible_aircraft::aircraft::{Aircraft, Control, Support};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::fmi::Interface;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{ArchiveTable, Place, Slot, Type, Value, Variable};
use quick_xml::escape::escape;

use crate::{Reduction, plan_view};

mod exchange;
mod interface;
#[cfg(test)]
mod tests;

/// A variable as an importer knows it.
type Row = Variable<Place>;

const TEMPLATE: &str = include_str!("../../modelDescription/documentation.html");

/// Where its shapes are seen.
const SHAPES: &str = "<figure>\n<iframe src=\"scene.html\" title=\"The aircraft in its trim and its modes\" \
     style=\"width: 100%; height: 34em; border: 1px solid #d6dbe1\"></iframe>\n\
     <figcaption>As it stands in its trim, and how its modes move: choose under <i>Show</i>, drag to look around. \
     <a href=\"scene.html\">Alone on a page</a>.</figcaption>\n</figure>\n";

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
    variables: Vec<&'a Row>,
}

/// The file beside the page in which shapes are seen.
pub(crate) const SCENE: &str = "scene.html";

/// The page, which needs no other file but the scene where there is one.
pub(crate) fn page(
    interface: Interface,
    Reduction { aircraft, model }: &Reduction,
    starts: &Settings,
    has_scene: bool,
) -> String {
    let table = ArchiveTable::new(model, starts, interface.extent());
    let groups = groups(&table);
    TEMPLATE
        .replace("{{interface}}", &interface.to_string())
        .replace("{{fmi}}", interface.version.number())
        .replace("{{use}}", &interface::how_to_use(interface))
        .replace("{{states}}", &exchange::states(&table))
        .replace("{{when_set}}", interface::when_set(interface.kind))
        .replace("{{ending}}", interface::ending(interface.kind))
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{support}}", &support(aircraft))
        .replace("{{controls}}", &controls(aircraft))
        .replace("{{conditions}}", if aircraft.support == Support::Free { CONDITIONS } else { "" })
        .replace("{{loads}}", if model.cuts.is_empty() { "" } else { SIGNS_OF_LOADS })
        .replace("{{limits_of_loads}}", if model.cuts.is_empty() { "" } else { LIMITS_OF_LOADS })
        .replace("{{level}}", starts.plant.fidelity.name())
        .replace("{{facts}}", &facts(aircraft, model))
        .replace("{{plan_view}}", &plan_view::svg(aircraft))
        .replace("{{scene}}", if has_scene { SHAPES } else { "" })
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
                None => "<code>altitude</code> and <code>temperature_offset</code> choose its air".to_owned(),
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

/// Inputs, parameters, then outputs by the first part of their names, all in the order of the table. Time, states that are no
/// outputs, and rates are told of elsewhere.
fn groups(table: &ArchiveTable) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for (_, variable) in table.iter() {
        let anchor = match variable.slot {
            Place::Common(Slot::Input(_)) => "inputs",
            Place::Common(Slot::Parameter(_)) => "parameters",
            Place::Common(Slot::Output(_)) => variable.name.split('.').next().unwrap_or_default(),
            Place::State(_) | Place::Rate(_) | Place::Time => continue,
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
    let cells = |variable: &Row| {
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

fn start(variable: &Row) -> String {
    match variable.start {
        Some(Value::Integer(number)) => number.to_string(),
        Some(Value::Real(number)) => plain(number),
        Some(Value::Boolean(flag)) => flag.to_string(),
        None => String::new(),
    }
}

/// Of enumerations the list of items says it.
fn limit(variable: &Row, limit: Option<f64>) -> String {
    match variable.kind {
        Type::Enumeration(_) | Type::Boolean => String::new(),
        Type::Real | Type::Integer => limit.map(plain).unwrap_or_default(),
    }
}

/// As a reader would write it: 7620, 0.1, 1e-5.
fn plain(number: f64) -> String {
    if number != 0.0 && number.abs() < 1e-3 { format!("{number:e}") } else { number.to_string() }
}

fn meaning(variable: &Row) -> String {
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

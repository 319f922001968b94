//! An aircraft as a file: its tables in TOML with what is said of them.

use super::design::{Component, Control, Design, Engine, JoinedTail, Part, Place, Structure, Surface};
use super::interview::Choice;
use super::kind::Kind;
use super::quantity::STATIC_MARGIN;
use super::sizing::Sizing;
use crate::commented::{beside, comment};
use crate::numbers::{Plain, short};

/// What `flexair schema` is told to write beside the file.
pub const SCHEMA: &str = "aircraft.schema.json";

/// Where comments begin that stand behind a value.
const COLUMN: usize = 56;

/// All of it.
pub fn file(name: &str, sizing: &Sizing, design: &Design) -> String {
    let mut text = heading(sizing);
    text += &top(name, sizing);
    for control in &design.controls {
        text += &of_control(control);
    }
    for component in &design.components {
        text += &of_component(component);
    }
    if !design.engines.is_empty() {
        text += &part("engines");
        text += &design.engines.iter().map(of_engine).collect::<String>();
    }
    text += &part("what is watched");
    for component in &design.watched {
        text += &format!(
            "[[station]]\nname = \"{}\"\ncomponent = \"{component}\"\nat = 1\n\n",
            end(component, "tip")
        );
    }
    for component in &design.cut {
        text += &format!(
            "[[cut]]\nname = \"{}\"\ncomponent = \"{component}\"\nat = 0\n\n",
            end(component, "root")
        );
    }
    text += &design.joined_tail.as_ref().map_or(String::new(), of_joined_tail);
    text.trim_end().to_owned() + "\n"
}

/// What is told of a tail in halves, in the file and on the terminal.
pub const HALVES: &str = "The halves of the tail are not joined: its antisymmetric modes are softer than those of a tail in one piece.";

/// How to join the halves of a tail.
fn of_joined_tail(tail: &JoinedTail) -> String {
    let how = "For one piece take away the comment signs below, give htail_right the axis that stands there, write model = \"exact\" above, for the \
               geometrically exact level flies no loop, and take out the cuts at the roots of wing and booms, for loads within a loop are no outputs.";
    let block = [
        &format!("axis_m = [[0, 0, 0], {}]", vector(&tail.tip)),
        "",
        "[[joint]]",
        "component = \"htail_right\"",
        "at = 1",
        "joined_to = { component = \"htail_left\", at = 1 }",
        "rotations = \"fixed\"",
    ];
    let block = block.map(|line| format!("# {line}").trim_end().to_owned() + "\n");
    part("joint") + &comment(&format!("{HALVES} {how}")) + "#\n" + &block.concat()
}

/// What an end of a component is called: that of `wing_right` `wing_tip_right`.
fn end(component: &str, end: &str) -> String {
    match component.rsplit_once('_') {
        Some((surface, side @ ("right" | "left"))) => format!("{surface}_{end}_{side}"),
        _ => format!("{component}_{end}"),
    }
}

/// What was given and what was assumed, in columns.
pub fn choices(choices: &[Choice]) -> Vec<String> {
    let width = |of: fn(&Choice) -> usize| choices.iter().map(of).max().unwrap_or(0);
    let widths = [width(|choice| choice.label.len()), width(|choice| choice.value.len())];
    let line = |choice: &Choice| {
        let source = choice.assumed.as_ref().map_or("given".to_owned(), |rule| format!("assumed: {rule}"));
        format!("{:<3$}  {:<4$}  {}", choice.label, choice.value, source, widths[0], widths[1])
    };
    choices.iter().map(line).collect()
}

/// Editors read from its first line where the schema lies, and from the rest of it people what was given.
fn heading(sizing: &Sizing) -> String {
    let mut lines =
        vec!["Written by `flexair new`. What was given, and what was assumed:".to_owned(), String::new()];
    lines.extend(choices(&sizing.choices).into_iter().map(|line| format!("  {line}")));
    lines.push(String::new());
    let mut text = format!("#:schema ./{SCHEMA}\n");
    text.extend(lines.iter().map(|line| format!("# {line}").trim_end().to_owned() + "\n"));
    let stiffness = "EI of the wing for its frequency";
    let margin = format!("the place of the payload for a static margin of {STATIC_MARGIN} of the mean chord");
    let found = match sizing.kind {
        Kind::WingOnWall => format!("One number was found with the library: {stiffness}."),
        Kind::FlyingWing => format!(
            "Three numbers were found with the library: {stiffness}, {margin}, and the wing's zero-lift moment for an elevator at \
             0 in the trim."
        ),
        _ => format!(
            "Four numbers were found with the library: {stiffness}, {margin}, and the incidences of wing and tail for a level \
             body and an elevator at 0 in the trim."
        ),
    };
    let rules = "The rest follows from rules of conceptual design, as said beside the numbers.";
    text += &comment(&format!("{rules} {found}"));
    text += "#\n";
    text += &comment(
        "SI units, as the ends of field names say. Body axes: x forward, y right, z down; O at the root of the wing, on its \
         elastic axis. Every field is described in aircraft/README.md of flexible-aircraft.",
    );
    text + "\n"
}

fn top(name: &str, sizing: &Sizing) -> String {
    let is_clamped = sizing.kind == Kind::WingOnWall;
    let mut text = String::from("format = 1\n");
    // As TOML quotes it, whatever it is.
    text += &format!("name = {}\n", toml::Value::String(name.to_owned()));
    text += &format!("support = \"{}\"\n", if is_clamped { "clamped" } else { "free" });
    if is_clamped {
        text += &line("mount_attitude_deg = [0, 3, 0]", "3 deg of incidence against the flow");
    }
    text += "mode_basis = \"bending_torsion\"\n";
    text += &line("model = \"geometrically_exact\"", "right however far wings bend");
    text += &format!("airspeed_m_s = {}\naltitude_m = {}\n", short(sizing.airspeed), short(sizing.altitude));
    if !is_clamped {
        text += "symmetric = true\n";
    }
    if sizing.engines > 0 {
        let weight = sizing.mass * flexible_aircraft::air::STANDARD_GRAVITY;
        let thrust = 0.3 * weight / sizing.engines as f64;
        let thrust = line(
            &format!("maximum_thrust_N = {}", digits(thrust)),
            "0.3 of the weight by the engines: our own, of jets and of propellers at low speed",
        );
        text += &format!("\n[limits]\n{thrust}");
    }
    text + "\n" + &part("controls")
}

fn of_control(control: &Control) -> String {
    let Control { name, description, positive, mirror, trim, limit } = control;
    let trim = trim.map_or(String::new(), |role| format!("trim = \"{role}\"\n"));
    format!(
        "[[control]]\nname = \"{name}\"\ndescription = \"{description}\"\npositive = \"{positive}\"\nmirror = \"{mirror}\"\n\
         {trim}minimum_deg = -{limit}\nmaximum_deg = {limit}\n\n"
    )
}

fn of_component(component: &Component) -> String {
    let mut text = part(component.name.trim_end_matches("_right"));
    text += &comment(&component.comment);
    text += &format!("[[component]]\nname = \"{}\"\n", component.name);
    if let Some(mirror) = &component.mirror {
        text += &format!("mirror = \"{mirror}\"\n");
    }
    text += &match &component.parent {
        None => "attached_to = \"origin\"\n".to_owned(),
        Some((parent, at)) => format!("attached_to = {{ component = \"{parent}\", at = {} }}\n", Plain(*at)),
    };
    text += &format!("axis_m = [[0, 0, 0], {}]\n", vector(&component.tip));
    text += &format!("elements = {}\ny_axis = {:?}\n", component.elements, component.y_axis);
    if let Some([root, tip]) = component.chords {
        text += &if root == tip {
            format!("chord_m = {}\n", digits(root))
        } else {
            format!("chord_m = {{ at = [0, 1], values = [{}, {}] }}\n", digits(root), digits(tip))
        };
    }
    text += &stiffnesses(component);
    text += &of_structure(&component.structure);
    for lump in &component.lumps {
        text += "\n";
        text += &line("[[component.point_masses]]", &lump.comment);
        text += &format!("{}mass_kg = {}\n", place(lump.at), digits(lump.mass));
        if lump.offset.iter().any(|along| *along != 0.0) {
            text += &format!("offset_m = {}\n", vector(&lump.offset));
        }
        text += &format!("gyration_m = {}\n", vector(&lump.gyration));
    }
    if let Some(surface) = &component.surface {
        text += &of_surface(surface);
    }
    text + "\n"
}

fn stiffnesses(component: &Component) -> String {
    let beam = &component.beam;
    let law = |root: f64, less: f64| match beam.chord_power {
        Some(power) => format!("{{ root = {}, chord_power = {} }}", digits(root), power - less),
        None => digits(root),
    };
    let multiple = |factor: f64| format!("{{ multiple_of = \"EI_y_N_m2\", factor = {factor} }}");
    let mut text = comment(&beam.comment);
    text += &line(&format!("EA_N = {}", law(beam.axial, 2.0)), "without effect at this level");
    text += &format!("GJ_N_m2 = {}\n", multiple(beam.torsion));
    text += &format!("EI_y_N_m2 = {}\n", law(beam.bending, 0.0));
    text + &format!("EI_z_N_m2 = {}\n", multiple(beam.in_surface))
}

fn of_structure(structure: &Structure) -> String {
    let mut text = String::from("\n[[component.distributed_mass]]\n");
    let parts: Vec<(String, &str)> =
        structure.parts.iter().map(|part| (of_part(part), part.comment)).collect();
    text += &match parts.as_slice() {
        [(part, comment)] => line(&format!("parts = [{part}]"), comment),
        several => {
            let lines = several.iter().map(|(part, comment)| line(&format!("    {part},"), comment));
            format!("parts = [\n{}]\n", lines.collect::<String>())
        }
    };
    if let Some(aft) = structure.aft {
        text += &format!("offset_chords = [{}, 0, 0]\n", Plain(-aft));
    }
    if let Some(chords) = structure.gyration_chords {
        text += &format!("gyration_chords = {}\n", vector(&chords));
    }
    text += &format!("gyration_lengths = {}\n", vector(&structure.gyration_lengths));
    if let Some(inertia) = structure.added_inertia {
        text += &format!("added_inertia_kg_m2 = {}\n", vector(&[inertia, 0.5 * inertia, 0.5 * inertia]));
    }
    text
}

fn of_part(part: &Part) -> String {
    let power = part.chord_power.map_or(String::new(), |power| format!(", chord_power = {power}"));
    let to = part.to.map_or(String::new(), |to| format!(", to = {to}"));
    format!("{{ total_kg = {}{power}{to} }}", digits(part.mass))
}

fn of_surface(surface: &Surface) -> String {
    let mut text = format!("\n[[component.surface]]\nelastic_axis = {}\n", surface.elastic_axis);
    let [root, tip] = surface.incidence;
    if root != tip {
        let law = format!("incidence_deg = {{ at = [0, 1], values = [{}, {}] }}", digits(root), digits(tip));
        text += &line(&law, "washout");
    } else if root != 0.0 {
        text += &format!("incidence_deg = {}\n", digits(root));
    }
    text += &line(&format!("lift_slope_per_rad = {}", digits(surface.lift_slope)), &surface.lift_comment);
    text += &line(&format!("profile_drag = {}", digits(surface.profile_drag)), &surface.drag_comment);
    text += &line(
        &format!("leading_edge_suction = {}", digits(surface.suction)),
        "leaves the induced drag CL^2/(pi A e), e = 0.85",
    );
    if surface.zero_lift_offset != 0.0 {
        text += &line(&format!("zero_lift_offset_deg = {}", digits(surface.zero_lift_offset)), "NACA 2412");
    }
    if surface.zero_lift_moment != 0.0 {
        text += &format!("zero_lift_moment = {}\n", digits(surface.zero_lift_moment));
    }
    if let Some([slope, hinge]) = surface.flap {
        text += &line(
            &format!("flap = {{ lift_slope_per_rad = {}, hinge = {hinge} }}", digits(slope)),
            "0.8 of thin-aerofoil theory",
        );
    }
    for control in &surface.moves {
        text += &format!(
            "\n[[component.surface.control]]\ninput = \"{}\"\ngain = {}\n",
            control.input, control.gain
        );
        if let Some([from, to]) = control.stretch {
            text += &format!("from = {from}\nto = {to}\n");
        }
    }
    text
}

fn of_engine(engine: &Engine) -> String {
    let offset = engine.offset.iter().any(|along| *along != 0.0);
    let offset = if offset { format!("offset_m = {}\n", vector(&engine.offset)) } else { String::new() };
    format!(
        "[[engine]]\nname = \"{}\"\ncomponent = \"{}\"\n{}{offset}direction = [1, 0, 0]\n\n",
        engine.name,
        engine.component,
        place(engine.at)
    )
}

fn place(place: Place) -> String {
    match place {
        Place::Metres(metres) => format!("at_m = {}\n", digits(metres)),
        Place::Fraction(fraction) => format!("at = {}\n", Plain(fraction)),
    }
}

/// A heading.
fn part(name: &str) -> String {
    format!("# {} {name}\n\n", "-".repeat(64))
}

/// A line with a comment behind it.
fn line(text: &str, comment: &str) -> String {
    beside(text, comment, COLUMN)
}

fn vector(numbers: &[f64; 3]) -> String {
    format!("[{}, {}, {}]", digits(numbers[0]), digits(numbers[1]), digits(numbers[2]))
}

/// With four digits: more would say what rules do not know. What is left of rounding is 0.
fn digits(number: f64) -> String {
    if number.abs() < 1e-12 {
        return "0".to_owned();
    }
    // PROOF: what is written as a number is read as one; the number itself stands in for any doubt.
    Plain(format!("{number:.3e}").parse().unwrap_or(number)).to_string()
}

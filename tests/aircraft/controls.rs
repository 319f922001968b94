//! Controls as the file names them: how gains pass to mirror images, and what is refused.

use flexible_aircraft::aircraft::{Aircraft, Bound, Bounds, Strip, TrimRole};

use super::{AILERON, GOOD, assert_messages, edited};

/// The gain of each control on the outermost flap of a wing.
fn gains(aircraft: &Aircraft, component: &str) -> Vec<f64> {
    let on_it = |strip: &&Strip| aircraft.beams[strip.attachment.beam].component == component;
    aircraft.strips.iter().rfind(on_it).unwrap().flap.as_ref().unwrap().gains.clone()
}

/// The good file without its controls and what they move.
fn without_controls() -> String {
    let start = GOOD.find("\n[[control]]").unwrap();
    GOOD[..start].replace("[[component.surface.control]]\ninput = \"aileron\"\ngain = -1\nfrom = 0.5\n", "")
}

#[test]
fn a_control_is_what_its_table_says() {
    let aircraft = edited(&[]).unwrap();
    let control = &aircraft.controls[AILERON];
    assert_eq!((control.name.as_str(), control.role), ("aileron", Some(TrimRole::Roll)));
    assert_eq!(
        (control.description.as_str(), control.positive.as_str()),
        ("Aileron deflection", "rolls right")
    );
    let twenty = 20_f64.to_radians();
    assert_eq!(control.limits, Bounds { minimum: Bound::Given(-twenty), maximum: Bound::Given(twenty) });
    assert_eq!(aircraft.controls[0].description, "Angle of elevator");
}

#[test]
fn gains_pass_to_mirror_images_as_the_control_says() {
    for (mirror, sign) in [("same", 1.0), ("opposite", -1.0)] {
        let edit =
            ("mirror = \"opposite\"\ntrim = \"roll\"", format!("mirror = \"{mirror}\"\ntrim = \"roll\""));
        let aircraft = edited(&[(edit.0, &edit.1)]).unwrap();
        assert_eq!(gains(&aircraft, "wing_right"), [0.0, -1.0, 0.0], "{mirror}");
        assert_eq!(gains(&aircraft, "wing_left")[AILERON], -sign, "{mirror}");
    }
}

/// The right side is that of y > 0, whichever was written.
#[test]
fn a_control_without_mirror_moves_the_side_that_the_file_names() {
    let none = ("mirror = \"opposite\"\ntrim = \"roll\"", "mirror = \"none\"\ntrim = \"roll\"");
    for (side, [right, left]) in [("right", [-1.0, 0.0]), ("left", [0.0, -1.0])] {
        let on_a_side = ("gain = -1", format!("gain = -1\nside = \"{side}\""));
        let aircraft = edited(&[none, (on_a_side.0, &on_a_side.1)]).unwrap();
        assert_eq!(
            [gains(&aircraft, "wing_right"), gains(&aircraft, "wing_left")].map(|g| g[AILERON]),
            [right, left]
        );
        let written_left = [
            none,
            (on_a_side.0, &on_a_side.1),
            ("[0, 5, 0]", "[0, -5, 0]"),
            ("\"wing_right\"\nmirror = \"wing_left\"", "\"wing_left\"\nmirror = \"wing_right\""),
        ];
        let aircraft = edited(&written_left).unwrap();
        assert_eq!(
            [gains(&aircraft, "wing_right"), gains(&aircraft, "wing_left")].map(|g| g[AILERON]),
            [right, left]
        );
    }
}

#[test]
fn a_component_without_mirror_image_has_all_controls_without_a_side() {
    let edits = [
        ("mirror = \"opposite\"\ntrim = \"roll\"", "mirror = \"none\"\ntrim = \"roll\""),
        ("mirror = \"wing_left\"\n", ""),
        ("symmetric = true", "symmetric = false"),
        ("component = \"wing_left\"", "component = \"wing_right\""),
    ];
    assert_eq!(gains(&edited(&edits).unwrap(), "wing_right"), [0.0, -1.0, 0.0]);
}

#[test]
fn an_aircraft_may_have_no_control_or_many() {
    let none = Aircraft::parse(&without_controls(), "none.toml").unwrap_or_else(|error| panic!("{error}"));
    assert!(none.controls.is_empty());
    let more = |number: usize| {
        format!("\n[[control]]\nname = \"tab_{number}\"\npositive = \"down\"\nmirror = \"same\"\n")
    };
    let many: String = (0..50).map(more).collect();
    assert_eq!(Aircraft::parse(&format!("{GOOD}{many}"), "many.toml").unwrap().controls.len(), 53);
}

#[test]
fn sides_where_they_make_no_sense_are_refused() {
    let none = ("mirror = \"opposite\"\ntrim = \"roll\"", "mirror = \"none\"\ntrim = \"roll\"");
    assert_messages(
        &[none],
        &[
            "small.toml:31:1: component.wing_right.surface[1].control[1].side: found no side for \"aileron\", which has \
           mirror = \"none\"; \"right\" or \"left\" is needed: of the component and its mirror image the one that it moves",
        ],
    );
    assert_messages(
        &[("gain = -1", "gain = -1\nside = \"left\"")],
        &[
            "small.toml:34:8: component.wing_right.surface[1].control[1].side: found a side for \"aileron\", whose gains \
           pass to mirror images; a side is allowed for controls with mirror = \"none\"",
        ],
    );
    assert_messages(
        &[
            none,
            ("gain = -1", "gain = -1\nside = \"left\""),
            ("mirror = \"wing_left\"\n", ""),
            ("symmetric = true", "symmetric = false"),
            ("component = \"wing_left\"", "component = \"wing_right\""),
        ],
        &[
            "small.toml:33:8: component.wing_right.surface[1].control[1].side: found a side on a component without mirror \
           image; no side is allowed here",
        ],
    );
}

#[test]
fn names_that_other_variables_have_are_refused_with_their_line() {
    for (name, variable) in [("model", "model"), ("wind_north", "wind_north"), ("thrust_only", "thrust_only")]
    {
        assert_messages(
            &[("name = \"elevator\"", &format!("name = \"{name}\""))],
            &[&format!(
                "small.toml:75:8: control.{name}.name: found the name \"{name}\", and `{variable}` is another variable; \
                 a name that no variable has is allowed"
            )],
        );
    }
    // An output of a control with a role stands beside what else a trim is.
    let error = edited(&[("name = \"elevator\"", "name = \"pitch\"")]).unwrap_err().to_string();
    assert!(error.contains("found the name \"pitch\", and `trim.pitch` is another variable"), "{error}");
    let roleless = [
        ("name = \"elevator\"", "name = \"pitch\""),
        ("mirror = \"same\"\ntrim = \"pitch\"", "mirror = \"same\""),
    ];
    assert!(edited(&roleless).is_ok());
    // Another aircraft's engine.
    assert!(edited(&[("name = \"elevator\"", "name = \"thrust_left\"")]).is_ok());
}

#[test]
fn names_and_roles_are_given_once() {
    assert_messages(
        &[("name = \"rudder\"", "name = \"elevator\"")],
        &[
            "small.toml:90:8: control.elevator.name: found the name \"elevator\" a second time; a name that no other control \
           has is allowed",
        ],
    );
    assert_messages(
        &[("trim = \"yaw\"", "trim = \"roll\"")],
        &[
            "small.toml:93:8: control.rudder.trim: found a role that \"aileron\" has already; one control for each role is \
           allowed",
        ],
    );
}

#[test]
fn a_table_lacks_nothing_and_says_nothing_unknown() {
    for (from, to, message) in [
        ("positive = \"nose-down\"\n", "", "control.elevator.positive: the field \"positive\" is missing"),
        ("mirror = \"same\"\n", "", "control.elevator.mirror: the field \"mirror\" is missing"),
        ("mirror = \"same\"", "mirror = \"both\"", "\"same\" or \"opposite\" or \"none\" is allowed"),
        ("trim = \"pitch\"", "trim = \"lift\"", "\"pitch\" or \"roll\" or \"yaw\" is allowed"),
        ("name = \"elevator\"", "name = \"ele vator\"", "a name of letters, digits and underscores"),
        ("trim = \"pitch\"", "role = \"pitch\"", "found the unknown field \"role\""),
        (
            "input = \"aileron\"",
            "input = \"flap\"",
            "found \"flap\", which is no [[control]]; allowed: elevator, aileron, rudder",
        ),
    ] {
        let error = edited(&[(from, to)]).expect_err(from).to_string();
        assert!(error.contains(message), "{message}\n{error}");
    }
}

/// Before controls had tables, four inputs stood for themselves.
#[test]
fn old_files_are_told_what_to_write() {
    let start = GOOD.find("\n[[control]]").unwrap();
    let old = GOOD[..start].replace(
        "inflow_states = 5\n",
        "inflow_states = 5\nlimits = { surface = { elevator = { minimum_deg = -25 } } }\n",
    );
    let error = Aircraft::parse(&old, "old.toml").unwrap_err().to_string();
    let expected = [
        "old.toml:7:22: limits.surface: found limits of surfaces; each control has its own: minimum_deg and maximum_deg are \
         allowed in its [[control]]",
        "old.toml:33:9: component.wing_right.surface[1].control[1].input: found \"aileron\", which is no [[control]]; controls \
         have tables of their own now: [[control]] with name = \"aileron\", positive = \"rolls right\", mirror = \"opposite\", \
         trim = \"roll\" is needed",
    ];
    assert_eq!(error, expected.join("\n"));
    for input in ["elevator", "aileron_symmetric", "rudder"] {
        let old = old.replace("\"aileron\"", &format!("\"{input}\""));
        let error = Aircraft::parse(&old, "old.toml").unwrap_err().to_string();
        // What the message says makes the file a good one.
        let fields =
            error.split("[[control]] with ").nth(1).unwrap().replace(" is needed", "").replace(", ", "\n");
        let limits = "limits = { surface = { elevator = { minimum_deg = -25 } } }\n";
        let new = format!("{}\n[[control]]\n{fields}\n", old.replace(limits, ""));
        assert_eq!(Aircraft::parse(&new, "new.toml").unwrap().controls[0].name, input);
    }
}

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
        let edit = ("mirror = \"opposite\"\ntrim = \"roll\"", format!("mirror = \"{mirror}\""));
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
    let used = "\n[[component.surface.control]]\ninput = \"tab\"\ngain = 0.1\n";
    let more = |number: usize| {
        let control = "\n[[control]]\nname = \"tab\"\npositive = \"down\"\nmirror = \"same\"\n";
        [used, control].map(|text| text.replace("tab", &format!("tab_{number}")))
    };
    let (uses, controls): (Vec<_>, Vec<_>) = (0..50).map(more).map(|[used, control]| (used, control)).unzip();
    let good = GOOD.replacen(
        "\n[[component]]\nname = \"fuselage\"",
        &(uses.concat() + "\n[[component]]\nname = \"fuselage\""),
        1,
    );
    assert_eq!(Aircraft::parse(&(good + &controls.concat()), "many.toml").unwrap().controls.len(), 53);
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

/// The elevator by another name.
fn named(name: &str) -> [(&'static str, &'static str); 2] {
    let edited = |text: &'static str| (text, &*text.replace("elevator", name).leak());
    ["name = \"elevator\"", "input = \"elevator\""].map(edited)
}

#[test]
fn names_that_other_variables_have_are_refused_with_their_line() {
    for (name, what) in [
        ("model", "a variable of every aircraft"),
        ("wind_north", "a variable of every aircraft"),
        ("thrust_only", "the thrust of an engine of this aircraft"),
        ("time", "what every table of a flight begins with"),
    ] {
        let error = edited(&named(name)).unwrap_err().to_string();
        let expected = format!(
            "small.toml:75:8: control.{name}.name: found the name \"{name}\", and `{name}` is {what}; another name is allowed"
        );
        assert_eq!(error, expected);
    }
    // An output of a control with a role stands beside what else a trim is.
    let error = edited(&named("pitch")).unwrap_err().to_string();
    assert!(
        error.contains("found the name \"pitch\", and `trim.pitch` is a variable of every trim"),
        "{error}"
    );
    let [control, used] = named("pitch");
    assert!(edited(&[control, used, ("mirror = \"same\"\ntrim = \"pitch\"", "mirror = \"same\"")]).is_ok());
    // Another aircraft's engine.
    assert!(edited(&named("thrust_left")).is_ok());
}

#[test]
fn names_and_roles_are_given_once() {
    assert_messages(
        &[("name = \"rudder\"", "name = \"elevator\""), (", { input = \"rudder\", gain = 1 }", "")],
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
        (
            "name = \"elevator\"",
            "name = \"ele vator\"",
            "control[1].name: found the text \"ele vator\"; a name of letters",
        ),
        ("name = \"elevator\"", "name = \"\"", "control[1].name: found the text \"\"; a name of letters"),
        ("positive = \"nose-down\"", "positive = \" . \"", "a text that is not empty is allowed"),
        (
            "\"Aileron deflection\"",
            "\"\"",
            "control.aileron.description: found the text \"\"; a text that is not empty",
        ),
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

#[test]
fn a_full_stop_at_the_end_of_a_text_is_left_out() {
    let edits = [("\"nose-down\"", "\"nose-down. \""), ("\"Aileron deflection\"", "\"Aileron deflection.\"")];
    let controls = edited(&edits).unwrap().controls;
    assert_eq!([&controls[0].positive, &controls[AILERON].description], ["nose-down", "Aileron deflection"]);
}

#[test]
fn a_control_that_no_surface_names_is_refused_and_one_with_gain_0_is_not() {
    assert_messages(
        &[("{ input = \"elevator\", gain = 1 }, ", "")],
        &[
            "small.toml:75:8: control.elevator.name: found \"elevator\", which moves no flap: no surface names it; a control is \
             allowed that a surface has as input, or no [[control]] of this name",
        ],
    );
    assert!(edited(&[("{ input = \"elevator\", gain = 1 }", "{ input = \"elevator\", gain = 0 }")]).is_ok());
}

#[test]
fn a_role_is_refused_that_the_flaps_cannot_play() {
    let opposite = ("mirror = \"same\"\ntrim = \"pitch\"", "mirror = \"opposite\"\ntrim = \"pitch\"");
    let error = edited(&[opposite]).unwrap_err().to_string();
    assert!(
        error.starts_with(
            "small.toml:78:8: control.elevator.trim: found the role of pitch for \"elevator\", whose flaps on both sides act \
             against each other: it cannot pitch; "
        ),
        "{error}"
    );
    for (role, name) in [("roll", "aileron"), ("yaw", "rudder")] {
        let edit = |mirror: &str| format!("mirror = \"{mirror}\"\ntrim = \"{role}\"");
        let (from, to) = (edit("opposite"), edit("same"));
        let error = edited(&[(&from, &to)]).unwrap_err().to_string();
        let expected = format!(
            "control.{name}.trim: found the role of {role} for \"{name}\", whose flaps act alike on both sides: it can neither \
             roll nor yaw"
        );
        assert!(error.contains(&expected), "{error}");
    }
}

/// A trim with it goes aside, which is worth a warning; an aircraft that is lopsided by itself is trimmed so in any case.
#[test]
fn a_pitch_control_on_one_side_of_a_symmetric_aircraft_is_noticed() {
    let one_side = [
        ("mirror = \"same\"\ntrim = \"pitch\"", "mirror = \"none\"\ntrim = \"pitch\""),
        ("{ input = \"elevator\", gain = 1 }", "{ input = \"elevator\", gain = 1, side = \"right\" }"),
    ];
    let noticed = |aircraft: &Aircraft| aircraft.lopsided_pitch_control().map(|control| control.name.clone());
    assert_eq!(noticed(&edited(&one_side).unwrap()).as_deref(), Some("elevator"));
    let both_sides = [
        one_side[0],
        (
            one_side[1].0,
            "{ input = \"elevator\", gain = 1, side = \"right\" }, { input = \"elevator\", gain = 1, side = \"left\" }",
        ),
    ];
    assert_eq!(noticed(&edited(&both_sides).unwrap()), None);
    let lopsided = [
        one_side[0],
        one_side[1],
        ("symmetric = true", "symmetric = false"),
        ("mirror = \"wing_left\"\n", ""),
        ("component = \"wing_left\"", "component = \"wing_right\""),
    ];
    assert_eq!(noticed(&edited(&lopsided).unwrap()), None);
}

#[test]
fn a_control_moves_a_stretch_once() {
    for again in ["input = \"aileron\"\ngain = 1", "input = \"aileron\"\ngain = 1\nfrom = 0.9"] {
        let twice = format!("gain = -1\nfrom = 0.5\n\n[[component.surface.control]]\n{again}\n");
        let error = edited(&[("gain = -1\nfrom = 0.5\n", &twice)]).unwrap_err().to_string();
        let expected = "surface[1].control[2].input: found \"aileron\" a second time on a stretch that it moves from 0.5 to 1; a \
                        control is allowed once on each stretch: the sum of the gains";
        assert!(error.contains(expected), "{error}");
    }
    let beside = "gain = -1\nfrom = 0.5\n\n[[component.surface.control]]\ninput = \"aileron\"\ngain = -0.5\nto = 0.5\n";
    assert!(edited(&[("gain = -1\nfrom = 0.5\n", beside)]).is_ok());
}

#[test]
fn a_control_without_role_is_neutral_within_its_limits() {
    let limits = ("minimum_deg = -20\nmaximum_deg = 20", "minimum_deg = 5\nmaximum_deg = 20");
    assert!(edited(&[limits]).is_ok(), "with a role a trim may stand there");
    let error = edited(&[limits, ("trim = \"roll\"\n", "")]).unwrap_err().to_string();
    assert!(
        error.starts_with("small.toml:85:15: control.aileron.minimum_deg: found a limit that excludes 0"),
        "{error}"
    );
}

#[test]
fn a_mistake_in_a_control_hides_no_other() {
    let edits = [
        ("mirror = \"same\"\ntrim = \"pitch\"", "mirror = \"sam\"\ntrim = \"pitch\""),
        ("input = \"aileron\"", "input = \"ailerons\""),
    ];
    let error = edited(&edits).unwrap_err();
    let fields: Vec<&str> = error.diagnostics().iter().map(|d| d.field.as_str()).collect();
    assert_eq!(fields, ["component.wing_right.surface[1].control[1].input", "control.elevator.mirror"]);
    // Where names are unknown, none is called wrong.
    for (from, to) in [("name = \"elevator\"", "name = \"\""), ("gain = -1", "gain = -1\nside = \"top\"")] {
        assert_eq!(edited(&[(from, to)]).unwrap_err().diagnostics().len(), 1, "{to}");
    }
    let single = without_controls()
        + "\n[control]\nname = \"elevator\"\npositive = \"nose-down\"\nmirror = \"same\"\n";
    let single = single
        .replace("hinge = 0.75 }\n", "hinge = 0.75 }\ncontrol = [{ input = \"elevator\", gain = 1 }]\n");
    let error = Aircraft::parse(&single, "single.toml").unwrap_err().to_string();
    assert!(error.ends_with("control: found a table; a list of tables ([[control]]) is allowed"), "{error}");
    assert_eq!(error.lines().count(), 1);
}

/// Before controls had tables, four inputs stood for themselves.
#[test]
fn old_files_are_told_what_to_write() {
    let start = GOOD.find("\n[[control]]").unwrap();
    let limits =
        "limits = { surface = { aileron = { minimum_deg = -25, maximum_deg = 15 }, rudder = {} } }\n";
    let old = GOOD[..start].replace("inflow_states = 5\n", &format!("inflow_states = 5\n{limits}"));
    let error = Aircraft::parse(&old, "old.toml").unwrap_err().to_string();
    let expected = [
        "old.toml:7:24: limits.surface.aileron: found limits of \"aileron\" outside its [[control]]; move minimum_deg = -25, \
         maximum_deg = 15 of aileron into its [[control]]",
        "old.toml:7:75: limits.surface.rudder: found limits of \"rudder\" outside its [[control]]; minimum_deg and maximum_deg \
         are allowed in the [[control]] of rudder",
        "old.toml:33:9: component.wing_right.surface[1].control[1].input: found \"aileron\", which is no [[control]]; controls \
         have tables of their own now: add these lines at the end of the file, or anywhere at its top level before another \
         table in double brackets",
        "",
        "[[control]]",
        "name = \"aileron\"",
        "positive = \"rolls right\"",
        "mirror = \"opposite\"",
        "trim = \"roll\"",
        "minimum_deg = -25",
        "maximum_deg = 15",
        "",
    ];
    assert_eq!(error, expected.join("\n"));
    for inputs in ["elevator", "aileron_symmetric", "rudder", "elevator rudder"] {
        let inputs: Vec<&str> = inputs.split(' ').collect();
        let flap = "\n[[component.surface.control]]\ninput = \"X\"\ngain = -1\nfrom = 0.5\n";
        let flaps: String = inputs.iter().map(|input| flap.replace('X', input)).collect();
        let old = old.replace(limits, "").replace(&flap[1..].replace('X', "aileron"), &flaps);
        let error = Aircraft::parse(&old, "old.toml").unwrap_err();
        let [diagnostic] = error.diagnostics() else { panic!("{error}") };
        // What the message says makes the file a good one.
        let new = format!("{old}\n{}", diagnostic.allowed.split_once('\n').unwrap().1);
        let names = match Aircraft::parse(&new, "new.toml") {
            Ok(aircraft) => aircraft.controls.iter().map(|control| control.name.clone()).collect::<Vec<_>>(),
            Err(error) => panic!("{error}"),
        };
        assert_eq!(names, inputs);
    }
}

#[test]
fn a_former_name_in_a_file_with_controls_is_like_any_other() {
    let error = edited(&[("name = \"elevator\"", "name = \"tailplane\"")]).unwrap_err().to_string();
    assert!(
        error.ends_with("found \"elevator\", which is no [[control]]; allowed: tailplane, aileron, rudder"),
        "{error}"
    );
    let limits = (
        "inflow_states = 5\n",
        "inflow_states = 5\nlimits = { surface = { aileron = { minimum_deg = -25 } } }\n",
    );
    let error = edited(&[limits]).unwrap_err().to_string();
    assert!(error.ends_with("move minimum_deg = -25 of aileron into its [[control]]"), "{error}");
}

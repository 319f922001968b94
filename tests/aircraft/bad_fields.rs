//! Files whose fields are wrong each by itself.

use flexible_aircraft::aircraft::Aircraft;

use super::{GOOD, assert_messages};

#[test]
fn negative_stiffness() {
    assert_messages(
        &[("EA_N = 1e7", "EA_N = -1e7")],
        &[
            "small.toml:17:8: component.wing_right.EA_N: found -10000000; a stiffness in N or N m² from 1e-6 to 1e15 is allowed",
        ],
    );
}

#[test]
fn stiffness_zero() {
    assert_messages(
        &[("EA_N = 1e7", "EA_N = 0")],
        &[
            "small.toml:17:8: component.wing_right.EA_N: found 0; a stiffness in N or N m² from 1e-6 to 1e15 is allowed",
        ],
    );
}

/// Each would overflow or fail much later, far from the file.
#[test]
fn numbers_that_no_aircraft_has() {
    for (field, value, message) in [
        ("EA_N = 1e7", "1e-300", "a stiffness in N or N m² from 1e-6 to 1e15 is allowed"),
        ("EI_z_N_m2 = { polynomial = [3e6, -2e6] }", "1e300", "a stiffness in N or N m² from 1e-6 to 1e15"),
        ("mass_kg = [300, 80]", "1e10", "a mass in kg from 1e-9 to 1e9 is allowed"),
        ("inertia_kg_m2 = [40, 50, 60]", "[1e13, 1e13, 1e13]", "a moment of inertia in kg m² from 0 to 1e12"),
        ("lift_slope_per_rad = 5.5", "1e3", "a lift slope per radian from 0 to 100 is allowed"),
        ("profile_drag = 0.01", "1e300", "a drag coefficient from 0 to 10 is allowed"),
        ("gain = -1", "1e9", "a gain from -100 to 100 is allowed"),
        ("chord_m = 1.5", "1e-300", "a length in metres from 1e-6 to 1000 is allowed"),
        ("gravity_m_s2 = 9.806", "1e4", "an acceleration in m/s² from 0 to 1000 is allowed"),
        (
            "gyration_chords = [0, 0.25, 0.25]",
            "[0, 1e9, 1e9]",
            "a radius of gyration from 0 to 1000 is allowed",
        ),
    ] {
        let (name, _) = field.split_once(" = ").unwrap();
        let error = super::edited(&[(field, &format!("{name} = {value}"))]).expect_err(field).to_string();
        assert!(error.contains(name) && error.contains(message), "{error}");
    }
}

#[test]
fn control_characters_in_a_name() {
    assert_messages(
        &[("name = \"Small aircraft\"", "name = \"a\\u0001b\"")],
        &["small.toml:2:8: name: found the text \"a\\u{1}b\"; a text without control characters is allowed"],
    );
}

#[test]
fn negative_mass() {
    assert_messages(
        &[("mass_kg = [300, 80]", "mass_kg = [300, -80]")],
        &[
            "small.toml:49:17: component.fuselage.point_masses[1].mass_kg[2]: found -80; a mass in kg from 1e-9 to 1e9 is allowed",
        ],
    );
}

#[test]
fn mass_zero() {
    assert_messages(
        &[("total_kg = 100", "total_kg = 0.0")],
        &[
            "small.toml:23:23: component.wing_right.distributed_mass[1].parts[1].total_kg: found 0; a mass in kg from 1e-9 to 1e9 is allowed",
        ],
    );
}

#[test]
fn negative_chord() {
    assert_messages(
        &[("chord_m = 1.5", "chord_m = -1.5")],
        &[
            "small.toml:16:11: component.wing_right.chord_m: found -1.5; a length in metres from 1e-6 to 1000 is allowed",
        ],
    );
}

#[test]
fn chord_zero() {
    assert_messages(
        &[("chord_m = 1.5", "chord_m = 0")],
        &[
            "small.toml:16:11: component.wing_right.chord_m: found 0; a length in metres from 1e-6 to 1000 is allowed",
        ],
    );
}

#[test]
fn unknown_field() {
    assert_messages(
        &[("chord_m = 1.5", "chord_m = 1.5\nsweep_deg = 3")],
        &[
            "small.toml:17:1: component.wing_right.sweep_deg: found the unknown field \"sweep_deg\"; allowed here: name, mirror, attached_to, axis_m, elements, y_axis, EA_N, GJ_N_m2, EI_y_N_m2, EI_z_N_m2, EI_yz_N_m2, bend_twist_y_N_m2, bend_twist_z_N_m2, tension_axis_y_m, tension_axis_z_m, shear_centre_y_m, shear_centre_z_m, section_stiffness, box, hinge, chord_m, distributed_mass, section_mass, point_masses, surface",
        ],
    );
}

#[test]
fn a_field_without_its_unit_is_guessed() {
    assert_messages(
        &[("\nsupport = ", "\ntemperature_offset = 10\nsupport = ")],
        &[
            "small.toml:4:1: temperature_offset: found the unknown field \"temperature_offset\"; did you mean \"temperature_offset_K\"? allowed here: format, name, gravity_m_s2, support, mode_basis, model, inflow_states, airspeed_m_s, altitude_m, temperature_offset_K, density_kg_m3, temperature_K, mount_attitude_deg, symmetric, basis, reference, limits, control, component, joint, engine, station, cut",
        ],
    );
}

#[test]
fn unknown_field_in_an_inline_table() {
    assert_messages(
        &[("hinge = 0.75", "hinges = 0.75")],
        &[
            "small.toml:30:8: component.wing_right.surface[1].flap.hinge: the field \"hinge\" is missing; it is needed; allowed here: lift_slope_per_rad, hinge, moment_slope, drag",
            "small.toml:30:34: component.wing_right.surface[1].flap.hinges: found the unknown field \"hinges\"; allowed here: lift_slope_per_rad, hinge, moment_slope, drag",
        ],
    );
}

#[test]
fn missing_field() {
    assert_messages(
        &[("EI_z_N_m2 = 1e6\n", "")],
        &[
            "small.toml:52:1: component.fin.EI_z_N_m2: the field \"EI_z_N_m2\" is missing; it is needed; allowed here: name, mirror, attached_to, axis_m, elements, y_axis, EA_N, GJ_N_m2, EI_y_N_m2, EI_z_N_m2, EI_yz_N_m2, bend_twist_y_N_m2, bend_twist_z_N_m2, tension_axis_y_m, tension_axis_z_m, shear_centre_y_m, shear_centre_z_m, section_stiffness, box, hinge, chord_m, distributed_mass, section_mass, point_masses, surface",
        ],
    );
}

#[test]
fn missing_top_field() {
    assert_messages(
        &[("support = \"free\"\n", "")],
        &[
            "small.toml:1:1: support: the field \"support\" is missing; it is needed; allowed here: format, name, gravity_m_s2, support, mode_basis, model, inflow_states, airspeed_m_s, altitude_m, temperature_offset_K, density_kg_m3, temperature_K, mount_attitude_deg, symmetric, basis, reference, limits, control, component, joint, engine, station, cut",
        ],
    );
}

#[test]
fn no_elements() {
    assert_messages(
        &[("elements = 4", "elements = 0")],
        &[
            "small.toml:14:12: component.wing_right.elements: found 0; a whole number from 1 to 1000 is allowed",
        ],
    );
}

#[test]
fn name_that_no_variable_can_have() {
    assert_messages(
        &[("name = \"tip\"", "name = \"left tip\"")],
        &[
            "small.toml:70:8: station[1].name: found the text \"left tip\"; a name of letters, digits and underscores that does not begin with a digit is allowed",
        ],
    );
}

#[test]
fn hinge_outside_the_chord() {
    assert_messages(
        &[("hinge = 0.75", "hinge = 1.2")],
        &[
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 1.2; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
        ],
    );
}

#[test]
fn hinge_at_the_trailing_edge() {
    assert_messages(
        &[("hinge = 0.75", "hinge = 1")],
        &[
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 1; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
        ],
    );
}

#[test]
fn not_a_number() {
    assert_messages(
        &[("chord_m = 1.5", "chord_m = nan")],
        &[
            "small.toml:16:11: component.wing_right.chord_m: found NaN; a length in metres from 1e-6 to 1000 is allowed",
        ],
    );
}

#[test]
fn infinite_number() {
    assert_messages(
        &[("[[0, 0, 0], [-6, 0, 0]]", "[[0, 0, 0], [-inf, 0, 0]]")],
        &[
            "small.toml:39:23: component.fuselage.axis_m[2][1]: found -inf; a length in metres from -1000 to 1000 is allowed",
        ],
    );
}

#[test]
fn syntax_error() {
    assert_messages(
        &[("elements = 4", "elements = ")],
        &[
            "small.toml:14:12: syntax: found \"elements =\": string values must be quoted, expected literal string; TOML is allowed (https://toml.io)",
        ],
    );
}

#[test]
fn field_given_twice() {
    assert_messages(
        &[("elements = 4", "elements = 4\nelements = 5")],
        &[
            "small.toml:15:1: syntax: found \"elements = 5\": duplicate key; TOML is allowed (https://toml.io)",
        ],
    );
}

#[test]
fn wrong_type() {
    assert_messages(
        &[("EA_N = 1e7", "EA_N = \"1e7\"")],
        &[
            "small.toml:17:8: component.wing_right.EA_N: found the text \"1e7\"; a number or a table of one form ({ per_element }, { at, values }, { polynomial }, { root, chord_power }, { multiple_of, factor }) is allowed",
        ],
    );
}

#[test]
fn vector_of_two() {
    assert_messages(
        &[("y_axis = [1, 0, 0]", "y_axis = [1, 0]")],
        &[
            "small.toml:15:10: component.wing_right.y_axis: found a list of 2; a list of three numbers is allowed",
        ],
    );
}

#[test]
fn unknown_word() {
    assert_messages(
        &[("mode_basis = \"bending_torsion\"", "mode_basis = \"bending\"")],
        &[
            "small.toml:5:14: mode_basis: found the text \"bending\"; \"bending_torsion\" or \"full\" is allowed",
        ],
    );
}

#[test]
fn unknown_level() {
    assert_messages(
        &[("model = \"exact\"", "model = \"Exact\"")],
        &[
            "small.toml:8:9: model: found the text \"Exact\"; \"exact\" or \"consistently_linearised\" or \"inconsistent\" or \"ruthlessly_linearised\" or \"rigid\" or \"geometrically_exact\" is allowed",
        ],
    );
}

#[test]
fn unknown_format() {
    assert_messages(
        &[("format = 1", "format = 2")],
        &["small.toml:1:10: format: found 2; the number 1 is allowed"],
    );
}

#[test]
fn too_many_inflow_states() {
    assert_messages(
        &[("inflow_states = 5", "inflow_states = 9")],
        &["small.toml:6:17: inflow_states: found 9; a whole number from 0 to 8 is allowed"],
    );
}

#[test]
fn a_trim_where_nothing_flies() {
    assert_messages(
        &[("inflow_states = 5", "inflow_states = 5\nairspeed_m_s = 0\naltitude_m = 31000")],
        &[
            "small.toml:7:16: airspeed_m_s: found 0; an airspeed in m/s from 1 to 400 is allowed, with support = \"clamped\" from 0 on",
            "small.toml:8:14: altitude_m: found 31000; an altitude in metres from -1000 to 30000 is allowed",
        ],
    );
}

#[test]
fn two_forms_of_a_law() {
    assert_messages(
        &[("polynomial = [3e6, -2e6]", "polynomial = [3e6, -2e6], factor = 2")],
        &[
            "small.toml:20:41: component.wing_right.EI_z_N_m2.factor: found the unknown field \"factor\"; allowed here: polynomial",
        ],
    );
}

#[test]
fn control_without_flap() {
    assert_messages(
        &[("flap = { lift_slope_per_rad = 3, hinge = 0.75 }\n", "")],
        &[
            "small.toml:26:1: component.wing_right.surface[1].flap: found a control and no flap; it is needed; allowed: { lift_slope_per_rad, hinge }",
        ],
    );
}

#[test]
fn all_mistakes_of_a_file_are_told_at_once() {
    assert_messages(
        &[
            ("chord_m = 1.5", "chord_m = -1.5"),
            ("elements = 3", "elements = 2.5"),
            ("hinge = 0.75", "hinge = 7.5"),
            ("name = \"tip\"\n", ""),
        ],
        &[
            "small.toml:16:11: component.wing_right.chord_m: found -1.5; a length in metres from 1e-6 to 1000 is allowed",
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 7.5; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
            "small.toml:40:12: component.fuselage.elements: found 2.5; a whole number from 1 to 1000 is allowed",
            "small.toml:69:1: station[1].name: the field \"name\" is missing; it is needed; allowed here: name, component, at_m, at",
        ],
    );
}

#[test]
fn distributed_mass_without_parts() {
    assert_messages(
        &[("[{ total_kg = 100, chord_power = 2 }]", "[]")],
        &[
            "small.toml:23:9: component.wing_right.distributed_mass[1].parts: found a list of 0; a list of at least one table is allowed",
        ],
    );
}

#[test]
fn length_in_millimetres() {
    assert_messages(
        &[("[[0, 0, 0], [-6, 0, 0]]", "[[0, 0, 0], [-6000, 0, 0]]")],
        &[
            "small.toml:39:23: component.fuselage.axis_m[2][1]: found -6000; a length in metres from -1000 to 1000 is allowed",
        ],
    );
}

/// Every value of the good file replaced by everything odd: a refusal or an aircraft of finite numbers.
#[test]
fn odd_values_neither_panic_nor_get_through() {
    let odd = [
        "-1",
        "0",
        "1",
        "1e300",
        "-1e300",
        "1e-300",
        "nan",
        "inf",
        "99999999999999999999",
        "\"x\"",
        "true",
        "[]",
        "{}",
        "[0, 0, 0]",
        "[1e300, 1e300, 1e300]",
        "[[1, 0]]",
        "{ at = [0, 0], values = [1, 1] }",
        "2020-01-01",
        "{ polynomial = [1e300, 1e300] }",
        "{ root = 1e-300, chord_power = 1e9 }",
        "{ per_element = [] }",
    ];
    let lines: Vec<&str> = GOOD.lines().collect();
    for (number, line) in lines.iter().enumerate() {
        let Some((field, _)) = line.split_once(" = ") else { continue };
        for value in odd {
            let edited = format!("{field} = {value}");
            let text = [&lines[..number], &[edited.as_str()], &lines[number + 1..]].concat().join("\n");
            match Aircraft::parse(&text, "odd.toml") {
                Err(error) => assert!(!error.diagnostics().is_empty(), "{edited}"),
                Ok(aircraft) => {
                    let numbers = format!("{aircraft:?}");
                    assert!(
                        !["NaN", "inf,", "inf]"].iter().any(|odd| numbers.contains(odd)),
                        "{edited}: {numbers}"
                    );
                }
            }
        }
    }
}

//! Bad aircraft files: each is a good one with an edit, and the message must say file, line, column, field, what
//! was found and what is allowed.

use flexible_aircraft::aircraft::Aircraft;

const GOOD: &str = include_str!("../data/small-aircraft.toml");

/// The good file with the first occurrence of a text replaced gives exactly these messages.
fn check(edits: &[(&str, &str)], messages: &[&str]) {
    let mut text = GOOD.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "the edit {from:?} must change something");
        text = text.replacen(from, to, 1);
    }
    let error = Aircraft::parse(&text, "small.toml").expect_err("a bad file");
    assert_eq!(error.to_string(), messages.join("\n"));
}

#[test]
fn unedited_file_is_good() {
    let aircraft = Aircraft::parse(GOOD, "small.toml").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((aircraft.nodes.len(), aircraft.beams.len(), aircraft.strips.len()), (14, 13, 8));
}

#[test]
fn negative_stiffness() {
    check(
        &[("EA_N = 1e7", "EA_N = -1e7")],
        &["small.toml:17:8: component.wing_right.EA_N: found -10000000; a number greater than 0 is allowed"],
    );
}

#[test]
fn stiffness_zero() {
    check(
        &[("EA_N = 1e7", "EA_N = 0")],
        &["small.toml:17:8: component.wing_right.EA_N: found 0; a number greater than 0 is allowed"],
    );
}

#[test]
fn law_that_becomes_negative_names_the_element() {
    check(
        &[("polynomial = [3e6, -2e6]", "polynomial = [3e6, -4e6]")],
        &[
            "small.toml:20:13: component.wing_right.EI_z_N_m2.element[4]: found -500000; a number greater than 0 is allowed",
        ],
    );
}

#[test]
fn negative_mass() {
    check(
        &[("mass_kg = [300, 80]", "mass_kg = [300, -80]")],
        &[
            "small.toml:49:17: component.fuselage.point_masses[1].mass_kg[2]: found -80; a number greater than 0 is allowed",
        ],
    );
}

#[test]
fn mass_zero() {
    check(
        &[("total_kg = 100", "total_kg = 0.0")],
        &[
            "small.toml:23:23: component.wing_right.distributed_mass[1].parts[1].total_kg: found 0; a number greater than 0 is allowed",
        ],
    );
}

#[test]
fn negative_chord() {
    check(
        &[("chord_m = 1.5", "chord_m = -1.5")],
        &["small.toml:16:11: component.wing_right.chord_m: found -1.5; a number greater than 0 is allowed"],
    );
}

#[test]
fn chord_zero() {
    check(
        &[("chord_m = 1.5", "chord_m = 0")],
        &["small.toml:16:11: component.wing_right.chord_m: found 0; a number greater than 0 is allowed"],
    );
}

#[test]
fn inertia_against_the_triangle_inequality() {
    check(
        &[("[40, 50, 60]", "[40, 50, 91]")],
        &[
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia 40, 50.00000000000001, 91 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn radii_of_gyration_against_the_triangle_inequality() {
    check(
        &[("gyration_chords = [0, 0.25, 0.25]", "gyration_chords = [0, 0.25, 0.5]")],
        &[
            "small.toml:24:19: component.wing_right.distributed_mass[1].gyration_chords: found the principal moments of inertia 0, 3.515625, 14.0625 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn products_of_inertia_too_great() {
    check(
        &[("[40, 50, 60]", "[40, 50, 60]\nproducts_kg_m2 = [0, 60, 0]")],
        &[
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia -10.827625302982193, 49.999999999999986, 110.82762530298221 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn unknown_field() {
    check(
        &[("chord_m = 1.5", "chord_m = 1.5\nsweep_deg = 3")],
        &[
            "small.toml:17:1: component.wing_right.sweep_deg: found the unknown field \"sweep_deg\"; allowed here: name, mirror, attached_to, axis_m, elements, y_axis, EA_N, GJ_N_m2, EI_y_N_m2, EI_z_N_m2, chord_m, distributed_mass, point_masses, surface",
        ],
    );
}

#[test]
fn unknown_field_in_an_inline_table() {
    check(
        &[("hinge = 0.75", "hinges = 0.75")],
        &[
            "small.toml:30:8: component.wing_right.surface[1].flap.hinge: the field \"hinge\" is missing; it is needed; allowed here: lift_slope_per_rad, hinge",
            "small.toml:30:34: component.wing_right.surface[1].flap.hinges: found the unknown field \"hinges\"; allowed here: lift_slope_per_rad, hinge",
        ],
    );
}

#[test]
fn missing_field() {
    check(
        &[("EI_z_N_m2 = 1e6\n", "")],
        &[
            "small.toml:52:1: component.fin.EI_z_N_m2: the field \"EI_z_N_m2\" is missing; it is needed; allowed here: name, mirror, attached_to, axis_m, elements, y_axis, EA_N, GJ_N_m2, EI_y_N_m2, EI_z_N_m2, chord_m, distributed_mass, point_masses, surface",
        ],
    );
}

#[test]
fn missing_top_field() {
    check(
        &[("support = \"free\"\n", "")],
        &[
            "small.toml:1:1: support: the field \"support\" is missing; it is needed; allowed here: format, name, gravity_m_s2, support, mode_basis, inflow_states, symmetric, component, engine, station",
        ],
    );
}

#[test]
fn component_on_an_unknown_one() {
    check(
        &[("{ component = \"fuselage\", at = 1 }", "{ component = \"body\", at = 1 }")],
        &[
            "small.toml:54:29: component.fin.attached_to.component: found \"body\", which is not a component above this one; allowed: \"origin\" or one of the components above: wing_right, wing_left, fuselage",
        ],
    );
}

#[test]
fn component_between_nodes() {
    check(
        &[("component = \"fuselage\", at = 1", "component = \"fuselage\", at = 0.5")],
        &[
            "small.toml:54:46: component.fin.attached_to.at: found 0.5, where \"fuselage\" has no node; the fraction of one of its 4 nodes is allowed, 0 and 1 among them",
        ],
    );
}

#[test]
fn axis_that_does_not_begin_at_its_attachment() {
    check(
        &[("[[0, 0, 0], [-0.5, 0, -2]]", "[[0, 0, -1], [-0.5, 0, -2]]")],
        &[
            "small.toml:55:10: component.fin.axis_m[1]: found a first point [0.0, 0.0, -1.0]; the axis begins at its attachment point: [0, 0, 0] is allowed",
        ],
    );
}

#[test]
fn element_of_zero_length() {
    check(
        &[("[0, 0, 0], [0, 5, 0]", "[0, 0, 0], [0, 0, 0]")],
        &[
            "small.toml:13:10: component.wing_right.axis_m[2]: found elements of length 0 m; elements of at least 0.000001 m are allowed",
        ],
    );
}

#[test]
fn no_elements() {
    check(
        &[("elements = 4", "elements = 0")],
        &[
            "small.toml:14:12: component.wing_right.elements: found 0; a whole number from 1 to 1000 is allowed",
        ],
    );
}

#[test]
fn y_axis_along_the_beam() {
    check(
        &[("y_axis = [0, 1, 0]", "y_axis = [1, 0, 0]")],
        &[
            "small.toml:41:10: component.fuselage.y_axis: found a direction along element 1 itself; a direction across the beam is allowed",
        ],
    );
}

#[test]
fn station_off_the_beam() {
    check(
        &[("component = \"wing_left\"\nat = 1", "component = \"wing_left\"\nat = 1.02")],
        &["small.toml:72:6: station.tip.at: found 1.02; a place on the component is allowed, from 0 to 1"],
    );
}

#[test]
fn mass_off_the_beam() {
    check(
        &[("at_m = [1, 4.5]", "at_m = [1, 6.5]")],
        &[
            "small.toml:48:12: component.fuselage.point_masses[1].at_m[2]: found 6.5 m; a place on the component is allowed, from 0 to 6 m",
        ],
    );
}

#[test]
fn station_on_an_unknown_component() {
    check(
        &[("component = \"wing_left\"", "component = \"wing\"")],
        &[
            "small.toml:71:13: station.tip.component: found \"wing\", which is not a component; allowed: wing_right, wing_left, fuselage, fin",
        ],
    );
}

#[test]
fn duplicate_component() {
    check(
        &[("name = \"fin\"", "name = \"wing_left\"")],
        &[
            "small.toml:53:8: component.wing_left.name: found the name \"wing_left\" a second time; a name that no other component has is allowed",
        ],
    );
}

#[test]
fn duplicate_station() {
    check(
        &[("[[station]]", "[[station]]\nname = \"tip\"\ncomponent = \"fin\"\nat = 1\n\n[[station]]")],
        &[
            "small.toml:75:8: station.tip.name: found the name \"tip\" a second time; a name that no other station has is allowed",
        ],
    );
}

#[test]
fn duplicate_engine() {
    check(
        &[(
            "[[engine]]",
            "[[engine]]\nname = \"only\"\ncomponent = \"fuselage\"\nat = 0\ndirection = [1, 0, 0]\n\n[[engine]]",
        )],
        &[
            "small.toml:70:8: engine.only.name: found the name \"only\" a second time; a name that no other engine has is allowed",
        ],
    );
}

#[test]
fn name_that_no_variable_can_have() {
    check(
        &[("name = \"tip\"", "name = \"left tip\"")],
        &[
            "small.toml:70:8: station.left tip.name: found the text \"left tip\"; a name of letters, digits and underscores that does not begin with a digit is allowed",
        ],
    );
}

#[test]
fn hinge_outside_the_chord() {
    check(
        &[("hinge = 0.75", "hinge = 1.2")],
        &[
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 1.2; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
        ],
    );
}

#[test]
fn hinge_at_the_trailing_edge() {
    check(
        &[("hinge = 0.75", "hinge = 1")],
        &[
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 1; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
        ],
    );
}

#[test]
fn no_engine_on_a_free_aircraft() {
    check(
        &[("[[engine]]\nname = \"only\"\ncomponent = \"fuselage\"\nat_m = 0\ndirection = [1, 0, 0]\n", "")],
        &[
            "small.toml:4:11: support: found \"free\" and no engine; at least one [[engine]], or support = \"clamped\", is allowed",
        ],
    );
}

#[test]
fn no_mass() {
    check(
        &[
            (
                "[[component.point_masses]]\nat_m = [1, 4.5]\nmass_kg = [300, 80]\ninertia_kg_m2 = [40, 50, 60]\n",
                "",
            ),
            (
                "[[component.distributed_mass]]\nparts = [{ total_kg = 100, chord_power = 2 }]\ngyration_chords = [0, 0.25, 0.25]\n",
                "",
            ),
        ],
        &[
            "small.toml:1:1: component: found no mass on any component; at least one distributed_mass or point_masses is needed",
        ],
    );
}

#[test]
fn wing_without_mirror_image() {
    check(
        &[("mirror = \"wing_left\"\n", ""), ("component = \"wing_left\"", "component = \"wing_right\"")],
        &[
            "small.toml:10:8: component.wing_right.name: found the component \"wing_right\" without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn mass_without_mirror_image() {
    check(
        &[("mass_kg = [300, 80]", "mass_kg = [300, 80]\noffset_m = [0, 0.1, 0]")],
        &[
            "small.toml:51:17: component.fuselage.point_masses[1].inertia_kg_m2: found a mass of 300 kg without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn engine_without_mirror_image() {
    check(
        &[("at_m = 0\n", "at_m = 0\noffset_m = [0, 1, 0]\n")],
        &[
            "small.toml:64:8: engine.only.name: found the engine \"only\" without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn not_a_number() {
    check(
        &[("chord_m = 1.5", "chord_m = nan")],
        &["small.toml:16:11: component.wing_right.chord_m: found NaN; a number greater than 0 is allowed"],
    );
}

#[test]
fn infinite_number() {
    check(
        &[("[[0, 0, 0], [-6, 0, 0]]", "[[0, 0, 0], [-inf, 0, 0]]")],
        &["small.toml:39:23: component.fuselage.axis_m[2][1]: found -inf; a finite number is allowed"],
    );
}

#[test]
fn syntax_error() {
    check(
        &[("elements = 4", "elements = ")],
        &[
            "small.toml:14:12: syntax: found \"elements =\": string values must be quoted, expected literal string; TOML is allowed (https://toml.io)",
        ],
    );
}

#[test]
fn field_given_twice() {
    check(
        &[("elements = 4", "elements = 4\nelements = 5")],
        &[
            "small.toml:15:1: syntax: found \"elements = 5\": duplicate key; TOML is allowed (https://toml.io)",
        ],
    );
}

#[test]
fn wrong_type() {
    check(
        &[("EA_N = 1e7", "EA_N = \"1e7\"")],
        &[
            "small.toml:17:8: component.wing_right.EA_N: found the text \"1e7\"; a number or a table of one form ({ per_element }, { at, values }, { polynomial }, { root, chord_power }, { multiple_of, factor }) is allowed",
        ],
    );
}

#[test]
fn vector_of_two() {
    check(
        &[("y_axis = [1, 0, 0]", "y_axis = [1, 0]")],
        &[
            "small.toml:15:10: component.wing_right.y_axis: found a list of 2; a list of three numbers is allowed",
        ],
    );
}

#[test]
fn unknown_word() {
    check(
        &[("mode_basis = \"bending_torsion\"", "mode_basis = \"bending\"")],
        &[
            "small.toml:5:14: mode_basis: found the text \"bending\"; \"bending_torsion\" or \"full\" is allowed",
        ],
    );
}

#[test]
fn unknown_format() {
    check(&[("format = 1", "format = 2")], &["small.toml:1:10: format: found 2; the number 1 is allowed"]);
}

#[test]
fn too_many_inflow_states() {
    check(
        &[("inflow_states = 5", "inflow_states = 9")],
        &["small.toml:6:17: inflow_states: found 9; a whole number from 0 to 8 is allowed"],
    );
}

#[test]
fn values_for_another_number_of_elements() {
    check(
        &[("per_element = [1e7, 9e6, 8e6]", "per_element = [1e7, 9e6]")],
        &[
            "small.toml:45:13: component.fuselage.EI_z_N_m2.per_element: found 2 values; one for each of the 3 elements is allowed",
        ],
    );
}

#[test]
fn multiple_of_a_multiple() {
    check(
        &[(
            "EI_z_N_m2 = { polynomial = [3e6, -2e6] }",
            "EI_z_N_m2 = { multiple_of = \"GJ_N_m2\", factor = 2 }",
        )],
        &[
            "small.toml:20:13: component.wing_right.EI_z_N_m2.multiple_of: found a multiple of \"GJ_N_m2\", which is itself a multiple; a multiple of a law that stands for itself is allowed",
        ],
    );
}

#[test]
fn two_forms_of_a_law() {
    check(
        &[("polynomial = [3e6, -2e6]", "polynomial = [3e6, -2e6], factor = 2")],
        &[
            "small.toml:20:41: component.wing_right.EI_z_N_m2.factor: found the unknown field \"factor\"; allowed here: polynomial",
        ],
    );
}

#[test]
fn control_without_flap() {
    check(
        &[("flap = { lift_slope_per_rad = 3, hinge = 0.75 }\n", "")],
        &[
            "small.toml:26:1: component.wing_right.surface[1].flap: found a control and no flap; it is needed; allowed: { lift_slope_per_rad, hinge }",
        ],
    );
}

#[test]
fn surface_without_chord() {
    check(
        &[("chord_m = 1.5\n", ""), (", chord_power = 2", ""), ("gyration_chords = [0, 0.25, 0.25]\n", "")],
        &[
            "small.toml:24:1: component.wing_right.surface[1].chord_m: found a quantity in terms of the chord, and no chord_m; it is allowed in a component that has a law chord_m",
        ],
    );
}

#[test]
fn all_mistakes_of_a_file_are_told_at_once() {
    check(
        &[
            ("chord_m = 1.5", "chord_m = -1.5"),
            ("elements = 3", "elements = 2.5"),
            ("hinge = 0.75", "hinge = 7.5"),
            ("name = \"tip\"\n", ""),
        ],
        &[
            "small.toml:16:11: component.wing_right.chord_m: found -1.5; a number greater than 0 is allowed",
            "small.toml:30:42: component.wing_right.surface[1].flap.hinge: found 7.5; a fraction of the chord behind the leading edge is allowed, greater than 0 and less than 1",
            "small.toml:40:12: component.fuselage.elements: found 2.5; a whole number from 1 to 1000 is allowed",
            "small.toml:69:1: station[1].name: the field \"name\" is missing; it is needed; allowed here: name, component, at_m, at",
        ],
    );
}

#[test]
fn all_mistakes_of_an_aircraft_are_told_at_once() {
    check(
        &[
            ("per_element = [1e7, 9e6, 8e6]", "per_element = [1e7, 9e6]"),
            ("[40, 50, 60]", "[40, 50, 91]"),
            ("y_axis = [1, 0, 0]", "y_axis = [0, 1, 0]"),
        ],
        &[
            "small.toml:15:10: component.wing_right.y_axis: found a direction along element 1 itself; a direction across the beam is allowed",
            "small.toml:45:13: component.fuselage.EI_z_N_m2.per_element: found 2 values; one for each of the 3 elements is allowed",
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia 40, 50.00000000000001, 91 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

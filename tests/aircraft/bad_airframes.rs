//! Files whose fields are good each by itself and whose aircraft is not.

use super::assert_messages;

#[test]
fn law_that_becomes_negative_names_the_element() {
    assert_messages(
        &[("polynomial = [3e6, -2e6]", "polynomial = [3e6, -4e6]")],
        &[
            "small.toml:20:13: component.wing_right.EI_z_N_m2.element[4]: found -500000; a stiffness in N or N m² from 1e-6 to 1e15 is allowed",
        ],
    );
}

#[test]
fn inertia_against_the_triangle_inequality() {
    assert_messages(
        &[("[40, 50, 60]", "[40, 50, 91]")],
        &[
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia 40.000, 50.000, 91.000 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn radii_of_gyration_against_the_triangle_inequality() {
    assert_messages(
        &[("gyration_chords = [0, 0.25, 0.25]", "gyration_chords = [0, 0.25, 0.5]")],
        &[
            "small.toml:24:19: component.wing_right.distributed_mass[1].gyration_chords: found the principal moments of inertia 0.000, 3.516, 14.062 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn products_of_inertia_too_great() {
    assert_messages(
        &[("[40, 50, 60]", "[50, 50, 50]\nproducts_kg_m2 = [0, 60, 0]")],
        &[
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia -10.00, 50.00, 110.00 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn component_on_an_unknown_one() {
    assert_messages(
        &[("{ component = \"fuselage\", at = 1 }", "{ component = \"body\", at = 1 }")],
        &[
            "small.toml:54:29: component.fin.attached_to.component: found \"body\", which is not a component above this one; allowed: \"origin\" or one of the components above: wing_right, wing_left, fuselage",
        ],
    );
}

#[test]
fn component_between_nodes() {
    assert_messages(
        &[("component = \"fuselage\", at = 1", "component = \"fuselage\", at = 0.5")],
        &[
            "small.toml:54:46: component.fin.attached_to.at: found 0.5, where \"fuselage\" has no node; the fraction of one of its 4 nodes is allowed, 0 and 1 among them (0.6666666666666666 is the nearest)",
        ],
    );
}

#[test]
fn axis_that_does_not_begin_at_its_attachment() {
    assert_messages(
        &[("[[0, 0, 0], [-0.5, 0, -2]]", "[[0, 0, -1], [-0.5, 0, -2]]")],
        &[
            "small.toml:55:10: component.fin.axis_m[1]: found a first point [0.0, 0.0, -1.0]; the axis begins at its attachment point: [0, 0, 0] is allowed",
        ],
    );
}

#[test]
fn element_of_zero_length() {
    assert_messages(
        &[("[0, 0, 0], [0, 5, 0]", "[0, 0, 0], [0, 0, 0]")],
        &[
            "small.toml:13:10: component.wing_right.axis_m[2]: found elements of length 0 m; elements of at least 0.000001 m are allowed",
        ],
    );
}

#[test]
fn y_axis_along_the_beam() {
    assert_messages(
        &[("y_axis = [0, 1, 0]", "y_axis = [1, 0, 0]")],
        &[
            "small.toml:41:10: component.fuselage.y_axis: found a direction along element 1 itself; a direction across the beam is allowed",
        ],
    );
}

#[test]
fn station_off_the_beam() {
    assert_messages(
        &[("component = \"wing_left\"\nat = 1", "component = \"wing_left\"\nat = 1.02")],
        &["small.toml:72:6: station.tip.at: found 1.02; a fraction from 0 to 1 is allowed"],
    );
}

#[test]
fn mass_off_the_beam() {
    assert_messages(
        &[("at_m = [1, 4.5]", "at_m = [1, 6.5]")],
        &[
            "small.toml:48:12: component.fuselage.point_masses[1].at_m[2]: found 6.5 m; a place on the component is allowed, from 0 to 6 m",
        ],
    );
}

#[test]
fn station_on_an_unknown_component() {
    assert_messages(
        &[("component = \"wing_left\"", "component = \"wing\"")],
        &[
            "small.toml:71:13: station.tip.component: found \"wing\", which is not a component; allowed: wing_right, wing_left, fuselage, fin, tail_right, tail_left",
        ],
    );
}

#[test]
fn duplicate_component() {
    assert_messages(
        &[("name = \"fin\"", "name = \"wing_left\"")],
        &[
            "small.toml:53:8: component.wing_left.name: found the name \"wing_left\" a second time; a name that no other component has is allowed",
        ],
    );
}

#[test]
fn duplicate_station() {
    assert_messages(
        &[("[[station]]", "[[station]]\nname = \"tip\"\ncomponent = \"fin\"\nat = 1\n\n[[station]]")],
        &[
            "small.toml:75:8: station.tip.name: found the name \"tip\" a second time; a name that no other station has is allowed",
        ],
    );
}

#[test]
fn duplicate_engine() {
    assert_messages(
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
fn a_tunnels_air_and_mount_around_a_free_aircraft() {
    assert_messages(
        &[("symmetric = true", "density_kg_m3 = 1.1\nmount_attitude_deg = [90, 0, 0]")],
        &[
            "small.toml:7:17: density_kg_m3: found it with support = \"free\"; support = \"clamped\" is allowed with it",
            "small.toml:8:22: mount_attitude_deg: found it with support = \"free\"; support = \"clamped\" is allowed with it",
        ],
    );
}

#[test]
fn density_and_altitude_together() {
    assert_messages(
        &[("\"free\"", "\"clamped\""), ("symmetric = true", "density_kg_m3 = 1.1\naltitude_m = 0")],
        &[
            "small.toml:8:14: altitude_m: found \"altitude_m\" and \"density_kg_m3\"; one of the two is allowed",
        ],
    );
}

#[test]
fn temperature_without_density() {
    assert_messages(
        &[("\"free\"", "\"clamped\""), ("symmetric = true", "temperature_K = 300")],
        &[
            "small.toml:7:17: temperature_K: found a temperature without density_kg_m3; both together are allowed; at an altitude_m the air has that of the standard atmosphere",
        ],
    );
}

#[test]
fn densities_temperatures_and_attitudes_that_no_tunnel_has() {
    assert_messages(
        &[
            ("\"free\"", "\"clamped\""),
            (
                "symmetric = true",
                "density_kg_m3 = 0\ntemperature_K = -20\nmount_attitude_deg = [0, 90, 0]\nairspeed_m_s = -1",
            ),
        ],
        &[
            "small.toml:7:17: density_kg_m3: found 0; a density in kg/m³ from 1e-9 to 1e5 is allowed",
            "small.toml:8:17: temperature_K: found -20; a temperature in K from 1 to 2000 is allowed",
            "small.toml:9:22: mount_attitude_deg: found a pitch of 90; a pitch in degrees from -89 to 89 is allowed",
            "small.toml:10:16: airspeed_m_s: found -1; an airspeed in m/s from 0 to 400 is allowed",
        ],
    );
}

#[test]
fn no_mass() {
    assert_messages(
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
    assert_messages(
        &[("mirror = \"wing_left\"\n", ""), ("component = \"wing_left\"", "component = \"wing_right\"")],
        &[
            "small.toml:10:8: component.wing_right.name: found the component \"wing_right\" without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn mass_without_mirror_image() {
    assert_messages(
        &[("mass_kg = [300, 80]", "mass_kg = [300, 80]\noffset_m = [0, 0.1, 0]")],
        &[
            "small.toml:51:17: component.fuselage.point_masses[1].inertia_kg_m2: found a mass of 300 kg without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn engine_without_mirror_image() {
    assert_messages(
        &[("at_m = 0\n", "at_m = 0\noffset_m = [0, 1, 0]\n")],
        &[
            "small.toml:64:8: engine.only.name: found the engine \"only\" without mirror image in y = 0, while symmetric = true; a structure that is its own mirror image is allowed, or symmetric = false",
        ],
    );
}

#[test]
fn values_for_another_number_of_elements() {
    assert_messages(
        &[("per_element = [1e7, 9e6, 8e6]", "per_element = [1e7, 9e6]")],
        &[
            "small.toml:45:13: component.fuselage.EI_z_N_m2.per_element: found 2 values; one for each of the 3 elements is allowed",
        ],
    );
}

#[test]
fn multiple_of_a_multiple() {
    assert_messages(
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
fn surface_without_chord() {
    assert_messages(
        &[("chord_m = 1.5\n", ""), (", chord_power = 2", ""), ("gyration_chords = [0, 0.25, 0.25]\n", "")],
        &[
            "small.toml:24:1: component.wing_right.surface[1].chord_m: found a quantity in terms of the chord, and no chord_m; it is allowed in a component that has a law chord_m",
        ],
    );
}

#[test]
fn all_mistakes_of_an_aircraft_are_told_at_once() {
    assert_messages(
        &[
            ("per_element = [1e7, 9e6, 8e6]", "per_element = [1e7, 9e6]"),
            ("[40, 50, 60]", "[40, 50, 91]"),
            ("y_axis = [1, 0, 0]", "y_axis = [0, 1, 0]"),
        ],
        &[
            "small.toml:15:10: component.wing_right.y_axis: found a direction along element 1 itself; a direction across the beam is allowed",
            "small.toml:45:13: component.fuselage.EI_z_N_m2.per_element: found 2 values; one for each of the 3 elements is allowed",
            "small.toml:50:17: component.fuselage.point_masses[1].inertia_kg_m2: found the principal moments of inertia 40.000, 50.000, 91.000 kg m²; moments are allowed of which none is negative or greater than the sum of the others",
        ],
    );
}

#[test]
fn chord_that_becomes_negative_is_told_once() {
    assert_messages(
        &[("chord_m = 1.5", "chord_m = { polynomial = [1, -2] }")],
        &[
            "small.toml:16:11: component.wing_right.chord_m.element[3]: found -0.25; a length in metres from 1e-6 to 1000 is allowed",
        ],
    );
}

#[test]
fn shares_of_a_total_that_are_no_masses() {
    assert_messages(
        &[("mass_kg = [300, 80]", "total_kg = 2e-9\nshares = [1, 1]\nshares_of = 4")],
        &[
            "small.toml:50:10: component.fuselage.point_masses[1].shares: found 5e-10; a mass in kg from 1e-9 to 1e9 is allowed",
        ],
    );
}

#[test]
fn shares_of_almost_nothing() {
    assert_messages(
        &[("mass_kg = [300, 80]", "total_kg = 300\nshares = [1, 1]\nshares_of = 1e-320")],
        &[
            "small.toml:51:13: component.fuselage.point_masses[1].shares_of: found 1e-320; a share from 1e-9 to 1e9 is allowed",
        ],
    );
}

#[test]
fn mirrored_component_on_a_parent_off_the_plane() {
    assert_messages(
        &[
            ("[[0, 0, 0], [-6, 0, 0]]", "[[0, 0, 0], [-6, 1, 0]]"),
            ("name = \"fin\"", "name = \"fin\"\nmirror = \"fin_left\""),
        ],
        &[
            "small.toml:55:29: component.fin.attached_to.component: found \"fuselage\", which is off the plane y = 0 and has no mirror image; a mirrored component is allowed on a parent in the plane or one that is mirrored too",
            "small.toml:99:29: component.tail_right.attached_to.component: found \"fuselage\", which is off the plane y = 0 and has no mirror image; a mirrored component is allowed on a parent in the plane or one that is mirrored too",
        ],
    );
}

#[test]
fn surface_along_the_body_needs_a_span_axis() {
    let surface = "\n[[component.surface]]\nelastic_axis = 0.5\nlift_slope_per_rad = 1\nprofile_drag = 0\nchord_m = 1\n";
    let edit = format!("inertia_kg_m2 = [40, 50, 60]\n{surface}");
    assert_messages(
        &[("inertia_kg_m2 = [40, 50, 60]\n", &edit)],
        &[
            "small.toml:52:1: component.fuselage.surface[1].span_axis: found a span axis along the body's x axis; a span_axis across the body's x axis is allowed, for example [0, 1, 0]",
        ],
    );
}

#[test]
fn surface_across_the_beam_needs_a_width() {
    let surface = "\n[[component.surface]]\nelastic_axis = 0.5\nlift_slope_per_rad = 1\nprofile_drag = 0\nchord_m = 1\nspan_axis = [0, 1, 0]\n";
    let edit = format!("inertia_kg_m2 = [40, 50, 60]\n{surface}");
    assert_messages(
        &[("inertia_kg_m2 = [40, 50, 60]\n", &edit)],
        &[
            "small.toml:52:1: component.fuselage.surface[1].width_m: found an element across the span axis and no width_m; it is needed where the beam does not run along the span; a law is allowed",
        ],
    );
}

#[test]
fn limits_of_nothing_beyond_all_or_upside_down() {
    let limits = "inflow_states = 5\nlimits = { maximum_mach = 0, maximum_alpha = 3 }";
    let edits = [
        ("inflow_states = 5", limits),
        ("positive = \"nose-down\"", "positive = \"nose-down\"\nminimum_deg = 20\nmaximum_deg = -20"),
        ("positive = \"nose right\"", "positive = \"nose right\"\nmaximum_deg = 91"),
    ];
    let error = super::edited(&edits).expect_err("bad limits").to_string();
    for message in [
        "limits.maximum_mach: found 0; a Mach number above 0 up to 10 is allowed",
        "79:15: control.elevator.maximum_deg: found minimum_deg = 20 and maximum_deg = -20, in degrees; maximum_deg > minimum_deg is allowed",
        "control.rudder.maximum_deg: found 91; an angle in degrees from -90 to 90 is allowed",
        "limits.maximum_alpha: found the unknown field \"maximum_alpha\"; allowed here: minimum_angle_of_attack_deg, ",
    ] {
        assert!(error.contains(message), "{message}\n{error}");
    }
}

//! A mirror image is one branch, one mass, one engine for each, not whatever is found at its place.

use flexible_aircraft::aircraft::{Aircraft, Problem};

const BIPLANE: &str = include_str!("../data/braced-biplane.toml");

/// What the biplane is told when a text is added to the component that begins with another one.
fn complaints(edits: &[(&str, &str)]) -> Vec<String> {
    let mut text = BIPLANE.to_owned();
    for (before, added) in edits {
        assert!(text.contains(before), "{before}");
        text = text.replacen(before, &format!("{added}{before}"), 1);
    }
    match Aircraft::parse(&text, "biplane.toml") {
        Ok(_) => Vec::new(),
        Err(error) => {
            assert!(error.diagnostics().iter().all(|one| one.problem == Problem::NotSymmetric), "{error}");
            error.diagnostics().iter().map(|one| one.found.clone()).collect()
        }
    }
}

/// Where the table after a component begins, so that what is put before it belongs to the component.
const AFTER_UPPER_WING: &str = "[[component]]\nname = \"keel\"";
const AFTER_BODY: &str = "[[component]]\nname = \"tail_right\"";
const AFTER_ALL: &str = "[[engine]]";

fn mass(component: &str, at: f64, offset: f64) -> String {
    let axis = format!("axis_m = [[0, 0, 0], [0, {offset}, 0]]");
    format!(
        "[[component]]\nname = \"{component}_extra\"\nattached_to = {{ component = \"{component}\", at = {at} }}\n{axis}\n\
         elements = 1\ny_axis = [1, 0, 0]\nEA_N = 1e7\nGJ_N_m2 = 1e5\nEI_y_N_m2 = 1e5\nEI_z_N_m2 = 1e5\n\
         [[component.point_masses]]\nat = 1\nmass_kg = 2\n"
    )
}

#[test]
fn what_hangs_on_a_strut_has_no_image_on_the_wing_that_the_strut_touches() {
    let (right, left) = (mass("strut_right", 1.0, 0.3), mass("strut_left", 1.0, -0.3));
    assert!(complaints(&[(AFTER_ALL, &right), (AFTER_ALL, &left)]).is_empty());
    // In the same place, but on another branch.
    let left = mass("upper_left", 0.75, -0.3);
    let found = complaints(&[(AFTER_ALL, &right), (AFTER_ALL, &left)]);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(
        found[0].contains("\"upper_left_extra\"") || found[0].contains("\"strut_right_extra\""),
        "{found:?}"
    );
}

#[test]
fn two_masses_are_no_image_of_one() {
    let at = |offset: f64| {
        format!("[[component.point_masses]]\nat = 0.4\nmass_kg = 3\noffset_m = [0, {offset}, 0]\n")
    };
    let (right, left) = (at(0.4), at(-0.4));
    assert!(complaints(&[(AFTER_BODY, &right), (AFTER_BODY, &left)]).is_empty());
    let found = complaints(&[(AFTER_BODY, &right), (AFTER_BODY, &left), (AFTER_BODY, &left)]);
    assert_eq!(found, ["found a mass of 3 kg without mirror image in y = 0, while symmetric = true"]);
}

#[test]
fn two_engines_are_no_image_of_one() {
    let at = |name: &str, offset: f64| {
        format!(
            "[[engine]]\nname = \"{name}\"\ncomponent = \"body\"\nat = 0\noffset_m = [0, {offset}, 0]\n\
             direction = [1, 0, 0]\n"
        )
    };
    let (right, left, another) = (at("right", 1.0), at("left", -1.0), at("another", -1.0));
    assert!(complaints(&[(AFTER_ALL, &right), (AFTER_ALL, &left)]).is_empty());
    let found = complaints(&[(AFTER_ALL, &right), (AFTER_ALL, &left), (AFTER_ALL, &another)]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].contains("engine"), "{found:?}");
}

#[test]
fn branches_in_one_place_are_told_apart_by_stiffness_and_mass() {
    // Two beams along the same axis on each side, written in another order on the left.
    let beam = |name: &str, y: f64, stiffness: f64, mass: f64| {
        format!(
            "[[component]]\nname = \"{name}\"\nattached_to = \"origin\"\naxis_m = [[0, 0, 0], [0, {y}, 0]]\n\
             elements = 2\ny_axis = [1, 0, 0]\nEA_N = 1e7\nGJ_N_m2 = 1e5\nEI_y_N_m2 = {stiffness}\n\
             EI_z_N_m2 = 1e6\n[[component.distributed_mass]]\nparts = [{{ total_kg = {mass} }}]\n\n"
        )
    };
    for (one, other) in [([1e5, 4.0], [2e5, 4.0]), ([1e5, 4.0], [1e5, 6.0])] {
        let right = [beam("a", 2.0, one[0], one[1]), beam("b", 2.0, other[0], other[1])].concat();
        let left = [beam("c", -2.0, other[0], other[1]), beam("d", -2.0, one[0], one[1])].concat();
        assert!(complaints(&[(AFTER_UPPER_WING, &right), (AFTER_UPPER_WING, &left)]).is_empty());
    }
}

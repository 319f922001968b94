//! Cuts for section loads: where they stand, what is outboard of them, how their axes lie; and stations along a component
//! [theory: section-loads.outboard, section-loads.axes].

use flexible_aircraft::aircraft::{Aircraft, StationsAlongError};
use flexible_aircraft::structure::{ReducedCut, ReducedModel};
use nalgebra::Vector3;

use super::{assert_messages, edited};

/// The small aircraft with this cut alone.
fn with_cut(component: &str, at: f64) -> Aircraft {
    let cut = format!("name = \"tail\"\ncomponent = \"{component}\"\nat = {at}");
    edited(&[("name = \"tail\"\ncomponent = \"fuselage\"\nat = 0.45", &cut)]).unwrap()
}

/// The elements outboard of a cut.
fn outboard(component: &str, at: f64) -> Vec<usize> {
    with_cut(component, at).cuts[0].outboard.clone()
}

#[test]
fn what_hangs_on_a_component_at_the_cut_or_beyond_is_outboard() {
    // Wings have 4 elements each, the fuselage 3, fin and tails 2: 0, 4, 8, 11, 13, 15 and on.
    assert_eq!(outboard("wing_right", 0.0), [0, 1, 2, 3]);
    assert_eq!(outboard("wing_left", 0.6), [6, 7]);
    assert_eq!(outboard("wing_left", 1.0), Vec::<usize>::new());
    assert_eq!(outboard("fuselage", 0.0), (8..17).collect::<Vec<_>>());
    assert_eq!(outboard("fuselage", 1.0), (11..17).collect::<Vec<_>>());
    // The fin and the tails hang on one node, and not on each other.
    assert_eq!(outboard("fin", 0.0), [11, 12]);
    assert_eq!(outboard("tail_right", 0.0), [13, 14]);
}

#[test]
fn a_cut_stands_at_the_nearest_node_and_of_two_at_the_inner_one() {
    for (at, node) in [(0.0, 0), (0.16, 0), (0.17, 1), (0.45, 1), (0.5, 1), (0.51, 2), (0.99, 3)] {
        let cut = &with_cut("fuselage", at).cuts[0];
        assert!((cut.at - f64::from(node) / 3.0).abs() < 1e-12, "{at}: {cut:?}");
    }
}

#[test]
fn axes_of_a_cut_lie_as_engineers_count() {
    let axes = |component: &str| -> ReducedCut {
        let model = ReducedModel::new(&with_cut(component, 0.0), 2).unwrap();
        model.cuts[0].clone()
    };
    for (wing, side) in [("wing_right", 1.0), ("wing_left", -1.0)] {
        let ReducedCut { along, up, chordwise, torsion, .. } = axes(wing);
        assert!(along.y * side > 0.9 && up.z < -0.9 && chordwise.x > 0.9 && torsion.y > 0.9, "{wing}");
        assert!(along.dot(&up).abs() < 1e-15 && along.dot(&chordwise).abs() < 1e-15);
    }
    // A beam without strips is a body.
    let ReducedCut { along, up, chordwise, torsion, .. } = axes("fuselage");
    assert!(along.x < -0.9 && (up + Vector3::z()).norm() < 1e-15);
    assert!((chordwise - Vector3::y()).norm() < 1e-15 && torsion == -along);
}

#[test]
fn a_cut_changes_nothing_but_itself() {
    let [with, without] = [1.0, 0.0].map(|at| ReducedModel::new(&with_cut("fuselage", at), 4).unwrap());
    assert_ne!(with.cuts, without.cuts);
    assert_eq!(ReducedModel { cuts: Vec::new(), ..with }, ReducedModel { cuts: Vec::new(), ..without });
}

#[test]
fn cuts_that_cannot_be_are_refused_where_they_stand() {
    let line = super::GOOD.lines().position(|line| line == "[[cut]]").unwrap() + 1;
    assert_messages(
        &[("component = \"fuselage\"\nat = 0.45", "component = \"hull\"\nat = 0.45")],
        &[&format!(
            "small.toml:{}:13: cut.tail.component: found \"hull\", which is not a component; allowed: wing_right, wing_left, fuselage, fin, tail_right, tail_left",
            line + 2
        )],
    );
    for (at, found) in [("1.02", "1.02"), ("-0.1", "-0.1"), ("inf", "inf")] {
        let error = edited(&[("at = 0.45", &format!("at = {at}"))]).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("small.toml:{}:6: cut.tail.at: found {found}", line + 3)),
            "{error}"
        );
    }
    let second = "[[cut]]\nname = \"tail\"\ncomponent = \"fin\"\nat = 1\n\n[[cut]]";
    assert_messages(
        &[("[[cut]]", second)],
        &[&format!(
            "small.toml:{}:8: cut.tail.name: found the name \"tail\" a second time; a name that no other cut has is allowed",
            line + 6
        )],
    );
}

#[test]
fn cuts_along_a_component_stand_at_all_of_its_nodes() {
    let aircraft = edited(&[]).unwrap();
    let cuts = aircraft.cuts_along("wing_left").unwrap();
    let names: Vec<&str> = cuts.iter().map(|cut| cut.name.as_str()).collect();
    assert_eq!(names, ["wing_left_00", "wing_left_01", "wing_left_02", "wing_left_03", "wing_left_04"]);
    assert!(cuts.windows(2).all(|pair| pair[0].outboard.len() == pair[1].outboard.len() + 1));
    assert!(aircraft.cuts_along("wing").is_none());
}

#[test]
fn stations_along_a_component_stand_in_the_middle_of_equal_parts() {
    let mut aircraft = edited(&[]).unwrap();
    aircraft.add_stations_along("fuselage", 3).unwrap();
    let added: Vec<_> = aircraft.stations[1..].iter().map(|s| (s.name.as_str(), s.attachment.beam)).collect();
    assert_eq!(added, [("fuselage_01", 8), ("fuselage_02", 9), ("fuselage_03", 10)]);
    assert!(aircraft.stations[1..].iter().all(|station| (station.attachment.fraction - 0.5).abs() < 1e-12));
    let before = aircraft.clone();
    let refusals = [("fuselage", 2), ("hull", 2), ("fin", 0)]
        .map(|(component, count)| aircraft.add_stations_along(component, count).unwrap_err());
    assert_eq!(refusals[0], StationsAlongError::NameTaken("fuselage_01".to_owned()));
    assert!(refusals[1].to_string().starts_with("found component \"hull\", allowed are wing_right, "));
    assert_eq!(refusals[2].to_string(), "found 0 stations along fin, allowed are 1 to 999");
    assert_eq!(aircraft, before);
}

//! Cuts for section loads: where they stand, what is outboard of them, how their axes lie; and stations along a component
//! [theory: section-loads.outboard, section-loads.axes].

use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, Fidelity, StationsAlongError};
use flexible_aircraft::flight::{Inputs, Simulation};
use flexible_aircraft::plant::{Outputs, PlantSettings};
use flexible_aircraft::structure::{ReducedCut, ReducedModel};
use flexible_aircraft::variables::VariableTable;
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

/// The axes of a cut through a component of the edited small aircraft.
fn axes_in(edits: &[(&str, &str)], component: &str, at: f64) -> ReducedCut {
    let cut = format!("name = \"tail\"\ncomponent = \"{component}\"\nat = {at}");
    let mut all = edits.to_vec();
    all.push(("name = \"tail\"\ncomponent = \"fuselage\"\nat = 0.45", &cut));
    ReducedModel::new(&edited(&all).unwrap(), 2).unwrap().cuts.swap_remove(0)
}

/// Along, up, chordwise and the axis of torsion are nearly these.
fn assert_axes(cut: &ReducedCut, expected: [Vector3<f64>; 4], case: &str) {
    for (axis, expected) in [cut.along, cut.up, cut.chordwise, cut.torsion].iter().zip(expected) {
        assert!(axis.dot(&expected) > 0.9, "{case}: {cut:?}");
    }
}

/// The wing bends up by a right angle at five sixths of its length.
const WINGLET: (&str, &str) = (
    "axis_m = [[0, 0, 0], [0, 5, 0]]\nelements = 4",
    "axis_m = [[0, 0, 0], [0, 5, 0], [0, 5, -1]]\nelements = [4, 2]",
);

#[test]
fn a_wing_with_a_winglet_is_cut_as_a_wing_and_its_winglet_as_a_fin() {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    for (wing, side) in [("wing_right", 1.0), ("wing_left", -1.0)] {
        for at in [0.0, 0.4, 0.6] {
            assert_axes(&axes_in(&[WINGLET], wing, at), [y * side, -z, x, y], wing);
        }
        // The node at the kink is where the winglet begins; n of the left one is the mirror image.
        for at in [5.0 / 6.0, 1.0] {
            assert_axes(&axes_in(&[WINGLET], wing, at), [-z, -y * side, x, -z * side], wing);
        }
    }
}

#[test]
fn a_cut_where_no_strips_are_has_the_axes_of_those_nearby_but_not_of_those_beyond_a_kink() {
    const EVERYWHERE: &str = "[[component.surface]]\nelastic_axis = 0.35\nlift_slope_per_rad = 5.5";
    let surface = |from: f64| {
        format!(
            "[[component.surface]]\nfrom = {from}\nincidence_deg = 10\nelastic_axis = 0.35\nlift_slope_per_rad = 5.5"
        )
    };
    // The leading edge is up where the surface is.
    let cut = axes_in(&[(EVERYWHERE, &surface(0.5))], "wing_right", 0.0);
    assert!((cut.chordwise.z + f64::to_radians(10.0).sin()).abs() < 1e-12, "{cut:?}");
    let outer = surface(5.0 / 6.0);
    let winglet = [WINGLET, (EVERYWHERE, outer.as_str()), ("from = 0.5", "from = 0.9")];
    let cut = axes_in(&winglet, "wing_right", 0.0);
    assert!(
        cut.chordwise == Vector3::x() && cut.torsion == Vector3::y(),
        "a body that runs sideways: {cut:?}"
    );
}

#[test]
fn axes_of_bodies_lie_the_same_however_little_they_lean() {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    let lopsided = ("symmetric = true\n", "");
    let body = |axis: [f64; 3]| {
        let fin = format!("axis_m = [[0, 0, 0], {axis:?}]\nelements = 2\ny_axis = [0.3, 0.4, 0.5]");
        axes_in(
            &[lopsided, ("axis_m = [[0, 0, 0], [-0.5, 0, -2]]\nelements = 2\ny_axis = [1, 0, 0]", &fin)],
            "fin",
            0.0,
        )
    };
    for lean in [-0.2, -1e-6, 0.0, 1e-6, 0.2] {
        for side in [1.0, -1.0] {
            let case = format!("{side}, {lean}");
            assert_axes(&body([lean, side, lean]), [y * side, -z, x, y], &case);
            assert_axes(&body([lean, lean, side]), [z * side, x, y, -z], &case);
            assert_axes(&body([side, lean, lean]), [x * side, -z, y, x], &case);
        }
    }
    // Halfway it runs sideways: up is inboard then.
    let strut = body([0.0, 1.0, -1.0]);
    assert!(strut.up.z < -0.7 && strut.up.y < -0.7 && strut.chordwise.x > 0.99 && strut.torsion.y > 0.7);
}

#[test]
fn a_fin_is_cut_with_shear_to_the_left_and_torsion_nose_left() {
    let surface = "EI_z_N_m2 = 1e6\nchord_m = 1\n\n[[component.surface]]\nelastic_axis = 0.35\nlift_slope_per_rad = 4\n\
                   profile_drag = 0.01\n\n[[engine]]";
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    let fin = axes_in(&[("EI_z_N_m2 = 1e6\n\n[[engine]]", surface)], "fin", 0.0);
    assert_axes(&fin, [-z, -y, x, -z], "fin");
}

#[test]
fn what_is_attached_at_the_node_of_a_cut_is_inboard_but_at_a_root_outboard() {
    let bodies = |at: f64| {
        let cut = format!("name = \"tail\"\ncomponent = \"fuselage\"\nat = {at}");
        let edits = [
            ("at_m = [1, 4.5]", "at_m = [2, 4.5]"),
            ("name = \"tail\"\ncomponent = \"fuselage\"\nat = 0.45", cut.as_str()),
        ];
        let model = ReducedModel::new(&edited(&edits).unwrap(), 2).unwrap();
        let outboard = &model.cuts[0].outboard;
        let masses = outboard.masses.iter().map(|&mass| model.masses[mass].body.mass);
        (masses.collect::<Vec<_>>(), outboard.engines.len())
    };
    // 300 kg at the node at 2 m, 80 kg beyond; the engine at the root.
    assert_eq!(bodies(0.0), (vec![300.0, 80.0], 1));
    assert_eq!(bodies(1.0 / 3.0), (vec![80.0], 0));
}

#[test]
fn descriptions_of_the_loads_at_a_cut_say_where_it_stands_and_was_asked_for() {
    for (at, expected) in [
        (0.45, "through fuselage at 0.333333 of its length, the node nearest to 0.45"),
        (1.0, "through fuselage at 1 of its length"),
    ] {
        let model = ReducedModel::new(&with_cut("fuselage", at), 2).unwrap();
        let table = VariableTable::new(&model);
        let described = &table.named("loads.tail.axial").unwrap().description;
        assert!(described.ends_with(expected), "{described}");
    }
}

#[test]
fn cuts_change_no_bit_of_a_flight() {
    let with = edited(&[]).unwrap();
    let without = Aircraft { cuts: Vec::new(), ..with.clone() };
    let models = [&with, &without].map(|aircraft| Arc::new(ReducedModel::new(aircraft, 4).unwrap()));
    assert_eq!(models[1].cuts, []);
    assert_eq!(ReducedModel { cuts: Vec::new(), ..(*models[0]).clone() }, *models[1]);
    for fidelity in Fidelity::ALL {
        let [with, without] = models.each_ref().map(|model| {
            let settings = PlantSettings { fidelity, ..PlantSettings::of(model) };
            let mut flight = Simulation::new(Arc::clone(model), &settings.into(), 0.0).unwrap();
            let mut inputs = Inputs::zero(model);
            (inputs.controls[super::AILERON], inputs.thrust[0]) = (0.02, 50.0);
            flight.set_inputs(&inputs, &Inputs::zero(model));
            let outputs = |step| {
                flight.advance_to(f64::from(step) * 0.02).unwrap();
                let loads = model.cuts.len();
                assert_eq!(flight.instant_with_loads().outputs.loads.known().unwrap().len(), loads);
                flight.outputs().clone()
            };
            (1..=10).map(outputs).collect::<Vec<Outputs>>()
        });
        for (with, without) in with.into_iter().zip(without) {
            let with = Outputs { loads: without.loads.clone(), ..with };
            // As text, in which zeros have signs.
            assert_eq!(format!("{with:?}"), format!("{without:?}"), "{fidelity:?}");
        }
    }
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

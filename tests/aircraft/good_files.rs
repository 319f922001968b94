//! What good files mean, beyond the jet: mirror images, laws, and errors as data.

use std::path::Path;

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Bound, Fidelity, Limits, Problem, Strip};
use flexible_aircraft::plant::PlantSettings;
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{Value, VariableTable};
use nalgebra::Vector3;

use super::{AILERON, GOOD, edited};

fn aircraft(edits: &[(&str, &str)]) -> Aircraft {
    edited(edits).unwrap_or_else(|error| panic!("{error}"))
}

/// The strips of a component.
fn strips<'a>(aircraft: &'a Aircraft, component: &str) -> Vec<&'a Strip> {
    let on_it = |strip: &&Strip| aircraft.beams[strip.attachment.beam].component == component;
    aircraft.strips.iter().filter(on_it).collect()
}

#[test]
fn small_aircraft_has_the_parts_that_it_lists() {
    let aircraft = aircraft(&[]);
    assert_eq!((aircraft.nodes.len(), aircraft.beams.len()), (18, 17));
    assert_eq!((aircraft.bays.len(), aircraft.strips.len()), (10, 12));
    assert_eq!((aircraft.engines.len(), aircraft.stations.len()), (1, 1));
}

#[test]
fn an_aircraft_flies_at_the_level_that_its_file_names() {
    for level in Fidelity::ALL {
        let named = aircraft(&[("model = \"exact\"", &format!("model = \"{}\"", level.name()))]);
        let model = ReducedModel::new(&named, 2).unwrap();
        assert_eq!([named.fidelity, model.fidelity, PlantSettings::of(&model).fidelity], [level; 3]);
        let table = VariableTable::new(&model);
        let variable = table.named("model").unwrap();
        assert_eq!(variable.start, Some(Value::Integer(level as i32 + 1)));
    }
    assert_eq!(aircraft(&[("model = \"exact\"", "")]).fidelity, Fidelity::GeometricallyExact);
}

#[test]
fn limits_replace_the_usual_ones_end_by_end() {
    assert_eq!(aircraft(&[]).limits, Limits::default());
    let text = "inflow_states = 5\nlimits = { maximum_angle_of_attack_deg = 12, minimum_thrust_N = -500 }";
    let edits = [
        ("inflow_states = 5", text),
        ("positive = \"nose-down\"", "positive = \"nose-down\"\nminimum_deg = -25"),
        ("positive = \"nose right\"", "positive = \"nose right\"\nminimum_deg = 40"),
    ];
    let limited = aircraft(&edits);
    let limits = limited.limits;
    let [elevator, aileron, rudder] = [0, 1, 2].map(|control| limited.controls[control].limits);
    assert_eq!(limits.angle_of_attack.maximum, Bound::Given(12_f64.to_radians()));
    assert_eq!(limits.angle_of_attack.minimum, Bound::Usual((-15_f64).to_radians()));
    assert_eq!((limits.thrust.minimum, limits.thrust.maximum), (Bound::Given(-500.0), Bound::None));
    assert_eq!(elevator.minimum, Bound::Given((-25_f64).to_radians()));
    assert_eq!(elevator.maximum, Bound::Usual(30_f64.to_radians()));
    // A usual end that the file's other end contradicts is none.
    assert_eq!((rudder.minimum, rudder.maximum), (Bound::Given(40_f64.to_radians()), Bound::None));
    assert_eq!(limits.mach, Limits::default().mach);
    let twenty = 20_f64.to_radians();
    assert_eq!((aileron.minimum, aileron.maximum), (Bound::Given(-twenty), Bound::Given(twenty)));
}

#[test]
fn left_wing_mirrors_the_right_one_and_counts_nose_up_alike() {
    let aircraft = aircraft(&[("elastic_axis = 0.35", "elastic_axis = 0.35\nincidence_deg = 3")]);
    let (right, left) = (strips(&aircraft, "wing_right"), strips(&aircraft, "wing_left"));
    for (right, left) in right.iter().zip(&left) {
        assert_eq!((right.span, left.span), (Vector3::y(), Vector3::y()));
        assert_eq!(right.forward, left.forward);
        assert!(
            (right.forward.z + 3_f64.to_radians().sin()).abs() < 1e-15,
            "nose-up is towards -z: {right:?}"
        );
    }
}

/// No strip is on the last element of the wings, nor any on fin and fuselage.
#[test]
fn twist_is_nose_up_without_a_strip_too() {
    for (component, axis) in [
        ("wing_left", Vector3::y()),
        ("wing_right", Vector3::y()),
        ("fin", -Vector3::z()),
        ("fuselage", Vector3::x()),
    ] {
        let aircraft = aircraft(&[
            ("elastic_axis = 0.35", "elastic_axis = 0.35\nto = 0.75"),
            ("component = \"wing_left\"", &format!("component = \"{component}\"")),
        ]);
        assert_eq!(aircraft.stations[0].twist_axis, axis, "{component}");
    }
}

#[test]
fn control_moves_only_the_strips_of_its_stretch() {
    let aircraft = aircraft(&[]);
    let gains: Vec<f64> = strips(&aircraft, "wing_right")
        .iter()
        .map(|strip| strip.flap.as_ref().unwrap().gains[AILERON])
        .collect();
    assert_eq!(gains, [0.0, 0.0, -1.0, -1.0]);
}

#[test]
fn flaps_of_one_surface_differ_along_it_by_laws_on_both_sides() {
    let flap = "{ lift_slope_per_rad = { at = [0, 1], values = [4, 2] }, hinge = { polynomial = [0.7, 0.2] }, \
                moment_slope = { per_element = [-0.1, -0.2, -0.3, -0.4] }, drag = { per_element = [0, 1.6, 0.2, 0.2] } }";
    let aircraft = aircraft(&[("{ lift_slope_per_rad = 3, hinge = 0.75 }", flap)]);
    for wing in ["wing_right", "wing_left"] {
        let strips = strips(&aircraft, wing);
        let flaps = || strips.iter().map(|strip| strip.flap.as_ref().unwrap());
        assert_eq!(
            flaps().map(|flap| flap.lift_slope).collect::<Vec<_>>(),
            [3.75, 3.25, 2.75, 2.25],
            "{wing}"
        );
        for (flap, expected) in flaps().zip([0.725, 0.775, 0.825, 0.875]) {
            assert!((flap.hinge - expected).abs() < 1e-15, "{wing}: {} instead of {expected}", flap.hinge);
        }
        assert_eq!(
            flaps().map(|flap| flap.moment_slope.unwrap()).collect::<Vec<_>>(),
            [-0.1, -0.2, -0.3, -0.4],
            "{wing}"
        );
        assert_eq!(flaps().map(|flap| flap.drag).collect::<Vec<_>>(), [0.0, 1.6, 0.2, 0.2], "{wing}");
    }
}

#[test]
fn laws_are_evaluated_at_the_middle_of_each_element() {
    let aircraft = aircraft(&[]);
    let root = &aircraft.beams[0];
    let near = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-14, "{one} instead of {other}");
    near(root.bending_stiffness_y, 1e6 - 0.125 * 9e5);
    near(root.torsional_stiffness, 2.0 * root.bending_stiffness_y);
    near(root.bending_stiffness_z, 3e6 - 0.125 * 2e6);
    near(aircraft.beams[10].bending_stiffness_z, 8e6);
}

#[test]
fn zero_lift_moment_is_a_law_and_comes_with_the_reduced_strip_through_its_bytes() {
    let moments = "profile_drag = 0.01\nzero_lift_moment = { at = [0, 1], values = [-0.08, -0.04] }";
    let model = ReducedModel::new(&aircraft(&[("profile_drag = 0.01", moments)]), 4).unwrap();
    let model = ReducedModel::from_bytes(&model.to_bytes()).unwrap();
    for (strip, expected) in model.strips.iter().zip([-0.075, -0.065, -0.055, -0.045].repeat(2)) {
        assert!((strip.zero_lift_moment - expected).abs() < 1e-16, "{strip:?}");
    }
    let without = ReducedModel::new(&aircraft(&[]), 4).unwrap();
    assert!(without.strips.iter().all(|strip| strip.zero_lift_moment == 0.0));
}

#[test]
fn incidence_camber_axis_suction_and_offsets_are_laws_along_the_span() {
    let aircraft = aircraft(&[
        (
            "elastic_axis = 0.35",
            "elastic_axis = { at = [0, 1], values = [0.3, 0.4] }\nincidence_deg = { at = [0, 1], values = [2, -2] }\n\
             zero_lift_offset_deg = { polynomial = [3, -1] }\nleading_edge_suction = { per_element = [1, 0.9, 0.8, 0.7] }",
        ),
        (
            "gyration_chords = [0, 0.25, 0.25]",
            "gyration_chords = [0, 0.25, 0.25]\noffset_chords = [{ at = [0, 1], values = [-0.1, 0.1] }, 0, 0.02]",
        ),
    ]);
    let near = |one: f64, other: f64| assert!((one - other).abs() < 1e-15, "{one} instead of {other}");
    for wing in ["wing_right", "wing_left"] {
        for (element, strip) in strips(&aircraft, wing).iter().enumerate() {
            let s = (element as f64 + 0.5) / 4.0;
            near(libm::atan2(-strip.forward.z, strip.forward.x), (2.0 - 4.0 * s).to_radians());
            near(strip.zero_lift_offset, (3.0 - s).to_radians());
            near(strip.elastic_axis_aft_of_midchord, (0.3 + 0.1 * s - 0.5) * 1.5);
            near(strip.leading_edge_suction, 1.0 - 0.1 * element as f64);
        }
    }
    for (bay, s) in aircraft.bays.iter().zip([0.125, 0.375, 0.625, 0.875].repeat(2)) {
        near(bay.offset.x, (-0.1 + 0.2 * s) * 1.5);
        near(bay.offset.z, 0.03);
    }
}

#[test]
fn kinked_axis_takes_its_elements_from_each_segment() {
    let aircraft = aircraft(&[
        ("[[0, 0, 0], [0, 5, 0]]", "[[0, 0, 0], [0, 1, 0], [0, 5, -3]]"),
        ("elements = 4", "elements = [2, 5]"),
    ]);
    assert_eq!(aircraft.nodes[2], Vector3::new(0.0, 1.0, 0.0));
    assert!((aircraft.nodes[3] - Vector3::new(0.0, 1.8, -0.6)).norm() < 1e-15);
    assert_eq!(aircraft.nodes[7], Vector3::new(0.0, 5.0, -3.0));
}

#[test]
fn distributed_mass_follows_length_where_elements_differ() {
    let aircraft = aircraft(&[
        ("[[0, 0, 0], [0, 5, 0]]", "[[0, 0, 0], [0, 1, 0], [0, 5, 0]]"),
        ("elements = 4", "elements = [1, 1]"),
    ]);
    assert_eq!((aircraft.bays[0].mass, aircraft.bays[1].mass), (20.0, 80.0));
}

#[test]
fn mirrored_tail_hangs_on_the_mirrored_parent() {
    let tail = "[[component]]\nname = \"fin\"\nmirror = \"fin_left\"";
    let edits =
        [("[[component]]\nname = \"fin\"", tail), ("\"fuselage\", at = 1", "\"wing_right\", at = 0.5")];
    let aircraft = aircraft(&edits);
    let first = |component: &str| {
        let beam = aircraft.beams.iter().find(|beam| beam.component == component).unwrap();
        aircraft.nodes[beam.nodes[0]].y
    };
    assert_eq!((first("fin"), first("fin_left")), (2.5, -2.5));
}

#[test]
fn clamped_wing_needs_no_engine() {
    let engine = GOOD.split("[[engine]]").nth(1).unwrap().split("[[station]]").next().unwrap();
    let engine = format!("[[engine]]{engine}");
    assert!(aircraft(&[("\"free\"", "\"clamped\""), (&engine, "")]).engines.is_empty());
}

#[test]
fn diagnostic_underlines_the_text_that_it_is_about() {
    let error = edited(&[("chord_m = 1.5", "chord_m = -1.5")]).expect_err("a bad file");
    let AircraftFileError::Rejected { text, diagnostics, .. } = error else { panic!("{error}") };
    let [diagnostic] = diagnostics.as_slice() else { panic!("{diagnostics:?}") };
    assert_eq!(&text[diagnostic.span.clone()], "-1.5");
    assert_eq!(diagnostic.problem, Problem::OutOfRange);
}

#[test]
fn every_shipped_file_is_an_aircraft() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("aircraft");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    assert!(files.len() >= 5, "{files:?}");
    for file in files {
        Aircraft::read(&file).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn file_that_is_not_there_is_named() {
    let error = Aircraft::read(Path::new("no/such/aircraft.toml")).expect_err("no such file");
    assert!(
        error.to_string().starts_with("no/such/aircraft.toml: cannot read the aircraft file: "),
        "{error}"
    );
}

/// The first TOML block of a document for people.
fn first_example(document: &str) -> &str {
    document.split("```toml\n").nth(1).unwrap().split("```").next().unwrap()
}

#[test]
fn example_of_the_readme_is_an_aircraft() {
    let readme = include_str!("../../aircraft/README.md");
    let aircraft = Aircraft::parse(first_example(readme), "README.md").unwrap_or_else(|e| panic!("{e}"));
    assert!(!aircraft.strips.is_empty() && !aircraft.engines.is_empty());
}

//! `[[joint]]`: written once and there on both sides, and what is refused [theory: structure.joints, section-loads.loops].

use flexible_aircraft::aircraft::{Aircraft, Fidelity, Problem};
use flexible_aircraft::structure::{ModalBasis, ModeFamily, ReducedModel, Structure, StructureError};

const BRACED: &str = include_str!("../data/strut-braced.toml");
const TWIN_BOOM: &str = include_str!("../data/twin-boom.toml");

/// The joint of the braced wing.
const JOINT: &str = "[[joint]]\ncomponent = \"strut_right\"\nat = 1\njoined_to = { component = \"wing_right\", at = 0.5 }\nrotations = \"free\"\n";

/// A file with the first occurrence of some texts replaced.
fn edited(text: &str, edits: &[(&str, &str)]) -> String {
    edits.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "the edit {from:?} must change something");
        text.replacen(from, to, 1)
    })
}

/// The braced aircraft is refused for one thing, of this kind, with this field, this found and this allowed.
fn assert_refused(edits: &[(&str, &str)], problem: Problem, [field, found, allowed]: [&str; 3]) {
    let error = Aircraft::parse(&edited(BRACED, edits), "braced.toml").expect_err("a bad file");
    let [diagnostic] = error.diagnostics() else { panic!("{error}") };
    assert_eq!(diagnostic.problem, problem, "{diagnostic}");
    let texts = [&diagnostic.field, &diagnostic.found, &diagnostic.allowed].map(String::as_str);
    assert_eq!(texts, [field, found, allowed]);
}

#[test]
fn a_joint_is_written_once_and_is_on_both_sides() {
    let aircraft = Aircraft::parse(BRACED, "braced.toml").unwrap();
    let joints: Vec<String> = aircraft.joints.iter().map(ToString::to_string).collect();
    let expected = [
        "the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5",
        "the joint of \"strut_left\" at 1 and \"wing_left\" at 0.5",
    ];
    assert_eq!(joints, expected);
    let within = aircraft.elements_in_loops();
    let in_loops = |name: &str| {
        let beams = aircraft.beams.iter().zip(&within).filter(|(beam, _)| beam.component == name);
        beams.filter(|(_, within)| **within).count()
    };
    let names = ["wing_right", "wing_left", "strut_right", "strut_left", "keel", "body", "fin"];
    assert_eq!(names.map(in_loops), [4, 4, 4, 4, 2, 0, 0]);
}

#[test]
fn a_joint_across_the_mirror_plane_is_there_once() {
    let across = "[[joint]]\ncomponent = \"tail_left\"\nat = 1\njoined_to = { component = \"tail_right\", at = 1 }\nrotations = \"fixed\"\n";
    let aircraft = Aircraft::parse(&(TWIN_BOOM.to_owned() + across), "twin.toml").unwrap();
    assert_eq!(aircraft.joints.len(), 1);
    assert_eq!(aircraft.joints[0].rotations, [true; 3]);
    // Right and left each: two elements of the wing, all of boom and tail.
    assert_eq!(aircraft.elements_in_loops().iter().filter(|within| **within).count(), 2 * (2 + 4 + 4));
}

#[test]
fn what_cannot_be_joined_is_refused_by_name() {
    let joint = "joint[1]";
    assert_refused(
        &[(
            "joined_to = { component = \"wing_right\", at = 0.5 }",
            "joined_to = { component = \"wing_right\", at = 0.75 }",
        )],
        Problem::Disconnected,
        [
            joint,
            "found the joint of \"strut_right\" at 1 and \"wing_right\" at 0.75, 1402.0 mm apart: at [0.000, 2.800, -0.150] and [0.000, 4.200, -0.225] m",
            "nodes at most 1 mm apart are allowed",
        ],
    );
    assert_refused(
        &[("component = \"strut_right\"\nat = 1", "component = \"wing_right\"\nat = 0.5")],
        Problem::Contradiction,
        [
            joint,
            "found the joint of \"wing_right\" at 0.5 and \"wing_right\" at 0.5, which are one node",
            "two nodes are allowed that do not hang together yet",
        ],
    );
    // A component's root is the node on which it hangs.
    assert_refused(
        &[(
            "component = \"strut_right\"\nat = 1\njoined_to = { component = \"wing_right\", at = 0.5 }",
            "component = \"strut_right\"\nat = 0\njoined_to = { component = \"keel\", at = 1 }",
        )],
        Problem::Contradiction,
        [
            joint,
            "found the joint of \"strut_right\" at 0 and \"keel\" at 1, which are one node",
            "two nodes are allowed that do not hang together yet",
        ],
    );
    assert_refused(
        &[("at = 0.5 }", "at = 0.51 }")],
        Problem::Disconnected,
        [
            "joint[1].joined_to.at",
            "found 0.51, where \"wing_right\" has no node",
            "the fraction of one of its 9 nodes is allowed, 0 and 1 among them (0.5 is the nearest)",
        ],
    );
    // Before a hinge is what its component hangs on: a joint of the root would not be one of what turns.
    assert_refused(
        &[
            ("EA_N = 3e7", "hinge = { axis = [1, 0, 0], stiffness_N_m_per_rad = 1e3 }\nEA_N = 3e7"),
            (
                "component = \"strut_right\"\nat = 1\njoined_to = { component = \"wing_right\", at = 0.5 }",
                "component = \"strut_right\"\nat = 0\njoined_to = { component = \"body\", at = 0 }",
            ),
        ],
        Problem::Disconnected,
        [
            "joint[1].at",
            "found the root of \"strut_right\", where a hinge is",
            "a node beyond the hinge is allowed, or what that component hangs on",
        ],
    );
    assert_refused(
        &[("joined_to = { component = \"wing_right\"", "joined_to = { component = \"wings\"")],
        Problem::UnknownName,
        [
            "joint[1].joined_to.component",
            "found \"wings\", which is not a component",
            "allowed: wing_right, wing_left, body, keel, strut_right, strut_left, tail_right, tail_left, fin",
        ],
    );
    let mirrored = JOINT.replace("_right", "_left");
    assert_refused(
        &[(JOINT, &format!("{JOINT}\n{mirrored}"))],
        Problem::DuplicateName,
        [
            "joint[2]",
            "found the joint of \"strut_left\" at 1 and \"wing_left\" at 0.5 a second time, beside the joint of \"strut_left\" at 1 and \"wing_left\" at 0.5",
            "one joint of two nodes is allowed; with mirrored components it is on both sides by itself",
        ],
    );
}

#[test]
fn rotations_are_words_or_axes_each_once() {
    let with =
        |rotations: &str| edited(BRACED, &[("rotations = \"free\"", &format!("rotations = {rotations}"))]);
    let shared =
        |rotations: &str| Aircraft::parse(&with(rotations), "braced.toml").unwrap().joints[1].rotations;
    assert_eq!(shared("\"fixed\""), [true; 3]);
    assert_eq!(shared("[\"z\", \"x\"]"), [true, false, true]);
    for rotations in ["\"pinned\"", "[]", "[\"x\", \"x\"]", "[\"w\"]", "\"x\"", "[1]", "true"] {
        let error = Aircraft::parse(&with(rotations), "braced.toml").unwrap_err();
        assert_eq!(error.diagnostics()[0].problem, Problem::WrongType, "{rotations}: {error}");
        assert!(error.diagnostics()[0].field.starts_with("joint[1].rotations"), "{rotations}: {error}");
    }
}

#[test]
fn a_loop_and_the_geometrically_exact_level_exclude_each_other_written_or_not() {
    let joint = "the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5";
    let allowed = "that level has no loops: write model = \"exact\"; allowed with joints: \"exact\", \"consistently_linearised\", \"inconsistent\", \"ruthlessly_linearised\", \"rigid\"";
    assert_refused(
        &[("model = \"exact\"", "model = \"geometrically_exact\"")],
        Problem::Contradiction,
        ["model", &format!("found \"geometrically_exact\" with {joint}, which closes a loop"), allowed],
    );
    assert_refused(
        &[("model = \"exact\"\n", "")],
        Problem::Contradiction,
        [
            "joint[1]",
            &format!(
                "found {joint}, which closes a loop, and no model, which is \"geometrically_exact\" then"
            ),
            allowed,
        ],
    );
    // A program can ask for what no file can.
    let mut aircraft = Aircraft::parse(BRACED, "braced.toml").unwrap();
    aircraft.fidelity = Fidelity::GeometricallyExact;
    assert_eq!(
        ReducedModel::new(&aircraft, 4).unwrap_err(),
        StructureError::Loop { joint: joint.to_owned() }
    );
}

#[test]
fn a_cut_within_a_loop_is_refused_and_beside_it_stands() {
    for (component, at) in
        [("wing_right", 0.25), ("strut_right", 0.5), ("strut_left", 1.0), ("keel", 0.5), ("wing_left", 0.0)]
    {
        let cut = format!("component = \"{component}\"\nat = {at}\n\n[[engine]]");
        let side = if component.ends_with("left") { "left" } else { "right" };
        let found = format!(
            "found a cut within the loop that is closed by the joint of \"strut_{side}\" at 1 and \"wing_{side}\" at 0.5"
        );
        assert_refused(
            &[("component = \"wing_right\"\nat = 0.5\n\n[[engine]]", &cut)],
            Problem::Contradiction,
            [
                "cut.outer_wing.name",
                &found,
                "a cut beside loops is allowed: within one the structure is statically indeterminate, summation has no unique answer",
            ],
        );
    }
    let aircraft = Aircraft::parse(BRACED, "braced.toml").unwrap();
    let names = |component: &str| -> Vec<String> {
        aircraft.cuts_along(component).unwrap().into_iter().map(|cut| cut.name).collect()
    };
    assert_eq!(
        names("wing_right"),
        ["wing_right_04", "wing_right_05", "wing_right_06", "wing_right_07", "wing_right_08"]
    );
    assert_eq!(names("strut_right"), Vec::<String>::new());
    assert_eq!(names("tail_right").len(), 5);
    let mut within = aircraft.clone();
    let cut = edited(BRACED, &[(JOINT, "")]);
    within.cuts = Aircraft::parse(&cut, "unbraced.toml").unwrap().cuts_along("strut_right").unwrap();
    let refused = ReducedModel::new(&within, 4).unwrap_err().to_string();
    assert!(refused.contains("the cut \"strut_right_00\" is within the loop"), "{refused}");
}

#[test]
fn joints_without_images_leave_no_mirror_plane_and_are_refused_where_it_is_declared() {
    // Wings and struts of names of their own on each side: nothing is mirrored by itself.
    let text = edited(BRACED, &[(JOINT, &format!("{JOINT}\n{}", JOINT.replace("_right", "_left")))]);
    let apart = |text: &str, symmetric: bool| {
        let mut document: toml::Table = text.parse().unwrap();
        document.insert("symmetric".to_owned(), symmetric.into());
        // Ailerons would have to be mirrored: the structure alone counts here.
        document.remove("control");
        let components = document["component"].as_array_mut().unwrap();
        let mut all = Vec::new();
        for component in components.drain(..) {
            let mut component = component;
            let table = component.as_table_mut().unwrap();
            let mirror = table.remove("mirror");
            table.remove("surface");
            let is_braced = ["wing_right", "strut_right"].contains(&table["name"].as_str().unwrap());
            all.push(component.clone());
            let Some(mirror) = mirror else { continue };
            if !is_braced {
                all.last_mut().unwrap().as_table_mut().unwrap().insert("mirror".to_owned(), mirror);
                continue;
            }
            let table = component.as_table_mut().unwrap();
            table.insert("name".to_owned(), mirror);
            for point in table["axis_m"].as_array_mut().unwrap() {
                let y = &mut point.as_array_mut().unwrap()[1];
                *y = y.as_float().map_or_else(|| (-y.as_integer().unwrap()).into(), |y| (-y).into());
            }
            all.push(component);
        }
        *components = all;
        toml::to_string(&document).unwrap()
    };
    let both = Aircraft::parse(&apart(&text, true), "apart.toml").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(both.joints.len(), 2);
    let families = |aircraft: &Aircraft| {
        let basis = ModalBasis::new(&Structure::new(aircraft).unwrap(), 6).unwrap();
        basis.modes.iter().map(|mode| mode.family).collect::<Vec<_>>()
    };
    assert!(!families(&both).contains(&ModeFamily::Unsymmetric));
    let one = apart(BRACED, true);
    let refused = Aircraft::parse(&one, "apart.toml").unwrap_err().to_string();
    assert!(
        refused.contains(
            "joint[1]: found the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5 without mirror image in y = 0, while symmetric = true"
        ),
        "{refused}"
    );
    let one = Aircraft::parse(&apart(BRACED, false), "apart.toml").unwrap();
    assert_eq!(one.joints.len(), 1);
    assert!(families(&one).iter().all(|family| *family == ModeFamily::Unsymmetric));
}

#[test]
fn a_model_with_joints_is_read_back_from_its_bytes() {
    let model = ReducedModel::new(&Aircraft::parse(BRACED, "braced.toml").unwrap(), 6).unwrap();
    let bytes = model.to_bytes();
    assert_eq!(ReducedModel::from_bytes(&bytes).unwrap(), model);
    assert_eq!(model.joints.len(), 2);
    let unjoined = ReducedModel { joints: Vec::new(), ..model.clone() };
    assert_ne!(model.content_hash(), unjoined.content_hash());
    let level = ReducedModel { fidelity: Fidelity::GeometricallyExact, ..model };
    let refused = ReducedModel::from_bytes(&level.to_bytes()).unwrap_err();
    assert_eq!(refused, StructureError::Bytes("it has joints, and a level that has none"));
}

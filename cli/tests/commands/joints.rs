//! Aircraft whose joints close loops, from the command line.

use std::path::Path;

use serde_json::Value;

use crate::support::{names, run, text, workspace};

/// A command on the strut-braced aircraft.
fn braced(folder: &Path, command: &str, options: &str) -> std::process::Output {
    let file = workspace("tests/data/strut-braced.toml");
    run(folder, &format!("{command} {} {options}", file.display()))
}

#[test]
fn a_joint_is_a_line_of_the_description() {
    let folder = tempfile::tempdir().unwrap();
    let found = braced(folder.path(), "describe --aircraft", "--json out.json --plot out.svg");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    let line = "the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5 is a pin";
    assert!(printed.lines().any(|other| other == line), "{printed}");
    let json: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("out.json")).unwrap()).unwrap();
    assert_eq!((json["joints"].as_array().unwrap().len(), json["joints"][0].as_str()), (2, Some(line)));
}

#[test]
fn the_geometrically_exact_level_is_refused_by_the_name_of_the_joint_wherever_it_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    for (command, options) in [
        ("trim", "--set model=geometrically_exact"),
        ("view", "--set model=geometrically_exact"),
        ("view", "--compare exact,geometrically_exact --duration 0.1"),
        ("simulate --aircraft", "--set model=geometrically_exact --duration 0.1 --output out.csv"),
        ("flutter", "--from 50 --to 60 --model geometrically_exact"),
        ("converge", "--from 50 --to 60 --model geometrically_exact"),
        ("linearise", "--set model=geometrically_exact"),
    ] {
        let refused = braced(folder.path(), command, options);
        let errors = text(&refused.stderr);
        assert_eq!(refused.status.code(), Some(1), "{command}: {errors}");
        assert!(
            errors.contains("model: found geometrically_exact") && errors.contains("closes a loop"),
            "{command}: {errors}"
        );
    }
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

#[test]
fn loops_are_seen_and_their_section_loads_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let seen = braced(
        folder.path(),
        "view --aircraft",
        "--modes 6 --trim --gltf out.glb --vtk vtk --output out.html",
    );
    assert!(seen.status.success(), "{}", text(&seen.stderr));
    let page = std::fs::read_to_string(folder.path().join("out.html")).unwrap();
    assert!(page.contains("section loads within loops that joints close are not known"));
    let loads =
        braced(folder.path(), "loads --aircraft", "--modes 4 --duration 0.05 --all-nodes --output loads");
    assert!(loads.status.success(), "{}", text(&loads.stderr));
    let nodes = std::fs::read_to_string(folder.path().join("loads/strut-braced-nodes.csv")).unwrap();
    assert!(
        nodes.contains("wing_right_04,")
            && !nodes.contains("wing_right_03,")
            && !nodes.contains("strut_right_")
    );
}

//! `flexair check`.

use std::fs;

use serde_json::Value;

use crate::support::{run, text, workspace};

#[test]
fn an_aircraft_of_which_nothing_is_unusual_ends_with_0() {
    let folder = tempfile::tempdir().unwrap();
    let jet = workspace("aircraft/generic-business-jet.toml");
    let checked = run(folder.path(), &format!("check {}", jet.display()));
    assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
    let described = run(folder.path(), &format!("describe {}", jet.display()));
    let verdict = format!("\n{}: no mistakes, and nothing is unusual\n", jet.display());
    assert_eq!(text(&checked.stdout), text(&described.stdout) + &verdict);
}

#[test]
fn what_is_unusual_is_said_and_ends_with_2() {
    let folder = tempfile::tempdir().unwrap();
    let jet = fs::read_to_string(workspace("aircraft/generic-business-jet.toml")).unwrap();
    fs::write(folder.path().join("slow.toml"), jet.replace("airspeed_m_s = 127", "airspeed_m_s = 20"))
        .unwrap();
    let checked = run(folder.path(), "check slow.toml --modes 4 --json slow.json");
    assert_eq!(checked.status.code(), Some(2), "{}", text(&checked.stderr));
    let printed = text(&checked.stdout);
    assert!(printed.contains("\nwarning: there is no trim: "), "{printed}");
    assert!(printed.ends_with("\nslow.toml: no mistakes, 1 warning\n"), "{printed}");
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("slow.json")).unwrap()).unwrap();
    assert_eq!(json["warnings"].as_array().unwrap().len(), 1);
}

#[test]
fn options_that_cannot_be_read_end_with_1_where_2_has_another_meaning() {
    let folder = tempfile::tempdir().unwrap();
    for line in ["check", "check light-single --sped 3", "import nastran stick.bdf --surface 1:3,chord=-1"] {
        let refused = run(folder.path(), line);
        assert_eq!((refused.status.code(), refused.stdout.len()), (Some(1), 0), "{line}");
    }
    assert_eq!(run(folder.path(), "describe light-single --sped 3").status.code(), Some(2));
}

#[test]
fn mistakes_are_all_shown_with_their_lines_and_end_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let jet = fs::read_to_string(workspace("aircraft/generic-business-jet.toml")).unwrap();
    let wrong =
        jet.replace("airspeed_m_s = 127", "airspeed_m_s = 1270").replacen("elements = ", "elments = ", 1);
    fs::write(folder.path().join("wrong.toml"), wrong).unwrap();
    let checked = run(folder.path(), "check wrong.toml --json wrong.json");
    assert_eq!((checked.status.code(), checked.stdout.len()), (Some(1), 0));
    let errors = text(&checked.stderr);
    for mistake in
        ["airspeed_m_s: found 1270", "found the unknown field \"elments\"", " --> wrong.toml:", "^^^"]
    {
        assert!(errors.contains(mistake), "{mistake}: {errors}");
    }
    assert!(!folder.path().join("wrong.json").exists());
}

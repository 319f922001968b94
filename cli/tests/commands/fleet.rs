//! What the command says of the aircraft that come with it.

use crate::support::{run, text, workspace};

/// Every whole aircraft that docs/fleet has a page of.
fn fleet() -> Vec<String> {
    let pages = std::fs::read_dir(workspace("docs/fleet")).unwrap().map(|entry| entry.unwrap().file_name());
    let pages = pages.filter_map(|name| name.into_string().ok()?.strip_suffix(".md").map(str::to_owned));
    let mut names: Vec<String> = pages.filter(|name| name != "README").collect();
    names.sort();
    names
}

#[test]
fn no_aircraft_of_the_fleet_has_anything_unusual() {
    let folder = tempfile::tempdir().unwrap();
    let fleet = fleet();
    assert!(fleet.len() >= 8, "{fleet:?}");
    for name in fleet {
        let described = run(folder.path(), &format!("describe {name} --modes 20"));
        let (said, warned) = (text(&described.stdout), text(&described.stderr));
        assert!(described.status.success(), "{name}: {warned}");
        assert!(!said.contains("warning:") && warned.is_empty(), "{name}: {said}{warned}");
        let trimmed = run(folder.path(), &format!("trim {name}"));
        let (said, warned) = (text(&trimmed.stdout), text(&trimmed.stderr));
        assert!(trimmed.status.success() && warned.is_empty(), "{name}: {said}{warned}");
    }
}

#[test]
fn the_aircraft_of_the_fleet_are_listed_by_their_names() {
    let folder = tempfile::tempdir().unwrap();
    let listed = text(&run(folder.path(), "aircraft").stdout);
    for name in fleet() {
        assert!(listed.lines().any(|line| line.starts_with(&format!("{name} "))), "{name}: {listed}");
    }
}

#[test]
fn a_file_here_that_is_called_like_one_of_them_is_remarked_and_meant_by_its_whole_name() {
    let folder = tempfile::tempdir().unwrap();
    let note = "note: sailplane is the aircraft that comes with flexair; the file here is sailplane.toml\n";
    assert_eq!(text(&run(folder.path(), "trim sailplane --modes 2").stderr), "");
    std::fs::copy(workspace("aircraft/light-single.toml"), folder.path().join("sailplane.toml")).unwrap();
    for (name, title, said) in
        [("sailplane", "Sailplane, 18 m", note), ("sailplane.toml", "Light single", "")]
    {
        let trimmed = run(folder.path(), &format!("trim {name} --modes 2"));
        assert!(text(&trimmed.stdout).starts_with(title), "{name}: {}", text(&trimmed.stdout));
        assert_eq!(text(&trimmed.stderr), said, "{name}");
    }
}

#[test]
fn each_aircraft_of_the_fleet_has_a_small_picture() {
    for name in fleet() {
        let picture = std::fs::read(workspace(&format!("docs/fleet/{name}.webp"))).unwrap();
        assert!(picture.starts_with(b"RIFF") && picture.len() < 60_000, "{name}: {} bytes", picture.len());
    }
}

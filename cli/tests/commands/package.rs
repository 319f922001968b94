//! What `flexair package` says.

use crate::support::{flexair, library, run, text, workspace};

/// Before it finds that there is no such library.
#[test]
fn the_level_at_which_the_file_flies_is_said_beside_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let shipped = std::fs::read_to_string(workspace("tests/data/small-aircraft.toml")).unwrap();
    let own = "model = \"exact\"\n";
    assert!(shipped.contains(own));
    let platform = library().split('=').next().unwrap().to_owned();
    let package = format!("package --aircraft small.toml --modes 2 --binary {platform}=none --output a.fmu");
    let inconsistent = "model = \"inconsistent\"\n";
    for (written, set, level) in [
        (own, "", "exact"),
        (inconsistent, "", "inconsistent"),
        ("", "", "geometrically_exact"),
        (own, "--set model=rigid", "rigid"),
    ] {
        std::fs::write(folder.path().join("small.toml"), shipped.replace(own, written)).unwrap();
        let said = text(&run(folder.path(), &format!("{package} {set}")).stderr);
        let expected = format!("Packaging Small aircraft (small.toml), which flies with model = {level}\n");
        assert!(said.starts_with(&expected), "{said}");
    }
}

/// No cargo is found that could build it.
#[test]
fn options_are_checked_before_the_library_is_built() {
    let folder = tempfile::tempdir().unwrap();
    for (options, reason) in [
        ("--set gust.shap=none", "--set gust.shap=none: there is no parameter `gust.shap`"),
        ("--set elevator=1", "--set elevator=1: `elevator` is an input and no parameter"),
        ("--stations-along wing=20", "stations along wing: found component \"wing\", allowed are "),
        (
            "--stations-along wing_right=20 --stations-along wing_right=20",
            "stations along wing_right: found the name \"wing_right_01\" of a station that there is",
        ),
        ("", "cannot build the shared library: cargo does not start"),
    ] {
        let mut package = flexair(folder.path(), &format!("package --modes 2 {options} --output a.fmu"));
        let said = text(&package.env("CARGO", "no-cargo").output().unwrap().stderr);
        assert!(said.contains(reason), "{options}: {said}");
        assert_eq!(said.contains("Building the shared library"), options.is_empty(), "{options}: {said}");
    }
}

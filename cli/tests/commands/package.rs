//! What `flexair package` says.

use crate::support::{library, run, text, workspace};

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
    for (written, level) in [(own, "exact"), (inconsistent, "inconsistent"), ("", "geometrically_exact")] {
        std::fs::write(folder.path().join("small.toml"), shipped.replace(own, written)).unwrap();
        let said = text(&run(folder.path(), &package).stderr);
        let expected = format!("Packaging Small aircraft (small.toml), which flies with model = {level}\n");
        assert!(said.starts_with(&expected), "{said}");
    }
}

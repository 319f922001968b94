//! What cannot succeed says so before the work, and not after it.

use std::path::Path;

use crate::support::{library, names, run, text, workspace};

/// A folder with the small aircraft, its FMU, and a file where a folder would have to be.
fn small_aircraft() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(workspace("tests/data/small-aircraft.toml"), folder.path().join("small.toml")).unwrap();
    let package =
        format!("package --no-check --aircraft small.toml --modes 2 --binary {} --output a.fmu", library());
    let packaged = run(folder.path(), &package);
    assert!(packaged.status.success(), "{}", text(&packaged.stderr));
    std::fs::write(folder.path().join("file"), "").unwrap();
    folder
}

/// The complaint of a command that fails and leaves the folder as it was.
fn complaint(folder: &Path, line: &str) -> String {
    let before = names(folder);
    let failed = run(folder, line);
    assert_eq!((failed.status.code(), text(&failed.stdout).as_str()), (Some(1), ""), "{line}");
    assert_eq!(names(folder), before, "{line}");
    text(&failed.stderr)
}

/// The report is printed, the flights are announced and the missing station is found by the work.
#[test]
fn what_cannot_be_written_is_found_before_the_work() {
    let folder = small_aircraft();
    let package = format!("package --no-check --modes 26 --binary {} --output jet.fmu", library());
    assert!(run(folder.path(), &package).status.success());
    for line in [
        "flutter --from 120 --to 130 --points 2 --modes 2 --output file/new",
        "reproduce --aircraft small.toml --output file/new",
        "gust small.toml --modes 2 --output file/new",
        "loads --aircraft small.toml --modes 2 --all-nodes --output file/new",
        "simulate --modes 2 --duration 0.1 --output new/flight.csv --plot file/new/flight.svg",
        "linearise small.toml --modes 2 --output file/new",
        "describe small.toml --modes 2 --json file/new/a.json --plot new/a.svg",
        "check small.toml --modes 2 --json file/new/a.json",
        "new file/new/wing.toml --kind wing-on-wall",
        "bench --fmu jet.fmu --output new/a.md --plot file/new/a.svg",
    ] {
        let errors = complaint(folder.path(), line);
        assert!(errors.starts_with("error: cannot write file/new/"), "{line}: {errors}");
    }
    let errors = complaint(folder.path(), "reproduce --aircraft small.toml --output new");
    assert!(errors.contains("is missing, whose deflection"), "{errors}");
}

#[test]
fn bench_says_what_it_needs_before_it_flies() {
    let folder = small_aircraft();
    let text_of = std::fs::read_to_string(folder.path().join("small.toml")).unwrap();
    let station = text_of.find("[[station]]").unwrap();
    let after = station + text_of[station..].find("\n\n").unwrap();
    let unwatched = [&text_of[..station], &text_of[after..]].concat();
    std::fs::write(folder.path().join("unwatched.toml"), unwatched).unwrap();
    let lopsided =
        text_of.replace("symmetric = true\n", "").replace("direction = [1, 0, 0]", "direction = [1, 0.1, 0]");
    std::fs::write(folder.path().join("lopsided.toml"), lopsided).unwrap();
    std::fs::copy(workspace("aircraft/goland-wing.toml"), folder.path().join("wing.toml")).unwrap();
    for (aircraft, expected) in [
        (
            "unwatched.toml",
            "error: a.fmu: the FMU has no variable `deflection.wing_tip_right.up`; the standard flight needs the \
             aircraft's control for pitch and a station\n",
        ),
        (
            "lopsided.toml",
            "error: Small aircraft has no mirror plane y = 0: the benchmark times half of an aircraft against the \
             whole\n",
        ),
        (
            "wing.toml",
            "error: Goland wing is clamped in a wind tunnel: the standard flight needs support = \"free\"\n",
        ),
    ] {
        assert_eq!(complaint(folder.path(), &format!("bench --fmu a.fmu --aircraft {aircraft}")), expected);
    }
    let help = text(&run(folder.path(), "bench --help").stdout);
    assert!(help.contains("a station (wing_tip_right, if there is one), and a mirror plane y = 0"), "{help}");
}

//! `| head -1` behind any command: nobody reads what it says, and it does its work all the same.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::import::STICK;
use crate::support::{flexair, library, run, text, workspace};

/// A line for each command that prints something, and a file that it then has written.
fn lines() -> Vec<(&'static str, String, Option<&'static str>)> {
    let package = format!("package --modes 4 --binary {} --output a.fmu", library());
    vec![
        ("package", package, Some("a.fmu")),
        ("merge", "merge a.fmu a.fmu --output merged.fmu".into(), Some("merged.fmu")),
        ("reproduce", "reproduce --output page".into(), Some("page/index.html")),
        ("simulate", "simulate inputs.csv --step 0.01".into(), None),
        ("flutter", "flutter --from 100 --to 130 --points 2 --modes 2 --output plots".into(), Some("plots")),
        (
            "converge",
            "converge --modes 2,3 --from 100 --to 130 --points 2 --output converged".into(),
            Some("converged"),
        ),
        ("trim", "trim --modes 2 --csv trims.csv".into(), Some("trims.csv")),
        ("describe", "describe --modes 2 --json about.json".into(), Some("about.json")),
        (
            "check",
            format!("check {} --modes 2", workspace("aircraft/generic-business-jet.toml").display()),
            None,
        ),
        (
            "linearise",
            "linearise --modes 2 --inflow steady --output linear".into(),
            Some("linear/generic-business-jet-linear.json"),
        ),
        ("loads", "loads --modes 2 --duration 0.1 --output carried".into(), Some("carried")),
        (
            "gust",
            "gust --modes 2 --gradients 20:30:2 --duration 1.1 --step 0.05 --output gusts".into(),
            Some("gusts"),
        ),
        ("ssp", "ssp a.fmu --output a.ssp --set aircraft.model=rigid".into(), Some("a.ssp")),
        ("sweep", "sweep sweep.toml --output swept".into(), Some("swept/manifest.json")),
        ("view", "view --modes 2 --trim --output page.html".into(), Some("page.html")),
        ("new", "new wing.toml --kind wing-on-wall".into(), Some("wing.toml")),
        ("import", "import nastran stick.bdf".into(), Some("stick.toml")),
        ("schema", "schema --output aircraft.schema.json".into(), Some("aircraft.schema.json")),
        ("aircraft", "aircraft".into(), None),
        ("completions", "completions bash".into(), None),
        ("help", "help".into(), None),
    ]
}

/// Runs a command whose standard output, and standard error if wanted, nobody reads.
fn unread(mut command: Command, errors_too: bool) -> Output {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    command.stdout(writer.try_clone().unwrap());
    if errors_too {
        command.stderr(writer);
    } else {
        command.stderr(Stdio::piped());
    }
    command.spawn().unwrap().wait_with_output().unwrap()
}

fn commands_in_the_help(folder: &Path) -> Vec<String> {
    let help = text(&run(folder, "--help").stdout);
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let commands = commands.take_while(|line| !line.is_empty());
    // The name of a command stands two columns in, its description further right or below.
    let names = commands.filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')));
    names.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

#[test]
fn every_command_does_its_work_when_nobody_reads_what_it_says() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n2\n").unwrap();
    let sweep = "[set]\nmodel = \"rigid\"\n[run]\nkind = \"trim\"\n[[vary]]\nname = \"airspeed\"\nvalues = [120.0, 130.0]\n[[keep]]\noutput = \"trim.pitch\"\n";
    std::fs::write(folder.path().join("sweep.toml"), sweep).unwrap();
    std::fs::write(folder.path().join("stick.bdf"), STICK).unwrap();
    let lines = lines();
    let mut tested: Vec<&str> = lines.iter().map(|(command, ..)| *command).chain(["bench"]).collect();
    let mut known = commands_in_the_help(folder.path());
    tested.sort_unstable();
    known.sort_unstable();
    assert_eq!(tested, known, "each command is tested");
    for (name, line, written) in &lines {
        check_unread(folder.path(), name, line, *written);
    }
}

#[test]
fn a_flight_is_drawn_to_its_end_when_nobody_reads_its_rows() {
    let folder = tempfile::tempdir().unwrap();
    let line = "simulate --modes 2 --input elevator=step:0.01@0.1 --duration 0.5 --plot flight.svg";
    check_unread(folder.path(), "simulate", line, Some("flight.svg"));
    let drawn = std::fs::read_to_string(folder.path().join("flight.svg")).unwrap();
    assert!(drawn.contains("attitude.pitch") && !drawn.contains(">ended<"));
}

/// Apart from the others, because it takes long.
#[test]
#[ignore = "a minute: SLOW=1 bash tests/run.sh runs it"]
fn bench_does_its_work_when_nobody_reads_what_it_says() {
    let folder = tempfile::tempdir().unwrap();
    let package = format!("package --modes 4 --no-check --binary {} --output a.fmu", library());
    check_unread(folder.path(), "package", &package, Some("a.fmu"));
    let bench = "bench --fmu a.fmu --output bench.md --plot bench.svg";
    check_unread(folder.path(), "bench", bench, Some("bench.md"));
}

#[track_caller]
fn check_unread(folder: &Path, name: &str, line: &str, written: Option<&str>) {
    let output = unread(flexair(folder, line), false);
    let errors = text(&output.stderr);
    assert!(output.status.success() && !errors.contains("panicked"), "{name}: {errors}");
    assert!(written.is_none_or(|written| folder.join(written).exists()), "{name} wrote nothing");
}

/// A panic would end the program with 101.
#[test]
fn nothing_panics_when_errors_cannot_be_told_either() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
    let lines = [
        ("simulate inputs.csv", 0),
        ("simulate missing.csv", 1),
        ("simulate inputs.csv --set flap=1", 1),
        ("package --aircraft missing.toml", 1),
        ("merge missing.fmu missing.fmu", 1),
        ("ssp missing.fmu --output a.ssp", 1),
        ("bench --fmu missing.fmu", 1),
        ("reproduce --aircraft missing.toml", 1),
        ("flutter missing.toml --from 1 --to 2", 1),
        ("converge missing.toml", 1),
        ("gust missing.toml", 1),
        ("gust --direction none", 2),
        ("loads --aircraft missing.toml", 1),
        ("loads missing.csv", 1),
        ("new a.toml", 1),
        ("completions none", 2),
        ("--help", 0),
        ("", 2),
    ];
    for (line, expected) in lines {
        let output = unread(flexair(folder.path(), line), true);
        assert_eq!(output.status.code(), Some(expected), "{line}");
    }
}

/// Standard output on a full disk is an error, other than a reader who had enough.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time\n0\n").unwrap();
    for (line, place) in [
        ("simulate inputs.csv", "standard output"),
        ("completions bash", "standard output"),
        ("simulate inputs.csv --output /dev/full", "/dev/full"),
    ] {
        let mut command = flexair(folder.path(), line);
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = command.stdout(full).stderr(Stdio::piped()).output().unwrap();
        let errors = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{errors}");
        let expected = format!("cannot write to {place}: No space left on device");
        assert!(errors.contains(&expected), "{errors}");
    }
}

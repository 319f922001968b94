//! `flexair simulate` from outside.

use std::io::Write;
use std::process::Stdio;

use crate::support::{flexair, names, run, text};

/// Standard output of a flight whose inputs come through standard input, and what is said beside.
fn fly(inputs: &str, options: &str) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = flexair(folder.path(), &format!("simulate - --modes 4 {options}"));
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut flying = command.spawn().unwrap();
    flying.stdin.take().unwrap().write_all(inputs.as_bytes()).unwrap();
    let output = flying.wait_with_output().unwrap();
    (text(&output.stdout), text(&output.stderr))
}

#[test]
fn a_minus_is_standard_input_and_output_and_a_step_gives_rows_in_between() {
    let (rows, errors) = fly("time,elevator\n0,0\n0.05,0\n", "--step 0.01 --output -");
    assert_eq!((rows.lines().count(), errors.as_str()), (7, ""));
    let times: Vec<&str> = rows.lines().skip(1).map(|row| row.split(',').next().unwrap()).collect();
    assert_eq!(times, ["0", "0.01", "0.02", "0.03", "0.04", "0.05"]);
    // Plain numbers: the altitude of the jet's own flight condition.
    let column = rows.lines().next().unwrap().split(',').position(|name| name == "position.down").unwrap();
    assert_eq!(rows.lines().nth(1).unwrap().split(',').nth(column), Some("-7620"));
}

#[test]
fn an_input_by_its_shape_flies_the_bits_of_the_same_table() {
    let folder = tempfile::tempdir().unwrap();
    let table = "time,elevator\n0,0\n1,0.05\n2.4,-0.05\n4.5,0.05\n5.2,-0.05\n5.9,0\n7,0\n";
    std::fs::write(folder.path().join("inputs.csv"), table).unwrap();
    let by_table = run(folder.path(), "simulate inputs.csv --modes 4 --step 0.01");
    let by_shape = run(folder.path(), "simulate --modes 4 --input elevator=2311:0.05 --duration 7");
    assert!(by_shape.status.success(), "{}", text(&by_shape.stderr));
    assert_eq!((text(&by_shape.stderr).as_str(), text(&by_shape.stdout).lines().count()), ("", 702));
    assert!(by_table.stdout == by_shape.stdout);
    // Beside a table that has no column for it.
    std::fs::write(folder.path().join("time.csv"), "time\n0\n7\n").unwrap();
    let beside = run(folder.path(), "simulate time.csv --modes 4 --input elevator=2311:0.05 --step 0.01");
    assert!(by_table.stdout == beside.stdout);
}

#[test]
fn an_edge_between_two_steps_has_a_row_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let line = "simulate --modes 2 --duration 0.05 --input elevator=pulse:0.01@0.0123:0.02";
    let rows = text(&run(folder.path(), line).stdout);
    let times: Vec<&str> = rows.lines().skip(1).map(|row| row.split(',').next().unwrap()).collect();
    assert_eq!(times, ["0", "0.01", "0.0123", "0.02", "0.03", "0.0323", "0.04", "0.05"]);
}

#[test]
fn inputs_that_cannot_be_flown_are_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inputs.csv"), "time,elevator\n0,0\n5,0\n").unwrap();
    for (options, expected) in [
        (
            "--input elevatr=2311:0.05",
            "--input elevatr=2311:0.05: found `elevatr`, allowed is an input, did you mean `elevator`?",
        ),
        (
            "--input elevator=0.05",
            "'elevator=0.05' for '--input <NAME=SHAPE>': found `0.05` without an amplitude",
        ),
        (
            "--input elevator=step:5",
            "found an amplitude of 5, allowed is -1.6 to 1.6 rad: inputs are rad; 5 looks like degrees",
        ),
        ("inputs.csv --input elevator=step:0.1", "--input elevator=step:0.1: found `elevator` twice"),
        (
            "inputs.csv --input rudder=step:0.1@5",
            "found a start at 5 s, allowed is before the end of the flight, at 5 s",
        ),
        (
            "--input elevator=sweep:0.01 --step 0.1",
            "found 5 Hz, allowed are at most 2.5 Hz with a --step of 0.1 s",
        ),
        ("inputs.csv --duration 3", "cannot be used with"),
        ("--duration 1e9", "found a step of 0.01 s between rows, which makes 100000000002 rows"),
        ("--plot-names load_factor", "--plot <FILE>"),
        ("--plot flight.svg --plot-names load_factors", "--plot-names load_factors: there is no such output"),
    ] {
        let failed = run(folder.path(), &format!("simulate {options}"));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(expected), "{options}: {errors}");
        assert_eq!(
            (text(&failed.stdout).as_str(), names(folder.path())),
            ("", vec!["inputs.csv".to_owned()])
        );
    }
}

#[test]
fn a_shape_that_outlasts_the_flight_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let line = "simulate --modes 2 --duration 2 --input elevator=sweep:0.001";
    let errors = text(&run(folder.path(), line).stderr);
    let expected = "warning: --input elevator=sweep:0.001: it lasts until 21 s, the flight ends at 2 s\n";
    assert!(errors.contains(expected), "{errors}");
}

#[test]
fn a_flight_is_drawn_with_its_inputs_and_units() {
    let folder = tempfile::tempdir().unwrap();
    let inputs = "--input elevator=step:0.01@0.05 --input wind_down=step:-1@0.1 --duration 0.2";
    let line = format!("simulate --modes 2 {inputs} --output flight.csv --plot flight.svg");
    let drawn = |line: &str| {
        let flown = run(folder.path(), line);
        assert!(flown.status.success(), "{}", text(&flown.stderr));
        std::fs::read_to_string(folder.path().join("flight.svg")).unwrap()
    };
    let usual = drawn(&line);
    for expected in [
        "127 m/s, 7620 m, model = ",
        "attitude.pitch",
        "attitude (rad)",
        "load_factor (1)",
        ">deflection.wing_tip_right.up<",
        "deflection (m)",
        "input (rad)",
        "input (m/s)",
        "time (s)",
        "max-width:100%",
    ] {
        assert!(usual.contains(expected), "{expected} is missing");
    }
    let chosen = drawn(&format!("{line} --plot-names load_factor"));
    assert!(chosen.contains(">load_factor.x<") && !chosen.contains("attitude.pitch"));
}

#[test]
fn one_row_is_the_trim_and_says_that_nothing_is_flown() {
    let (rows, errors) = fly("time\n2\n", "");
    assert_eq!(rows.lines().count(), 2);
    assert_eq!(
        errors,
        "note: standard input has one row: nothing is flown, the row written is the trim at 2 s\n"
    );
}

#[test]
fn absurd_sizes_are_refused() {
    let (rows, errors) = fly("time\n0\n1000\n", "--step 1e-9");
    assert_eq!(rows, "");
    let expected = "found a step of 0.000000001 s between rows, which makes 1000000000002 rows, allowed are 10000000 at most";
    assert!(errors.contains(expected), "{errors}");
    for step in ["0", "-1", "NaN", "inf"] {
        let (_, errors) = fly("time\n0\n1\n", &format!("--step {step}"));
        assert!(errors.contains("allowed is a number of seconds, greater than 0"), "{errors}");
    }
    let folder = tempfile::tempdir().unwrap();
    let errors = text(&run(folder.path(), "simulate /dev/zero").stderr);
    assert!(cfg!(not(unix)) || errors.contains("which no table of inputs has"), "{errors}");
    let errors = text(&run(folder.path(), "simulate /dev/null --modes 100000").stderr);
    assert!(errors.contains("100000 modes were asked for"), "{errors}");
}

#[test]
fn completions_are_there_for_every_shell() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = text(&run(folder.path(), &format!("completions {shell}")).stdout);
        assert!(script.contains("simulate") && script.contains("mode-family"), "{shell}");
    }
}

//! `flexair simulate` from outside.

use std::io::Write;
use std::process::Stdio;

use crate::support::{flexair, run, text};

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

//! `flexair trim`.

use crate::support::{run, text, workspace};

#[test]
fn a_table_of_turns_has_a_row_for_every_point_and_says_why_one_failed() {
    let folder = tempfile::tempdir().unwrap();
    let line = "trim --turn --load-factor 1.2,3 --speed 127,150 --set actuator.elevator.minimum=-0.45 \
                --csv out/turns.csv --json out/turns.json";
    let found = run(folder.path(), line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    assert!(printed.contains("turn, ") && printed.contains("turn_rate (rad/s)"), "{printed}");
    let csv = std::fs::read_to_string(folder.path().join("out/turns.csv")).unwrap();
    let rows: Vec<&str> = csv.lines().collect();
    assert!(
        rows[0].starts_with("airspeed,altitude,condition.load_factor,pitch,alpha,roll,beta,"),
        "{}",
        rows[0]
    );
    assert_eq!(rows.len(), 5);
    assert!(rows[1].starts_with("127,7620,1.2,") && rows[1].contains(",ok,"), "{}", rows[1]);
    let json = std::fs::read_to_string(folder.path().join("out/turns.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let trims = json["trims"].as_array().unwrap();
    assert_eq!((trims.len(), json["units"]["turn_rate"].as_str()), (4, Some("rad/s")));
    for (trim, status) in trims.iter().zip(["ok", "ok", "beyond_limits", "beyond_limits"]) {
        assert_eq!(trim["status"].as_str(), Some(status), "{trim}");
        if status == "ok" {
            assert!((trim["load_factor"].as_f64().unwrap() - 1.2).abs() < 1e-6, "{trim}");
        } else {
            assert!(trim["message"].as_str().unwrap().starts_with("elevator would need -"), "{trim}");
            assert!(trim["pitch"].is_null(), "{trim}");
        }
    }
}

#[test]
fn a_trim_beyond_a_limit_is_none_and_says_what_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let limited = "trim --set actuator.elevator.minimum=-0.2";
    let found = run(folder.path(), limited);
    assert!(!found.status.success());
    // The prototype's numbers: −0.2479 rad would be needed, −0.02363 rad/s² remain.
    let printed = text(&found.stdout);
    for said in [
        "elevator would need -0.2479 rad, its limit is -0.2000 rad",
        "-0.02363 rad/s² that elevator would balance",
    ] {
        assert!(printed.contains(said), "{said}: {printed}");
    }
    assert!(text(&found.stderr).contains("no point could be trimmed"));
}

#[test]
fn a_table_goes_to_standard_output_alone_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let found = run(folder.path(), "trim --modes 2 --csv -");
    assert!(found.status.success(), "{}", text(&found.stderr));
    assert!(text(&found.stdout).starts_with("airspeed,altitude,"), "{}", text(&found.stdout));
    assert!(crate::support::names(folder.path()).is_empty());
}

#[test]
fn what_does_not_go_together_is_refused_by_the_options_names() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/goland-wing.toml");
    let clamped = format!("{} --climb-angle 3", wing.display());
    for (options, reason) in [
        (
            "--turn",
            "condition.bank_angle, which --bank-angle gives in degrees: found 0, allowed is an angle other than 0",
        ),
        ("--turn --load-factor 1.2,0", "--load-factor: found 0, allowed is another number"),
        ("--pull-up --load-factor 1.2 --bank-angle 5", "allowed is 0 (rad) in a pull-up, which finds it"),
        ("--load-factor 1.5", "--load-factor: found without --turn or --pull-up"),
        (
            "--turn --load-factor 0.9",
            "--load-factor: found 0.9, allowed is below -1.0000 (to the left) or above 1.0000",
        ),
        ("--failed-engine middle", "--failed-engine: found middle, allowed is left, right"),
        ("--speed 5000", "--speed: found 5000, allowed is 1 to 400 (m/s)"),
        ("--speed 1:2", "allowed is a number, a list N,N,… or FROM:TO:COUNT"),
        ("--climb-angle 90", "allowed are -84 to 84 degrees"),
        (clamped.as_str(), "a clamped aircraft stands as its mount does"),
    ] {
        let refused = run(folder.path(), &format!("trim {options}"));
        assert!(!refused.status.success(), "{options}");
        let said = text(&refused.stderr);
        assert!(said.contains(reason), "{options}: {said}");
    }
}

#[test]
fn straight_symmetric_flights_have_a_static_margin_and_others_none() {
    let folder = tempfile::tempdir().unwrap();
    let margins = |options: &str| -> Vec<Option<f64>> {
        let found = run(folder.path(), &format!("trim --json - {options}"));
        assert!(found.status.success(), "{}", text(&found.stderr));
        let json: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
        assert_eq!(json["units"]["static_margin"].as_str(), Some("1"));
        json["trims"].as_array().unwrap().iter().map(|trim| trim["static_margin"].as_f64()).collect()
    };
    // As `describe` has it.
    let level = margins("--speed 127");
    assert!((level[0].unwrap() - 0.10295).abs() < 5e-6, "{level:?}");
    assert!(margins("--climb-angle 5")[0].is_some());
    assert_eq!(margins("--turn --bank-angle 20"), [None]);
    assert_eq!(margins("--pull-up --load-factor 1.2"), [None]);
}

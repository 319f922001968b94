//! `flexair describe`.

use serde_json::Value;

use crate::support::{names, run, text, workspace};

#[test]
fn the_jet_is_described_with_its_static_margin_and_modes() {
    let folder = tempfile::tempdir().unwrap();
    let found = run(folder.path(), "describe --json out/jet.json --plot out/jet.svg");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    for said in [
        "Generic business jet",
        "reference chord 3.73073 m, area 87.1975 m², span 24.86 m, of wing_right and wing_left",
        "level flight, 127 m/s, 7620 m",
        // In steady flow [theory: linearisation.static-margin]: `static_margin.rs` of the verification has it against closed forms, and alike
        // for 0, 2, 5, 8 inflow states; below it is 0.10295.
        "static margin 0.1029 of the chord",
        "wing bending, first, symmetric",
    ] {
        assert!(printed.contains(said), "{said}: {printed}");
    }
    assert!(!printed.contains("warning:"), "{printed}");
    assert_eq!(names(&folder.path().join("out")), ["jet.json", "jet.svg"]);
    let json = std::fs::read_to_string(folder.path().join("out/jet.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    let margin = json["stability"]["static_margin"].as_f64().unwrap();
    assert!((margin - 0.10295).abs() < 5e-6, "{margin}");
    let number = |path: &str| json.pointer(path).and_then(Value::as_f64).unwrap();
    let lever = number("/stability/centre_of_mass/0") - number("/stability/neutral_point");
    assert!((lever - margin * number("/reference/chord")).abs() < 1e-9);
    // Parallel axes.
    let (mass, x, z) = (number("/mass"), number("/centre_of_mass/0"), number("/centre_of_mass/2"));
    let [centre, origin] =
        ["centre_of_mass", "origin"].map(|about| number(&format!("/inertia/about_{about}/1/1")));
    assert!((centre + mass * (x * x + z * z) - origin).abs() < 1e-6 * origin);
    let modes = json["modes"].as_array().unwrap();
    assert_eq!((modes.len(), json["warnings"].as_array().unwrap().len()), (12, 0));
    let svg = std::fs::read_to_string(folder.path().join("out/jet.svg")).unwrap();
    assert_eq!(svg.matches(">from above<").count(), 12);
}

#[test]
fn frequencies_and_margin_are_those_of_the_stiffness_that_is_set() {
    let folder = tempfile::tempdir().unwrap();
    let json = |options: &str| -> Value {
        let found = run(folder.path(), &format!("describe --modes 12 --json - {options}"));
        assert!(found.status.success(), "{}", text(&found.stderr));
        serde_json::from_slice(&found.stdout).unwrap()
    };
    let [nominal, tenth, without_wake] =
        ["", "--set stiffness_scale=0.1", "--set stiffness_scale=0.1 --set inflow_states=0"].map(json);
    let [margin, other] =
        [&tenth, &without_wake].map(|json| json["stability"]["static_margin"].as_f64().unwrap());
    // In steady flow [theory: linearisation.static-margin], by the verification's `static_margin.rs`; wakes have nothing to do with it.
    assert!((margin - 0.11710).abs() < 5e-6 && (margin - other).abs() < 1e-6, "{margin} {other}");
    let [one, other] = [&nominal, &tenth].map(|json| json["modes"][0]["frequency"].as_f64().unwrap());
    assert!((one / other - 10_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn what_has_no_static_margin_is_described_all_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/goland-wing.toml");
    for (options, reason) in [
        (format!("{} --modes 2", wing.display()), "no static margin: the aircraft is clamped"),
        ("--modes 2 --set airspeed=20".to_owned(), "no static margin: there is no trim"),
        (
            "--modes 2 --set condition.manoeuvre=pull_up --set condition.load_factor=1.5".to_owned(),
            "no static margin: the path bends, and",
        ),
    ] {
        let found = run(folder.path(), &format!("describe {options}"));
        assert!(found.status.success(), "{options}: {}", text(&found.stderr));
        let printed = text(&found.stdout);
        assert!(printed.contains(reason) && printed.contains("bending, first"), "{options}: {printed}");
    }
}

#[test]
fn a_warning_says_what_is_unusual_and_is_no_failure() {
    let folder = tempfile::tempdir().unwrap();
    let jet = std::fs::read_to_string(workspace("aircraft/generic-business-jet.toml")).unwrap();
    let odd = jet.replacen("symmetric = true", "symmetric = true\n[reference]\nchord_m = 0.37", 1);
    std::fs::write(folder.path().join("odd.toml"), odd).unwrap();
    let found = run(folder.path(), "describe --aircraft odd.toml");
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    for warning in [
        "warning: the static margin is 1.038",
        "warning: [reference] chord_m is 0.37, the wing has 3.73073: usual is about that",
    ] {
        assert!(printed.contains(warning), "{warning}: {printed}");
    }
}

#[test]
fn an_aircraft_is_named_once_and_nothing_is_drawn_of_no_modes() {
    let folder = tempfile::tempdir().unwrap();
    for (options, reason) in [
        ("one.toml --aircraft other.toml", "cannot be used with"),
        ("--modes 0 --plot modes.svg", "--plot: found nothing to draw"),
        ("missing.toml", "missing.toml"),
        ("--set airspeeed=3", "did you mean `airspeed`?"),
    ] {
        let found = run(folder.path(), &format!("describe {options}"));
        assert!(!found.status.success(), "{options}");
        assert!(text(&found.stderr).contains(reason), "{options}: {}", text(&found.stderr));
    }
    assert!(names(folder.path()).is_empty());
}

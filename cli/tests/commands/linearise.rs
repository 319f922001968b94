//! `flexair linearise`.

use std::path::Path;

use serde_json::Value;

use crate::support::{names, run, text, workspace};

const FILES: [&str; 13] =
    ["A", "B", "Bd", "C", "D", "Dd", "linear.json", "linear.mat", "linear.npz", "modes", "u", "x", "y"];

/// All formats of a small model of the jet.
fn linearise(folder: &Path, output: &str) -> String {
    let line =
        format!("linearise --modes 2 --set inflow_states=1 --format json,csv,npz,mat,json --output {output}");
    let found = run(folder, &line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    text(&found.stdout)
}

fn file(name: &str) -> String {
    let ending = if name.contains('.') { "" } else { ".csv" };
    format!("generic-business-jet-{name}{ending}")
}

#[test]
fn shapes_agree_and_labels_are_words_that_stand_once() {
    let folder = tempfile::tempdir().unwrap();
    let printed = linearise(folder.path(), "out");
    assert!(printed.contains("level flight, 127 m/s, 7620 m") && printed.contains(" to half"), "{printed}");
    assert_eq!(names(&folder.path().join("out")), FILES.map(file));
    let json = std::fs::read_to_string(folder.path().join("out").join(file("linear.json"))).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    let length = |key: &str| json[key].as_array().unwrap().len();
    let [n, m, p] = ["x0", "u0", "y0"].map(length);
    for (prefix, count) in [("x", n), ("u", m), ("y", p)] {
        for list in ["names", "units", "labels"] {
            assert_eq!(length(&format!("{prefix}_{list}")), count);
        }
    }
    for (key, rows, columns) in
        [("A", n, n), ("B", n, m), ("C", p, n), ("D", p, m), ("Bd", n, m), ("Dd", p, m)]
    {
        let matrix = json[key].as_array().unwrap();
        assert_eq!(matrix.len(), rows, "{key}");
        assert!(matrix.iter().all(|row| row.as_array().unwrap().len() == columns), "{key}");
        assert!(matrix.iter().all(|row| row.as_array().unwrap().iter().all(Value::is_f64)), "{key}");
    }
    let texts = |key: &str| -> Vec<String> {
        json[key].as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
    };
    let mut signals = [texts("u_labels"), texts("y_labels")].concat();
    assert!(signals.contains(&"wind_down".to_owned()) && signals.contains(&"wind_down_out".to_owned()));
    let is_word =
        |label: &String| label.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    assert!(signals.iter().chain(&texts("x_labels")).all(is_word));
    signals.sort();
    signals.dedup();
    assert_eq!(signals.len(), m + p);
    assert_eq!(texts("x_names")[..3], ["position.down", "attitude.roll", "attitude.pitch"]);
}

#[test]
fn tables_have_the_names_of_rows_and_columns_and_the_numbers_of_the_other_files() {
    let folder = tempfile::tempdir().unwrap();
    linearise(folder.path(), "out");
    let bytes = |name: &str| std::fs::read(folder.path().join("out").join(file(name))).unwrap();
    let table = text(&bytes("B"));
    let head = table.lines().next().unwrap();
    assert!(
        head.starts_with(",elevator,aileron,") && head.ends_with(",wind_north,wind_east,wind_down"),
        "{head}"
    );
    let row = table.lines().find(|line| line.starts_with("rate.y,")).unwrap();
    let elevator = row.split(',').nth(1).unwrap();
    let json: Value = serde_json::from_slice(&bytes("linear.json")).unwrap();
    let of_json = json["B"][7][0].as_f64().unwrap();
    assert_eq!((json["x_names"][7].as_str(), elevator.parse().ok()), (Some("rate.y"), Some(of_json)));
    let holds = |name: &str| bytes(name).windows(8).any(|part| *part == of_json.to_le_bytes());
    assert!(holds("linear.npz") && holds("linear.mat"));
    assert!(text(&bytes("A")).contains(",\"inflow[1,1]\","));
    assert!(text(&bytes("y")).starts_with("name,label,unit,value\n"));
    assert!(text(&bytes("x")).contains("\nrate.y,rate_y,rad/s,"));
}

#[test]
fn two_runs_write_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    for output in ["one", "other"] {
        linearise(folder.path(), output);
    }
    for name in FILES.map(file) {
        let [one, other] =
            ["one", "other"].map(|of| std::fs::read(folder.path().join(of).join(&name)).unwrap());
        assert!(one == other, "{name}");
    }
}

#[test]
fn a_turn_is_linearised_and_what_cannot_be_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let turn =
        "linearize --modes 2 --inflow steady --set condition.manoeuvre=turn --set condition.bank_angle=0.5";
    let found = run(folder.path(), turn);
    assert!(found.status.success(), "{}", text(&found.stderr));
    assert!(text(&found.stdout).contains("turn, 127 m/s, 7620 m"));
    assert!(folder.path().join("target/linear").join(file("linear.json")).exists());
    let jet = workspace("aircraft/generic-business-jet.toml");
    for (options, reason) in [
        ("--set airspeed=1e9", "--set airspeed=1e9: found `1e9`, allowed is"),
        ("--set elevator=1", "--set elevator=1: "),
        ("--set condition.manoeuvre=turn", "condition.bank_angle: found 0, allowed is an angle other than 0"),
        ("--format xls", "invalid value 'xls'"),
        (
            "--inflow half",
            "invalid value 'half' for '--inflow <keep|steady|balanced:N>': allowed are keep, steady and balanced:N",
        ),
        ("--modes 2 --set inflow_states=1 --inflow balanced:3", "--inflow balanced:3: allowed are 4 to "),
        (
            "--modes 2 --set inflow_states=1 --inflow balanced:600",
            "4 of the 112 roots are slow or do not decay",
        ),
        (
            "--all-states --set condition.manoeuvre=turn --set condition.bank_angle=0.5",
            "condition.manoeuvre: found turn, allowed is straight or pull_up for a linear model with all states",
        ),
    ] {
        let failed = run(folder.path(), &format!("linearise {} {options} --output out", jet.display()));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("out").exists(), "{options}");
    }
}

#[test]
fn a_wing_in_a_tunnel_has_modes_alone() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/goland-wing.toml");
    let line = format!("linearise {} --modes 2 --inflow steady --format csv --output out", wing.display());
    let found = run(folder.path(), &line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    assert!(printed.contains("rest in the tunnel") && printed.contains("\n4 states, "), "{printed}");
    let table = std::fs::read_to_string(folder.path().join("out/goland-wing-A.csv")).unwrap();
    assert_eq!(table.lines().next(), Some(",modal.q[1],modal.q[2],modal.q_dot[1],modal.q_dot[2]"));
    assert_eq!(table.lines().count(), 5);
}

#[test]
fn a_gust_at_planes_is_an_input_and_where_they_are_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let line = "linearise --modes 2 --inflow steady --gust-stations 4 --output out";
    let found = run(folder.path(), line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    assert!(printed.contains("17 inputs") && printed.contains("\n4 gust planes, 10.4143 to −"), "{printed}");
    let json = std::fs::read_to_string(folder.path().join("out").join(file("linear.json"))).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        (json["u_names"][9].as_str(), json["u_names"][16].as_str()),
        (Some("gust_plane[1].up"), Some("gust_plane[4].right"))
    );
    assert_eq!(json["u_labels"][10], "gust_plane_1__right");
    let places: Vec<f64> = json["gust_planes"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
    assert!(places.len() == 4 && places.is_sorted_by(|one, next| one > next), "{places:?}");
    for wrong in ["1", "-2", "1001", "x"] {
        let failed = run(folder.path(), &format!("linearise --gust-stations {wrong} --output wrong"));
        let errors = text(&failed.stderr);
        assert!(errors.contains("allowed is 0 for none, or 2 to 1000"), "{errors}");
    }
}

/// The keys of JSON that hold texts.
fn texts(json: &Value, key: &str) -> Vec<String> {
    json[key].as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

fn json(folder: &Path, options: &str) -> (String, Value) {
    let found = run(folder, &format!("linearise --modes 2 --set inflow_states=1 {options} --output out"));
    assert!(found.status.success(), "{}", text(&found.stderr));
    let file = std::fs::read(folder.join("out").join(file("linear.json"))).unwrap();
    (text(&found.stdout), serde_json::from_slice(&file).unwrap())
}

#[test]
fn a_reduced_model_has_its_own_states_a_bound_and_no_rate_of_the_wind_on_them() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--inflow balanced:30 --set actuator.elevator.frequency=40 --all-states";
    let (printed, reduced) = json(folder.path(), options);
    // Height, spiral, phugoid, position and heading, drift.
    for part in ["30 of 120 states are left, 10 of which are split off", "outputs are wrong by at most "] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    assert!(printed.contains("the modes of the aircraft, before its 120 states are reduced"), "{printed}");
    let bound = reduced["error_bound"][0].as_f64().unwrap();
    assert!(
        bound > 0.0 && printed.contains(&format!("wrong by at most {}", &bound.to_string()[..4])),
        "{bound}: {printed}"
    );
    let states = texts(&reduced, "x_names");
    assert_eq!((states.len(), &*states[0], &*states[29]), (30, "reduced[1]", "reduced[30]"));
    let rows = reduced["Bd"].as_array().unwrap().iter();
    assert!(rows.flat_map(|row| row.as_array().unwrap()).all(|entry| entry.as_f64() == Some(0.0)));
    let (_, again) = json(folder.path(), options);
    assert!(again == reduced);
}

#[test]
fn inputs_of_controls_are_those_without_the_air_and_all_states_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (_, controls) = json(folder.path(), "--inputs controls --all-states");
    let expected = ["elevator", "aileron", "aileron_symmetric", "rudder", "thrust_left", "thrust_right"];
    assert_eq!(texts(&controls, "u_names"), expected);
    assert_eq!(
        (controls["u0"].as_array().unwrap().len(), controls["D"][0].as_array().unwrap().len()),
        (6, 6)
    );
    let states = texts(&controls, "x_names");
    assert_eq!(states[..3], ["position.north", "position.east", "position.down"]);
    assert_eq!((&*states[5], &*states[states.len() - 1]), ("attitude.yaw", "drift.down"));
    // ψ̇ = ω_z/cos θ in level flight.
    let pitch = controls["x0"][4].as_f64().unwrap();
    let column = states.iter().position(|name| name == "rate.z").unwrap();
    assert!((controls["A"][5][column].as_f64().unwrap() * pitch.cos() - 1.0).abs() < 1e-8);
}

#[test]
fn a_wing_in_a_tunnel_whose_roots_all_decay_fast_is_reduced_and_one_that_nothing_moves_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/very-flexible-wing.toml");
    let reduce = |options: &str| {
        run(
            folder.path(),
            &format!("linearise {} --inflow balanced:20 {options} --output out", wing.display()),
        )
    };
    let found = reduce("");
    let printed = text(&found.stdout);
    assert!(found.status.success() && printed.contains("20 of 104 states are left, 0 of which"), "{printed}");
    let still = text(&reduce("--inputs controls").stderr);
    assert!(still.contains("--inflow balanced:20: no input moves"), "{still}");
}

#[test]
fn modes_are_told_by_name_with_flying_qualities_and_stand_in_the_files() {
    let folder = tempfile::tempdir().unwrap();
    let (printed, json) = json(folder.path(), "--format json,csv");
    for name in ["phugoid", "short period", "Dutch roll", "elastic 2"] {
        assert!(printed.contains(name), "{name}: {printed}");
    }
    assert!(printed.contains("n/α: ") && printed.contains("led by"), "{printed}");
    let modes = json["modes"].as_array().unwrap();
    let named = |name: &str| modes.iter().find(|mode| mode["name"] == name).unwrap();
    assert_eq!(
        (named("roll")["family"].as_str(), named("phugoid")["family"].as_str()),
        (Some("antisymmetric"), Some("symmetric"))
    );
    let phugoid = named("phugoid")["eigenvalue"][1].as_f64().unwrap();
    assert!((0.1..0.13).contains(&phugoid), "{phugoid}");
    assert!(named("short period")["participations"]["rate.y"].as_f64().unwrap() > 0.1);
    assert!(json["flying_qualities"]["load_factor_per_alpha"].as_f64().unwrap() > 5.0);
    let table = std::fs::read_to_string(folder.path().join("out").join(file("modes"))).unwrap();
    assert!(table.contains("phugoid,symmetric,") && table.lines().count() == 1 + modes.len(), "{table}");
}

#[test]
fn modes_are_followed_over_airspeed() {
    let folder = tempfile::tempdir().unwrap();
    let line = "linearise --modes 2 --set inflow_states=1 --speed 120:140:3 --output out";
    let found = run(folder.path(), line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let table = std::fs::read_to_string(folder.path().join("out").join(file("locus"))).unwrap();
    let frequencies: Vec<f64> = table
        .lines()
        .filter(|line| line.contains(",short period,symmetric,"))
        .map(|line| line.split(',').nth(5).unwrap().parse().unwrap())
        .collect();
    assert!(frequencies.len() == 3 && frequencies.is_sorted(), "{table}");
    assert!(table.starts_with("airspeed,mode,family,real_part,"), "{table}");
    assert!(table.contains("120,Dutch roll,antisymmetric,"), "{table}");
    assert_eq!(text(&found.stderr), "");
    let drawing = std::fs::read_to_string(folder.path().join("out/generic-business-jet-locus.svg")).unwrap();
    assert!(drawing.contains("Dutch roll") && drawing.contains("elastic 1"));
    for (options, reason) in [
        ("--speed 120", "allowed are at least two ascending airspeeds"),
        ("--speed 140,120", "allowed are at least two ascending airspeeds"),
        ("--speed 120:140:3 --format csv", "cannot be used with"),
        ("--speed 120:140:3 --inflow balanced:20", "--inflow balanced:20: found with --speed"),
        ("--speed 1:2:2", "no steady level flight found at 2 m/s"),
    ] {
        let failed = run(folder.path(), &format!("linearise --modes 2 {options} --output wrong"));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("wrong").exists(), "{options}");
    }
}

#[test]
fn trims_of_a_locus_beyond_their_limits_are_warned_of_as_those_of_a_model() {
    let folder = tempfile::tempdir().unwrap();
    let linearise = |options: &str| {
        let line =
            format!("linearise --modes 2 --set inflow_states=1 --inflow steady {options} --output out");
        let found = run(folder.path(), &line);
        assert!(found.status.success(), "{}", text(&found.stderr));
        text(&found.stderr)
    };
    let one = linearise("--set airspeed=70");
    let one = one.split_once(" stands, but ").unwrap().1.trim().split("; ").next().unwrap();
    let followed = linearise("--speed 70,75,130");
    let warning = followed.lines().find(|line| line.contains(one)).unwrap();
    assert!(warning.starts_with("warning: the trim at 70 m/s stands, but "), "{followed}");
    assert!(warning.ends_with(" (so at 2 airspeeds, 70 to 75 m/s)"), "{followed}");
}

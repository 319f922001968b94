//! `flexair gust --continuous`.

use serde_json::Value;

use crate::support::{names, run, text, workspace};

/// Of a small model of the jet.
const SMALL: &str = "gust --continuous --modes 4 --set inflow_states=1";

#[test]
fn limits_are_the_trim_and_the_rms_times_the_velocity_of_cs_25() {
    let folder = tempfile::tempdir().unwrap();
    let line =
        format!("{SMALL} --direction 0,90 --output-names load_factor,loads.wing_root_right --output out");
    let found = run(folder.path(), &line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let printed = text(&found.stdout);
    for part in [
        "continuous turbulence of 1 m/s at 127 m/s, 7620 m",
        "von Kármán's spectrum, scale 762 m",
        "U_σ 24.0800 m/s of true airspeed by CS 25.341(b) at VC, F_g 1.00000 at sea level, 1.00000 here",
        "frequencies from 0.05 to 300 rad/s",
    ] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let endings = ["continuous.csv", "continuous.json", "continuous.svg"];
    assert_eq!(
        names(&folder.path().join("out")),
        endings.map(|ending| format!("generic-business-jet-{ending}"))
    );
    let read = |ending: &str| {
        std::fs::read_to_string(folder.path().join(format!("out/generic-business-jet-{ending}"))).unwrap()
    };
    let json: Value = serde_json::from_str(&read("continuous.json")).unwrap();
    let row = |direction: usize, name: &str| -> [f64; 5] {
        let rows = json["directions"][direction]["outputs"].as_array().unwrap();
        let row = rows.iter().find(|row| row["output"] == name).unwrap();
        ["trim", "a_bar_per_m_s", "n0_hz", "least", "greatest"].map(|key| row[key].as_f64().unwrap())
    };
    let [trim, rms, crossings, least, greatest] = row(0, "load_factor.z");
    // Near what all modes give, 0.0401 per m/s.
    assert!((trim - 1.0).abs() < 0.02 && (0.03..0.05).contains(&rms) && (0.1..10.0).contains(&crossings));
    let increment = 24.08 * rms;
    assert!((least - (trim - increment)).abs() < 1e-12 && (greatest - (trim + increment)).abs() < 1e-12);
    // Upwards nothing goes aside, to the right the load factor across does not change.
    assert_eq!(row(0, "load_factor.y")[1..3], [0.0, 0.0]);
    assert!(row(1, "load_factor.y")[1] > 1e-3 && row(1, "load_factor.z")[1] < 1e-3 * rms);
    let table = read("continuous.csv");
    assert_eq!(table.lines().count(), 1 + 2 * (4 + 6));
    let line = table.lines().find(|line| line.starts_with("0,load_factor.z,,")).unwrap();
    assert_eq!(line.split(',').nth(4).unwrap().parse::<f64>().unwrap(), rms);
    let plot = read("continuous.svg");
    assert!(plot.contains("frequency (rad/s)") && plot.contains(">loads.wing_root_right.bending<"));
}

#[test]
fn scale_spectrum_and_criterion_count() {
    let folder = tempfile::tempdir().unwrap();
    let greatest = |options: &str| {
        let line = format!("{SMALL} --output-names load_factor.z --output out {options}");
        let found = run(folder.path(), &line);
        assert!(found.status.success(), "{options}: {}", text(&found.stderr));
        let table = folder.path().join("out/generic-business-jet-continuous.csv");
        let table = std::fs::read_to_string(table).unwrap();
        let row: Vec<f64> =
            table.lines().nth(1).unwrap().split(',').filter_map(|cell| cell.parse().ok()).collect();
        // After the direction: trim, Ā, N0, U_σ.
        [row[2], row[4]]
    };
    let [usual, velocity] = greatest("");
    let [dive, half] = greatest("--criterion cs25_vd");
    assert_eq!((dive, half), (usual, 0.5 * velocity));
    let [short, _] = greatest("--set turbulence.scale=200");
    let [dryden, _] = greatest("--set turbulence.spectrum=dryden");
    assert!(short > 1.1 * usual && (dryden / usual - 1.0).abs() > 0.01, "{usual} {short} {dryden}");
    let [alleviated, less] = greatest("--set gust.alleviation=0.5");
    assert_eq!(alleviated, usual);
    assert!((less / velocity - (0.5 + 0.5 * 7620.0 / 12_500.0)).abs() < 1e-12);
}

#[test]
fn what_no_continuous_turbulence_has_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let jet = workspace("aircraft/generic-business-jet.toml");
    for (options, reason) in [
        (
            "--gradients 30",
            "--gradients: found with --continuous, where no gust has a gradient: meant is `--set turbulence.scale=…` (m), or",
        ),
        ("--peak 3", "--peak: found with --continuous, where no gust has a peak: meant is --criterion,"),
        (
            "--duration 3",
            "--duration: found with --continuous, where nothing is flown: meant is `flexair simulate",
        ),
        ("--step 0.01", "--step: found with --continuous, where nothing is flown"),
        (
            "--set turbulence.intensity=2",
            "--set turbulence.intensity=2: continuous turbulence has an rms of 1 m/s",
        ),
        ("--set gust.start=2", "--set gust.start=2: continuous turbulence"),
        (
            "--set gust.inclination=1",
            "everywhere; allowed of gust.* and turbulence.* are turbulence.spectrum,",
        ),
        ("--set gust.criterion=peak", "everywhere: meant is --criterion, from which U_σ follows; allowed"),
        ("--set gust.gradient=30", "everywhere: meant is `--set turbulence.scale=…` (m); allowed"),
        ("--weights 3,2,1 --set gust.alleviation=1", "the gusts of a set have their own, by --weights"),
        (
            "--output-names sensor.rate.y",
            "--output-names sensor.rate.y: found an output that no linear model has",
        ),
        ("--output-names loads.wing", "--output-names loads.wing: there is no such output"),
    ] {
        let failed =
            run(folder.path(), &format!("gust {} --continuous {options} --output out", jet.display()));
        let errors = text(&failed.stderr);
        assert!(!failed.status.success() && errors.contains(reason), "{options}: {errors}");
        assert!(!folder.path().join("out").exists(), "{options}");
    }
}

#[test]
fn a_wing_in_a_tunnel_stands_in_turbulence_where_there_is_a_stream() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/very-flexible-wing.toml");
    let line = format!("gust {} --continuous --modes 4 --output out", wing.display());
    let found = run(folder.path(), &line);
    assert!(found.status.success(), "{}", text(&found.stderr));
    let table = std::fs::read_to_string(folder.path().join("out/very-flexible-wing-continuous.csv")).unwrap();
    let bending = table.lines().find(|line| line.starts_with("0,loads.root.bending,")).unwrap();
    assert!(bending.split(',').nth(4).unwrap().parse::<f64>().unwrap() > 1e-3, "{bending}");
    let failed = run(folder.path(), &format!("{line} --set airspeed=0"));
    let errors = text(&failed.stderr);
    assert!(
        errors.contains("airspeed: found 0, allowed is greater than 0 (m/s) for a linear model"),
        "{errors}"
    );
}

#[test]
fn an_aircraft_that_flutters_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let wing = workspace("aircraft/goland-wing.toml");
    let line = format!(
        "gust {} --continuous --modes 4 --set airspeed=160 --output-names deflection --output out",
        wing.display()
    );
    let found = run(folder.path(), &line);
    let errors = text(&found.stderr);
    assert!(
        found.status.success() && errors.contains("warning: the aircraft is unstable, with a root at "),
        "{errors}"
    );
    assert_eq!(warnings(folder.path(), "goland-wing"), told(&errors));
}

/// What the JSON warns of.
fn warnings(folder: &std::path::Path, aircraft: &str) -> Vec<String> {
    let json = std::fs::read_to_string(folder.join(format!("out/{aircraft}-continuous.json"))).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    json["warnings"].as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

/// What standard error warns of.
fn told(errors: &str) -> Vec<String> {
    errors.lines().filter_map(|line| line.strip_prefix("warning: ")).map(str::to_owned).collect()
}

#[test]
fn a_trim_beyond_the_limits_is_warned_of_in_the_file_too_and_other_trims_are_not() {
    let folder = tempfile::tempdir().unwrap();
    for (options, count) in [("", 0), (" --set airspeed=70", 1)] {
        let line = format!("{SMALL} --output-names load_factor.z --output out{options}");
        let found = run(folder.path(), &line);
        assert!(found.status.success(), "{}", text(&found.stderr));
        let (written, told) = (warnings(folder.path(), "generic-business-jet"), told(&text(&found.stderr)));
        assert_eq!(written, told);
        let is_beyond = |text: &&String| text.starts_with("the trim at 70 m/s and 7620 m stands, but ");
        assert_eq!(written.iter().filter(is_beyond).count(), count, "{written:?}");
    }
}

#[test]
fn turbulence_has_no_sense_so_that_opposite_directions_are_one() {
    let folder = tempfile::tempdir().unwrap();
    let table = |directions: &str| {
        let line = format!("{SMALL} --direction {directions} --output-names load_factor --output out");
        let found = run(folder.path(), &line);
        assert!(found.status.success(), "{}", text(&found.stderr));
        std::fs::read_to_string(folder.path().join("out/generic-business-jet-continuous.csv")).unwrap()
    };
    let right = table("90");
    assert_eq!(right.lines().count(), 1 + 4);
    for same in ["270", "-90", "90,-90,270"] {
        assert_eq!(table(same), right, "{same}");
    }
}

//! The command from its options to its words, plots and numbers.

use std::path::Path;

use clap::Parser;
use flexible_aircraft::stability::Branch;

use super::*;
use crate::analysis::motion;
use crate::chart::Curve;
use crate::diagnostics::Report as _;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    options: FlutterOptions,
}

/// The options of `flexair flutter` with a shipped aircraft.
fn options(aircraft: &str, rest: &str) -> FlutterOptions {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft").join(aircraft);
    let mut words = vec!["flutter".to_owned(), path.display().to_string()];
    words.extend(rest.split_whitespace().map(str::to_owned));
    Line::try_parse_from(words).unwrap_or_else(|error| panic!("{error}")).options
}

fn analyse(options: &FlutterOptions) -> Result<Analysis, Error> {
    super::analyse(options, &Audience::new(false))
}

fn section(rest: &str) -> Analysis {
    analyse(&options("typical-section.toml", rest)).unwrap()
}

#[test]
fn the_report_names_the_speeds_of_the_typical_section() {
    let text = report::text(&section("--from 5 --to 80 --points 9 --modes 2 --inflow-states 6"));
    // Hodges and Pierce: 2.165 and 0.6545 times b ω = 20 m/s; divergence at 2.828.
    for line in ["43.31 m/s  flutter         13.09 rad/s (2.083 Hz)", "56.57 m/s  divergence      static"] {
        assert!(text.contains(line), "{text}");
    }
    assert!(text.contains("% mode 2") && text.contains("(begins as mode 2, 3.2"), "{text}");
}

#[test]
fn no_flutter_in_the_range_is_said_with_the_range() {
    let text = report::text(&section("--from 5 --to 40 --points 5"));
    assert!(text.contains("no flutter begins from 5 to 40 m/s"), "{text}");
    assert!(text.contains("no divergence begins from 5 to 40 m/s"), "{text}");
}

#[test]
fn a_range_that_begins_beyond_flutter_says_so() {
    let text = report::text(&section("--from 50 --to 55 --points 3 --modes 2"));
    assert!(
        text.contains("50.00 to 55.00 m/s  1.") && text.contains(" already at the first airspeed ("),
        "{text}"
    );
}

#[test]
fn airspeeds_without_trim_are_listed_with_the_reason() {
    let range = "--from 3 --to 127 --points 2 --altitude 7620 --modes 2";
    let text = report::text(&analyse(&options("generic-business-jet.toml", range)).unwrap());
    assert!(text.contains("not analysed: 3.00 m/s\n"), "{text}");
    assert!(text.contains("no steady level flight found at 3 m/s"), "{text}");
}

#[test]
fn the_plots_show_both_modes_and_mark_both_speeds() {
    let analysis = section("--from 5 --to 80 --points 16 --modes 2");
    for chart in [plots::dampings(&analysis), plots::frequencies(&analysis)] {
        assert_eq!(chart.curves.len(), 2);
        let svg = chart.to_svg();
        assert!(svg.contains(">flutter 43.3 m/s<") && svg.contains(">divergence 56.6 m/s<"), "{svg}");
        assert!(chart.curves.iter().all(|curve| curve.points.len() > 5));
    }
    let aperiodic = plots::aperiodic_growth(&analysis).unwrap();
    let grows = |curve: &Curve| curve.points.iter().any(|point| point.1 > 0.0);
    assert!(aperiodic.curves.iter().any(grows), "the divergence is drawn");
}

#[test]
fn a_range_that_is_none_is_refused() {
    for range in [
        "--from 80 --to 5",
        "--from 0 --to 5",
        "--from 1e-320 --to 0",
        "--from 5 --to 80 --points 1",
        "--from 5 --to 80 --points 100001",
        "--from 5 --to 80 --points 18446744073709551615",
    ] {
        let error = analyse(&options("typical-section.toml", range)).err().unwrap().report();
        assert!(error.contains("0 < from < to (m/s) and 2 to 100000 points are allowed"), "{error}");
    }
}

#[test]
fn what_is_out_of_range_is_named_by_its_option() {
    for (aircraft, option, expected) in [
        ("generic-business-jet.toml", "--from 0.5 --to 90", "--from: found 0.5, allowed is 1 to 400 m/s"),
        ("generic-business-jet.toml", "--from 90 --to 401", "--to: found 401, allowed is 1 to 400 m/s"),
        (
            "generic-business-jet.toml",
            "--from 90 --to 100 --altitude 31000",
            "--altitude: found 31000, allowed is -1000 to 30000 (m)",
        ),
        (
            "goland-wing.toml",
            "--from 90 --to 100 --stiffness-scale 0",
            "--stiffness-scale: found 0, allowed is a finite number > 0",
        ),
        (
            "goland-wing.toml",
            "--from 90 --to 100 --inflow-states 9",
            "--inflow-states: found 9, allowed is 0 to 8",
        ),
    ] {
        let error = analyse(&options(aircraft, option)).err().unwrap().report();
        assert_eq!(error, format!("error: {expected}"));
    }
}

#[test]
fn an_altitude_is_refused_where_the_tunnel_has_air_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let own: String =
        text.lines().filter(|line| !line.starts_with("altitude_m")).fold(String::new(), |t, l| t + l + "\n");
    let file = folder.path().join("own-air.toml");
    std::fs::write(&file, own.replacen("support =", "density_kg_m3 = 1.0\nsupport =", 1)).unwrap();
    let range = "--from 90 --to 100 --points 2 --modes 2";
    let file = file.display().to_string();
    let error = analyse(&options(&file, &format!("{range} --altitude 1000"))).err().unwrap().report();
    assert!(error.starts_with("error: --altitude 1000: ") && error.contains("`density_kg_m3`"), "{error}");
    assert_eq!(analyse(&options(&file, range)).unwrap().density(), 1.0);
}

/// Nobody gave the option.
#[test]
fn of_a_clamped_wing_that_is_rigid_by_its_file_the_file_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let file = folder.path().join("rigid.toml").display().to_string();
    std::fs::write(&file, text.replace("model = \"exact\"", "model = \"rigid\"")).unwrap();
    let error = analyse(&options(&file, "--from 90 --to 100")).err().unwrap().report();
    let nothing = "nothing would move, for the aircraft is clamped; allowed is a flexible model";
    assert_eq!(error, format!("error: model = \"rigid\" of {file}: {nothing}"));
}

/// Of the section, which diverges from 56.57 m/s on.
#[test]
fn an_aperiodic_instability_at_one_airspeed_alone_is_drawn() {
    let analysis = section("--from 5 --to 60 --points 2 --modes 2 --inflow-states 0");
    let chart = plots::aperiodic_growth(&analysis).unwrap();
    let unstable = |curve: &&Curve| curve.points.iter().any(|point| point.1 > 0.0);
    let [curve] = chart.curves.iter().filter(unstable).collect::<Vec<_>>()[..] else { panic!("{chart:?}") };
    assert_eq!(curve.points.len(), 1, "{curve:?}");
    assert!(chart.y.window.contains(curve.points[0].1) && chart.to_svg().contains("<circle"));
}

#[test]
fn a_plot_of_an_earlier_run_goes_when_nothing_is_drawn_now() {
    let folder = tempfile::tempdir().unwrap();
    let files = || {
        let entries = std::fs::read_dir(folder.path()).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect::<Vec<_>>()
    };
    for (to, count) in [("80", 4), ("20", 3)] {
        let rest = format!(
            "--from 5 --to {to} --points 16 --modes 2 --inflow-states 0 --output {}",
            folder.path().display()
        );
        run(&options("typical-section.toml", &rest)).unwrap();
        let is_there = files().contains(&"typical-section-v-aperiodic.svg".to_owned());
        assert_eq!((files().len(), is_there), (count, count == 4), "{:?}", files());
    }
}

#[test]
fn a_missing_file_and_too_many_modes_are_errors_for_people() {
    let report = |aircraft, rest| analyse(&options(aircraft, rest)).err().unwrap().report();
    let missing = report("none.toml", "--from 5 --to 80");
    assert!(missing.contains("none.toml: cannot read the aircraft file"), "{missing}");
    let many = report("typical-section.toml", "--from 5 --to 80 --modes 40");
    assert!(many.starts_with("error: 40 modes were asked for, the structure has "), "{many}");
    let absurd = "--from 5 --to 80 --mode-family symmetric --modes 18446744073709551615";
    let absurd = report("generic-business-jet.toml", absurd);
    assert!(absurd.starts_with("error: 18446744073709551615 symmetric modes were asked for"), "{absurd}");
    let lopsided = report("goland-wing.toml", "--from 5 --to 80 --mode-family symmetric");
    assert!(
        lopsided.contains("symmetric modes were asked for, the structure has no mirror plane"),
        "{lopsided}"
    );
}

#[test]
fn a_clamped_wing_that_nothing_moves_is_refused_and_a_free_rigid_aircraft_is_not() {
    for (option, allowed) in [("--model rigid", "a flexible model"), ("--modes 0", "at least 1 mode")] {
        let range = format!("--from 60 --to 200 --points 3 {option}");
        let error = analyse(&options("goland-wing.toml", &range)).err().unwrap().report();
        let expected =
            format!("error: {option}: nothing would move, for the aircraft is clamped; allowed is {allowed}");
        assert_eq!(error, expected);
        let range = format!("--from 120 --to 130 --points 2 {option}");
        let analysis = analyse(&options("generic-business-jet.toml", &range)).unwrap();
        // [theory: thesis-runs.eigenvalues]: the phugoid and the short period of the rigid jet oscillate.
        let oscillating = |branch: &Branch| branch.roots[0].as_ref().is_some_and(motion::oscillates);
        assert!(analysis.sweep.branches.iter().filter(|branch| oscillating(branch)).count() >= 2);
    }
}

#[test]
fn the_altitude_is_the_aircrafts_unless_asked_for() {
    let range = "--from 120 --to 130 --points 2 --modes 2";
    let altitude = |rest: &str| {
        analyse(&options("generic-business-jet.toml", &format!("{range} {rest}"))).unwrap().settings.altitude
    };
    assert_eq!([altitude(""), altitude("--altitude 100")], [7620.0, 100.0]);
}

#[test]
fn load_modes_are_counted_and_named_by_themselves_and_bring_motion_where_no_natural_mode_does() {
    let wing = |rest: &str| report::text(&analyse(&options("goland-wing.toml", rest)).unwrap());
    let text = wing("--from 100 --to 200 --points 5 --modes 2 --load-modes");
    assert!(text.contains(", 2 natural and 3 load modes, "), "{text}");
    assert!(wing("--from 100 --to 110 --points 2 --modes 2").contains(", 2 modes, "));
    let text = wing("--from 100 --to 200 --points 5 --modes 0 --load-modes");
    assert!(
        text.contains(", 0 natural and 3 load modes, ") && text.contains("(begins as load mode "),
        "{text}"
    );
}

#[test]
fn the_roots_are_written_with_speed_root_frequency_damping_and_mode() {
    let analysis = section("--from 5 --to 80 --points 16 --modes 2 --inflow-states 6");
    let table = roots::table(&analysis);
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some(roots::HEADER));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == 7));
    let number = |row: &Vec<&str>, column: usize| row[column].parse::<f64>().unwrap();
    // At 45 m/s, beyond 43.3, one root flutters; its damping is that of its eigenvalue.
    let unstable = |row: &&Vec<&str>| number(row, 0) == 45.0 && number(row, 2) > 0.0;
    let [row] = rows.iter().filter(unstable).collect::<Vec<_>>()[..] else { panic!("{table}") };
    let (growth, frequency) = (number(row, 2), number(row, 4));
    assert!(
        (number(row, 3) / std::f64::consts::TAU - frequency).abs() < 1e-9 && (1.5..2.5).contains(&frequency)
    );
    assert!((number(row, 5) - 2.0 * growth / number(row, 3)).abs() < 1e-9);
    assert!(row[6].starts_with("mode "), "{row:?}");
    // From 60 m/s it diverges: a root without frequency has no damping.
    let diverging = |row: &&Vec<&str>| number(row, 0) == 80.0 && number(row, 2) > 0.0 && row[4] == "0";
    assert!(
        rows.iter().filter(diverging).all(|row| row[5].is_empty()) && rows.iter().any(|row| diverging(&row))
    );
}

#[test]
fn warnings_name_the_speeds_whose_trims_nobody_could_fly() {
    let range = "--from 55 --to 127 --points 3 --modes 2";
    let analysis = analyse(&options("generic-business-jet.toml", range)).unwrap();
    let warnings = limits::warnings(&analysis.sweep.limits_exceeded).join("\n");
    assert!(warnings.contains("the trim at 55 m/s stands, but elevator -"), "{warnings}");
    assert!(warnings.contains("below -0.5236 rad (-30.0°), the usual limit"), "{warnings}");
    assert!(!warnings.contains("127 m/s"), "{warnings}");
}

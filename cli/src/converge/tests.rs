//! The command from its options to its words, plot and numbers.

use std::path::Path;

use clap::Parser;
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{ModeSelection, Plant};
use flexible_aircraft::stability::Complex;
use flexible_aircraft::structure::ModeKind;

use super::quantity::{Kind, Quantity, Value};
use super::verdict::{Verdict, moved};
use super::*;
use crate::chart::Window;
use crate::diagnostics::Report as _;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    options: ConvergeOptions,
}

fn parse(aircraft: &str, rest: &str) -> Result<ConvergeOptions, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(aircraft);
    let mut words = vec!["converge".to_owned(), path.display().to_string()];
    words.extend(rest.split_whitespace().map(str::to_owned));
    Line::try_parse_from(words).map(|line| line.options).map_err(|error| error.to_string())
}

fn study_of(aircraft: &str, rest: &str) -> Result<Study, String> {
    study(&parse(aircraft, rest).unwrap()).map_err(|error| error.report())
}

const SECTION: &str = "aircraft/typical-section.toml";
const GOLAND: &str = "aircraft/goland-wing.toml";
const JET: &str = "aircraft/generic-business-jet.toml";
const SMALL: &str = "tests/data/small-aircraft.toml";

fn numbers(kind: Kind, name: &str, scale: f64, numbers: &[f64]) -> Quantity {
    let values = numbers.iter().copied().map(Value::Number).collect();
    Quantity { kind: Some(kind), name: name.to_owned(), unit: "rad", places: 4, scale, values }
}

fn labels(counts: &[usize]) -> Vec<String> {
    counts.iter().map(ToString::to_string).collect()
}

fn verdict(quantities: &[Quantity], counts: &[usize], all: bool) -> String {
    let verdict = Verdict::of(quantities, counts.len(), || all);
    verdict.text(quantities, &labels(counts), false)
}

#[test]
fn so_many_modes_are_enough_as_all_larger_numbers_agree_with() {
    let elevator = numbers(Kind::Trim, "elevator", 0.4, &[-0.30, -0.398, -0.401, -0.400]);
    let tip = numbers(Kind::Deflection, "tip up", 5.0, &[4.8, 4.99, 4.995, 5.0]);
    assert_eq!(
        verdict(&[elevator.clone(), tip.clone()], &[4, 8, 16, 24], false),
        "8 modes are enough: with more, up to 24, trims move by 0.8 %, deflections by 0.2 % at most."
    );
    // What agrees with the last alone, and not with those between, has not converged there.
    let swaying = numbers(Kind::Trim, "elevator", 0.4, &[-0.40, -0.30, -0.401, -0.400]);
    assert!(
        verdict(&[swaying, tip.clone()], &[4, 8, 16, 24], false)
            .starts_with("16 modes are enough: with more, 24, ")
    );
    assert!(moved(&[elevator, tip], &labels(&[4, 8, 16, 24])).is_empty());
}

#[test]
fn what_moved_most_in_the_last_step_shows_that_modes_are_not_enough() {
    let mut flutter = numbers(Kind::Critical, "flutter", 167.0, &[196.0, 167.0]);
    flutter.unit = "m/s";
    let pitch = numbers(Kind::Trim, "pitch", 0.4, &[0.166, 0.1708]);
    let quantities = [pitch, flutter];
    assert_eq!(
        verdict(&quantities, &[12, 24], false),
        "Not converged with 24 modes: flutter still moved by 17 % at the last step (196.0000 m/s to 167.0000 m/s); ask for \
         more (--modes …) or for load modes (--load-modes)."
    );
    let warnings = moved(&quantities, &labels(&[12, 24]));
    assert_eq!(
        warnings,
        [
            "pitch moved by 1.2 % of the greatest trim angle from 12 to 24 modes (0.1660 rad to 0.1708 rad)",
            "flutter moved by 17 % from 12 to 24 modes (196.0000 m/s to 167.0000 m/s)"
        ]
    );
    assert_eq!(
        verdict(&quantities, &[12, 24], true),
        "Of these numbers only 24 modes will do: all that the structure has."
    );
    assert!(
        verdict(&quantities, &[24], false).starts_with("One number of modes says nothing of convergence")
    );
}

#[test]
fn a_flutter_that_appears_is_a_change_and_one_that_is_nowhere_is_none() {
    let none = || Value::Outside("none".into());
    let with = |values: Vec<Value>| Quantity {
        values,
        unit: "m/s",
        ..numbers(Kind::Critical, "flutter", 167.0, &[])
    };
    let appears = with(vec![none(), Value::Number(167.0)]);
    assert!(appears.change(0, 1).is_infinite());
    let text = verdict(&[appears], &[8, 20], false);
    assert!(text.contains("flutter still moved at the last step (none to 167.0000 m/s)"), "{text}");
    let tip = numbers(Kind::Deflection, "tip up", 5.0, &[5.0, 5.01]);
    let nowhere = with(vec![none(), none()]);
    assert_eq!(
        verdict(&[tip.clone(), nowhere], &[8, 20], false),
        "8 modes are enough: with more, 20, deflections move by 0.2 % at most."
    );
    // Two trims that are not found do not agree.
    let lost = with(vec![Value::Unknown("no trim"), Value::Unknown("no trim")]);
    let text = verdict(&[tip, lost], &[8, 20], false);
    assert!(text.starts_with("Not converged with 20 modes: flutter is not known (no trim)"), "{text}");
}

#[test]
fn roots_move_as_shares_of_themselves() {
    let root = |re, im| Value::Root(Complex::new(re, im));
    let values = vec![root(-0.4, 3.0), root(-0.4, 3.1)];
    let root = Quantity { values, ..numbers(Kind::Root, "root 1", 1.0, &[]) };
    assert!((root.change(0, 1) - 0.1 / 0.4_f64.hypot(3.1)).abs() < 1e-12);
    assert_eq!(root.text(0), "−0.4000 ± 3.0000i");
    // They speak where nothing else does.
    let tip = numbers(Kind::Deflection, "tip up", 5.0, &[5.0, 5.1]);
    let text = verdict(&[root.clone(), tip], &[4, 8], false);
    assert!(text.starts_with("Not converged with 8 modes: tip up still moved by 2.0 %"), "{text}");
    assert!(
        verdict(&[root], &[4, 8], false)
            .starts_with("Not converged with 8 modes: root 1 still moved by 3.2 %")
    );
}

#[test]
fn usual_numbers_end_with_all_modes_of_a_small_structure() {
    assert_eq!(usual_counts(5), [1, 2, 3, 4, 5]);
    assert_eq!(usual_counts(10), [4, 6, 8, 10]);
    assert_eq!(usual_counts(40), USUAL_COUNTS);
}

#[test]
fn the_section_needs_both_of_its_springs_and_no_more() {
    let study = study_of(SECTION, "--from 5 --to 80 --points 9 --airspeed 20 --inflow-states 6").unwrap();
    let text = report::text(&study);
    assert_eq!(study.labels(), ["1", "2", "3", "4", "5"], "{text}");
    assert!(text.contains("\n2 modes are enough: with more, up to 5, critical speeds move by "), "{text}");
    // Hodges and Pierce: 2.165 and 0.6545 times b ω = 20 m/s; divergence at 2.828.
    let cells = |name: &str| {
        let line = text.lines().find(|line| line.trim_start().starts_with(name)).unwrap_or_default();
        line.split_whitespace().skip(2).take(3).collect::<Vec<_>>().join(" ")
    };
    assert_eq!([cells("flutter (m/s)"), cells("divergence (m/s)")], ["none 43.31 43.31", "none 56.57 56.57"]);
    let both = study_of(SECTION, "--modes 1,5 --from 5 --to 80 --points 9 --airspeed 20").unwrap();
    assert!(
        report::text(&both).ends_with("Of these numbers only 5 modes will do: all that the structure has.\n")
    );
}

#[test]
fn golands_wing_flutters_alike_with_few_modes_and_with_many() {
    let study = study_of(GOLAND, "--modes 8,2,4 --from 100 --to 200 --points 5 --inflow-states 4").unwrap();
    assert_eq!(study.labels(), ["2", "4", "8"]);
    let flutter = study.quantities.iter().find(|quantity| quantity.name == "flutter").unwrap();
    // The wing of VERIFICATION.md, 137.4 m/s with eight modes and its own inflow states.
    assert!(flutter.values.iter().all(|value| (value.number().unwrap() - 137.0).abs() < 3.0), "{flutter:?}");
    let table = table::table(&study);
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(names[..2], ["natural_modes", "load_modes"]);
    for name in ["flutter_m_s", "flutter_frequency_rad_s", "divergence_m_s", "root_1_imaginary_rad_s"] {
        assert!(names.contains(&name), "{table}");
    }
    assert!(
        lines.clone().count() == 3 && lines.all(|line| line.split(',').count() == names.len()),
        "{table}"
    );
    let plot = plot::departures(&study);
    assert!(plot.curves.iter().any(|curve| curve.label == "flutter" && curve.points.len() == 3));
    // Nothing holds a trim in a tunnel.
    assert!(study.quantities.iter().all(|quantity| quantity.kind != Some(Kind::Trim)), "{table}");
}

/// What a flight of the jet with so many symmetric modes begins with, geometrically exact at one-tenth stiffness: pitch and
/// elevator (rad), wing tip up and inboard (m). VERIFICATION.md has these trims.
fn trimmed_jet(mode_count: usize) -> [f64; 4] {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(JET);
    let (count, kind) = (ModeCount::Asked(mode_count), ModeKind::Symmetric);
    let model = ReducedModel::with(&Aircraft::read(path).unwrap(), count, kind).unwrap();
    let settings = PlantSettings {
        fidelity: Fidelity::GeometricallyExact,
        mode_selection: ModeSelection::Symmetric,
        mode_count,
        stiffness_scale: 0.1,
        inflow_states: 0,
        ..PlantSettings::of(&model)
    };
    let plant = Plant::under(&model, &settings).unwrap();
    let trim = plant.trim(&settings.trim_condition()).unwrap();
    let outputs = plant.outputs_at(&trim.state, &trim.controls, &mut plant.workspace());
    let station = model.stations.iter().position(|station| station.name == "wing_tip_right").unwrap();
    let tip = outputs.deflections[station].displacement;
    [trim.point.pitch, trim.point.pitch_control, -tip.z, -tip.y]
}

#[test]
fn the_jet_at_a_tenth_of_its_stiffness_wants_more_than_sixteen_symmetric_modes() {
    let condition =
        "--model geometrically_exact --stiffness-scale 0.1 --mode-family symmetric --inflow-states 0";
    let study = study_of(JET, &format!("{condition} --modes 8,16 --from 150 --to 151 --points 2")).unwrap();
    let trims = [8, 16].map(trimmed_jet);
    let names = ["pitch", "elevator", "wing_tip_right up", "wing_tip_right inboard"];
    for (place, name) in names.into_iter().enumerate() {
        let quantity = study.quantities.iter().find(|quantity| quantity.name == name).unwrap();
        for (value, trim) in quantity.values.iter().zip(&trims) {
            assert!((value.number().unwrap() - trim[place]).abs() < 1e-9, "{quantity:?} {trim:?}");
        }
    }
    let text = report::text(&study);
    assert!(
        text.contains("Not converged with 16 modes: elevator still moved by 17 % of the greatest"),
        "{text}"
    );
    let warnings = study.warnings();
    let of_tip = warnings.iter().filter(|warning| warning.contains("wing_tip_right up")).collect::<Vec<_>>();
    assert!(
        of_tip.len() == 1 && of_tip[0].starts_with("wing_tip_left, wing_tip_right up moved"),
        "{warnings:?}"
    );
}

#[test]
fn a_free_aircraft_shows_its_trims_and_load_modes_are_counted_beside() {
    let study = study_of(SMALL, "--modes 2,4 --load-modes --points 2 --from 100 --to 130").unwrap();
    let text = report::text(&study);
    assert!(study.rows.iter().all(|row| row.loads > 0) && text.contains(" + "), "{text}");
    assert!(text.contains("with load modes (natural + load)"), "{text}");
    assert!(text.contains("pitch (rad)") && text.contains("last step"), "{text}");
    assert!(!study.verdict.text(&study.quantities, &study.labels(), true).contains("--load-modes"));
}

#[test]
fn a_trim_that_is_not_found_is_said_in_its_row() {
    let study = study_of(SMALL, "--modes 2,4 --airspeed 3 --from 3 --to 4 --points 2").unwrap();
    let text = report::text(&study);
    assert!(text.contains("no trim  no trim") && text.contains("  2 modes: no trim: no steady"), "{text}");
    assert!(text.contains("Not converged with 4 modes: pitch is not known (no trim)"), "{text}");
}

#[test]
fn the_usual_search_is_within_what_the_aircraft_may_fly() {
    for (aircraft, airspeed, rest, expected) in [
        (Support::Free, 127.0, "", [63.5, 254.0]),
        (Support::Free, 1.5, "", [1.0, 3.0]),
        (Support::Free, 300.0, "", [150.0, 400.0]),
        (Support::Clamped, 0.4, "", [0.2, 0.8]),
        (Support::Clamped, 0.0, "--from 5 --to 80", [5.0, 80.0]),
    ] {
        let Airspeeds { from, to, points } = parse(SMALL, rest).unwrap().search(airspeed, aircraft).unwrap();
        assert_eq!(([from, to], points), (expected, 16));
    }
}

/// Nobody gave an option there.
#[test]
fn a_file_that_flies_rigid_is_what_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rigid.toml");
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(SMALL)).unwrap();
    std::fs::write(&file, text.replace("model = \"exact\"", "model = \"rigid\"")).unwrap();
    let file = file.to_str().unwrap();
    assert_eq!(
        study_of(file, "").err().unwrap(),
        format!(
            "error: model = \"rigid\" of {file}: it has no modes whose number could matter; allowed is a flexible model"
        )
    );
    let flies = study_of(file, "--model inconsistent --modes 2,4 --from 100 --to 130 --points 2");
    assert!(flies.is_ok(), "{:?}", flies.err());
}

#[test]
fn grid_lines_over_the_number_of_modes_are_whole() {
    let study = study_of(SECTION, "--from 5 --to 80 --points 3 --airspeed 20").unwrap();
    let svg = plot::departures(&study).to_svg();
    assert!((1..=5).all(|modes| svg.contains(&format!(">{modes}<"))) && !svg.contains(">2.5<"), "{svg}");
    for (least, most, step) in [(4.0, 5.0, 1.0), (4.0, 14.0, 1.0), (4.0, 40.0, 5.0), (1.0, 400.0, 50.0)] {
        assert_eq!(plot::whole_tick(Window::new(least, most)), step);
    }
}

#[test]
fn what_is_wrong_is_named_by_its_option() {
    for (aircraft, rest, expected) in [
        (SMALL, "--airspeed 0.5", "--airspeed: found 0.5, allowed is 1 to 400 m/s"),
        (SMALL, "--from 5 --to 401", "--to: found 401, allowed is 1 to 400 m/s"),
        (SMALL, "--from 9 --to 5", "0 < from < to (m/s)"),
        (SMALL, "--model rigid", "--model rigid: it has no modes whose number could matter"),
        (GOLAND, "--modes 0,2", "--modes 0: nothing would move, for the aircraft is clamped"),
        (GOLAND, "--modes 2,4000", "4000 modes were asked for, the structure has "),
    ] {
        let error = study_of(aircraft, rest).err().unwrap();
        assert!(error.starts_with("error: ") && error.contains(expected), "{rest}: {error}");
    }
    let error = study_of(GOLAND, "--airspeed 0").err().unwrap();
    assert_eq!(
        error,
        "error: around 0 m/s flutter would be looked for from 0 to 0 m/s, which is no range: give --from and --to (m/s)"
    );
    let error = parse(SMALL, "--modes 4,x").err().unwrap();
    assert!(error.contains("allowed is a whole number, 0 or more"), "{error}");
}

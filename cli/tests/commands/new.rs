//! `flexair new`: every kind, small, light and large, is an aircraft at once.

use std::path::Path;

use serde_json::Value;

use crate::support::{names, run, text};

/// Runs a command that has to succeed without a warning.
#[track_caller]
fn quietly(folder: &Path, line: &str) -> String {
    let found = run(folder, line);
    let errors = text(&found.stderr);
    assert!(found.status.success() && !errors.contains("warning"), "{line}: {errors}");
    text(&found.stdout)
}

/// The columns of a flight with some names.
fn columns(table: &str, names: &[&str]) -> Vec<Vec<f64>> {
    let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let places = names.iter().map(|name| header.iter().position(|column| column == name).unwrap());
    let places: Vec<usize> = places.collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|row| places.iter().map(|&place| row[place].parse().unwrap()).collect()).collect();
    (0..names.len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect()
}

/// Writes, describes and flies an aircraft of a kind in three spans, m; the second is shaken too. Then one whose wing carries so little, kg, that
/// the air that it moves weighs more than it does.
#[track_caller]
fn check_kind(kind: &str, spans: [f64; 3], light: Option<[f64; 2]>) {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (size, span) in spans.into_iter().enumerate() {
        let file = format!("{kind}-{span}.toml");
        let printed = quietly(folder, &format!("new {file} --kind {kind} --span {span}"));
        assert!(printed.contains("given\n") && printed.contains("assumed: "), "{printed}");
        for next in ["check", "view", "package --aircraft"] {
            assert!(printed.contains(&format!("  flexair {next} {file}\n")), "{printed}");
        }
        let written = std::fs::read_to_string(folder.join(&file)).unwrap();
        assert!(written.starts_with("#:schema ./aircraft.schema.json\n# Written by"), "{written}");
        assert!(printed.ends_with("  flexair schema --output aircraft.schema.json\n"), "{printed}");
        assert!(
            written.contains("\nmodel = \"geometrically_exact\"") && written.contains("\n#   span "),
            "{written}"
        );
        check_described(folder, (kind, &file, span));
        check_flight(folder, (kind, &file), 2e-3);
        check_senses(folder, (kind, &file));
        if size == 1 {
            check_flutter(folder, (&file, &written));
            check_margin(folder, (&file, &written));
        }
    }
    if let Some([span, mass]) = light {
        let printed = quietly(folder, &format!("new light.toml --kind {kind} --span {span} --mass {mass}"));
        assert!(printed.contains("static margin"), "{printed}");
        let written = std::fs::read_to_string(folder.join("light.toml")).unwrap();
        check_described(folder, (kind, "light.toml", span));
        check_flight(folder, (kind, "light.toml"), 2e-3);
        check_senses(folder, (kind, "light.toml"));
        check_margin(folder, ("light.toml", &written));
    }
}

/// The static margin without what computes it: as it is found in flight, where the elevator of trims at two airspeeds goes with the lift by as much as
/// the margin is great, and goes with the place of the payload. The rigid aircraft, whose margin airspeeds leave as it is; drag and
/// thrust turn too: what is found differs by up to 0.02. And inflow states change nothing.
#[track_caller]
fn check_margin(folder: &Path, (file, written): (&str, &str)) {
    if !written.contains("payload") {
        return;
    }
    let place = written.find("placed for the static margin\nat_m = ").unwrap();
    let place = place + written[place..].find("at_m = ").unwrap() + "at_m = ".len();
    let end = place + written[place..].find('\n').unwrap();
    let at: f64 = written[place..end].parse().unwrap();
    let described = |file: &str, states: usize| -> [f64; 3] {
        let line = format!("describe {file} --set model=rigid --set inflow_states={states} --json -");
        let described: Value = serde_json::from_str(&text(&run(folder, &line).stdout)).unwrap();
        ["/stability/static_margin", "/stability/centre_of_mass/0", "/reference/chord"]
            .map(|path| described.pointer(path).and_then(Value::as_f64).unwrap())
    };
    let [[margin, x, chord], [unsteady, _, _]] = [0, 5].map(|states| described(file, states));
    let moved = format!("{}{}{}", &written[..place], at + 0.1 * chord, &written[end..]);
    std::fs::write(folder.join("moved.toml"), moved).unwrap();
    let [_, moved_x, _] = described("moved.toml", 0);
    assert!((margin - unsteady).abs() < 1e-6, "{file}: {margin} {unsteady}");
    let airspeed = written.lines().find_map(|line| line.strip_prefix("airspeed_m_s = ")).unwrap();
    let airspeed: f64 = airspeed.parse().unwrap();
    let slope = |file: &str| {
        let elevator = [1.0, 1.1].map(|ratio| {
            let line = format!("trim {file} --set model=rigid --speed {} --json -", ratio * airspeed);
            let trims: Value = serde_json::from_str(&text(&run(folder, &line).stdout)).unwrap();
            trims["trims"][0]["elevator"].as_f64().unwrap()
        });
        elevator[1] - elevator[0]
    };
    let [slope, moved_slope] = [file, "moved.toml"].map(slope);
    // K/K' = slope/slope', K' = K + (x' - x)/c.
    let found = (moved_x - x) / chord * slope / (moved_slope - slope);
    assert!((found - margin).abs() < 0.02, "{file}: {found} {margin}");
}

/// No warning, the static margin that is aimed at, the usual frequency.
#[track_caller]
fn check_described(folder: &Path, (kind, file, span): (&str, &str, f64)) {
    let described = quietly(folder, &format!("describe {file} --json -"));
    let described: Value = serde_json::from_str(&described).unwrap();
    assert_eq!(described["warnings"].as_array().map(Vec::len), Some(0), "{file}: {}", described["warnings"]);
    if kind != "wing-on-wall" {
        let margin = described["stability"]["static_margin"].as_f64().unwrap();
        assert!((margin - 0.1).abs() < 0.006, "{file}: {margin}");
    }
    let usual = match kind {
        "sailplane" => 45.0 / span,
        "wing-on-wall" => (35.0 / span).min(40.0),
        _ => 70.0 / span,
    };
    assert!((bending(&described) / usual - 1.0).abs() < 0.01, "{file}: {} {usual}", bending(&described));
}

/// Of the first bending of the wing that is not antisymmetric, Hz.
fn bending(described: &Value) -> f64 {
    let modes = described["modes"].as_array().unwrap();
    let is_it = |mode: &&Value| {
        mode["motion"].as_str().unwrap().starts_with("wing bending") && mode["family"] != "antisymmetric"
    };
    modes.iter().find(is_it).unwrap()["frequency"].as_f64().unwrap()
}

/// Ten seconds with an elevator doublet, or a flap's: the nose goes down first, what it does stays small and has nearly gone in the end. It pitches by
/// so much at least, rad.
#[track_caller]
fn check_flight(folder: &Path, (kind, file): (&str, &str), least: f64) {
    let is_free = kind != "wing-on-wall";
    let (control, watched) = match kind {
        "wing-on-wall" => ("flap", "deflection.wing_tip.up"),
        _ => ("elevator", "attitude.pitch"),
    };
    let line = format!(
        "simulate --aircraft {file} --modes 6 --step 0.05 --input {control}=doublet:0.01@0.2:0.4 --duration 10"
    );
    let flight = columns(&quietly(folder, &line), &["time", watched]);
    let (times, values) = (&flight[0], &flight[1]);
    let away = |value: &f64| value - values[0];
    let far = values.iter().map(away).fold(0.0, |far: f64, away| far.max(away.abs()));
    let left = away(&values[values.len() - 1]).abs();
    let early = times.iter().position(|time| *time >= 0.55).unwrap();
    if is_free {
        assert!(away(&values[early]) < 0.0, "{file}: {}", away(&values[early]));
        assert!((least..0.05).contains(&far), "{file}: {far}");
        assert!(left < 0.005, "{file}: {left}");
    } else {
        assert!(away(&values[early]) > 0.0 && far > 1e-6 && left < 0.01 * far, "{file}: {far} {left}");
    }
}

/// A step of the aileron rolls right, one of the rudder turns the nose right, within a fifth of a second (a small aircraft swings back after it).
#[track_caller]
fn check_senses(folder: &Path, (kind, file): (&str, &str)) {
    if kind == "wing-on-wall" {
        return;
    }
    let controls: &[(&str, &str)] = match kind {
        "flying-wing" => &[("aileron", "rate.x")],
        _ => &[("aileron", "rate.x"), ("rudder", "rate.z")],
    };
    for (control, rate) in controls {
        let line = format!(
            "simulate --aircraft {file} --modes 6 --step 0.05 --input {control}=step:0.01@0.1 --duration 0.3"
        );
        let rates = &columns(&quietly(folder, &line), &[rate])[0];
        let last = rates[rates.len() - 1] - rates[0];
        assert!(last > 1e-4, "{file}: {control} {last}");
    }
}

/// None from the airspeed of the trim to a fifth more; two inflow states are enough to see it and quick.
#[track_caller]
fn check_flutter(folder: &Path, (file, written): (&str, &str)) {
    let airspeed = written.lines().find_map(|line| line.strip_prefix("airspeed_m_s = ")).unwrap();
    let airspeed: f64 = airspeed.parse().unwrap();
    let line = format!(
        "flutter {file} --modes 20 --inflow-states 2 --from {airspeed} --to {} --points 2 --output shaken",
        1.2 * airspeed
    );
    let printed = quietly(folder, &line);
    assert!(printed.contains("no flutter begins"), "{file}: {printed}");
}

#[test]
fn conventional_aircraft_fly_as_they_are_written() {
    check_kind("conventional", [3.0, 11.0, 45.0], Some([3.0, 2.0]));
}

#[test]
fn aircraft_with_a_t_tail_fly_as_they_are_written() {
    check_kind("t-tail", [3.0, 12.0, 35.0], Some([3.0, 2.2]));
}

#[test]
fn aircraft_with_a_v_tail_fly_as_they_are_written() {
    check_kind("v-tail", [3.0, 10.0, 35.0], Some([3.0, 1.5]));
}

#[test]
fn canards_fly_as_they_are_written() {
    check_kind("canard", [3.0, 10.0, 30.0], Some([3.0, 2.2]));
}

#[test]
fn flying_wings_fly_as_they_are_written() {
    check_kind("flying-wing", [3.0, 12.0, 50.0], Some([3.0, 2.0]));
}

#[test]
fn twin_booms_fly_as_they_are_written() {
    check_kind("twin-boom", [3.0, 11.0, 40.0], Some([3.0, 2.0]));
}

#[test]
fn sailplanes_fly_as_they_are_written() {
    check_kind("sailplane", [3.0, 18.0, 30.0], Some([15.0, 20.0]));
}

#[test]
fn wings_on_walls_stand_as_they_are_written() {
    check_kind("wing-on-wall", [1.0, 5.0, 30.0], None);
}

/// Slender wings of little weight in thin air.
#[test]
fn what_flies_by_the_sun_is_written_at_30_to_80_metres() {
    let folder = tempfile::tempdir().unwrap();
    for (span, mass) in [(30, 80), (80, 500)] {
        let line = format!(
            "new {span}.toml --kind sailplane --span {span} --mass {mass} --altitude 18000 --engines 1"
        );
        quietly(folder.path(), &line);
        let file = format!("{span}.toml");
        let checked = run(folder.path(), &format!("check {file}"));
        assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stdout));
        check_described(folder.path(), ("sailplane", &file, f64::from(span)));
        // The doublet of 0.4 s is short for what is so large: 1.6e-3 rad at 80 m.
        check_flight(folder.path(), ("sailplane", &file), 5e-4);
        check_margin(folder.path(), (&file, &std::fs::read_to_string(folder.path().join(&file)).unwrap()));
    }
}

/// What the end of the file of a twin boom says is true: its tail in one piece flies, and its antisymmetric modes are stiffer.
#[test]
fn the_tail_of_a_twin_boom_can_be_joined_as_its_file_says() {
    let folder = tempfile::tempdir().unwrap();
    let printed = quietly(folder.path(), "new halves.toml --kind twin-boom");
    assert!(printed.contains("The halves of the tail are not joined"), "{printed}");
    let written = std::fs::read_to_string(folder.path().join("halves.toml")).unwrap();
    let (halves, block) = written.split_once("# axis_m = ").unwrap();
    let (axis, joint) = block.split_once("#\n").unwrap();
    let mut joined = halves.replace("\"geometrically_exact\"", "\"exact\"") + &joint.replace("# ", "");
    let tail = joined.find("name = \"htail_right\"").unwrap();
    let from = tail + joined[tail..].find("axis_m").unwrap();
    let to = from + joined[from..].find('\n').unwrap();
    joined.replace_range(from..to, &format!("axis_m = {}", axis.trim_end()));
    for root in ["wing_root_right", "wing_root_left", "boom_root_right", "boom_root_left"] {
        let from = joined.find(&format!("[[cut]]\nname = \"{root}\"")).unwrap();
        let to = from + joined[from..].find("at = 0\n").unwrap() + "at = 0\n".len();
        joined.replace_range(from..to, "");
    }
    std::fs::write(folder.path().join("joined.toml"), joined).unwrap();
    let lowest = |file: &str| {
        let checked = run(folder.path(), &format!("check {file} --json -"));
        assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
        let described: Value = serde_json::from_slice(&checked.stdout).unwrap();
        let modes = described["modes"].as_array().unwrap().clone();
        let is_it = |mode: &&Value| mode["family"] == "antisymmetric";
        modes.iter().find(is_it).unwrap()["frequency"].as_f64().unwrap()
    };
    let [halves, joined] = ["halves.toml", "joined.toml"].map(lowest);
    assert!(joined > 1.05 * halves, "{halves} {joined}");
}

/// Every number by an option, and none of them in the way of another.
#[test]
fn what_is_given_stands_in_the_file_and_the_wing_has_the_frequency_that_was_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--kind T-tail --span 25 --root-chord 4.5 --tip-chord 1.8 --sweep 15 --dihedral 2.5 --mass 16000 --engines 4 \
                   --airspeed 150 --altitude 7000 --bending-frequency 2.4";
    let printed = quietly(folder.path(), &format!("new \"a\"b.toml {options}"));
    assert!(!printed.contains("assumed: "), "{printed}");
    let written = std::fs::read_to_string(folder.path().join("\"a\"b.toml")).unwrap();
    for line in [
        "name = '\"a\"b, aircraft with a T-tail'\n",
        "airspeed_m_s = 150\n",
        "altitude_m = 7000\n",
        "values = [4.5, 1.8]",
        "name = \"wing_left\"",
    ] {
        assert!(written.contains(line), "{line}: {written}");
    }
    assert_eq!(written.matches("[[engine]]").count(), 4);
    let described = quietly(folder.path(), "describe \"a\"b.toml --json -");
    let described: Value = serde_json::from_str(&described).unwrap();
    assert!((bending(&described) / 2.4 - 1.0).abs() < 0.01, "{}", bending(&described));
    assert!((described["mass"].as_f64().unwrap() / 16000.0 - 1.0).abs() < 1e-3, "{}", described["mass"]);
    let span = described["reference"]["span"].as_f64().unwrap();
    assert!((span - 25.0).abs() < 0.005, "{span}");
}

#[test]
fn what_is_not_allowed_is_told_with_what_is_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    for (options, reason) in [
        (
            "",
            "--kind: found none, allowed is conventional, t-tail, v-tail, canard, flying-wing, twin-boom, sailplane",
        ),
        ("--kind canard --span 500", "--span: found 500 m, allowed is 0.5 to 100 m"),
        ("--kind canard --sweep -30", "--sweep: found -30 deg, allowed is -20 to 40 deg"),
        ("--kind sailplane --engines 2", "--engines: found 2, allowed is 0 to 1 of this kind"),
        (
            "--kind canard --tip-chord 8",
            "--tip-chord: found 8 m, allowed is 0.0242424 to 2.66667 m for aspect ratios from 3 to 60 at this span",
        ),
        (
            "--kind canard --root-chord 8",
            "--root-chord: found 8 m, allowed is 0.133333 to 4.84848 m for aspect ratios from 3 to 60 at this span",
        ),
        (
            "--kind canard --root-chord 2 --tip-chord 0.1",
            "--root-chord: found 2 m, allowed is 0.166667 to 1 m beside this tip, for tapers from 0.1 to 1 and aspect",
        ),
        (
            "--kind canard --mass 100000",
            "--mass: found 100000 kg, allowed is 4.0299 to 7980 kg with this wing, for 0.5 to 1000 kg/m2",
        ),
        (
            "--kind canard --mass 7000 --altitude 20000",
            "--mass and the wing's area: found 877 kg/m2, allowed is what flies",
        ),
        // Not the search's own numbers, of a file that nobody has.
        (
            "--kind sailplane --span 100 --bending-frequency 0.1",
            "--bending-frequency: found 0.1 Hz, and no such aircraft: ",
        ),
        ("--kind sailplane --airspeed 5", "--airspeed: found 5 m/s, allowed is 24."),
        (
            "--kind sailplane --bending-frequency 100",
            "--bending-frequency: found 100 Hz, allowed is 0.5 to 12.5 Hz",
        ),
    ] {
        let failed = run(folder.path(), &format!("new new/a.toml {options}"));
        assert_eq!(failed.status.code(), Some(1), "{options}");
        assert!(
            text(&failed.stderr).starts_with("error: ") && text(&failed.stderr).contains(reason),
            "{}",
            text(&failed.stderr)
        );
        assert!(names(folder.path()).is_empty(), "{options}");
    }
}

#[test]
fn a_file_that_exists_is_replaced_by_force_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, "mine").unwrap();
    let failed = run(folder.path(), "new mine.toml --kind wing-on-wall");
    assert_eq!(failed.status.code(), Some(1));
    let errors = text(&failed.stderr);
    assert_eq!(
        errors,
        "error: mine.toml exists and stays as it is; allowed is another file, or --force to replace it\n"
    );
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine");
    quietly(folder.path(), "new mine.toml --kind wing-on-wall --force");
    assert!(std::fs::read_to_string(&file).unwrap().contains("# Written by `flexair new`"));
}

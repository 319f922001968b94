//! `flexair sweep`.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

use crate::support::{flexair, names, run, text, workspace};

/// A folder with a sweep file for one of the aircraft of the workspace.
fn sweep(aircraft: &str, rest: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let aircraft = workspace(aircraft);
    let file = format!("aircraft = {:?}\n{rest}", aircraft.display().to_string());
    std::fs::write(folder.path().join("a.toml"), file).unwrap();
    folder
}

/// All rows of a part, values by the names of their columns.
fn rows(part: &Path) -> Vec<BTreeMap<String, Field>> {
    let reader = SerializedFileReader::new(File::open(part).unwrap()).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    rows.map(|row| row.get_column_iter().map(|(name, value)| (name.clone(), value.clone())).collect())
        .collect()
}

fn number(field: &Field) -> f64 {
    match field {
        Field::Double(number) => *number,
        other => panic!("{other:?} is no number"),
    }
}

/// Bytes of everything in a folder.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let drafts = |name: &String| !name.starts_with('.');
    let names = names(folder).into_iter().filter(drafts);
    names.map(|name| (name.clone(), std::fs::read(folder.join(&name)).unwrap())).collect()
}

/// 2500 trims of a wing.
const TRIMS: &str = r#"
modes = 2
[[vary]]
name = "airspeed"
from = 20
to = 90
count = 50
[[vary]]
name = "stiffness_scale"
from = 0.5
to = 1.5
count = 50
[run]
kind = "trim"
[[keep]]
output = "deflection"
"#;

#[test]
fn a_sweep_that_was_killed_goes_on_to_the_bytes_of_one_that_was_not_with_any_number_of_threads() {
    let folder = sweep("aircraft/very-flexible-wing.toml", TRIMS);
    let mut child = flexair(folder.path(), "sweep a.toml --output killed")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let killed = folder.path().join("killed");
    let began = Instant::now();
    while !killed.join("part-00000.parquet").exists() && began.elapsed() < Duration::from_secs(300) {
        assert!(child.try_wait().unwrap().is_none(), "it ended before its first part was there");
        sleep(Duration::from_millis(1));
    }
    // SIGKILL on Unix.
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(killed.join("manifest.json").exists() && !killed.join("part-00002.parquet").exists());
    let first = std::fs::metadata(killed.join("part-00000.parquet")).unwrap().modified().unwrap();

    let resumed = run(folder.path(), "sweep a.toml --output killed --jobs 1");
    assert!(resumed.status.success(), "{}", text(&resumed.stderr));
    let said = text(&resumed.stdout);
    assert!(said.starts_with("2500 points: 2500 ok; ") && !said.contains("2500 flown"), "{said}");
    let whole = run(folder.path(), "sweep a.toml --output whole --jobs 2");
    assert!(text(&whole.stdout).contains("; 2500 flown in "), "{}", text(&whole.stdout));

    let parts = ["manifest.json", "part-00000.parquet", "part-00001.parquet", "part-00002.parquet"];
    let [killed_contents, whole_contents] =
        ["killed", "whole"].map(|name| contents(&folder.path().join(name)));
    assert_eq!(whole_contents.iter().map(|(name, _)| name).collect::<Vec<_>>(), parts);
    assert!(killed_contents == whole_contents);
    assert_eq!(std::fs::metadata(killed.join("part-00000.parquet")).unwrap().modified().unwrap(), first);
    let last = rows(&folder.path().join("whole/part-00002.parquet"));
    assert_eq!((last.len(), &last[499]["point"]), (500, &Field::Long(2499)));
    assert_eq!([number(&last[499]["airspeed"]), number(&last[499]["stiffness_scale"])], [90.0, 1.5]);

    // Nothing is left to do, and nothing else may go on there.
    let again = run(folder.path(), "sweep a.toml --output whole");
    assert!(text(&again.stdout).contains("2500 ok; all of them were there"), "{}", text(&again.stdout));
    let changed = std::fs::read_to_string(folder.path().join("a.toml")).unwrap().replace("90", "91");
    std::fs::write(folder.path().join("a.toml"), changed).unwrap();
    let refused = run(folder.path(), "sweep a.toml --output whole");
    let errors = text(&refused.stderr);
    assert_eq!(refused.status.code(), Some(1));
    assert!(
        errors.contains("manifest.json is of another sweep: the sweep file (")
            && !errors.contains("aircraft file"),
        "{errors}"
    );
    assert!(contents(&folder.path().join("whole")) == whole_contents);
}

#[test]
fn a_point_that_cannot_be_flown_is_a_row_that_says_why() {
    let rest = r#"
modes = 2
set.model = "exact"
set.actuator.elevator.minimum = -0.25
[[vary]]
name = "airspeed"
values = [110, 127, 500]
[run]
kind = "trim"
[[keep]]
output = "trim.pitch"
[[keep]]
output = "load_factor.z"
"#;
    let folder = sweep("aircraft/generic-business-jet.toml", rest);
    let swept = run(folder.path(), "sweep a.toml --output out");
    assert!(swept.status.success(), "{}", text(&swept.stderr));
    assert!(
        text(&swept.stdout).starts_with("3 points: 1 ok, 1 no_trim, 1 invalid; 3 flown"),
        "{}",
        text(&swept.stdout)
    );
    let first = "\nthe first that did not come out, point 0: ";
    let told = |said: &str| said.split_once(first).unwrap().1.lines().next().unwrap().to_owned();
    let message = told(&text(&swept.stdout));
    assert!(message.contains("`actuator.elevator.minimum` is -0.25 rad"), "{message}");
    let again = text(&run(folder.path(), "sweep a.toml --output out").stdout);
    assert!(again.contains("all of them were there") && told(&again) == message, "{again}");
    let rows = rows(&folder.path().join("out/part-00000.parquet"));
    let status = |row: usize| rows[row]["status"].to_string();
    assert_eq!([0, 1, 2].map(status), ["\"no_trim\"", "\"ok\"", "\"invalid\""]);
    for (row, message) in
        [(0, "`actuator.elevator.minimum` is -0.25 rad"), (2, "found `500`, allowed is 1 to 400 m/s")]
    {
        assert!(rows[row]["message"].to_string().contains(message), "{:?}", rows[row]);
        assert_eq!((&rows[row]["trim.pitch"], &rows[row]["load_factor.z"]), (&Field::Null, &Field::Null));
    }
    let trimmed = run(folder.path(), "trim --modes 2 --set model=exact --speed 127 --csv -");
    let table = text(&trimmed.stdout);
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let place = lines[0].iter().position(|head| *head == "pitch").unwrap();
    let expected: f64 = lines[1][place].parse().unwrap();
    let pitch = number(&rows[1]["trim.pitch"]);
    assert!((pitch - expected).abs() < 1e-12, "{pitch} {expected}");
    assert!((number(&rows[1]["load_factor.z"]) - pitch.cos()).abs() < 1e-6, "{:?}", rows[1]);
}

/// The same flight as `flexair simulate` makes of it, whose table has every look.
#[test]
fn what_is_kept_of_a_flight_is_what_its_table_has() {
    let rest = r#"
modes = 2
[set]
model = "exact"
gust.shape = "one_minus_cosine"
[[vary]]
name = "gust.peak"
values = [-3, 6]
[run]
kind = "simulate"
duration = 2
input = "elevator=doublet:0.02@0.5:0.4"
[[keep]]
output = "load_factor.z"
reduce = ["max", "min", "end", "time_of_max"]
[[keep]]
output = "loads.wing_root_right.bending"
reduce = "max"
"#;
    let folder = sweep("aircraft/generic-business-jet.toml", rest);
    let swept = run(folder.path(), "sweep a.toml --output out");
    assert!(swept.status.success(), "{}", text(&swept.stderr));
    let rows = rows(&folder.path().join("out/part-00000.parquet"));
    for (row, peak) in rows.iter().zip(["-3", "6"]) {
        let line = format!(
            "simulate --modes 2 --set model=exact --set gust.shape=one_minus_cosine --set gust.peak={peak} --duration 2 \
             --input elevator=doublet:0.02@0.5:0.4"
        );
        let table = text(&run(folder.path(), &line).stdout);
        let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
        let column = |name: &str| {
            let place = lines[0].iter().position(|head| *head == name).unwrap();
            lines[1..].iter().map(|line| line[place].parse().unwrap()).collect::<Vec<f64>>()
        };
        let (time, factor) = (column("time"), column("load_factor.z"));
        let greatest = factor.iter().copied().fold(f64::MIN, f64::max);
        let when = factor.iter().position(|value| *value == greatest).unwrap();
        let expected = [
            ("load_factor.z.max", greatest),
            ("load_factor.z.min", factor.iter().copied().fold(f64::MAX, f64::min)),
            ("load_factor.z.end", factor[factor.len() - 1]),
            ("load_factor.z.time_of_max", time[when]),
            (
                "loads.wing_root_right.bending.max",
                column("loads.wing_root_right.bending").into_iter().fold(f64::MIN, f64::max),
            ),
        ];
        assert!(greatest > 1.05, "{greatest}");
        for (name, expected) in expected {
            assert_eq!(number(&row[name]).to_bits(), expected.to_bits(), "{name}");
        }
    }
}

/// A wing of one component: its stiffness times a factor is the elastic properties times that, and half the mass of all
/// bays raises roots by the square root of two where there is no air to speak of.
#[test]
fn a_factor_on_the_aircraft_file_is_what_it_says() {
    let rest = |vary: &str, values: &str| {
        format!(
            "modes = 4\n[[vary]]\nname = \"{vary}\"\nvalues = {values}\n[run]\nkind = \"linearise\"\n[[keep]]\nroot = 1\n\
             [[keep]]\nmatrix = \"A\"\nrow = \"modal.q_dot[1]\"\ncolumn = \"modal.q[1]\"\n"
        )
    };
    let found = |vary: &str, values: &str| {
        let folder = sweep("aircraft/goland-wing.toml", &rest(vary, values));
        let swept = run(folder.path(), "sweep a.toml --output out");
        assert!(swept.status.success(), "{}", text(&swept.stderr));
        rows(&folder.path().join("out/part-00000.parquet"))
    };
    let by_file = found("component.wing.stiffness", "[0.5, 1, 0.5]");
    let by_parameter = found("stiffness_scale", "[0.5, 1, 0.5]");
    for (one, other) in by_file.iter().zip(&by_parameter) {
        for name in ["root[1].re", "root[1].im", "A[modal.q_dot[1],modal.q[1]]"] {
            let [one, other] = [one, other].map(|row| number(&row[name]));
            assert!((one - other).abs() < 1e-6 * (1.0 + other.abs()), "{name}: {one} {other}");
        }
    }
    assert_eq!(by_file[0]["root[1].im"], by_file[2]["root[1].im"]);
    assert!(number(&by_file[0]["root[1].im"]) < number(&by_file[1]["root[1].im"]));
}

#[test]
fn what_is_wrong_with_a_sweep_file_is_shown_with_its_lines_before_the_work() {
    let run_of = |kind: &str| format!("[run]\nkind = \"{kind}\"\n");
    let keep = "[[keep]]\noutput = \"load_factor.z\"\n";
    let trim = format!("modes = 2\n{}{keep}", run_of("trim"));
    let vary = |name: &str, rest: &str| format!("{trim}[[vary]]\nname = \"{name}\"\n{rest}\n");
    let linear = format!("modes = 2\n{}[[keep]]\nmatrix = \"B\"\n", run_of("linearise"));
    let fly = |run: &str| format!("modes = 2\n{}{run}\n{keep}reduce = \"max\"\n", run_of("simulate"));
    let gust = |top: &str, run: &str, rest: &str| {
        format!("modes = 2\n{top}\n{}{run}\n{keep}reduce = \"max\"\n{rest}", run_of("gust"))
    };
    for (rest, expected) in [
        (
            vary("airsped", "values = [1]"),
            &[
                "vary[1].name: there is no `airsped` that could be set",
                "did you mean `airspeed`?",
                " --> a.toml:8:8\n",
                "8 | name = \"airsped\"\n",
            ][..],
        ),
        (
            vary("component.wing_left.stiffness", "values = [1]"),
            &["did you mean `component.wing_right.stiffness`?"],
        ),
        (
            vary("elevator", "values = [1]"),
            &["found the input `elevator`", "inputs are given by `input` under [run]"],
        ),
        (vary("trim.pitch", "values = [1]"), &["found the output `trim.pitch`"]),
        (
            vary("model", "values = [\"rigit\"]"),
            &["vary[1].values[1]: found `rigit`", "allowed is exact, consistently_linearised"],
        ),
        (vary("model", "values = [1.5]"), &["found numbers that are not whole"]),
        (vary("airspeed", "values = [\"a\"]"), &["found texts as values"]),
        (vary("sensor.enabled", "values = [1]"), &["true or false goes under [set]"]),
        (
            vary("airspeed", "values = [100]\n[[vary]]\nname = \"airspeed\"\nvalues = [100]"),
            &["found `airspeed` twice"],
        ),
        (format!("{trim}[set]\nairspeed = 500\n"), &["set.airspeed: found `500`", "allowed is 1 to 400 m/s"]),
        (
            format!("{trim}[set]\nmass.wing_right = 0\n"),
            &["set.mass.wing_right: found the factor 0", "allowed is 0.000001 to 1000000"],
        ),
        (
            vary(
                "airspeed",
                "from = 100\nto = 200\ncount = 100000\n[[vary]]\nname = \"altitude\"\nfrom = 0\nto = 1000\ncount = 100000",
            ),
            &["found too many points", "allowed are 100000000 at most"],
        ),
        (
            format!("modes = 2\n{}[[keep]]\noutput = \"load_facto\"\n", run_of("trim")),
            &["keep[1].output: there is no output `load_facto` here", "did you mean"],
        ),
        (format!("modes = 2\n{}{keep}{keep}", run_of("trim")), &["found `load_factor.z` twice"]),
        (fly("input = \"elevatr=step:0.1\""), &["run.input: found `elevatr`", "did you mean `elevator`?"]),
        (
            fly("step = 1e-9"),
            &["run: found a duration and a step that make 10000000002 looks", "allowed are 1000000 at most"],
        ),
        (
            format!("{linear}row = \"rate.q\"\ncolumn = \"elevator\"\n"),
            &["keep[1]: found `rate.q` as a row of B", "did you mean `rate.x`?"],
        ),
        (
            // At none of the points, whatever the number of states; the first of them has no trim.
            format!(
                "modes = 2\nset.model = \"rigid\"\n{}[[keep]]\nroot = 20\n[[vary]]\nname = \"airspeed\"\nvalues = [1, 127]\n\
                 [[vary]]\nname = \"inflow_states\"\nvalues = [0]\n",
                run_of("linearise")
            ),
            &["keep[1].root: found the root 20", "allowed is 1 to 9, the states of the linear model"],
        ),
        (
            gust("", "duration = 2", "[set]\ngust.start = 2\n"),
            &[
                "set.gust.start: found a gust that begins at 2 s",
                "allowed is before the end of the flight, at 2 s",
            ],
        ),
        (
            gust("", "duration = 1", ""),
            &["run: found a flight of 1 s, but the gust begins at 1 s (`gust.start`)", "allowed is a longer"],
        ),
        (
            gust("", "duration = 2", "[[vary]]\nname = \"gust.start\"\nvalues = [1, 3]\n"),
            &["vary[1].name: found a gust that begins at 3 s"],
        ),
        (
            gust("samples = 2", "duration = 2", "[[vary]]\nname = \"gust.start\"\nuniform = [1, 2.5]\n"),
            &["vary[1].name: found a gust that begins at 2.5 s"],
        ),
    ] {
        let folder = sweep("aircraft/generic-business-jet.toml", &rest);
        let refused = run(folder.path(), "sweep a.toml --output out");
        let errors = text(&refused.stderr);
        assert_eq!((refused.status.code(), text(&refused.stdout).as_str()), (Some(1), ""), "{rest}");
        for expected in expected {
            assert!(errors.contains(expected), "{rest}\n{errors}\n{expected}");
        }
        assert_eq!(names(folder.path()), ["a.toml"], "{rest}");
    }
    let folder = sweep("aircraft/generic-business-jet.toml", &trim);
    let none = run(folder.path(), "sweep a.toml --output out --jobs 0");
    assert!(text(&none.stderr).contains("--jobs: found 0, allowed is 1 or more"));
    std::fs::write(folder.path().join("file"), "").unwrap();
    let blocked = run(folder.path(), "sweep a.toml --output file/new");
    assert!(
        text(&blocked.stderr).starts_with("error: cannot write file/new/manifest.json"),
        "{}",
        text(&blocked.stderr)
    );
    let missing = run(folder.path(), "sweep b.toml --output out");
    assert!(
        text(&missing.stderr).starts_with("error: b.toml: cannot read the sweep file: "),
        "{}",
        text(&missing.stderr)
    );
}

//! What a sweep file may say.

use super::*;

const WHOLE: &str = r#"
aircraft = "jet.toml"
modes = 4
[monte_carlo]
samples = 10
seed = 5
[set]
model = "rigid"
gust.shape = "one_minus_cosine"
"sensor.enabled" = true
[set.actuator.elevator]
frequency = 4e1
[[vary]]
name = "airspeed"
from = 110
to = 130.0
count = 3
[[vary]]
name = "mode_family"
values = ["all", "symmetric"]
[[vary]]
name = "gust.peak"
uniform = [-15, 15]
[[vary]]
name = "mass.wing_right"
normal = [1, 0.1]
[run]
kind = "simulate"
duration = 2
input = ["elevator=2311:0.05@0.5"]
[[keep]]
output = "load_factor"
reduce = ["max", "time_of_max"]
"#;

#[test]
fn a_whole_file_is_read_as_it_was_meant() {
    let file = SweepFile::parse(WHOLE, "a.toml").unwrap();
    assert_eq!((file.aircraft.as_deref(), file.modes), (Some(std::path::Path::new("jet.toml")), Some(4)));
    assert_eq!((file.samples, file.seed, file.load_modes), (10, 5, false));
    let mut fixed: Vec<(&str, &str)> =
        file.fixed.iter().map(|fixed| (fixed.name.as_str(), fixed.value.as_str())).collect();
    fixed.sort_unstable();
    let expected = [
        ("actuator.elevator.frequency", "40"),
        ("gust.shape", "one_minus_cosine"),
        ("model", "rigid"),
        ("sensor.enabled", "true"),
    ];
    assert_eq!(fixed, expected);
    let names: Vec<&str> = file.varied.iter().map(|varied| varied.name.as_str()).collect();
    assert_eq!(names, ["airspeed", "mode_family", "gust.peak", "mass.wing_right"]);
    assert!(matches!(&file.varied[0].law, Law::Axis(Axis::Grid(values)) if *values == [110.0, 120.0, 130.0]));
    assert!(
        matches!(&file.varied[1].law, Law::Items(items) if items.len() == 2 && items[1].0 == "symmetric")
    );
    assert!(matches!(file.varied[2].law, Law::Axis(Axis::Uniform { least: -15.0, most: 15.0 })));
    assert!(matches!(file.varied[3].law, Law::Axis(Axis::Normal { mean: 1.0, deviation: 0.1 })));
    let Run::Fly(flown) = &file.run else { panic!("{:?}", file.run) };
    assert_eq!((flown.duration, flown.step, flown.is_gust, flown.inputs.len()), (2.0, 0.01, false, 1));
    let [Keep::Output { name, reductions, .. }] = file.keep.as_slice() else { panic!("{:?}", file.keep) };
    assert_eq!(
        (name.as_str(), reductions.as_slice()),
        ("load_factor", &[Reduction::Max, Reduction::TimeOfMax][..])
    );
}

#[test]
fn what_is_wrong_is_told_with_its_line_and_what_is_allowed() {
    let run = "[run]\nkind = \"trim\"\n";
    let keep = "[[keep]]\noutput = \"trim.pitch\"\n";
    let vary = |rest: &str| format!("[[vary]]\nname = \"airspeed\"\n{rest}\n{run}{keep}");
    for (text, expected) in [
        (
            format!("arcraft = 1\n{run}{keep}"),
            "a.toml:1:1: arcraft: found the unknown key \"arcraft\"; did you mean `aircraft`? allowed here: aircraft, ",
        ),
        (
            format!("[run]\nkind = \"trim\"\nstep = 1\n{keep}"),
            "a.toml:3:8: run.step: found a key of another kind of run; allowed here: nothing but `kind`",
        ),
        (
            format!("[run]\nkind = \"fly\"\n{keep}"),
            "a.toml:2:8: run.kind: found the text \"fly\"; allowed is \"trim\", \"linearise\", \"gust\", \"simulate\"",
        ),
        (keep.to_owned(), "run: the key \"run\" is missing"),
        (run.to_owned(), "keep: the key \"keep\" is missing"),
        (
            format!("{run}[[keep]]\noutput = \"trim.pitch\"\nreduce = \"max\"\n"),
            "keep[1].reduce: found a key of another kind of run; allowed here: output",
        ),
        (
            format!("[run]\nkind = \"gust\"\n{keep}"),
            "keep[1].reduce: the key \"reduce\" is missing; allowed is \"max\", \"min\", \"rms\", \"end\", \"time_of_max\"",
        ),
        (
            format!("[run]\nkind = \"gust\"\nduration = 0\n{keep}"),
            "a.toml:3:12: run.duration: found 0; allowed is a finite number of seconds, greater than 0",
        ),
        (
            format!("[run]\nkind = \"simulate\"\ninput = \"elevator=flap:1\"\n{keep}reduce = \"end\"\n"),
            "run.input: found the shape `flap`; allowed are up to 16 digits",
        ),
        (vary(""), "vary[1]: found none or several ways to vary; allowed is one of `values`, "),
        (vary("values = [1]\nuniform = [0, 1]"), "vary[1]: found none or several ways to vary"),
        (vary("values = []"), "vary[1].values: found a list of 0; allowed is a list of numbers"),
        (vary("values = [1, inf]"), "a.toml:3:14: vary[1].values[2]: found inf; allowed is a finite number"),
        (vary("from = 1\nto = 2"), "vary[1].count: the key \"count\" is missing"),
        (
            vary("uniform = [2, 1]"),
            "vary[1].uniform: found a list of 2; allowed is [LEAST, MOST], LEAST < MOST",
        ),
        (
            vary("normal = [2, 0]"),
            "vary[1].normal: found a list of 2; allowed is [MEAN, DEVIATION], DEVIATION > 0",
        ),
        (vary("normal = [2, 1]"), "samples: the key \"samples\" is missing"),
        (
            format!("samples = 3\n{}", vary("values = [1]")),
            "a.toml:1:11: samples: found samples, but nothing that is random",
        ),
        (format!("seed = 3\n[monte_carlo]\nseed = 4\n{}", vary("values = [1]")), "seed: found `seed` twice"),
        (
            format!("seed = -3\n{}", vary("values = [1]")),
            "a.toml:1:8: seed: found -3; allowed is a whole number from 0 to 9223372036854775807",
        ),
        (
            format!("[set]\nmodel = [1]\n{run}{keep}"),
            "a.toml:2:9: set.model: found a list of 1; allowed is a finite number, a text, true or false",
        ),
        ("[run\n".to_owned(), "a.toml:1:"),
        (
            "[run]\nkind = \"linearise\"\n[[keep]]\nroot = 1\nmatrix = \"A\"\n".to_owned(),
            "keep[1]: found none or several things to keep",
        ),
        (
            "[run]\nkind = \"linearise\"\n[[keep]]\nmatrix = \"E\"\nrow = \"a\"\ncolumn = \"b\"\n".to_owned(),
            "keep[1].matrix: found the text \"E\"; allowed is \"A\", ",
        ),
    ] {
        let error = SweepFile::parse(&text, "a.toml").unwrap_err().to_string();
        assert!(error.contains(expected), "{text}\n{error}\n{expected}");
    }
}

#[test]
fn all_mistakes_are_told_at_once_in_the_order_of_the_file() {
    let text = "seed = -1\n[[vary]]\nname = 1\nvalues = 2\n[run]\nkind = 3\n";
    let error = SweepFile::parse(text, "a.toml").unwrap_err();
    let fields: Vec<&str> = error.mistakes.iter().map(|mistake| mistake.field.as_str()).collect();
    assert_eq!(fields, ["keep", "seed", "vary[1].name", "vary[1].values", "run.kind"]);
}

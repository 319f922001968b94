//! Tables as people and programs write them.

use std::path::Path;

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::ReducedModel;

use super::super::header::input;
use super::*;

fn small_aircraft() -> ReducedModel {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
    let aircraft = Aircraft::read(&path).unwrap();
    ReducedModel::new(&aircraft, 0).unwrap()
}

fn variables() -> VariableTable {
    VariableTable::new(&small_aircraft())
}

fn schedule(text: &str) -> Schedule {
    Schedule::parse(text.as_bytes(), &variables()).unwrap()
}

fn times(schedule: &Schedule, step: Option<f64>) -> Vec<f64> {
    schedule.points(step).map(|point| point.time).collect()
}

#[test]
fn values_and_rates_reach_the_inputs_that_the_columns_name() {
    let schedule = schedule(
        "\u{feff}time, der(elevator) ,wind_down,\"elevator\"\r\n0,1,2,0.3\r\n\r\n0.5,4,5,\"0.6\"\r\n",
    );
    assert_eq!(times(&schedule, None), [0.0, 0.5]);
    let [mut inputs, mut rates] = [Inputs::zero(&small_aircraft()), Inputs::zero(&small_aircraft())];
    schedule.write(1, &mut inputs, &mut rates);
    assert_eq!((inputs.controls[0], inputs.wind.z, rates.controls[0]), (0.6, 5.0, 4.0));
}

#[test]
fn a_step_puts_rows_between_those_of_the_table() {
    let schedule = schedule("time\n-1\n-0.985\n-0.95\n");
    let expected = [-1.0, -0.99, -0.985, -0.98, -0.97, -0.96, -0.95];
    let found = times(&schedule, Some(0.01));
    assert_eq!(found.len(), expected.len(), "{found:?}");
    assert!(
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-15),
        "{found:?}"
    );
    let rows: Vec<Option<usize>> = schedule.points(Some(0.01)).map(|point| point.row).collect();
    assert_eq!(rows, [Some(0), None, Some(1), None, None, None, Some(2)]);
}

#[test]
fn a_shape_has_rows_at_its_edges_and_leaves_the_columns_of_a_table_as_they_go_on() {
    let model = small_aircraft();
    let (slot, _) = input("elevator", &variables()).unwrap();
    let table = schedule("time,wind_down,der(wind_down)\n0,0,2\n1,5,0\n2,5,0\n");
    let both = table.with("elevator", slot, &"pulse:0.1@0.25:0.5".parse().unwrap(), 0.1);
    assert_eq!(times(&both, None), [0.0, 0.25, 0.75, 1.0, 2.0]);
    assert!(both.has_column("elevator") && both.has_column("wind_down") && !both.has_column("rudder"));
    let wind = vec![(0.0, 0.0), (0.25, 0.5), (0.75, 1.5), (1.0, 2.0), (1.0, 5.0), (2.0, 5.0)];
    let elevator =
        vec![(0.0, 0.0), (0.25, 0.0), (0.25, 0.1), (0.75, 0.1), (0.75, 0.0), (1.0, 0.0), (2.0, 0.0)];
    assert_eq!(both.histories(&model), [("wind_down", wind), ("elevator", elevator)]);
}

/// From its start on there are chords between the multiples of the step, each of which ends where the next begins.
#[test]
fn a_wave_is_continuous_and_none_of_its_rows_is_there_twice() {
    let (slot, _) = input("elevator", &variables()).unwrap();
    let wave = Schedule::hands_off(2.0).with("elevator", slot, &"sine:0.1@0.505:1".parse().unwrap(), 0.1);
    assert_eq!(times(&wave, None).len(), 2 + 14 + 1);
    assert_eq!(times(&wave, Some(0.1)).len(), 21 + 1);
    let histories = wave.histories(&small_aircraft());
    let history = &histories[0].1;
    for pair in history.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        assert!((pair[0].1 - pair[1].1).abs() < 1e-14, "{pair:?}");
    }
    let peak = history.iter().map(|point| point.1).fold(0.0, f64::max);
    // Of the rows that at 0.8 s and 1.8 s are nearest to the peaks.
    let expected = 0.1 * (0.295 * std::f64::consts::TAU).sin();
    assert!((peak - expected).abs() < 1e-12, "{peak}");
}

/// The wind changes at once where it steps, and at a rate where it swings.
#[test]
fn a_shape_of_the_wind_gives_its_rate() {
    let variables = variables();
    let (slot, _) = input("wind_down", &variables).unwrap();
    let rate = |shape: &str, row: usize| {
        let schedule = Schedule::hands_off(2.0).with("wind_down", slot, &shape.parse().unwrap(), 0.1);
        let [mut inputs, mut rates] = [Inputs::zero(&small_aircraft()), Inputs::zero(&small_aircraft())];
        schedule.write(row, &mut inputs, &mut rates);
        (inputs.wind.z, rates.wind.z)
    };
    assert_eq!(rate("step:-5@1", 1), (-5.0, 0.0));
    let (wind, slope) = rate("sine:2@0:1", 0);
    let chord = 2.0 * (0.2 * std::f64::consts::PI).sin() / 0.1;
    assert!(wind == 0.0 && (slope - chord).abs() < 1e-12, "{slope} {chord}");
}

/// 57 · 0.01 is 0.5700000000000001, and 29 · 0.1 is 2.9000000000000004.
#[test]
fn times_between_rows_have_the_digits_that_people_expect() {
    for step in [0.01, 0.1] {
        for (point, n) in schedule("time\n0\n10\n").points(Some(step)).zip(0..) {
            let expected: f64 = format!("{n}e{}", step.log10()).parse().unwrap();
            assert_eq!(point.time, expected);
        }
    }
    assert_eq!(times(&schedule("time\n0\n1\n"), Some(0.3)), [0.0, 0.3, 0.6, 0.8999999999999999, 1.0]);
    assert_eq!(times(&schedule("time\n0\n1\n"), Some(2.0)), [0.0, 1.0]);
}

#[test]
fn a_mistake_is_told_with_its_place_and_what_is_allowed() {
    let cases = [
        ("", "line 1, column 1: found ``, allowed is `time`, in s"),
        ("elevator\n", "line 1, column 1: found `elevator`, allowed is `time`, in s"),
        ("Time\n", "line 1, column 1: found `Time`, allowed is `time`, in small letters, in s"),
        ("t,elevator\n", "line 1, column 1: found `t`, allowed is `time`, in small letters, in s"),
        ("TIME [s]\n", "found `TIME [s]`, allowed is `time`, in small letters, in s; names stand alone"),
        ("time,flap\n", "line 1, column 2: found `flap`, allowed is an input; there are elevator, aileron, "),
        ("time,elevatr\n", "found `elevatr`, allowed is an input, did you mean `elevator`?; there are "),
        ("time,der(elevatr)\n", "found `der(elevatr)`, allowed is an input, did you mean `elevator`?"),
        ("time,airspeed\n", "found `airspeed`, allowed is an input; it is a parameter: --set airspeed=VALUE"),
        ("time,load_factor.z\n", "allowed is an input; it is an output, which is computed"),
        ("time,elevator,elevator\n", "line 1, column 3: found `elevator`, allowed is each name once"),
        ("time,der(rudder)\n", "allowed is a derivative beside the column of its input, `rudder`"),
        ("time\n", "line 1, time: found no numbers, allowed is a line of numbers for each step"),
        ("time,rudder\n0,1\n1\n", "line 3, all of it: found 1 column, allowed is 2, as in the line of names"),
        ("time,rudder\n0,left\n", "line 2, rudder: found `left`, allowed is a finite number"),
        ("time\ninf\n", "line 2, time: found `inf`, allowed is a finite number"),
        ("time\n1\n\n1\n", "line 4, time: found 1 s, allowed is a time after that of the row before, 1 s"),
        ("time\n1\n  \n\n1", "line 5, time: found 1 s"),
    ];
    for (text, expected) in cases {
        let mistake = Schedule::parse(text.as_bytes(), &variables()).unwrap_err().to_string();
        assert!(mistake.contains(expected), "{text:?}: {mistake}");
    }
}

#[test]
fn tables_in_other_formats_are_told_what_was_found() {
    let cases = [
        (
            "time;elevator\n0;0,1\n",
            "line 1, the line of names: found semicolons between the names, allowed is commas",
        ),
        ("time\televator\n", "found tabs between the names"),
        ("time elevator\n", "found spaces between the names"),
        ("# time,elevator\n", "line 1, the line of names: found `#`, allowed is a line of names"),
        (
            "time (s),elevator\n",
            "found `time (s)`, allowed is `time`, in s; names stand alone, without units",
        ),
        ("time,elevator (deg)\n", "did you mean `elevator`?; names stand alone, without units or quotes"),
        ("'time','elevator'\n", "found `'time'`, allowed is `time`, in s"),
        ("time,elevator\n0;1\n", "line 2, all of it: found semicolons between the numbers, allowed is 2"),
        (
            "time,elevator\n# take-off\n",
            "line 2, all of it: found `#`, allowed is numbers: there are no comments",
        ),
        ("time,elevator\n0,\"1\n1,2\n", "found a quoted text over several lines"),
        ("time,elevator\n0,0,5\n", "line 2, all of it: found 3 columns, allowed is 2"),
    ];
    for (text, expected) in cases {
        let mistake = Schedule::parse(text.as_bytes(), &variables()).unwrap_err().to_string();
        assert!(mistake.contains(expected), "{text:?}: {mistake}");
    }
    let wide: Vec<u8> = "\u{feff}time\n0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let mistake = Schedule::parse(&wide, &variables()).unwrap_err().to_string();
    assert!(mistake.contains("found a text in UTF-16, allowed is a text in UTF-8"), "{mistake}");
    let mistake = Schedule::parse(b"time\n\xe4\n", &variables()).unwrap_err().to_string();
    assert!(mistake.starts_with("line 2, all of it: found bytes that are no text in UTF-8"), "{mistake}");
}

#[test]
fn degrees_are_refused_and_never_converted() {
    let table = |angle: &str| Schedule::parse(format!("time,elevator\n0,{angle}\n").as_bytes(), &variables());
    for angle in ["5", "-1.61"] {
        let mistake = table(angle).unwrap_err().to_string();
        let expected = format!(
            "line 2, elevator: found {angle}, allowed is -1.6 to 1.6 rad: inputs are rad; {angle} looks like degrees"
        );
        assert_eq!(mistake, expected);
    }
    table("1.6").unwrap();
    schedule("time,wind_down,thrust_only,elevator,der(elevator)\n0,5,5000,0,5\n");
}

//! Reference lengths, of the file and of the wing.

use super::{assert_messages, edited};

/// The file with a table of its own for reference lengths.
fn with_reference(lines: &str) -> (&'static str, String) {
    ("model = \"exact\"\n", format!("model = \"exact\"\n[reference]\n{lines}\n"))
}

#[test]
fn without_a_table_they_are_those_of_the_mirrored_wing() {
    // A chord of 1.5 m over 5 m on each side.
    let lengths = edited(&[]).unwrap().reference_lengths().unwrap();
    for (found, expected) in [(lengths.chord, 1.5), (lengths.area, 15.0), (lengths.span, 10.0)] {
        assert!((found - expected).abs() < 1e-12, "{found} instead of {expected}");
    }
}

#[test]
fn a_wing_that_tapers_has_the_mean_of_the_squares() {
    let tapering = edited(&[("chord_m = 1.5", "chord_m = { at = [0, 1], values = [2, 1] }")]).unwrap();
    let lengths = tapering.reference_lengths().unwrap();
    // Four strips a side, at 1/8, 3/8, 5/8, 7/8 of the span.
    let chords = [1.875, 1.625, 1.375, 1.125];
    let [sum, squares] = [1, 2].map(|power| chords.map(|chord: f64| chord.powi(power)).iter().sum::<f64>());
    assert!((lengths.chord - squares / sum).abs() < 1e-12);
    assert!((lengths.area - 2.0 * 1.25 * sum).abs() < 1e-12);
}

#[test]
fn what_the_file_gives_stands_in_their_place() {
    let (before, after) = with_reference("chord_m = 1.4\nspan_m = 11");
    let lengths = edited(&[(before, &after)]).unwrap().reference_lengths().unwrap();
    assert_eq!([lengths.chord, lengths.span], [1.4, 11.0]);
    assert!((lengths.area - 15.0).abs() < 1e-12);
}

#[test]
fn lengths_that_none_has_are_refused() {
    let (before, after) = with_reference("chord_m = 0\narea_m2 = -1\nbreadth = 1");
    assert_messages(
        &[(before, &after)],
        &[
            "small.toml:10:11: reference.chord_m: found 0; a length in metres from 1e-6 to 1000 is allowed",
            "small.toml:11:11: reference.area_m2: found -1; an area in m² from 1e-12 to 1e6 is allowed",
            "small.toml:12:1: reference.breadth: found the unknown field \"breadth\"; allowed here: chord_m, area_m2, span_m",
        ],
    );
}

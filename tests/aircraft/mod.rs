//! The aircraft file: the shipped jet expands to the recorded numbers, mirrored parts fly as they should, and
//! bad files are told apart.

mod bad_airframes;
mod bad_fields;
mod basis;
mod controls;
mod cuts;
mod engines;
mod format_cases;
mod format_edits;
mod format_page;
mod format_samples;
mod good_files;
mod jet;
mod joints;
mod mirrors;
mod ranges;
mod reference;
mod sections;

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};

/// A small aircraft in which every part of the format occurs.
const GOOD: &str = include_str!("../data/small-aircraft.toml");

/// The place of its ailerons among its controls.
const AILERON: usize = 1;

/// The good file with the first occurrence of some texts replaced.
fn edited(edits: &[(&str, &str)]) -> Result<Aircraft, AircraftFileError> {
    let mut text = GOOD.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "the edit {from:?} must change something");
        text = text.replacen(from, to, 1);
    }
    Aircraft::parse(&text, "small.toml")
}

/// The edited file is refused with exactly these messages: file, line, column, field, what was found and what
/// is allowed.
fn assert_messages(edits: &[(&str, &str)], messages: &[&str]) {
    let error = edited(edits).expect_err("a bad file");
    assert_eq!(error.to_string(), messages.join("\n"));
}

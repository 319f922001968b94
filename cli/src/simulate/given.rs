//! Inputs that are given on the command line: `--input elevator=2311:0.05`.

use std::str::FromStr;

use flexible_aircraft::variables::{InputSlot, VariableTable, instead_of_degrees};

use super::header;
use super::schedule::Schedule;
use super::shape::{Shape, ShapeError};
use crate::diagnostics;
use crate::numbers::Plain;

/// Fewer rows than this within a period draw another wave.
const LEAST_ROWS: f64 = 4.0;

/// An input and what it does.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// As it was given.
    text: String,
    /// Of the input.
    name: String,
    pub shape: Shape,
}

/// A text that is no `NAME=SHAPE`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotGiven {
    #[error("allowed is NAME=SHAPE, as in elevator=2311:0.05")]
    NoName,
    #[error(transparent)]
    Shape(#[from] ShapeError),
}

/// Why an input cannot be flown.
#[derive(Debug, PartialEq, thiserror::Error)]
pub enum Error {
    #[error("--input {input}: found `{name}`, allowed is {allowed}")]
    Name { input: String, name: String, allowed: String },
    #[error("--input {input}: found an amplitude of {}, allowed is {allowed}", Plain(*amplitude))]
    Degrees { input: String, amplitude: f64, allowed: String },
    #[error(
        "--input {input}: found `{name}` twice, allowed is once, in a column of the table or in one --input"
    )]
    Twice { input: String, name: String },
    #[error(
        "--input {input}: found `{other}` beside it, allowed is one of both: a shape of the wind brings its rate"
    )]
    Wind { input: String, other: String },
    #[error(
        "--input {input}: found a start at {} s, allowed is before the end of the flight, at {} s", Plain(*start), Plain(*end)
    )]
    Late { input: String, start: f64, end: f64 },
    #[error(
        "--input {input}: found {} Hz, allowed are at most {} Hz with a --step of {} s: a period has at least {LEAST_ROWS} rows",
        Plain(*frequency), Plain(1.0 / (LEAST_ROWS * step)), Plain(*step)
    )]
    Frequency { input: String, frequency: f64, step: f64 },
}

impl FromStr for Given {
    type Err = NotGiven;

    fn from_str(text: &str) -> Result<Self, NotGiven> {
        let (name, shape) = text.split_once('=').ok_or(NotGiven::NoName)?;
        Ok(Given { text: text.to_owned(), name: name.trim().to_owned(), shape: shape.trim().parse()? })
    }
}

impl Given {
    /// What a schedule becomes with this input, whose waves have rows in steps, s; with a warning where it goes on behind the end.
    ///
    /// # Errors
    /// When the aircraft has no such input, another table or option has it, or it cannot be what was meant.
    pub fn add_to(
        &self,
        schedule: Schedule,
        variables: &VariableTable,
        step: f64,
    ) -> Result<Schedule, Error> {
        let Given { text, name, shape } = self;
        let input = || text.clone();
        let (slot, is_surface) = header::input(name, variables).map_err(|allowed| Error::Name {
            input: input(),
            name: name.clone(),
            allowed,
        })?;
        let amplitude = shape.amplitude();
        if let Some(allowed) = instead_of_degrees(amplitude).filter(|_| is_surface) {
            return Err(Error::Degrees { input: input(), amplitude, allowed });
        }
        if schedule.has_column(name) {
            return Err(Error::Twice { input: input(), name: name.clone() });
        }
        if let Some(other) = other_of_wind(name, slot).filter(|other| schedule.has_column(other)) {
            return Err(Error::Wind { input: input(), other });
        }
        let frequency = shape.highest_frequency().filter(|frequency| frequency * step * LEAST_ROWS > 1.0);
        if let Some(frequency) = frequency {
            return Err(Error::Frequency { input: input(), frequency, step });
        }
        let (edges, end) = (shape.edges(), schedule.end());
        if let Some(start) = edges.first().copied().filter(|start| *start >= end) {
            return Err(Error::Late { input: input(), start, end });
        }
        if let Some(last) = edges.last().filter(|last| **last > end) {
            let [last, end] = [*last, end].map(Plain);
            diagnostics::warn(&format!(
                "--input {text}: it lasts until {last} s, the flight ends at {end} s"
            ));
        }
        Ok(schedule.with(name, slot, shape, step))
    }
}

/// The name of the rate of a wind, or of the wind of a rate.
fn other_of_wind(name: &str, slot: InputSlot) -> Option<String> {
    match slot {
        InputSlot::Wind(_) => Some(name.replacen("wind_", "wind_rate_", 1)),
        InputSlot::WindRate(_) => Some(name.replacen("wind_rate_", "wind_", 1)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::structure::ReducedModel;

    use super::*;

    fn small_aircraft() -> ReducedModel {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
        ReducedModel::new(&Aircraft::read(&path).unwrap(), 0).unwrap()
    }

    fn variables() -> VariableTable {
        VariableTable::new(&small_aircraft())
    }

    fn added(inputs: &[&str], schedule: Schedule) -> Result<Schedule, Error> {
        let variables = variables();
        let mut inputs = inputs.iter().map(|input| input.parse::<Given>().unwrap());
        inputs.try_fold(schedule, |schedule, input| input.add_to(schedule, &variables, 0.01))
    }

    fn parsed(table: &str) -> Schedule {
        Schedule::parse(table.as_bytes(), &variables()).unwrap()
    }

    #[test]
    fn a_shape_is_the_table_that_people_would_write() {
        let given = added(&["elevator=2311:0.05@1:0.7"], Schedule::hands_off(10.0)).unwrap();
        let head = "time,elevator,der(elevator)\n0,0,0\n1,0.05,0\n2.4,-0.05,0\n4.5,0.05,0\n5.2,-0.05,0\n";
        let table = parsed(&format!("{head}5.9,0,0\n10,0,0\n"));
        let model = small_aircraft();
        assert_eq!(given.histories(&model), table.histories(&model));
        assert_eq!((given.len(), given.end()), (7, 10.0));
    }

    #[test]
    fn an_input_that_cannot_be_flown_is_refused_by_name() {
        let hands_off = || Schedule::hands_off(10.0);
        let refused = |inputs: &[&str], schedule: Schedule| added(inputs, schedule).unwrap_err().to_string();
        for (inputs, expected) in [
            (
                &["elevatr=step:0.1"][..],
                "--input elevatr=step:0.1: found `elevatr`, allowed is an input, did you mean `elevator`?; there are elevator, ",
            ),
            (
                &["airspeed=step:1"][..],
                "found `airspeed`, allowed is an input; it is a parameter: --set airspeed=VALUE",
            ),
            (&["load_factor.z=step:1"][..], "allowed is an input; it is an output, which is computed"),
            (
                &["elevator=step:5"][..],
                "--input elevator=step:5: found an amplitude of 5, allowed is -1.6 to 1.6 rad: inputs are rad; 5 looks like degrees",
            ),
            (
                &["elevator=step:0.1", "elevator=step:0.2"][..],
                "--input elevator=step:0.2: found `elevator` twice, allowed is once, in a column of the table or in one --input",
            ),
            (
                &["wind_down=step:1", "wind_rate_down=step:1"][..],
                "--input wind_rate_down=step:1: found `wind_down` beside it, allowed is one of both",
            ),
            (
                &["elevator=step:0.1@10"][..],
                "found a start at 10 s, allowed is before the end of the flight, at 10 s",
            ),
            (
                &["elevator=sine:0.1@1:26"][..],
                "found 26 Hz, allowed are at most 25 Hz with a --step of 0.01 s",
            ),
        ] {
            let error = refused(inputs, hands_off());
            assert!(error.contains(expected), "{inputs:?}: {error}");
        }
        let error = refused(&["elevator=step:0.1"], parsed("time,elevator\n0,0\n9,0\n"));
        assert!(error.contains("found `elevator` twice"), "{error}");
        let error = refused(&["wind_down=step:1"], parsed("time,wind_rate_down\n0,0\n9,0\n"));
        assert!(error.contains("found `wind_rate_down` beside it"), "{error}");
        added(&["thrust_only=step:5000", "wind_down=step:-5"], hands_off()).unwrap();
        assert_eq!("elevator".parse::<Given>().unwrap_err(), NotGiven::NoName);
        let error = "elevator=flap:1".parse::<Given>().unwrap_err().to_string();
        assert!(error.starts_with("found the shape `flap`"), "{error}");
    }
}

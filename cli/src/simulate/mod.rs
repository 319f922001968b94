//! `flexair simulate`: a flight with the Rust library alone, stepped and steered as an FMI master would do it with
//! the FMU, under the same names.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::simulation::{Inputs, Settings, Simulation, SimulationError};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft::variables::{OutputSlot, Slot, VariableTable};

use crate::diagnostics;

mod parameter;
mod schedule;

use schedule::{Mistake, Schedule};

/// Options of `flexair simulate`.
#[derive(Args)]
pub struct SimulateOptions {
    /// Comma-separated values: `time` (s), then any inputs of the FMU, and `der(…)` of inputs that ramp. Each row
    /// is a communication point; its inputs act until the next
    #[arg(value_name = "INPUTS")]
    inputs: PathBuf,

    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value = "aircraft/generic-business-jet.toml")]
    aircraft: PathBuf,

    /// How many natural modes to reduce the aircraft to, as in `flexair package` [default: 26, or all where there are
    /// fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// A parameter of the FMU, as in `model=rigid`. May be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,

    /// The file to write all outputs to, a row per communication point, as a master reads them at the end of the
    /// step that leads there [default: standard output]
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Why `flexair simulate` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("--set {0}")]
    Parameter(#[from] parameter::Mistake),
    #[error("{}: cannot read the inputs: {source}", path.display())]
    Read { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Inputs { path: PathBuf, source: Mistake },
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error("{}: cannot write the outputs: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
}

impl Error {
    /// For people, on a terminal.
    pub fn report(&self) -> String {
        match self {
            Error::Aircraft(error) => diagnostics::render(error),
            other => format!("error: {other}"),
        }
    }
}

/// Flies, and writes what comes out.
pub fn run(options: &SimulateOptions) -> Result<(), Error> {
    let count = ModeCount::asked_or_usual(options.modes, ReducedModel::USUAL_MODES);
    let model = Arc::new(ReducedModel::new(&Aircraft::read(&options.aircraft)?, count)?);
    let variables = VariableTable::new(&model);
    let mut settings = Settings::of(&model);
    for assignment in &options.set {
        parameter::set(assignment, &variables, &mut settings)?;
    }
    let path = &options.inputs;
    let text = std::fs::read_to_string(path).map_err(|source| Error::Read { path: path.clone(), source })?;
    let schedule =
        Schedule::parse(&text, &variables).map_err(|source| Error::Inputs { path: path.clone(), source })?;

    let path = options.output.as_deref().unwrap_or(Path::new("standard output"));
    let write_error = |source| Error::Write { path: path.to_owned(), source };
    let mut sink: Box<dyn Write> = match &options.output {
        Some(path) => Box::new(BufWriter::new(File::create(path).map_err(write_error)?)),
        None => Box::new(BufWriter::new(io::stdout().lock())),
    };
    let flown = fly(model, &settings, &schedule, &variables, &mut sink);
    let flushed = sink.flush().map_err(write_error);
    match flown {
        Ok(()) => flushed,
        Err(Interruption::Flight(error)) => Err(Error::Flight(error)),
        Err(Interruption::Sink(source)) => Err(write_error(source)),
    }
}

/// Why a flight did not reach the end of its schedule.
#[derive(Debug, thiserror::Error)]
enum Interruption {
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error(transparent)]
    Sink(#[from] io::Error),
}

/// Writes a line of names, then a line of numbers for each communication point that is reached.
fn fly(
    model: Arc<ReducedModel>,
    settings: &Settings,
    schedule: &Schedule,
    variables: &VariableTable,
    sink: &mut impl Write,
) -> Result<(), Interruption> {
    let (names, slots): (Vec<&str>, Vec<OutputSlot>) = variables
        .iter()
        .filter_map(|(_, variable)| match variable.slot {
            Slot::Output(slot) => Some((variable.name.as_str(), slot)),
            _ => None,
        })
        .unzip();
    let engines = model.engines.len();
    let (mut inputs, mut rates) = (Inputs::zero(engines), Inputs::zero(engines));
    let mut flight = Simulation::new(model, settings, schedule.start())?;
    for exceeded in flight.limits_exceeded() {
        let Settings { airspeed, altitude, .. } = settings;
        diagnostics::warn(&format!("the trim at {airspeed} m/s and {altitude} m stands, but {exceeded}"));
    }
    schedule.write(0, &mut inputs, &mut rates);
    flight.set_inputs(&inputs, &rates);
    writeln!(sink, "time,{}", names.join(","))?;
    for (point, time) in schedule.times().enumerate() {
        flight.advance_to(time)?;
        let trim = *flight.trim();
        let outputs = flight.outputs();
        // The shortest digits that give the same bits again.
        write!(sink, "{time:e}")?;
        for slot in &slots {
            write!(sink, ",{:e}", slot.get(outputs, &trim))?;
        }
        writeln!(sink)?;
        // Where a row sets the rate of the wind alone, the wind goes on from what it is.
        flight.write_inputs(&mut inputs);
        schedule.write(point, &mut inputs, &mut rates);
        flight.set_inputs(&inputs, &rates);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines that a flight of the generic business jet writes, and how it ended.
    fn lines(inputs: &str) -> (Vec<String>, Result<(), Interruption>) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let model = Arc::new(ReducedModel::new(&Aircraft::read(&path).unwrap(), 4).unwrap());
        let variables = VariableTable::new(&model);
        let settings = Settings { mode_count: 4, ..Settings::of(&model) };
        let schedule = Schedule::parse(inputs, &variables).unwrap();
        let mut sink = Vec::new();
        let flown = fly(model, &settings, &schedule, &variables, &mut sink);
        (String::from_utf8(sink).unwrap().lines().map(String::from).collect(), flown)
    }

    fn value(lines: &[String], name: &str, row: usize) -> f64 {
        let column = lines[0].split(',').position(|found| found == name).unwrap();
        lines[row + 1].split(',').nth(column).unwrap().parse().unwrap()
    }

    #[test]
    fn a_row_holds_the_outputs_at_the_end_of_the_step_that_leads_there() {
        let (lines, flown) = lines("time,elevator,der(elevator)\n0,0.01,0.2\n0.1,0.05,0\n0.2,0,0\n");
        flown.unwrap();
        assert_eq!(lines.len(), 4);
        let acting = |row| value(&lines, "surface.elevator", row) - value(&lines, "trim.elevator", 0);
        for (row, expected) in [(0, 0.01), (1, 0.03), (2, 0.05)] {
            assert!((acting(row) - expected).abs() < 1e-12, "{}", acting(row));
        }
        assert!(value(&lines, "rate.y", 2) < -1e-3);
    }

    #[test]
    fn a_flight_that_must_end_leaves_the_rows_up_to_there() {
        let (lines, flown) = lines("time,wind_north\n0,0\n0.01,400\n0.02,0\n");
        assert!(matches!(flown, Err(Interruption::Flight(SimulationError::ReverseFlow { .. }))), "{flown:?}");
        assert_eq!(lines.len(), 3);
    }

    #[test]
    fn a_gust_by_wind_rate_is_one_by_its_derivative_and_goes_on_where_only_its_rate_is_given() {
        let [by_rate, by_derivative] = ["wind_rate_down", "der(wind_down)"].map(|rate| {
            let (lines, flown) = lines(&format!("time,wind_down,{rate}\n0,0,-5\n0.1,-0.5,2\n0.2,-0.3,0\n"));
            flown.unwrap();
            lines
        });
        assert!(by_rate == by_derivative);
        let (rate_alone, flown) = lines("time,wind_rate_down\n0,-5\n0.1,2\n0.2,0\n");
        flown.unwrap();
        for row in 0..3 {
            let [alone, with] =
                [&rate_alone, &by_rate].map(|lines| value(lines, "deflection.wing_tip_right.up", row));
            assert!((alone - with).abs() < 1e-12 * with, "{row}: {alone} {with}");
        }
        let rise = |lines: &[String]| value(lines, "air.alpha", 1) - value(lines, "air.alpha", 0);
        assert!(rise(&rate_alone) > 0.5 / 127.0 / 2.0, "{}", rise(&rate_alone));
    }
}

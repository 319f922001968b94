//! `flexair simulate`: a flight with the Rust library alone, stepped and steered as an FMI master would do it with
//! the FMU, under the same names.

use std::fs::File;
use std::io::{self, ErrorKind, IsTerminal, Read};
use std::path::{Path, PathBuf};

use clap::Args;
use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;

use crate::files::{Overwriting, STANDARD, Sink, named, refuse_overwriting};
use crate::flown::{self, FlownOptions, seconds};
use crate::numbers::NumberTable;
use crate::progress::Progress;
use crate::{terminal, workspace};

mod flight;
mod header;
pub mod schedule;

use flight::{Flight, Interruption};
use schedule::{Mistake, Schedule};

/// More rows than anybody reads: more than a day in steps of 10 ms.
const MOST_ROWS: f64 = 1e7;

/// Bytes of a table of inputs.
const MOST_BYTES: u64 = 1 << 30;

/// Options of `flexair simulate`.
#[derive(Args)]
pub struct SimulateOptions {
    /// Comma-separated values: `time` (s), then any inputs of the FMU, and `der(…)` of inputs that ramp. Each row
    /// is a communication point; its inputs act until the next. `-` is standard input
    #[arg(value_name = "INPUTS")]
    inputs: PathBuf,

    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// Further communication points between the rows, at all multiples of this, s; the inputs of the row before go on
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    step: Option<f64>,

    /// The file to write all outputs to, a row per communication point, as a master reads them at the end of the
    /// step that leads there. `-` is standard output
    #[arg(short, long, value_name = "FILE", default_value = STANDARD)]
    output: PathBuf,
}

/// Why `flexair simulate` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error("{}: {source}", named(path, "standard input"))]
    Inputs { path: PathBuf, source: Mistake },
    #[error("{}: found more than {MOST_BYTES} bytes, which no table of inputs has", named(.0, "standard input"))]
    Endless(PathBuf),
    #[error(
        "found a step of {step} s between rows, which makes {rows:.0} rows, allowed are {MOST_ROWS} at most"
    )]
    Rows { step: f64, rows: f64 },
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error("{source}; what was flown until then is in {}", kept.display())]
    Unfinished { source: Box<SimulationError>, kept: PathBuf },
}

/// Flies, and writes what comes out.
pub fn run(options: &SimulateOptions) -> Result<(), Error> {
    let SimulateOptions { inputs, output, step, .. } = options;
    let unfinished = unfinished(output);
    let outputs = if output == Path::new(STANDARD) { vec![&**output] } else { vec![&**output, &unfinished] };
    refuse_overwriting(&outputs, [inputs.as_path(), &options.aircraft])?;
    let aircraft = options.flown.read(&options.aircraft)?;
    let model = options.flown.reduce(&aircraft)?;
    let variables = VariableTable::new(&model);
    let settings = options.flown.settings(&variables, &model)?;
    let schedule = Schedule::parse(&read(inputs)?, &variables)
        .map_err(|source| Error::Inputs { path: inputs.clone(), source })?;
    let rows = schedule.point_count(*step);
    if let Some(step) = step.filter(|_| rows > MOST_ROWS) {
        return Err(Error::Rows { step, rows });
    }
    if schedule.len() == 1 {
        let (inputs, time) = (named(inputs, "standard input"), schedule.start());
        terminal::note(&format!(
            "note: {inputs} has one row: nothing is flown, the row written is the trim at {time} s"
        ));
    }
    let mut flight = Flight::new(model, &settings, &schedule, &variables)?;
    let progress = if output == Path::new(STANDARD) && io::stdout().is_terminal() {
        Progress::hidden()
    } else {
        Progress::new(rows as usize, "rows")
    };
    let kept = unfinished;
    match fly(&mut flight, *step, Sink::open(output)?, &progress) {
        // Who reads had enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(source) => {
            Err(FileError { action: "write to", path: named(output, "standard output").into(), source }
                .into())
        }
        Ok((Sink::Stream(_), end)) => end.map_or(Ok(()), |error| Err(error.into())),
        Ok((Sink::File(draft), None)) => Ok(draft.keep()?),
        Ok((Sink::File(draft), Some(source))) => {
            draft.keep_as(&kept)?;
            Err(Error::Unfinished { source: Box::new(source), kept })
        }
    }
}

/// What has been written to, and why the flight ended early, if it did.
fn fly(
    flight: &mut Flight<'_>,
    step: Option<f64>,
    sink: Sink,
    progress: &Progress,
) -> io::Result<(Sink, Option<SimulationError>)> {
    let mut table = NumberTable::new(sink, flight.names())?;
    let end = match flight.fly(step, &mut table, progress) {
        Ok(()) => None,
        Err(Interruption::Flight(error)) => Some(error),
        Err(Interruption::Sink(error)) => return Err(error),
    };
    Ok((table.into_sink()?, end))
}

pub fn read(inputs: &Path) -> Result<Vec<u8>, Error> {
    let failed = |source| FileError { action: "read", path: inputs.to_owned(), source };
    let reader: Box<dyn Read> = if inputs == Path::new(STANDARD) {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(inputs).map_err(failed)?)
    };
    let mut bytes = Vec::new();
    reader.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(Error::Endless(inputs.to_owned()));
    }
    Ok(bytes)
}

/// Where the rows of a flight go that did not reach its end: `flight.csv` becomes `flight.unfinished.csv`.
fn unfinished(output: &Path) -> PathBuf {
    let mut name = output.file_stem().unwrap_or_default().to_owned();
    name.push(".unfinished");
    if let Some(extension) = output.extension() {
        name.push(".");
        name.push(extension);
    }
    output.with_file_name(name)
}

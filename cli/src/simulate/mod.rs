//! `flexair simulate`: a flight with the Rust library alone, stepped and steered as an FMI master would do it with
//! the FMU, under the same names.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, ErrorKind, IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::Support;
use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::variables::{Unit, VariableTable};
use flexible_aircraft_packaging::FileError;

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, STANDARD, Sink, named, picture, refuse_overwriting};
use crate::flown::{self, FlownOptions, seconds};
use crate::numbers::NumberTable;
use crate::progress::{Audience, Progress};
use crate::watched::{NoSuchOutput, Watched};
use crate::{terminal, workspace};

mod flight;
pub mod given;
mod header;
pub mod plot;
pub mod schedule;
mod shape;

use flight::{Flight, Interruption};
use given::Given;
use plot::Recorded;
use schedule::{Mistake, Schedule};

/// More rows than anybody reads: more than a day in steps of 10 ms.
const MOST_ROWS: f64 = 1e7;

/// Bytes of a table of inputs.
const MOST_BYTES: u64 = 1 << 30;

/// Seconds that are flown without a table unless the user says otherwise, and between rows then.
const USUAL_DURATION: f64 = 10.0;
const USUAL_STEP: f64 = 0.01;

/// Options of `flexair simulate`.
#[derive(Args)]
#[command(
    after_help = "Shapes of --input; amplitudes are in the unit of the input (rad, N, m/s), times in s, frequencies in Hz:
  2311:AMPLITUDE[@START[:UNIT]]               pulses of 2, 3, 1 and 1 unit times that change sign; 3211 and others likewise
  step:AMPLITUDE[@START]                      stays
  pulse:AMPLITUDE[@START[:LENGTH]]            one pulse
  doublet:AMPLITUDE[@START[:LENGTH]]          two, one each way, of this length each
  sine:AMPLITUDE[@START[:FREQUENCY]]          goes on
  sweep:AMPLITUDE[@START[:LENGTH[:FROM:TO]]]  a sine whose frequency grows, by the same factor in equal times
START is 1, UNIT 0.7, LENGTH 1 (of a sweep 20), FREQUENCY 1, FROM 0.1 and TO 5 unless they are given. The first pulse has the sign of the \
amplitude. Sweeps and sines are straight between rows.

Inputs are those of the FMU: the controls of the aircraft file, thrust_<engine>, wind_north and so on. A step of the wind meets all of the aircraft at \
once; gusts that it flies into are built in: --set gust.shape=one_minus_cosine.

Example: an elevator 2-3-1-1, nose-up first, flown for 15 s and drawn
  flexair simulate --input elevator=2311:-0.05@1:0.7 --duration 15 --output flight.csv --plot flight.svg"
)]
pub struct SimulateOptions {
    /// Comma-separated values: `time` (s), then any inputs of the FMU, and `der(…)` of inputs that ramp. Each row
    /// is a communication point; its inputs act until the next. `-` is standard input [default: nobody touches what no
    /// --input gives]
    #[arg(value_name = "INPUTS")]
    inputs: Option<PathBuf>,

    /// An input that does what is built in, as in `elevator=2311:0.05` (see below), beside the columns of INPUTS. May be repeated
    #[arg(long, value_name = "NAME=SHAPE")]
    input: Vec<Given>,

    /// How long to fly where there is no table, s, from 0 s on [default: 10]
    #[arg(long, value_name = "SECONDS", value_parser = seconds, conflicts_with = "inputs")]
    duration: Option<f64>,

    /// The aircraft file (TOML)
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// Further communication points between the rows, at all multiples of this, s; the inputs of the row before go on [default: 0.01
    /// where there is no table, and with sweeps and sines; otherwise none]
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    step: Option<f64>,

    /// The file to write all outputs to, a row per communication point, as a master reads them at the end of the
    /// step that leads there. `-` is standard output
    #[arg(short, long, value_name = "FILE", default_value = STANDARD)]
    output: PathBuf,

    /// Where to draw pitch, load factor, upward deflections of the first stations and the inputs (SVG)
    #[arg(long, value_name = "FILE", value_parser = picture())]
    plot: Option<PathBuf>,

    /// Outputs to draw instead: names, or the first parts of them, as in `load_factor`
    #[arg(long, value_name = "NAME,NAME,…", value_delimiter = ',', requires = "plot")]
    plot_names: Vec<String>,
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
    #[error(transparent)]
    Given(#[from] given::Error),
    #[error(transparent)]
    Output(#[from] NoSuchOutput),
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

impl SimulateOptions {
    /// Between further communication points, s.
    fn step(&self) -> Option<f64> {
        let has_waves = self.input.iter().any(|given| given.shape.highest_frequency().is_some());
        self.step.or((self.inputs.is_none() || has_waves).then_some(USUAL_STEP))
    }

    /// What is given over time: in a table that somebody has, or in the file.
    fn schedule(&self, table: Option<&[u8]>, variables: &VariableTable) -> Result<Schedule, Error> {
        let table = match &self.inputs {
            Some(path) => {
                let bytes =
                    table.map_or_else(|| read(path).map(Cow::Owned), |table| Ok(Cow::Borrowed(table)))?;
                Schedule::parse(&bytes, variables)
                    .map_err(|source| Error::Inputs { path: path.clone(), source })?
            }
            None => Schedule::hands_off(self.duration.unwrap_or(USUAL_DURATION)),
        };
        if let (Some(path), 1) = (&self.inputs, table.len()) {
            let (inputs, time) = (named(path, "standard input"), table.start());
            terminal::note(&format!(
                "note: {inputs} has one row: nothing is flown, the row written is the trim at {time} s"
            ));
        }
        let step = self.step();
        let rows = table.point_count(step);
        if let Some(step) = step.filter(|_| rows > MOST_ROWS) {
            return Err(Error::Rows { step, rows });
        }
        let step = step.unwrap_or(USUAL_STEP);
        Ok(self.input.iter().try_fold(table, |table, given| given.add_to(table, variables, step))?)
    }

    /// What is to be drawn.
    fn recorded(
        &self,
        variables: &VariableTable,
        support: Support,
        rows: f64,
    ) -> Result<Option<Recorded>, Error> {
        let outputs = match self.plot_names.as_slice() {
            [] => plot::usual(variables, support),
            names => Watched::choose("--plot-names", names, variables)?,
        };
        Ok(self.plot.as_ref().map(|_| Recorded::new(outputs, rows)))
    }
}

/// Flies, and writes and draws what comes out.
pub fn run(options: &SimulateOptions) -> Result<(), Error> {
    let SimulateOptions { output, plot, .. } = options;
    let unfinished = unfinished(output);
    let mut outputs = vec![output.as_path()];
    outputs.extend(Some(unfinished.as_path()).filter(|_| output != Path::new(STANDARD)));
    outputs.extend(plot.as_deref());
    let inputs = [options.inputs.as_deref(), Some(options.aircraft.as_path())];
    refuse_overwriting(&outputs, inputs.into_iter().flatten())?;
    let drawing = plot.as_deref().map(|plot| Drafts::new([plot])).transpose()?;
    let aircraft = options.flown.read(&options.aircraft)?;
    let model = options.flown.reduce(&aircraft)?;
    let variables = VariableTable::new(&model);
    let settings = options.flown.settings(&variables, &model)?;
    let schedule = options.schedule(None, &variables)?;
    let rows = schedule.point_count(options.step());
    let mut recorded = options.recorded(&variables, model.support, rows)?;
    let mut flight = Flight::new(Arc::clone(&model), &settings, &schedule, &variables)?;
    let progress = if output == Path::new(STANDARD) && io::stdout().is_terminal() {
        Progress::hidden()
    } else {
        Progress::new(rows as usize, "rows")
    };
    let sink = Sink::open(output)?;
    // A plot is drawn for whoever reads no rows, too.
    let sink = if recorded.is_some() { sink.unheard() } else { sink };
    let flown = fly(&mut flight, options.step(), sink, recorded.as_mut(), &progress);
    let is_whole = flown.as_ref().ok().map(|(_, end)| end.is_none());
    let kept = keep(flown, output, unfinished);
    if let (Some(drawing), Some(recorded), Some(is_whole)) = (drawing, recorded, is_whole) {
        let svg = recorded.plot(&schedule, &variables, &model, &settings, is_whole);
        return kept.and(drawing.keep([svg.as_str()]).map_err(Error::from));
    }
    kept
}

/// Flies, and answers with all outputs: a row for each communication point, a column for each name. The inputs come from a
/// table in place of the file where there is one.
pub fn answer(options: &SimulateOptions, table: Option<&[u8]>, audience: &Audience) -> Result<Answer, Error> {
    let model = options.flown.reduce(&options.flown.read(&options.aircraft)?)?;
    let variables = VariableTable::new(&model);
    let settings = options.flown.settings(&variables, &model)?;
    let schedule = options.schedule(table, &variables)?;
    let rows = schedule.point_count(options.step());
    let mut flight = Flight::new(Arc::clone(&model), &settings, &schedule, &variables)?;
    let values = flight.record(options.step(), &audience.progress(rows as usize, "rows"))?;
    let names: Vec<String> = flight.names().map(str::to_owned).collect();
    let unit = |name: &String| {
        let variable = variables.iter().find(|(_, variable)| variable.name == *name);
        variable.map_or("s", |(_, variable)| variable.unit.map_or("", Unit::name)).to_owned()
    };
    Ok(Answer::named([
        ("units", Answer::Texts(names.iter().map(unit).collect())),
        ("values", Answer::Matrix { rows: values.len() / names.len(), columns: names.len(), values }),
        ("names", Answer::Texts(names)),
    ]))
}

/// Keeps what has been written, under another name where the flight ended early.
fn keep(
    flown: io::Result<(Sink, Option<SimulationError>)>,
    output: &Path,
    unfinished: PathBuf,
) -> Result<(), Error> {
    match flown {
        // Who reads had enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(source) => {
            Err(FileError { action: "write to", path: named(output, "standard output").into(), source }
                .into())
        }
        Ok((Sink::Stream(_), end)) => end.map_or(Ok(()), |error| Err(error.into())),
        Ok((Sink::File(draft), None)) => Ok(draft.keep()?),
        Ok((Sink::File(draft), Some(source))) => {
            draft.keep_as(&unfinished)?;
            Err(Error::Unfinished { source: Box::new(source), kept: unfinished })
        }
    }
}

/// What has been written to, and why the flight ended early, if it did.
fn fly(
    flight: &mut Flight<'_>,
    step: Option<f64>,
    sink: Sink,
    recorded: Option<&mut Recorded>,
    progress: &Progress,
) -> io::Result<(Sink, Option<SimulationError>)> {
    let mut table = NumberTable::new(sink, flight.names())?;
    let end = match flight.fly(step, &mut table, recorded, progress) {
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

//! `flexair reproduce`: flies the thesis' flights and lays the results beside its figures and table.

mod cases;
mod figures;
mod findings;
mod fit;
mod history;
mod page;
mod plots;
mod table;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Support};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::{ReproduceOptions, diagnostics};
use cases::{Flight, Surface};
use figures::{GROUPS, Group};
use history::{DURATION, History, Tips};
use plots::Plot;

/// Why `flexair reproduce` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("{0} is clamped in a wind tunnel: the flights need support = \"free\"")]
    Clamped(String),
    #[error("station {station} is missing, whose deflection Table 5.1 lists; the aircraft has: {found}")]
    NoStation { station: &'static str, found: String },
    #[error("cannot write {file}: {error}")]
    Write { file: PathBuf, error: std::io::Error },
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

/// What has been flown and drawn.
pub struct Reproduction {
    /// Of the aircraft.
    name: String,
    rows: Vec<table::Row>,
    /// Elevator and rudder.
    inputs: [(u8, String); 2],
    groups: Vec<(Group, Vec<Plot>)>,
    /// Flights that ended before their time, with the reason.
    ended: Vec<(Flight, String)>,
}

/// Flies, draws and writes everything.
pub fn run(options: &ReproduceOptions) -> Result<(), Error> {
    let aircraft = Aircraft::read(&options.aircraft)?;
    if aircraft.support == Support::Clamped {
        return Err(Error::Clamped(aircraft.name));
    }
    let model = Arc::new(ReducedModel::new(&aircraft, ModeCount::Usual(ReducedModel::USUAL_MODES))?);
    let histories = fly(&model, &Flight::all())?;
    let reproduction = Reproduction::new(aircraft.name, &histories);
    write_all(&options.output, &reproduction, &histories)?;
    print!("{}", table::markdown(&reproduction.rows));
    println!("{}", reproduction.summary());
    println!("{}", options.output.join("index.html").display());
    Ok(())
}

/// All flights, as many at once as there are cores, in their order.
fn fly(model: &Arc<ReducedModel>, flights: &[Flight]) -> Result<Vec<History>, Error> {
    let tips = Tips::of(model)?;
    let progress = ProgressBar::new(flights.len() as u64).with_message("flights");
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}, {elapsed}") {
        progress.set_style(style);
    }
    let fly = |&flight: &Flight| {
        let history = History::fly(model, tips, flight, DURATION);
        progress.inc(1);
        history
    };
    let histories = flights.par_iter().map(fly).collect();
    progress.finish_and_clear();
    Ok(histories)
}

impl Reproduction {
    fn new(name: String, histories: &[History]) -> Self {
        let plots = |group: &Group| group.figures().map(|figure| Plot::new(figure, histories)).collect();
        let ended = histories.iter().filter_map(|history| {
            let reason = history.end.as_ref()?.to_string();
            Some((history.flight, reason))
        });
        Reproduction {
            name,
            rows: table::rows(histories),
            inputs: [(1, Surface::Elevator), (33, Surface::Rudder)].map(|(n, s)| (n, plots::input(s))),
            groups: GROUPS.iter().map(|group| (*group, plots(group))).collect(),
            ended: ended.collect(),
        }
    }

    /// How many figures fit, in one sentence.
    fn summary(&self) -> String {
        page::count(self.groups.iter().flat_map(|(_, plots)| plots))
    }

    /// Figures 5.14–5.19: the flights in which the models differ most.
    fn overview(&self) -> String {
        let plots = self.groups.iter().flat_map(|(_, plots)| plots);
        let drawings = plots.filter(|plot| (14..=19).contains(&plot.figure.number));
        plots::side_by_side(&drawings.map(|plot| plot.svg.as_str()).collect::<Vec<_>>())
    }
}

fn write_all(output: &Path, reproduction: &Reproduction, histories: &[History]) -> Result<(), Error> {
    let (figures, flights) = (output.join("figures"), output.join("flights"));
    for folder in [&figures, &flights] {
        std::fs::create_dir_all(folder).map_err(|error| Error::Write { file: folder.clone(), error })?;
    }
    write(output.join("index.html"), &page::html(reproduction))?;
    write(output.join("overview.svg"), &reproduction.overview())?;
    write(output.join("table-5.1.md"), &table::markdown(&reproduction.rows))?;
    for (number, svg) in &reproduction.inputs {
        write(figures.join(format!("figure-5.{number:02}-input.svg")), svg)?;
    }
    for plot in reproduction.groups.iter().flat_map(|(_, plots)| plots) {
        write(figures.join(plot.figure.file_name()), &plot.svg)?;
    }
    for history in histories {
        write(flights.join(format!("{}.csv", history.flight.slug())), &history.to_csv())?;
    }
    Ok(())
}

fn write(file: PathBuf, content: &str) -> Result<(), Error> {
    std::fs::write(&file, content).map_err(|error| Error::Write { file, error })
}

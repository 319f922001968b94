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
use cases::{Case, Flight, Surface};
use figures::{GROUPS, Group};
use history::{DURATION, History, Tips};
use plots::Plot;
use table::Table;

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
    table: Table,
    /// Elevator and rudder.
    inputs: [(u8, String); 2],
    sections: Vec<Section>,
    /// Flights that ended before their time, with the reason.
    ended: Vec<(Flight, String)>,
}

/// A group of figures with what they show.
struct Section {
    group: Group,
    plots: Vec<Plot>,
    /// Computed from the flights, one sentence each.
    findings: Vec<String>,
}

/// Flies, draws and writes everything.
pub fn run(options: &ReproduceOptions) -> Result<(), Error> {
    let aircraft = Aircraft::read(&options.aircraft)?;
    if aircraft.support == Support::Clamped {
        return Err(Error::Clamped(aircraft.name));
    }
    let model = Arc::new(ReducedModel::new(&aircraft, ModeCount::Usual(ReducedModel::USUAL_MODES))?);
    let histories = fly(&model, &Flight::all())?;
    let reproduction = Reproduction::new(&aircraft, &histories);
    write_all(&options.output, &reproduction, &histories)?;
    print!("{}", reproduction.table.markdown());
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
    fn new(aircraft: &Aircraft, histories: &[History]) -> Self {
        let section = |group: &Group| {
            let plots: Vec<Plot> = group.figures().map(|figure| Plot::new(figure, histories)).collect();
            let findings = findings::of(group, &plots, histories);
            Section { group: *group, plots, findings }
        };
        let ended = histories.iter().filter_map(|history| {
            let reason = history.end.as_ref()?.to_string();
            Some((history.flight, reason))
        });
        Reproduction {
            name: aircraft.name.clone(),
            table: Table::new(is_shipped(aircraft), histories),
            inputs: [(1, Surface::Elevator), (33, Surface::Rudder)].map(|(n, s)| (n, plots::input(s))),
            sections: GROUPS.iter().map(section).collect(),
            ended: ended.collect(),
        }
    }

    fn plots(&self) -> impl Iterator<Item = &Plot> {
        self.sections.iter().flat_map(|section| &section.plots)
    }

    /// How many figures fit, in one sentence.
    fn summary(&self) -> String {
        page::count(self.plots())
    }

    /// Figures 5.14–5.19: the flights in which the models differ most.
    fn overview(&self) -> String {
        let drawings = self.plots().filter(|plot| (14..=19).contains(&plot.figure.number));
        let panels: Vec<&str> = drawings.map(|plot| plot.panel.as_str()).collect();
        plots::overview(&format!("{}: {}", self.name, Case::ElevatorTenthFast.title()), &panels)
    }
}

/// Whether it is the aircraft that comes with the program, which others have computed too.
fn is_shipped(aircraft: &Aircraft) -> bool {
    let file = include_str!("../../../aircraft/generic-business-jet.toml");
    Aircraft::parse(file, "generic-business-jet.toml").is_ok_and(|shipped| shipped == *aircraft)
}

fn write_all(output: &Path, reproduction: &Reproduction, histories: &[History]) -> Result<(), Error> {
    let (figures, flights) = (output.join("figures"), output.join("flights"));
    for folder in [&figures, &flights] {
        std::fs::create_dir_all(folder).map_err(|error| Error::Write { file: folder.clone(), error })?;
    }
    write(output.join("index.html"), &page::html(reproduction))?;
    write(output.join("overview.svg"), &reproduction.overview())?;
    write(output.join("table-5.1.md"), &reproduction.table.markdown())?;
    for (number, svg) in &reproduction.inputs {
        write(figures.join(format!("figure-5.{number:02}-input.svg")), svg)?;
    }
    for plot in reproduction.plots() {
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

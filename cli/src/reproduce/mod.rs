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
use flexible_aircraft_packaging::FileError;
use rayon::prelude::*;

use crate::files::{Overwriting, refuse_overwriting};
use crate::progress::Progress;
use crate::{ReproduceOptions, diagnostics, files, terminal};
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
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(transparent)]
    File(#[from] FileError),
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
    write_all(options, &reproduction, &histories)?;
    let (table, page) = (table::markdown(&reproduction.rows), options.output.join("index.html"));
    Ok(terminal::print(&format!("{table}{}\n{}\n", reproduction.summary(), page.display()))?)
}

/// All flights, as many at once as there are cores, in their order.
fn fly(model: &Arc<ReducedModel>, flights: &[Flight]) -> Result<Vec<History>, Error> {
    let tips = Tips::of(model)?;
    let progress = Progress::new(flights.len(), "flights");
    let fly = |&flight: &Flight| {
        let history = History::fly(model, tips, flight, DURATION);
        progress.advance();
        history
    };
    Ok(flights.par_iter().map(fly).collect())
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

/// All files of the page, with their names in the folder.
fn write_all(
    options: &ReproduceOptions,
    reproduction: &Reproduction,
    histories: &[History],
) -> Result<(), Error> {
    let mut contents = vec![
        ("index.html".to_owned(), page::html(reproduction)),
        ("overview.svg".to_owned(), reproduction.overview()),
        ("table-5.1.md".to_owned(), table::markdown(&reproduction.rows)),
    ];
    let inputs = reproduction.inputs.iter();
    contents.extend(inputs.map(|(n, svg)| (format!("figures/figure-5.{n:02}-input.svg"), svg.clone())));
    let plots = reproduction.groups.iter().flat_map(|(_, plots)| plots);
    contents.extend(plots.map(|plot| (format!("figures/{}", plot.figure.file_name()), plot.svg.clone())));
    let flights = histories.iter();
    contents
        .extend(flights.map(|history| (format!("flights/{}.csv", history.flight.slug()), history.to_csv())));
    let paths: Vec<PathBuf> = contents.iter().map(|(name, _)| options.output.join(name)).collect();
    let outputs: Vec<&Path> = paths.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&outputs, [options.aircraft.as_path()])?;
    outputs
        .into_iter()
        .zip(&contents)
        .try_for_each(|(path, (_, content))| files::write(path, content.as_bytes()))?;
    Ok(())
}

//! `flexair reproduce`: flies the thesis' flights and lays the results beside its figures and table.

mod cases;
mod figures;
mod findings;
mod fit;
mod history;
mod page;
mod plots;
mod table;
mod wings;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Support};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft_packaging::FileError;
use rayon::prelude::*;

use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::progress::Progress;
use crate::{ReproduceOptions, diagnostics, terminal};
use cases::{Case, Flight, Surface};
use figures::{GROUPS, Group};
use history::{DURATION, History, Places};
use plots::Plot;
use table::Table;
use wings::Wing;

/// The figures that show the inputs.
const INPUTS: [(u8, Surface); 2] = [(1, Surface::Elevator), (33, Surface::Rudder)];

/// Why `flexair reproduce` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("{0} is clamped in a wind tunnel: the flights need support = \"free\"")]
    Clamped(String),
    #[error("station {station} is missing, whose deflection Table 5.1 lists; the aircraft has: {found}")]
    NoStation { station: &'static str, found: String },
    #[error("no control has trim = \"{role}\", and the flights move one for pitch and one for yaw")]
    NoControl { role: &'static str },
    #[error(transparent)]
    Wings(#[from] wings::Error),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(transparent)]
    File(#[from] FileError),
}

/// What has been flown and drawn.
pub struct Reproduction {
    /// Of the aircraft.
    name: String,
    table: Table,
    /// Elevator and rudder.
    inputs: [(u8, String); 2],
    sections: Vec<Section>,
    /// Not of the thesis, and of no aircraft that is asked for.
    wings: [Wing; 3],
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
    let aircraft = diagnostics::read_aircraft(&options.aircraft)?;
    if aircraft.support == Support::Clamped {
        return Err(Error::Clamped(aircraft.name));
    }
    let model = Arc::new(ReducedModel::new(&aircraft, ModeCount::Usual(ReducedModel::USUAL_MODES))?);
    let paths: Vec<PathBuf> = file_names().iter().map(|name| options.output.join(name)).collect();
    let outputs: Vec<&Path> = paths.iter().map(PathBuf::as_path).collect();
    refuse_overwriting(&outputs, [options.aircraft.as_path()])?;
    let drafts = Drafts::new(outputs)?;
    let histories = fly(&model, &Flight::all())?;
    let reproduction = Reproduction::new(&aircraft, &histories, wings::all()?);
    drafts.keep(contents(&reproduction, &histories).iter().map(String::as_str))?;
    let (table, page) = (reproduction.table.markdown(), options.output.join("index.html"));
    Ok(terminal::print(&format!("{table}{}\n{}\n", reproduction.summary(), page.display()))?)
}

/// All flights, as many at once as there are cores, in their order.
fn fly(model: &Arc<ReducedModel>, flights: &[Flight]) -> Result<Vec<History>, Error> {
    let places = Places::of(model)?;
    let progress = Progress::new(flights.len(), "flights");
    let fly = |&flight: &Flight| {
        let history = History::fly(model, places, flight, DURATION);
        progress.advance();
        history
    };
    Ok(flights.par_iter().map(fly).collect())
}

impl Reproduction {
    fn new(aircraft: &Aircraft, histories: &[History], wings: [Wing; 3]) -> Self {
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
            inputs: INPUTS
                .map(|(number, surface)| (number, plots::input(surface, name_of(surface, aircraft)))),
            sections: GROUPS.iter().map(section).collect(),
            wings,
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

    /// The wings of others with what they found, one below the other.
    fn wings_of_others(&self) -> String {
        let [patil, pazy, _] = &self.wings;
        plots::column(&[patil.chart.to_svg(), pazy.chart.to_svg()])
    }
}

/// Whether it is the aircraft that comes with the program, which others have computed too.
fn is_shipped(aircraft: &Aircraft) -> bool {
    let file = include_str!("../../../aircraft/generic-business-jet.toml");
    Aircraft::parse(file, "generic-business-jet.toml").is_ok_and(|shipped| shipped == *aircraft)
}

/// The names in the folder of all files of the page.
fn file_names() -> Vec<String> {
    let whole = ["index.html", "overview.svg", "wings.svg", "table-5.1.md"].map(str::to_owned);
    let inputs = INPUTS.map(|(number, _)| format!("figures/figure-5.{number:02}-input.svg"));
    let figures = GROUPS.iter().flat_map(Group::figures);
    let flights = Flight::all().into_iter();
    whole
        .into_iter()
        .chain(inputs)
        .chain(figures.map(|figure| format!("figures/{}", figure.file_name())))
        .chain(flights.map(|flight| format!("flights/{}.csv", flight.slug())))
        .collect()
}

/// The control of an aircraft that moves in place of a surface.
fn name_of(surface: Surface, aircraft: &Aircraft) -> &str {
    let mut controls = aircraft.controls.iter();
    controls
        .find(|control| control.role == Some(surface.role()))
        .map_or("no control", |control| &control.name)
}

/// What is in them, in the same order.
fn contents(reproduction: &Reproduction, histories: &[History]) -> Vec<String> {
    let drawings = [reproduction.overview(), reproduction.wings_of_others()];
    let whole = [page::html(reproduction)].into_iter().chain(drawings).chain([reproduction.table.markdown()]);
    whole
        .into_iter()
        .chain(reproduction.inputs.iter().map(|(_, svg)| svg.clone()))
        .chain(reproduction.plots().map(|plot| plot.svg.clone()))
        .chain(histories.iter().map(History::to_csv))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_page_has_the_content_of_its_name() {
        let file = include_str!("../../../aircraft/generic-business-jet.toml");
        let aircraft = Aircraft::parse(file, "generic-business-jet.toml").unwrap();
        let model = Arc::new(ReducedModel::new(&aircraft, 12).unwrap());
        let places = Places::of(&model).unwrap();
        let fly = |&flight: &Flight| History::fly(&model, places, flight, 0.1);
        let histories: Vec<History> = Flight::all().iter().map(fly).collect();
        let reproduction = Reproduction::new(&aircraft, &histories, wings::all().unwrap());
        let (names, contents) = (file_names(), contents(&reproduction, &histories));
        assert_eq!(names.len(), contents.len());
        let content = |name: String| &contents[names.iter().position(|found| *found == name).unwrap()];
        for plot in reproduction.plots() {
            assert!(*content(format!("figures/{}", plot.figure.file_name())) == plot.svg);
        }
        for history in &histories {
            assert!(*content(format!("flights/{}.csv", history.flight.slug())) == history.to_csv());
        }
    }
}

//! `flexair view`: the aircraft in the browser: flights, trims, modes as the library computes them, in one page that needs no network.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::Aircraft;
use flexible_aircraft::air::{GustShape, TurbulenceSettings};
use flexible_aircraft::aircraft::{Fidelity, StationsAlongError};
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::{
    ModalBasis, ModeCount, ModeKind, ModeMotion, ReducedModel, Structure, StructureError,
};
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;

use crate::aircraft_file::AircraftFile;
use crate::files::{Drafts, Overwriting, named, picture, refuse_overwriting};
use crate::flown::{self, FlownOptions, seconds};
use crate::home::Home;
use crate::simulate::given::{self, Given};
use crate::simulate::schedule::{Mistake, Schedule};
use crate::simulate::{self, plot};
use crate::terminal;
use crate::watched::{NoSuchOutput, Watched};

mod airframe;
pub mod archive;
mod body;
mod data;
mod flap;
mod flights;
mod gltf;
mod gust;
mod low_rank;
mod outline;
mod page;
mod plan;
mod rate;
mod recording;
mod roots;
mod scene;
mod shapes;
mod show;
mod vtk;

use airframe::Airframe;
use data::Data;
use gltf::NotLinear;
use page::{Content, TooLarge};
use rate::TooManyFrames;
use roots::RootError;
use show::{Kind, Show};

/// Seconds that are flown without a table unless the user says otherwise.
const USUAL_DURATION: f64 = 10.0;

/// Options of `flexair view`.
#[derive(Args)]
#[command(after_help = "\
A flight is shown where any of --flight, --input, --duration, --compare is given, or --set switches on a gust or turbulence \
(--set gust.shape=one_minus_cosine); without any of these and of --trim, --mode-shapes, --root the page shows the trim and the mode shapes.

The page draws what the library computed: sections of the structure, strips, flaps, engines and stations at each frame, whatever the level of \
fidelity, colours by lift, section loads, twist and acceleration, and charts of outputs. It opens from disk in any browser.

Examples: trim and modes; a gust; two levels of fidelity in an elevator 2-3-1-1; the phugoid
  flexair view
  flexair view --set gust.shape=one_minus_cosine --duration 6
  flexair view --input elevator=2311:-0.05 --compare exact,geometrically_exact
  flexair view --root phugoid --root \"Dutch roll\"")]
pub struct ViewOptions {
    #[command(flatten)]
    file: AircraftFile,

    #[command(flatten)]
    flown: FlownOptions,

    /// Show a flight with these inputs: a table as `flexair simulate` reads it; `-` is standard input
    #[arg(long, value_name = "INPUTS")]
    flight: Option<PathBuf>,

    /// Show a flight with an input that does what is built in, as in `elevator=2311:0.05`, as `flexair simulate` has them. May be repeated
    #[arg(long, value_name = "NAME=SHAPE")]
    input: Vec<Given>,

    /// How long to fly where there is no table, s [default: 10]
    #[arg(long, value_name = "SECONDS", value_parser = seconds, conflicts_with = "flight")]
    duration: Option<f64>,

    /// Poses a second of flights
    #[arg(long, value_name = "PER_SECOND", value_parser = rate::parse, default_value_t = 50.0)]
    rate: f64,

    /// Show the flight at two levels of fidelity, the second as a ghost beside the first
    #[arg(long, value_name = "LEVEL,LEVEL", value_parser = two_levels)]
    compare: Option<[Fidelity; 2]>,

    /// An output to chart: its name, or the first parts of it, as in `load_factor`; --output is the page itself. May be repeated [default:
    /// pitch, load factor, upward deflections of the first stations]
    #[arg(long, value_name = "NAME")]
    output_name: Vec<String>,

    /// Show the trim, beside the undeformed aircraft
    #[arg(long)]
    trim: bool,

    /// Show the natural modes and load modes that fly, with frequency, family and what moves; --modes says how many there are
    #[arg(long)]
    mode_shapes: bool,

    /// Show a mode of the aircraft in flight, by the name or the number that `flexair linearise` gives it: phugoid, "elastic 1". May be
    /// repeated
    #[arg(long, value_name = "NAME|NUMBER")]
    root: Vec<String>,

    /// Also write files for ParaView into a folder: of each show strips with lift and beams with section loads, a .vtu for each frame and
    /// .pvd that list them over time
    #[arg(long, value_name = "DIR", value_parser = picture())]
    vtk: Option<PathBuf>,

    /// Also write the aircraft for game engines: a skeleton with a skin that the FMU's outputs drive, an animation for each show
    #[arg(long, value_name = "FILE.glb", value_parser = gltf::path())]
    gltf: Option<PathBuf>,

    /// Also write it as one mesh with a morph target for each mode and each control; not for the level geometrically_exact
    #[arg(long, value_name = "FILE.glb", value_parser = gltf::path())]
    gltf_morph: Option<PathBuf>,

    /// Add stations along a component, as `flexair package` does: joints of --gltf have their names, wing_right_01 and on. May be repeated
    #[arg(long, value_name = "COMPONENT=COUNT", value_parser = crate::component_and_count)]
    stations_along: Vec<(String, usize)>,

    /// The page to write [default: target/view/ with the aircraft file's name, or flexair-out/view/ where flexair is installed]
    #[arg(short, long, value_name = "FILE.html", value_parser = picture())]
    output: Option<PathBuf>,
}

/// Why there is no page.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error("--stations-along {component}: {source}")]
    StationsAlong { component: String, source: StationsAlongError },
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("{}: {source}", named(path, "standard input"))]
    Inputs { path: PathBuf, source: Mistake },
    #[error(transparent)]
    Unreadable(#[from] simulate::Error),
    #[error(transparent)]
    Given(#[from] given::Error),
    #[error(transparent)]
    Output(#[from] NoSuchOutput),
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error(transparent)]
    Root(#[from] RootError),
    #[error(transparent)]
    Frames(#[from] TooManyFrames),
    #[error(transparent)]
    NotLinear(#[from] NotLinear),
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    #[error("the page could not be compressed: {0}")]
    Compressing(#[from] io::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// What is viewed.
struct View {
    airframe: Airframe,
    /// Of the airframe, with its stations and cuts.
    model: Arc<ReducedModel>,
    /// Of its modes.
    motions: Vec<ModeMotion>,
    /// The variables of the aircraft as its file has it, and of the airframe.
    variables: [VariableTable; 2],
    settings: Settings,
}

/// Computes what is to be shown, and writes the page and what is asked for beside it.
pub fn run(options: &ViewOptions, home: &Home) -> Result<(), Error> {
    let output = options.output(home);
    let table = options.flight.as_deref();
    let outputs: Vec<&Path> = [Some(&output), options.gltf.as_ref(), options.gltf_morph.as_ref()]
        .into_iter()
        .flatten()
        .map(PathBuf::as_path)
        .collect();
    let places: Vec<&Path> = outputs.iter().copied().chain(options.vtk.as_deref()).collect();
    refuse_overwriting(&places, [Some(options.file.path()), table].into_iter().flatten())?;
    if let Some(folder) = &options.vtk {
        vtk::check(folder)?;
    }
    let drafts = Drafts::new(outputs.iter().copied())?;
    let aircraft = options.aircraft()?;
    let settings = |variables: &VariableTable, model: &ReducedModel| options.flown.settings(variables, model);
    let view = View::new(&aircraft, options.flown.count(), settings)?;
    let levels = options.levels(&view);
    if options.gltf_morph.is_some() {
        gltf::check_linear(&levels)?;
    }
    let shows = options.shows(&view)?;
    let flights = shows.iter().filter(|show| show.kind == Kind::Flight).count().max(1);
    let page = view.page(&shows)?;
    if let Some(note) = page::check(page.len(), flights, options.rate)? {
        terminal::note(&note);
    }
    if let Some(folder) = &options.vtk {
        for list in vtk::write(&view.airframe, &shows, folder)? {
            terminal::print(&format!("{}\n", list.display()))?;
        }
    }
    let is_linear = gltf::check_linear(&levels).is_ok();
    let skeleton = options.gltf.as_ref().map(|_| gltf::skeleton(&view, &shows, is_linear));
    let morph = options.gltf_morph.as_ref().map(|_| gltf::morph(&view));
    drafts.keep([Some(page.into_bytes()), skeleton, morph].into_iter().flatten())?;
    for output in outputs {
        terminal::print(&format!("{}\n", output.display()))?;
    }
    Ok(())
}

impl ViewOptions {
    /// That of the file, with the stations that are asked for.
    fn aircraft(&self) -> Result<Aircraft, Error> {
        let mut aircraft = self.flown.read(self.file.path())?;
        for (component, count) in &self.stations_along {
            let failed = |source| Error::StationsAlong { component: component.clone(), source };
            aircraft.add_stations_along(component, *count).map_err(failed)?;
        }
        Ok(aircraft)
    }

    fn output(&self, home: &Home) -> PathBuf {
        let name = self.file.path().file_stem().unwrap_or_default().to_string_lossy();
        let usual = || home.output("view", &Path::new("target/view").join(format!("{name}.html")));
        self.output.clone().unwrap_or_else(usual)
    }

    /// Whether a flight is asked for.
    fn flies(&self, settings: &Settings) -> bool {
        self.flight.is_some()
            || !self.input.is_empty()
            || self.duration.is_some()
            || self.compare.is_some()
            || settings.gust.shape != GustShape::None
            || settings.turbulence != TurbulenceSettings::default()
    }

    /// All that is asked for, flights first.
    fn shows(&self, view: &View) -> Result<Vec<Show>, Error> {
        let flies = self.flies(&view.settings);
        let is_asked = flies || self.trim || self.mode_shapes || !self.root.is_empty();
        let mut shows = if flies { self.flights(view)? } else { Vec::new() };
        if self.trim || !is_asked {
            shows.push(flights::trim(view)?);
        }
        shows.extend(roots::shows(view, &self.root)?);
        if self.mode_shapes || !is_asked {
            shows.extend(shapes::shows(view).map_err(SimulationError::from)?);
        }
        if shows.is_empty() {
            // No mode flies.
            shows.push(flights::trim(view)?);
        }
        Ok(shows)
    }

    fn flights(&self, view: &View) -> Result<Vec<Show>, Error> {
        let schedule = self.schedule(&view.variables[0])?;
        let levels = self.levels(view);
        rate::check(self.rate, schedule.duration(), levels.len() * view.airframe.sections.len())?;
        let charted = self.charted(view)?;
        let flight = |level| flights::flight(view, (&schedule, self.rate), &charted, level);
        let mut flights = levels.into_iter().map(flight).collect::<Result<Vec<Show>, _>>()?;
        if let [one, other] = flights.as_mut_slice() {
            one.ghost = Some(other.name.clone());
            other.ghost = Some(one.name.clone());
        }
        Ok(flights)
    }

    /// At which it flies.
    fn levels(&self, view: &View) -> Vec<Fidelity> {
        self.compare.map_or_else(|| vec![view.settings.plant.fidelity], |two| two.to_vec())
    }

    fn schedule(&self, variables: &VariableTable) -> Result<Schedule, Error> {
        let table = match &self.flight {
            Some(path) => Schedule::parse(&simulate::read(path)?, variables)
                .map_err(|source| Error::Inputs { path: path.clone(), source })?,
            None => Schedule::hands_off(self.duration.unwrap_or(USUAL_DURATION)),
        };
        let step = 1.0 / self.rate;
        Ok(self.input.iter().try_fold(table, |table, given| given.add_to(table, variables, step))?)
    }

    /// The outputs that are charted, as the airframe's model has them.
    fn charted(&self, view: &View) -> Result<Vec<Watched>, Error> {
        let [own, all] = &view.variables;
        let chosen = match self.output_name.as_slice() {
            [] => plot::usual(own, view.model.support),
            names => Watched::choose("--output-name", names, own)?,
        };
        let in_airframe = |chosen: Watched| Watched::all(all).find(|output| output.name == chosen.name);
        Ok(chosen.into_iter().filter_map(in_airframe).collect())
    }
}

impl View {
    /// An aircraft with so many natural modes, that flies as its settings say.
    fn new(
        aircraft: &Aircraft,
        modes: ModeCount,
        settings: impl FnOnce(&VariableTable, &ReducedModel) -> Result<Settings, flown::Error>,
    ) -> Result<Self, Error> {
        let airframe = Airframe::new(aircraft);
        let structure = Structure::new(&airframe.aircraft)?;
        let basis = ModalBasis::with(&structure, modes, ModeKind::All)?;
        let motions = ModeMotion::of_modes(&structure, &basis.shapes);
        let model = Arc::new(ReducedModel::of_basis(&structure, basis)?);
        let mut own = ReducedModel::clone(&model);
        own.stations.truncate(airframe.named[0]);
        own.cuts.truncate(airframe.named[1]);
        let variables = [&own, &model].map(VariableTable::new);
        let settings = settings(&variables[0], &own)?;
        Ok(View { airframe, model, motions, variables, settings })
    }

    /// The page with some shows.
    fn page(&self, shows: &[Show]) -> Result<String, Error> {
        let thrusts = shows.iter().flat_map(|show| &show.recording.thrust);
        let largest = thrusts.fold(0.0_f64, |largest, thrust| largest.max(thrust.abs()));
        let mut data = Data::default();
        let mut scene = scene::scene(&self.airframe, &self.model, largest, &self.notes(shows));
        scene["shows"] = show::all(shows, &mut data).into();
        let title = &self.airframe.aircraft.name;
        let plan = plan::svg(&self.airframe);
        Ok(Content { title, plan: &plan, scene: &scene, data: &data.bytes }.page()?)
    }

    /// What people should know of what they see.
    fn notes(&self, shows: &[Show]) -> Vec<String> {
        let mut notes = Vec::new();
        if self.airframe.has_loops() {
            notes.push(
                "section loads within loops that joints close are not known, and drawn as 0".to_owned(),
            );
        }
        if shows.iter().any(|show| show.kind == Kind::Flight)
            && self.settings.turbulence != TurbulenceSettings::default()
        {
            notes.push("the aircraft flies in turbulence, which is not drawn".to_owned());
        }
        notes
    }
}

fn two_levels(text: &str) -> Result<[Fidelity; 2], String> {
    let level = |name: &str| Fidelity::named(name.trim().to_ascii_lowercase().as_str());
    let levels = text.split_once(',').and_then(|(one, other)| Some([level(one)?, level(other)?]));
    levels.filter(|[one, other]| one != other).ok_or_else(|| {
        let names = Fidelity::ALL.map(Fidelity::name).join(", ");
        format!("allowed are two different levels with a comma between them, of {names}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_two() {
        assert_eq!(two_levels("exact,Rigid"), Ok([Fidelity::Exact, Fidelity::Rigid]));
        for wrong in ["exact", "exact,exact", "exact,soft", "exact,rigid,exact", ""] {
            assert!(two_levels(wrong).unwrap_err().contains("geometrically_exact"), "{wrong}");
        }
    }
}

//! `flexair describe`: what an aircraft file describes: mass, balance, static margin, natural modes, and what is unusual about it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::{ModeMotion, ReducedModel, Structure};
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;
use nalgebra::DMatrix;

use crate::aircraft_file::AircraftFile;
use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, STANDARD, picture, refuse_overwriting};
use crate::flown::{self, FlownOptions};
use crate::terminal;

mod balance;
mod drawing;
mod facts;
pub mod frame;
pub mod json;
pub mod modes;
mod senses;
pub mod surfaces;
pub mod text;
pub mod warnings;

use balance::Balance;
use facts::Facts;
use modes::NaturalMode;

/// Options of `flexair describe`.
#[derive(Args)]
#[command(
    after_help = "Mass, centre of mass and inertia are those of the undeformed aircraft, in body axes: x forward, y right, z down from O. The static \
margin is that of the trim with which a flight begins (--set airspeed=150), at a constant airspeed with structure and wake at rest: \
-dM/dL by the mean aerodynamic chord, positive where the aircraft turns back.

Natural modes are those of the structure held at O. A mode has its name from the component with the greatest part of its strain energy, left \
and right together, and from what strains there: bending (out of the surface; up and down of a body), in-plane bending (in the surface; \
sideways of a body), torsion, stretch; two of them where the first has less than 70 %. \"Moves\" are shares of the kinetic energy. \
The pictures show each mode from above and across the component that it is named after; the largest displacement is 15 % of the aircraft's size.

Examples: the jet; another aircraft with a picture of its 6 lowest modes
  flexair describe
  flexair describe my-aircraft.toml --modes 6 --plot modes.svg"
)]
pub struct DescribeOptions {
    #[command(flatten)]
    file: AircraftFile,

    #[command(flatten)]
    flown: FlownOptions,

    /// Also write all of it as JSON; - is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Draw the natural modes (SVG)
    #[arg(long, value_name = "FILE", value_parser = picture())]
    plot: Option<PathBuf>,
}

/// Why `flexair describe` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error(
        "--plot: found nothing to draw, for no natural mode flies; allowed is --modes or mode_count above 0"
    )]
    NoModes,
}

/// All that is said of an aircraft.
pub struct Description {
    facts: Facts,
    balance: Balance,
    modes: Vec<NaturalMode>,
    /// What is unusual.
    pub warnings: Vec<String>,
}

/// Describes an aircraft; what is unusual is no failure.
pub fn run(options: &DescribeOptions) -> Result<(), Error> {
    let outputs: Vec<&Path> = options.json.iter().chain(&options.plot).map(PathBuf::as_path).collect();
    refuse_overwriting(&outputs, [options.file.path()])?;
    let is_standard = |path: &&PathBuf| path.as_path() == Path::new(STANDARD);
    let files = options.json.iter().filter(|path| !is_standard(path)).chain(&options.plot);
    let drafts = Drafts::new(files.map(PathBuf::as_path))?;

    let aircraft = options.flown.read(options.file.path())?;
    let Described { structure, shapes, description } = Described::new(&aircraft, &options.flown)?;
    if options.plot.is_some() && description.modes.is_empty() {
        return Err(Error::NoModes);
    }
    let json = options.json.as_ref().map(|_| json::text(&description));
    let plot = options.plot.as_ref().map(|_| drawing::svg(&structure, &shapes, &description.modes));
    match (&json, options.json.as_ref().is_some_and(|path| is_standard(&path))) {
        (Some(json), true) => terminal::print(json)?,
        _ => terminal::print(&text::text(&description))?,
    }
    let to_file = json.filter(|_| !options.json.as_ref().is_some_and(|path| is_standard(&path)));
    drafts.keep(to_file.into_iter().chain(plot))?;
    Ok(())
}

/// All of it as the text of a JSON object.
pub fn answer(options: &DescribeOptions) -> Result<Answer, Error> {
    let aircraft = options.flown.read(options.file.path())?;
    let json = json::text(&Description::new(&aircraft, &options.flown)?);
    Ok(Answer::named([("json", Answer::Text(json))]))
}

/// An aircraft with what is said of it, and the shapes of its modes.
struct Described<'a> {
    structure: Structure<'a>,
    shapes: DMatrix<f64>,
    description: Description,
}

impl Description {
    /// All that is said of an aircraft in the flight that options ask for.
    pub fn new(aircraft: &Aircraft, flown: &FlownOptions) -> Result<Self, flown::Error> {
        Ok(Described::new(aircraft, flown)?.description)
    }
}

impl<'a> Described<'a> {
    fn new(aircraft: &'a Aircraft, flown: &FlownOptions) -> Result<Self, flown::Error> {
        let structure = Structure::new(aircraft)?;
        let basis = flown.basis(&structure)?;
        let shapes = basis.shapes.clone();
        let motions = ModeMotion::of_modes(&structure, &shapes);
        let model = Arc::new(ReducedModel::of_basis(&structure, basis)?);
        let settings = flown.settings(&VariableTable::new(&model), &model)?;
        let modes = modes::name(aircraft, &model.modes, &motions, &settings.plant);
        let facts = Facts::new(aircraft, &model);
        let balance = Balance::new(&model, &settings, facts.reference);
        let warnings = warnings::find(aircraft, &facts, &balance, &modes);
        Ok(Described { structure, shapes, description: Description { facts, balance, modes, warnings } })
    }
}

//! `flexair bench`: how fast the aircraft flies, how exact it is then, and what it costs to make it larger.
//!
//! The standard flight goes through the C interface as an importing tool would fly it; what lies inside, the
//! right-hand side and how it grows, is measured in the library. All times are of the processor, on one core.

mod equations;
mod larger;
mod options;
mod report;
mod scaling;
mod standard_flight;

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::Support;
use flexible_aircraft::flight::SimulationError;
use flexible_aircraft::fmi::Interface;
use flexible_aircraft::plant::{PlantSettings, SettingError, TrimError};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft::symmetry::Plants;
use flexible_aircraft_packaging::c_abi::Fmu;
use flexible_aircraft_packaging::{FileError, FmuError};

use crate::files::{Drafts, Overwriting, picture, refuse_overwriting};
use crate::{diagnostics, terminal, workspace};
use equations::{EquationCosts, pitch_control};
use report::Report;
use scaling::Scaling;
use standard_flight::{Flown, StandardFlight};

/// Options of `flexair bench`.
#[derive(Args)]
#[command(
    after_help = "The aircraft has to be free, with a control for pitch, a station (wing_tip_right, if there is one), and a mirror plane y = 0: \
the flight is a 2-3-1-1 of that control, and half of the aircraft is timed against the whole"
)]
pub struct BenchOptions {
    /// The FMU to fly, as `flexair package` writes it: FMI 2.0 co-simulation
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::fmu())]
    fmu: PathBuf,

    /// The aircraft file (TOML) that the FMU was made of
    #[arg(long, value_name = "FILE", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    /// Where to write the figures (Markdown)
    #[arg(long, value_name = "FILE", default_value = "target/performance/PERFORMANCE.md")]
    output: PathBuf,

    /// Where to draw the plot (SVG)
    #[arg(long, value_name = "FILE", default_value = "target/performance/performance.svg", value_parser = picture())]
    plot: PathBuf,
}

/// Why nothing can be measured.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// The aircraft file.
    #[error("{0}")]
    Aircraft(#[from] flexible_aircraft::aircraft::AircraftFileError),
    /// Its structure.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// A plant in the library.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// Its trim.
    #[error(transparent)]
    Trim(#[from] Box<TrimError>),
    /// The flight in the library.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// There is nothing to fly.
    #[error("{0}; `flexair package` writes one")]
    NoFmu(FileError),
    /// What there is flies in another way.
    #[error("{0}; `flexair package` writes one")]
    OtherFmu(FmuError),
    /// The flight through the C interface.
    #[error(transparent)]
    Fmu(#[from] FmuError),
    /// The aircraft is not its own mirror image.
    #[error("{0} has no mirror plane y = 0: the benchmark times half of an aircraft against the whole")]
    NoMirrorPlane(String),
    /// The aircraft does not fly.
    #[error("{0} is clamped in a wind tunnel: the standard flight needs support = \"free\"")]
    Clamped(String),
    /// Nothing moves in the standard flight.
    #[error("{0} has no control with trim = \"pitch\": the standard flight moves it")]
    NoPitchControl(String),
    /// The FMU lacks what the standard flight moves or watches.
    #[error(
        "{}: the FMU has no variable `{missing}`; the standard flight needs the aircraft's control for pitch and a station",
        fmu.display()
    )]
    NoStandardFlight { fmu: PathBuf, missing: String },
    /// Half flew for the whole, or the whole for half.
    #[error(
        "{} of the aircraft flew where the {} was to be timed, in a side wind of {side_wind} m/s",
        if *side_wind == 0.0 { "the whole" } else { "half" },
        if *side_wind == 0.0 { "half" } else { "whole" }
    )]
    OtherPart { side_wind: f64 },
    /// An output that is an input.
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    /// The results.
    #[error(transparent)]
    File(#[from] FileError),
}

/// The station that is watched where there is one of this name.
const WING_TIP: &str = "wing_tip_right";

/// Measures and writes.
///
/// # Errors
/// When the aircraft or the FMU cannot be read or flown, or the results cannot be written.
pub fn run(options: &BenchOptions) -> Result<(), BenchError> {
    let inputs = [options.fmu.as_path(), &options.aircraft];
    let outputs = [options.output.as_path(), &options.plot];
    refuse_overwriting(&outputs, inputs)?;
    let aircraft = diagnostics::read_aircraft(&options.aircraft)?;
    if aircraft.support == Support::Clamped {
        return Err(BenchError::Clamped(aircraft.name));
    }
    let model = Arc::new(ReducedModel::new(&aircraft, ModeCount::Usual(ReducedModel::USUAL_MODES))?);
    if Plants::under(&model, &PlantSettings::of(&model))?.half().is_none() {
        return Err(BenchError::NoMirrorPlane(aircraft.name));
    }
    let fmu = Fmu::open_as(&options.fmu, Interface::USUAL).map_err(|error| match error {
        FmuError::File(file) => BenchError::NoFmu(file),
        FmuError::OtherInterface { .. } => BenchError::OtherFmu(error),
        other => other.into(),
    })?;
    let control = &model.controls[pitch_control(&model)?];
    let mut names = model.stations.iter().map(|station| station.name.as_str());
    let first = names.clone().next();
    let station = names.find(|name| *name == WING_TIP).or(first).unwrap_or(WING_TIP);
    let flown = Flown { fmu: &fmu, level: model.fidelity, control: &control.name, station, parameters: &[] };
    if let Some(missing) = flown.missing_variable() {
        return Err(BenchError::NoStandardFlight { fmu: options.fmu.clone(), missing });
    }
    let drafts = Drafts::new(outputs)?;
    terminal::note("the standard flight through the C interface …");
    let flight = StandardFlight::measure(flown)?;
    terminal::note("the same with gusts, turbulence and an actuator …");
    let options = options::measure(flown)?;
    terminal::note("the right-hand side and the plain method …");
    let equations = EquationCosts::measure(&model)?;
    terminal::note("larger and smaller aircraft …");
    let scaling = Scaling::measure(&aircraft, &model)?;
    let report = Report { model: &model, control: &control.name, flight, options, equations, scaling };
    drafts.keep([report.markdown().as_str(), &report.chart().to_svg()])?;
    Ok(terminal::print(&format!("{}\n", report.summary()))?)
}

/// The least time, s, that `work` takes of a few times; the rest is what else the machine does.
fn least_time<T>(times: usize, mut work: impl FnMut() -> Result<T, BenchError>) -> Result<f64, BenchError> {
    let mut least = f64::INFINITY;
    for _ in 0..times {
        let start = cpu_time::ThreadTime::now();
        work()?;
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(least)
}

#[cfg(test)]
mod tests;

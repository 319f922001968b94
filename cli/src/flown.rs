//! What flies and how: the options that `flexair simulate`, `trim`, `linearise`, `gust` and `loads` share, and the trim that they begin with.

use std::path::Path;
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::plant::LimitExceeded;
use flexible_aircraft::structure::{
    ModalBasis, ModeCount, ModeKind, ReducedModel, Structure, StructureError,
};
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::assignment;

use crate::diagnostics;
use crate::numbers::Plain;

/// The modes and parameters of an aircraft that flies.
#[derive(Args, Default)]
pub struct FlownOptions {
    /// How many natural modes fly, lowest frequencies first; load modes are not counted [default: 12, or all where there are
    /// fewer; `--set mode_count=…` then has up to 26 fly]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Put load modes beside them, shapes that typical static loads give the structure, also where the aircraft file does
    /// not ask for them; `--set load_modes=false` switches them off where it does
    #[arg(long)]
    load_modes: bool,

    /// A parameter of the FMU, as in `model=rigid`. May be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

/// Why nothing can fly.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("--set {0}")]
    Parameter(#[from] assignment::Mistake),
}

impl FlownOptions {
    /// The aircraft of a file.
    pub fn read(&self, file: &Path) -> Result<Aircraft, Error> {
        Ok(self.changed(diagnostics::read_aircraft(file)?))
    }

    /// An aircraft as the options have it.
    pub fn changed(&self, mut aircraft: Aircraft) -> Aircraft {
        aircraft.load_modes |= self.load_modes;
        aircraft
    }

    /// The aircraft with its modes.
    pub fn reduce(&self, aircraft: &Aircraft) -> Result<Arc<ReducedModel>, Error> {
        Ok(Arc::new(ReducedModel::new(aircraft, self.count())?))
    }

    /// The modes of a structure with their shapes: those to which [`reduce`](Self::reduce) reduces.
    pub fn basis(&self, structure: &Structure) -> Result<ModalBasis, Error> {
        Ok(ModalBasis::with(structure, self.count(), ModeKind::All)?)
    }

    /// Its settings.
    pub fn settings(&self, variables: &VariableTable, model: &ReducedModel) -> Result<Settings, Error> {
        Ok(assignment::settings(&self.set, variables, model, self.count())?)
    }

    /// How many natural modes there are.
    pub fn count(&self) -> ModeCount {
        ModeCount::asked_or_usual(self.modes, ReducedModel::USUAL_MODES)
    }
}

/// A number of seconds on the command line.
pub fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "allowed is a number of seconds, greater than 0".to_owned())
}

/// The aircraft in its trim at a time, s, with a warning where that is beyond what it is flown within.
///
/// # Errors
/// When it cannot be trimmed.
pub fn trimmed(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    start: f64,
) -> Result<Simulation, SimulationError> {
    let simulation = Simulation::new(Arc::clone(model), settings, start)?;
    if let Some(warning) = LimitExceeded::warning(simulation.limits_exceeded(), model, &settings.plant) {
        diagnostics::warn(&warning);
    }
    Ok(simulation)
}

/// Airspeed, altitude or the tunnel's air, level and modes, for the heading of a report.
pub fn condition(model: &ReducedModel, settings: &Settings) -> String {
    let plant = &settings.plant;
    let air = match model.tunnel_air {
        Some(air) => format!("air of {} kg/m³", Plain(air.density)),
        None => plant.air_in_words(),
    };
    format!("{} m/s, {air}, {}", Plain(plant.airspeed), level(settings))
}

/// Level and modes.
pub fn level(settings: &Settings) -> String {
    let plant = &settings.plant;
    let modes = match plant.fidelity {
        Fidelity::Rigid => String::new(),
        _ => format!(", {} modes", plant.mode_count),
    };
    format!("model = {}{modes}", plant.fidelity.name())
}

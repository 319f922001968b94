//! What is analysed and under which settings: the options that `flexair flutter` and `flexair converge` share.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Support};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{ModeSelection, PlantSettings, SettingError};
use flexible_aircraft::structure::{ModeCount, ModeFamily, ModeKind, ReducedModel, StructureError};
use flexible_aircraft_packaging::FileError;

use crate::files::Overwriting;
use crate::numbers::Plain;
use crate::{diagnostics, workspace};

/// More airspeeds than this are a slip of the pen: the jet would take hours.
const MOST_POINTS: usize = 100_000;

/// The aircraft and its settings.
#[derive(Args)]
pub struct ConditionOptions {
    /// The aircraft file (TOML), free or clamped
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    pub aircraft: PathBuf,

    /// Altitude in the standard atmosphere, m, where the aircraft has no `density_kg_m3` [default: the aircraft's]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    altitude: Option<f64>,

    /// By how much the air is warmer than the standard atmosphere, K, where the aircraft has no `density_kg_m3` [default: the
    /// aircraft's]
    #[arg(long, value_name = "K", allow_negative_numbers = true)]
    temperature_offset: Option<f64>,

    /// Factor on all elastic properties
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    stiffness_scale: f64,

    /// Modal damping ratio of every mode
    #[arg(long, value_name = "RATIO", default_value_t = 0.0)]
    structural_damping: f64,

    /// Fidelity level [default: the aircraft's]
    #[arg(long, value_name = "LEVEL", value_parser = level())]
    model: Option<Fidelity>,

    /// Put load modes beside the natural ones, shapes that typical static loads give the structure, also where the aircraft
    /// file does not ask for them
    #[arg(long)]
    load_modes: bool,

    /// Families of modes that take part
    #[arg(long, value_enum, default_value_t = Modes::All)]
    mode_family: Modes,

    /// Peters inflow states of each strip, 0 (steady) to 8 [default: the aircraft's]
    #[arg(long, value_name = "N")]
    inflow_states: Option<usize>,
}

/// The families under their names in the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Modes {
    All,
    Symmetric,
}

/// The fidelity levels under their names.
fn level() -> impl TypedValueParser<Value = Fidelity> {
    // PROOF: the parser hands on nothing but these names, all of small letters, in any case.
    PossibleValuesParser::new(Fidelity::ALL.map(Fidelity::name))
        .map(|name| Fidelity::named(&name.to_ascii_lowercase()).expect("a name of a level"))
}

/// Why an analysis did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("{}: found {}, allowed is {}", option(&.0.setting), .0.found, .0.allowed)]
    Setting(#[from] SettingError),
    #[error("{option}: found {}, allowed is {} to {} m/s", Plain(*found), allowed.start(), allowed.end())]
    Airspeed { option: &'static str, found: f64, allowed: RangeInclusive<f64> },
    #[error(
        "{option} {}: {aircraft} is in a wind tunnel with air of its own, `density_kg_m3`; allowed is one of them",
        Plain(*found)
    )]
    TunnelAir { option: &'static str, found: f64, aircraft: String },
    #[error(
        "--from {} --to {} --points {points} is no range: 0 < from < to (m/s) and 2 to {MOST_POINTS} points are allowed",
        Plain(*from),
        Plain(*to)
    )]
    Range { from: f64, to: f64, points: usize },
    #[error(
        "around {} m/s flutter would be looked for from {} to {} m/s, which is no range: give --from and --to (m/s)",
        Plain(*around),
        Plain(*from),
        Plain(*to)
    )]
    NoUsualRange { around: f64, from: f64, to: f64 },
    #[error("{found}: nothing would move, for the aircraft is clamped; allowed is {allowed}")]
    Motionless { found: String, allowed: &'static str },
    #[error("{found}: it has no modes whose number could matter; allowed is a flexible model")]
    Modeless { found: String },
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// The option with which a parameter of the FMU is set here.
pub fn option(setting: &str) -> String {
    match setting {
        "mode_count" => "--modes".to_owned(),
        other => format!("--{}", other.replace('_', "-")),
    }
}

impl ConditionOptions {
    /// The aircraft, with load modes where they are asked for.
    pub fn read(&self) -> Result<Aircraft, Error> {
        let mut aircraft = diagnostics::read_aircraft(&self.aircraft)?;
        aircraft.load_modes |= self.load_modes;
        for (option, given) in
            [("--altitude", self.altitude), ("--temperature-offset", self.temperature_offset)]
        {
            if let (Some(found), Some(_)) = (given, &aircraft.tunnel_air) {
                return Err(Error::TunnelAir {
                    option,
                    found,
                    aircraft: self.aircraft.display().to_string(),
                });
            }
        }
        Ok(aircraft)
    }

    /// The model with enough modes of the family, and how many of them take part.
    pub fn reduce(&self, aircraft: &Aircraft, count: ModeCount) -> Result<(ReducedModel, usize), Error> {
        let (kind, takes_part): (_, fn(ModeFamily) -> bool) = match self.mode_family {
            Modes::All => (ModeKind::All, |_| true),
            Modes::Symmetric => (ModeKind::Symmetric, |family| family == ModeFamily::Symmetric),
        };
        let model = ReducedModel::with(aircraft, count, kind)?;
        let count = model.modes.iter().filter(|mode| !mode.of_loads && takes_part(mode.family)).count();
        Ok((model, count))
    }

    /// The level at which an aircraft is analysed.
    pub fn fidelity(&self, aircraft: &Aircraft) -> Fidelity {
        self.model.unwrap_or(aircraft.fidelity)
    }

    /// The level at which an aircraft is analysed, as it was given: by the option or by the file.
    fn given_level(&self, aircraft: &Aircraft) -> String {
        match self.model {
            Some(level) => format!("--model {}", level.name()),
            None => format!("model = \"{}\" of {}", aircraft.fidelity.name(), self.aircraft.display()),
        }
    }

    /// Whether there are modes whose number can matter.
    pub fn check_flexible(&self, aircraft: &Aircraft) -> Result<(), Error> {
        match self.fidelity(aircraft) {
            Fidelity::Rigid => Err(Error::Modeless { found: self.given_level(aircraft) }),
            _ => Ok(()),
        }
    }

    /// A clamped aircraft moves in its modes alone: `least` is the smallest number of them that is asked for, if any is.
    pub fn check_mobility(
        &self,
        aircraft: &Aircraft,
        model: &ReducedModel,
        least: Option<usize>,
    ) -> Result<(), Error> {
        match (aircraft.support, self.fidelity(aircraft), least) {
            (Support::Clamped, Fidelity::Rigid, _) => {
                Err(Error::Motionless { found: self.given_level(aircraft), allowed: "a flexible model" })
            }
            (Support::Clamped, _, Some(0)) if !model.has_load_modes() => {
                Err(Error::Motionless { found: "--modes 0".to_owned(), allowed: "at least 1 mode" })
            }
            _ => Ok(()),
        }
    }

    /// The settings of a model of an aircraft with so many natural modes.
    pub fn settings(&self, aircraft: &Aircraft, model: &ReducedModel, mode_count: usize) -> PlantSettings {
        PlantSettings {
            fidelity: self.fidelity(aircraft),
            altitude: self.altitude.unwrap_or(aircraft.altitude),
            temperature_offset: self.temperature_offset.unwrap_or(aircraft.temperature_offset),
            stiffness_scale: self.stiffness_scale,
            structural_damping: self.structural_damping,
            mode_selection: self.mode_family.selection(),
            mode_count,
            inflow_states: self.inflow_states.unwrap_or(aircraft.inflow_states),
            ..PlantSettings::of(model)
        }
    }
}

/// Airspeeds of a range, evenly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airspeeds {
    /// The lowest and the highest, m/s.
    pub from: f64,
    pub to: f64,
    /// How many there are.
    pub points: usize,
}

impl Airspeeds {
    /// So many, at which an aircraft of such a support can be asked to fly.
    pub fn new([from, to]: [f64; 2], points: usize, support: Support) -> Result<Self, Error> {
        if !(0.0 < from && from < to && to.is_finite() && (2..=MOST_POINTS).contains(&points)) {
            return Err(Error::Range { from, to, points });
        }
        for (option, found) in [("--from", from), ("--to", to)] {
            check_airspeed(option, found, support)?;
        }
        Ok(Airspeeds { from, to, points })
    }

    /// One alone, m/s.
    pub fn one(airspeed: f64) -> Self {
        Airspeeds { from: airspeed, to: airspeed, points: 1 }
    }

    /// All of them, ascending, m/s.
    pub fn all(self) -> Vec<f64> {
        let Airspeeds { from, to, points } = self;
        let step = (to - from) / points.saturating_sub(1).max(1) as f64;
        (0..points).map(|point| from + step * point as f64).collect()
    }
}

/// Whether an aircraft can be asked for an airspeed.
pub fn check_airspeed(option: &'static str, found: f64, support: Support) -> Result<(), Error> {
    let allowed = support.airspeeds();
    if allowed.contains(&found) { Ok(()) } else { Err(Error::Airspeed { option, found, allowed }) }
}

impl Modes {
    fn selection(self) -> ModeSelection {
        match self {
            Modes::All => ModeSelection::All,
            Modes::Symmetric => ModeSelection::Symmetric,
        }
    }
}

//! `flexair flutter`: at which airspeeds an aircraft flutters or diverges, in words, plots and numbers.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use flexible_aircraft::air::Air;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError, Support};
use flexible_aircraft::equations::Fidelity;
use flexible_aircraft::plant::{ModeSelection, PlantSettings, SettingError};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::{ModeCount, ModeFamily, ModeKind, ReducedModel, StructureError};
use flexible_aircraft_packaging::FileError;

use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::numbers::Plain;
use crate::progress::Progress;
use crate::{diagnostics, terminal, workspace};

mod motion;
mod plots;
mod report;
mod roots;

/// Modes that take part unless the user says otherwise, if the aircraft has so many.
const USUAL_MODES: usize = 12;

/// How the names of the files end that are written: V–g and V–f plots, growth of aperiodic roots, numbers.
const OUTPUTS: [&str; 4] = ["v-g.svg", "v-f.svg", "v-aperiodic.svg", "roots.csv"];

/// More airspeeds than this are a slip of the pen: the jet would take hours.
const MOST_POINTS: usize = 100_000;

/// Options of `flexair flutter`.
#[derive(Args)]
pub struct FlutterOptions {
    /// The aircraft file (TOML), free or clamped
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    /// Lowest airspeed, m/s
    #[arg(long, value_name = "M/S")]
    from: f64,

    /// Highest airspeed, m/s
    #[arg(long, value_name = "M/S")]
    to: f64,

    /// Number of airspeeds, 2 to 100000; each root is followed from one to the next in as many steps as it needs
    #[arg(long, value_name = "N", default_value_t = 41)]
    points: usize,

    /// Altitude in the standard atmosphere, m, where the aircraft has no `density_kg_m3` [default: the aircraft's]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    altitude: Option<f64>,

    /// Factor on all elastic properties
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    stiffness_scale: f64,

    /// Modal damping ratio of every mode
    #[arg(long, value_name = "RATIO", default_value_t = 0.0)]
    structural_damping: f64,

    /// Fidelity level [default: the aircraft's]
    #[arg(long, value_name = "LEVEL", value_parser = level())]
    model: Option<Fidelity>,

    /// Number of natural modes, lowest frequencies first [default: 12, or all where there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Put load modes beside them, shapes that typical static loads give the structure, also where the aircraft file does
    /// not ask for them
    #[arg(long)]
    load_modes: bool,

    /// Families of modes that take part
    #[arg(long, value_enum, default_value_t = Modes::All)]
    mode_family: Modes,

    /// Peters inflow states of each strip, 0 (steady) to 8 [default: the aircraft's]
    #[arg(long, value_name = "N")]
    inflow_states: Option<usize>,

    /// Folder for the plots and the table of roots
    #[arg(long, value_name = "DIR", default_value = "target/flutter")]
    output: PathBuf,
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

/// Why `flexair flutter` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("{}: found {}, allowed is {}", option(.0.setting), .0.found, .0.allowed)]
    Setting(#[from] SettingError),
    #[error("{option}: found {}, allowed is {} to {} m/s", Plain(*found), allowed.start(), allowed.end())]
    Airspeed { option: &'static str, found: f64, allowed: RangeInclusive<f64> },
    #[error(
        "--altitude {}: {aircraft} is in a wind tunnel with air of its own, `density_kg_m3`; allowed is one of them",
        Plain(*altitude)
    )]
    TunnelAltitude { altitude: f64, aircraft: String },
    #[error(
        "--from {} --to {} --points {points} is no range: 0 < from < to (m/s) and 2 to {MOST_POINTS} points are allowed",
        Plain(*from),
        Plain(*to)
    )]
    Range { from: f64, to: f64, points: usize },
    #[error("{option}: nothing would move, for the aircraft is clamped; allowed is {allowed}")]
    Motionless { option: &'static str, allowed: &'static str },
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
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

/// The option with which a parameter of the FMU is set here.
fn option(setting: &str) -> String {
    match setting {
        "mode_count" => "--modes".to_owned(),
        other => format!("--{}", other.replace('_', "-")),
    }
}

/// What was analysed, and what came out.
struct Analysis {
    model: ReducedModel,
    /// Fidelity level for people.
    level: String,
    settings: PlantSettings,
    /// Lowest and highest airspeed asked for, m/s.
    range: [f64; 2],
    sweep: Sweep,
}

/// Analyses, prints, draws, and writes the roots.
pub fn run(options: &FlutterOptions) -> Result<(), Error> {
    let name = options.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let outputs = OUTPUTS.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [options.aircraft.as_path()])?;
    let [dampings, frequencies, aperiodic, roots] = outputs.each_ref().map(PathBuf::as_path);
    let drafts = Drafts::new([dampings, frequencies, roots, aperiodic])?;
    let analysis = analyse(options)?;
    for warning in report::warnings(&analysis) {
        diagnostics::warn(&warning);
    }
    terminal::print(&report::text(&analysis))?;
    let always = [
        plots::dampings(&analysis).to_svg(),
        plots::frequencies(&analysis).to_svg(),
        roots::table(&analysis),
    ];
    let growth = plots::aperiodic_growth(&analysis).map(|chart| chart.to_svg());
    drafts.keep(always.iter().chain(&growth).map(String::as_str))?;
    for path in
        [Some(dampings), Some(frequencies), growth.map(|_| aperiodic), Some(roots)].into_iter().flatten()
    {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

fn analyse(options: &FlutterOptions) -> Result<Analysis, Error> {
    let mut aircraft = diagnostics::read_aircraft(&options.aircraft)?;
    aircraft.load_modes |= options.load_modes;
    let airspeeds = airspeeds(options, aircraft.support)?;
    if let (Some(altitude), Some(_)) = (options.altitude, &aircraft.tunnel_air) {
        return Err(Error::TunnelAltitude { altitude, aircraft: options.aircraft.display().to_string() });
    }
    let (model, mode_count) = reduce(&aircraft, options)?;
    let fidelity = options.model.unwrap_or(aircraft.fidelity);
    check_mobility(&model, fidelity, options)?;
    let settings = PlantSettings {
        fidelity,
        altitude: options.altitude.unwrap_or(aircraft.altitude),
        stiffness_scale: options.stiffness_scale,
        structural_damping: options.structural_damping,
        mode_selection: options.mode_family.selection(),
        mode_count,
        inflow_states: options.inflow_states.unwrap_or(aircraft.inflow_states),
        ..PlantSettings::of(&model)
    };
    let progress = Progress::new(airspeeds.len(), "airspeeds");
    let sweep = Sweep::watched(&model, &settings, &airspeeds, &|| progress.advance())?;
    drop(progress);
    let model = model.in_use(&settings.choose_modes(&model)?);
    let level = settings.fidelity.name().replace('_', " ");
    Ok(Analysis { model, level, settings, range: [options.from, options.to], sweep })
}

/// A clamped aircraft moves in its modes alone.
fn check_mobility(model: &ReducedModel, level: Fidelity, options: &FlutterOptions) -> Result<(), Error> {
    match (model.support, level, options.modes) {
        (Support::Clamped, Fidelity::Rigid, _) => {
            Err(Error::Motionless { option: "--model rigid", allowed: "a flexible model" })
        }
        (Support::Clamped, _, Some(0)) if !model.has_load_modes() => {
            Err(Error::Motionless { option: "--modes 0", allowed: "at least 1 mode" })
        }
        _ => Ok(()),
    }
}

/// The airspeeds of the range.
fn airspeeds(options: &FlutterOptions, support: Support) -> Result<Vec<f64>, Error> {
    let FlutterOptions { from, to, points, .. } = *options;
    if !(0.0 < from && from < to && to.is_finite() && (2..=MOST_POINTS).contains(&points)) {
        return Err(Error::Range { from, to, points });
    }
    let allowed = support.airspeeds();
    for (option, found) in [("--from", from), ("--to", to)] {
        if !allowed.contains(&found) {
            return Err(Error::Airspeed { option, found, allowed });
        }
    }
    let step = (to - from) / (points - 1) as f64;
    Ok((0..points).map(|point| from + step * point as f64).collect())
}

/// The model with enough modes of the family, and how many of them take part.
fn reduce(aircraft: &Aircraft, options: &FlutterOptions) -> Result<(ReducedModel, usize), Error> {
    let count = ModeCount::asked_or_usual(options.modes, USUAL_MODES);
    let (kind, takes_part): (_, fn(ModeFamily) -> bool) = match options.mode_family {
        Modes::All => (ModeKind::All, |_| true),
        Modes::Symmetric => (ModeKind::Symmetric, |family| family == ModeFamily::Symmetric),
    };
    let model = ReducedModel::with(aircraft, count, kind)?;
    let count = model.modes.iter().filter(|mode| !mode.of_loads && takes_part(mode.family)).count();
    Ok((model, count))
}

impl Modes {
    fn selection(self) -> ModeSelection {
        match self {
            Modes::All => ModeSelection::All,
            Modes::Symmetric => ModeSelection::Symmetric,
        }
    }
}

impl Analysis {
    /// kg/m³.
    fn density(&self) -> f64 {
        let tunnel = self.model.tunnel_air.as_ref().map(Air::of_tunnel);
        tunnel.unwrap_or_else(|| Air::at(self.settings.altitude)).density
    }
}

#[cfg(test)]
mod tests;

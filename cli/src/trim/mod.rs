//! `flexair trim`: what holds an aircraft in steady flight, over speeds, altitudes and load factors [theory: trim.manoeuvres].

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{ConditionSettings, Lateral, ManoeuvreChoice, SettingError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::FileError;

use crate::answer::Answer;
use crate::files::{Drafts, Overwriting, STANDARD, refuse_overwriting};
use crate::flown::{self, FlownOptions};
use crate::progress::Audience;
use crate::{axis, condition, terminal, workspace};

mod points;
mod table;

use points::{Point, Status, Trimmed};

/// Numbers of an axis, in the order in which they were given.
#[derive(Clone, Debug)]
struct Values(Vec<f64>);

fn values(text: &str) -> Result<Values, String> {
    let allowed = || {
        format!("allowed is a number, a list N,N,… or FROM:TO:COUNT with FROM ≤ TO and 1 to {MOST_POINTS}")
    };
    axis::numbers(text, MOST_POINTS).map(Values).ok_or_else(allowed)
}

/// Most points of a table.
const MOST_POINTS: usize = 100_000;

/// Options of `flexair trim`.
#[derive(Args)]
#[command(
    after_help = "Each of --speed, --altitude and --load-factor is a number, a list (120,127) or FROM:TO:N; all are combined. \
Angles are degrees here and rad in the tables. Where a trim needs more than the limits of the aircraft file, of actuator.* and engine.*, it counts \
as none, and the table says what is left with them held there. The static margin is in mean aerodynamic chords, with structure and wake \
at rest; only straight flights of a symmetric aircraft have one here.

Examples: level flight over speeds; turns and a pull-up; the right engine of the jet out
  flexair trim --speed 110:180:8
  flexair trim --turn --load-factor 1.2,1.5
  flexair trim --pull-up --load-factor 1.5
  flexair trim --failed-engine right"
)]
pub struct TrimOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    #[command(flatten)]
    flown: FlownOptions,

    /// True airspeeds, m/s [default: the aircraft's]
    #[arg(long, value_name = "M/S", value_parser = values, allow_hyphen_values = true)]
    speed: Option<Values>,

    /// Altitudes, m [default: the aircraft's]
    #[arg(long, value_name = "M", value_parser = values, allow_hyphen_values = true)]
    altitude: Option<Values>,

    /// Load factors across the flow, of turns (negative to the left) or pull-ups
    #[arg(long, value_name = "FACTOR", value_parser = values, allow_hyphen_values = true)]
    load_factor: Option<Values>,

    /// Trim turns, by --load-factor or --bank-angle
    #[arg(long, conflicts_with = "pull_up")]
    turn: bool,

    /// Trim pull-ups, or push-overs, by --load-factor
    #[arg(long, requires = "load_factor")]
    pull_up: bool,

    /// Bank angle, degrees, positive to the right: of a turn, or with sideslip found of a straight flight
    #[arg(long, value_name = "DEG", value_parser = degrees, allow_hyphen_values = true)]
    bank_angle: Option<f64>,

    /// Climb angle of the path, degrees
    #[arg(long, value_name = "DEG", value_parser = degrees, allow_hyphen_values = true)]
    climb_angle: Option<f64>,

    /// Sideslip of a straight flight, degrees, positive with the wind from the right
    #[arg(long, value_name = "DEG", value_parser = degrees, allow_hyphen_values = true, conflicts_with_all = ["turn", "pull_up", "bank_angle"])]
    sideslip: Option<f64>,

    /// Engine that gives no thrust, by its name
    #[arg(long, value_name = "ENGINE", conflicts_with_all = ["turn", "pull_up"])]
    failed_engine: Option<String>,

    /// Ignore the limits of the aircraft file; those that are set by actuator.* and engine.* stay
    #[arg(long)]
    ignore_limits: bool,

    /// Also write the table as comma-separated values; - is standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Also write the table as JSON; - is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Why `flexair trim` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error("--failed-engine: found {found}, allowed is {allowed}")]
    Engine { found: String, allowed: String },
    #[error(
        "found {0} points, allowed are {MOST_POINTS} at most: shorten --speed, --altitude or --load-factor"
    )]
    TooMany(usize),
    #[error("--load-factor: found without --turn or --pull-up, which it belongs to")]
    LoadFactor,
    #[error("--load-factor: found 0, allowed is another number: 0 stands for none given")]
    NoLoadFactor,
    #[error("{}: found {}, allowed is {}", given(&.0.setting), .0.found, .0.allowed)]
    Setting(#[from] SettingError),
    #[error("no point could be trimmed; the table says why")]
    None,
    #[error("no point could be trimmed; the first because: {0}")]
    Nowhere(String),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

/// A parameter of the FMU, by the option with which it is set here; angles are degrees there.
fn given(setting: &str) -> String {
    match setting {
        "airspeed" => "--speed".to_owned(),
        "condition.load_factor" => "--load-factor".to_owned(),
        "condition.climb_angle" | "condition.bank_angle" | "condition.sideslip" => {
            let option = condition::option(setting.trim_start_matches("condition."));
            format!("{setting}, which {option} gives in degrees")
        }
        other if other.starts_with("condition.") => other.to_owned(),
        other => condition::option(other),
    }
}

fn degrees(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle: &f64| angle.abs() <= 84.0);
    angle.ok_or_else(|| "allowed are -84 to 84 degrees".to_owned())
}

/// Trims all points, prints the table, and writes it; a table in which nothing is trimmed is a failure.
pub fn run(options: &TrimOptions) -> Result<(), Error> {
    let file = options.aircraft.as_path();
    let outputs: Vec<&Path> = options.csv.iter().chain(&options.json).map(PathBuf::as_path).collect();
    refuse_overwriting(&outputs, [file])?;
    let is_standard = |path: &Path| path == Path::new(STANDARD);
    let drafts = Drafts::new(outputs.iter().copied().filter(|path| !is_standard(path)))?;
    let Trims { model, settings, points } = options.trim(&Audience::of_command())?;
    let found = points.iter().filter(|point| point.status == Status::Found).count();
    let printed = table::text(&model, &settings, &points);
    let written = [
        options.csv.as_ref().map(|_| table::csv(&model, &points)),
        options.json.as_ref().map(|_| table::json(&model, &points)),
    ];
    let written: Vec<String> = written.into_iter().flatten().collect();
    let (printed_ones, files): (Vec<_>, Vec<_>) =
        outputs.iter().zip(&written).partition(|(path, _)| is_standard(path));
    match printed_ones.first() {
        None => terminal::print(&printed)?,
        Some((_, table)) => terminal::print(table)?,
    }
    drafts.keep(files.iter().map(|(_, table)| table.as_str()))?;
    if found == 0 { Err(Error::None) } else { Ok(()) }
}

/// The table as arrays.
pub fn answer(options: &TrimOptions, audience: &Audience) -> Result<Answer, Error> {
    let Trims { model, points, .. } = options.trim(audience)?;
    match points.iter().find(|point| point.status != Status::Found) {
        Some(first) if points.iter().all(|point| point.status != Status::Found) => {
            Err(Error::Nowhere(first.message.clone()))
        }
        _ => Ok(table::answer(&model, &points)),
    }
}

/// All points.
struct Trims {
    model: Arc<ReducedModel>,
    settings: Settings,
    points: Vec<Point>,
}

impl TrimOptions {
    fn trim(&self, audience: &Audience) -> Result<Trims, Error> {
        let aircraft = self.flown.read(&self.aircraft)?;
        let model = self.flown.reduce(&aircraft)?;
        let settings = self.flown.settings(&VariableTable::new(&model), &model)?;
        let all = self.settings(&model, &settings)?;
        let reference = aircraft.reference_lengths();
        let trimmed = Trimmed { model: &model, reference, ignore_limits: self.ignore_limits };
        let points = points::trim(&trimmed, &all, audience)?;
        Ok(Trims { model, settings, points })
    }

    /// The settings of every point, load factor after load factor, in each altitude after altitude, in each speed after speed.
    fn settings(&self, model: &ReducedModel, base: &Settings) -> Result<Vec<Settings>, Error> {
        let condition = self.condition(model, base.plant.condition)?;
        if self.load_factor.is_some() && condition.manoeuvre == ManoeuvreChoice::Straight {
            return Err(Error::LoadFactor);
        }
        if self.load_factor.as_ref().is_some_and(|factors| factors.0.contains(&0.0)) {
            return Err(Error::NoLoadFactor);
        }
        let or = |given: &Option<Values>, usual: f64| {
            given.as_ref().map_or(vec![usual], |values| values.0.clone())
        };
        let speeds = or(&self.speed, base.plant.airspeed);
        let altitudes = or(&self.altitude, base.plant.altitude);
        let factors = or(&self.load_factor, condition.load_factor);
        let count = speeds.len() * altitudes.len() * factors.len();
        if count > MOST_POINTS {
            return Err(Error::TooMany(count));
        }
        let mut all = Vec::with_capacity(count);
        for &load_factor in &factors {
            for &altitude in &altitudes {
                for &airspeed in &speeds {
                    let mut settings = base.clone();
                    settings.plant.condition = ConditionSettings { load_factor, ..condition };
                    (settings.plant.airspeed, settings.plant.altitude) = (airspeed, altitude);
                    settings.plant.choose_modes(model)?;
                    all.push(settings);
                }
            }
        }
        Ok(all)
    }

    /// What is asked of every point.
    fn condition(&self, model: &ReducedModel, base: ConditionSettings) -> Result<ConditionSettings, Error> {
        let mut condition = base;
        let radians = |degrees: &f64| degrees.to_radians();
        condition.climb_angle = self.climb_angle.as_ref().map_or(base.climb_angle, radians);
        condition.bank_angle = self.bank_angle.as_ref().map_or(base.bank_angle, radians);
        condition.sideslip = self.sideslip.as_ref().map_or(base.sideslip, radians);
        match (self.turn, self.pull_up, self.bank_angle) {
            (true, _, _) => condition.manoeuvre = ManoeuvreChoice::Turn,
            (_, true, _) => condition.manoeuvre = ManoeuvreChoice::PullUp,
            (_, _, Some(_)) if condition.manoeuvre == ManoeuvreChoice::Straight => {
                condition.lateral = Lateral::Bank;
            }
            _ => {}
        }
        if let Some(name) = &self.failed_engine {
            let place = model.engines.iter().position(|engine| engine.name == *name);
            let names: Vec<&str> = model.engines.iter().map(|engine| engine.name.as_str()).collect();
            let allowed =
                if names.is_empty() { "none: there are no engines".to_owned() } else { names.join(", ") };
            let place = place.ok_or_else(|| Error::Engine { found: name.clone(), allowed })?;
            condition.failed_engine = place + 1;
        }
        Ok(condition)
    }
}

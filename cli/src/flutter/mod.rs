//! `flexair flutter`: at which airspeeds an aircraft flutters or diverges, with V–g and V–f plots.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use flexible_aircraft::aerodynamics::Air;
use flexible_aircraft::aircraft::{Aircraft, AircraftFileError};
use flexible_aircraft::simulation::{Fidelity, ModeSelection, Settings, SimulationError};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::{ModeCount, ModeFamily, ModeKind, ReducedModel, StructureError};
use flexible_aircraft_packaging::FileError;

use crate::{diagnostics, files, terminal, workspace};

mod motion;
mod plots;
mod report;

/// Modes that take part unless the user says otherwise, if the aircraft has so many.
const USUAL_MODES: usize = 12;

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

    /// Number of airspeeds; each root is followed from one to the next in as many steps as it needs
    #[arg(long, value_name = "N", default_value_t = 41)]
    points: usize,

    /// Altitude in the standard atmosphere, m
    #[arg(long, value_name = "M", default_value_t = 0.0, allow_negative_numbers = true)]
    altitude: f64,

    /// Factor on all elastic properties
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    stiffness_scale: f64,

    /// Modal damping ratio of every mode
    #[arg(long, value_name = "RATIO", default_value_t = 0.0)]
    structural_damping: f64,

    /// Fidelity level
    #[arg(long, value_enum, default_value_t = Model::Exact)]
    model: Model,

    /// Number of modes, lowest frequencies first [default: 12, or all where there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Families of modes that take part
    #[arg(long, value_enum, default_value_t = Modes::All)]
    mode_family: Modes,

    /// Peters inflow states of each strip, 0 (steady) to 8 [default: the aircraft's]
    #[arg(long, value_name = "N")]
    inflow_states: Option<usize>,

    /// Folder for the plots
    #[arg(long, value_name = "DIR", default_value = "target/flutter")]
    output: PathBuf,
}

/// The fidelity levels under their names in the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
enum Model {
    Exact,
    ConsistentlyLinearised,
    Inconsistent,
    RuthlesslyLinearised,
    Rigid,
}

/// The families under their names in the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Modes {
    All,
    Symmetric,
}

/// Why `flexair flutter` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error(transparent)]
    Settings(#[from] SimulationError),
    #[error(
        "--from {from} --to {to} --points {points} is no range: 0 < from < to and at least 2 points are allowed"
    )]
    Range { from: f64, to: f64, points: usize },
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

/// What was analysed, and what came out.
struct Analysis {
    model: ReducedModel,
    /// Fidelity level for people.
    level: String,
    settings: Settings,
    /// Lowest and highest airspeed asked for, m/s.
    range: [f64; 2],
    sweep: Sweep,
}

/// Analyses, prints, and draws.
pub fn run(options: &FlutterOptions) -> Result<(), Error> {
    let analysis = analyse(options)?;
    terminal::print(&report::text(&analysis))?;
    let name = options.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    for (kind, chart) in [("v-g", plots::dampings(&analysis)), ("v-f", plots::frequencies(&analysis))] {
        let path = options.output.join(format!("{name}-{kind}.svg"));
        files::write(&path, chart.to_svg().as_bytes())?;
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

fn analyse(options: &FlutterOptions) -> Result<Analysis, Error> {
    let aircraft = Aircraft::read(&options.aircraft)?;
    let airspeeds = airspeeds(options)?;
    let (model, mode_count) = reduce(&aircraft, options)?;
    let settings = Settings {
        fidelity: options.model.fidelity(),
        altitude: options.altitude,
        stiffness_scale: options.stiffness_scale,
        structural_damping: options.structural_damping,
        mode_selection: options.mode_family.selection(),
        mode_count,
        inflow_states: options.inflow_states.unwrap_or(aircraft.inflow_states),
        ..Settings::default()
    };
    let sweep = Sweep::new(&model, &settings, &airspeeds)?;
    let model = model.select(&settings.choose_modes(&model)?);
    let level =
        options.model.to_possible_value().map_or(String::new(), |value| value.get_name().replace('_', " "));
    Ok(Analysis { model, level, settings, range: [options.from, options.to], sweep })
}

/// The airspeeds of the range.
fn airspeeds(options: &FlutterOptions) -> Result<Vec<f64>, Error> {
    let FlutterOptions { from, to, points, .. } = *options;
    if !(0.0 < from && from < to && to.is_finite() && points >= 2) {
        return Err(Error::Range { from, to, points });
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
    let count = model.modes.iter().filter(|mode| takes_part(mode.family)).count();
    Ok((model, count))
}

impl Model {
    fn fidelity(self) -> Fidelity {
        match self {
            Model::Exact => Fidelity::Exact,
            Model::ConsistentlyLinearised => Fidelity::ConsistentlyLinearised,
            Model::Inconsistent => Fidelity::Inconsistent,
            Model::RuthlesslyLinearised => Fidelity::RuthlesslyLinearised,
            Model::Rigid => Fidelity::Rigid,
        }
    }
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
        Air::at(self.settings.altitude).density
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        options: FlutterOptions,
    }

    /// The options of `flexair flutter` with a shipped aircraft.
    fn options(aircraft: &str, rest: &str) -> FlutterOptions {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft").join(aircraft);
        let mut words = vec!["flutter".to_owned(), path.display().to_string()];
        words.extend(rest.split_whitespace().map(str::to_owned));
        Line::try_parse_from(words).unwrap_or_else(|error| panic!("{error}")).options
    }

    fn section(rest: &str) -> Analysis {
        analyse(&options("typical-section.toml", rest)).unwrap()
    }

    #[test]
    fn the_report_names_the_speeds_of_the_typical_section() {
        let text = report::text(&section("--from 5 --to 80 --points 9 --modes 2 --inflow-states 6"));
        // Hodges and Pierce: 2.165 and 0.6545 times b ω = 20 m/s; divergence at 2.828.
        for line in ["43.31 m/s  flutter         13.09 rad/s (2.083 Hz)", "56.57 m/s  divergence      static"]
        {
            assert!(text.contains(line), "{text}");
        }
        assert!(text.contains("% mode 2") && text.contains("(begins as mode 2, 3.2"), "{text}");
    }

    #[test]
    fn no_flutter_in_the_range_is_said_with_the_range() {
        let text = report::text(&section("--from 5 --to 40 --points 5"));
        assert!(text.contains("no flutter begins from 5 to 40 m/s"), "{text}");
        assert!(text.contains("no divergence begins from 5 to 40 m/s"), "{text}");
    }

    #[test]
    fn a_range_that_begins_beyond_flutter_says_so() {
        let text = report::text(&section("--from 50 --to 55 --points 3 --modes 2"));
        assert!(text.contains("50.00 m/s  already unstable here: "), "{text}");
    }

    #[test]
    fn airspeeds_without_trim_are_listed_with_the_reason() {
        let range = "--from 3 --to 127 --points 2 --altitude 7620 --modes 2";
        let text = report::text(&analyse(&options("generic-business-jet.toml", range)).unwrap());
        assert!(text.contains("not analysed: 3.00 m/s\n"), "{text}");
        assert!(text.contains("no steady level flight found at 3 m/s"), "{text}");
    }

    #[test]
    fn the_plots_show_both_modes_and_mark_both_speeds() {
        let analysis = section("--from 5 --to 80 --points 16 --modes 2");
        for chart in [plots::dampings(&analysis), plots::frequencies(&analysis)] {
            assert_eq!(chart.curves.len(), 2);
            assert!(chart.x.label.contains(", flutter 43.") && chart.x.label.contains(", divergence 56.6"));
            assert!(chart.curves.iter().all(|curve| curve.points.len() > 5));
        }
    }

    #[test]
    fn a_range_that_is_none_is_refused() {
        for range in ["--from 80 --to 5", "--from 0 --to 5", "--from 5 --to 80 --points 1"] {
            let error = analyse(&options("typical-section.toml", range)).err().unwrap().report();
            assert!(error.contains("0 < from < to and at least 2 points are allowed"), "{error}");
        }
    }

    #[test]
    fn a_missing_file_and_too_many_modes_are_errors_for_people() {
        let report = |aircraft, rest| analyse(&options(aircraft, rest)).err().unwrap().report();
        let missing = report("none.toml", "--from 5 --to 80");
        assert!(missing.contains("none.toml: cannot read the aircraft file"), "{missing}");
        let many = report("typical-section.toml", "--from 5 --to 80 --modes 40");
        assert!(many.starts_with("error: 40 modes were asked for, the structure has "), "{many}");
    }
}

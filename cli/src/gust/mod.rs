//! `flexair gust`: one 1-cosine gust after the other, the worst of each output [theory: gusts.one-minus-cosine].

use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use clap::{Args, ValueEnum};
use flexible_aircraft::air::{CS25_GRADIENTS, GustCriterion, GustShape};
use flexible_aircraft::aircraft::AircraftFileError;
use flexible_aircraft::flight::{Settings, SimulationError};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use flexible_aircraft::variables::VariableTable;
use flexible_aircraft_packaging::{FileError, assignment};

use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::numbers::Plain;
use crate::{diagnostics, terminal, workspace};

mod alleviation;
mod plot;
mod report;
mod sweep;
mod table;
mod watched;

use alleviation::{Weights, weights};
use sweep::{Case, Sweep};
use watched::Watched;

/// How the names of the files end that are written: all cases, the worst of them, the plot.
const OUTPUTS: [&str; 3] = ["gusts.csv", "worst.csv", "gusts.svg"];

/// More gusts than this are a slip of the pen.
const MOST_GRADIENTS: usize = 10_000;

/// Options of `flexair gust`.
#[derive(Args)]
#[command(
    after_help = "Every gust is flown upwards and downwards (with --direction 90 to the right and to the left), hands off, from the trim on. \
What it adds to the trim is counted as an increment.

Example: the jet through the gusts of CS-25 at its design cruising speed, its loads and load factors
  flexair gust --output-names loads,load_factor"
)]
pub struct GustOptions {
    /// The aircraft file (TOML)
    #[arg(value_name = "AIRCRAFT", default_value_os_t = workspace::aircraft())]
    aircraft: PathBuf,

    /// How many natural modes fly, lowest frequencies first; load modes are not counted [default: 12, or all where there are
    /// fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Put load modes beside them, also where the aircraft file does not ask for them
    #[arg(long)]
    load_modes: bool,

    /// Gradients H of the gusts, m: the least, the greatest and how many, equally far apart
    #[arg(long, value_name = "FROM:TO:N", value_parser = gradients, default_value = "9.144:106.68:37")]
    gradients: Gradients,

    /// What the peak follows from
    #[arg(long, value_enum, default_value_t = Criterion::Cs25Vc)]
    criterion: Criterion,

    /// Peak of every gust, m/s of true airspeed, in place of a criterion
    #[arg(long, value_name = "M/S", conflicts_with = "criterion")]
    peak: Option<f64>,

    /// Direction of the gusts across the track, degrees: 0 upwards, 90 to the right; the opposite is flown too
    #[arg(long, value_name = "DEG", default_value_t = 0.0)]
    direction: f64,

    /// Maximum take-off, landing and zero-fuel weight, of any unit: F_g of CS-25 at sea level follows from them and from
    /// `gust.maximum_operating_altitude`
    #[arg(long, value_name = "MTOW,MLW,MZFW", value_parser = weights)]
    weights: Option<Weights>,

    /// A parameter of the FMU, as in `airspeed=140`. May be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,

    /// Outputs to watch: names, or the first parts of them, as in `load_factor` [default: loads, load_factor and upward
    /// deflections]
    #[arg(long, value_name = "NAME,NAME,…", value_delimiter = ',')]
    output_names: Vec<String>,

    /// How long each gust is flown, s, from the trim on
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    duration: f64,

    /// Time between two looks at the outputs, s
    #[arg(long, value_name = "SECONDS", default_value_t = 0.005)]
    step: f64,

    /// Folder for the tables and the plot
    #[arg(long, value_name = "DIR", default_value = "target/gust")]
    output: PathBuf,
}

/// What the peak of a gust follows from, under the names of the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Criterion {
    /// CS 25.341(a) at the design cruising speed
    #[value(name = "cs25_vc")]
    Cs25Vc,
    /// CS 25.341(a) at the design dive speed: half of it
    #[value(name = "cs25_vd")]
    Cs25Vd,
}

/// Equally spaced gradients, m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Gradients {
    from: f64,
    to: f64,
    count: usize,
}

/// Why `flexair gust` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Aircraft(#[from] AircraftFileError),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("--set {0}")]
    Parameter(#[from] assignment::Mistake),
    #[error("--set {0}: `flexair gust` flies gusts of its own, by {1}")]
    OwnParameter(String, &'static str),
    #[error("--gradients: found {} to {} m, allowed with CS-25 is 9.144 to 106.68 m; --peak flies others", Plain(*from), Plain(*to))]
    Cs25Gradients { from: f64, to: f64 },
    #[error("--{option}: found {}, allowed is {allowed}", Plain(*found))]
    Number { option: &'static str, found: f64, allowed: &'static str },
    #[error("--duration: found {} s, but the gusts begin at {} s (`gust.start`)", Plain(*duration), Plain(*start))]
    Late { duration: f64, start: f64 },
    #[error("--output-names {found}: there is no such output; {instead}")]
    Output { found: String, instead: String },
    #[error("{gust}: {source}")]
    Flight { gust: String, source: SimulationError },
    #[error(transparent)]
    Trim(#[from] SimulationError),
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

/// Flies all gusts, prints the worst, and writes tables and a plot.
pub fn run(options: &GustOptions) -> Result<(), Error> {
    let file = options.aircraft.as_path();
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let outputs = OUTPUTS.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [file])?;
    let drafts = Drafts::new(outputs.iter().map(PathBuf::as_path))?;
    let count = ModeCount::asked_or_usual(options.modes, ReducedModel::USUAL_MODES);
    let mut aircraft = diagnostics::read_aircraft(file)?;
    aircraft.load_modes |= options.load_modes;
    let model = Arc::new(ReducedModel::new(&aircraft, count)?);
    let variables = VariableTable::new(&model);
    let settings = options.settings(&variables, &model, count)?;
    let watched = Watched::choose(&options.output_names, &variables)?;
    let began = Instant::now();
    let sweep = Sweep::fly(&model, &settings, &watched, &options.cases(), [options.duration, options.step])?;
    let seconds = began.elapsed().as_secs_f64();
    terminal::print(&report::text(&model, &settings, &watched, &sweep, seconds))?;
    let (all, worst) = (table::all(&watched, &sweep), table::worst(&watched, &sweep));
    drafts.keep([
        all.as_str(),
        worst.as_str(),
        plot::increments(&model.name, &watched, &sweep).to_svg().as_str(),
    ])?;
    for path in &outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

impl GustOptions {
    /// The settings of all flights but for gradient and sense of the gust.
    fn settings(
        &self,
        variables: &VariableTable,
        model: &ReducedModel,
        count: ModeCount,
    ) -> Result<Settings, Error> {
        for (name, instead) in [
            ("gust.gradient", "--gradients"),
            ("gust.shape", "--gradients"),
            ("gust.criterion", "--criterion or --peak"),
            ("gust.peak", "--peak"),
            ("gust.direction", "--direction"),
        ] {
            if let Some(set) = self.set.iter().find(|set| set.split('=').next() == Some(name)) {
                return Err(Error::OwnParameter(set.clone(), instead));
            }
        }
        self.check()?;
        let mut settings = assignment::settings(&self.set, variables, model, count)?;
        let gust = &mut settings.gust;
        gust.shape = GustShape::OneMinusCosine;
        gust.criterion = match (self.peak, self.criterion) {
            (Some(_), _) => GustCriterion::Peak,
            (None, Criterion::Cs25Vc) => GustCriterion::Cs25Vc,
            (None, Criterion::Cs25Vd) => GustCriterion::Cs25Vd,
        };
        gust.peak = self.peak.unwrap_or(gust.peak);
        if self.duration <= gust.start {
            return Err(Error::Late { duration: self.duration, start: gust.start });
        }
        if let Some(weights) = self.weights {
            gust.alleviation = weights.alleviation_at_sea_level(gust.maximum_operating_altitude);
        }
        Ok(settings)
    }

    fn check(&self) -> Result<(), Error> {
        let positive = |option, found: f64, allowed| {
            if found.is_finite() && found > 0.0 {
                Ok(())
            } else {
                Err(Error::Number { option, found, allowed })
            }
        };
        positive("duration", self.duration, "a number of seconds, greater than 0")?;
        positive("step", self.step, "a number of seconds, greater than 0")?;
        if let Some(peak) = self.peak {
            positive("peak", peak, "a number of m/s, greater than 0: both senses are flown")?;
        }
        if !self.direction.is_finite() {
            let allowed = "a finite number of degrees";
            return Err(Error::Number { option: "direction", found: self.direction, allowed });
        }
        let Gradients { from, to, .. } = self.gradients;
        let is_within = CS25_GRADIENTS.contains(&from) && CS25_GRADIENTS.contains(&to);
        if self.peak.is_none() && !is_within {
            return Err(Error::Cs25Gradients { from, to });
        }
        Ok(())
    }

    /// Every gradient in both senses.
    fn cases(&self) -> Vec<Case> {
        let Gradients { from, to, count } = self.gradients;
        let steps = count.max(2) - 1;
        let gradient = |place: usize| {
            if place == steps { to } else { from + (to - from) * place as f64 / steps as f64 }
        };
        let direction = self.direction.to_radians();
        let gradients: Vec<f64> = if count == 1 { vec![from] } else { (0..count).map(gradient).collect() };
        let senses = [("positive", direction), ("negative", direction + PI)];
        let cases = senses.into_iter().flat_map(|(sense, direction)| {
            gradients.iter().map(move |&gradient| Case { gradient, sense, direction })
        });
        cases.collect()
    }
}

fn gradients(text: &str) -> Result<Gradients, String> {
    let parse = || {
        let mut parts = text.split(':');
        let [from, to] = [parts.next()?, parts.next()?].map(|part| part.parse::<f64>().ok());
        let gradients = Gradients { from: from?, to: to?, count: parts.next()?.parse().ok()? };
        let Gradients { from, to, count } = gradients;
        let is_range = 0.0 < from && from <= to && to.is_finite() && (1..=MOST_GRADIENTS).contains(&count);
        (parts.next().is_none() && is_range).then_some(gradients)
    };
    parse().ok_or_else(|| {
        format!("allowed is FROM:TO:N in m with 0 < FROM ≤ TO and 1 to {MOST_GRADIENTS} gradients")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_are_equally_far_apart_and_both_ends_are_flown() {
        assert_eq!(gradients("10:30:5"), Ok(Gradients { from: 10.0, to: 30.0, count: 5 }));
        for wrong in ["10:30", "10:30:5:1", "30:10:5", "0:30:5", "10:30:0", "10:inf:3", "a:b:c", "1:2:10001"]
        {
            assert!(gradients(wrong).unwrap_err().contains("0 < FROM"), "{wrong}");
        }
    }
}

//! `flexair flutter`: at which airspeeds an aircraft flutters or diverges, in words, plots and numbers.

use std::path::PathBuf;

use clap::Args;
use flexible_aircraft::air::Air;
use flexible_aircraft::plant::{PlantSettings, SettingError};
use flexible_aircraft::stability::Sweep;
use flexible_aircraft::structure::{ModeCount, ReducedModel};
use flexible_aircraft_packaging::FileError;

use crate::condition::{self, ConditionOptions};
use crate::files::{Drafts, Overwriting, refuse_overwriting};
use crate::progress::Progress;
use crate::{diagnostics, terminal};

pub mod motion;
mod plots;
mod report;
mod roots;

/// Modes that take part unless the user says otherwise, if the aircraft has so many.
const USUAL_MODES: usize = 12;

/// How the names of the files end that are written: V–g and V–f plots, growth of aperiodic roots, numbers.
const OUTPUTS: [&str; 4] = ["v-g.svg", "v-f.svg", "v-aperiodic.svg", "roots.csv"];

/// Options of `flexair flutter`.
#[derive(Args)]
pub struct FlutterOptions {
    #[command(flatten)]
    condition: ConditionOptions,

    /// Lowest airspeed, m/s
    #[arg(long, value_name = "M/S")]
    from: f64,

    /// Highest airspeed, m/s
    #[arg(long, value_name = "M/S")]
    to: f64,

    /// Number of airspeeds, 2 to 100000; each root is followed from one to the next in as many steps as it needs
    #[arg(long, value_name = "N", default_value_t = 41)]
    points: usize,

    /// Number of natural modes, lowest frequencies first [default: 12, or all where there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Folder for the plots and the table of roots
    #[arg(long, value_name = "DIR", default_value = "target/flutter")]
    output: PathBuf,
}

/// Why `flexair flutter` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Condition(#[from] condition::Error),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
}

impl Error {
    /// For people, on a terminal.
    pub fn report(&self) -> String {
        match self {
            Error::Condition(error) => error.report(),
            other => format!("error: {other}"),
        }
    }
}

/// What was analysed, and what came out.
pub struct Analysis {
    /// With the modes that take part.
    pub model: ReducedModel,
    /// Fidelity level for people.
    pub level: String,
    pub settings: PlantSettings,
    /// Lowest and highest airspeed asked for, m/s.
    pub range: [f64; 2],
    pub sweep: Sweep,
}

/// Analyses, prints, draws, and writes the roots.
pub fn run(options: &FlutterOptions) -> Result<(), Error> {
    let name = options.condition.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let outputs = OUTPUTS.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [options.condition.aircraft.as_path()])?;
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

fn analyse(options: &FlutterOptions) -> Result<Analysis, condition::Error> {
    let FlutterOptions { condition, from, to, points, modes, .. } = options;
    let aircraft = condition.read()?;
    let airspeeds = condition::airspeeds([*from, *to], *points, aircraft.support)?;
    let (model, count) = condition.reduce(&aircraft, ModeCount::asked_or_usual(*modes, USUAL_MODES))?;
    condition::check_mobility(&model, condition.fidelity(&aircraft), *modes)?;
    let settings = condition.settings(&aircraft, &model, count);
    let progress = Progress::new(airspeeds.len(), "airspeeds");
    Ok(Analysis::new(&model, settings, [*from, *to], &airspeeds, &progress)?)
}

impl Analysis {
    /// Of a model under some settings over the ascending airspeeds of a range, m/s.
    pub fn new(
        model: &ReducedModel,
        settings: PlantSettings,
        range: [f64; 2],
        airspeeds: &[f64],
        progress: &Progress,
    ) -> Result<Self, SettingError> {
        let sweep = Sweep::watched(model, &settings, airspeeds, &|| progress.advance())?;
        let model = model.in_use(&settings.choose_modes(model)?);
        let level = settings.fidelity.name().replace('_', " ");
        Ok(Analysis { model, level, settings, range, sweep })
    }

    /// kg/m³.
    pub fn density(&self) -> f64 {
        let tunnel = self.model.tunnel_air.as_ref().map(Air::of_tunnel);
        tunnel.unwrap_or_else(|| Air::at(self.settings.altitude)).density
    }
}

#[cfg(test)]
mod tests;

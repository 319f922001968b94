//! `flexair flutter`: at which airspeeds an aircraft flutters or diverges, in words, plots and numbers.

use std::path::PathBuf;

use clap::Args;
use flexible_aircraft::structure::ModeCount;

use crate::analysis::Analysis;
use crate::answer::Answer;
use crate::condition::{Airspeeds, ConditionOptions, Error};
use crate::files::{Drafts, refuse_overwriting};
use crate::progress::Audience;
use crate::{diagnostics, limits, terminal};

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

    /// How many natural modes take part, lowest frequencies first; load modes are not counted [default: 12, or all where
    /// there are fewer]
    #[arg(long, value_name = "N")]
    modes: Option<usize>,

    /// Folder for the plots and the table of roots
    #[arg(long, value_name = "DIR", default_value = "target/flutter")]
    output: PathBuf,
}

/// Analyses, prints, draws, and writes the roots.
pub fn run(options: &FlutterOptions) -> Result<(), Error> {
    let name = options.condition.aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let outputs = OUTPUTS.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [options.condition.aircraft.as_path()])?;
    let [dampings, frequencies, aperiodic, roots] = outputs.each_ref().map(PathBuf::as_path);
    let drafts = Drafts::new([dampings, frequencies, roots, aperiodic])?;
    let analysis = analyse(options, &Audience::of_command())?;
    for warning in limits::warnings(&analysis.sweep.limits_exceeded) {
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

/// The roots and what they say, as arrays.
pub fn answer(options: &FlutterOptions, audience: &Audience) -> Result<Answer, Error> {
    Ok(roots::answer(&analyse(options, audience)?))
}

fn analyse(options: &FlutterOptions, audience: &Audience) -> Result<Analysis, Error> {
    let FlutterOptions { condition, from, to, points, modes, .. } = options;
    let aircraft = condition.read()?;
    let airspeeds = Airspeeds::new([*from, *to], *points, aircraft.support)?;
    let (model, count) = condition.reduce(&aircraft, ModeCount::asked_or_usual(*modes, USUAL_MODES))?;
    condition.check_mobility(&aircraft, &model, *modes)?;
    let settings = condition.settings(&aircraft, &model, count);
    let progress = audience.progress(airspeeds.points, "airspeeds");
    Ok(Analysis::new(&model, settings, airspeeds, &progress)?)
}

#[cfg(test)]
mod tests;

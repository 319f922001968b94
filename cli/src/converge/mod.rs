//! `flexair converge`: how trim, deflections, critical airspeeds and roots change with the number of modes, and how many are
//! enough [theory: structure.convergence].

use std::path::PathBuf;

use clap::Args;
use flexible_aircraft::aircraft::{Aircraft, Support};
use flexible_aircraft::plant::{PlantSettings, SettingError};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};
use rayon::prelude::*;

use crate::condition::{Airspeeds, ConditionOptions, Error, check_airspeed};
use crate::files::{Drafts, refuse_overwriting};
use crate::progress::Progress;
use crate::{diagnostics, terminal};

mod plot;
mod quantity;
mod report;
mod row;
mod study;
mod table;
mod verdict;

use row::Row;
use study::Study;

/// Numbers of modes that are compared unless others are asked for: about a third more from each to the next.
const USUAL_COUNTS: [usize; 8] = [4, 6, 8, 12, 16, 24, 32, 40];

/// So many of a structure's modes are compared one by one where it has no more.
const FEW: usize = 6;

/// How the names of the files end that are written: the plot, the numbers.
const OUTPUTS: [&str; 2] = ["modes.svg", "modes.csv"];

/// The search for flutter and divergence begins and ends at these multiples of the trims' airspeed.
const SEARCH: [f64; 2] = [0.5, 2.0];

/// Options of `flexair converge`.
#[derive(Args)]
#[command(
    after_help = "The counts of modes are those of `flutter --modes` and of the FMU's `mode_count`: with `--mode-family all` the \
lowest modes of both families together, whose antisymmetric ones move no symmetric trim, but flutter. Changes are measured \
against the greatest trim angle, the greatest deflection, and the thrust, airspeed or root itself.

Example: the jet at one tenth of its stiffness, symmetric modes
  flexair converge --model geometrically_exact --stiffness-scale 0.1 --mode-family symmetric --from 100 --to 250"
)]
pub struct ConvergeOptions {
    #[command(flatten)]
    condition: ConditionOptions,

    /// Numbers of natural modes to compare, lowest frequencies first; load modes, which belong to each number, are not
    /// counted [default: 4,6,8,12,16,24,32,40 as far as the structure has so many]
    #[arg(long, value_name = "N,N,…", value_delimiter = ',', value_parser = crate::count)]
    modes: Vec<usize>,

    /// Airspeed of the trims, m/s [default: the aircraft's]
    #[arg(long, value_name = "M/S")]
    airspeed: Option<f64>,

    /// Lowest airspeed at which flutter and divergence are looked for, m/s [default: half that of the trims, but
    /// no less than the aircraft may fly]
    #[arg(long, value_name = "M/S")]
    from: Option<f64>,

    /// Highest airspeed at which they are looked for, m/s [default: twice that of the trims, at most 400]
    #[arg(long, value_name = "M/S")]
    to: Option<f64>,

    /// Number of airspeeds from one to the other, 2 to 100000; what is unstable between two of them alone goes unnoticed
    #[arg(long, value_name = "N", default_value_t = 16)]
    points: usize,

    /// Folder for the plot and the table
    #[arg(long, value_name = "DIR", default_value = "target/converge")]
    output: PathBuf,
}

/// Analyses with each number of modes, prints, draws, and writes the numbers.
pub fn run(options: &ConvergeOptions) -> Result<(), Error> {
    let aircraft = options.condition.aircraft.as_path();
    let name = aircraft.file_stem().unwrap_or_default().to_string_lossy();
    let outputs = OUTPUTS.map(|ending| options.output.join(format!("{name}-{ending}")));
    refuse_overwriting(&outputs.each_ref().map(PathBuf::as_path), [aircraft])?;
    let drafts = Drafts::new(outputs.iter().map(PathBuf::as_path))?;
    let study = study(options)?;
    for warning in study.warnings() {
        diagnostics::warn(&warning);
    }
    terminal::print(&report::text(&study))?;
    drafts.keep([plot::departures(&study).to_svg().as_str(), &table::table(&study)])?;
    for path in &outputs {
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

fn study(options: &ConvergeOptions) -> Result<Study, Error> {
    let condition = &options.condition;
    let aircraft = condition.read()?;
    let airspeed = options.airspeed.unwrap_or(aircraft.airspeed);
    check_airspeed("--airspeed", airspeed, aircraft.support)?;
    let airspeeds = options.search(airspeed, aircraft.support)?;
    condition.check_flexible(&aircraft)?;
    let (model, counts) = reduce(&aircraft, options)?;
    condition.check_mobility(&aircraft, &model, counts.first().copied())?;
    // The trims' own airspeed is one more, of which the roots are listed.
    let progress = Progress::new(counts.len() * (airspeeds.points + 1), "airspeeds");
    let row = |count: usize| {
        let settings = PlantSettings { airspeed, ..condition.settings(&aircraft, &model, count) };
        Row::new(&model, settings, airspeeds, &progress)
    };
    let rows: Result<Vec<Row>, SettingError> = counts.into_par_iter().with_max_len(1).map(row).collect();
    let mut rows = rows?;
    // The other one of a pair comes with the last: two numbers may be one.
    rows.dedup_by_key(|row| row.natural);
    drop(progress);
    let last = rows.last().map_or(0, |row| row.natural);
    Ok(Study::new(rows, airspeed, || has_no_more(&aircraft, condition, last)))
}

impl ConvergeOptions {
    /// The airspeeds at which flutter and divergence are looked for, around that of the trims, m/s.
    fn search(&self, airspeed: f64, support: Support) -> Result<Airspeeds, Error> {
        let allowed = support.airspeeds();
        let usual = SEARCH.map(|multiple| (multiple * airspeed).clamp(*allowed.start(), *allowed.end()));
        let [from, to] = [self.from.unwrap_or(usual[0]), self.to.unwrap_or(usual[1])];
        let is_usual = self.from.is_none() || self.to.is_none();
        if is_usual && !(0.0 < from && from < to) {
            return Err(Error::NoUsualRange { around: airspeed, from, to });
        }
        Airspeeds::new([from, to], self.points, support)
    }
}

/// The model with the most modes that are compared, and the numbers of them, ascending.
fn reduce(aircraft: &Aircraft, options: &ConvergeOptions) -> Result<(ReducedModel, Vec<usize>), Error> {
    let mut counts = options.modes.clone();
    counts.sort_unstable();
    counts.dedup();
    let most = counts.last().copied();
    let usual = USUAL_COUNTS[USUAL_COUNTS.len() - 1];
    let (model, most) = options.condition.reduce(aircraft, ModeCount::asked_or_usual(most, usual))?;
    let counts = if counts.is_empty() { usual_counts(most) } else { counts };
    Ok((model, counts))
}

/// Numbers of modes to be compared where there are so many.
fn usual_counts(most: usize) -> Vec<usize> {
    if most <= FEW {
        return (1..=most).collect();
    }
    let mut counts: Vec<usize> = USUAL_COUNTS.into_iter().filter(|count| *count < most).collect();
    counts.push(most);
    counts
}

/// Whether a structure has no more modes than so many.
fn has_no_more(aircraft: &Aircraft, condition: &ConditionOptions, count: usize) -> bool {
    let more = condition.reduce(aircraft, ModeCount::Asked(count + 1));
    matches!(more, Err(Error::Structure(StructureError::TooFewModes { .. })))
}

#[cfg(test)]
mod tests;

//! `flexair sweep`: many points over parameters of the FMU and of the aircraft, numbers of each as Parquet [theory: sweeps.points].

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use flexible_aircraft::aircraft::looked_for;
use flexible_aircraft_packaging::{Draft, FileError};
use parquet::errors::ParquetError;
use rayon::prelude::*;
use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};

use crate::diagnostics::read_aircraft;
use crate::files::{Overwriting, refuse_overwriting};
use crate::flown;
use crate::home::Home;
use crate::marked::Rejected;
use crate::progress::Progress;
use crate::{terminal, workspace};

mod columns;
mod document;
mod file;
mod foreseen;
mod job;
mod linear;
mod manifest;
mod models;
mod names;
mod part;
mod plan;
mod points;
mod reduction;

use file::SweepFile;
use job::Status;
use manifest::{Folder, Identity, POINTS_PER_PART};
use part::{BrokenPart, Format, Outcomes, Row};
use plan::Plan;

/// Options of `flexair sweep`.
#[derive(Args)]
#[command(
    after_help = "A sweep file has what is fixed under [set], what varies in [[vary]], what is done in [run] and what is kept in [[keep]]:
  aircraft = \"jet.toml\"             # relative to this file; without it the jet; modes and load_modes as elsewhere
  samples = 1000                    # of what is random, at each point of the grids; seed = 1
  [set]
  model = \"geometrically_exact\"     # parameters of the FMU
  [[vary]]
  name = \"gust.gradient\"            # values = [...], from/to/count, uniform = [least, most], normal = [mean, deviation]
  from = 10
  to = 107
  count = 20
  [[vary]]
  name = \"component.wing_right.stiffness\"  # or mass.<component>, mass.<component>.point_masses[1]: factors, on both sides
  normal = [1, 0.05]
  [run]
  kind = \"gust\"                     # trim, linearise (inflow), gust (duration, step), simulate (input, duration, step)
  duration = 5
  [[keep]]
  output = \"load_factor.z\"          # or the first parts of several names
  reduce = [\"max\", \"min\"]           # rms, end, time_of_max; of linear models root = 1, or matrix, row, column
Grids are all combined, the first changes slowest. A point is a function of its number alone: threads and order change nothing. Parts of 1000 points \
appear whole; a sweep that was stopped goes on with the same command. Columns: point, what varies, status (ok, no_trim, left_validity, invalid), \
message, what is kept; their units stand as JSON in the metadata `units` of each part."
)]
pub struct SweepOptions {
    /// The sweep file (TOML)
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// Folder for the parts of the table and manifest.json
    #[arg(long, value_name = "DIR")]
    output: PathBuf,

    /// How many points are flown at a time [default: as many as there are cores]
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
}

/// Why `flexair sweep` did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("{0}")]
    Rejected(#[from] Rejected),
    #[error("{0}")]
    Plan(#[from] plan::Error),
    #[error(transparent)]
    Flown(#[from] flown::Error),
    #[error("{}: cannot read the sweep file: {source}{}", path.display(), looked_for(path, source))]
    Unreadable { path: PathBuf, source: std::io::Error },
    #[error("--jobs: found 0, allowed is 1 or more")]
    NoJobs,
    #[error("cannot start so many threads: {0}")]
    Threads(#[from] ThreadPoolBuildError),
    #[error(transparent)]
    Folder(#[from] manifest::Error),
    #[error(transparent)]
    Broken(#[from] BrokenPart),
    #[error("cannot write a part: {0}")]
    Parquet(#[from] ParquetError),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(transparent)]
    Overwriting(#[from] Overwriting),
    #[error("no point came out; the column `message` says why")]
    None,
}

/// Flies all points that have no part yet, and says how all came out.
pub fn run(options: &SweepOptions, home: &Home) -> Result<(), Error> {
    if options.jobs == Some(0) {
        return Err(Error::NoJobs);
    }
    let pool = ThreadPoolBuilder::new().num_threads(options.jobs.unwrap_or(0)).build()?;
    let file_name = options.file.display().to_string();
    let unreadable = |source| Error::Unreadable { path: options.file.clone(), source };
    let text = std::fs::read_to_string(&options.file).map_err(unreadable)?;
    let file = SweepFile::parse(&text, &file_name)?;
    let aircraft_file = aircraft_file(&file, &options.file, home);
    let aircraft = read_aircraft(&aircraft_file).map_err(flown::Error::from)?;
    let failed = |source| FileError { action: "read", path: aircraft_file.clone(), source };
    let identity = Identity::new(text.as_bytes(), &std::fs::read(&aircraft_file).map_err(failed)?);
    let mut folder = Folder::open(&options.output, &identity)?;
    refuse_overwriting(&[&folder.manifest(), &folder.part(0)], [options.file.as_path(), &aircraft_file])?;
    let plan = Plan::new(&file, aircraft, (&file_name, &text))?;
    folder.begin(&identity, plan.points.count())?;
    let swept = pool.install(|| sweep(&plan, &folder))?;
    terminal::print(&swept.report(&options.output))?;
    if swept.outcomes.tally[0] == 0 { Err(Error::None) } else { Ok(()) }
}

/// As the sweep file names it, a path from where it is or one that comes with the program, or the one that all commands take.
fn aircraft_file(file: &SweepFile, sweep_file: &Path, home: &Home) -> PathBuf {
    let named = file.aircraft.clone().unwrap_or_else(workspace::aircraft);
    match named.to_str().filter(|name| home.aircraft_names().iter().any(|known| known == name)) {
        Some(name) => home.aircraft_file(name),
        None => sweep_file.parent().unwrap_or(Path::new("")).join(named),
    }
}

/// How a sweep came out.
struct Swept {
    outcomes: Outcomes,
    /// Points of this run, and how long they took, s.
    flown: u64,
    seconds: f64,
}

/// Flies the parts that are not there, one after the other, their points on all threads.
fn sweep(plan: &Plan, folder: &Folder) -> Result<Swept, Error> {
    let format = Format::new(&plan.varied, &plan.kept)?;
    let count = plan.points.count();
    let parts = count.div_ceil(POINTS_PER_PART);
    let points = |part: u64| part * POINTS_PER_PART..count.min((part + 1) * POINTS_PER_PART);
    let size = |part: u64| points(part).end - points(part).start;
    let mut swept = Swept { outcomes: Outcomes::default(), flown: 0, seconds: 0.0 };
    let mut missing = Vec::new();
    for part in 0..parts {
        let path = folder.part(part);
        if path.exists() {
            swept.outcomes.add(Outcomes::read(&path, &points(part))?);
        } else {
            missing.push(part);
        }
    }
    swept.flown = missing.iter().map(|part| size(*part)).sum();
    let progress = Progress::new(swept.flown as usize, "points");
    let began = Instant::now();
    for part in missing {
        let rows = rows(plan, points(part), &progress);
        Draft::write(&format.bytes(&rows)?, &folder.part(part))?.keep()?;
        swept.outcomes.add(Outcomes::of(&rows));
    }
    swept.seconds = began.elapsed().as_secs_f64();
    Ok(swept)
}

/// The rows of some points, in their order; points of the same aircraft share its model.
fn rows(plan: &Plan, points: std::ops::Range<u64>, progress: &Progress) -> Vec<Row> {
    let mut groups: Vec<Vec<(u64, Vec<f64>)>> = Vec::new();
    let mut places = HashMap::new();
    for point in points {
        let values = plan.points.values(point);
        let place = *places.entry(plan.key(&values)).or_insert_with(|| {
            groups.push(Vec::new());
            groups.len() - 1
        });
        groups[place].push((point, values));
    }
    let of_group = |group: Vec<(u64, Vec<f64>)>| {
        let model = group.first().map(|(_, values)| plan.model(values));
        group.into_par_iter().with_max_len(1).filter_map(move |(point, varied)| {
            let outcome = model.clone()?.and_then(|model| plan.run(&model, &varied));
            progress.advance();
            Some(Row { point, varied, outcome })
        })
    };
    let mut rows: Vec<Row> = groups.into_par_iter().with_max_len(1).flat_map(of_group).collect();
    rows.sort_by_key(|row| row.point);
    rows
}

impl Swept {
    /// For people.
    fn report(&self, output: &Path) -> String {
        let Outcomes { tally, first_failure } = &self.outcomes;
        let all: u64 = tally.iter().sum();
        let statuses = tally.iter().zip(Status::ALL).filter(|(count, _)| **count > 0);
        let statuses: Vec<String> =
            statuses.map(|(count, status)| format!("{count} {}", status.name())).collect();
        let parts = all.div_ceil(POINTS_PER_PART);
        let flown = match self.flown {
            0 => "all of them were there".to_owned(),
            flown => format!(
                "{flown} flown in {:.1} s, {:.1} flights per second",
                self.seconds,
                flown as f64 / self.seconds.max(1e-9)
            ),
        };
        let failure = first_failure.as_ref().map_or(String::new(), |(point, message)| {
            format!("the first that did not come out, point {point}: {message}\n")
        });
        format!(
            "{all} points: {}; {flown}\n{failure}{}: {parts} part{} and manifest.json\n",
            statuses.join(", "),
            output.display(),
            if parts == 1 { "" } else { "s" }
        )
    }
}

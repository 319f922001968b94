//! A sweep file as its author thinks of it: what is fixed, what varies, what is flown, what is kept.

use std::path::PathBuf;

use flexible_aircraft::Inflow;
use toml::de::DeTable;

use super::document::{Item, Mistakes, Place, Section};
use super::points::Axis;
use super::reduction::Reduction;
use crate::axis::even;
use crate::marked::Rejected;
use crate::simulate::given::Given;

/// More points than anybody flies: the jet would take days.
pub const MOST_POINTS: u64 = 100_000_000;

/// Most values of one axis that a grid or a list has.
const MOST_VALUES: u64 = 1_000_000;

/// How long is flown unless the file says otherwise, s, and how often outputs are looked at: on the flight's grid.
const USUAL_DURATION: f64 = 10.0;
const USUAL_STEP: f64 = 0.01;

const FILE: &[&str] =
    &["aircraft", "modes", "load_modes", "samples", "seed", "monte_carlo", "set", "vary", "run", "keep"];
const MONTE_CARLO: &[&str] = &["samples", "seed"];
const VARY: &[&str] = &["name", "values", "from", "to", "count", "uniform", "normal"];
const RUN: &[&str] = &["kind", "duration", "step", "input", "inflow"];
const KEEP: &[&str] = &["output", "reduce", "root", "matrix", "row", "column"];

/// A whole file, each key allowed by itself.
#[derive(Debug)]
pub struct SweepFile {
    /// As written: relative to the file.
    pub aircraft: Option<PathBuf>,
    /// How many natural modes fly.
    pub modes: Option<usize>,
    pub load_modes: bool,
    pub fixed: Vec<Fixed>,
    pub varied: Vec<Varied>,
    pub samples: u64,
    pub seed: u64,
    pub run: Run,
    pub keep: Vec<Keep>,
}

/// What is the same at all points.
#[derive(Debug)]
pub struct Fixed {
    pub name: String,
    /// As `--set` would have it.
    pub value: String,
    pub place: Place,
}

/// What is not.
#[derive(Debug)]
pub struct Varied {
    pub name: String,
    /// Of the name.
    pub place: Place,
    pub law: Law,
}

/// How something varies.
#[derive(Debug)]
pub enum Law {
    Axis(Axis),
    /// Names of an enumeration's items, with their places.
    Items(Vec<(String, Place)>),
}

/// What is done at each point.
#[derive(Debug)]
pub enum Run {
    Trim,
    Linearise(Inflow),
    Fly(Flown),
}

/// A flight from the trim on.
#[derive(Debug)]
pub struct Flown {
    /// s.
    pub duration: f64,
    /// Between two looks at the outputs, s.
    pub step: f64,
    /// What is flown into is a gust unless `gust.shape` says otherwise.
    pub is_gust: bool,
    pub inputs: Vec<(Given, Place)>,
    /// Of the table.
    pub place: Place,
}

/// What is kept of each point.
#[derive(Debug)]
pub enum Keep {
    /// Of an output, or all whose names begin so; none of these for a trim, which has one value.
    Output { name: String, place: Place, reductions: Vec<Reduction> },
    /// Of a linear model the root with this number, counted from 1.
    Root { number: usize, place: Place },
    /// Of a linear model an entry of a matrix.
    Entry { matrix: Matrix, row: String, column: String, place: Place },
}

/// A matrix of a linear model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matrix {
    A,
    B,
    C,
    D,
    Bd,
    Dd,
}

impl Matrix {
    /// By their names in files that `flexair linearise` writes.
    pub const ALL: [(&str, Matrix); 6] = [
        ("A", Matrix::A),
        ("B", Matrix::B),
        ("C", Matrix::C),
        ("D", Matrix::D),
        ("Bd", Matrix::Bd),
        ("Dd", Matrix::Dd),
    ];
}

impl SweepFile {
    /// Reads a file's text.
    ///
    /// # Errors
    /// With all that is wrong in it.
    pub fn parse(text: &str, file_name: &str) -> Result<Self, Rejected> {
        let mistakes = Mistakes::default();
        let read = match DeTable::parse(text) {
            Ok(document) => read(document.get_ref(), &mistakes),
            Err(error) => {
                let place = Place { span: error.span().unwrap_or_default(), field: "syntax".to_owned() };
                mistakes.add(&place, error.message(), "allowed is TOML (https://toml.io)");
                None
            }
        };
        mistakes.conclude(read, file_name, text)
    }
}

fn read(document: &DeTable<'_>, mistakes: &Mistakes) -> Option<SweepFile> {
    let file = Section::new(document, Place { span: 0..0, field: String::new() }, FILE, mistakes);
    let aircraft = file.optional("aircraft").map(|item| item.text().map(PathBuf::from));
    let modes = file.optional("modes").map(|item| item.count(0..=10_000));
    let load_modes = file.optional("load_modes").map(|item| item.flag());
    let fixed = file.optional("set").map_or_else(Vec::new, |set| fixed(&set));
    let varied: Vec<Option<Varied>> =
        file.sections("vary", VARY).iter().map(|it| varied(it, mistakes)).collect();
    let varied = varied.into_iter().collect::<Option<Vec<Varied>>>();
    let random = varied.iter().flatten().filter(|it| matches!(&it.law, Law::Axis(axis) if axis.is_random()));
    let chance = chance(&file, random.count() > 0, mistakes);
    let what = "a table [run] with `kind`";
    let run = file.required("run", what).and_then(|item| item.section(RUN)).and_then(|it| run(&it, mistakes));
    file.required("keep", "a list of tables, [[keep]]");
    let keep = run.as_ref().map(|run| {
        let sections = file.sections("keep", KEEP);
        sections.iter().map(|section| keep(section, run, mistakes)).collect::<Vec<_>>()
    });
    let keep = keep?.into_iter().collect::<Option<Vec<Keep>>>();
    let (samples, seed) = chance?;
    Some(SweepFile {
        aircraft: aircraft.flatten(),
        modes: modes.flatten().map(|modes| modes as usize),
        load_modes: load_modes.flatten().unwrap_or(false),
        fixed,
        varied: varied?,
        samples,
        seed,
        run: run?,
        keep: keep?,
    })
}

/// Parameters by dotted names, which TOML has as tables within tables.
fn fixed(set: &Item<'_, '_>) -> Vec<Fixed> {
    fn collect(table: &Item<'_, '_>, prefix: &str, found: &mut Vec<Fixed>) {
        for (key, item) in table.entries().unwrap_or_default() {
            let name = format!("{prefix}{key}");
            if item.is_table() {
                collect(&item, &format!("{name}."), found);
            } else if let Some(value) = item.setting() {
                found.push(Fixed { name, value, place: item.place });
            }
        }
    }
    let mut found = Vec::new();
    collect(set, "", &mut found);
    found
}

fn varied(section: &Section<'_, '_>, mistakes: &Mistakes) -> Option<Varied> {
    let name = section.required("name", "a parameter of the FMU or a name of the aircraft file");
    let law = law(section, mistakes);
    let name = name?;
    let text = name.text()?;
    Some(Varied { name: text.to_owned(), place: name.place, law: law? })
}

/// Exactly one way to vary.
fn law(section: &Section<'_, '_>, mistakes: &Mistakes) -> Option<Law> {
    let ways = [&["values"][..], &["from", "to", "count"], &["uniform"], &["normal"]];
    let is_there = |way: &&&[&str]| way.iter().any(|key| section.optional(key).is_some());
    let mut there = ways.iter().filter(is_there);
    let (Some(way), None) = (there.next(), there.next()) else {
        let found = "found none or several ways to vary";
        let allowed = "allowed is one of `values`, `from` with `to` and `count`, `uniform`, `normal`";
        mistakes.add(&section.place, found, allowed);
        return None;
    };
    let key = way[0];
    let item = section.optional(key);
    match key {
        "values" => values(&item?),
        "from" => {
            let what = "a grid's `from`, `to` and `count`";
            let [from, to, count] = ["from", "to", "count"].map(|key| section.required(key, what));
            let (from, to) = (from.and_then(|it| it.number()), to.and_then(|it| it.number()));
            let count = count.and_then(|it| it.count(1..=MOST_VALUES));
            Some(Law::Axis(Axis::Grid(even(from?, to?, count? as usize))))
        }
        "uniform" => {
            let (item, what) = (item?, "[LEAST, MOST], LEAST < MOST");
            let [least, most] = item.pair(what)?;
            if least < most { Some(Law::Axis(Axis::Uniform { least, most })) } else { item.wrong(what) }
        }
        _ => {
            let (item, what) = (item?, "[MEAN, DEVIATION], DEVIATION > 0");
            let [mean, deviation] = item.pair(what)?;
            if deviation > 0.0 { Some(Law::Axis(Axis::Normal { mean, deviation })) } else { item.wrong(what) }
        }
    }
}

fn values(item: &Item<'_, '_>) -> Option<Law> {
    let list = item.list("a list of numbers, or of names of an enumeration's items")?;
    if list.iter().all(|entry| entry.as_text().is_some()) {
        let items = list.iter().filter_map(|entry| Some((entry.as_text()?.to_owned(), entry.place.clone())));
        return Some(Law::Items(items.collect()));
    }
    let numbers: Vec<Option<f64>> = list.iter().map(Item::number).collect();
    Some(Law::Axis(Axis::Grid(numbers.into_iter().collect::<Option<_>>()?)))
}

/// Samples and seed, at the top of the file or in a table of their own.
fn chance(file: &Section<'_, '_>, is_random: bool, mistakes: &Mistakes) -> Option<(u64, u64)> {
    let table = file.optional("monte_carlo").map(|item| item.section(MONTE_CARLO));
    let of_table = |key: &str| table.as_ref().and_then(|table| table.as_ref()?.optional(key));
    let [samples, seed] = ["samples", "seed"].map(|key| match (file.optional(key), of_table(key)) {
        (Some(one), Some(_)) => {
            mistakes.add(&one.place, format!("found `{key}` twice"), "allowed is here or in [monte_carlo]");
            Some(one)
        }
        (one, other) => one.or(other),
    });
    let seed = match seed {
        Some(item) => item.count(0..=i64::MAX as u64)?,
        None => 1,
    };
    match (samples, is_random) {
        (Some(item), true) => Some((item.count(1..=MOST_POINTS)?, seed)),
        (None, false) => Some((1, seed)),
        (Some(item), false) => {
            let allowed = "allowed is where a [[vary]] is `uniform` or `normal`";
            mistakes.add(&item.place, "found samples, but nothing that is random", allowed);
            None
        }
        (None, true) => {
            file.required("samples", "the number of samples, for `uniform` and `normal`");
            None
        }
    }
}

fn run(section: &Section<'_, '_>, mistakes: &Mistakes) -> Option<Run> {
    #[derive(Clone, Copy)]
    enum Kind {
        Trim,
        Linearise,
        Gust,
        Simulate,
    }
    let kinds = [
        ("trim", Kind::Trim),
        ("linearise", Kind::Linearise),
        ("gust", Kind::Gust),
        ("simulate", Kind::Simulate),
    ];
    let kind = section.required("kind", "trim, linearise, gust or simulate")?.one_of(&kinds)?;
    let keys: &[&str] = match kind {
        Kind::Trim => &[],
        Kind::Linearise => &["inflow"],
        Kind::Gust => &["duration", "step"],
        Kind::Simulate => &["duration", "step", "input"],
    };
    let others = RUN[1..].iter().filter(|key| !keys.contains(key)).filter_map(|key| section.optional(key));
    for other in others {
        let allowed = if keys.is_empty() { "nothing but `kind`".to_owned() } else { keys.join(", ") };
        mistakes.add(&other.place, "found a key of another kind of run", format!("allowed here: {allowed}"));
    }
    let seconds = |key: &str, usual: f64| section.optional(key).map_or(Some(usual), |item| item.seconds());
    match kind {
        Kind::Trim => Some(Run::Trim),
        Kind::Linearise => {
            let words = [("keep", Inflow::Kept), ("steady", Inflow::Steady)];
            let inflow = section.optional("inflow").map_or(Some(Inflow::Kept), |item| item.one_of(&words));
            inflow.map(Run::Linearise)
        }
        Kind::Gust | Kind::Simulate => {
            let (duration, step) = (seconds("duration", USUAL_DURATION), seconds("step", USUAL_STEP));
            let inputs = section.optional("input").map_or(Some(Vec::new()), |item| inputs(&item, mistakes));
            let is_gust = matches!(kind, Kind::Gust);
            let place = section.place.clone();
            Some(Run::Fly(Flown { duration: duration?, step: step?, is_gust, inputs: inputs?, place }))
        }
    }
}

/// As `--input` of `flexair simulate` has them.
fn inputs(item: &Item<'_, '_>, mistakes: &Mistakes) -> Option<Vec<(Given, Place)>> {
    let read = |entry: Item<'_, '_>| match entry.text()?.parse::<Given>() {
        Ok(given) => Some((given, entry.place)),
        Err(error) => {
            mistakes.add_said(&entry.place, &error.to_string());
            None
        }
    };
    let inputs: Vec<_> = item.one_or_more().into_iter().map(read).collect();
    inputs.into_iter().collect()
}

fn keep(section: &Section<'_, '_>, run: &Run, mistakes: &Mistakes) -> Option<Keep> {
    let keys: &[&str] = match run {
        Run::Trim => &["output"],
        Run::Fly(_) => &["output", "reduce"],
        Run::Linearise(_) => &["root", "matrix", "row", "column"],
    };
    for other in KEEP.iter().filter(|key| !keys.contains(key)).filter_map(|key| section.optional(key)) {
        let allowed = format!("allowed here: {}", keys.join(", "));
        mistakes.add(&other.place, "found a key of another kind of run", allowed);
    }
    if let Run::Linearise(_) = run {
        return of_linear_model(section, mistakes);
    }
    let output = section.required("output", "the name of an output, or the first parts of several");
    let reductions = match run {
        Run::Trim => Some(Vec::new()),
        _ => {
            let reduce = section.required("reduce", &Reduction::names())?;
            let found = reduce.one_or_more().into_iter().map(|entry| entry.one_of(&Reduction::ALL));
            found.collect::<Vec<_>>().into_iter().collect()
        }
    };
    let output = output?;
    let name = output.text()?.to_owned();
    Some(Keep::Output { name, place: output.place, reductions: reductions? })
}

fn of_linear_model(section: &Section<'_, '_>, mistakes: &Mistakes) -> Option<Keep> {
    match (section.optional("root"), section.optional("matrix")) {
        (Some(root), None) => {
            let number = root.count(1..=10_000)? as usize;
            Some(Keep::Root { number, place: root.place })
        }
        (None, Some(matrix)) => {
            let matrix = matrix.one_of(&Matrix::ALL);
            let [row, column] = ["row", "column"].map(|key| section.required(key, "a name of the matrix"));
            let [row, column] = [row?.text()?, column?.text()?].map(str::to_owned);
            Some(Keep::Entry { matrix: matrix?, row, column, place: section.place.clone() })
        }
        _ => {
            let allowed = "allowed is `root`, the number of a root, or `matrix` with `row` and `column`";
            mistakes.add(&section.place, "found none or several things to keep", allowed);
            None
        }
    }
}

impl Run {
    /// Whether a gust is flown unless `gust.shape` says otherwise.
    pub fn is_gust(&self) -> bool {
        matches!(self, Run::Fly(Flown { is_gust: true, .. }))
    }
}

#[cfg(test)]
mod tests;

//! What the inputs do over time: a table of comma-separated values, shapes that are built in, or both; a communication step
//! from each row to the next.

use csv::{ReaderBuilder, StringRecord, Trim};
use flexible_aircraft::flight::{Inputs, Simulation, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{InputSlot, VariableTable, instead_of_degrees};

use super::header::{Column, Meaning, columns, other_separator};
use super::shape::Shape;

/// Rows that a history shows, about.
pub const MOST_DRAWN: usize = 20_000;

/// Inputs over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    columns: Vec<Column>,
    /// Ascending in time, at least one; the first has all numbers.
    rows: Vec<Row>,
}

/// What is set at a time.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    /// s.
    time: f64,
    /// One per column; none where its input goes on as it does.
    numbers: Vec<Option<f64>>,
}

/// A communication point.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Point {
    /// s.
    time: f64,
    /// The row whose inputs act from here on; none where those that act go on.
    row: Option<usize>,
}

/// What is wrong with a table, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}, {place}: found {found}, allowed is {allowed}")]
pub struct Mistake {
    line: usize,
    place: String,
    found: String,
    allowed: String,
}

impl Mistake {
    pub fn new(line: usize, place: &str, found: impl Into<String>, allowed: impl Into<String>) -> Self {
        Mistake { line, place: place.to_owned(), found: found.into(), allowed: allowed.into() }
    }
}

impl Schedule {
    /// Reads a table: a line of names, then a line of numbers for each step and one for the end of the last.
    ///
    /// # Errors
    /// At the first thing that is not as it must be.
    pub fn parse(bytes: &[u8], variables: &VariableTable) -> Result<Self, Mistake> {
        let text = text(bytes)?;
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let mut records = reader.records().filter(|record| !record.as_ref().is_ok_and(is_blank));
        let mut next = || match records.next() {
            // PROOF by the settings above: lengths may differ, and the text is UTF-8 in memory. It is told all the same.
            Some(Err(error)) => {
                Err(Mistake::new(0, "all of it", error.to_string(), "comma-separated values"))
            }
            Some(Ok(record)) => Ok(Some((line(&record, text), record))),
            None => Ok(None),
        };
        let (head, names) = next()?.unwrap_or_default();
        let head = head.max(1);
        let names: Vec<&str> = if names.is_empty() { vec![""] } else { names.iter().collect() };
        let columns = columns(&names, head, variables)?;
        let mut rows: Vec<Row> = Vec::new();
        while let Some((line, record)) = next()? {
            let row = row(&record, line, &columns)?;
            if let Some(last) = rows.last().filter(|last| row.time <= last.time) {
                let allowed = format!("a time after that of the row before, {} s", last.time);
                return Err(Mistake::new(line, "time", format!("{} s", row.time), allowed));
            }
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(Mistake::new(head, "time", "no numbers", "a line of numbers for each step"));
        }
        Ok(Schedule { columns, rows })
    }

    /// Nothing is touched for a time, s.
    pub fn hands_off(duration: f64) -> Self {
        let rows = [0.0, duration].map(|time| Row { time, numbers: Vec::new() });
        Schedule { columns: Vec::new(), rows: rows.into() }
    }

    /// An input does what a shape says, too; where that is curved, in chords between the multiples of a step, s.
    pub fn with(self, input: &str, slot: InputSlot, shape: &Shape, step: f64) -> Self {
        let [start, end] = [self.start(), self.end()];
        let inside = shape.edges().into_iter().filter(|edge| start < *edge && *edge < end);
        let edges: Vec<f64> = std::iter::once(start).chain(inside).chain([end]).collect();
        let mut rows = Vec::new();
        for pair in edges.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let curved = Some(step).filter(|_| shape.is_curved_from(from)).into_iter();
            let between = curved.flat_map(|step| multiples(step, from - start, to - start));
            let times = std::iter::once(from).chain(between.map(|past| start + past)).chain([to]);
            let times: Vec<f64> = times.collect();
            rows.extend(times.windows(2).map(|chord| Row {
                time: chord[0],
                numbers: vec![Some(shape.value(chord[0])), Some(shape.slope(chord[0], chord[1]))],
            }));
        }
        // Whoever asked has looked for degrees.
        let value = Column { name: input.to_owned(), meaning: Meaning::Value { slot, is_surface: false } };
        let rate = Column { name: format!("der({input})"), meaning: Meaning::Rate(slot) };
        self.beside(Schedule { columns: vec![value, rate], rows })
    }

    /// Both at once, from the same start on. A row of one alone leaves the inputs of the other as they go on.
    fn beside(self, other: Schedule) -> Self {
        let [ours, theirs] = [&self, &other].map(|schedule| vec![None; schedule.columns.len()]);
        let before = self.rows.into_iter().map(|Row { time, numbers }| (time, [numbers, theirs.clone()]));
        let behind = other.rows.into_iter().map(|Row { time, numbers }| (time, [ours.clone(), numbers]));
        let rows = before.chain(behind).map(|(time, numbers)| Row { time, numbers: numbers.concat() });
        let mut rows: Vec<Row> = rows.collect();
        rows.sort_by(|one, other| one.time.total_cmp(&other.time));
        rows.dedup_by(|next, row| {
            let is_part = next.is_part_of(row);
            if is_part {
                row.take(next);
            }
            is_part
        });
        Schedule { columns: [self.columns, other.columns].concat(), rows }
    }

    /// Whether there is a column of this name.
    pub fn has_column(&self, name: &str) -> bool {
        self.columns.iter().any(|column| column.name == name)
    }

    /// From the first communication point to the last, s.
    pub fn duration(&self) -> f64 {
        self.end() - self.start()
    }

    /// The first communication point, s.
    pub fn start(&self) -> f64 {
        self.rows[0].time
    }

    /// The last communication point, s.
    pub fn end(&self) -> f64 {
        self.rows[self.rows.len() - 1].time
    }

    /// How many rows there are: at least one.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// About how many communication points [`points`](Self::points) gives.
    pub fn point_count(&self, step: Option<f64>) -> f64 {
        self.rows.len() as f64 + step.map_or(0.0, |step| self.duration() / step)
    }

    /// What each input that is set does over time: its name, and (s, value), both values where it jumps. Of very many rows
    /// some stand for all.
    pub fn histories(&self, model: &ReducedModel) -> Vec<(&str, Vec<(f64, f64)>)> {
        let values = self.columns.iter().filter_map(|column| match column.meaning {
            Meaning::Value { slot, .. } => Some((slot, (column.name.as_str(), Vec::new()))),
            Meaning::Rate(_) => None,
        });
        let (slots, mut histories): (Vec<InputSlot>, Vec<_>) = values.unzip();
        let [mut inputs, mut rates] = [Inputs::zero(model), Inputs::zero(model)];
        let (mut before, every) = (self.start(), self.rows.len().div_ceil(MOST_DRAWN));
        for (index, Row { time, .. }) in self.rows.iter().enumerate() {
            // As a flight has it [theory: integration.inputs].
            let elapsed = time - before;
            inputs.wind += elapsed * (inputs.wind_rate + 0.5 * elapsed * rates.wind_rate);
            inputs.add(elapsed, &rates);
            let arrived: Vec<f64> = slots.iter().map(|slot| slot.get(&inputs)).collect();
            self.write(index, &mut inputs, &mut rates);
            before = *time;
            if index % every != 0 && index + 1 != self.rows.len() {
                continue;
            }
            for ((slot, (_, history)), arrived) in slots.iter().zip(&mut histories).zip(arrived) {
                let value = slot.get(&inputs);
                if index > 0 && arrived != value {
                    history.push((*time, arrived));
                }
                history.push((*time, value));
            }
        }
        histories
    }

    /// Communication points, ascending: the rows, and between them the multiples of the step, s, from the start on.
    fn points(&self, step: Option<f64>) -> impl Iterator<Item = Point> {
        let start = self.start();
        (0..self.rows.len()).flat_map(move |row| {
            let (time, end) = (self.rows[row].time, self.rows.get(row + 1).map(|next| next.time));
            let between = step.zip(end).into_iter().flat_map(move |(step, end)| {
                multiples(step, time - start, end - start)
                    .map(move |past| Point { time: start + past, row: None })
            });
            std::iter::once(Point { time, row: Some(row) }).chain(between)
        })
    }

    /// Flies what stands at the start, and has somebody look at each communication point, as a master does at the end of the
    /// step that leads there; the point's own inputs act from then on. Between the rows there are points in steps, s.
    ///
    /// # Errors
    /// When the flight has to end, or who looks wants no more.
    pub fn fly<E: From<SimulationError>>(
        &self,
        simulation: &mut Simulation,
        model: &ReducedModel,
        step: Option<f64>,
        mut look: impl FnMut(f64, &mut Simulation) -> Result<(), E>,
    ) -> Result<(), E> {
        let [mut inputs, mut rates] = [Inputs::zero(model), Inputs::zero(model)];
        self.write(0, &mut inputs, &mut rates);
        simulation.set_inputs(&inputs, &rates);
        for Point { time, row } in self.points(step) {
            simulation.advance_to(time)?;
            look(time, simulation)?;
            if let Some(row) = row {
                // Where a row sets the rate of the wind alone, the wind goes on from what it is.
                simulation.write_inputs(&mut inputs);
                self.write(row, &mut inputs, &mut rates);
                simulation.set_inputs(&inputs, &rates);
            }
        }
        Ok(())
    }

    /// Writes the inputs that act from the communication point with this row on, and their rates.
    fn write(&self, row: usize, inputs: &mut Inputs, rates: &mut Inputs) {
        for (column, number) in self.columns.iter().zip(&self.rows[row].numbers) {
            match (column.meaning, number) {
                (Meaning::Value { slot, .. }, Some(number)) => *slot.of(inputs) = *number,
                (Meaning::Rate(slot), Some(number)) => *slot.of(rates) = *number,
                (_, None) => {}
            }
        }
    }
}

impl Row {
    /// Whether it is at the time of the one before, but for rounding, and sets other inputs.
    fn is_part_of(&self, other: &Row) -> bool {
        const ROUNDING: f64 = 1e-9;
        let mut both = self.numbers.iter().zip(&other.numbers);
        self.time - other.time < ROUNDING && !both.any(|(one, other)| one.is_some() && other.is_some())
    }

    /// Sets what the other does, too.
    fn take(&mut self, other: &Row) {
        for (number, other) in self.numbers.iter_mut().zip(&other.numbers) {
            *number = number.or(*other);
        }
    }
}

/// The multiples of a step between two times, neither of which is repeated because of rounding.
fn multiples(step: f64, from: f64, to: f64) -> impl Iterator<Item = f64> {
    // In parts of a step.
    const ROUNDING: f64 = 1e-6;
    let first = (from / step + ROUNDING).floor() + 1.0;
    let last = (to / step - ROUNDING).ceil() - 1.0;
    // Of 0.01, the 57th is 57/100: its digits are as few as people expect, other than those of 57 · 0.01.
    let per_second = (1.0 / step).round();
    let is_a_part = (per_second * step - 1.0).abs() < 1e-12;
    let multiple = move |n: f64| if is_a_part { n / per_second } else { n * step };
    (first as u64..=last as u64).map(move |n| multiple(n as f64))
}

/// The text without the mark that some programs begin it with.
fn text(bytes: &[u8]) -> Result<&str, Mistake> {
    let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    let found = if wide { "a text in UTF-16" } else { "bytes that are no text in UTF-8" };
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
        Mistake::new(line, "all of it", found, "a text in UTF-8")
    })?;
    Ok(text.trim_start_matches('\u{feff}'))
}

/// Whether a line holds nothing but blanks.
fn is_blank(record: &StringRecord) -> bool {
    record.len() == 1 && record[0].is_empty()
}

/// The line of a record, which its reader places before the empty lines above it.
fn line(record: &StringRecord, text: &str) -> usize {
    let Some(position) = record.position() else { return 1 };
    let bytes = text.as_bytes().iter().skip(position.byte() as usize);
    let empty = bytes.take_while(|byte| matches!(byte, b'\n' | b'\r')).filter(|byte| **byte == b'\n').count();
    position.line() as usize + empty
}

/// The finite numbers of a line: a time, and one per column.
fn row(record: &StringRecord, line: usize, columns: &[Column]) -> Result<Row, Mistake> {
    if record.iter().any(|cell| cell.contains('\n')) {
        let (found, allowed) = ("a quoted text over several lines", "quotes that are closed in their line");
        return Err(Mistake::new(line, "all of it", found, allowed));
    }
    if record[0].starts_with('#') {
        return Err(Mistake::new(line, "all of it", "`#`", "numbers: there are no comments"));
    }
    if record.len() != 1 + columns.len() {
        let found = match other_separator(&record[0]).filter(|_| record.len() == 1) {
            Some(separator) => format!("{separator} between the numbers"),
            None if record.len() == 1 => "1 column".to_owned(),
            None => format!("{} columns", record.len()),
        };
        let allowed = format!("{}, as in the line of names, with commas between them", 1 + columns.len());
        return Err(Mistake::new(line, "all of it", found, allowed));
    }
    let time = number(&record[0], line, "time")?;
    let numbers = record.iter().skip(1).zip(columns).map(|(cell, column)| of_column(cell, line, column));
    Ok(Row { time, numbers: numbers.map(|number| number.map(Some)).collect::<Result<_, _>>()? })
}

fn number(cell: &str, line: usize, column: &str) -> Result<f64, Mistake> {
    let number: Option<f64> = cell.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| Mistake::new(line, column, format!("`{cell}`"), "a finite number"))
}

fn of_column(cell: &str, line: usize, column: &Column) -> Result<f64, Mistake> {
    let number = number(cell, line, &column.name)?;
    let is_surface = matches!(column.meaning, Meaning::Value { is_surface: true, .. });
    match instead_of_degrees(number).filter(|_| is_surface) {
        Some(allowed) => Err(Mistake::new(line, &column.name, number.to_string(), allowed)),
        None => Ok(number),
    }
}

#[cfg(test)]
mod tests;

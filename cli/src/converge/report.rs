//! What `flexair converge` prints: a table with a column for each number of modes, and the verdict.

use std::fmt::Write;

use flexible_aircraft::plant::ModeSelection;

use super::quantity::{Quantity, Value};
use super::study::Study;
use super::verdict::percent;
use crate::condition::Airspeeds;
use crate::numbers::{Plain, fixed};

/// The whole report.
pub fn text(study: &Study) -> String {
    let mut text = heading(study);
    text += &table(study);
    text += &remarks(study);
    let verdict = study.verdict.text(&study.quantities, &study.labels(), study.has_load_modes());
    text + "\n" + &verdict + "\n"
}

fn heading(study: &Study) -> String {
    let Some(row) = study.last() else { return String::new() };
    let analysis = &row.analysis;
    let family = match analysis.settings.mode_selection {
        ModeSelection::All => "modes of all families",
        ModeSelection::Symmetric => "symmetric modes",
    };
    let loads = if study.has_load_modes() { " with load modes (natural + load)" } else { "" };
    let Airspeeds { from, to, .. } = analysis.airspeeds;
    format!(
        "{}, {} at {} m/s\n{}flutter and divergence from {} to {} m/s\n\n",
        analysis.model.name,
        analysis.support(),
        Plain(study.airspeed),
        analysis.condition(&format!("{family}{loads}")),
        Plain(from),
        Plain(to),
    )
}

/// A line of the table: a name, a cell for each number of modes, by how much the last step moved it.
struct Line {
    name: String,
    cells: Vec<String>,
    last_step: String,
}

fn table(study: &Study) -> String {
    let mut lines = vec![Line { name: "modes".into(), cells: study.labels(), last_step: "last step".into() }];
    for quantity in study.distinct() {
        lines.extend(self::lines(&quantity));
    }
    let letters = |text: &String| text.chars().count();
    let names = lines.iter().map(|line| letters(&line.name)).max().unwrap_or(0);
    let width = |cell: usize| lines.iter().map(|line| letters(&line.cells[cell])).max().unwrap_or(0);
    let widths: Vec<usize> = (0..study.rows.len()).map(width).collect();
    let mut text = String::new();
    for Line { name, cells, last_step } in &lines {
        let mut line = format!("  {name:names$}");
        for (cell, width) in cells.iter().zip(&widths) {
            let _ = write!(line, "  {cell:>width$}");
        }
        if study.rows.len() > 1 {
            let _ = write!(line, "  {last_step:>9}");
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// One line for a number, two for a root.
fn lines(quantity: &Quantity) -> Vec<Line> {
    let last = quantity.values.len() - 1;
    let moved = |from: usize| percent(quantity.change(from, last));
    let last_step = match last.checked_sub(1).filter(|_| quantity.kind.is_some()) {
        Some(from) if !matches!(quantity.values[last], Value::Outside(_)) => moved(from),
        _ => String::new(),
    };
    let Quantity { name, unit, places, .. } = quantity;
    if !quantity.is_root() {
        let cells = (0..=last).map(|row| quantity.text(row)).collect();
        return vec![Line { name: format!("{name} ({unit})"), cells, last_step }];
    }
    let parts = [("grows", 0, last_step), ("swings", 1, String::new())];
    let part = |(what, part, last_step): (&str, usize, String)| {
        let cell = |value: &Value| match value {
            Value::Root(root) => fixed([root.re, root.im][part], *places),
            _ => "–".to_owned(),
        };
        let unit = ["1/s", "rad/s"][part];
        Line {
            name: format!("{name} {what} ({unit})"),
            cells: quantity.values.iter().map(cell).collect(),
            last_step,
        }
    };
    parts.into_iter().map(part).collect()
}

/// What is to be said of single numbers of modes.
fn remarks(study: &Study) -> String {
    let mut text = String::new();
    for row in &study.rows {
        let trim = row.trim.as_ref().err().map(|reason| format!("no trim: {reason}"));
        for remark in trim.iter().chain(&row.remarks) {
            let _ = write!(text, "\n  {} modes: {remark}", row.label());
        }
    }
    if text.is_empty() { text } else { text + "\n" }
}

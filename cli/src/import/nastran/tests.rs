//! Decks from text to aircraft: formats, closed forms, what is reported.

mod bounds;
mod cards;
mod flaps;
mod frequencies;
mod loops;
mod mutated;
mod panels;
mod read;
mod sections;
mod told;

use std::path::Path;

use flexible_aircraft::Aircraft;
use flexible_aircraft::structure::{ModalBasis, ModeCount, ModeKind, Structure};

use super::conversion::{Imported, import, of_text};
use super::request::{OneText, Request};
use super::units::UnitSystem;

/// A deck as cards: a name and its fields.
type Cards = Vec<(&'static str, Vec<String>)>;

/// A card from a line of words; `-` is a blank field.
fn card(line: &'static str) -> (&'static str, Vec<String>) {
    let mut words = line.split_whitespace();
    let name = words.next().unwrap();
    (name, words.map(|word| if word == "-" { String::new() } else { word.to_owned() }).collect())
}

fn cards(lines: &'static str) -> Cards {
    lines.lines().map(str::trim).filter(|line| !line.is_empty()).map(card).collect()
}

/// In columns of eight.
fn small(cards: &Cards) -> String {
    let mut text = String::new();
    for (name, fields) in cards {
        for (line, fields) in fields.chunks(8).enumerate() {
            let head = if line == 0 { name } else { "+" };
            text += &format!(
                "{head:<8}{}\n",
                fields.iter().map(|field| format!("{field:>8}")).collect::<String>()
            );
        }
    }
    text
}

/// In columns of sixteen, four to a line.
fn large(cards: &Cards) -> String {
    let mut text = String::new();
    for (name, fields) in cards {
        let mut fields = fields.clone();
        fields.resize(fields.len().next_multiple_of(8), String::new());
        for (line, fields) in fields.chunks(4).enumerate() {
            let head = if line == 0 { format!("{name}*") } else { "*".to_owned() };
            text += &format!(
                "{head:<8}{}\n",
                fields.iter().map(|field| format!("{field:>16}")).collect::<String>()
            );
        }
    }
    text
}

/// Between commas.
fn free(cards: &Cards) -> String {
    let mut text = String::new();
    for (name, fields) in cards {
        for (line, fields) in fields.chunks(8).enumerate() {
            text += &format!("{}, {}\n", if line == 0 { name } else { "+" }, fields.join(", "));
        }
    }
    text
}

/// Lines between commas that are too long, continued.
fn wrapped(text: &str) -> String {
    let line = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let (name, data) = fields.split_first().unwrap();
        let lines = data.chunks(8).map(|data| data.join(","));
        format!("{name},{}\n", lines.collect::<Vec<_>>().join("\n+,"))
    };
    text.lines().map(|one| if one.contains(',') { line(one) } else { format!("{one}\n") }).collect()
}

#[track_caller]
fn imported(text: &str) -> Imported {
    of_text(&wrapped(text)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// What is reported, a line each.
fn reports(imported: &Imported) -> Vec<String> {
    let shown = |remark: &super::mistakes::Remark| {
        format!("{}: {}: {}", imported.deck.shown(remark.place), remark.what, remark.said)
    };
    imported.remarks.general.iter().cloned().chain(imported.remarks.reports.iter().map(shown)).collect()
}

/// Natural frequencies held at O, rad/s.
fn frequencies(aircraft: &Aircraft, count: usize) -> Vec<f64> {
    let structure = Structure::new(aircraft).unwrap();
    let basis = ModalBasis::with(&structure, ModeCount::Usual(count), ModeKind::All).unwrap();
    basis.modes.iter().map(|mode| mode.angular_frequency).collect()
}

/// What rests of a file without its comments.
fn without_comments(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split(" # ").next().unwrap_or_default().trim_end().to_owned() + "\n").collect()
}

//! What became of a deck, for people: what was taken, what is not held, what the aircraft is.

use std::path::Path;

use super::conversion::Imported;
use super::deck::Place;
use super::mistakes::Remark;
use crate::describe::{Description, text};
use crate::files::named;
use crate::flown::FlownOptions;
use crate::numbers::short;

/// Larger aircraft are described by the command of this name: their modes take minutes.
const MOST_ELEMENTS: usize = 400;

/// From so many lines on that say the same, they are told together.
const TOGETHER: usize = 4;

/// All of it.
pub fn text(imported: &Imported, output: &Path) -> String {
    let shown = named(output, "standard output");
    let mut text = format!("{shown}: written from {}\n\n", imported.files().next().unwrap_or_default());
    text += &format!("read: {}\n", counts(imported));
    text += &imported.taken.iter().map(|line| format!("{line}\n")).collect::<String>();
    text += &imported.remarks.notes.iter().map(|note| format!("note: {note}\n")).collect::<String>();
    text += &not_of_the_aircraft(imported);
    text += &reports(imported);
    text += &masses(imported);
    text + "\n" + &described(imported)
}

fn counts(imported: &Imported) -> String {
    let cards = &imported.cards;
    let aero = &cards.aero;
    let counts = [
        ("GRID", cards.grids.len()),
        ("coordinate systems", cards.frames.len()),
        ("elements", cards.elements.len()),
        ("CONM1 and CONM2", cards.lumps.len()),
        ("rigid links", cards.rigids.len() + cards.spreads.len()),
        ("CAERO1", aero.panels.len()),
        ("splines", aero.splines.len()),
        ("AESURF", aero.surfaces.len()),
    ];
    let there = counts.iter().filter(|(_, count)| *count > 0);
    there.map(|(what, count)| format!("{count} {what}")).collect::<Vec<_>>().join(", ")
}

/// Lines that say what is computed; they are no reports.
fn not_of_the_aircraft(imported: &Imported) -> String {
    let mut kinds: Vec<String> = Vec::new();
    if !imported.deck.control_lines.is_empty() {
        kinds.push(format!(
            "executive and case control, but for SPC and PARAM ({})",
            lines(imported, &imported.deck.control_lines)
        ));
    }
    let cards = &imported.cards.of_analyses;
    kinds.extend(cards.iter().map(|(name, places)| format!("{name} ({})", lines(imported, places))));
    if kinds.is_empty() {
        return String::new();
    }
    format!("not read, for it says what is computed and not what flies: {}\n", kinds.join(", "))
}

/// `wing.bdf:3-5, 9`.
fn lines(imported: &Imported, places: &[Place]) -> String {
    let mut runs: Vec<(Place, usize)> = Vec::new();
    for &place in places {
        match runs.last_mut().filter(|(first, last)| first.file == place.file && *last + 1 == place.line) {
            Some((_, last)) => *last = place.line,
            None => runs.push((place, place.line)),
        }
    }
    let mut file = None;
    let shown = runs.iter().map(|(first, last)| {
        let begin = if file.replace(first.file) == Some(first.file) {
            first.line.to_string()
        } else {
            imported.deck.shown(*first)
        };
        if *last > first.line { format!("{begin}-{last}") } else { begin }
    });
    shown.collect::<Vec<_>>().join(", ")
}

fn reports(imported: &Imported) -> String {
    let remarks = &imported.remarks;
    let count = remarks.reports.len() + remarks.general.len();
    if count == 0 {
        return "\nnothing of the aircraft is left out\n".to_owned();
    }
    let word = if count == 1 { "report" } else { "reports" };
    let mut text = format!("\n{count} {word} of what is not held as the deck has it:\n");
    text += &remarks.general.iter().map(|said| format!("  {said}\n")).collect::<String>();
    let mut reports: Vec<&Remark> = remarks.reports.iter().collect();
    reports.sort_by_key(|remark| remark.place);
    let mut rest = reports.as_slice();
    while let Some(first) = rest.first() {
        let is_alike = |remark: &Remark| {
            remark.said == first.said || (first.of_many.is_some() && remark.of_many == first.of_many)
        };
        let is_same = |remark: &&&Remark| is_alike(remark) && card(remark) == card(first);
        let same = rest.iter().take_while(is_same).count();
        let told = if same >= TOGETHER { same } else { 1 };
        if told > 1 {
            let places: Vec<Place> = rest[..told].iter().map(|remark| remark.place).collect();
            let said = match first.of_many {
                Some(of_many) => format!("{of_many}; {}: {}", first.what, first.said),
                None => first.said.clone(),
            };
            text += &format!("  {}: {told} {}: {said}\n", lines(imported, &places), card(first));
        } else {
            let place = match first.what.starts_with("--") {
                true => "command line".to_owned(),
                false => imported.deck.shown(first.place),
            };
            text += &format!("  {place}: {}: {}\n", first.what, first.said);
        }
        rest = &rest[told..];
    }
    text
}

fn card(remark: &Remark) -> &str {
    remark.what.split(' ').next().unwrap_or_default()
}

fn masses(imported: &Imported) -> String {
    let [lumps, elements] = imported.masses;
    let written: f64 = imported.aircraft.bays.iter().map(|bay| bay.mass).sum();
    format!(
        "\nmass: {} kg of CONM1 and CONM2 and {} kg of elements in the deck, {} kg in the file\n",
        short(lumps),
        short(elements),
        short(written)
    )
}

/// As `flexair describe` has it; that there is no trim is no mistake.
fn described(imported: &Imported) -> String {
    if imported.aircraft.beams.len() > MOST_ELEMENTS {
        return format!(
            "its modes are not computed here, for it has {} elements: flexair describe\n",
            imported.aircraft.beams.len()
        );
    }
    match Description::new(&imported.aircraft, &FlownOptions::default()) {
        Ok(description) => text::text(&description),
        Err(error) => format!("it cannot be described: {error}\n"),
    }
}

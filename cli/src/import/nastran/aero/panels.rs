//! All panels: CAERO1 with the grids that carry them, and those of `--surface`.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::cards::{AeroCards, Cards, Division, PanelCard, Spline, SplineBoxes};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::super::structure::Structure;
use super::chordwise::joined;
use super::line::SurfaceLine;
use super::panel::{CarriedBy, Panel, Patch, SAME};
use super::trapezium::Trapezium;

/// All panels, of the deck and of the command line.
pub fn panels(
    (cards, world): (&Cards, &World),
    structure: &Structure,
    lines: &[SurfaceLine],
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Panel> {
    let aero = &cards.aero;
    let of_cards: Vec<Panel> = aero
        .panels
        .iter()
        .filter_map(|card| of_card(card, (cards, world), structure, (mistakes, remarks)))
        .collect();
    tell_panels_without_splines(&of_cards, remarks);
    let mut panels = joined(of_cards, remarks);
    for (place, line) in lines.iter().enumerate() {
        panels.extend(of_line((place, line), world, structure, mistakes));
    }
    let known: BTreeSet<i64> = aero.panels.iter().map(|panel| panel.origin.id).collect();
    for spline in aero.splines.iter().filter(|spline| !known.contains(&spline.panel)) {
        mistakes.missing(&spline.origin, "CAERO", spline.panel, Needed::Card("a CAERO1"));
    }
    panels
}

fn of_card(
    card: &PanelCard,
    (cards, world): (&Cards, &World),
    structure: &Structure,
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Option<Panel> {
    let corners =
        card.corners.map(|corner| world.point(card.frame, corner).map(|place| place - structure.origin));
    let [Some(inboard), Some(outboard)] = corners else {
        mistakes.missing(&card.origin, "CP", card.frame, Needed::Frame);
        return None;
    };
    let spanwise = edges(&cards.aero, card, (card.spanwise, "LSPAN"), mistakes)?;
    let chordwise = edges(&cards.aero, card, (card.chordwise, "LCHORD"), mistakes)?;
    let chords = card.chords.map(|chord| chord * world.length());
    let outline = Trapezium { corners: [inboard, outboard], chords };
    let patch = Patch { origin: card.origin.clone(), outline: outline.clone(), spanwise, chordwise };
    let carried_by = carried_by(cards, card, mistakes)?;
    tell_boxes_without_splines(cards, &patch, remarks);
    let panel = Panel { origin: card.origin.clone(), outline, patches: vec![patch], carried_by, flap: None };
    if panel.outline.span().norm() < 1e-6 {
        let found = "found no span across the flow";
        mistakes.of_origin(
            &card.origin,
            "X1, X4",
            found,
            "corners are needed that are apart across x of the aerodynamic frame",
        );
        return None;
    }
    Some(panel)
}

fn edges(
    aero: &AeroCards,
    card: &PanelCard,
    (division, name): (Division, &str),
    mistakes: &mut Mistakes,
) -> Option<Vec<f64>> {
    match division {
        Division::Equal(count) => Some((0..=count).map(|edge| edge as f64 / count as f64).collect()),
        Division::List(id) => {
            let fractions = aero.fractions.get(&id);
            let found = fractions
                .map_or_else(|| format!("found {id}"), |list| format!("found {list:?} in AEFACT {id}"));
            let is_good = |list: &&Vec<f64>| {
                list.len() > 1
                    && list.windows(2).all(|pair| pair[0] < pair[1])
                    && list[0].abs() <= SAME
                    && (list[list.len() - 1] - 1.0).abs() <= SAME
            };
            let good = fractions.filter(is_good);
            if good.is_none() {
                mistakes.of_origin(
                    &card.origin,
                    name,
                    found,
                    "an AEFACT of the deck is needed with ascending fractions from 0 to 1",
                );
            }
            good.cloned()
        }
    }
}

fn carried_by(cards: &Cards, card: &PanelCard, mistakes: &mut Mistakes) -> Option<CarriedBy> {
    let mut grids = BTreeSet::new();
    let mut has_spline = false;
    for spline in splines(cards, &card.origin) {
        let Some(set) = cards.aero.sets.get(&spline.set) else {
            mistakes.missing(&spline.origin, "SETG", spline.set, Needed::Card("a SET1"));
            return None;
        };
        cards.missing_grids((&set.origin, "G"), &set.ids, mistakes);
        if let SplineBoxes::List(list) = spline.boxes
            && !cards.aero.boxes.contains_key(&list)
        {
            mistakes.missing(&spline.origin, "AELIST", list, Needed::Card("an AELIST"));
        }
        grids.extend(cards.grids_in(&set.ids));
        has_spline = true;
    }
    Some(if has_spline { CarriedBy::Grids(grids.into_iter().collect()) } else { CarriedBy::Nearest })
}

fn splines<'c>(cards: &'c Cards, panel: &Origin) -> impl Iterator<Item = &'c Spline> {
    let id = panel.id;
    cards.aero.splines.iter().filter(move |spline| spline.panel == id)
}

fn tell_panels_without_splines(panels: &[Panel], remarks: &mut Remarks) {
    let without = panels.iter().filter(|panel| panel.carried_by == CarriedBy::Nearest);
    let names: Vec<String> = without.map(|panel| panel.origin.to_string()).collect();
    match names.as_slice() {
        [] => {}
        [one] => remarks.note(format!("{one}: no spline names it, it is carried by the beam beside it")),
        several => remarks.note(format!(
            "{}: no spline names them, each is carried by the beam beside it",
            several.join(", ")
        )),
    }
}

/// Says that boxes which no spline moves are carried as the others are: BOX1 and BOX2 are corners of a rectangle, an AELIST lists them.
fn tell_boxes_without_splines(cards: &Cards, patch: &Patch, remarks: &mut Remarks) {
    let boxes = patch.boxes();
    let mut is_moved = vec![false; boxes.clone().count()];
    let mut has_spline = false;
    for spline in splines(cards, &patch.origin) {
        has_spline = true;
        let of_panel = |id: i64| patch.place(id).map(|place| patch.index(place));
        let corners = match spline.boxes {
            SplineBoxes::Corners(corners) => corners,
            SplineBoxes::List(list) => {
                let runs =
                    cards.aero.boxes.get(&list).into_iter().flat_map(|list| list.ids.within(boxes.clone()));
                let moved = runs.flat_map(|(from, to)| from..=to).filter_map(of_panel);
                moved.for_each(|place| is_moved[place] = true);
                continue;
            }
        };
        let corners = [corners[0].unwrap_or(boxes.start), corners[1].unwrap_or(boxes.end - 1)];
        let places = corners.map(|id| patch.place(id));
        let [Some((strip, row)), Some((last_strip, last_row))] = places else {
            let said =
                format!("found {} to {}, of which {} has no box", corners[0], corners[1], patch.origin);
            remarks.card(&spline.origin, said);
            continue;
        };
        for strip in strip.min(last_strip)..=strip.max(last_strip) {
            for row in row.min(last_row)..=row.max(last_row) {
                is_moved[patch.index((strip, row))] = true;
            }
        }
    }
    let still = is_moved.iter().filter(|moved| !**moved).count();
    if has_spline && still > 0 {
        remarks.note(format!(
            "{}: no spline moves {still} of its {} boxes (BOX1, BOX2, AELIST); all are carried by the grids of its splines",
            patch.origin,
            is_moved.len()
        ));
    }
}

fn of_line(
    (place, line): (usize, &SurfaceLine),
    world: &World,
    structure: &Structure,
    mistakes: &mut Mistakes,
) -> Option<Panel> {
    let places = line.grids.map(|grid| world.grid(grid).map(|at| at - structure.origin));
    let [Some(one), Some(other)] = places else {
        mistakes.of_whole(format!(
            "--surface: found {} and {}, two GRIDs of the deck are needed",
            line.grids[0], line.grids[1]
        ));
        return None;
    };
    let ahead = |at: Vector3<f64>, chord: f64| at + Vector3::x() * (line.axis * chord);
    let panel = Panel {
        origin: Origin { card: "--surface", id: place as i64 + 1, place: Default::default() },
        outline: Trapezium {
            corners: [ahead(one, line.chords[0]), ahead(other, line.chords[1])],
            chords: line.chords,
        },
        patches: Vec::new(),
        carried_by: CarriedBy::Between(line.grids),
        flap: line.flap.clone(),
    };
    if panel.outline.span().norm() < 1e-6 {
        mistakes.of_whole(format!(
            "--surface {}:{}: found no span, two grids apart across x are needed",
            line.grids[0], line.grids[1]
        ));
        return None;
    }
    Some(panel)
}

//! All panels: CAERO1 with the grids that carry them, and those of `--surface`.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::cards::{AeroCards, Cards, Division, PanelCard};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::super::structure::Structure;
use super::chordwise::joined;
use super::line::SurfaceLine;
use super::panel::{CarriedBy, Panel, Patch};

/// All panels, of the deck and of the command line.
pub fn panels(
    (cards, world): (&Cards, &World),
    structure: &Structure,
    lines: &[SurfaceLine],
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Panel> {
    let aero = &cards.aero;
    let of_cards = aero
        .panels
        .iter()
        .filter_map(|card| of_card(card, (cards, world), structure, (mistakes, remarks)))
        .collect();
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
    let patch =
        Patch { origin: card.origin.clone(), corners: [inboard, outboard], chords, spanwise, chordwise };
    let carried_by = carried_by((cards, card), patch.boxes(), (mistakes, remarks))?;
    if carried_by == CarriedBy::Nearest {
        remarks.note(format!(
            "{}: no SPLINE1 or SPLINE2 names it, it is carried by the beam beside it",
            card.origin
        ));
    }
    let panel = Panel {
        origin: card.origin.clone(),
        corners: [inboard, outboard],
        chords,
        patches: vec![patch],
        carried_by,
        flap: None,
    };
    if panel.span().norm() < 1e-6 {
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
                    && list.iter().all(|edge| (-1e-9..=1.0 + 1e-9).contains(edge))
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

fn carried_by(
    (cards, card): (&Cards, &PanelCard),
    boxes: std::ops::Range<i64>,
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Option<CarriedBy> {
    let splines = cards.aero.splines.iter().filter(|spline| spline.panel == card.origin.id);
    let mut grids = BTreeSet::new();
    let (mut first, mut last, mut count) = (i64::MAX, i64::MIN, 0);
    for spline in splines {
        let Some(set) = cards.aero.sets.get(&spline.set) else {
            mistakes.missing(&spline.origin, "SETG", spline.set, Needed::Card("a SET1"));
            return None;
        };
        cards.missing_grids((&set.origin, "G"), &set.ids, mistakes);
        grids.extend(cards.grids_in(&set.ids));
        first = first.min(spline.boxes[0].unwrap_or(boxes.start));
        last = last.max(spline.boxes[1].unwrap_or(boxes.end - 1));
        count += 1;
    }
    if count == 0 {
        return Some(CarriedBy::Nearest);
    }
    if first > boxes.start || last < boxes.end - 1 {
        remarks.note(format!(
            "{}: its splines move boxes {first} to {last} of {} to {}; all of them are carried here",
            card.origin,
            boxes.start,
            boxes.end - 1
        ));
    }
    Some(CarriedBy::Grids(grids.into_iter().collect()))
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
        corners: [ahead(one, line.chords[0]), ahead(other, line.chords[1])],
        chords: line.chords,
        patches: Vec::new(),
        carried_by: CarriedBy::Between(line.grids),
        flap: line.flap.clone(),
    };
    if panel.span().norm() < 1e-6 {
        mistakes.of_whole(format!(
            "--surface {}:{}: found no span, two grids apart across x are needed",
            line.grids[0], line.grids[1]
        ));
        return None;
    }
    Some(panel)
}

//! AESURF with its boxes and hinge as flaps on panels: from where to where along the span, hinged where, turned which way.

use std::collections::BTreeSet;

use nalgebra::Vector3;

use super::super::cards::{Cards, Ids, SurfaceCard, boxes};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::super::names::Names;
use super::super::structure::Structure;
use super::panel::{Panel, SAME};

/// Hinges nearer to an edge of the chord than this leave no flap, or no section before it.
const HINGES: std::ops::RangeInclusive<f64> = 0.02..=0.98;

/// Boxes nearer to the rear edge than this share of the chord reach it.
const REAR: f64 = 2e-3;

/// A hinge whose fraction of the chord changes by more than this along the flap is told of.
const TAPER: f64 = 0.05;

/// A control surface, or several that turn together: an input of the aircraft.
#[derive(Clone, Debug)]
pub struct Control {
    pub origin: Origin,
    pub name: String,
    /// As the deck calls it.
    pub label: String,
    /// Least and greatest angle, rad.
    pub limits: Option<[f64; 2]>,
    pub parts: Vec<ControlPart>,
}

/// A flap on a panel.
#[derive(Clone, Debug)]
pub struct ControlPart {
    /// The card of its control.
    pub origin: Origin,
    pub panel: usize,
    /// As fractions of the panel's span.
    pub from: f64,
    pub to: f64,
    /// As a fraction of the chord.
    pub hinge: f64,
    /// 1 where a positive angle is about the hinge to the right or upwards, else −1; of what an AELINK turns by its coefficient.
    pub gain: f64,
    /// Lift by that of an unswept flap that is wholly effective: the deck's effectiveness times cos² of the hinge's sweep.
    pub effectiveness: f64,
}

/// All controls, of the deck and of the command line.
pub fn controls(
    (cards, world): (&Cards, &World),
    structure: &Structure,
    panels: &[Panel],
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Control> {
    boxes_of_no_panel(cards, remarks);
    let mut making = Making { cards, world, structure, panels, mistakes, remarks };
    let mut controls: Vec<Control> = cards.aero.surfaces.iter().map(|card| making.control(card)).collect();
    for (panel, found) in panels.iter().enumerate() {
        let Some((name, hinge)) = &found.flap else { continue };
        let origin = found.origin.clone();
        let part =
            ControlPart { origin, panel, from: 0.0, to: 1.0, hinge: *hinge, gain: 1.0, effectiveness: 1.0 };
        match controls.iter_mut().find(|control| control.label == *name) {
            Some(control) => control.parts.push(part),
            None => controls.push(Control {
                origin: found.origin.clone(),
                name: String::new(),
                label: name.clone(),
                limits: None,
                parts: vec![part],
            }),
        }
    }
    controls.retain(|control| !control.parts.is_empty());
    name(&mut controls);
    controls
}

/// Angles that both may have.
pub fn both(one: Option<[f64; 2]>, other: Option<[f64; 2]>) -> Option<[f64; 2]> {
    match (one, other) {
        (Some(one), Some(other)) => Some([one[0].max(other[0]), one[1].min(other[1])]),
        (one, other) => one.or(other),
    }
}

/// Names that an aircraft file takes, each once.
fn name(controls: &mut [Control]) {
    let mut names = Names::default();
    for control in controls {
        control.name = names.free(&control.label, "control");
    }
}

/// Says of lists of control surfaces which of their boxes are none.
fn boxes_of_no_panel(cards: &Cards, remarks: &mut Remarks) {
    let mut ranges: Vec<std::ops::Range<i64>> =
        cards.aero.panels.iter().map(|panel| boxes(cards, panel)).collect();
    ranges.sort_by_key(|range| range.start);
    let used: BTreeSet<i64> =
        cards.aero.surfaces.iter().flat_map(|card| &card.parts).map(|(_, list)| *list).collect();
    for list in used.iter().filter_map(|list| cards.aero.boxes.get(list)) {
        if let Some((first, count)) = beside(&list.ids, &ranges) {
            let more = if count > 1 { format!(" and {} more", count - 1) } else { String::new() };
            let said = format!("found {first}{more}, of which no CAERO1 has a box: nothing is moved there");
            remarks.card(&list.origin, said);
        }
    }
}

/// The first number of a list that is in none of some ascending ranges, and how many there are.
fn beside(ids: &Ids, ranges: &[std::ops::Range<i64>]) -> Option<(i64, u64)> {
    let mut found = None;
    let mut add = |from: i64, to: i64| {
        if from < to {
            let (_, count) = found.get_or_insert((from, 0));
            *count += to.abs_diff(from);
        }
    };
    for (from, to) in ids.runs() {
        let mut next = from;
        let first = ranges.partition_point(|range| range.end <= from);
        for range in ranges[first..].iter().take_while(|range| range.start <= to) {
            add(next, range.start);
            next = range.end;
        }
        add(next, to.saturating_add(1));
    }
    found
}

/// To the right, or up where it is upright: the sense of span axes.
pub fn is_rightwards(span: &Vector3<f64>) -> bool {
    if span.y.abs() > 1e-9 * span.norm() { span.y > 0.0 } else { span.z < 0.0 }
}

struct Making<'a> {
    cards: &'a Cards,
    world: &'a World,
    structure: &'a Structure,
    panels: &'a [Panel],
    mistakes: &'a mut Mistakes,
    remarks: &'a mut Remarks,
}

impl Making<'_> {
    fn control(&mut self, card: &SurfaceCard) -> Control {
        let mut parts = Vec::new();
        for &(frame, list) in &card.parts {
            parts.extend(self.parts(card, frame, list));
        }
        if parts.is_empty() {
            self.remarks
                .card(&card.origin, format!("{}: no flap of it is on a panel, it is left out", card.label));
        }
        Control {
            origin: card.origin.clone(),
            name: String::new(),
            label: card.label.clone(),
            limits: card.limits,
            parts,
        }
    }

    fn parts(&mut self, card: &SurfaceCard, frame: i64, list: i64) -> Vec<ControlPart> {
        let Some(boxes) = self.cards.aero.boxes.get(&list) else {
            self.mistakes.missing(&card.origin, "ALID", list, Needed::Card("an AELIST"));
            return Vec::new();
        };
        let hinge = self.world.point(frame, [0.0; 3]).map(|at| at - self.structure.origin);
        let beside = self.world.point(frame, [0.0, 1.0, 0.0]).map(|at| at - self.structure.origin);
        let (Some(at), Some(beside)) = (hinge, beside) else {
            self.mistakes.missing(&card.origin, "CID", frame, Needed::Frame);
            return Vec::new();
        };
        let axis = (beside - at).normalize();
        let mut parts = Vec::new();
        for (place, panel) in self.panels.iter().enumerate() {
            for (ends, edge) in self.flaps(card, panel, &boxes.ids) {
                parts.extend(self.part(card, (place, panel), (ends, edge), (&at, &axis)));
            }
        }
        parts
    }

    /// Where along the span of a panel boxes of a list reach the rear edge, and at which fraction of the chord the first of them begin;
    /// others are told of.
    fn flaps(&mut self, card: &SurfaceCard, panel: &Panel, boxes: &Ids) -> Vec<([f64; 2], f64)> {
        if panel.patches.iter().all(|patch| boxes.within(patch.boxes()).next().is_none()) {
            return Vec::new();
        }
        let mut found: Vec<([f64; 2], f64)> = Vec::new();
        for ends in panel.strips().windows(2) {
            let parts = panel.covered(0.5 * (ends[0] + ends[1]), boxes);
            let edge = match parts.as_slice() {
                [] => continue,
                &[[edge, rear]] if rear > 1.0 - REAR => edge,
                [[front, rear], ..] => {
                    let said = format!(
                        "{}: its boxes on {}, from {front:.3} to {rear:.3} of the chord, do not reach the rear edge in one: only flaps \
                         there are held, these boxes are left out",
                        card.label, panel.origin
                    );
                    self.remarks.card_once(&card.origin, format!("ahead on {}", panel.origin), said);
                    continue;
                }
            };
            match found.last_mut().filter(|(before, _)| (before[1] - ends[0]).abs() <= SAME) {
                Some((before, first)) => {
                    before[1] = ends[1];
                    if (edge - *first).abs() > TAPER {
                        let said = format!(
                            "{}: its boxes on {} begin at {first:.3} and at {edge:.3} of the chord: one flap is held, with its hinge",
                            card.label, panel.origin
                        );
                        self.remarks.card_once(&card.origin, format!("edges on {}", panel.origin), said);
                    }
                    *first = first.min(edge);
                }
                None => found.push(([ends[0], ends[1]], edge)),
            }
        }
        found
    }

    fn part(
        &mut self,
        card: &SurfaceCard,
        (place, panel): (usize, &Panel),
        ([from, to], edge): ([f64; 2], f64),
        (at, axis): (&Vector3<f64>, &Vector3<f64>),
    ) -> Option<ControlPart> {
        let span = panel.outline.span().normalize();
        let across = axis.dot(&span);
        if across.abs() < 0.2 {
            let said = format!(
                "{}: its hinge, y of its frame, runs along the chord of {}: no flap there",
                card.label, panel.origin
            );
            self.remarks.card(&card.origin, said);
            return None;
        }
        let hinge_at = |fraction: f64| {
            let out = (panel.outline.leading_edge(fraction) - at).dot(&span);
            let place = at + axis * (out / across);
            panel.outline.chord_fraction(&place, fraction)
        };
        let middle = hinge_at(0.5 * (from + to));
        let [one, other] = [hinge_at(from), hinge_at(to)];
        let hinge = if HINGES.contains(&middle) {
            if (one - other).abs() > TAPER && [one, other].iter().all(|end| end.is_finite()) {
                self.remarks.note(format!(
                    "{} {}: its hinge is at {one:.3} and {other:.3} of the chord at its ends; the flap has it at {middle:.3}",
                    card.origin, card.label
                ));
            }
            middle
        } else {
            let edge = edge.clamp(*HINGES.start(), *HINGES.end());
            let said = format!(
                "{}: its hinge, y of its frame, is at {middle:.3} of the chord of {}, where no flap can be: it is put at {edge:.3}, before the first of its boxes",
                card.label, panel.origin
            );
            self.remarks.card(&card.origin, said);
            edge
        };
        // Of the angle about the hinge the part about the span, and of the flow the part across the hinge.
        let effectiveness = card.effectiveness * across * across;
        let is_right = is_rightwards(&span) == (across > 0.0);
        Some(ControlPart {
            origin: card.origin.clone(),
            panel: place,
            from,
            to,
            // Decks have up to nine digits.
            hinge: (hinge * 1e9).round() / 1e9,
            gain: if is_right { 1.0 } else { -1.0 },
            effectiveness,
        })
    }
}

//! AESURF with its boxes and hinge as flaps on panels: from where to where along the span, hinged where, turned which way.

use nalgebra::Vector3;

use super::super::cards::{Cards, SurfaceCard};
use super::super::frames::World;
use super::super::mistakes::{Mistakes, Origin, Remarks};
use super::super::structure::Structure;
use super::panel::Panel;

/// Hinges nearer to an edge of the chord than this leave no flap, or no section before it.
const HINGES: std::ops::RangeInclusive<f64> = 0.02..=0.98;

/// A hinge whose fraction of the chord changes by more than this along the flap is told of.
const TAPER: f64 = 0.05;

/// An angle that a pilot sets.
#[derive(Clone, Debug)]
pub struct Control {
    pub origin: Origin,
    pub name: String,
    /// As the deck calls it.
    pub label: String,
    /// rad.
    pub limits: [Option<f64>; 2],
    pub parts: Vec<ControlPart>,
}

/// A flap on a panel.
#[derive(Clone, Debug)]
pub struct ControlPart {
    pub panel: usize,
    /// As fractions of the panel's span.
    pub from: f64,
    pub to: f64,
    /// As a fraction of the chord.
    pub hinge: f64,
    /// 1 where a positive angle is about the hinge to the right or upwards, else −1.
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
    let mut making = Making { cards, world, structure, panels, mistakes, remarks };
    let mut controls: Vec<Control> = cards.aero.surfaces.iter().map(|card| making.control(card)).collect();
    for (panel, found) in panels.iter().enumerate() {
        let Some((name, hinge)) = &found.flap else { continue };
        let part = ControlPart { panel, from: 0.0, to: 1.0, hinge: *hinge, gain: 1.0, effectiveness: 1.0 };
        match controls.iter_mut().find(|control| control.label == *name) {
            Some(control) => control.parts.push(part),
            None => controls.push(Control {
                origin: found.origin.clone(),
                name: String::new(),
                label: name.clone(),
                limits: [None; 2],
                parts: vec![part],
            }),
        }
    }
    controls.retain(|control| !control.parts.is_empty());
    name(&mut controls);
    controls
}

/// Names that an aircraft file takes, each once.
fn name(controls: &mut [Control]) {
    let mut taken: Vec<String> = Vec::new();
    for control in controls {
        let name = super::super::names::free(&control.label, "control", &taken);
        taken.push(name.clone());
        control.name = name;
    }
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
            let allowed = "an AELIST of the deck is needed";
            self.mistakes.of_origin(&card.origin, "ALID", format!("found {list}"), allowed);
            return Vec::new();
        };
        let hinge = self.world.point(frame, [0.0; 3]).map(|at| at - self.structure.origin);
        let beside = self.world.point(frame, [0.0, 1.0, 0.0]).map(|at| at - self.structure.origin);
        let (Some(at), Some(beside)) = (hinge, beside) else {
            let allowed = "a CORD1R or CORD2R of the deck is needed";
            self.mistakes.of_origin(&card.origin, "CID", format!("found {frame}"), allowed);
            return Vec::new();
        };
        let axis = (beside - at).normalize();
        let mut parts = Vec::new();
        // Boxes that some panel has.
        let mut named = 0;
        for (place, panel) in
            self.panels.iter().enumerate().filter(|(_, panel)| panel.origin.card == "CAERO1")
        {
            let last_row = panel.chordwise.len() - 2;
            let mut rows: Vec<Option<[usize; 2]>> = vec![None; panel.spanwise.len() - 1];
            for (from, to) in boxes.within(panel.boxes()) {
                let [Some((first, row)), Some((last, until))] = [from, to].map(|id| panel.box_at(id)) else {
                    continue;
                };
                named += (to - from + 1) as usize;
                // Boxes are counted along the chord, so that all strips but the first begin with their first row.
                for (strip, known) in rows.iter_mut().enumerate().take(last + 1).skip(first) {
                    let own =
                        [if strip == first { row } else { 0 }, if strip == last { until } else { last_row }];
                    *known = Some(known.map_or(own, |[low, high]| [own[0].min(low), own[1].max(high)]));
                }
            }
            let has_rear =
                self.panels.iter().any(|rear| rear.behind.is_some_and(|(front, _)| front == place));
            let told: Vec<&[usize; 2]> = rows.iter().flatten().collect();
            if told.iter().any(|[_, high]| *high < last_row) || (has_rear && !told.is_empty()) {
                let said = format!(
                    "{}: its boxes on {} do not reach the trailing edge: a flap from its hinge to there is held",
                    card.label, panel.origin
                );
                self.remarks.card(&card.origin, said);
            } else if told.windows(2).any(|pair| pair[0][0] != pair[1][0]) {
                let said = format!(
                    "{}: its boxes on {} begin in several rows: the flap has one hinge",
                    card.label, panel.origin
                );
                self.remarks.card(&card.origin, said);
            }
            let mut strip = 0;
            while strip < rows.len() {
                let run = rows[strip..].iter().take_while(|row| row.is_some()).count();
                if run > 0 {
                    let row =
                        rows[strip..strip + run].iter().flatten().map(|[low, _]| *low).min().unwrap_or(0);
                    let ends = [panel.spanwise[strip], panel.spanwise[strip + run]];
                    parts.extend(self.part(card, (place, panel), (ends, row), (&at, &axis)));
                }
                strip += run.max(1);
            }
        }
        if named < boxes.size() {
            let said = format!(
                "{}: {} of its {} boxes in AELIST {list} are on no panel",
                card.label,
                boxes.size() - named,
                boxes.size()
            );
            self.remarks.card(&card.origin, said);
        }
        parts
    }

    fn part(
        &mut self,
        card: &SurfaceCard,
        (place, panel): (usize, &Panel),
        ([from, to], row): ([f64; 2], usize),
        (at, axis): (&Vector3<f64>, &Vector3<f64>),
    ) -> Option<ControlPart> {
        let span = panel.span().normalize();
        // Of a panel behind another one the flap is in the chord of both.
        let edge = panel.chordwise[row];
        let (place, whole, edge) = match panel.behind {
            Some((front, share)) => (front, &self.panels[front], share + (1.0 - share) * edge),
            None => (place, panel, edge),
        };
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
            let out = (whole.leading_edge(fraction) - at).dot(&span);
            let place = at + axis * (out / across);
            whole.chord_fraction(&place, fraction)
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
            panel: place,
            from,
            to,
            hinge,
            gain: if is_right { 1.0 } else { -1.0 },
            effectiveness,
        })
    }
}

//! Panels behind one another, as decks have a wing box and the control surface on a CAERO1 of its own: where the leading edge of one lies
//! on the rear edge of another, they are one panel with the sum of the chords. Of the one ahead what has none behind it stays a panel.

use super::super::mistakes::Remarks;
use super::panel::{CarriedBy, Panel};
use super::trapezium::Trapezium;

/// Edges that are nearer than this share of both chords meet: decks are written with few digits.
const MEET: f64 = 1e-3;

/// Shares of a span that are less are none.
const LEAST: f64 = 1e-3;

/// All panels, those of cards that meet joined.
pub fn joined(mut panels: Vec<Panel>, remarks: &mut Remarks) -> Vec<Panel> {
    let mut ahead = 0;
    while ahead < panels.len() {
        let found = (0..panels.len()).find_map(|behind| {
            (behind != ahead)
                .then(|| meeting(&panels[ahead], &panels[behind]))
                .flatten()
                .map(|ends| (behind, ends))
        });
        let Some((behind, ends)) = found else {
            ahead += 1;
            continue;
        };
        let [front, rear] = [panels[ahead].clone(), panels[behind].clone()];
        remarks.note(format!(
            "{} lies behind {}, and their edges meet: they are one panel here",
            rear.origin, front.origin
        ));
        let rest = [[0.0, ends[0]], [ends[1], 1.0]].into_iter().filter(|[from, to]| to - from > LEAST);
        let rest: Vec<Panel> = rest.map(|ends| piece(&front, ends)).collect();
        panels[ahead] = one(&front, &rear, ends);
        panels.remove(behind);
        ahead -= usize::from(behind < ahead);
        panels.extend(rest);
    }
    panels
}

fn is_card(panel: &Panel) -> bool {
    panel.origin.card == "CAERO1"
}

/// From where to where along the span of one panel another one lies behind it, if their edges meet.
fn meeting(front: &Panel, rear: &Panel) -> Option<[f64; 2]> {
    if !is_card(front) || !is_card(rear) {
        return None;
    }
    let (front, rear) = (&front.outline, &rear.outline);
    let fractions = rear.corners.map(|corner| front.fraction(&corner));
    let meets = |end: usize| {
        let fraction = fractions[end];
        let edge = front.at(fraction, 1.0);
        let chords = front.chords[0].max(front.chords[1]) + rear.chords[0].max(rear.chords[1]);
        (-LEAST..=1.0 + LEAST).contains(&fraction) && (rear.corners[end] - edge).norm() <= MEET * chords
    };
    let snapped = fractions.map(|fraction| {
        if fraction < LEAST {
            0.0
        } else if fraction > 1.0 - LEAST {
            1.0
        } else {
            fraction
        }
    });
    let ends = [snapped[0].min(snapped[1]), snapped[0].max(snapped[1])];
    (meets(0) && meets(1) && ends[1] - ends[0] > LEAST).then_some(ends)
}

/// A part of a panel along its span.
fn piece(panel: &Panel, ends: [f64; 2]) -> Panel {
    Panel { outline: panel.outline.part(ends), ..panel.clone() }
}

/// Both as one, along the span of the one behind.
fn one(front: &Panel, rear: &Panel, ends: [f64; 2]) -> Panel {
    let ahead = piece(front, ends);
    let Trapezium { corners, chords } = ahead.outline;
    let rear_ends = corners.map(|corner| rear.outline.fraction(&corner).clamp(0.0, 1.0));
    let chords = [0, 1].map(|end| chords[end] + rear.outline.chord(rear_ends[end]));
    let outline = Trapezium { corners, chords };
    let patches = front.patches.iter().chain(&rear.patches).cloned().collect();
    Panel { outline, patches, carried_by: both(&front.carried_by, &rear.carried_by), ..ahead }
}

fn both(one: &CarriedBy, other: &CarriedBy) -> CarriedBy {
    match (one, other) {
        (CarriedBy::Grids(one), CarriedBy::Grids(other)) => {
            CarriedBy::Grids(one.iter().chain(other).copied().collect())
        }
        (CarriedBy::Nearest, other) => other.clone(),
        (one, _) => one.clone(),
    }
}

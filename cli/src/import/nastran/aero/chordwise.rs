//! Panels behind one another, as decks have a wing box and the control surface on a CAERO1 of its own: where the leading edge of one lies
//! on the rear edge of another, they are one panel with the sum of the chords. What of either is beside the other one stays a panel.

use super::super::mistakes::Remarks;
use super::panel::{CarriedBy, Panel};
use super::trapezium::Trapezium;

/// Edges that are nearer than this share of both chords meet: decks are written with few digits.
const MEET: f64 = 1e-3;

/// Shares of a span that are less are none.
const LEAST: f64 = 1e-3;

/// Where two panels are behind one another: shares of the span of the front one, and of the rear one in the same sense.
struct Meeting {
    front: [f64; 2],
    rear: [f64; 2],
}

/// All panels, those of cards that meet joined.
pub fn joined(mut panels: Vec<Panel>, remarks: &mut Remarks) -> Vec<Panel> {
    // Of panels that lie on one another every pair may meet: of those that do not there are fewer meetings than ends.
    let mut most = 2 * panels.len();
    let mut ahead = 0;
    while ahead < panels.len() && most > 0 {
        let found = (0..panels.len()).find_map(|behind| {
            let meeting = (behind != ahead).then(|| meeting(&panels[ahead], &panels[behind])).flatten()?;
            Some((behind, meeting))
        });
        let Some((behind, meeting)) = found else {
            ahead += 1;
            continue;
        };
        let [front, rear] = [panels[ahead].clone(), panels[behind].clone()];
        remarks.note(format!(
            "{} lies behind {}, and their edges meet: they are one panel here",
            rear.origin, front.origin
        ));
        panels[ahead] = one(&front, &rear, &meeting);
        panels.remove(behind);
        ahead -= usize::from(behind < ahead);
        panels.extend(rest(&front, meeting.front).chain(rest(&rear, meeting.rear)));
        most -= 1;
    }
    panels
}

fn is_card(panel: &Panel) -> bool {
    panel.origin.card == "CAERO1"
}

/// Where one panel lies behind another one, if their edges meet there.
fn meeting(front: &Panel, rear: &Panel) -> Option<Meeting> {
    if !is_card(front) || !is_card(rear) {
        return None;
    }
    let (front, rear) = (&front.outline, &rear.outline);
    let slack = MEET * (front.chords[0].max(front.chords[1]) + rear.chords[0].max(rear.chords[1]));
    let [one, other] = rear.corners.map(|corner| snapped(front.fraction(&corner)));
    let along_front = [one.min(other).max(0.0), one.max(other).min(1.0)];
    let along_rear = along_front.map(|fraction| snapped(rear.fraction(&front.at(fraction, 1.0))));
    let meets = |end: usize| {
        let edges = front.at(along_front[end], 1.0) - rear.leading_edge(along_rear[end]);
        edges.norm() <= slack && (0.0..=1.0).contains(&along_rear[end])
    };
    let is_some = along_front[1] - along_front[0] > LEAST;
    (is_some && meets(0) && meets(1)).then_some(Meeting { front: along_front, rear: along_rear })
}

/// A fraction at an end, if it is nearly there.
fn snapped(fraction: f64) -> f64 {
    let end = fraction.round();
    if (0.0..=1.0).contains(&end) && (fraction - end).abs() < LEAST { end } else { fraction }
}

/// A part of a panel along its span.
fn piece(panel: &Panel, ends: [f64; 2]) -> Panel {
    Panel { outline: panel.outline.part(ends), ..panel.clone() }
}

/// What is beside a part of a panel.
fn rest(panel: &Panel, [one, other]: [f64; 2]) -> impl Iterator<Item = Panel> + '_ {
    let beside = [[0.0, one.min(other)], [one.max(other), 1.0]];
    beside.into_iter().filter(|[from, to]| to - from > LEAST).map(|ends| piece(panel, ends))
}

/// Both as one, where they are behind one another.
fn one(front: &Panel, rear: &Panel, meeting: &Meeting) -> Panel {
    let ahead = piece(front, meeting.front);
    let Trapezium { corners, chords } = ahead.outline;
    let chords = [0, 1].map(|end| chords[end] + rear.outline.chord(meeting.rear[end]));
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

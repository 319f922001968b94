//! A stretch of a component that carries part of a panel: chords, where the beam runs in them, span axis, widths, flap.

use nalgebra::Vector3;

use super::super::mistakes::{Origin, Remarks};
use super::super::structure::Component;
use super::controls::{ControlPart, is_rightwards};
use super::panel::{Panel, SAME};
use super::runs::{ELASTIC_AXES, Run};

/// A span axis is written where the beam's own direction across x is off by more than this, rad.
const OFF: f64 = 1e-4;

/// Flaps whose hinges, as fractions of the chord, and lifts differ by less are one.
const SAME_FLAP: f64 = 2e-3;

/// A panel that lies higher or lower than its beam by more than this share of the chord is told of.
const HIGH: f64 = 0.1;

/// A flap of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Flap {
    pub hinge: f64,
    pub effectiveness: f64,
    /// Controls with their gains.
    pub moves: Vec<(usize, f64)>,
}

/// Strips on a stretch of a component.
#[derive(Clone, Debug)]
pub struct Surface {
    pub origin: Origin,
    pub component: usize,
    /// As fractions of its length.
    pub from: f64,
    pub to: f64,
    /// Ends of strips along the component with the chord there, m.
    pub at: Vec<f64>,
    pub chords: Vec<f64>,
    /// Middles of strips, and where the beam runs in the chord there.
    pub middles: Vec<f64>,
    pub elastic_axes: Vec<f64>,
    pub span_axis: Option<Vector3<f64>>,
    /// Of each element of the component, m.
    pub widths: Option<Vec<f64>>,
    pub flap: Option<Flap>,
}

/// The surface of a stretch between two fractions of a panel; what lies beyond its ends widens it there.
pub fn of_stretch(
    (component, run, panel): (&Component, &Run, &Panel),
    ([from, to], widened): ([f64; 2], [Option<f64>; 2]),
    parts: &[(usize, &ControlPart)],
    remarks: &mut Remarks,
) -> Option<Surface> {
    let along = run.along(component);
    let inside = run.fractions.iter().copied().filter(|node| (from + SAME..to - SAME).contains(node));
    let mut ends: Vec<f64> = inside.chain([from, to]).collect();
    ends.sort_by(|one, other| along(*one).total_cmp(&along(*other)));
    let least = 1e-3 * panel.outline.chords[0].max(panel.outline.chords[1]);
    // Strips stand in the middle between two ends: laws that are exact there.
    let mut middles = Vec::with_capacity(ends.len());
    let mut high = 0.0_f64;
    for pair in ends.windows(2) {
        let fraction = 0.5 * (pair[0] + pair[1]);
        let at = run.point(component, fraction);
        middles.push((along(fraction), panel.outline.chord_fraction(&at, fraction)));
        let above = (at - panel.outline.leading_edge(fraction)).dot(&up(panel));
        high = high.max(above.abs() / panel.outline.chord(fraction).max(least));
    }
    if let Some((_, bad)) = middles.iter().find(|(_, axis)| !ELASTIC_AXES.contains(axis)) {
        let said = format!(
            "the beam runs {bad:.3} chords behind its leading edge, where -1 to 2 is held: {:.4} m² from {from:.4} to {to:.4} of its span are left out",
            panel.outline.area(from, to)
        );
        remarks.card(&panel.origin, said);
        return None;
    }
    if high > HIGH {
        let said = format!(
            "it lies up to {high:.3} chords above or below its beam: its strips are in the height of the beam"
        );
        remarks.card_once(&panel.origin, "height", said);
    }
    let at: Vec<f64> = ends.iter().map(|fraction| along(*fraction)).collect();
    Some(Surface {
        origin: panel.origin.clone(),
        component: run.component,
        from: at[0],
        to: at[at.len() - 1],
        at,
        chords: ends.iter().map(|fraction| panel.outline.chord(*fraction).max(least)).collect(),
        middles: middles.iter().map(|(along, _)| *along).collect(),
        elastic_axes: middles.iter().map(|(_, axis)| *axis).collect(),
        span_axis: span_axis(component, run, panel),
        widths: widths(component, (run, panel), ([from, to], widened)),
        flap: flap([from, to], parts, remarks),
    })
}

/// Across the chords and the span of a panel.
fn up(panel: &Panel) -> Vector3<f64> {
    Vector3::x().cross(&panel.outline.span().normalize())
}

/// That of the panel, where the beam's own direction is another one.
fn span_axis(component: &Component, run: &Run, panel: &Panel) -> Option<Vector3<f64>> {
    let span = panel.outline.span().normalize();
    let span = if is_rightwards(&span) { span } else { -span };
    let elements = component.points[run.first..run.first + run.fractions.len()].windows(2);
    let is_off = elements.map(|ends| ends[1] - ends[0]).any(|along| {
        let own = Vector3::new(0.0, along.y, along.z);
        own.cross(&span).norm() > OFF * own.norm()
    });
    is_off.then_some(span)
}

/// Widths of strips, where what lies beyond the beam widens one.
fn widths(
    component: &Component,
    (run, panel): (&Run, &Panel),
    ([from, to], widened): ([f64; 2], [Option<f64>; 2]),
) -> Option<Vec<f64>> {
    if widened == [None, None] {
        return None;
    }
    let span = panel.outline.span();
    let unit = span.normalize();
    let own = component.points.windows(2).map(|ends| (ends[1] - ends[0]).dot(&unit).abs().max(1e-6));
    let mut widths: Vec<f64> = own.collect();
    for (end, beyond) in [from, to].into_iter().zip(widened) {
        let Some(beyond) = beyond else { continue };
        // Of an element that is cut here its part gets all of it.
        let inward = if end == from { end + SAME } else { end - SAME };
        let (element, _) = run.place(inward);
        let place = element - run.first;
        let [one, other] = [run.fractions[place], run.fractions[place + 1]];
        let part = one.max(other).min(to) - one.min(other).max(from);
        let share = (part / (other - one).abs()).max(1e-3);
        // The chord there is another one than in the middle of the strip: the area counts.
        let [outer, middle] = if end == from {
            [from - 0.5 * beyond, from + 0.5 * part]
        } else {
            [to + 0.5 * beyond, to - 0.5 * part]
        };
        widths[element] += beyond * span.norm() / share
            * (panel.outline.chord(outer)
                / panel.outline.chord(middle).max(1e-3 * panel.outline.chord(outer)));
    }
    Some(widths)
}

/// The flap of a stretch that no end of a control cuts: the largest, and what else moves it. Tabs on it are told of.
fn flap([from, to]: [f64; 2], parts: &[(usize, &ControlPart)], remarks: &mut Remarks) -> Option<Flap> {
    let middle = 0.5 * (from + to);
    let here: Vec<&(usize, &ControlPart)> =
        parts.iter().filter(|(_, part)| part.from < middle && middle < part.to).collect();
    // The first of equals.
    let (_, largest) = here.iter().min_by(|(_, one), (_, other)| one.hinge.total_cmp(&other.hinge))?;
    let is_same = |part: &ControlPart| {
        (part.hinge - largest.hinge).abs() <= SAME_FLAP
            && (part.effectiveness - largest.effectiveness).abs() <= SAME_FLAP * largest.effectiveness
    };
    for (_, other) in here.iter().filter(|(_, part)| !is_same(part)) {
        let said = format!(
            "from {from:.4} to {to:.4} of a panel's span its flap has its hinge at {:.3} of the chord and {:.3} of a flap's lift, \
             that of {} at {:.3} and {:.3}: one flap is held of a strip, so that this one moves nothing there",
            other.hinge, other.effectiveness, largest.origin, largest.hinge, largest.effectiveness
        );
        remarks.card_once(&other.origin, format!("below {} on {}", largest.origin, other.panel), said);
    }
    let moves = here.iter().filter(|(_, part)| is_same(part)).map(|(control, part)| (*control, part.gain));
    Some(Flap { hinge: largest.hinge, effectiveness: largest.effectiveness, moves: moves.collect() })
}

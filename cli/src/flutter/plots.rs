//! V–g and V–f plots.
//!
//! g = 2 Re λ / |Im λ| is the structural damping that a root lacks: positive is unstable. Roots that do not
//! oscillate have no g and are left out of both plots; where one goes through zero a line is marked.

use flexible_aircraft::stability::{Branch, Crossing, CrossingKind, Root};

use super::Analysis;
use super::motion::{frequency, name, oscillates};
use crate::chart::{Axis, Chart, Curve, Mark, Window};

/// The most that the V–g plot shows: what matters is near zero.
const DAMPING: Window = Window::new(-0.6, 0.4);

/// The least of it.
const LEAST_DAMPING: Window = Window::new(-0.1, 0.05);

/// The V–f plot goes up to this multiple of the highest frequency of a flutter, if there is one.
const FREQUENCY_MARGIN: f64 = 4.0;

/// Onsets that the airspeed axis names.
const NAMED_ONSETS: usize = 4;

/// Damping over airspeed.
pub fn dampings(analysis: &Analysis) -> Chart {
    let curves = curves(analysis, |root| 2.0 * root.eigenvalue.re / root.eigenvalue.im.abs());
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let least = values().fold(LEAST_DAMPING.min, f64::min).max(DAMPING.min);
    let greatest = values().fold(LEAST_DAMPING.max, f64::max).min(DAMPING.max);
    let mut marks = marks(analysis);
    marks.push(Mark::Horizontal(0.0, String::new()));
    Chart {
        title: format!("{}: V–g", analysis.model.name),
        x: airspeed_axis(analysis),
        y: Axis::new("damping g (positive: unstable)", Window::new(1.1 * least, 1.1 * greatest)),
        curves,
        marks,
        frame: None,
    }
}

/// Frequency over airspeed.
pub fn frequencies(analysis: &Analysis) -> Chart {
    let curves = curves(analysis, frequency);
    let values = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let greatest = values.fold(0.0, f64::max);
    let flutter = onsets(analysis).map(|crossing| frequency(&crossing.root)).fold(0.0, f64::max);
    let shown = if flutter > 0.0 { greatest.min(FREQUENCY_MARGIN * flutter) } else { greatest };
    let top = if shown > 0.0 { 1.05 * shown } else { 1.0 };
    Chart {
        title: format!("{}: V–f", analysis.model.name),
        x: airspeed_axis(analysis),
        y: Axis::new("frequency (Hz)", Window::new(0.0, top)),
        curves,
        marks: marks(analysis),
        frame: None,
    }
}

fn airspeed_axis(analysis: &Analysis) -> Axis {
    let [from, to] = analysis.range;
    let name = |crossing: &Crossing| match crossing.kind {
        CrossingKind::Flutter => format!(", flutter {:.1}", crossing.airspeed),
        CrossingKind::Divergence => format!(", divergence {:.1}", crossing.airspeed),
    };
    let onsets: String = onsets(analysis).take(NAMED_ONSETS).map(name).collect();
    Axis::new(format!("airspeed (m/s){onsets}"), Window::new(from, to))
}

/// One curve for each branch that oscillates, while it does.
fn curves(analysis: &Analysis, value: impl Fn(&Root) -> f64) -> Vec<Curve> {
    let sweep = &analysis.sweep;
    let curve = |branch: &Branch| {
        let roots = sweep.airspeeds.iter().zip(&branch.roots);
        let oscillating = roots
            .filter_map(|(speed, root)| root.as_ref().filter(|root| oscillates(root)).map(|r| (*speed, r)));
        let points = oscillating.map(|(speed, root)| (speed, value(root))).collect();
        Curve { label: name(branch, analysis), points }
    };
    sweep.branches.iter().map(curve).filter(|curve| curve.points.len() > 1).collect()
}

/// Lines at the onsets of flutter and divergence; what they are stands at the axis.
fn marks(analysis: &Analysis) -> Vec<Mark> {
    onsets(analysis).map(|crossing| Mark::Vertical(crossing.airspeed, String::new())).collect()
}

fn onsets(analysis: &Analysis) -> impl Iterator<Item = &Crossing> {
    analysis.sweep.crossings.iter().filter(|crossing| crossing.is_onset)
}

//! V–g and V–f plots, and the growth of roots that do not oscillate [theory: linearisation.eigenvalues].
//!
//! g = 2 Re λ / |Im λ| is the structural damping that a root lacks: positive is unstable. A root that does not
//! oscillate has no g; its growth Re λ is drawn in a plot of its own.

use flexible_aircraft::stability::{Branch, CrossingKind, LossKind, Onset, Root};

use crate::analysis::Analysis;
use crate::analysis::motion::{damping, frequency, name, oscillates};
use crate::chart::{Axis, Chart, Curve, Mark, Window};
use crate::condition::Airspeeds;

/// The most that the V–g plot shows: what matters is near zero.
const DAMPING: Window = Window::new(-0.6, 0.4);

/// The least of it.
const LEAST_DAMPING: Window = Window::new(-0.1, 0.05);

/// The V–f plot goes up to this multiple of the highest frequency of a flutter, if there is one.
const FREQUENCY_MARGIN: f64 = 4.0;

/// The most growth that the plot of aperiodic roots shows, 1/s, unless a root grows faster than that wherever it is unstable.
const GROWTH: Window = Window::new(-10.0, 10.0);

/// The least of it.
const LEAST_GROWTH: Window = Window::new(-0.1, 0.1);

/// Where roots grow, decay is shown up to this multiple of the greatest growth: a slow spiral would be lost beside fast lags.
const DECAY_BY_GROWTH: f64 = 5.0;

/// Damping over airspeed.
pub fn dampings(analysis: &Analysis) -> Chart {
    let curves = curves(analysis, oscillates, frequency_window(analysis), damping);
    let y = Axis::new("damping g (1); unstable above 0", enclosing(&curves, LEAST_DAMPING, DAMPING));
    chart(analysis, "damping over airspeed (V–g)", y, curves, Some(Mark::Limit(0.0)))
}

/// Frequency over airspeed.
pub fn frequencies(analysis: &Analysis) -> Chart {
    let window = frequency_window(analysis);
    let curves = curves(analysis, oscillates, window, frequency);
    chart(analysis, "frequency over airspeed (V–f)", Axis::new("frequency (Hz)", window), curves, None)
}

/// Growth over airspeed of the roots that do not oscillate; none where all do.
pub fn aperiodic_growth(analysis: &Analysis) -> Option<Chart> {
    let is_aperiodic = |root: &Root| !oscillates(root);
    let mut curves = curves(analysis, is_aperiodic, Window::new(0.0, 1.0), |root| root.eigenvalue.re);
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let decay = match values().fold(0.0, f64::max) {
        greatest if greatest > 0.0 => (-DECAY_BY_GROWTH * greatest).clamp(GROWTH.min, LEAST_GROWTH.min),
        _ => GROWTH.min,
    };
    curves.retain(|curve| curve.points.iter().any(|point| point.1 >= decay));
    if curves.is_empty() {
        return None;
    }
    // What is unstable is shown where it grows least, however fast that is.
    let slowest = |curve: &Curve| {
        let growths = curve.points.iter().map(|point| point.1).filter(|growth| *growth > 0.0);
        growths.reduce(f64::min)
    };
    let most = Window::new(decay, curves.iter().filter_map(slowest).fold(GROWTH.max, f64::max));
    let y = Axis::new("growth Re λ (1/s); unstable above 0", enclosing(&curves, LEAST_GROWTH, most));
    Some(chart(analysis, "growth of aperiodic roots over airspeed", y, curves, Some(Mark::Limit(0.0))))
}

/// The frequencies that matter, Hz: all, or those in the neighbourhood of a flutter's.
fn frequency_window(analysis: &Analysis) -> Window {
    let sweep = &analysis.sweep;
    let roots = sweep.branches.iter().flat_map(|branch| branch.roots.iter().flatten());
    let greatest = roots.map(frequency).fold(0.0, f64::max);
    let onsets = sweep.crossings.iter().filter(|crossing| crossing.is_onset);
    let flutter = onsets.map(|crossing| frequency(&crossing.root)).fold(0.0, f64::max);
    let shown = if flutter > 0.0 { greatest.min(FREQUENCY_MARGIN * flutter) } else { greatest };
    Window::new(0.0, if shown > 0.0 { 1.05 * shown } else { 1.0 })
}

fn chart(analysis: &Analysis, what: &str, y: Axis, curves: Vec<Curve>, limit: Option<Mark>) -> Chart {
    let Airspeeds { from, to, .. } = analysis.airspeeds;
    let mut marks = marks(analysis);
    marks.extend(limit);
    let title = format!("{}: {what}", analysis.model.name);
    Chart { title, x: Axis::new("airspeed (m/s)", Window::new(from, to)), y, curves, marks, frame: None }
}

/// The window around some curves, at least `least` and at most `most`.
fn enclosing(curves: &[Curve], least: Window, most: Window) -> Window {
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let low = values().fold(least.min, f64::min).max(most.min);
    let high = values().fold(least.max, f64::max).min(most.max);
    Window::new(1.1 * low, 1.1 * high)
}

/// One curve for each branch with roots of a kind, where it has them, if one of them has a frequency in the window. One
/// root by itself matters, as a dot, if it is unstable.
fn curves(
    analysis: &Analysis,
    is_wanted: impl Fn(&Root) -> bool,
    frequencies: Window,
    value: impl Fn(&Root) -> f64,
) -> Vec<Curve> {
    let sweep = &analysis.sweep;
    let curve = |branch: &Branch| {
        let roots = sweep.airspeeds.iter().zip(&branch.roots);
        let wanted: Vec<(f64, &Root)> = roots
            .filter_map(|(speed, root)| Some((*speed, root.as_ref()?)))
            .filter(|(_, root)| is_wanted(root))
            .collect();
        let is_seen = wanted.len() > 1 || wanted.iter().any(|(_, root)| root.eigenvalue.re > 0.0);
        let matters = is_seen && wanted.iter().any(|(_, root)| frequencies.contains(frequency(root)));
        let points = wanted.iter().map(|(speed, root)| (*speed, value(root))).collect();
        matters.then(|| Curve { label: name(branch, analysis), points })
    };
    sweep.branches.iter().filter_map(curve).collect()
}

/// Lines where something becomes unstable or the equilibrium is lost, by airspeed.
fn marks(analysis: &Analysis) -> Vec<Mark> {
    let sweep = &analysis.sweep;
    let onsets = sweep.crossings.iter().filter(|crossing| crossing.is_onset).map(|crossing| {
        let kind = match crossing.kind {
            CrossingKind::Flutter => "flutter",
            CrossingKind::Divergence => "divergence",
        };
        (crossing.airspeed, kind)
    });
    let losses = sweep.losses.iter().map(|loss| match loss.kind {
        LossKind::Jump { .. } => (loss.between[1], "equilibrium jumps"),
        LossKind::NoneAbove(_) => (loss.between[0], "no trim above"),
        LossKind::NoneBelow(_) => (loss.between[1], "no trim below"),
    });
    let unseen =
        sweep.unstable.iter().filter(|range| matches!(range.onset, Onset::Begins(_) | Onset::Unseen(_)));
    let unseen = unseen.map(|range| (range.first, "unstable"));
    let mut lines: Vec<(f64, &str)> = onsets.chain(losses).chain(unseen).collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines.into_iter().map(|(speed, what)| Mark::Vertical(speed, format!("{what} {speed:.1} m/s"))).collect()
}

//! How far each quantity is, with each number of modes, from what it is with the most.

use super::quantity::{Kind, Quantity, Value};
use super::study::Study;
use super::verdict::Verdict;
use crate::chart::{Axis, Chart, Curve, Mark, Window};

/// What has converged is in this frame, %.
const CONVERGED: Window = Window::new(-1.0, 1.0);

/// The least and the most that the plot shows, %.
const LEAST: Window = Window::new(-2.0, 2.0);
const MOST: Window = Window::new(-60.0, 60.0);

/// Steps from one grid line to the next along the axis of the modes, at most.
const MOST_TICKS: f64 = 10.0;

/// Departures over the number of modes.
pub fn departures(study: &Study) -> Chart {
    let counts: Vec<f64> = study.rows.iter().map(|row| (row.natural + row.loads) as f64).collect();
    let is_drawn = |quantity: &Quantity| match quantity.kind {
        Some(Kind::Deflection) => is_up(quantity) && is_large(quantity),
        Some(Kind::Trim | Kind::Critical) => true,
        Some(Kind::Root) | None => false,
    };
    let quantities = study.distinct();
    let curve = |quantity: &Quantity| Curve { label: label(quantity), points: points(quantity, &counts) };
    let mut curves: Vec<Curve> = quantities.iter().filter(|quantity| is_drawn(quantity)).map(curve).collect();
    curves.retain(|curve| !curve.points.is_empty());
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|point| 1.1 * point.1));
    let low = values().fold(LEAST.min, f64::min).max(MOST.min);
    let high = values().fold(LEAST.max, f64::max).min(MOST.max);
    let (name, last) =
        study.last().map_or_else(Default::default, |row| (row.analysis.model.name.clone(), row.label()));
    let modes = if study.has_load_modes() { "number of modes, natural and load" } else { "number of modes" };
    let [first, most] = [counts.first(), counts.last()].map(|count| count.copied().unwrap_or(0.0));
    let shown = Window::new(first, most.max(first + 1.0));
    Chart {
        title: format!("{name}: convergence in modes"),
        x: Axis { tick: Some(whole_tick(shown)), ..Axis::new(modes, shown) },
        y: Axis::new(format!("departure from {last} modes (%)"), Window::new(low, high)),
        curves,
        marks: enough(study, &counts).into_iter().collect(),
        frame: Some(CONVERGED),
    }
}

/// A whole number between grid lines of whole numbers, of which there are few: 1, 2 or 5 times a power of ten.
pub fn whole_tick(shown: Window) -> f64 {
    let steps = (0..).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10.0_f64.powi(power)));
    steps.take(30).find(|step| shown.width() <= MOST_TICKS * step).unwrap_or(shown.width())
}

/// The number of modes that are enough.
fn enough(study: &Study, counts: &[f64]) -> Option<Mark> {
    match &study.verdict {
        Verdict::Enough { row, .. } => Some(Mark::Vertical(counts[*row], "enough".to_owned())),
        _ => None,
    }
}

/// In % of the scale, where there are numbers.
fn points(quantity: &Quantity, counts: &[f64]) -> Vec<(f64, f64)> {
    let Some(last) = quantity.values.last().and_then(Value::number) else { return Vec::new() };
    let numbers =
        counts.iter().zip(&quantity.values).filter_map(|(count, value)| Some((*count, value.number()?)));
    numbers.map(|(count, number)| (count, 100.0 * (number - last) / quantity.scale)).collect()
}

fn is_up(quantity: &Quantity) -> bool {
    !quantity.name.ends_with(" inboard")
}

/// Whether it matters among the deflections.
fn is_large(quantity: &Quantity) -> bool {
    quantity.values.iter().filter_map(Value::number).any(|number| number.abs() > 0.02 * quantity.scale)
}

fn label(quantity: &Quantity) -> String {
    match quantity.kind {
        // The first of those that are alike stands for all.
        Some(Kind::Deflection) => quantity.name.rsplit(", ").next().unwrap_or_default().to_owned(),
        _ => quantity.name.clone(),
    }
}

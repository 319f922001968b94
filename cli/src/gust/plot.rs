//! What gusts add to the trim, over their gradients.

use super::found::{Extremes, Found};
use crate::chart::{Axis, Chart, Curve, Window};
use crate::watched::Watched;

/// Curves that a plot bears.
const MOST_CURVES: usize = 8;

/// The greatest increments of the outputs, in parts of the greatest of any gust, over the gradient; bending moments first, and of
/// curves that coincide the first.
pub fn increments(name: &str, watched: &[Watched], found: &Found) -> Chart {
    let mut places: Vec<usize> = (0..watched.len()).collect();
    places.sort_by_key(|place| rank(&watched[*place].name));
    let mut curves: Vec<Curve> = Vec::new();
    for curve in places.into_iter().filter_map(|place| curve(place, watched, found)) {
        // Of a symmetric gust left and right answer alike.
        if !curves.iter().any(|other| coincide(other, &curve)) {
            curves.push(curve);
        }
    }
    let gradients = || found.flights.iter().map(|flown| flown.case.gust.gradient);
    let [first, last] = [gradients().fold(f64::INFINITY, f64::min), gradients().fold(0.0, f64::max)];
    Chart {
        title: format!("{name}: increments by 1-cosine gusts"),
        x: Axis::new("gradient H (m)", Window::new(first, if last > first { last } else { first + 1.0 })),
        y: Axis::new("greatest increment (% of that of the worst gust)", Window::new(0.0, 105.0)),
        curves: curves.into_iter().take(MOST_CURVES).collect(),
        marks: Vec::new(),
        frame: None,
    }
}

/// What is drawn first: what breaks a wing, then what it feels like.
pub fn rank(name: &str) -> usize {
    let is_bending = name.starts_with("loads.") && name.ends_with(".bending");
    let order = [is_bending, name == "load_factor.lift", name.starts_with("deflection.")];
    order.iter().position(|is_first| *is_first).unwrap_or(order.len())
}

/// Whether two curves cannot be told from each other.
pub fn coincide(one: &Curve, other: &Curve) -> bool {
    one.points.iter().zip(&other.points).all(|(a, b)| (a.1 - b.1).abs() < 1e-3)
}

/// Of an output that any gust moves.
fn curve(place: usize, watched: &[Watched], found: &Found) -> Option<Curve> {
    let (output, trim) = (&watched[place], found.trim[place]);
    let increment = |Extremes { least, greatest }: &Extremes| (greatest.0 - trim).max(trim - least.0);
    // Of all gusts with a gradient the worst.
    let mut points: Vec<(f64, f64)> = Vec::new();
    for flown in &found.flights {
        let (gradient, added) = (flown.case.gust.gradient, increment(&flown.extremes[place]));
        match points.iter_mut().find(|point| point.0 == gradient) {
            Some(point) => point.1 = point.1.max(added),
            None => points.push((gradient, added)),
        }
    }
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    let greatest = points.iter().fold(0.0, |greatest: f64, point| greatest.max(point.1));
    let is_moved = greatest > 1e-9 * largest(&output.unit, watched, found);
    points.iter_mut().for_each(|point| point.1 *= 100.0 / greatest);
    is_moved.then(|| Curve { label: output.name.clone(), points })
}

/// The largest size of any watched output of a unit.
fn largest(unit: &str, watched: &[Watched], found: &Found) -> f64 {
    let of_unit = |place: &usize| watched[*place].unit == unit;
    let sizes = |extremes: &Extremes| extremes.greatest.0.abs().max(extremes.least.0.abs());
    let all = (0..watched.len()).filter(of_unit);
    let all = all.flat_map(|place| found.flights.iter().map(move |flown| sizes(&flown.extremes[place])));
    all.fold(0.0, f64::max)
}

//! What gusts add to the trim, over their gradients.

use super::sweep::{Extremes, Sweep};
use super::watched::Watched;
use crate::chart::{Axis, Chart, Curve, Window};

/// Curves that a plot bears.
const MOST_CURVES: usize = 8;

/// The greatest increments of the outputs, in parts of the greatest of any gust, over the gradient.
pub fn increments(name: &str, watched: &[Watched], sweep: &Sweep) -> Chart {
    let curves: Vec<Curve> =
        watched.iter().enumerate().filter_map(|(place, output)| curve(place, output, sweep)).collect();
    let gradients = || sweep.flights.iter().map(|flown| flown.case.gradient);
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

/// Of an output that any gust moves.
fn curve(place: usize, output: &Watched, sweep: &Sweep) -> Option<Curve> {
    let trim = sweep.trim[place];
    let increment = |Extremes { least, greatest }: &Extremes| (greatest.0 - trim).max(trim - least.0);
    // Of both senses of a gust the worse one.
    let mut points: Vec<(f64, f64)> = Vec::new();
    for flown in &sweep.flights {
        let (gradient, found) = (flown.case.gradient, increment(&flown.extremes[place]));
        match points.iter_mut().find(|point| point.0 == gradient) {
            Some(point) => point.1 = point.1.max(found),
            None => points.push((gradient, found)),
        }
    }
    let greatest = points.iter().fold(0.0, |greatest: f64, point| greatest.max(point.1));
    let is_moved = greatest > 1e-9 * trim.abs().max(1e-6);
    points.iter_mut().for_each(|point| point.1 *= 100.0 / greatest);
    is_moved.then(|| Curve { label: output.name.clone(), points })
}

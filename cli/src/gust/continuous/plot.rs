//! Power spectral densities of outputs in continuous turbulence.

use super::{Direction, Found};
use crate::chart::{Axis, Chart, Curve, Window, stacked};
use crate::gust::case::across;
use crate::gust::plot::{coincide, rank};

/// Curves that a plot bears.
const MOST_CURVES: usize = 6;

/// Powers of ten below the highest peak that are shown.
const DECADES: f64 = 7.0;

/// |H|²Φ over the frequency, in parts of Ā²; bending moments first, and of curves that coincide the first.
pub fn densities(name: &str, found: &Found) -> String {
    let title = |direction: &Direction| {
        format!("{name}: spectral densities in turbulence, {}", across(direction.degrees))
    };
    let chart = |direction: &Direction| chart(title(direction), found, direction);
    match found.directions.as_slice() {
        [only] => chart(only).to_svg(),
        several => stacked(
            &format!("{name}: spectral densities in turbulence"),
            &several
                .iter()
                .map(|direction| Chart { title: across(direction.degrees), ..chart(direction) })
                .collect::<Vec<_>>(),
        ),
    }
}

fn chart(title: String, found: &Found, direction: &Direction) -> Chart {
    let mut places: Vec<usize> = (0..found.watched.len()).collect();
    places.sort_by_key(|place| rank(&found.watched[*place].name));
    let mut curves: Vec<Curve> = Vec::new();
    for curve in places.into_iter().filter_map(|place| curve(place, found, direction)) {
        // Left and right answer alike.
        if curves.len() < MOST_CURVES && !curves.iter().any(|other| coincide(other, &curve)) {
            curves.push(curve);
        }
    }
    let ends = [direction.outputs.frequencies.first(), direction.outputs.frequencies.last()];
    let [first, last] = ends.map(|end| end.map_or(0.0, |end| end.log10()));
    let heights = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let top = heights.fold(f64::NEG_INFINITY, f64::max);
    let top = if top.is_finite() { top.ceil() } else { 0.0 };
    Chart {
        title,
        x: Axis::of_decades("frequency (rad/s)", Window::new(first, last)),
        y: Axis::of_decades("|H|²Φ / Ā² (s/rad)", Window::new(top - DECADES, top)),
        curves,
        marks: Vec::new(),
        frame: None,
    }
}

/// Of an output that the turbulence moves.
fn curve(place: usize, found: &Found, direction: &Direction) -> Option<Curve> {
    let output = &direction.outputs.outputs[place];
    let square = output.rms * output.rms;
    let density = |(frequency, density): (&f64, &f64)| (frequency.log10(), (density / square).log10());
    (square > 0.0).then(|| Curve {
        label: found.watched[place].name.clone(),
        points: direction.outputs.frequencies.iter().zip(&output.densities).map(density).collect(),
    })
}

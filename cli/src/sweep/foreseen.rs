//! What no point of a sweep could have, told before any is flown: roots beyond the states, gusts that begin too late.

use flexible_aircraft::flight::Settings;
use flexible_aircraft::structure::ReducedModel;

use super::document::{Mistakes, Place};
use super::file::{Flown, Keep, Law, Run, SweepFile, Varied};
use super::points::{Axis, Points};
use crate::numbers::Plain;

/// So many points are looked at: parameters may change how many states there are.
const MOST_LOOKED_AT: u64 = 64;

/// Complains of every root that no linear model has, by how many states it has at a point with some numbers.
pub fn check_roots(
    file: &SweepFile,
    points: &Points,
    states: impl Fn(&[f64]) -> Option<usize>,
    mistakes: &Mistakes,
) {
    let roots = file.keep.iter().filter_map(|keep| match keep {
        Keep::Root { number, place } => Some((*number, place)),
        Keep::Entry { .. } | Keep::Output { .. } => None,
    });
    let roots: Vec<(usize, &Place)> = roots.collect();
    if roots.is_empty() {
        return;
    }
    // Where no point is allowed, others tell.
    let most = spread(points.count()).filter_map(|point| states(&points.values(point))).max();
    let Some(most) = most else { return };
    for (number, place) in roots.into_iter().filter(|(number, _)| *number > most) {
        let allowed = format!("allowed is 1 to {most}, the states of the linear model");
        mistakes.add(place, format!("found the root {number}"), allowed);
    }
}

/// All of some points, or of many the first, the last and those evenly between.
fn spread(count: u64) -> impl Iterator<Item = u64> {
    let looked_at = count.min(MOST_LOOKED_AT);
    (0..looked_at).map(move |number| number * count.saturating_sub(1) / looked_at.saturating_sub(1).max(1))
}

/// Complains of a gust that begins when the flight is over.
pub fn check_gust(file: &SweepFile, model: &ReducedModel, mistakes: &Mistakes) {
    let Run::Fly(Flown { is_gust: true, duration, place: run, .. }) = &file.run else { return };
    if has_no_gust(file) {
        return;
    }
    let end = Plain(*duration);
    let allowed = format!("allowed is before the end of the flight, at {end} s");
    let name = "gust.start";
    if let Some(Varied { place, law, .. }) = file.varied.iter().find(|varied| varied.name == name) {
        if let Some(start) = too_late(law, *duration) {
            mistakes.add(place, format!("found a gust that begins at {} s", Plain(start)), allowed);
        }
    } else if let Some(fixed) = file.fixed.iter().find(|fixed| fixed.name == name) {
        if fixed.value.parse().is_ok_and(|start: f64| start >= *duration) {
            mistakes.add(&fixed.place, format!("found a gust that begins at {} s", fixed.value), allowed);
        }
    } else {
        let start = Settings::of(model).gust.start;
        if start >= *duration {
            let found =
                format!("found a flight of {end} s, but the gust begins at {} s (`{name}`)", Plain(start));
            mistakes.add(run, found, "allowed is a longer `duration`, or an earlier gust under [set]");
        }
    }
}

/// Of the times at which gusts begin, one that is not before the end, s; of a normal distribution points tell.
fn too_late(law: &Law, end: f64) -> Option<f64> {
    match law {
        Law::Axis(Axis::Grid(starts)) => starts.iter().copied().find(|start| *start >= end),
        Law::Axis(Axis::Uniform { most, .. }) => Some(*most).filter(|most| *most > end),
        Law::Axis(Axis::Normal { .. }) | Law::Items(_) => None,
    }
}

/// Whether the file says that there is none at all.
fn has_no_gust(file: &SweepFile) -> bool {
    let (name, is_none) = ("gust.shape", |shape: &str| shape.eq_ignore_ascii_case("none"));
    let fixed = file.fixed.iter().any(|fixed| fixed.name == name && is_none(&fixed.value));
    let mut varied = file.varied.iter().filter(|varied| varied.name == name);
    fixed || varied.any(|varied| matches!(&varied.law, Law::Items(items) if items.iter().all(|(shape, _)| is_none(shape))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_few_points_all_are_looked_at_and_of_many_the_first_and_the_last_too() {
        let points = |count| spread(count).collect::<Vec<u64>>();
        assert_eq!((points(0), points(1), points(3)), (vec![], vec![0], vec![0, 1, 2]));
        assert_eq!(points(64), (0..64).collect::<Vec<u64>>());
        let many = points(100_000_000);
        assert_eq!((many.len(), many[0], many[63]), (64, 0, 99_999_999));
        assert!(many.is_sorted_by(|one, next| one < next));
    }
}

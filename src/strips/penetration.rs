//! A frozen gust at all strips: three points of each deformed chord [theory: gusts.chord].
//!
//! Symbols: W̄ the mean over the chord, W̄₁ how the gust changes along it, aft positive, g₁ = −m·W̄₁.

use crate::air::{AlongTrack, TrackSeen};
use crate::kinematics::{SectionMotion, Sections, SectionsInPlane, SectionsInSpace, Turn};
use crate::math::{Arithmetic, Arrow, Eight, LaneVector, Lanes, PlaneVector, Window, Work};

use super::all_strips::Strips;
use super::gust_at_strips::{EightGusts, GustAtStrips};

/// ξ of the outer ones of three Chebyshev points: √3/2.
const OUTER: f64 = 0.866_025_403_784_438_6;
/// 1/√3: W̄₁ = ⅔ Σ ξ W.
const PER_DIFFERENCE: f64 = 0.577_350_269_189_625_8;

/// How a gust comes to all strips.
pub struct Penetrate<'a, K, F> {
    /// The strips.
    pub strips: &'a Strips,
    /// Where their sections are.
    pub sections: &'a K,
    /// What they fly into.
    pub gust: &'a F,
    /// Its track as the aircraft sees it.
    pub seen: &'a TrackSeen,
    /// What it is there.
    pub at_strips: &'a mut GustAtStrips,
}

/// What the chords of eight strips are: b and d.
pub(crate) type Chords<'a> = [&'a Eight; 2];

impl<K: Sections, F: AlongTrack> Work for Penetrate<'_, K, F> {
    type Output = ();

    #[inline(always)]
    fn with<S: Arithmetic>(self, simd: S) {
        let Penetrate { strips, sections, gust, seen, at_strips } = self;
        for ((index, group), found) in strips.groups.iter().enumerate().zip(&mut at_strips.groups) {
            let sections = sections.of_strips(index);
            let aerofoil = &group.aerofoil;
            let chords = [&aerofoil.semichord, &aerofoil.elastic_axis_aft_of_midchord];
            for window in Window::all(simd) {
                let places = if group.in_plane {
                    let forward = PlaneVector::load(window, [&group.forward.x, &group.forward.z]);
                    places(window, seen, SectionsInPlane::motion(&sections, window), &forward, chords)
                } else {
                    let forward = LaneVector::load(window, &group.forward);
                    places(window, seen, SectionsInSpace::motion(&sections, window), &forward, chords)
                };
                meet(window, (gust, seen), places, found);
            }
        }
        for ((index, group), found) in strips.edge_on.groups().enumerate().zip(&mut at_strips.edge_on) {
            let sections = sections.edge_on(index);
            for window in Window::all(simd) {
                let forward = PlaneVector::load(window, group.forward());
                let places = places(window, seen, sections.motion(window), &forward, group.chords());
                meet(window, (gust, seen), places, found);
            }
        }
    }
}

/// How far along the track the three points of each chord are, m: before, at and behind mid-chord.
#[inline(always)]
fn places<S: Arithmetic, V: Arrow<S>, A, T: Turn<V>>(
    window: Window<S>,
    seen: &TrackSeen,
    SectionMotion { position, turn, .. }: SectionMotion<V, A, T>,
    forward: &V,
    [semichord, elastic_axis_aft_of_midchord]: Chords,
) -> [Lanes<S>; 3] {
    let along = V::splat(window, &seen.axes[0]);
    let chordwise = along.dot(&turn.apply(forward));
    let to_midchord = chordwise * window.load(elastic_axis_aft_of_midchord);
    let midchord = along.dot(&position) + window.splat(seen.origin) + to_midchord;
    let outer = chordwise * window.load(semichord) * OUTER;
    [midchord + outer, midchord, midchord - outer]
}

/// Writes the mean of a gust at three places along the track, and how it changes from the first to the last.
#[inline(always)]
fn meet<S: Arithmetic, F: AlongTrack>(
    window: Window<S>,
    (gust, seen): (&F, &TrackSeen),
    places: [Lanes<S>; 3],
    found: &mut EightGusts,
) {
    let mut mean = [window.splat(0.0); 3];
    let mut change = mean;
    for lane in 0..mean[0].numbers().len() {
        let [before, at, behind] = places.each_ref().map(|place| gust.velocity(place.numbers()[lane]));
        for axis in 0..3 {
            mean[axis].numbers_mut()[lane] = (before[axis] + at[axis] + behind[axis]) / 3.0;
            change[axis].numbers_mut()[lane] = (behind[axis] - before[axis]) * PER_DIFFERENCE;
        }
    }
    in_body_axes(window, seen, mean).store(window, &mut found.mean);
    in_body_axes(window, seen, change).store(window, &mut found.change);
}

/// Vectors of components along the track, to the right, down.
#[inline(always)]
fn in_body_axes<S: Arithmetic>(
    window: Window<S>,
    seen: &TrackSeen,
    [along, right, down]: [Lanes<S>; 3],
) -> LaneVector<S> {
    let [ahead, aside, below] = &seen.axes;
    LaneVector::splat(window, ahead) * along
        + LaneVector::splat(window, aside) * right
        + LaneVector::splat(window, below) * down
}

//! Strips as slices of an aerofoil, each with its flap if it has one, as the page draws them.

use nalgebra::Vector3;

use super::super::outline::Outline;
use super::shape::{Paint, Shape, Surface, unit};

/// Fractions of the chord, of the part before or of that behind the hinge, where the skin has edges.
const WHOLE: [f64; 7] = [0.0, 0.02, 0.09, 0.25, 0.5, 0.75, 1.0];
const FRONT: [f64; 6] = [0.0, 0.025, 0.11, 0.3, 0.6, 1.0];
const BACK: [f64; 3] = [0.0, 0.5, 1.0];

/// Of the span of a strip, left free at both ends, so that one sees where strips meet.
const SEAM: f64 = 0.008;

/// A hinge so near to the leading edge, in chords, leaves nothing before it.
const ALL_FLAP: f64 = 0.02;

/// A strip that is drawn.
pub struct Slice<'a> {
    pub outline: &'a Outline,
    /// Where the elastic axis passes through it on the undeformed aircraft.
    pub place: Vector3<f64>,
    /// In chords.
    pub thickness: f64,
    pub joint: usize,
    /// The hinge as a fraction of the chord, and the joint of the flap.
    pub flap: Option<(f64, usize)>,
}

/// One end of a strip: where its chord begins, and the chord.
struct End {
    edge: Vector3<f64>,
    chord: Vector3<f64>,
}

/// A part of a strip between two fractions of its chord.
struct Part<'a> {
    slice: &'a Slice<'a>,
    ends: &'a [End; 2],
    joint: usize,
    fractions: Vec<f64>,
}

/// A point of the skin.
#[derive(Clone, Copy)]
struct Point {
    place: Vector3<f64>,
    normal: Vector3<f64>,
}

/// Points of one side of a part, from the leading edge on: inboard and outboard.
type Side = [Vec<Point>; 2];

impl Slice<'_> {
    pub fn add_to(&self, shape: &mut Shape) {
        let ends = [self.end(SEAM), self.end(1.0 - SEAM)];
        let part = |joint, fractions: &[f64], [from, to]: [f64; 2]| Part {
            slice: self,
            ends: &ends,
            joint,
            fractions: fractions.iter().map(|fraction| from + fraction * (to - from)).collect(),
        };
        match self.flap {
            None => part(self.joint, &WHOLE, [0.0, 1.0]).add_to(shape.of(Paint::Skin)),
            Some((hinge, flap)) if hinge < ALL_FLAP => {
                part(flap, &WHOLE, [0.0, 1.0]).add_to(shape.of(Paint::Flap));
            }
            Some((hinge, flap)) => {
                part(self.joint, &FRONT, [0.0, hinge]).add_to(shape.of(Paint::Skin));
                part(flap, &BACK, [hinge, 1.0]).add_to(shape.of(Paint::Flap));
            }
        }
    }

    fn end(&self, share: f64) -> End {
        let along = |fraction| {
            let [inboard, outboard] = self.outline.along_chord(fraction);
            self.place + inboard + (outboard - inboard) * share
        };
        let edge = along(0.0);
        End { edge, chord: along(1.0) - edge }
    }
}

impl Part<'_> {
    /// Adds the skin and the faces that close it.
    fn add_to(&self, surface: &mut Surface) {
        let sides = [1.0, -1.0].map(|side| self.rows(side));
        for rows in &sides {
            let [inboard, outboard] = rows.each_ref().map(|row| -> Vec<u32> {
                row.iter().map(|point| surface.vertex(self.joint, point.place, point.normal)).collect()
            });
            for (inner, outer) in inboard.windows(2).zip(outboard.windows(2)) {
                surface.quad([inner[0], outer[0], outer[1], inner[1]]);
            }
        }
        let outwards = unit(self.ends[1].edge - self.ends[0].edge, Vector3::y());
        for (end, normal) in [-outwards, outwards].into_iter().enumerate() {
            // At the leading edge both sides begin at one point.
            let own = usize::from(self.fractions[0] == 0.0);
            let around = sides[0][end].iter().chain(sides[1][end][own..].iter().rev());
            let corners: Vec<Vector3<f64>> = around.map(|point| point.place).collect();
            surface.face(self.joint, normal, &corners);
        }
        let back = unit(self.ends[0].chord, -Vector3::x());
        let last = self.fractions.len() - 1;
        self.close(surface, &sides, (last, back));
        if self.fractions[0] > 0.0 {
            self.close(surface, &sides, (0, -back));
        }
    }

    /// The upper (1) or the lower (−1) side.
    fn rows(&self, side: f64) -> Side {
        let point = |end: &End, x: f64| {
            let Slice { outline, thickness, .. } = self.slice;
            let half = thickness * half_thickness(x) * end.chord.norm();
            let place = end.edge + end.chord * x + outline.normal * (side * half);
            let backwards = unit(end.chord, -Vector3::x());
            if x == 0.0 {
                return Point { place, normal: -backwards };
            }
            let normal = outline.normal * side - backwards * (thickness * thickness_slope(x));
            Point { place, normal: unit(normal, outline.normal * side) }
        };
        self.ends.each_ref().map(|end| self.fractions.iter().map(|&x| point(end, x)).collect())
    }

    /// Adds the face between both sides at one of the fractions.
    fn close(&self, surface: &mut Surface, [upper, lower]: &[Side; 2], (at, normal): (usize, Vector3<f64>)) {
        let corners = [upper[0][at], upper[1][at], lower[1][at], lower[0][at]].map(|point| point.place);
        surface.face(self.joint, normal, &corners);
    }
}

/// Half the thickness of a NACA four-digit aerofoil with a sharp trailing edge, of its thickness.
fn half_thickness(x: f64) -> f64 {
    5.0 * (0.2969 * x.sqrt() + x * (-0.126 + x * (-0.3516 + x * (0.2843 - x * 0.1036))))
}

fn thickness_slope(x: f64) -> f64 {
    5.0 * (0.14845 / x.sqrt() - 0.126 + x * (-0.7032 + x * (0.8529 - x * 0.4144)))
}

//! The outlines of strips: quadrilaterals whose sides follow the beam, so that swept and tapered wings have straight edges.

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Strip;
use nalgebra::Vector3;

use crate::describe::surfaces;

/// Strips whose ends are nearer than this share of a width are neighbours.
const NEAR: f64 = 0.1;

/// A strip as it is drawn, as offsets from where the elastic axis passes through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Leading edge inboard and outboard, trailing edge outboard and inboard.
    pub corners: [Vector3<f64>; 4],
    /// Towards the suction side.
    pub normal: Vector3<f64>,
}

/// One side of a strip.
#[derive(Clone, Copy)]
struct Side {
    /// Where the elastic axis leaves the strip.
    at: Vector3<f64>,
    /// Of the elastic axis there behind mid-chord, and half the chord, m.
    aft: f64,
    semichord: f64,
}

impl Outline {
    /// Of each strip, in their order.
    pub fn of_all(aircraft: &Aircraft) -> Vec<Self> {
        let ends: Vec<[Vector3<f64>; 2]> =
            aircraft.strips.iter().map(|strip| ends(aircraft, strip)).collect();
        (0..aircraft.strips.len()).map(|strip| Outline::new(aircraft, &ends, strip)).collect()
    }

    fn new(aircraft: &Aircraft, ends: &[[Vector3<f64>; 2]], number: usize) -> Self {
        let strip = &aircraft.strips[number];
        let place = place(aircraft, strip);
        let [inboard, outboard] = [0, 1].map(|end| Side::new(aircraft, ends, (number, end)));
        let edge = |side: &Side, semichords: f64| {
            side.at - place + strip.forward * (side.aft + semichords * side.semichord)
        };
        Outline {
            corners: [edge(&inboard, 1.0), edge(&outboard, 1.0), edge(&outboard, -1.0), edge(&inboard, -1.0)],
            normal: -strip.forward.cross(&strip.span),
        }
    }

    /// Points at a fraction of the chord behind the leading edge, inboard and outboard.
    pub fn along_chord(&self, fraction: f64) -> [Vector3<f64>; 2] {
        let [leading_inboard, leading_outboard, trailing_outboard, trailing_inboard] = self.corners;
        [(leading_inboard, trailing_inboard), (leading_outboard, trailing_outboard)]
            .map(|(leading, trailing)| leading + (trailing - leading) * fraction)
    }
}

impl Side {
    /// The end of a strip, where it has the mean of its own chord and that of the strip that begins there. At a free end the chord goes on
    /// as from the neighbour on the other side.
    fn new(aircraft: &Aircraft, ends: &[[Vector3<f64>; 2]], (number, end): (usize, usize)) -> Self {
        let strip = &aircraft.strips[number];
        let at = ends[number][end];
        let neighbour = |at: Vector3<f64>| {
            let mut others = aircraft.strips.iter().zip(ends).enumerate();
            others.find_map(|(other, (one, ends))| {
                let near = ends.iter().any(|end| (end - at).norm() < NEAR * strip.width);
                (other != number && near && one.span.dot(&strip.span).abs() > 0.9).then_some(one)
            })
        };
        let with = |other: &Strip, share: f64| {
            let go = |own: f64, other: f64| own + (other - own) * share;
            let semichord = go(strip.semichord, other.semichord).max(0.1 * strip.semichord);
            Side {
                at,
                aft: go(strip.elastic_axis_aft_of_midchord, other.elastic_axis_aft_of_midchord),
                semichord,
            }
        };
        match (neighbour(at), neighbour(ends[number][1 - end])) {
            (Some(other), _) => with(other, 0.5),
            (None, Some(opposite)) => with(opposite, -0.5),
            (None, None) => with(strip, 0.0),
        }
    }
}

/// On the undeformed aircraft.
pub fn place(aircraft: &Aircraft, strip: &Strip) -> Vector3<f64> {
    let [from, to] = aircraft.beams[strip.attachment.beam].nodes.map(|node| aircraft.nodes[node]);
    from + (to - from) * strip.attachment.fraction
}

/// Where the elastic axis enters and leaves a strip, nearer to the root first.
fn ends(aircraft: &Aircraft, strip: &Strip) -> [Vector3<f64>; 2] {
    let place = place(aircraft, strip);
    let along = surfaces::direction(aircraft, strip.attachment.beam);
    let across = along.dot(&strip.span);
    let way = if surfaces::runs_along(aircraft, strip) { along / across.abs() } else { strip.span };
    [-0.5, 0.5].map(|side| place + way * (side * strip.width))
}

#[cfg(test)]
mod tests {
    use super::super::airframe::tests::jet;
    use super::*;

    #[test]
    fn strips_have_their_width_and_chord_and_neighbours_share_their_corners() {
        let jet = jet();
        let outlines = Outline::of_all(&jet);
        let mut shared = 0;
        for (strip, outline) in jet.strips.iter().zip(&outlines) {
            let [a, b, c, d] = outline.corners;
            let area = 0.5 * ((c - a).cross(&(d - b))).norm();
            assert!((area / (2.0 * strip.semichord * strip.width) - 1.0).abs() < 0.1, "{area}");
            assert!(
                outline.normal.dot(&strip.span).abs() < 1e-12 && (outline.normal.norm() - 1.0).abs() < 1e-12
            );
            let outboard = place(&jet, strip) + b;
            let at =
                |other: &(&Strip, &Outline)| (place(&jet, other.0) + other.1.corners[0] - outboard).norm();
            shared += usize::from(jet.strips.iter().zip(&outlines).any(|other| at(&other) < 0.02));
        }
        assert!(2 * shared > jet.strips.len(), "{shared} of {}", jet.strips.len());
    }
}

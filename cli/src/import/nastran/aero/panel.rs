//! A panel in body axes from O, and its boxes.

use nalgebra::Vector3;

use super::super::cards::Ids;
use super::super::mistakes::Origin;

/// Fractions of a panel's span that are nearer are one.
pub const SAME: f64 = 1e-6;

/// Parts of a chord that are nearer are one: what is behind one another meets to a thousandth.
const JOINED: f64 = 2e-3;

/// A trapezium whose chords run along x.
#[derive(Clone, Debug)]
pub struct Panel {
    pub origin: Origin,
    /// Of the leading edge, inboard and outboard, m from O.
    pub corners: [Vector3<f64>; 2],
    pub chords: [f64; 2],
    /// Its boxes, of one card or of several behind one another; of a `--surface` none.
    pub patches: Vec<Patch>,
    pub carried_by: CarriedBy,
    /// A flap over all of the span: control and hinge.
    pub flap: Option<(String, f64)>,
}

/// The boxes of a card, which may reach beyond a panel along its span.
#[derive(Clone, Debug)]
pub struct Patch {
    pub origin: Origin,
    /// Of its leading edge, m from O.
    pub corners: [Vector3<f64>; 2],
    pub chords: [f64; 2],
    /// Edges of boxes, as fractions of its own span and chord.
    pub spanwise: Vec<f64>,
    pub chordwise: Vec<f64>,
}

impl Patch {
    fn rows(&self) -> i64 {
        self.chordwise.len() as i64 - 1
    }

    /// The numbers of its boxes.
    pub fn boxes(&self) -> std::ops::Range<i64> {
        let count = self.rows() * (self.spanwise.len() as i64 - 1);
        self.origin.id..self.origin.id.saturating_add(count)
    }

    /// The strip and the row of a box, which are counted along the chord.
    pub fn place(&self, id: i64) -> Option<(usize, usize)> {
        let place = self.boxes().contains(&id).then(|| id - self.origin.id)?;
        Some(((place / self.rows()) as usize, (place % self.rows()) as usize))
    }

    /// How many boxes are before one.
    pub fn index(&self, (strip, row): (usize, usize)) -> usize {
        strip * self.rows() as usize + row
    }

    /// The numbers of the boxes of the strip in which a fraction of a panel's span lies; none beside it.
    fn strip(&self, panel: &Panel, fraction: f64) -> Option<std::ops::Range<i64>> {
        let own = fraction_between(&self.corners, &panel.leading_edge(fraction));
        let strip = self.spanwise.windows(2).position(|edges| (edges[0]..edges[1]).contains(&own))?;
        let first = self.origin.id + strip as i64 * self.rows();
        Some(first..first + self.rows())
    }

    /// Which part of a panel's chord some boxes of a list cover in the strip at a fraction of its span.
    fn covered(&self, panel: &Panel, fraction: f64, ids: &Ids) -> Vec<[f64; 2]> {
        let Some(strip) = self.strip(panel, fraction) else { return Vec::new() };
        let own = fraction_between(&self.corners, &panel.leading_edge(fraction));
        let leading = self.corners[0].lerp(&self.corners[1], own);
        let chord = self.chords[0] + own * (self.chords[1] - self.chords[0]);
        let edge = |row: i64| {
            let behind = Vector3::x() * (self.chordwise[row as usize] * chord);
            panel.chord_fraction(&(leading - behind), fraction)
        };
        let rows = ids.within(strip.clone()).map(|(from, to)| [from - strip.start, to - strip.start + 1]);
        rows.map(|rows| rows.map(edge)).collect()
    }
}

/// How far along a line a place is, across x.
fn fraction_between(corners: &[Vector3<f64>; 2], place: &Vector3<f64>) -> f64 {
    let along = corners[1] - corners[0];
    let span = Vector3::new(0.0, along.y, along.z);
    (place - corners[0]).dot(&span) / span.norm_squared()
}

/// What a panel hangs on.
#[derive(Clone, Debug, PartialEq)]
pub enum CarriedBy {
    /// Those of its splines.
    Grids(Vec<i64>),
    /// The beams from one grid to another.
    Between([i64; 2]),
    /// The beam beside it.
    Nearest,
}

impl Panel {
    /// Across x, from the inboard to the outboard edge, m.
    pub fn span(&self) -> Vector3<f64> {
        let along = self.corners[1] - self.corners[0];
        Vector3::new(0.0, along.y, along.z)
    }

    /// How far out a place is: 0 at the inboard edge, 1 at the outboard one.
    pub fn fraction(&self, place: &Vector3<f64>) -> f64 {
        fraction_between(&self.corners, place)
    }

    pub fn chord(&self, fraction: f64) -> f64 {
        self.chords[0] + fraction * (self.chords[1] - self.chords[0])
    }

    pub fn leading_edge(&self, fraction: f64) -> Vector3<f64> {
        self.corners[0] + (self.corners[1] - self.corners[0]) * fraction
    }

    /// How far behind the leading edge a place is, in chords.
    pub fn chord_fraction(&self, place: &Vector3<f64>, fraction: f64) -> f64 {
        (self.leading_edge(fraction).x - place.x) / self.chord(fraction)
    }

    /// Its area between two fractions of the span, m².
    pub fn area(&self, from: f64, to: f64) -> f64 {
        self.span().norm() * (to - from) * self.chord(0.5 * (from + to))
    }

    /// Edges of strips between its ends, as fractions of the span, with these.
    pub fn strips(&self) -> Vec<f64> {
        let of_patch = |patch: &Patch| {
            let [one, other] = patch.corners.map(|corner| self.fraction(&corner));
            patch.spanwise.iter().map(move |edge| one + edge * (other - one)).collect::<Vec<_>>()
        };
        let inside = self.patches.iter().flat_map(of_patch).filter(|edge| (SAME..1.0 - SAME).contains(edge));
        let mut edges: Vec<f64> = inside.chain([0.0, 1.0]).collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup_by(|one, other| (*one - *other).abs() <= SAME);
        edges
    }

    /// Which parts of the chord boxes of a list cover at a fraction of the span, from the front, apart from one another.
    pub fn covered(&self, fraction: f64, ids: &Ids) -> Vec<[f64; 2]> {
        let mut parts: Vec<[f64; 2]> =
            self.patches.iter().flat_map(|patch| patch.covered(self, fraction, ids)).collect();
        parts.sort_by(|one, other| one[0].total_cmp(&other[0]));
        parts.dedup_by(|next, before| {
            let is_joined = next[0] <= before[1] + JOINED;
            if is_joined {
                before[1] = before[1].max(next[1]);
            }
            is_joined
        });
        parts
    }
}

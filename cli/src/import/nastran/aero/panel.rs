//! A panel in body axes from O, and its boxes.

use super::super::cards::Ids;
use super::super::mistakes::Origin;
use super::trapezium::Trapezium;

/// Fractions of a panel's span that are nearer are one.
pub const SAME: f64 = 1e-6;

/// Parts of a chord that are nearer are one: what is behind one another meets to a thousandth.
const JOINED: f64 = 2e-3;

/// What the air sees of one card, or of several behind one another.
#[derive(Clone, Debug)]
pub struct Panel {
    pub origin: Origin,
    pub outline: Trapezium,
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
    pub outline: Trapezium,
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
        let own = self.outline.fraction(&panel.outline.leading_edge(fraction));
        let strip = self.spanwise.windows(2).position(|edges| (edges[0]..edges[1]).contains(&own))?;
        let first = self.origin.id + strip as i64 * self.rows();
        Some(first..first + self.rows())
    }

    /// Which part of a panel's chord some boxes of a list cover in the strip at a fraction of its span.
    fn covered(&self, panel: &Panel, fraction: f64, ids: &Ids) -> Vec<[f64; 2]> {
        let Some(strip) = self.strip(panel, fraction) else { return Vec::new() };
        let own = self.outline.fraction(&panel.outline.leading_edge(fraction));
        let edge = |row: i64| {
            let place = self.outline.at(own, self.chordwise[row as usize]);
            panel.outline.chord_fraction(&place, fraction)
        };
        let rows = ids.within(strip.clone()).map(|(from, to)| [from - strip.start, to - strip.start + 1]);
        rows.map(|rows| rows.map(edge)).collect()
    }
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
    /// Edges of strips between its ends, as fractions of the span, with these.
    pub fn strips(&self) -> Vec<f64> {
        let of_patch = |patch: &Patch| {
            let [one, other] = patch.outline.corners.map(|corner| self.outline.fraction(&corner));
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

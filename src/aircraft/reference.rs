//! The lengths by which coefficients and the static margin are made dimensionless: those of the aircraft file, else those of
//! its wing's strips [theory: linearisation.reference].

use nalgebra::Vector3;

use super::document::Table;
use super::format::{Field, file};
use super::model::{Aircraft, GivenReference, Strip};

/// Reference lengths of an aircraft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceLengths {
    /// c̄, m.
    pub chord: f64,
    /// S, m².
    pub area: f64,
    /// From tip to tip, m.
    pub span: f64,
}

/// Reads the table `reference`.
pub(super) fn read_reference(table: &Table) -> GivenReference {
    let Some(table) = table.optional(&file::REFERENCE).and_then(|value| value.table()) else {
        return GivenReference::default();
    };
    let given = |field: &Field| table.optional(field).and_then(|value| value.number());
    GivenReference {
        chord: given(&file::REFERENCE_CHORD),
        area: given(&file::REFERENCE_AREA_FIELD),
        span: given(&file::REFERENCE_SPAN),
    }
}

impl Aircraft {
    /// The reference lengths: those that the file gives, the others of the wing. `None` without strips, unless the file gives
    /// all.
    ///
    /// ```
    /// let jet = flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?;
    /// let lengths = jet.reference_lengths().ok_or("it has a wing")?;
    /// assert!((lengths.chord - 3.7307).abs() < 1e-4 && (lengths.area - 87.198).abs() < 1e-3);
    /// assert!((lengths.span - 24.86).abs() < 1e-9); // m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reference_lengths(&self) -> Option<ReferenceLengths> {
        let GivenReference { chord, area, span } = self.reference;
        match (chord, area, span) {
            (Some(chord), Some(area), Some(span)) => Some(ReferenceLengths { chord, area, span }),
            _ => {
                let wing = self.wing_lengths()?;
                Some(ReferenceLengths {
                    chord: chord.unwrap_or(wing.chord),
                    area: area.unwrap_or(wing.area),
                    span: span.unwrap_or(wing.span),
                })
            }
        }
    }

    /// The component whose strips give the reference lengths, by its index: the first with strips that has a mirror image, or
    /// the first with strips.
    pub fn wing(&self) -> Option<usize> {
        let mut with_strips: Vec<usize> =
            self.strips.iter().filter_map(|strip| self.component_of(strip.attachment.beam)).collect();
        with_strips.sort_unstable();
        let mirrored = with_strips.iter().find(|&&component| self.components[component].image.is_some());
        mirrored.or(with_strips.first()).copied()
    }

    /// Those of the wing, both sides.
    fn wing_lengths(&self) -> Option<ReferenceLengths> {
        let wing = self.wing()?;
        let sides = [Some(wing), self.components[wing].image];
        let belongs = |strip: &&Strip| {
            let component = self.component_of(strip.attachment.beam);
            component.is_some() && sides.contains(&component)
        };
        let (mut area, mut moment) = (0.0, 0.0);
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for strip in self.strips.iter().filter(belongs) {
            let chord = 2.0 * strip.semichord;
            area += chord * strip.width;
            moment += chord * chord * strip.width;
            let [from, to] = self.beams[strip.attachment.beam].nodes.map(|node| self.nodes[node]);
            let middle = from.lerp(&to, strip.attachment.fraction);
            for side in [-0.5, 0.5] {
                let end = middle + strip.span * (side * strip.width);
                (low, high) = (low.inf(&end), high.sup(&end));
            }
        }
        // A fin alone is upright.
        let span = (high.y - low.y).max(high.z - low.z);
        Some(ReferenceLengths { chord: moment / area, area, span })
    }
}

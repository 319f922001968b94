//! Words along vertical lines of a chart: upright beside the line, from its top downwards, none over another.

use crate::chart::escaped;

const FONT_SIZE: f64 = 15.0;

/// Width of a letter, px: an average of usual fonts.
const LETTER: f64 = 8.0;

/// From the line and from its end, px.
const GAP: f64 = 5.0;

/// A label that has found its place, px.
struct Placed {
    left: f64,
    top: f64,
    length: f64,
}

impl Placed {
    fn is_clear_of(&self, other: &Placed) -> bool {
        self.left + FONT_SIZE <= other.left
            || other.left + FONT_SIZE <= self.left
            || self.top + self.length + GAP <= other.top
            || other.top + other.length + GAP <= self.top
    }
}

/// The labels of lines at some x (px), between the left and right, the top and bottom (px) of a frame, as SVG.
pub fn upright_labels(lines: &[(f64, &str)], [left, right]: [f64; 2], [top, bottom]: [f64; 2]) -> String {
    let mut placed: Vec<Placed> = Vec::new();
    let mut svg =
        format!("<g font-size=\"{FONT_SIZE}\" fill=\"#333333\" stroke=\"#ffffff\" stroke-width=\"4\">");
    for &(x, label) in lines.iter().filter(|(_, label)| !label.is_empty()) {
        let length = LETTER * label.chars().count() as f64;
        let sides = [x - GAP - FONT_SIZE, x + GAP]
            .into_iter()
            .filter(|&side| left <= side && side + FONT_SIZE <= right);
        let sides: Vec<f64> = sides.collect();
        let place = |row: usize, side: f64| Placed {
            left: side,
            top: top + GAP + length.max(140.0) * row as f64,
            length,
        };
        let mut places = (0..3).flat_map(|row| sides.iter().map(move |&side| (row, side)));
        let free = places.find_map(|(row, side)| {
            let candidate = place(row, side);
            let fits = candidate.top + length <= bottom;
            (fits && placed.iter().all(|other| candidate.is_clear_of(other))).then_some(candidate)
        });
        // Too many lines at one place: the first of them stand for all.
        let Some(label_place) = free else { continue };
        svg += &format!(
            "<text transform=\"translate({:.1} {:.1}) rotate(-90)\" text-anchor=\"end\" paint-order=\"stroke\" \
             stroke-linejoin=\"round\">{}</text>",
            label_place.left + 0.8 * FONT_SIZE,
            label_place.top,
            escaped(label)
        );
        placed.push(label_place);
    }
    svg + "</g>"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(svg: &str) -> Vec<&str> {
        svg.split("translate(").skip(1).filter_map(|text| text.split(')').next()).collect()
    }

    #[test]
    fn labels_of_near_lines_stand_apart_and_within_the_frame() {
        let lines = [(100.0, "flutter 1 m/s"), (110.0, "flutter 2 m/s"), (112.0, "divergence 3 m/s")];
        let svg = upright_labels(&lines, [92.0, 702.0], [40.0, 380.0]);
        let places = places(&svg);
        assert_eq!(places.len(), 3, "{svg}");
        // The first has no room on its left; the second none but beyond the third line, or below.
        assert!(places[0].starts_with("117.0 "), "{places:?}");
        assert!(places[0] != places[1] && places[1] != places[2], "{places:?}");
    }

    #[test]
    fn where_too_many_lines_meet_the_first_are_named() {
        let lines: Vec<(f64, &str)> =
            (0..20).map(|line| (300.0 + f64::from(line), "no trim above 1 m/s")).collect();
        let svg = upright_labels(&lines, [92.0, 702.0], [40.0, 380.0]);
        assert!((2..10).contains(&places(&svg).len()), "{svg}");
    }

    #[test]
    fn a_line_without_a_label_has_none() {
        assert!(places(&upright_labels(&[(200.0, "")], [92.0, 702.0], [40.0, 380.0])).is_empty());
    }
}

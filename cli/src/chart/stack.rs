//! Charts one below the other: several quantities over the same time.

use super::{Chart, FONT, WIDTH, element, escaped, title_size};

/// Height of a chart among others, px.
const HEIGHT: f64 = 290.0;

/// Of the title above all, px.
const HEAD: f64 = 40.0;

/// Charts under a common title as one SVG element that stands alone in a file and scales within a page; those of several curves
/// have a legend each.
pub fn stacked(title: &str, charts: &[Chart]) -> String {
    let mut svg = format!(
        "<text x=\"{}\" y=\"26\" text-anchor=\"middle\" font-size=\"{}\" font-family=\"{FONT}\">{}</text>",
        0.5 * WIDTH,
        title_size(title),
        escaped(title)
    );
    let mut top = HEAD;
    for chart in charts {
        let (drawing, height) = match chart.curves.len() {
            0 | 1 => (chart.panel(HEIGHT), HEIGHT),
            _ => chart.with_legend(HEIGHT),
        };
        svg += &format!("<g transform=\"translate(0 {top})\">{drawing}</g>");
        top += height;
    }
    element(WIDTH, top, &svg)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::{Axis, Curve, Window};

    #[test]
    fn charts_stand_below_each_other_and_those_of_several_curves_say_which_is_which() {
        let curve = |label: &str| Curve { label: label.into(), points: vec![(0.0, 0.0), (1.0, 1.0)] };
        let chart = |title: &str, curves| Chart {
            title: title.into(),
            x: Axis::new("time (s)", Window::new(0.0, 1.0)),
            y: Axis::new("share (1)", Window::new(0.0, 1.0)),
            curves,
            marks: Vec::new(),
            frame: None,
        };
        let charts = [chart("alone", vec![curve("only")]), chart("both", vec![curve("one"), curve("other")])];
        let svg = stacked("A < B", &charts);
        for (text, times) in [
            (">A &lt; B<", 1),
            ("alone", 1),
            ("both", 1),
            (">only<", 0),
            (">one<", 1),
            (">other<", 1),
            ("translate(0 40)", 1),
            ("translate(0 330)", 1),
            ("max-width:100%", 1),
        ] {
            assert_eq!(svg.matches(text).count(), times, "{text}");
        }
        // One legend in one row.
        assert!(svg.contains("viewBox=\"0 0 720 646\""), "{}", &svg[..200]);
    }
}

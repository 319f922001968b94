//! Legends: what curves and points are.

use super::dots::ring;
use super::{Style, element, escaped};

/// Geometry, px.
const ROW: f64 = 26.0;
const STROKE: f64 = 44.0;

/// What stands before a label in a legend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sign {
    Stroke(Style),
    Ring,
}

/// The legend of charts whose curves have these labels, as an SVG element of its own. It is as wide as its entries
/// in one row, at most `most`, px.
pub fn legend<'a>(labels: &[&'a str], most: f64) -> String {
    let stroke = |(index, label): (usize, &&'a str)| (*label, Sign::Stroke(Style::of(index)));
    let named: Vec<(&str, Sign)> = labels.iter().enumerate().map(stroke).collect();
    let width = (named.len() as f64 * entry_width(&named)).min(most);
    let (entries, height) = entries(&named, 8.0, width + 8.0, 0.0);
    element(width + 8.0, height, &entries)
}

/// The entries of a legend, in as many columns as there is room, below `top`, and their height, px: strokes long
/// enough to show their dashes.
pub(super) fn entries(named: &[(&str, Sign)], left: f64, width: f64, top: f64) -> (String, f64) {
    let entry_width = entry_width(named);
    let columns = ((width - left) / entry_width + 1e-9).floor().clamp(1.0, 7.0) as usize;
    let mut svg = String::from("<g font-size=\"15\">");
    for (index, (label, sign)) in named.iter().enumerate() {
        let x = left + entry_width * (index % columns) as f64;
        let y = top + ROW * ((index / columns) as f64 + 0.4);
        svg += &match sign {
            Sign::Stroke(Style { colour, dash, width }) => format!(
                "<path d=\"M{x} {y}h{STROKE}\" stroke=\"{colour}\" stroke-width=\"{width}\" \
                 stroke-dasharray=\"{dash}\"/>"
            ),
            Sign::Ring => ring(x + 0.5 * STROKE, y),
        };
        svg += &format!("<text x=\"{}\" y=\"{}\">{}</text>", x + STROKE + 8.0, y + 5.0, escaped(label));
    }
    (svg + "</g>", ROW * named.len().div_ceil(columns) as f64)
}

fn entry_width(named: &[(&str, Sign)]) -> f64 {
    let letters = named.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0);
    STROKE + 24.0 + 8.0 * letters as f64
}

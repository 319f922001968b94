//! A drawing as SVG; the page that it stands in has the colours of its classes.

use std::fmt::{self, Write};

use super::shape::{DOT, Drawing, FONT, Shape};

/// An SVG element.
pub(super) fn text(drawing: &Drawing<'_>) -> String {
    let mut svg = String::new();
    // Writing to a `String` cannot fail.
    let _ = write(&mut svg, drawing);
    svg
}

fn write(svg: &mut String, Drawing { size: [width, height], shapes }: &Drawing<'_>) -> fmt::Result {
    writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" font-size=\"{FONT}\" \
         aria-label=\"Plan view\">"
    )?;
    shapes.iter().try_for_each(|shape| element(svg, shape))?;
    svg.write_str("</svg>\n")
}

fn element(svg: &mut String, shape: &Shape<'_>) -> fmt::Result {
    match shape {
        Shape::Polygon { class, corners } => {
            let corners: Vec<String> = corners.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
            writeln!(svg, "<polygon class=\"{class}\" points=\"{}\"/>", corners.join(" "))
        }
        Shape::Line { class, from: [x1, y1], to: [x2, y2] } => writeln!(
            svg,
            "<line class=\"{class}\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        ),
        Shape::Dot { class, place: [x, y], name } => writeln!(
            svg,
            "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{DOT}\"><title>{}</title></circle>",
            quick_xml::escape::escape(*name)
        ),
        Shape::Name { place: [x, y], text } => writeln!(
            svg,
            "<text class=\"name\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{}</text>",
            quick_xml::escape::escape(*text)
        ),
        Shape::Letter { place: [x, y], text } => {
            writeln!(svg, "<text class=\"body\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>")
        }
        Shape::Length { place: [x, y], text } => {
            writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>")
        }
    }
}

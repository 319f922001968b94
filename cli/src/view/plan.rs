//! The plan view of the undeformed aircraft as SVG, for whom the page cannot draw.

use std::fmt::Write;

use nalgebra::Vector3;

use crate::describe::frame::{Extent, Frame, View};

use super::airframe::Airframe;
use super::outline::Outline;

/// px.
const WIDTH: f64 = 480.0;
const MARGIN: f64 = 10.0;

const STYLE: &str = "fill:#3b6fb6;fill-opacity:.22;stroke:#1d4f91;stroke-width:.7";
const AXIS: &str = "fill:none;stroke:#0d2f5e;stroke-width:1.8";

/// From above, the nose up.
pub fn svg(airframe: &Airframe) -> String {
    let outlines = Outline::of_all(&airframe.aircraft);
    let place = |section: usize| airframe.sections[section].position;
    let strips: Vec<Vec<Vector3<f64>>> = outlines
        .iter()
        .zip(&airframe.strips)
        .map(|(outline, &section)| outline.corners.iter().map(|corner| place(section) + corner).collect())
        .collect();
    let beams: Vec<Vec<Vector3<f64>>> =
        airframe.nodes.iter().map(|nodes| nodes.iter().map(|&node| place(node)).collect()).collect();
    let extent = Extent::around(View::Above, strips.iter().chain(&beams).flatten());
    let [width, height] = extent.size();
    let scale = (WIDTH - 2.0 * MARGIN) / width.max(height).max(f64::MIN_POSITIVE);
    let size = [width, height].map(|metres| metres * scale + 2.0 * MARGIN);
    let frame = Frame { view: View::Above, scale };
    let [x, y] = frame.origin(&extent, size.map(|side| 0.5 * side));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0} {:.0}\" role=\"img\" aria-label=\"Plan view\">\
         <g transform=\"translate({x:.1} {y:.1})\">",
        size[0], size[1]
    );
    for (lines, style, end) in [(&strips, STYLE, "Z"), (&beams, AXIS, "")] {
        let courses: String = lines.iter().map(|line| course(&frame, line) + end).collect();
        // Writing to a `String` cannot fail.
        let _ = write!(svg, "<path style=\"{style}\" d=\"{courses}\"/>");
    }
    svg + "</g></svg>"
}

fn course(frame: &Frame, line: &[Vector3<f64>]) -> String {
    let point = |(number, point): (usize, &Vector3<f64>)| {
        let [x, y] = frame.place(point);
        format!("{}{x:.1} {y:.1}", if number == 0 { 'M' } else { 'L' })
    };
    line.iter().enumerate().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::super::airframe::tests::jet;
    use super::*;

    #[test]
    fn every_strip_and_every_beam_is_a_line() {
        let airframe = Airframe::new(&jet());
        let svg = svg(&airframe);
        assert_eq!(svg.matches('Z').count(), airframe.strips.len());
        assert_eq!(svg.matches('M').count(), airframe.strips.len() + airframe.nodes.len());
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

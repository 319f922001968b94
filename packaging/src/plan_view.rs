//! The picture of the documentation page: the aircraft from above, drawn from its strips, beams, engines and
//! stations as SVG. The nose points up.

use std::fmt::Write;

use flexible_aircraft::aircraft::{Aircraft, Attachment, ControlGains, Strip};
use nalgebra::Vector3;

/// Width of the picture, px.
const WIDTH: f64 = 640.0;
const MARGIN: f64 = 16.0;

/// An SVG element with the undeformed aircraft from above.
pub(crate) fn svg(aircraft: &Aircraft) -> String {
    let outlines: Vec<[Vector3<f64>; 4]> =
        aircraft.strips.iter().map(|strip| outline(aircraft, strip, [-1.0, 1.0])).collect();
    let frame = Frame::around(aircraft.nodes.iter().chain(outlines.iter().flatten()));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0} {:.0}\" role=\"img\" \
         aria-label=\"Plan view\">\n",
        WIDTH, frame.height
    );
    for (strip, outline) in aircraft.strips.iter().zip(&outlines) {
        polygon(&mut svg, &frame, outline, "surface");
        if let Some(flap) = strip.flap.filter(|flap| flap.gains != ControlGains::default()) {
            let hinge = 1.0 - 2.0 * flap.hinge;
            polygon(&mut svg, &frame, &self::outline(aircraft, strip, [-1.0, hinge]), "flap");
        }
    }
    for beam in &aircraft.beams {
        let [from, to] = beam.nodes.map(|node| frame.place(&aircraft.nodes[node]));
        line(&mut svg, from, to, "axis");
    }
    for engine in &aircraft.engines {
        let place = frame.place(&(position(aircraft, engine.attachment) + engine.offset));
        circle(&mut svg, place, "engine", &engine.name);
    }
    for station in &aircraft.stations {
        circle(&mut svg, frame.place(&position(aircraft, station.attachment)), "station", &station.name);
    }
    svg.push_str("</svg>\n");
    svg
}

/// Corners of the part of a strip between two chordwise places, in semichords ahead of midchord.
fn outline(aircraft: &Aircraft, strip: &Strip, chordwise: [f64; 2]) -> [Vector3<f64>; 4] {
    let midchord = position(aircraft, strip.attachment) + strip.forward * strip.elastic_axis_aft_of_midchord;
    let half_width = strip.span * (strip.width / 2.0);
    let [aft, fore] = chordwise.map(|place| midchord + strip.forward * (place * strip.semichord));
    [aft - half_width, aft + half_width, fore + half_width, fore - half_width]
}

fn position(aircraft: &Aircraft, attachment: Attachment) -> Vector3<f64> {
    let [from, to] = aircraft.beams[attachment.beam].nodes.map(|node| aircraft.nodes[node]);
    from.lerp(&to, attachment.fraction)
}

/// Where body axes lie on the picture.
struct Frame {
    foremost: f64,
    leftmost: f64,
    /// px per metre.
    scale: f64,
    height: f64,
}

impl Frame {
    fn around<'p>(points: impl Iterator<Item = &'p Vector3<f64>>) -> Self {
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for point in points {
            (low, high) = (low.inf(point), high.sup(point));
        }
        // A wing alone is slender; the limit keeps an aircraft that is longer than wide on the page.
        let scale = (WIDTH - 2.0 * MARGIN) / (high.y - low.y).max(0.5 * (high.x - low.x));
        let height = (high.x - low.x) * scale + 2.0 * MARGIN;
        Frame { foremost: high.x, leftmost: (low.y + high.y) / 2.0 - WIDTH / scale / 2.0, scale, height }
    }

    fn place(&self, point: &Vector3<f64>) -> [f64; 2] {
        [(point.y - self.leftmost) * self.scale, (self.foremost - point.x) * self.scale + MARGIN]
    }
}

// Writing to a `String` cannot fail.

fn polygon(svg: &mut String, frame: &Frame, corners: &[Vector3<f64>], class: &str) {
    let corners = corners.iter().map(|corner| {
        let [x, y] = frame.place(corner);
        format!("{x:.1},{y:.1}")
    });
    let points = corners.collect::<Vec<_>>().join(" ");
    let _ = writeln!(svg, "<polygon class=\"{class}\" points=\"{points}\"/>");
}

fn line(svg: &mut String, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], class: &str) {
    let _ = writeln!(
        svg,
        "<line class=\"{class}\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
    );
}

fn circle(svg: &mut String, [x, y]: [f64; 2], class: &str, name: &str) {
    let name = quick_xml::escape::escape(name);
    let _ = writeln!(
        svg,
        "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"><title>{name}</title></circle>"
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flaps_are_drawn_where_a_control_moves_them() {
        let text = include_str!("../../aircraft/generic-business-jet.toml");
        let jet = Aircraft::parse(text, "jet").unwrap();
        let moved = |strip: &&Strip| strip.flap.is_some_and(|f| f.gains != ControlGains::default());
        let (moved, all) =
            (jet.strips.iter().filter(moved).count(), jet.strips.iter().filter(|s| s.flap.is_some()));
        assert!(moved > 0 && moved < all.count());
        assert_eq!(svg(&jet).matches("class=\"flap\"").count(), moved);
    }
}

//! The aircraft from above, drawn from its strips, beams, engines and stations: for the documentation page as SVG with a
//! scale, the body axes and the names of engines and stations, for importers that show a picture as PNG without letters. The
//! nose points up.

mod png;
mod shape;
mod svg;

use flexible_aircraft::aircraft::{Aircraft, Attachment, Strip};
use nalgebra::Vector3;

pub use png::PictureError;
use shape::{DOT, Drawing, FONT, Shape};

/// Width of the picture, px: about that of a phone, so that its letters can be read there.
const WIDTH: f64 = 480.0;
const MARGIN: f64 = 16.0;

/// Of a letter on average, px; rather too much.
const LETTER: f64 = 0.58 * FONT;

/// Below the aircraft, for the scale, px.
const FOOT: f64 = 34.0;

/// Length of the drawn body axes, px.
const AXIS: f64 = 30.0;

/// An SVG element with the undeformed aircraft from above.
pub(crate) fn svg(aircraft: &Aircraft) -> String {
    svg::text(&drawing(aircraft))
}

/// The same as bytes of a PNG.
pub(crate) fn png(aircraft: &Aircraft) -> Result<Vec<u8>, PictureError> {
    png::bytes(&drawing(aircraft))
}

/// The undeformed aircraft from above.
fn drawing(aircraft: &Aircraft) -> Drawing<'_> {
    let outlines: Vec<[Vector3<f64>; 4]> =
        aircraft.strips.iter().map(|strip| outline(aircraft, strip, [-1.0, 1.0])).collect();
    let frame = Frame::around(aircraft.nodes.iter().chain(outlines.iter().flatten()));
    let mut shapes = Vec::new();
    for (strip, outline) in aircraft.strips.iter().zip(&outlines) {
        shapes.push(polygon(&frame, outline, "surface"));
        if let Some(flap) = strip.flap.as_ref().filter(|flap| flap.is_moved()) {
            let hinge = 1.0 - 2.0 * flap.hinge;
            shapes.push(polygon(&frame, &self::outline(aircraft, strip, [-1.0, hinge]), "flap"));
        }
    }
    for beam in &aircraft.beams {
        let [from, to] = beam.nodes.map(|node| frame.place(&aircraft.nodes[node]));
        shapes.push(Shape::Line { class: "axis", from, to });
    }
    let mut points: Vec<Point> = Vec::new();
    for engine in &aircraft.engines {
        let place = frame.place(&(position(aircraft, engine.attachment) + engine.offset));
        points.push(Point { place, class: "engine", name: &engine.name });
    }
    for station in &aircraft.stations {
        let place = frame.place(&position(aircraft, station.attachment));
        points.push(Point { place, class: "station", name: &station.name });
    }
    body_axes(&mut shapes, frame.place(&aircraft.nodes[0]));
    label(&mut shapes, &points, [WIDTH, frame.height]);
    scale(&mut shapes, &frame);
    Drawing { size: [WIDTH, frame.height + FOOT], shapes }
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
        let scale = (WIDTH - 2.0 * MARGIN) / (high.y - low.y).max(0.5 * (high.x - low.x)).max(1e-3);
        let height = (high.x - low.x) * scale + 2.0 * MARGIN;
        Frame { foremost: high.x, leftmost: (low.y + high.y) / 2.0 - WIDTH / scale / 2.0, scale, height }
    }

    fn place(&self, point: &Vector3<f64>) -> [f64; 2] {
        [(point.y - self.leftmost) * self.scale, (self.foremost - point.x) * self.scale + MARGIN]
    }
}

/// An engine or a station.
struct Point<'a> {
    /// px.
    place: [f64; 2],
    class: &'static str,
    name: &'a str,
}

/// What a label covers, px.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    left: f64,
    top: f64,
    width: f64,
}

impl Rectangle {
    const HEIGHT: f64 = FONT + 2.0;

    fn overlaps(&self, other: &Rectangle) -> bool {
        self.left < other.left + other.width
            && other.left < self.left + self.width
            && (self.top - other.top).abs() < Self::HEIGHT
    }

    fn covers(&self, [x, y]: [f64; 2]) -> bool {
        (self.left - DOT..self.left + self.width + DOT).contains(&x)
            && (self.top - DOT..self.top + Self::HEIGHT + DOT).contains(&y)
    }
}

/// The points, and each one's name where it is on the picture and on no other name or point.
fn label<'a>(shapes: &mut Vec<Shape<'a>>, points: &[Point<'a>], size: [f64; 2]) {
    let circle = |point: &Point<'a>| Shape::Dot { class: point.class, place: point.place, name: point.name };
    shapes.extend(points.iter().map(circle));
    let mut taken: Vec<Rectangle> = Vec::new();
    for (index, Point { place, name, .. }) in points.iter().enumerate() {
        let others =
            || points.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, point)| point.place);
        let is_free = |space: &Rectangle| {
            !taken.iter().any(|other| other.overlaps(space)) && !others().any(|place| space.covers(place))
        };
        let spaces = spaces(*place, LETTER * name.chars().count() as f64, size);
        let Some(space) = spaces.iter().find(|space| is_free(space)).or(spaces.first()) else { continue };
        taken.push(*space);
        shapes.push(Shape::Name {
            place: [space.left + space.width / 2.0, space.top + FONT - 1.0],
            text: name,
        });
    }
}

/// Where the name of a point may stand, the best first: beside it, outwards; above or below, ever farther; inwards.
fn spaces([x, y]: [f64; 2], width: f64, [picture_width, height]: [f64; 2]) -> Vec<Rectangle> {
    let (gap, right) = (DOT + 3.0, picture_width - 2.0 - width);
    let (before, after) = (x - gap - width, x + gap);
    let (outwards, inwards) = if x < picture_width / 2.0 { (before, after) } else { (after, before) };
    let beside = y - Rectangle::HEIGHT / 2.0;
    let mut spaces = vec![Rectangle { left: outwards, top: beside, width }];
    for row in 0..4 {
        let away = gap + f64::from(row) * Rectangle::HEIGHT;
        let left = (x - width / 2.0).min(right).max(2.0);
        for top in [y - away - Rectangle::HEIGHT, y + away] {
            spaces.push(Rectangle { left, top, width });
        }
    }
    spaces.push(Rectangle { left: inwards, top: beside, width });
    let fits = |space: &Rectangle| {
        (2.0..=right).contains(&space.left) && space.top >= 0.0 && space.top + Rectangle::HEIGHT <= height
    };
    spaces.retain(fits);
    spaces
}

/// O with the axes x, ahead, and y, to the right.
fn body_axes(shapes: &mut Vec<Shape<'_>>, [x, y]: [f64; 2]) {
    for to in [[x, y - AXIS], [x + AXIS, y]] {
        shapes.push(Shape::Line { class: "body", from: [x, y], to });
    }
    for (text, place) in
        [("x", [x + 4.0, y - AXIS + 8.0]), ("y", [x + AXIS + 2.0, y + 4.0]), ("O", [x - 12.0, y + 12.0])]
    {
        shapes.push(Shape::Letter { place, text });
    }
}

/// A bar of a round length, below the aircraft, with its length.
fn scale(shapes: &mut Vec<Shape<'_>>, frame: &Frame) {
    let length = round_length(0.3 * WIDTH / frame.scale);
    let (left, right, y) = (MARGIN, MARGIN + length * frame.scale, frame.height + FOOT / 2.0);
    let mut line = |from, to| shapes.push(Shape::Line { class: "scale", from, to });
    line([left, y], [right, y]);
    for end in [left, right] {
        line([end, y - 4.0], [end, y + 4.0]);
    }
    shapes.push(Shape::Length { place: [right + 8.0, y + 0.35 * FONT], text: format!("{length} m") });
}

/// The longest of 1, 2 and 5 times a power of ten that is no longer than this.
fn round_length(most: f64) -> f64 {
    let power = 10_f64.powf(most.log10().floor());
    let factor = [5.0, 2.0].into_iter().find(|factor| factor * power <= most).unwrap_or(1.0);
    factor * power
}

fn polygon<'a>(frame: &Frame, corners: &[Vector3<f64>], class: &'static str) -> Shape<'a> {
    Shape::Polygon { class, corners: corners.iter().map(|corner| frame.place(corner)).collect() }
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::aircraft::Flap;

    use super::*;

    fn jet() -> Aircraft {
        let text = include_str!("../../aircraft/generic-business-jet.toml");
        Aircraft::parse(text, "jet").unwrap()
    }

    #[test]
    fn flaps_are_drawn_where_a_control_moves_them() {
        let jet = jet();
        let moved = |strip: &&Strip| strip.flap.as_ref().is_some_and(Flap::is_moved);
        let (moved, all) =
            (jet.strips.iter().filter(moved).count(), jet.strips.iter().filter(|s| s.flap.is_some()));
        assert!(moved > 0 && moved < all.count());
        assert_eq!(svg(&jet).matches("class=\"flap\"").count(), moved);
    }

    #[test]
    fn every_engine_and_station_is_named_and_the_scale_is_true() {
        let jet = jet();
        let picture = svg(&jet);
        let names = jet.engines.iter().map(|e| &e.name).chain(jet.stations.iter().map(|s| &s.name));
        for name in names {
            assert!(picture.contains(&format!(">{name}</text>")), "{name}");
        }
        let bar = picture.lines().find(|line| line.contains("class=\"scale\"")).unwrap();
        let end = |name: &str| {
            let rest = bar.split(&format!("{name}=\"")).nth(1).unwrap();
            rest.split('"').next().unwrap().parse::<f64>().unwrap()
        };
        // The span of 24.9 m fills the picture between its margins.
        let width = jet.nodes.iter().map(|node| node.y.abs()).fold(0.0, f64::max) * 2.0;
        let metres = (end("x2") - end("x1")) / (WIDTH - 2.0 * MARGIN) * width;
        assert!(picture.contains(">5 m</text>") && (metres - 5.0).abs() < 0.05, "{metres}");
    }

    #[test]
    fn no_two_names_overlap_where_there_is_room() {
        let place = [240.0, 100.0];
        let first = spaces(place, 80.0, [480.0, 300.0])[0];
        let second = spaces(place, 80.0, [480.0, 300.0]).into_iter().find(|space| !space.overlaps(&first));
        assert!(second.is_some());
        // At the right edge the name stands to the left of its point or above.
        assert!(spaces([478.0, 100.0], 80.0, [480.0, 300.0]).iter().all(|space| space.left + 80.0 <= 478.0));
    }

    #[test]
    fn a_length_of_the_scale_is_one_two_or_five_of_something() {
        for (most, length) in [(9.9, 5.0), (5.0, 5.0), (4.9, 2.0), (1.0, 1.0), (0.3, 0.2), (19.0, 10.0)] {
            assert!((round_length(most) / length - 1.0).abs() < 1e-12, "{most}");
        }
    }
}

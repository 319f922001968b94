//! Pictures of natural modes as SVG: the undeformed aircraft light, the deformed one dark, from above and across the component
//! that the mode is named after.

use std::fmt::Write;

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::Attachment;
use flexible_aircraft::structure::{ModeShapes, Structure};
use nalgebra::{DMatrix, Vector3};

use super::frame::{Extent, Frame, View};
use super::modes::NaturalMode;

/// Width of the picture, px: about that of a phone, so that its letters can be read there.
const WIDTH: f64 = 480.0;

/// Around each view, px.
const MARGIN: f64 = 10.0;

/// Width of a view, px.
const PANEL: f64 = WIDTH / 2.0 - 2.0 * MARGIN;

/// Height of the two lines above the views of a mode, px.
const HEAD: f64 = 40.0;

/// Of the line below them, px.
const FOOT: f64 = 24.0;

/// Of the title, px.
const TITLE: f64 = 30.0;

/// The largest displacement, in parts of the aircraft's size.
const AMPLITUDE: f64 = 0.15;

/// Where an element is drawn, in parts of its length.
const FRACTIONS: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

const STYLE: &str = "text{font-family:sans-serif;font-size:13px;fill:#1a1a1a}.name{font-weight:bold;text-anchor:middle}.title{font-weight:bold}.view{font-size:12px;fill:#444;text-anchor:middle}\
.rest{fill:#eceff2;stroke:#b4bcc6;stroke-width:.6}.rest-axis{fill:none;stroke:#b4bcc6;stroke-width:1}\
.mode{fill:#3b6fb6;fill-opacity:.22;stroke:#1d4f91;stroke-width:.7}.mode-axis{fill:none;stroke:#0d2f5e;stroke-width:1.8}";

/// All of some modes, whose shapes are columns of a structure's.
pub fn svg(structure: &Structure, shapes: &DMatrix<f64>, modes: &[NaturalMode]) -> String {
    let airframe = Airframe::new(structure, shapes);
    let rest = airframe.at_rest();
    let rows: Vec<Row> =
        modes.iter().map(|mode| Row::new(structure.aircraft, mode, &airframe, &rest)).collect();
    let widths = rows.iter().flat_map(|row| row.extents).map(|extent| extent.size()[0]);
    let scale = PANEL / widths.fold(1e-6, f64::max);
    let row_height = |row: &Row| {
        HEAD + FOOT + row.extents.map(|extent| extent.size()[1] * scale).into_iter().fold(0.0, f64::max)
    };
    let height = TITLE + rows.iter().map(row_height).sum::<f64>();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\" aria-label=\"Natural modes\">\n\
         <style>{STYLE}</style>\n<rect width=\"{WIDTH}\" height=\"{height:.0}\" fill=\"#fff\"/>\n"
    );
    undeformed(&mut svg, &rest, scale);
    text(&mut svg, [WIDTH / 2.0, 20.0], "name", &structure.aircraft.name);
    let mut top = TITLE;
    for row in &rows {
        row.draw(&mut svg, [top, row_height(row)], scale);
        top += row_height(row);
    }
    svg + "</svg>\n"
}

/// What is drawn of an airframe: its beams as lines, its strips as outlines.
struct Airframe {
    lines: Vec<Line>,
}

/// Points that belong together, each with its section and how that moves in all modes.
struct Line {
    points: Vec<Point>,
    is_outline: bool,
}

struct Point {
    at: Vector3<f64>,
    /// From the section's place on the elastic axis.
    arm: Vector3<f64>,
    shapes: ModeShapes,
}

/// The same at one deflection.
struct Drawn {
    points: Vec<Vector3<f64>>,
    is_outline: bool,
}

impl Airframe {
    fn new(structure: &Structure, shapes: &DMatrix<f64>) -> Self {
        let aircraft = structure.aircraft;
        let on_axis = |beam: usize, fraction: f64| Point {
            at: structure.geometry[beam].position(fraction),
            arm: Vector3::zeros(),
            shapes: structure.shapes_at(Attachment { beam, fraction }, shapes),
        };
        let outlines = aircraft.strips.iter().map(|strip| {
            let at = structure.geometry[strip.attachment.beam].position(strip.attachment.fraction);
            let shapes = structure.shapes_at(strip.attachment, shapes);
            let middle = strip.forward * strip.elastic_axis_aft_of_midchord;
            let corners = [[-1.0, -0.5], [-1.0, 0.5], [1.0, 0.5], [1.0, -0.5]];
            let points = corners.map(|[fore, side]| {
                let arm =
                    middle + strip.forward * (fore * strip.semichord) + strip.span * (side * strip.width);
                Point { at: at + arm, arm, shapes: shapes.clone() }
            });
            Line { points: points.into(), is_outline: true }
        });
        let beams = (0..aircraft.beams.len()).map(|beam| Line {
            points: FRACTIONS.map(|fraction| on_axis(beam, fraction)).into(),
            is_outline: false,
        });
        Airframe { lines: outlines.chain(beams).collect() }
    }

    fn at_rest(&self) -> Vec<Drawn> {
        self.drawn(|point| point.at)
    }

    /// In a mode, so that the largest displacement is a part of the size.
    fn deflected(&self, mode: usize, size: f64) -> Vec<Drawn> {
        let displacement = |point: &Point| {
            let [translation, rotation] = point.shapes.of_mode(mode);
            translation + rotation.cross(&point.arm)
        };
        let points = self.lines.iter().flat_map(|line| &line.points);
        let largest = points.map(|point| displacement(point).norm()).fold(f64::MIN_POSITIVE, f64::max);
        self.drawn(|point| point.at + displacement(point) * (AMPLITUDE * size / largest))
    }

    fn drawn(&self, place: impl Fn(&Point) -> Vector3<f64>) -> Vec<Drawn> {
        let line = |line: &Line| Drawn {
            points: line.points.iter().map(&place).collect(),
            is_outline: line.is_outline,
        };
        self.lines.iter().map(line).collect()
    }
}

/// A mode: two lines of text above two views.
struct Row {
    head: [String; 2],
    views: [View; 2],
    /// What is seen in each view, deflected or not.
    extents: [Extent; 2],
    deflected: Vec<Drawn>,
}

impl Row {
    fn new(aircraft: &Aircraft, mode: &NaturalMode, airframe: &Airframe, rest: &[Drawn]) -> Self {
        let points = rest.iter().flat_map(|line| &line.points);
        let (low, high) = points.fold(
            (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)),
            |(low, high), point| (low.inf(point), high.sup(point)),
        );
        let deflected = airframe.deflected(mode.number - 1, (high - low).max());
        let views = [View::Above, across(aircraft, mode.component)];
        let all = || rest.iter().chain(&deflected).flat_map(|line| &line.points);
        Row {
            head: [format!("{} · {:.3} Hz", mode.number, mode.frequency()), mode.motion.clone()],
            extents: views.map(|view| Extent::around(view, all())),
            views,
            deflected,
        }
    }

    fn draw(&self, svg: &mut String, [top, height]: [f64; 2], scale: f64) {
        let [number, motion] = &self.head;
        text(svg, [MARGIN, top + 16.0], "title", number);
        text(svg, [MARGIN, top + 32.0], "motion", motion);
        for (column, (view, extent)) in self.views.into_iter().zip(self.extents).enumerate() {
            let across = WIDTH / 4.0 * (1.0 + 2.0 * column as f64);
            let middle = [across, top + HEAD + (height - HEAD - FOOT) / 2.0];
            let frame = Frame { view, scale };
            let [x, y] = frame.origin(&extent, middle);
            let _ = writeln!(svg, "<g transform=\"translate({x:.1} {y:.1})\"><use href=\"#{}\"/>", id(view));
            paths(svg, &frame, &self.deflected, "mode");
            svg.push_str("</g>\n");
            text(svg, [across, top + height - 8.0], "view", view.name());
        }
    }
}

/// The view across the longer direction of a component: its bending up and down shows.
fn across(aircraft: &Aircraft, component: usize) -> View {
    let nodes = &aircraft.components[component].nodes;
    let reach = aircraft.nodes[nodes[nodes.len() - 1]] - aircraft.nodes[nodes[0]];
    if reach.x.abs() > reach.y.abs().max(reach.z.abs()) { View::Right } else { View::Behind }
}

// Writing to a `String` cannot fail.

/// The undeformed aircraft in all views, to be used wherever it is seen.
fn undeformed(svg: &mut String, rest: &[Drawn], scale: f64) {
    svg.push_str("<defs>\n");
    for view in [View::Above, View::Behind, View::Right] {
        let _ = writeln!(svg, "<g id=\"{}\">", id(view));
        paths(svg, &Frame { view, scale }, rest, "rest");
        svg.push_str("</g>\n");
    }
    svg.push_str("</defs>\n");
}

/// Of the undeformed aircraft in a view.
fn id(view: View) -> String {
    view.name().replace(' ', "-")
}

/// Outlines, and beams on top of them.
fn paths(svg: &mut String, frame: &Frame, lines: &[Drawn], class: &str) {
    path(svg, frame, lines.iter().filter(|line| line.is_outline), class);
    path(svg, frame, lines.iter().filter(|line| !line.is_outline), &format!("{class}-axis"));
}

/// Lines as one element.
fn path<'d>(svg: &mut String, frame: &Frame, lines: impl Iterator<Item = &'d Drawn>, class: &str) {
    let mut course = String::new();
    for line in lines {
        for (place, point) in line.points.iter().enumerate() {
            let [x, y] = frame.place(point);
            let _ = write!(course, "{}{x:.1} {y:.1}", if place == 0 { 'M' } else { 'L' });
        }
        course.push_str(if line.is_outline { "Z" } else { "" });
    }
    let _ = writeln!(svg, "<path class=\"{class}\" d=\"{course}\"/>");
}

fn text(svg: &mut String, [x, y]: [f64; 2], class: &str, text: &str) {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let _ = writeln!(svg, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>");
}

#[cfg(test)]
mod tests {
    use flexible_aircraft::ReducedModel;
    use flexible_aircraft::plant::PlantSettings;
    use flexible_aircraft::structure::{ModalBasis, ModeMotion};

    use super::super::modes;
    use super::*;

    /// Two modes of the jet under another name.
    fn with_modes<T>(check: impl FnOnce(&Structure, &DMatrix<f64>, &[NaturalMode]) -> T) -> T {
        let path = format!("{}/../aircraft/generic-business-jet.toml", env!("CARGO_MANIFEST_DIR"));
        let mut jet = Aircraft::read(path).unwrap();
        jet.name = "Jet <A & B>".to_owned();
        let structure = Structure::new(&jet).unwrap();
        let basis = ModalBasis::new(&structure, 2).unwrap();
        let (shapes, motions) = (basis.shapes.clone(), ModeMotion::of_modes(&structure, &basis.shapes));
        let model = ReducedModel::of_basis(&structure, basis).unwrap();
        let modes = modes::name(&jet, &model.modes, &motions, &PlantSettings::of(&model));
        check(&structure, &shapes, &modes)
    }

    #[test]
    fn each_mode_has_two_views_and_its_name() {
        let svg = with_modes(svg);
        for (part, count) in
            [("class=\"mode\"", 4), ("<use href", 4), (">from above<", 2), (">from behind<", 2)]
        {
            assert_eq!(svg.matches(part).count(), count, "{part}");
        }
        assert!(svg.contains(">wing bending, first, symmetric<") && svg.contains(">Jet &lt;A &amp; B&gt;<"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn the_largest_displacement_is_a_part_of_the_size() {
        with_modes(|structure, shapes, _| {
            let airframe = Airframe::new(structure, shapes);
            let (rest, deflected) = (airframe.at_rest(), airframe.deflected(0, 20.0));
            let points = |lines: &[Drawn]| -> Vec<Vector3<f64>> {
                lines.iter().flat_map(|line| line.points.clone()).collect()
            };
            let away =
                points(&rest).into_iter().zip(points(&deflected)).map(|(one, other)| (other - one).norm());
            assert!((away.fold(0.0, f64::max) - 3.0).abs() < 1e-9);
        });
    }
}

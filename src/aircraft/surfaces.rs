//! Lifting surfaces: one aerodynamic strip per element [4.1].

use nalgebra::{Unit, UnitQuaternion, Vector3};

use super::error::{Problem, Report};
use super::geometry::Line;
use super::law::{Laws, Point};
use super::model::{Attachment, ControlGains, Flap, Strip};
use super::schema::{ControlSpec, Input, SurfaceSpec};

/// The strips of a surface, their elements counted from the component's root.
pub(super) fn strips(spec: &SurfaceSpec, line: &Line, laws: &Laws) -> Option<Vec<Strip>> {
    let inside = |point: &Point| (spec.from..=spec.to).contains(&point.s);
    let points: Vec<Point> = line.points_at(spec.position).into_iter().filter(inside).collect();
    if points.is_empty() {
        let found = format!("found no strip from {} to {}", spec.from, spec.to);
        let allowed = "a stretch that holds position_in_element of at least one element is allowed";
        laws.report.add(Problem::OutOfRange, &spec.place, found, allowed);
        return None;
    }
    let chords = match &spec.chord {
        Some(law) => laws.values(law, &points),
        None => laws.chords(&points, &spec.place.within("chord_m")),
    };
    let widths = spec.width.as_ref().map(|law| laws.values(law, &points));
    let lift_slopes = laws.values(&spec.lift_slope, &points);
    let moments = match &spec.zero_lift_moment {
        Some(law) => laws.values(law, &points),
        None => Some(vec![0.0; points.len()]),
    };
    let drags = laws.values(&spec.profile_drag, &points);
    let axes: Option<Vec<_>> = points.iter().map(|p| axes(spec, line, *p, laws.report)).collect();
    let gains = gains(&spec.controls, &points, laws.report);
    let (chords, lift_slopes, moments, drags) = (chords?, lift_slopes?, moments?, drags?);
    let (axes, gains) = (axes?, gains?);
    let mut strips = Vec::with_capacity(points.len());
    for (i, point) in points.iter().enumerate() {
        let (forward, span) = axes[i];
        let width = match &widths {
            Some(widths) => widths.as_ref()?[i],
            None => projected_width(spec, line, *point, span, laws.report)?,
        };
        strips.push(Strip {
            attachment: Attachment { beam: point.element, fraction: spec.position },
            forward,
            span,
            semichord: chords[i] / 2.0,
            elastic_axis_aft_of_midchord: (spec.elastic_axis - 0.5) * chords[i],
            width,
            lift_slope: lift_slopes[i],
            zero_lift_offset: spec.zero_lift_offset,
            zero_lift_moment: moments[i],
            profile_drag: drags[i],
            leading_edge_suction: spec.leading_edge_suction,
            flap: spec.flap.map(|f| Flap { lift_slope: f.lift_slope, hinge: f.hinge, gains: gains[i] }),
        });
    }
    Some(strips)
}

/// f and s of a strip.
fn axes(
    spec: &SurfaceSpec,
    line: &Line,
    point: Point,
    report: &Report,
) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let span = spec.span_axis.or_else(|| span_axis(line.span(point.element)));
    let level = span.and_then(|s| (Vector3::x() - s * s.x).try_normalize(1e-6));
    let (Some(span), Some(level)) = (span, level) else {
        let found = "found a span axis along the body's x axis";
        let allowed = "a span_axis across the body's x axis is allowed, for example [0, 1, 0]";
        report.add(Problem::NoDirection, &spec.place.within("span_axis"), found, allowed);
        return None;
    };
    let nose_up = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(span), spec.incidence);
    Some((nose_up * level, span))
}

/// The axis about which positive is nose-up for a beam along a vector: its direction across x, if it has one.
pub(super) fn span_axis(beam: Vector3<f64>) -> Option<Vector3<f64>> {
    let beam = beam.normalize();
    (beam - Vector3::x() * beam.x).try_normalize(1e-6).map(rightwards)
}

/// The sense of a span axis: to the right, and for a fin upwards.
fn rightwards(span: Vector3<f64>) -> Vector3<f64> {
    let backwards = if span.y.abs() > 1e-9 { span.y < 0.0 } else { span.z > 0.0 };
    if backwards { -span } else { span }
}

/// The element's extent along the span axis.
fn projected_width(
    spec: &SurfaceSpec,
    line: &Line,
    point: Point,
    span: Vector3<f64>,
    report: &Report,
) -> Option<f64> {
    let width = line.span(point.element).dot(&span).abs();
    if width > 1e-6 {
        return Some(width);
    }
    let found = "found an element across the span axis and no width_m";
    let allowed = "it is needed where the beam does not run along the span; a law is allowed";
    report.add(Problem::MissingField, &spec.place.within("width_m"), found, allowed);
    None
}

/// The gains of the inputs on each strip.
fn gains(controls: &[ControlSpec], points: &[Point], report: &Report) -> Option<Vec<ControlGains>> {
    let mut gains = vec![ControlGains::default(); points.len()];
    for control in controls {
        let inside = |point: &Point| (control.from..=control.to).contains(&point.s);
        if !points.iter().any(inside) {
            let found = format!("found no strip from {} to {}", control.from, control.to);
            report.add(Problem::OutOfRange, &control.place, found, "a stretch with strips is allowed");
            return None;
        }
        for (gains, _) in gains.iter_mut().zip(points).filter(|(_, point)| inside(point)) {
            match control.input {
                Input::Elevator => gains.elevator += control.gain,
                Input::Aileron => gains.aileron += control.gain,
                Input::AileronSymmetric => gains.aileron_symmetric += control.gain,
                Input::Rudder => gains.rudder += control.gain,
            }
        }
    }
    Some(gains)
}

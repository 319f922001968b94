//! Lifting surfaces: one aerodynamic strip per element or part of one [theory: air-loads.strip; thesis §4.1].

use nalgebra::{Unit, UnitQuaternion, Vector3};

use super::error::{Place, Problem, Report};
use super::format::surface as fields;
use super::geometry::{Line, SAME_PLACE};
use super::law::{AxisPoint, Law, Laws};
use super::model::{Flap, Strip};
use super::schema::{FlapSpec, MoveSpec, SurfaceSpec};
use super::stretch::{Piece, Stretch};

/// A strip of a component by itself.
pub(super) struct PartStrip<'s> {
    /// Its flap has no gains yet: they differ from side to side.
    pub(super) strip: Strip,
    /// What moves its flap.
    pub(super) moves: Vec<&'s MoveSpec>,
}

/// The strips of a surface, their elements counted from the component's root: one for each element, or for each part of
/// it where the surface or a control begins or ends within.
pub(super) fn strips<'s>(spec: &'s SurfaceSpec, line: &Line, laws: &Laws) -> Option<Vec<PartStrip<'s>>> {
    let ends = std::iter::once(&spec.stretch).chain(spec.moves.iter().map(|control| &control.stretch));
    let mut pieces = line.pieces(ends);
    pieces.retain(|piece| spec.stretch.holds(piece));
    if pieces.is_empty() {
        nothing_between(&spec.stretch, &spec.place, laws.report);
        return None;
    }
    let points: Vec<AxisPoint> = pieces.iter().map(|piece| line.point(piece.at(spec.position))).collect();
    let chords = match &spec.chord {
        Some(law) => laws.values(law, &points),
        None => laws.chords(&points, &spec.place.within("chord_m")),
    };
    let widths = spec.width.as_ref().map(|law| laws.values(law, &points));
    let elastic_axes = laws.values(&spec.elastic_axis, &points);
    let lift_slopes = laws.values(&spec.lift_slope, &points);
    let drags = laws.values(&spec.profile_drag, &points);
    let optional = |law: &Option<Law>, field| laws.values_or_usual(law.as_ref(), field, &points);
    let incidences = optional(&spec.incidence, &fields::INCIDENCE);
    let offsets = optional(&spec.zero_lift_offset, &fields::ZERO_LIFT_OFFSET);
    let moments = optional(&spec.zero_lift_moment, &fields::ZERO_LIFT_MOMENT);
    let slopes = optional(&spec.moment_slope, &fields::MOMENT_SLOPE);
    let suctions = optional(&spec.leading_edge_suction, &fields::SUCTION);
    let flaps = match &spec.flap {
        Some(flap) => flaps(flap, &points, laws).map(|flaps| flaps.into_iter().map(Some).collect()),
        None => Some(vec![None; points.len()]),
    };
    let axes = incidences.and_then(|incidences| axes(spec, line, &pieces, &incidences, laws.report));
    let moves = moves(&spec.moves, &pieces, laws.report);
    let (chords, elastic_axes, lift_slopes, drags) = (chords?, elastic_axes?, lift_slopes?, drags?);
    let (offsets, moments, slopes, suctions) = (offsets?, moments?, slopes?, suctions?);
    let (flaps, axes, moves): (Vec<_>, _, _) = (flaps?, axes?, moves?);
    let mut strips = Vec::with_capacity(pieces.len());
    for (i, (piece, moves)) in pieces.iter().zip(moves).enumerate() {
        let (forward, span) = axes[i];
        let width = match &widths {
            Some(widths) => widths.as_ref()?[i],
            None => projected_width(spec, line, piece.element, span, laws.report)?,
        };
        let strip = Strip {
            attachment: piece.at(spec.position),
            forward,
            span,
            semichord: chords[i] / 2.0,
            elastic_axis_aft_of_midchord: (elastic_axes[i] - 0.5) * chords[i],
            width: width * piece.share(),
            lift_slope: lift_slopes[i],
            zero_lift_offset: offsets[i].to_radians(),
            zero_lift_moment: moments[i],
            moment_slope: slopes[i],
            profile_drag: drags[i],
            leading_edge_suction: suctions[i],
            flap: flaps[i].clone(),
        };
        strips.push(PartStrip { strip, moves });
    }
    Some(strips)
}

/// The flaps of strips, before it is known on which side of the aircraft they are.
fn flaps(spec: &FlapSpec, points: &[AxisPoint], laws: &Laws) -> Option<Vec<Flap>> {
    let lift_slopes = laws.values(&spec.lift_slope, points);
    let hinges = laws.values(&spec.hinge, points);
    let moments = spec.moment_slope.as_ref().map(|law| laws.values(law, points));
    let drags = laws.values_or_usual(spec.drag.as_ref(), &fields::FLAP_DRAG, points);
    let (lift_slopes, hinges, drags) = (lift_slopes?, hinges?, drags?);
    let moments = match moments {
        Some(moments) => moments?.into_iter().map(Some).collect(),
        None => vec![None; points.len()],
    };
    let flap = |i: usize| Flap {
        lift_slope: lift_slopes[i],
        hinge: hinges[i],
        moment_slope: moments[i],
        drag: drags[i],
        gains: Vec::new(),
    };
    Some((0..points.len()).map(flap).collect())
}

/// Surfaces that share a stretch of a component count it twice, unless their spans cross, as those of a body do that
/// lifts up and sideways; true when none does.
pub(super) fn do_not_overlap(specs: &[SurfaceSpec], line: &Line, report: &Report) -> bool {
    let mut none = true;
    for (index, later) in specs.iter().enumerate() {
        let same_span = |earlier: &&SurfaceSpec| {
            let shared = Stretch {
                from: earlier.stretch.from.max(later.stretch.from),
                to: earlier.stretch.to.min(later.stretch.to),
            };
            let spans_cross = |element: usize| {
                let spans = [earlier, later].map(|spec| span_of(spec, line, element));
                // Without a span axis it is refused for that.
                let [Some(one), Some(other)] = spans else { return true };
                one.dot(&other).abs() < CROSSING
            };
            shared.to - shared.from > SAME_PLACE
                && line
                    .pieces([&earlier.stretch, &later.stretch].into_iter())
                    .iter()
                    .any(|piece| shared.holds(piece) && !spans_cross(piece.element))
        };
        if let Some(earlier) = specs[..index].iter().find(same_span) {
            let text = |stretch: &Stretch| format!("from {} to {}", stretch.from, stretch.to);
            let found = format!(
                "found a surface {} over {}, which runs {}",
                text(&later.stretch),
                earlier.place.field,
                text(&earlier.stretch)
            );
            let allowed = "surfaces of one component are allowed that meet, leave a gap, or whose span axes are at \
                           least 45 degrees apart";
            report.add(Problem::Overlap, &later.place, found, allowed);
            none = false;
        }
    }
    none
}

/// Cosine of the angle from which on directions cross, so that surfaces with these spans may share a stretch: 45°, and rounding.
pub(crate) const CROSSING: f64 = std::f64::consts::FRAC_1_SQRT_2 + 1e-9;

/// Complains that a stretch holds no part of any element.
fn nothing_between(stretch: &Stretch, place: &Place, report: &Report) {
    let found = format!("found no strip from {} to {}", stretch.from, stretch.to);
    let allowed =
        format!("a stretch of the surface is allowed that is longer than {SAME_PLACE} of the component");
    report.add(Problem::OutOfRange, place, found, allowed);
}

/// The span axis of a surface on an element.
fn span_of(spec: &SurfaceSpec, line: &Line, element: usize) -> Option<Vector3<f64>> {
    spec.span_axis.or_else(|| span_axis(line.span(element)))
}

/// f and s of each strip, set at its incidence in degrees.
fn axes(
    spec: &SurfaceSpec,
    line: &Line,
    pieces: &[Piece],
    incidences: &[f64],
    report: &Report,
) -> Option<Vec<(Vector3<f64>, Vector3<f64>)>> {
    let axes = |(piece, incidence): (&Piece, &f64)| {
        let span = span_of(spec, line, piece.element)?;
        let level = (Vector3::x() - span * span.x).try_normalize(1e-6)?;
        let span_axis = Unit::new_unchecked(span);
        Some((UnitQuaternion::from_axis_angle(&span_axis, incidence.to_radians()) * level, span))
    };
    let axes: Option<_> = pieces.iter().zip(incidences).map(axes).collect();
    if axes.is_none() {
        let found = "found a span axis along the body's x axis";
        let allowed = "a span_axis across the body's x axis is allowed, for example [0, 1, 0]";
        report.add(Problem::NoDirection, &spec.place.within("span_axis"), found, allowed);
    }
    axes
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
    element: usize,
    span: Vector3<f64>,
    report: &Report,
) -> Option<f64> {
    let width = line.span(element).dot(&span).abs();
    if width > 1e-6 {
        return Some(width);
    }
    let found = "found an element across the span axis and no width_m";
    let allowed = "it is needed where the beam does not run along the span; a law is allowed";
    report.add(Problem::MissingField, &spec.place.within("width_m"), found, allowed);
    None
}

/// What moves the flap of each piece of a surface, none of which the end of a control cuts.
fn moves<'s>(specs: &'s [MoveSpec], pieces: &[Piece], report: &Report) -> Option<Vec<Vec<&'s MoveSpec>>> {
    if let Some(spec) = specs.iter().find(|spec| !pieces.iter().any(|piece| spec.stretch.holds(piece))) {
        nothing_between(&spec.stretch, &spec.place, report);
        return None;
    }
    let of_piece = |piece| specs.iter().filter(|spec| spec.stretch.holds(piece)).collect();
    Some(pieces.iter().map(of_piece).collect())
}

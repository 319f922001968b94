//! What is unusual about an aircraft and is probably a slip of the pen: each warning says what, what was found, and what is usual.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::{Strip, Support};
use nalgebra::Vector3;

mod controls;
mod engines;
mod gyration;
mod meetings;
mod sections;
mod tails;

use super::balance::Balance;
use super::facts::Facts;
use super::modes::NaturalMode;
use super::surfaces::{direction, elements, is_lifting, normal, runs_along, strips};
use crate::numbers::{Plain, short};

/// Static margins of aircraft that people fly, in chords.
const MARGINS: RangeInclusive<f64> = 0.0..=0.5;

/// Lowest frequencies of airframes by their span, m/s: 10 of an aircraft that flies by the sun, 45 of a sailplane, 70 of one with engines, 180 of a
/// stiff small wing. Likenesses of other sizes have the same. Wings and sections on springs of wind tunnels may be softer.
const LOWEST_FREQUENCIES: RangeInclusive<f64> = 3.0..=500.0;
const LOWEST_OF_CLAMPED: RangeInclusive<f64> = 1.0..=500.0;

/// Wing loadings, kg/m²: models that fly in halls have 0.5 to 1, those that fly by the sun in the stratosphere 2 to 5.
pub const LOADINGS: RangeInclusive<f64> = 0.5..=1000.0;

/// Stiffness in the surface by that out of it.
const LEAST_STIFFNESS_RATIO: f64 = 0.5;

/// Chord of a strip by that of its neighbour.
const LARGEST_CHORD_STEP: f64 = 3.0;

/// Lift slopes beyond thin aerofoils' 2π, with some thickness, 1/rad.
const LARGEST_LIFT_SLOPE: f64 = 1.15 * TAU;

/// Reference lengths by those of the wing.
const REFERENCE_RATIOS: RangeInclusive<f64> = 0.5..=2.0;

/// Everything unusual.
pub fn find(aircraft: &Aircraft, facts: &Facts, balance: &Balance, modes: &[NaturalMode]) -> Vec<String> {
    let components = 0..aircraft.components.len();
    let mut warnings: Vec<String> = balance.odd.iter().cloned().collect();
    warnings.extend(balance.margin.as_ref().and_then(|margin| static_margin(margin.margin)));
    warnings.extend(modes.iter().map(NaturalMode::frequency).reduce(f64::min).and_then(|frequency| {
        let size = reach(aircraft);
        let span = facts.reference.map_or((size[1] - size[0]).amax(), |lengths| lengths.span);
        lowest_frequency(frequency, span, aircraft.support)
    }));
    if aircraft.support == Support::Free {
        warnings.extend(wing_loading(facts));
        warnings.extend(centre_of_mass(aircraft, facts));
        warnings.extend(tails::volumes(aircraft, facts));
        warnings.extend(gyration::inertia(aircraft, facts));
        warnings.extend(aircraft.engines.iter().flat_map(|engine| engines::turning(engine, facts)));
        let does = balance.senses.iter().flatten();
        warnings.extend(
            aircraft
                .controls
                .iter()
                .zip(does)
                .filter_map(|(control, does)| controls::contradiction(control, does)),
        );
    }
    warnings.extend(reference_lengths(aircraft));
    warnings.extend(meetings::unjoined(aircraft));
    for component in components {
        warnings.extend(massless(aircraft, component));
        warnings.extend(stiffness_ratio(aircraft, component));
        warnings.extend(chord_step(aircraft, component));
        warnings.extend(lift_slope(aircraft, component));
        warnings.extend(sections::moments(aircraft, component));
        warnings.extend(gap(aircraft, component));
    }
    warnings.extend((0..aircraft.controls.len()).filter_map(|control| idle_control(aircraft, control)));
    warnings
}

fn static_margin(margin: f64) -> Option<String> {
    let found =
        format!("the static margin is {}, usual is {}", short(margin), range(&MARGINS, "of the chord"));
    match margin {
        _ if margin < *MARGINS.start() => {
            Some(format!("{found}: the aircraft turns away from its trim by itself"))
        }
        _ if margin > *MARGINS.end() => Some(format!("{found}: is the centre of mass where it should be?")),
        _ => None,
    }
}

fn lowest_frequency(frequency: f64, span: f64, support: Support) -> Option<String> {
    let usual = if support == Support::Free { LOWEST_FREQUENCIES } else { LOWEST_OF_CLAMPED };
    (!usual.contains(&(frequency * span))).then(|| {
        let [low, high] = [usual.start(), usual.end()].map(|speed| short(speed / span));
        format!(
            "the lowest frequency of the structure is {} Hz, usual is {low} to {high} Hz at a span of {} m: are stiffnesses in N m² and masses in kg?",
            short(frequency),
            short(span)
        )
    })
}

fn wing_loading(facts: &Facts) -> Option<String> {
    let loading = facts.mass / facts.reference?.area;
    (!LOADINGS.contains(&loading)).then(|| {
        format!(
            "the mass by the wing area is {} kg/m², usual is {}",
            short(loading),
            range(&LOADINGS, "kg/m²")
        )
    })
}

/// Whether the centre of mass is ahead of the nose or behind the tail.
fn centre_of_mass(aircraft: &Aircraft, facts: &Facts) -> Option<String> {
    let [aft, fore] = reach(aircraft).map(|corner| corner.x);
    let x = facts.centre_of_mass.x;
    (!(aft..=fore).contains(&x)).then(|| {
        format!(
            "the centre of mass is at x {} m, the aircraft reaches from {} to {} m: usual is between them",
            short(x),
            short(aft),
            short(fore)
        )
    })
}

/// Reference lengths that the file gives and that are not those of its wing. Of half a wing area and span may be those of the whole.
fn reference_lengths(aircraft: &Aircraft) -> Vec<String> {
    let given = aircraft.reference;
    let plain = Aircraft { reference: Default::default(), ..aircraft.clone() };
    let (Some(wing), Some(lengths)) = (aircraft.wing(), plain.reference_lengths()) else { return Vec::new() };
    if !is_largest(aircraft, wing) {
        return Vec::new();
    }
    let halves = if is_half(aircraft, wing) { 2.0 } else { 1.0 };
    let all = [
        ("chord_m", given.chord, lengths.chord, 1.0),
        ("area_m2", given.area, lengths.area, halves),
        ("span_m", given.span, lengths.span, halves),
    ];
    let odd = all.into_iter().filter_map(|(field, given, wing, halves)| {
        let usual = *REFERENCE_RATIOS.start()..=halves * REFERENCE_RATIOS.end();
        let given = given.filter(|given| !usual.contains(&(given / wing)))?;
        let wing = short(wing);
        Some(format!("[reference] {field} is {}, the wing has {wing}: usual is about that", Plain(given)))
    });
    odd.collect()
}

/// Whether nothing lifts with more area than what the library takes for the wing: where a file has a wing as a component for each side, that
/// may be the tail.
fn is_largest(aircraft: &Aircraft, wing: usize) -> bool {
    let area = |component: usize| -> f64 {
        strips(aircraft, component).iter().map(|strip| 2.0 * strip.semichord * strip.width).sum()
    };
    let lifting = (0..aircraft.components.len()).filter(|&component| is_lifting(aircraft, component));
    area(wing) > 0.99 * lifting.map(area).fold(0.0, f64::max)
}

/// Whether a wing is on one side alone and has no image: of half a model, or of an aircraft with a component for each side.
fn is_half(aircraft: &Aircraft, wing: usize) -> bool {
    let places: Vec<f64> = strips(aircraft, wing).iter().map(|strip| middle(aircraft, strip).y).collect();
    let is_on_one_side = places.iter().all(|y| *y > 0.0) || places.iter().all(|y| *y < 0.0);
    aircraft.components[wing].image.is_none() && is_on_one_side
}

/// A component with strips and no mass.
fn massless(aircraft: &Aircraft, component: usize) -> Option<String> {
    let carries = |beam: usize| aircraft.component_of(beam) == Some(component);
    let has_mass = aircraft.bays.iter().any(|bay| carries(bay.attachment.beam) && bay.mass > 0.0);
    (!has_mass && !strips(aircraft, component).is_empty()).then(|| {
        format!(
            "{} has strips and its mass is 0 kg: usual is that what lifts weighs something",
            aircraft.components[component].name
        )
    })
}

/// A surface that is softer in its plane than out of it.
fn stiffness_ratio(aircraft: &Aircraft, component: usize) -> Option<String> {
    let strips = strips(aircraft, component);
    let along = strips.iter().find(|strip| runs_along(aircraft, strip))?;
    let normal = normal(along);
    let ratio = |beam: usize| {
        let element = &aircraft.beams[beam];
        let z_axis = direction(aircraft, beam).cross(&element.y_axis);
        let ratio = element.bending_stiffness_z / element.bending_stiffness_y;
        // v is along y, w along z.
        if z_axis.dot(&normal).abs() >= element.y_axis.dot(&normal).abs() { ratio } else { 1.0 / ratio }
    };
    let lowest = elements(aircraft, component).map(ratio).reduce(f64::min)?;
    (lowest < LEAST_STIFFNESS_RATIO).then(|| {
        format!(
            "{}: EI of bending in the surface is {} of that out of it, usual is {} or more: are EI_y and EI_z exchanged?",
            aircraft.components[component].name,
            short(lowest),
            LEAST_STIFFNESS_RATIO
        )
    })
}

/// Neighbours whose chords differ by much.
fn chord_step(aircraft: &Aircraft, component: usize) -> Option<String> {
    let strips = strips(aircraft, component);
    let along: Vec<&&Strip> = strips.iter().filter(|strip| runs_along(aircraft, strip)).collect();
    let step = |pair: &[&&Strip]| {
        let [one, other] = [pair[0], pair[1]].map(|strip| 2.0 * strip.semichord);
        (one.max(other) / one.min(other) > LARGEST_CHORD_STEP).then(|| {
            format!(
                "{}: the chord goes from {} to {} m from one strip to the next, usual is a factor of {} at most",
                aircraft.components[component].name,
                short(one),
                short(other),
                LARGEST_CHORD_STEP
            )
        })
    };
    along.windows(2).find_map(step)
}

fn lift_slope(aircraft: &Aircraft, component: usize) -> Option<String> {
    let slopes = strips(aircraft, component).into_iter().map(|strip| strip.lift_slope);
    let steepest = slopes.reduce(f64::max).filter(|slope| *slope > LARGEST_LIFT_SLOPE)?;
    Some(format!(
        "{}: lift_slope_per_rad is {}, usual is up to 2π, {} per rad",
        aircraft.components[component].name,
        short(steepest),
        short(TAU)
    ))
}

/// A lifting surface with elements between or beyond its strips that have none; inboard of the first a body may be.
fn gap(aircraft: &Aircraft, component: usize) -> Option<String> {
    if !is_lifting(aircraft, component) {
        return None;
    }
    let strips = strips(aircraft, component);
    let has_strip = |beam: &usize| strips.iter().any(|strip| strip.attachment.beam == *beam);
    let beams = elements(aircraft, component);
    let first = beams.clone().find(has_strip)?;
    let bare = (first..beams.end).filter(|beam| !has_strip(beam)).count();
    (bare > 0).then(|| {
        format!(
            "{}: {bare} of the {} elements from the first strip to the end have no strip, usual are strips on all of them",
            aircraft.components[component].name,
            beams.end - first
        )
    })
}

/// A control that turns no flap.
fn idle_control(aircraft: &Aircraft, control: usize) -> Option<String> {
    let flaps = aircraft.strips.iter().filter_map(|strip| strip.flap.as_ref());
    let moves = flaps.into_iter().any(|flap| flap.gains.get(control).is_some_and(|gain| *gain != 0.0));
    (!moves).then(|| {
        format!(
            "{} moves no flap, for all its gains are 0: usual is that a control moves something",
            aircraft.controls[control].name
        )
    })
}

/// The aftmost, leftmost, highest and the foremost, rightmost, lowest of nodes and chords, in body axes, m.
fn reach(aircraft: &Aircraft) -> [Vector3<f64>; 2] {
    let edges = aircraft.strips.iter().flat_map(|strip| {
        let middle = middle(aircraft, strip) + strip.forward * strip.elastic_axis_aft_of_midchord;
        [-1.0, 1.0].map(|side| middle + strip.forward * (strip.semichord * side))
    });
    let points = aircraft.nodes.iter().copied().chain(edges);
    let ends = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
    points.fold(ends, |[low, high], point| [low.inf(&point), high.sup(&point)])
}

/// Where a strip sits on the elastic axis.
fn middle(aircraft: &Aircraft, strip: &Strip) -> Vector3<f64> {
    let [from, to] = aircraft.beams[strip.attachment.beam].nodes.map(|node| aircraft.nodes[node]);
    from.lerp(&to, strip.attachment.fraction)
}

fn range(range: &RangeInclusive<f64>, unit: &str) -> String {
    format!("{} to {} {unit}", range.start(), range.end())
}

#[cfg(test)]
mod tests;

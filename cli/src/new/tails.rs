//! Tails, canards, fins and winglets.

use super::basis::Basis;
use super::design::{Component, JoinedTail, Move, Part, Structure, Surface};
use super::kind::Kind;
use super::planform::{Planform, SECTION_DRAG};
use super::quantity::in_three_digits;
use super::stiffness;

/// Behind the leading edge, chords.
const ELASTIC_AXIS: f64 = 0.4;

/// Frequencies of tails and fins by the wing's, each held at its root.
const STIFFER: f64 = 3.0;

const ELEMENTS: usize = 6;

pub const HINGE: f64 = 0.68;

/// By which each half of a tail between booms ends before the plane of symmetry, of its length: halves that are not joined do not touch.
const SLIT: f64 = 0.01;

/// What lifts fore or aft, without its side.
pub fn name(kind: Kind) -> &'static str {
    match kind {
        Kind::VTail => "tail",
        Kind::Canard => "canard",
        _ => "htail",
    }
}

pub fn components(basis: &Basis) -> Vec<Component> {
    let mut all: Vec<Component> = fins(basis).into_iter().collect();
    all.extend(tail(basis));
    all
}

/// How much of its lift slope a tail keeps, for the air goes down behind the wing [no downwash in this program].
pub fn kept_lift(basis: &Basis) -> f64 {
    if basis.sizing.kind == Kind::Canard { 1.0 } else { basis.sizing.wing.kept_behind() }
}

fn tail(basis: &Basis) -> Option<Component> {
    let kind = basis.sizing.kind;
    let mut planform = basis.layout.tail?;
    if kind == Kind::TwinBoom {
        planform.length *= 1.0 - SLIT;
    }
    let name = name(kind);
    let at = |component: &str| Some((component.to_owned(), 1.0));
    let (parent, inward) = match kind {
        Kind::TTail | Kind::Sailplane => (at("fin"), false),
        Kind::Canard => (at("fuselage_fore"), false),
        Kind::TwinBoom => (at("boom_right"), true),
        _ => (at("fuselage_aft"), false),
    };
    let role = |input, gain| Move { input, gain, stretch: None };
    let moves = match kind {
        Kind::VTail => vec![role("elevator", 1.0), role("rudder", 1.0)],
        // Down at its trailing edge it turns the nose up.
        Kind::Canard => vec![role("elevator", -1.0)],
        _ => vec![role("elevator", 1.0)],
    };
    let kept = kept_lift(basis);
    let lift_comment = match kind {
        Kind::Canard => "of the finite canard: Raymer eq. 12.6. Its wake on the wing is left out".to_owned(),
        _ => format!(
            "of the finite tail, times 1 - 2 a/(pi A) = {} for the wing's downwash, and so are damping and gusts",
            in_three_digits(kept)
        ),
    };
    let mut tip = planform.tip(ELASTIC_AXIS);
    let mut comment = format!("{}; tail and fin: {}", area_of(&planform, 2.0), basis.layout.tail_rule);
    if inward {
        tip[1] = -tip[1];
        comment += ". The halves end just before the plane of symmetry and are not joined; how to join them stands at the end";
    }
    let surface = Surface {
        incidence: [basis.unknowns.relief; 2],
        lift_slope: planform.lift_slope() * kept,
        suction: planform.suction(planform.lift_slope() * kept),
        lift_comment,
        ..surface(&planform, Some([planform.flap_slope(), HINGE]), moves)
    };
    let mass = basis.layout.masses.tail;
    Some(Component {
        mirror: Some(format!("{name}_left")),
        comment,
        ..lifting(basis, (&format!("{name}_right"), parent, tip), (&planform, mass, 0.0), surface)
    })
}

/// Of a tail between booms, what makes one piece of its halves; none of others.
pub fn joined(basis: &Basis) -> Option<JoinedTail> {
    let planform = basis.layout.tail.filter(|_| basis.sizing.kind == Kind::TwinBoom)?;
    let [x, y, z] = planform.tip(ELASTIC_AXIS);
    Some(JoinedTail { tip: [x, -y, z] })
}

/// The fin, that on the right boom, or the right winglet.
fn fins(basis: &Basis) -> Option<Component> {
    let (kind, masses) = (basis.sizing.kind, &basis.layout.masses);
    let planform = basis.layout.fin?;
    let tip = planform.tip(ELASTIC_AXIS);
    let on_top = if matches!(kind, Kind::TTail | Kind::Sailplane) { 2.0 * masses.tail } else { 0.0 };
    let rudder = || vec![Move { input: "rudder", gain: 1.0, stretch: None }];
    let at = |component: &str| Some((component.to_owned(), 1.0));
    let (name, mirror, parent, moves) = match kind {
        Kind::FlyingWing => ("winglet_right", Some("winglet_left"), at("wing_right"), Vec::new()),
        Kind::TwinBoom => ("fin_right", Some("fin_left"), at("boom_right"), rudder()),
        _ => ("fin", None, at("fuselage_aft"), rudder()),
    };
    let flap = (!moves.is_empty()).then(|| [planform.flap_slope(), HINGE]);
    let comment = match kind {
        Kind::FlyingWing => basis.layout.tail_rule.clone(),
        _ => area_of(&planform, 1.0),
    };
    let surface = surface(&planform, flap, moves);
    Some(Component {
        mirror: mirror.map(str::to_owned),
        comment,
        ..lifting(basis, (name, parent, tip), (&planform, masses.fin, on_top), surface)
    })
}

fn area_of(planform: &Planform, sides: f64) -> String {
    let angle = planform.dihedral.to_degrees();
    let angle = if (1.0..89.0).contains(&angle) {
        format!(" at {} deg", in_three_digits(angle))
    } else {
        String::new()
    };
    format!(
        "{} m2{angle}, acts with an aspect ratio of {}",
        in_three_digits(sides * planform.area()),
        in_three_digits(planform.aspect_ratio)
    )
}

fn surface(planform: &Planform, flap: Option<[f64; 2]>, moves: Vec<Move>) -> Surface {
    Surface {
        elastic_axis: ELASTIC_AXIS,
        incidence: [0.0; 2],
        lift_slope: planform.lift_slope(),
        lift_comment: "Raymer eq. 12.6, with the aspect ratio above".to_owned(),
        profile_drag: SECTION_DRAG,
        drag_comment: String::new(),
        suction: planform.suction(planform.lift_slope()),
        zero_lift_offset: 0.0,
        zero_lift_moment: 0.0,
        flap,
        moves,
    }
}

/// A component that lifts, with masses along it and at its tip.
fn lifting(
    basis: &Basis,
    (name, parent, tip): (&str, Option<(String, f64)>, [f64; 3]),
    (planform, mass, at_tip): (&Planform, f64, f64),
    surface: Surface,
) -> Component {
    let length = planform.axis_length(ELASTIC_AXIS);
    let bending = stiffness::cantilever(STIFFER * basis.sizing.frequency, [mass, at_tip], length);
    let comment = format!("a flat box: {STIFFER} times the wing's frequency by itself");
    let is_upright = tip[2].abs() > tip[1].abs();
    let gyration_lengths = if is_upright { [0.2887, 0.2887, 0.0] } else { [0.2887, 0.0, 0.2887] };
    let gyration_chords = if is_upright { [0.25, 0.25, 0.03] } else { [0.03, 0.25, 0.25] };
    Component {
        comment: String::new(),
        name: name.to_owned(),
        mirror: None,
        parent,
        tip,
        elements: ELEMENTS,
        y_axis: [1, 0, 0],
        chords: Some([planform.root_chord, planform.tip_chord]),
        beam: stiffness::box_beam(comment, bending, planform.root_chord),
        structure: Structure {
            parts: vec![Part { comment: "structure", mass, chord_power: Some(2.0), to: None }],
            aft: Some(0.03),
            gyration_chords: Some(gyration_chords),
            gyration_lengths,
            added_inertia: None,
        },
        lumps: Vec::new(),
        surface: Some(surface),
    }
}

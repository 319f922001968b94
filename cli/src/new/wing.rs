//! The wing.

use super::basis::Basis;
use super::design::{Component, Move, Part, Structure, Surface};
use super::kind::Kind;
use super::layout::ELASTIC_AXIS;
use super::planform::SECTION_DRAG;
use super::quantity::in_three_digits;
use super::stiffness;

/// Centre of mass of the structure behind the elastic axis, chords: skins and flaps aft of the box.
pub const MASS_AFT: f64 = 0.04;

/// Elements of one half: a multiple of 16, so that booms find a node.
const ELEMENTS: usize = 16;

/// NACA 2412 in place of a plain aerofoil: nose-up angle by camber, degrees, and c_m0 [Abbott and von Doenhoff, Theory of
/// Wing Sections].
const CAMBER: [f64; 2] = [2.1, -0.05];

/// Washout of a wing whose tips do the work of a tail, degrees per degree of sweep: 3 at 25.
const WASHOUT: f64 = 0.12;

/// Ailerons or elevons.
const STRETCH: [f64; 2] = [0.6, 0.95];
const ELEVONS: [f64; 2] = [0.5, 0.95];
const HINGE: f64 = 0.75;

pub fn component(basis: &Basis) -> Component {
    let sizing = basis.sizing;
    let (kind, wing) = (sizing.kind, &sizing.wing);
    let is_pair = kind != Kind::WingOnWall;
    let frequency = in_three_digits(sizing.frequency);
    let comment =
        format!("a flat box; EI is such that the first symmetric bending has {frequency} Hz with O held");
    let [sweep, dihedral] = [wing.sweep, wing.dihedral].map(f64::to_degrees).map(in_three_digits);
    Component {
        comment: format!(
            "aspect ratio {}, sweep of the quarter chord {sweep} deg, dihedral {dihedral} deg; the axis is at {ELASTIC_AXIS} of the chord",
            in_three_digits(wing.aspect_ratio)
        ),
        name: if is_pair { "wing_right" } else { "wing" }.to_owned(),
        mirror: is_pair.then(|| "wing_left".to_owned()),
        parent: None,
        tip: wing.tip(ELASTIC_AXIS),
        elements: ELEMENTS,
        y_axis: [1, 0, 0],
        chords: Some([wing.root_chord, wing.tip_chord]),
        beam: stiffness::box_beam(comment, basis.unknowns.bending, wing.root_chord),
        structure: structure(basis),
        lumps: basis.mounts.iter().filter_map(|mount| mount.lump_on("wing_right")).collect(),
        surface: Some(surface(basis)),
    }
}

fn structure(basis: &Basis) -> Structure {
    let masses = &basis.layout.masses;
    let structure = Part { comment: "structure", mass: masses.wing, chord_power: Some(2.0), to: None };
    let fuel = Part { comment: "fuel", mass: masses.fuel, chord_power: Some(2.0), to: Some(0.75) };
    Structure {
        parts: [structure, fuel].into_iter().filter(|part| part.mass > 0.0).collect(),
        aft: Some(MASS_AFT),
        gyration_chords: Some([0.03, 0.25, 0.25]),
        gyration_lengths: [0.2887, 0.0, 0.2887],
        added_inertia: None,
    }
}

fn surface(basis: &Basis) -> Surface {
    let sizing = basis.sizing;
    let wing = &sizing.wing;
    let cos = wing.sweep.cos();
    let incidence = basis.unknowns.incidence;
    let (tip_incidence, camber) = match sizing.kind {
        Kind::FlyingWing => {
            (incidence - (WASHOUT * wing.sweep.to_degrees()).max(0.0), [0.0, basis.unknowns.relief])
        }
        _ => (incidence, [CAMBER[0] * cos, CAMBER[1] * cos * cos]),
    };
    let aileron = |gain, stretch| Move { input: "aileron", gain, stretch: Some(stretch) };
    let moves = match sizing.kind {
        Kind::FlyingWing => {
            vec![Move { input: "elevator", gain: 1.0, stretch: Some(ELEVONS) }, aileron(-1.0, ELEVONS)]
        }
        // Nothing rolls, and a flap down is what people ask of a tunnel.
        Kind::WingOnWall => vec![Move { input: "flap", gain: 1.0, stretch: Some(STRETCH) }],
        _ => vec![aileron(-1.0, STRETCH)],
    };
    Surface {
        elastic_axis: ELASTIC_AXIS,
        incidence: [incidence, tip_incidence],
        lift_slope: wing.lift_slope(),
        lift_comment: "of the finite wing: Raymer eq. 12.6".to_owned(),
        profile_drag: sizing.usual.profile_drag - SECTION_DRAG * basis.layout.area_of_tails() / sizing.area,
        drag_comment: match sizing.kind {
            Kind::WingOnWall => String::new(),
            _ => "of the whole aircraft but its tails, which is all put here".to_owned(),
        },
        suction: wing.suction(wing.lift_slope()),
        zero_lift_offset: camber[0],
        zero_lift_moment: camber[1],
        flap: Some([wing.flap_slope(), HINGE]),
        moves,
    }
}

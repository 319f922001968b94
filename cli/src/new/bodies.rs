//! Fuselages, pods and booms.

use super::basis::Basis;
use super::design::{Component, Lump, Part, Place, Structure};
use super::kind::Kind;
use super::layout::BOOM_PLACE;
use super::quantity::in_three_digits;
use super::stiffness;

/// Frequencies of bodies by the wing's: they are stiffer.
const STIFFER: f64 = 2.5;

/// Length of the payload by that of the fuselage.
const LOAD_LENGTH: f64 = 0.3;

const ELEMENTS: usize = 8;

/// The fuselage ahead of O and behind it, and booms.
pub fn components(basis: &Basis) -> Vec<Component> {
    let layout = &basis.layout;
    let bending = fuselage_bending(basis);
    let comment = format!("a round tube, stiffer than the wing: {STIFFER} times its frequency by itself");
    let whole = layout.nose + layout.aft;
    let mut all: Vec<Component> = [("fuselage_fore", layout.nose), ("fuselage_aft", -layout.aft)]
        .into_iter()
        .map(|(name, reach)| {
            let mass = layout.masses.body * reach.abs() / whole;
            let mut lumps: Vec<Lump> = basis.mounts.iter().filter_map(|mount| mount.lump_on(name)).collect();
            let is_here = (basis.unknowns.load >= 0.0) == (reach > 0.0);
            lumps.extend(is_here.then(|| load(basis)));
            let beam = stiffness::tube(comment.clone(), bending, layout.radius);
            body(name, (reach, mass, layout.radius), beam, lumps)
        })
        .collect();
    all[0].comment = format!(
        "from O to the nose; {} m long with the rest, {} m thick. Bodies lift nothing here, their drag is the wing's",
        in_three_digits(whole),
        in_three_digits(2.0 * layout.radius)
    );
    all[1].comment = "from O to the tail".to_owned();
    if basis.sizing.kind == Kind::TwinBoom {
        all.push(boom(basis));
    }
    all
}

/// What the centre of mass is put in its place with.
fn load(basis: &Basis) -> Lump {
    let (layout, place) = (&basis.layout, basis.unknowns.load);
    let round = 0.6 * layout.radius;
    let along = LOAD_LENGTH * (layout.nose + layout.aft) / 12_f64.sqrt();
    Lump {
        comment: "payload, crew, systems, gear: placed for the static margin".to_owned(),
        at: Place::Metres(place.abs()),
        mass: layout.masses.load,
        offset: [0.0; 3],
        gyration: [round, along, along],
    }
}

/// EI at which both parts, held at O, are stiff enough, N m².
fn fuselage_bending(basis: &Basis) -> f64 {
    let layout = &basis.layout;
    let masses = &layout.masses;
    let frequency = STIFFER * basis.sizing.frequency;
    let is_on_it = basis.sizing.kind != Kind::TwinBoom && basis.sizing.kind != Kind::FlyingWing;
    let tails = if is_on_it { 2.0 * masses.tail + masses.fin } else { 0.0 };
    let on = |name: &str| -> f64 {
        basis.mounts.iter().filter_map(|mount| mount.lump_on(name)).map(|lump| lump.mass).sum()
    };
    let [fore_tails, aft_tails] =
        if basis.sizing.kind == Kind::Canard { [2.0 * masses.tail, masses.fin] } else { [0.0, tails] };
    // Payload by its place along its part, as a cantilever's tip mass: with the cube of the place.
    let place = basis.unknowns.load;
    let part = if place > 0.0 { place / layout.nose } else { place / layout.aft };
    let load = masses.load * part.abs().powi(3);
    let [fore_load, aft_load] = if place > 0.0 { [load, 0.0] } else { [0.0, load] };
    let half = 0.5 * masses.body;
    let fore = [half, fore_tails + on("fuselage_fore") + fore_load];
    let aft = [half, aft_tails + on("fuselage_aft") + aft_load];
    stiffness::cantilever(frequency, fore, layout.nose).max(stiffness::cantilever(frequency, aft, layout.aft))
}

fn boom(basis: &Basis) -> Component {
    let layout = &basis.layout;
    let masses = &layout.masses;
    let radius = 0.4 * layout.radius;
    let carried = [masses.boom, masses.tail + masses.fin];
    let bending = stiffness::cantilever(STIFFER * basis.sizing.frequency, carried, layout.boom);
    let comment = format!("a round tube: {STIFFER} times the wing's frequency by itself");
    let beam = stiffness::tube(comment, bending, radius);
    Component {
        comment: "carries a fin and half of the tail; its root is a node of the wing".to_owned(),
        mirror: Some("boom_left".to_owned()),
        parent: Some(("wing_right".to_owned(), BOOM_PLACE)),
        ..body("boom_right", (-layout.boom, masses.boom, radius), beam, Vec::new())
    }
}

/// Along x.
fn body(
    name: &str,
    (reach, mass, radius): (f64, f64, f64),
    beam: super::design::Beam,
    lumps: Vec<Lump>,
) -> Component {
    let structure = Part { comment: "structure", mass, chord_power: None, to: None };
    Component {
        comment: String::new(),
        name: name.to_owned(),
        mirror: None,
        parent: None,
        tip: [reach, 0.0, 0.0],
        elements: ELEMENTS,
        y_axis: [0, 1, 0],
        chords: None,
        beam,
        structure: Structure {
            parts: vec![structure],
            aft: None,
            gyration_chords: None,
            gyration_lengths: [0.0, 0.2887, 0.2887],
            added_inertia: Some(mass * radius * radius / ELEMENTS as f64),
        },
        lumps,
        surface: None,
    }
}

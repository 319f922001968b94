//! What a deck leaves open: whether it flies, how fast, what pushes it, where it is held.

use clap::ValueEnum;
use flexible_aircraft::air::{Air, STANDARD_GRAVITY};

use super::aero::{Control, Role, Surface};
use super::cards::Cards;
use super::frames::World;
use super::mistakes::{Mistakes, Remarks};
use super::structure::{Held, Structure};
use super::write::Engine;

/// Whether the aircraft flies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Support {
    /// It flies
    Free,
    /// It is held at O in a wind tunnel
    Clamped,
}

/// Lift coefficient of a trim whose airspeed nobody gives.
const LIFT_COEFFICIENT: f64 = 0.5;

/// Lift coefficients at which aircraft fly: at the VELOCITY of an AERO they have another one where it is 1, as decks of analyses say.
const LIFT_COEFFICIENTS: std::ops::RangeInclusive<f64> = 0.05..=1.5;

/// Airspeed, m/s, of what is clamped, where nobody gives one.
const TUNNEL_SPEED: f64 = 50.0;

/// Where O is, and why there.
pub fn held(structure: &Structure) -> String {
    let grid = structure.root_grid;
    match &structure.held {
        Held::Clamped(origin) => format!("O: GRID {grid}, which {origin} clamps"),
        Held::Hinged { by, needs_links: false } => format!("O: GRID {grid}, which the springs of {by} hold"),
        Held::Hinged { by, needs_links: true } => {
            format!(
                "O: GRID {grid}, which the springs of {by} hold, with two rigid elements of 1 mm there and back"
            )
        }
        Held::Asked => format!("O: GRID {grid} (--origin)"),
        Held::Supported => format!("O: GRID {grid} (SUPORT)"),
        Held::NearestToMass => {
            format!("O: GRID {grid}, the one in the plane of symmetry nearest to the centre of mass")
        }
    }
}

/// Controls that move something, with the surfaces that know them by their new places.
pub fn used(
    mut surfaces: Vec<Surface>,
    controls: Vec<Control>,
    remarks: &mut Remarks,
) -> (Vec<Surface>, Vec<Control>) {
    let moves = |control: usize| {
        let mut flaps = surfaces.iter().filter_map(|surface| surface.flap.as_ref());
        flaps.any(|flap| flap.moves.iter().any(|(other, _)| *other == control))
    };
    let is_used: Vec<bool> = (0..controls.len()).map(moves).collect();
    let places: Vec<usize> = is_used
        .iter()
        .scan(0, |next, used| {
            let place = *next;
            *next += usize::from(*used);
            Some(place)
        })
        .collect();
    for (control, _) in controls.iter().zip(&is_used).filter(|(_, used)| !**used) {
        remarks
            .card(&control.origin, format!("{}: no strip has a flap of it, it is left out", control.label));
    }
    for (control, _) in
        surfaces.iter_mut().filter_map(|surface| surface.flap.as_mut()).flat_map(|flap| &mut flap.moves)
    {
        *control = places[*control];
    }
    let kept = controls.into_iter().zip(is_used).filter(|(_, used)| *used).map(|(control, _)| control);
    (surfaces, kept.collect())
}

/// What is clamped in the deck is; what is free flies, if a control holds it in pitch.
pub fn support(
    asked: Option<Support>,
    structure: &Structure,
    roles: &[Option<Role>],
    remarks: &mut Remarks,
) -> Support {
    let is_held = matches!(structure.held, Held::Clamped(_) | Held::Hinged { .. });
    let usual = if is_held { Support::Clamped } else { Support::Free };
    let support = asked.unwrap_or(usual);
    if support == Support::Free && !roles.contains(&Some(Role::Pitch)) {
        remarks.general.push(
            "nothing holds it in pitch, no AESURF and no --surface with a control that pitches it alone: a free aircraft needs one, so it is written with \
             support = \"clamped\""
                .to_owned(),
        );
        return Support::Clamped;
    }
    support
}

/// Of the trim, m/s, with what it comes from.
pub fn airspeed(
    (asked, altitude): (Option<f64>, f64),
    cards: &Cards,
    (support, mass, area, length): (Support, f64, f64, f64),
    remarks: &mut Remarks,
) -> (f64, String) {
    if let Some(airspeed) = asked {
        return (airspeed, String::new());
    }
    let flies = |airspeed: &f64| (1.0..=400.0).contains(airspeed);
    // What lifts the weight has this airspeed squared, times the lift coefficient.
    let squared = 2.0 * mass * STANDARD_GRAVITY / (Air::at(altitude).density * area);
    if let Some(airspeed) = cards.aero.reference.airspeed.map(|airspeed| airspeed * length) {
        let coefficient = squared / (airspeed * airspeed);
        // In a tunnel there may be little of the aircraft, or no panel.
        let is_plausible = match support {
            Support::Free => LIFT_COEFFICIENTS.contains(&coefficient),
            Support::Clamped => area <= 0.0 || coefficient <= *LIFT_COEFFICIENTS.end(),
        };
        if flies(&airspeed) && is_plausible {
            return (airspeed, "VELOCITY of AERO".to_owned());
        }
        let why = match () {
            () if area <= 0.0 => "there is no panel".to_owned(),
            () => format!("the lift coefficient would be {coefficient:.3}"),
        };
        remarks.note(format!("AERO: its VELOCITY, {airspeed} m/s, is not taken for the trim: {why}"));
    }
    let airspeed = libm::sqrt(squared / LIFT_COEFFICIENT).round();
    match support {
        Support::Free if flies(&airspeed) => {
            (airspeed, format!("assumed: lift coefficient {LIFT_COEFFICIENT}"))
        }
        _ => (TUNNEL_SPEED, "assumed".to_owned()),
    }
}

/// Thrust at grids.
pub fn engines(
    asked: &[(String, i64)],
    (world, structure): (&World, &Structure),
    mistakes: &mut Mistakes,
) -> Vec<Engine> {
    let mut engines: Vec<Engine> = Vec::new();
    for (name, grid) in asked {
        let place = world.grid(*grid).map(|place| place - structure.origin);
        let node = place.and_then(|place| structure.node_at(*grid, &place));
        let (Some(place), Some((at, node))) = (place, node) else {
            mistakes.of_whole(format!("--engine {name}={grid}: found no grid of the aircraft, a GRID that a beam or a rigid link carries is needed"));
            continue;
        };
        if engines.iter().any(|engine| engine.name == *name) {
            mistakes.of_whole(format!("--engine: found {name} twice, each has a name of its own"));
        }
        let (component, node) = structure.carriers(node)[0];
        engines.push(Engine { name: name.clone(), component, node, offset: place - at });
    }
    engines
}

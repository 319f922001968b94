//! Masses at grids in body axes and SI: centre, inertia about it, as a body has them.

use nalgebra::{Matrix3, Vector3};

use super::cards::{Cards, LumpCard, LumpContent};
use super::frames::World;
use super::inertia;
use super::mistakes::{Mistakes, Needed, Origin, Remarks};
use super::units::Units;

/// A matrix of mass whose parts differ by more than this share of it belongs to no body.
const BODY: f64 = 1e-6;

/// Of an inertia without mass, the mass that it gets: this share of what the deck has.
const LEAST_SHARE: f64 = 1e-6;

/// A rigid body on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Lump {
    pub origin: Origin,
    pub grid: i64,
    /// Where the grid is, m.
    pub at: Vector3<f64>,
    /// kg.
    pub mass: f64,
    /// m.
    pub centre: Vector3<f64>,
    /// About the centre, kg m².
    pub inertia: Matrix3<f64>,
}

/// All masses of CONM1 and CONM2, beside so many kg of elements.
pub fn lumps(
    (cards, world, units): (&Cards, &World, &Units),
    of_elements: f64,
    (mistakes, remarks): (&mut Mistakes, &mut Remarks),
) -> Vec<Lump> {
    let mut lumps = Vec::new();
    for card in &cards.lumps {
        let Some(grid) = world.grid(card.grid) else {
            if !cards.grids.contains_key(&card.grid) {
                mistakes.missing(&card.origin, "G", card.grid, Needed::Grid);
            }
            continue;
        };
        let is_basic = card.frame == -1 && matches!(card.content, LumpContent::Body { .. });
        let axes = if is_basic { Some(world.basic_axes()) } else { world.axes_at(card.frame, card.grid) };
        let Some(axes) = axes else {
            mistakes.missing(&card.origin, "CID", card.frame, Needed::Frame);
            continue;
        };
        let lump = match &card.content {
            LumpContent::Body { mass, place, inertia } => {
                let [i11, i21, i22, i31, i32, i33] = *inertia;
                let local = Matrix3::new(i11, -i21, -i31, -i21, i22, -i32, -i31, -i32, i33);
                let from_zero = || world.point(0, *place);
                let from_grid = grid + axes * Vector3::from(*place) * units.length;
                let centre = if is_basic { from_zero().unwrap_or(from_grid) } else { from_grid };
                let inertia = axes * local * axes.transpose() * units.inertia();
                Some(Lump {
                    origin: card.origin.clone(),
                    grid: card.grid,
                    at: grid,
                    mass: mass * units.mass,
                    centre,
                    inertia,
                })
            }
            LumpContent::Matrix(terms) => of_matrix(card, terms, (grid, axes, units), remarks),
        };
        lumps.extend(lump.filter(|lump| is_a_body(lump, (mistakes, remarks))));
    }
    let total = lumps.iter().fold(of_elements, |sum, lump| sum + lump.mass);
    lumps.into_iter().filter_map(|lump| mended(lump, total, remarks)).collect()
}

/// Says of what is nothing, or less, that it is left out.
fn is_a_body(lump: &Lump, (mistakes, remarks): (&mut Mistakes, &mut Remarks)) -> bool {
    if lump.mass < 0.0 {
        remarks.card(
            &lump.origin,
            format!("found a mass of {:.6} kg, which no body has: it is left out", lump.mass),
        );
        return false;
    }
    if lump.mass > 1e9 || lump.inertia.amax() > 1e12 || !lump.inertia.iter().all(|term| term.is_finite()) {
        let allowed = "up to 1e9 kg and 1e12 kg m² is allowed; --units says what the deck's units are";
        mistakes.of_origin(&lump.origin, "M", format!("found {:.4e} kg", lump.mass), allowed);
        return false;
    }
    if lump.mass == 0.0 && lump.inertia.amax() == 0.0 {
        remarks.note(format!("{} has neither mass nor inertia", lump.origin));
        return false;
    }
    true
}

/// A mass from its 6 × 6 matrix about the grid.
fn of_matrix(
    card: &LumpCard,
    terms: &[f64; 21],
    (grid, axes, units): (Vector3<f64>, Matrix3<f64>, &Units),
    remarks: &mut Remarks,
) -> Option<Lump> {
    let term = |row: usize, column: usize| {
        let (row, column) = (row.max(column), row.min(column));
        terms[row * (row + 1) / 2 + column]
    };
    let mass = (term(0, 0) + term(1, 1) + term(2, 2)) / 3.0;
    // m times the cross matrix of the centre, transposed, stands right above; the mean of its two halves is nearest.
    let first = Vector3::new(
        0.5 * (term(1, 5) - term(2, 4)),
        0.5 * (term(2, 3) - term(0, 5)),
        0.5 * (term(0, 4) - term(1, 3)),
    );
    if mass <= 0.0 {
        remarks.card(&card.origin, "its translations have no mass: it is left out");
        return None;
    }
    let arm = first / mass;
    let about_grid = Matrix3::from_fn(|row, column| term(row + 3, column + 3));
    let cross = arm.cross_matrix();
    let inertia = about_grid + cross * cross * mass;
    let coupling = Matrix3::from_fn(|row, column| term(row, column + 3));
    let translations = Matrix3::from_fn(&term);
    let missed = (translations - Matrix3::identity() * mass).amax() / mass
        + (coupling + cross * mass).amax() / (mass * arm.norm().max(1e-3));
    if missed > BODY {
        let said = format!(
            "its matrix is that of no rigid body: the nearest is held, mass {:.6} kg in all directions",
            mass * units.mass
        );
        remarks.card(&card.origin, said);
    }
    Some(Lump {
        origin: card.origin.clone(),
        grid: card.grid,
        at: grid,
        mass: mass * units.mass,
        centre: grid + axes * arm * units.length,
        inertia: axes * inertia * axes.transpose() * units.inertia(),
    })
}

/// What is said of many masses whose inertia no body has.
const MENDED: &str =
    "no body has their principal moments: those that are too small are held larger, none smaller";

/// As a body has it.
fn mended(mut lump: Lump, total: f64, remarks: &mut Remarks) -> Option<Lump> {
    let Some(mended) = inertia::mend(&lump.inertia) else {
        remarks.card(&lump.origin, "its inertia has no principal moments: the mass is held as a point");
        return Some(Lump { inertia: Matrix3::zeros(), ..lump });
    };
    if let Some(before) = mended.from {
        let shown = |moments: [f64; 3]| moments.map(|moment| format!("{moment:.6}")).join(", ");
        let said = format!(
            "no body has the principal moments {} kg m²: they are held as {}",
            shown(before),
            shown(mended.to)
        );
        remarks.card_of_many(&lump.origin, said, MENDED);
        lump.inertia = mended.inertia;
    }
    if lump.mass == 0.0 {
        if total <= 0.0 {
            remarks.card(&lump.origin, "an inertia without any mass in the deck is left out");
            return None;
        }
        lump.mass = LEAST_SHARE * total;
        remarks.card(&lump.origin, format!("an inertia without mass: it gets {:.3e} kg", lump.mass));
    }
    Some(lump)
}

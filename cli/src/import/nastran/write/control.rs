//! Controls, and how their gains pass to mirror images.

use super::super::aero::{self, Control, Role};
use super::super::pairs::Side;
use super::{Written, number};
use crate::commented::comment;

/// How gains pass to the images of components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirroring {
    Same,
    Opposite,
    None,
}

/// What each control does to each surface on both sides.
pub struct Moved {
    pub mirroring: Vec<Mirroring>,
    /// The gains on the image of each surface, by control; of surfaces without image none.
    images: Vec<Vec<(usize, f64)>>,
}

impl Moved {
    pub fn new(written: &Written) -> Self {
        let images: Vec<Vec<(usize, f64)>> =
            (0..written.surfaces.len()).map(|surface| image(written, surface)).collect();
        let mirroring =
            (0..written.controls.len()).map(|control| mirroring(written, &images, control)).collect();
        Moved { mirroring, images }
    }

    /// Of a control on the image of a surface.
    pub fn on_image(&self, surface: usize, control: usize) -> f64 {
        gain(&self.images[surface], control)
    }
}

/// What moves the surface of the image that is in the same place as a surface.
fn image(written: &Written, surface: usize) -> Vec<(usize, f64)> {
    let own = &written.surfaces[surface];
    let Side::Written { image } = written.sides[own.component] else { return Vec::new() };
    let place =
        written.surfaces.iter().take(surface).filter(|other| other.component == own.component).count();
    let other = written.surfaces.iter().filter(|other| other.component == image).nth(place);
    other.and_then(|other| other.flap.as_ref()).map_or_else(Vec::new, |flap| flap.moves.clone())
}

fn gain(moves: &[(usize, f64)], control: usize) -> f64 {
    moves.iter().filter(|(other, _)| *other == control).map(|(_, gain)| gain).sum()
}

/// A flap that a control turns: how far to the right it is, whether it stands upright as a fin's, which way it turns.
struct Turn {
    side: f64,
    is_upright: bool,
    sign: f64,
}

fn turns(written: &Written, control: usize) -> Vec<Turn> {
    let mut turns = Vec::new();
    for surface in written.surfaces {
        let gain = surface.flap.as_ref().map_or(0.0, |flap| gain(&flap.moves, control));
        if gain != 0.0 {
            let (at, span) = aero::middle(written.structure, surface);
            turns.push(Turn { side: at.y, is_upright: span.z.abs() > span.y.abs(), sign: gain.signum() });
        }
    }
    turns
}

/// Which way flaps on the right turn, and those on the left, if all on a side turn one way.
fn by_side(turns: &[Turn]) -> [Option<f64>; 2] {
    [1.0, -1.0].map(|side| one_sign(turns.iter().filter(|turn| turn.side * side > 0.0)))
}

fn one_sign<'t>(mut turns: impl Iterator<Item = &'t Turn>) -> Option<f64> {
    let first = turns.next()?.sign;
    turns.all(|turn| turn.sign == first).then_some(first)
}

fn mirroring(written: &Written, images: &[Vec<(usize, f64)>], control: usize) -> Mirroring {
    let mut signs = Vec::new();
    for (surface, own) in written.surfaces.iter().enumerate() {
        if matches!(written.sides[own.component], Side::Written { .. }) {
            let here = own.flap.as_ref().map_or(0.0, |flap| gain(&flap.moves, control));
            let there = gain(&images[surface], control);
            if here != 0.0 || there != 0.0 {
                signs.push(if here == there {
                    1
                } else if here == -there {
                    -1
                } else {
                    0
                });
            }
        }
    }
    if signs.is_empty() {
        // Nothing is an image: what the sides do shows what it is.
        let is_opposite =
            matches!(by_side(&turns(written, control)), [Some(right), Some(left)] if right == -left);
        return if is_opposite { Mirroring::Opposite } else { Mirroring::Same };
    }
    if signs.iter().all(|sign| *sign == 1) {
        Mirroring::Same
    } else if signs.iter().all(|sign| *sign == -1) {
        Mirroring::Opposite
    } else {
        Mirroring::None
    }
}

pub fn controls(written: &Written, moved: &Moved) -> String {
    let mut text = String::new();
    for (place, control) in written.controls.iter().enumerate() {
        text += &one(written, (place, control), (moved.mirroring[place], written.roles[place]));
    }
    text
}

fn one(
    written: &Written,
    (place, control): (usize, &Control),
    (mirroring, role): (Mirroring, Option<Role>),
) -> String {
    let mirror = match mirroring {
        Mirroring::Same => "same",
        Mirroring::Opposite => "opposite",
        Mirroring::None => "none",
    };
    let mut text = comment(&format!("{} ({})", control.origin, (written.shown)(&control.origin)));
    text += &format!(
        "[[control]]\nname = \"{}\"\ndescription = \"{}\"\npositive = \"{}\"\nmirror = \"{mirror}\"\n",
        control.name,
        description(control),
        positive(&turns(written, place))
    );
    if let Some(role) = role {
        text += &format!("trim = \"{}\"\n", role.name());
    }
    if let Some([low, high]) = control.limits.map(|limits| limits.map(f64::to_degrees)) {
        text += &format!("minimum_deg = {}\nmaximum_deg = {}\n", number(low), number(high));
    }
    text + "\n"
}

/// What the deck calls it, without what stands in no line.
fn description(control: &Control) -> String {
    let plain: String =
        control.label.chars().filter(|c| !c.is_control() && !['"', '\\'].contains(c)).collect();
    if plain.trim().is_empty() { control.name.clone() } else { plain.trim().to_owned() }
}

/// What a positive angle does.
fn positive(turns: &[Turn]) -> &'static str {
    let uprights = turns.iter().filter(|turn| turn.is_upright).count();
    match (one_sign(turns.iter()), by_side(turns)) {
        (Some(1.0), _) if uprights == 0 => "trailing edge down",
        (Some(_), _) if uprights == 0 => "trailing edge up",
        (Some(1.0), _) if uprights == turns.len() => "trailing edge to the right",
        (Some(_), _) if uprights == turns.len() => "trailing edge to the left",
        (Some(1.0), _) => "trailing edge down, of a fin to the right",
        (Some(_), _) => "trailing edge up, of a fin to the left",
        (None, [Some(1.0), Some(-1.0)]) => "trailing edge down on the right, up on the left",
        (None, [Some(-1.0), Some(1.0)]) => "trailing edge up on the right, down on the left",
        _ => "trailing edge down, of a fin to the right, where its gain is above 0",
    }
}

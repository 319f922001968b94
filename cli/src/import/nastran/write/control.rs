//! Controls, and how their gains pass to mirror images.

use super::super::aero::{Control, Role};
use super::super::layout::middle;
use super::super::pairs::Side;
use super::{Written, comment, number};

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
        return of_sides(written, control);
    }
    if signs.iter().all(|sign| *sign == 1) {
        Mirroring::Same
    } else if signs.iter().all(|sign| *sign == -1) {
        Mirroring::Opposite
    } else {
        Mirroring::None
    }
}

/// What a control does to components without images: opposite where all that is on the right turns against all that is on the left.
fn of_sides(written: &Written, control: usize) -> Mirroring {
    let mut sides = [Vec::new(), Vec::new()];
    for surface in written.surfaces {
        let gain = surface.flap.as_ref().map_or(0.0, |flap| gain(&flap.moves, control));
        let y = middle(&written.structure.components[surface.component]).y;
        if gain != 0.0 {
            sides[usize::from(y < 0.0)].push(gain);
        }
    }
    let [right, left] = sides;
    let is_opposite = !left.is_empty() && right.iter().all(|one| left.iter().all(|other| one * other < 0.0));
    if is_opposite && !right.is_empty() { Mirroring::Opposite } else { Mirroring::Same }
}

pub fn controls(written: &Written, moved: &Moved) -> String {
    let mut text = String::new();
    for (place, control) in written.controls.iter().enumerate() {
        text += &one(written, control, (moved.mirroring[place], written.roles[place]));
    }
    text
}

fn one(written: &Written, control: &Control, (mirroring, role): (Mirroring, Option<Role>)) -> String {
    let mirror = match mirroring {
        Mirroring::Same => "same",
        Mirroring::Opposite => "opposite",
        Mirroring::None => "none",
    };
    let mut text = comment(&format!("{} ({})", control.origin, (written.shown)(&control.origin)));
    text += &format!(
        "[[control]]\nname = \"{}\"\ndescription = \"{}\"\npositive = \"{}\"\nmirror = \"{mirror}\"\n",
        control.name,
        control.label.replace(|letter: char| matches!(letter, '"' | '\\') || letter.is_control(), "_"),
        positive(control, (mirroring, role))
    );
    if let Some(role) = role {
        text += &format!("trim = \"{}\"\n", role.name());
    }
    let limits = control.limits.map(|limit| limit.map(f64::to_degrees));
    if let [Some(low), Some(high)] = limits {
        text += &format!("minimum_deg = {}\nmaximum_deg = {}\n", number(low), number(high));
    }
    text + "\n"
}

/// What a positive angle does.
fn positive(control: &Control, (mirroring, role): (Mirroring, Option<Role>)) -> &'static str {
    let is_down = control.parts.first().is_none_or(|part| part.gain > 0.0);
    match (mirroring, role, is_down) {
        (Mirroring::Opposite, _, true) => {
            "trailing edge down on the first of its surfaces, up on the other side"
        }
        (Mirroring::Opposite, _, false) => {
            "trailing edge up on the first of its surfaces, down on the other side"
        }
        (_, Some(Role::Yaw), true) => "trailing edge to the right",
        (_, Some(Role::Yaw), false) => "trailing edge to the left",
        (_, _, true) => "trailing edge down, of a fin to the right",
        (_, _, false) => "trailing edge up, of a fin to the left",
    }
}

//! Strips of a component, with what no deck says of them: marked as assumed.

use std::f64::consts::{PI, TAU};

use super::super::aero::{Flap, Surface};
use super::super::pairs::Side;
use super::control::{Mirroring, Moved};
use super::law::{per_element, straight};
use super::{Written, beside, number, vector};

/// Profile drag of every strip.
const PROFILE_DRAG: f64 = 0.01;

/// Lift slope of every strip, 1/rad: that of thin aerofoils.
const LIFT_SLOPE: f64 = TAU;

pub fn text(written: &Written, surface: &Surface, moved: &Moved) -> String {
    let source = format!("{} ({})", surface.origin, (written.shown)(&surface.origin));
    let mut text = beside("\n[[component.surface]]", &source);
    if surface.from > 0.0 {
        text += &format!("from = {}\n", number(surface.from));
    }
    if surface.to < 1.0 {
        text += &format!("to = {}\n", number(surface.to));
    }
    let widest = surface.chords.iter().copied().fold(0.0, f64::max);
    text += &format!("chord_m = {}\n", straight(&surface.at, &surface.chords, 1e-9 * widest));
    text += &format!("elastic_axis = {}\n", straight(&surface.middles, &surface.elastic_axes, 1e-9));
    if let Some(axis) = &surface.span_axis {
        text += &format!("span_axis = {}\n", vector(axis));
    }
    if let Some(widths) = &surface.widths {
        text += &format!("width_m = {}\n", per_element(widths));
    }
    text += &beside(&format!("lift_slope_per_rad = {}", number(LIFT_SLOPE)), "assumed: 2 pi");
    text += &beside(&format!("profile_drag = {PROFILE_DRAG}"), "assumed");
    text += &beside(
        &format!("leading_edge_suction = {}", number(LIFT_SLOPE / TAU)),
        "assumed: lift slope / 2 pi",
    );
    if let Some(flap) = &surface.flap {
        text += &of_flap(written, surface, flap, moved);
    }
    text
}

fn of_flap(written: &Written, surface: &Surface, flap: &Flap, moved: &Moved) -> String {
    let slope = flap.effectiveness * slope(flap.hinge);
    let line = format!("flap = {{ lift_slope_per_rad = {}, hinge = {} }}", number(slope), number(flap.hinge));
    let mut text = beside(&line, "assumed: thin aerofoil");
    let place = written.surfaces.iter().position(|other| std::ptr::eq(other, surface)).unwrap_or(0);
    let has_image = matches!(written.sides[surface.component], Side::Written { .. });
    for control in 0..written.controls.len() {
        let here: f64 = flap.moves.iter().filter(|(other, _)| *other == control).map(|(_, gain)| gain).sum();
        let name = &written.controls[control].name;
        let line = |gain: f64, side: &str| {
            format!("\n[[component.surface.control]]\ninput = \"{name}\"\ngain = {}\n{side}", number(gain))
        };
        if !has_image || moved.mirroring[control] != Mirroring::None {
            if here != 0.0 {
                text += &line(here, "");
            }
            continue;
        }
        for (gain, side) in [(here, "right"), (moved.on_image(place, control), "left")] {
            if gain != 0.0 {
                text += &line(gain, &format!("side = \"{side}\"\n"));
            }
        }
    }
    text
}

/// Lift of a flap with its hinge at a fraction of the chord, 1/rad [Glauert's thin aerofoil with a flap].
fn slope(hinge: f64) -> f64 {
    let angle = libm::acos(1.0 - 2.0 * hinge);
    2.0 * (PI - angle + libm::sin(angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flap_of_all_the_chord_lifts_as_the_aerofoil_and_one_of_a_quarter_by_six_tenths() {
        assert!((slope(0.0) - TAU).abs() < 1e-12);
        // Abbott and von Doenhoff, Theory of Wing Sections, §8.2: effectiveness of a quarter-chord flap 0.609.
        assert!((slope(0.75) / TAU - 0.609).abs() < 5e-4, "{}", slope(0.75) / TAU);
    }
}

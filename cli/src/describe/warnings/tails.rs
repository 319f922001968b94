//! Volumes of tails: area by lever, against area and chord (tailplanes, foreplanes) or span (fins) of the wing. A strip that is neither
//! level nor upright counts for both, by the squares of its normal's components, as in a V-tail. A surface that is within a chord of the centre
//! of mass on the whole is no tail.

use std::ops::RangeInclusive;

use flexible_aircraft::Aircraft;
use flexible_aircraft::aircraft::{ReferenceLengths, Strip};

use super::super::facts::Facts;
use super::super::surfaces::{is_lifting, normal, strips};
use super::{middle, range};
use crate::numbers::short;

/// Of tailplanes: 0.4 of a fighter to 1 of a jet transport (Raymer, Aircraft Design, table 6.4), with room on both sides.
const TAILPLANES: RangeInclusive<f64> = 0.2..=1.5;

/// Of foreplanes, which also carry.
const FOREPLANES: RangeInclusive<f64> = 0.05..=1.5;

/// Of fins: 0.02 of a sailplane to 0.09 of a jet transport (same table), with room on both sides.
const FINS: RangeInclusive<f64> = 0.005..=0.2;

/// Less of the wing's area is no surface of its own: what winglets have level, what a wing's dihedral has upright.
const LEAST_AREA: f64 = 0.02;

/// Normals that are this much alike belong to one surface: 45°.
const SAME_SURFACE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Area, m², and area by lever behind the centre of mass, m³.
#[derive(Clone, Copy, Default)]
struct Volume {
    area: f64,
    moment: f64,
}

impl Volume {
    fn add(&mut self, area: f64, lever: f64) {
        self.area += area;
        self.moment += area * lever;
    }
}

/// What is unusual about the sizes of tails.
pub fn volumes(aircraft: &Aircraft, facts: &Facts) -> Vec<String> {
    let (Some(lengths), Some(wing)) = (facts.reference, aircraft.wing()) else { return Vec::new() };
    let [mut behind, mut ahead, mut upright] = [Volume::default(); 3];
    for component in 0..aircraft.components.len() {
        if !is_lifting(aircraft, component) || continues(aircraft, component, wing) {
            continue;
        }
        let strips = strips(aircraft, component);
        let area = |strip: &Strip| 2.0 * strip.semichord * strip.width;
        let lever = |strip: &Strip| facts.centre_of_mass.x - aerodynamic_centre(aircraft, strip);
        let mut all = Volume::default();
        strips.iter().for_each(|strip| all.add(area(strip), lever(strip)));
        // A strut or another wing, not a tail.
        if all.moment.abs() < all.area * lengths.chord {
            continue;
        }
        for strip in strips {
            let (area, lever) = (area(strip), lever(strip));
            let [across, down] = [normal(strip).y, normal(strip).z].map(|part| part * part);
            upright.add(area * across, lever);
            if lever > 0.0 { &mut behind } else { &mut ahead }.add(area * down, lever.abs());
        }
    }
    let ReferenceLengths { chord, area, span } = lengths;
    [
        ("tailplanes", behind, chord, &TAILPLANES),
        ("foreplanes", ahead, chord, &FOREPLANES),
        ("fins", upright, span, &FINS),
    ]
    .into_iter()
    .filter(|(_, volume, ..)| volume.area > LEAST_AREA * area)
    .filter_map(|(what, volume, length, usual)| unusual(what, volume.moment / (area * length), usual))
    .collect()
}

fn unusual(what: &str, volume: f64, usual: &RangeInclusive<f64>) -> Option<String> {
    (!usual.contains(&volume)).then(|| {
        format!(
            "the volume coefficient of the {what} is {}, usual is {}: area by lever about the centre of mass, of the wing's area and {}",
            short(volume),
            range(usual, "").trim_end(),
            if what == "fins" { "span" } else { "chord" }
        )
    })
}

/// Whether a component is the wing, or goes on where the wing or its image ends, in the same direction.
pub(super) fn continues(aircraft: &Aircraft, component: usize, wing: usize) -> bool {
    if component == wing || aircraft.components[wing].image == Some(component) {
        return true;
    }
    let Some((parent, _)) = aircraft.components[component].parent else { return false };
    let (Some(own), Some(other)) =
        (strips(aircraft, component).first().copied(), strips(aircraft, parent).last().copied())
    else {
        return false;
    };
    normal(own).dot(&normal(other)).abs() > SAME_SURFACE && continues(aircraft, parent, wing)
}

/// x of the quarter chord, m.
fn aerodynamic_centre(aircraft: &Aircraft, strip: &Strip) -> f64 {
    let ahead = 0.5 * strip.semichord + strip.elastic_axis_aft_of_midchord;
    middle(aircraft, strip).x + strip.forward.x * ahead
}

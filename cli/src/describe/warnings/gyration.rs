//! Inertia against geometry: radii of gyration by the aircraft's size, and masses that lie far from what carries them.

use std::ops::RangeInclusive;

use flexible_aircraft::Aircraft;

use super::super::facts::Facts;
use super::{range, reach};
use crate::numbers::short;

/// Radii of gyration by half the size across their axis: 0.22 to 0.52 of usual aircraft (Raymer, Aircraft Design, table 16.1), 0.58 where all
/// mass is spread along the wing.
const RADII: RangeInclusive<f64> = 0.08..=0.8;

/// What is unusual about the inertia of an aircraft that flies, and where its masses are.
pub fn inertia(aircraft: &Aircraft, facts: &Facts) -> Vec<String> {
    let [low, high] = reach(aircraft);
    let size = high - low;
    let axes = [("roll", 0, size.y), ("pitch", 1, size.x), ("yaw", 2, 0.5 * (size.x + size.y))];
    let radii = axes.into_iter().filter_map(|(axis, index, size)| {
        let radius = (facts.about_centre[(index, index)] / facts.mass).sqrt();
        let share = 2.0 * radius / size;
        (!RADII.contains(&share)).then(|| {
            format!(
                "the radius of gyration in {axis} is {} m, {} of half the size of {} m, usual is {}: are inertias in kg m²?",
                short(radius),
                short(share),
                short(size),
                range(&RADII, "").trim_end()
            )
        })
    });
    radii.chain(far_masses(aircraft, size.amax())).collect()
}

/// A mass further from its beam than half the aircraft's size: the first of each component.
fn far_masses(aircraft: &Aircraft, size: f64) -> Vec<String> {
    let far = |component: usize| {
        let carried = aircraft
            .bays
            .iter()
            .filter(|bay| bay.mass > 0.0 && aircraft.component_of(bay.attachment.beam) == Some(component));
        carried.into_iter().find(|bay| bay.offset.norm() > 0.5 * size).map(|bay| {
            format!(
                "{}: {} kg lie {} m from the beam that carries them, usual is less than half the aircraft's size, {} m",
                aircraft.components[component].name,
                short(bay.mass),
                short(bay.offset.norm()),
                short(0.5 * size)
            )
        })
    };
    (0..aircraft.components.len()).filter_map(far).collect()
}

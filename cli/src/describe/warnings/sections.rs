//! Moments of sections that are no aerofoil's.

use flexible_aircraft::Aircraft;

use super::super::surfaces::strips;
use crate::numbers::short;

/// Of c_mα by C_Lα: the aerodynamic centre that far from the quarter chord is at the leading edge or in mid-chord, where that of supersonic flow is.
const FARTHEST_CENTRE: f64 = 0.25;

/// What is unusual about the moments of a component's sections.
pub fn moments(aircraft: &Aircraft, component: usize) -> Vec<String> {
    let name = &aircraft.components[component].name;
    let strips = strips(aircraft, component);
    let far = strips.iter().find(|strip| strip.moment_slope.abs() > FARTHEST_CENTRE * strip.lift_slope.abs());
    let far = far.map(|strip| {
        format!(
            "{name}: moment_slope is {} beside a lift slope of {} per rad, usual is up to {FARTHEST_CENTRE} of it: the aerodynamic centre is that far, \
             by the chord, from the quarter chord",
            short(strip.moment_slope),
            short(strip.lift_slope)
        )
    });
    let slopes = strips.iter().filter_map(|strip| strip.flap.as_ref()?.moment_slope);
    let upward = slopes.into_iter().find(|slope| *slope > 0.0).map(|slope| {
        format!(
            "{name}: moment_slope of its flap is {} per rad, usual is below 0: a flap that goes down turns the nose down about the quarter chord",
            short(slope)
        )
    });
    far.into_iter().chain(upward).collect()
}

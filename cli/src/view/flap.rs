//! Flaps as they are drawn: hinge, axis, and which controls turn them.

use flexible_aircraft::Aircraft;
use nalgebra::Vector3;

use super::outline::Outline;

/// A flap that some control moves. A positive angle moves the trailing edge towards n = f × s, so that it turns about s
/// [theory: air-loads.flap].
#[derive(Clone, Debug, PartialEq)]
pub struct Flap {
    /// Inboard and outboard, from where the elastic axis passes through the strip.
    pub hinge: [Vector3<f64>; 2],
    /// About which it turns.
    pub axis: Vector3<f64>,
    /// Controls, and its angle per angle of each.
    pub gains: Vec<(usize, f64)>,
}

impl Flap {
    /// That of a strip with an outline, if it has one.
    pub fn of(aircraft: &Aircraft, number: usize, outline: &Outline) -> Option<Self> {
        let strip = &aircraft.strips[number];
        let flap = strip.flap.as_ref().filter(|flap| flap.is_moved())?;
        let hinge = outline.along_chord(flap.hinge);
        let along = (hinge[1] - hinge[0]).normalize();
        let axis = if along.dot(&strip.span) < 0.0 { -along } else { along };
        let gains = flap.gains.iter().copied().enumerate().filter(|(_, gain)| *gain != 0.0).collect();
        Some(Flap { hinge, axis, gains })
    }

    /// How far it is turned at some angles of all controls, rad.
    pub fn angle(&self, controls: &[f64]) -> f64 {
        self.gains.iter().map(|&(control, gain)| gain * controls[control]).sum()
    }
}

//! Stiffnesses of thin-walled sections, and of cantilevers that are to have a frequency.

use std::f64::consts::TAU;

use super::design::Beam;

/// What of the mass along a uniform cantilever moves as at its tip [Blevins, Formulas for Natural Frequency and Mode
/// Shape, table 8-8: 33/140].
const MOVED: f64 = 33.0 / 140.0;

/// EI of a cantilever with a frequency, Hz, with masses along it and at its tip, kg, and a length, m [Blevins, table 8-8].
pub fn cantilever(frequency: f64, [along, at_tip]: [f64; 2], length: f64) -> f64 {
    let mass = at_tip + MOVED * along;
    (TAU * frequency).powi(2) * mass * length.powi(3) / 3.0
}

/// A flat box between spars at 0.15 and 0.60 of a chord, 0.11 chords high, with walls of one thickness w: EI_y is E w c³ times
/// 0.45 · 0.11²/2, EI_z by that (0.45/0.11)²/3 + 0.45/0.11, EA 4/(0.11 c)²; GJ 4 G/E · 0.45/0.56, 1.2 of aluminium and 1 here.
pub fn box_beam(comment: String, bending: f64, root_chord: f64) -> Beam {
    let axial = 4.0 * bending / (0.11 * root_chord).powi(2);
    Beam { comment, bending, chord_power: Some(3.0), torsion: 1.0, in_surface: 10.0, axial }
}

/// A round tube with a radius, m: EA is 2/r² of EI, GJ 2 G/E, of aluminium 0.77.
pub fn tube(comment: String, bending: f64, radius: f64) -> Beam {
    let axial = 2.0 * bending / (radius * radius);
    Beam { comment, bending, chord_power: None, torsion: 0.77, in_surface: 1.0, axial }
}

//! Wings, tails and fins of straight taper, and what lifting surfaces of their shape do.

use std::f64::consts::PI;

/// One side of a wing or a tail, or a fin.
#[derive(Clone, Copy, Debug)]
pub struct Planform {
    /// From root to tip across x, m.
    pub length: f64,
    /// m.
    pub root_chord: f64,
    /// m.
    pub tip_chord: f64,
    /// Of the quarter-chord line, rad.
    pub sweep: f64,
    /// From y to −z, rad: 0 of a level wing, π/2 of a fin.
    pub dihedral: f64,
    /// Of the surface of which this is a side, or of the fin with what mirrors it: b²/S.
    pub aspect_ratio: f64,
}

/// Induced drag above that of an elliptic lift, e [Raymer §12.6.1: 0.7 to 0.85; more of a taper near 0.4 without a body].
const OSWALD: f64 = 0.85;

/// Of a flap's lift by that of thin-aerofoil theory, for the boundary layer at its hinge [Raymer figure 16.6, up to 20°].
const FLAP_LOSS: f64 = 0.8;

/// Profile drag of sections with a smooth surface, by their own area [Abbott and von Doenhoff: 0.006 to 0.010].
pub const SECTION_DRAG: f64 = 0.009;

impl Planform {
    /// A pair of tails, or a fin that stands on a body, of an area (both sides, m²).
    pub fn of_area(area: f64, aspect_ratio: f64, taper: f64, sides: f64) -> Self {
        let span = (aspect_ratio * area).sqrt();
        let root_chord = 2.0 * area / (span * (1.0 + taper));
        Planform {
            length: span / sides,
            root_chord,
            tip_chord: taper * root_chord,
            sweep: 0.0,
            dihedral: 0.0,
            aspect_ratio,
        }
    }

    /// m².
    pub fn area(&self) -> f64 {
        0.5 * self.length * (self.root_chord + self.tip_chord)
    }

    pub fn taper(&self) -> f64 {
        self.tip_chord / self.root_chord
    }

    /// At a fraction of the length, m.
    pub fn chord(&self, fraction: f64) -> f64 {
        self.root_chord + fraction * (self.tip_chord - self.root_chord)
    }

    /// Mean aerodynamic chord, m.
    pub fn mean_chord(&self) -> f64 {
        let taper = self.taper();
        2.0 / 3.0 * self.root_chord * (1.0 + taper + taper * taper) / (1.0 + taper)
    }

    /// Where that chord is, as a fraction of the length.
    pub fn mean_place(&self) -> f64 {
        let taper = self.taper();
        (1.0 + 2.0 * taper) / (3.0 * (1.0 + taper))
    }

    /// How far the quarter point of the mean aerodynamic chord lies behind that of the root, m.
    pub fn setback(&self) -> f64 {
        self.mean_place() * self.length * self.sweep.tan()
    }

    /// The tip from the root along an elastic axis at a fraction of the chord, m, body axes.
    pub fn tip(&self, elastic_axis: f64) -> [f64; 3] {
        let aft = self.length * self.sweep.tan() - (elastic_axis - 0.25) * (self.root_chord - self.tip_chord);
        [-aft, self.length * self.dihedral.cos(), -self.length * self.dihedral.sin()]
    }

    /// Along the elastic axis, m.
    pub fn axis_length(&self, elastic_axis: f64) -> f64 {
        self.tip(elastic_axis).iter().map(|along| along * along).sum::<f64>().sqrt()
    }

    /// C_Lα of the finite surface, 1/rad [Raymer eq. 12.6, DATCOM, at Mach 0 with thin sections].
    pub fn lift_slope(&self) -> f64 {
        let (ratio, tan) = (self.aspect_ratio, self.sweep.tan());
        2.0 * PI * ratio / (2.0 + (4.0 + ratio * ratio * (1.0 + tan * tan)).sqrt())
    }

    /// The share of leading-edge suction that leaves the induced drag of C_L²/(π A e) to strips with a lift slope, 1/rad
    /// [theory: air-loads.drag].
    pub fn suction(&self, lift_slope: f64) -> f64 {
        1.0 - lift_slope / (PI * self.aspect_ratio * OSWALD)
    }

    /// C_Lδ of a plain flap before thin-aerofoil theory's factor for its chord, 1/rad.
    pub fn flap_slope(&self) -> f64 {
        FLAP_LOSS * self.lift_slope()
    }

    /// How fast a tail behind the surface turns against the air as both turn up, 1 − dε/dα, for the air goes down there
    /// [far behind an elliptic lift: dε/dα = 2 C_Lα/(π A)].
    pub fn kept_behind(&self) -> f64 {
        1.0 - 2.0 * self.lift_slope() / (PI * self.aspect_ratio)
    }
}

/// Of thin-aerofoil theory: what of a turn of the chord does a turn of the flap behind a hinge [theory: air-loads.flap].
pub fn flap_share(hinge: f64) -> f64 {
    let angle = (2.0 * hinge - 1.0).acos();
    (angle + angle.sin()) / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_has_the_area_and_aspect_ratio_that_were_asked_for() {
        let tail = Planform::of_area(2.0, 4.0, 0.6, 2.0);
        assert!((2.0 * tail.area() - 2.0).abs() < 1e-12);
        assert!((2.0 * tail.length * 2.0 * tail.length / 2.0 - 4.0).abs() < 1e-12);
        assert!((tail.taper() - 0.6).abs() < 1e-12);
    }

    #[test]
    fn slender_surfaces_lift_as_thin_aerofoils_and_elliptic_ones_nearly_as_lifting_lines() {
        let of = |aspect_ratio: f64| Planform::of_area(1.0, aspect_ratio, 0.5, 2.0).lift_slope();
        assert!((of(1e6) / (2.0 * PI) - 1.0).abs() < 1e-5);
        assert!((of(8.0) / (2.0 * PI * 8.0 / 10.0) - 1.0).abs() < 0.03);
        assert!((flap_share(1e-12) - 1.0).abs() < 1e-5);
    }
}

//! Trailing-edge flap by thin-aerofoil theory.
//!
//! [theory: air-loads.flap, corrections.flap-lift, corrections.flap-moment; thesis §4.1]

use super::Flap;

/// What a flap does to its section, per radian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlapEffect {
    /// CLδ c1: lift is ρ b U² times this.
    pub lift: f64,
    /// CLδ c4, or 2 c_mδ: nose-up moment about the elastic axis is ρ b² U² times this, besides the arm of the lift.
    pub moment: f64,
}

impl FlapEffect {
    /// The effect of a flap: cos φ_m = 2·hinge − 1, c1 = (φ_m + sin φ_m)/π, c4 = −sin φ_m (1 + cos φ_m)/2π; where its own moment is
    /// given, that.
    ///
    /// [theory: air-loads.flap]
    pub fn new(flap: &Flap) -> Self {
        let cos_hinge = 2.0 * flap.hinge - 1.0;
        let hinge = libm::acos(cos_hinge);
        let sin_hinge = libm::sin(hinge);
        let pi = std::f64::consts::PI;
        FlapEffect {
            lift: flap.lift_slope * (hinge + sin_hinge) / pi,
            moment: match flap.moment_slope {
                Some(slope) => 2.0 * slope,
                None => -flap.lift_slope * sin_hinge * (1.0 + cos_hinge) / (2.0 * pi),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flap(hinge: f64) -> Flap {
        let lift_slope = std::f64::consts::TAU;
        Flap { lift_slope, hinge, moment_slope: None, drag: 0.0, gains: Vec::new() }
    }

    #[test]
    fn a_flap_hinged_at_the_leading_edge_is_an_angle_of_attack() {
        let effect = FlapEffect::new(&flap(1e-12));
        assert!((effect.lift - std::f64::consts::TAU).abs() < 1e-5);
        assert!(effect.moment.abs() < 1e-5);
    }

    #[test]
    fn a_flap_at_mid_chord_has_the_lift_of_thin_aerofoil_theory() {
        // Glauert: τ = 1 − (θ_h − sin θ_h)/π with θ_h measured from the leading edge; at mid-chord
        // τ = 1/2 + 1/π, and c_m(c/4) = −½ sin θ_h (1 − cos θ_h) per radian = −1/2.
        let effect = FlapEffect::new(&flap(0.5));
        assert!((effect.lift / std::f64::consts::TAU - (0.5 + std::f64::consts::FRAC_1_PI)).abs() < 1e-15);
        // Moment = ρ b² U² · moment = ½ρU²(2b)² · c_m, so c_m = moment / 2.
        assert!((effect.moment / 2.0 + 0.5).abs() < 1e-15);
    }

    #[test]
    fn a_moment_of_its_own_takes_the_place_of_the_theorys_and_leaves_the_lift() {
        // ½ρU²(2b)² c_mδ is 2 c_mδ ρ b² U².
        let given = FlapEffect::new(&Flap { moment_slope: Some(-0.4), ..flap(0.5) });
        assert_eq!(given, FlapEffect { moment: -0.8, ..FlapEffect::new(&flap(0.5)) });
    }
}

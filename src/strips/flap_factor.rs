//! What the loads of flaps are proportional to [theory: air-loads.flap-products; thesis §4.1].

use std::collections::BTreeSet;

use crate::aircraft::Flap;

/// What the loads of flaps are proportional to: the angle of a control, or the product of two.
///
/// [theory: air-loads.flap-products]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum FlapFactor {
    Angle(usize),
    Product([usize; 2]),
}

impl FlapFactor {
    /// Those of some flaps, each with whether it drags: angles first, then products, of which only flaps that drag have any.
    pub(crate) fn of_flaps<'a>(flaps: impl Iterator<Item = (&'a Flap, bool)>) -> Vec<Self> {
        let mut factors = BTreeSet::new();
        for (flap, drags) in flaps {
            let moving = (0..flap.gains.len()).filter(|&control| flap.gains[control] != 0.0);
            let moving: Vec<usize> = moving.collect();
            factors.extend(moving.iter().map(|&control| FlapFactor::Angle(control)));
            if drags {
                let pairs =
                    moving.iter().enumerate().flat_map(|(i, &j)| moving[i..].iter().map(move |&k| [j, k]));
                factors.extend(pairs.map(FlapFactor::Product));
            }
        }
        factors.into_iter().collect()
    }

    /// Under given angles of the controls, rad or rad².
    pub(crate) fn value(self, angles: &[f64]) -> f64 {
        match self {
            FlapFactor::Angle(control) => angles[control],
            FlapFactor::Product([j, k]) => angles[j] * angles[k],
        }
    }

    /// Its coefficient in the angle δ, or in δ², of a flap that the controls turn with given gains.
    pub(crate) fn coefficient(self, gains: &[f64]) -> f64 {
        match self {
            FlapFactor::Angle(control) => gains[control],
            FlapFactor::Product([j, k]) if j == k => gains[j] * gains[j],
            FlapFactor::Product([j, k]) => 2.0 * gains[j] * gains[k],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_gains(gains: &[f64]) -> Flap {
        Flap { lift_slope: 3.0, hinge: 0.7, moment_slope: None, drag: 0.0, gains: gains.to_vec() }
    }

    #[test]
    fn only_controls_that_share_a_flap_that_drags_have_a_product() {
        let flap = |gains: [f64; 4]| of_gains(&gains);
        let [one, two, three] =
            [flap([0.0, 1.0, -1.0, 0.0]), flap([0.0, 0.0, 0.5, 0.0]), flap([2.0, 0.0, 1.0, 0.0])];
        let factors = FlapFactor::of_flaps([(&one, true), (&two, true), (&three, false)].into_iter());
        let [angles, products] =
            [[0, 1, 2].map(FlapFactor::Angle), [[1, 1], [1, 2], [2, 2]].map(FlapFactor::Product)];
        assert_eq!(factors, [angles, products].concat());
    }

    #[test]
    fn factors_and_coefficients_make_the_angle_of_a_flap_and_its_square() {
        let (gains, angles) = ([0.5, -1.0, 2.0], [0.1, 0.2, -0.3]);
        let flap = of_gains(&gains);
        let factors = FlapFactor::of_flaps([(&flap, true)].into_iter());
        let sum = |is_angle: bool| -> f64 {
            let kept = factors.iter().filter(|factor| matches!(factor, FlapFactor::Angle(_)) == is_angle);
            kept.map(|factor| factor.value(&angles) * factor.coefficient(&gains)).sum()
        };
        let delta = 0.5 * 0.1 - 0.2 - 2.0 * 0.3;
        assert!((sum(true) - delta).abs() < 1e-15);
        assert!((sum(false) - delta * delta).abs() < 1e-15);
    }
}

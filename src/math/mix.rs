//! Numbers that look random and are functions of their place alone: SplitMix64 [theory: gusts.realisation].

use std::f64::consts::TAU;

/// What SplitMix64 adds before it mixes.
pub const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// 64 bits that look random, of a place.
pub fn mix(place: u64) -> u64 {
    let mut bits = place.wrapping_add(GOLDEN);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

/// From 0 to below 1 in steps of 2⁻⁵³, of a place.
pub fn unit_number(place: u64) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
    (mix(place) >> 11) as f64 * STEP
}

/// Normally distributed with mean 0 and variance 1, of a place and the next (G. E. P. Box, M. E. Muller).
pub fn normal_number(place: u64) -> f64 {
    // Never 0, of which there is no logarithm.
    let radius = unit_number(place) + 0.5 * f64::EPSILON;
    let turn = unit_number(place.wrapping_add(1));
    libm::sqrt(-2.0 * libm::log(radius)) * libm::cos(TAU * turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_numbers_are_those_of_the_published_generator() {
        // Of the seed 1234567, from the reference implementation's test vector (S. Vigna, splitmix64.c, as Rosetta Code prints it).
        let numbers: Vec<u64> =
            (0..3_u64).map(|n| mix(1_234_567_u64.wrapping_add(n.wrapping_mul(GOLDEN)))).collect();
        assert_eq!(
            numbers,
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]
        );
        assert_eq!(mix(0), 0xe220_a839_7b1d_cdaf);
        assert!((0..1000).map(unit_number).all(|number| (0.0..1.0).contains(&number)));
    }
}

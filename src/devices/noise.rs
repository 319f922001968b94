//! Noise that has no memory: the number of a channel's sample decides it [theory: sensors.noise].

use crate::math::{GOLDEN, normal_number};

/// Normally distributed numbers of one channel, of mean 0 and variance 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    base: u64,
}

impl Noise {
    /// Of the channel with a name, under a seed.
    pub fn new(seed: u64, name: &str) -> Self {
        Noise { base: seed.wrapping_mul(GOLDEN).wrapping_add(fnv(name.as_bytes())) }
    }

    /// The number of a sample, counted from 0.
    pub fn number(self, sample: u64) -> f64 {
        normal_number(self.base.wrapping_add(sample.wrapping_mul(2)))
    }
}

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo).
fn fnv(bytes: &[u8]) -> u64 {
    let mixed = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01B3);
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, mixed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_and_name_and_number_make_the_noise() {
        // Of a program of its own that shares nothing with this one.
        let found = [0, 1, 2].map(|sample| Noise::new(1, "sensor.rate.y").number(sample));
        for (found, expected) in found.iter().zip([1.768_671_3, -0.041_571_1, 0.461_534_9]) {
            assert!((found - expected).abs() < 6e-8, "{found} {expected}");
        }
    }

    #[test]
    fn the_hash_is_the_published_one() {
        // Landon Curt Noll's test vectors.
        assert_eq!(fnv(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn many_numbers_have_mean_0_and_variance_1() {
        let (noise, count) = (Noise::new(7, "sensor.air.speed"), 100_000);
        let numbers = || (0..count).map(|sample| noise.number(sample));
        let mean = numbers().sum::<f64>() / count as f64;
        let variance = numbers().map(|x| x * x).sum::<f64>() / count as f64;
        // Of so many numbers they depart by 0.003 and 0.0045.
        assert!(mean.abs() < 0.015 && (variance - 1.0).abs() < 0.02, "{mean} {variance}");
    }
}

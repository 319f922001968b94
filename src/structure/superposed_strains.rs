//! The strain energy where strains superpose, however far they bend the structure.
//!
//! [theory: equations-of-motion.levels, strain-energy.energy]

use super::StrainEnergy;

impl StrainEnergy {
    /// ½ Σ ω_a² q_a²: of strains that are sums of those of modes with these frequencies (rad/s), which are orthogonal.
    pub fn of_superposed_strains(frequencies: impl ExactSizeIterator<Item = f64>) -> Self {
        let mut energy = StrainEnergy::zero(frequencies.len());
        let diagonal = energy.linear_stiffness.iter_mut().step_by(frequencies.len() + 1);
        for (stiffness, frequency) in diagonal.zip(frequencies) {
            *stiffness = frequency * frequency;
        }
        energy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_coordinate_is_held_by_its_own_frequency_alone() {
        let energy = StrainEnergy::of_superposed_strains([3.0, 5.0, 0.5].into_iter());
        let mut force = [0.0; 3];
        let value = energy.add_quadratic(&[2.0, -1.0, 4.0], &mut force);
        assert_eq!((value, force), (0.5 * (36.0 + 25.0 + 4.0), [18.0, -25.0, 1.0]));
        assert!(energy.cubic_terms().all(|(_, coefficient)| coefficient == 0.0));
        assert!(energy.quartic_terms().all(|(_, coefficient)| coefficient == 0.0));
        assert!(
            energy.is_consistent(3) && StrainEnergy::of_superposed_strains([].into_iter()).is_consistent(0)
        );
    }
}

//! The strain energy where strains superpose, however far they bend the structure.
//!
//! [theory: equations-of-motion.levels, strain-energy.energy]

use super::StrainEnergy;

impl StrainEnergy {
    /// ½ Σ ω_a² q_a²: of strains that are sums of those of modes with these frequencies (rad/s), which are orthogonal.
    pub fn of_superposed_strains(frequencies: impl ExactSizeIterator<Item = f64>) -> Self {
        let modes = frequencies.len();
        let mut linear_stiffness = vec![0.0; modes * modes];
        let diagonal = linear_stiffness.iter_mut().step_by(modes + 1);
        for (stiffness, frequency) in diagonal.zip(frequencies) {
            *stiffness = frequency * frequency;
        }
        StrainEnergy::quadratic(linear_stiffness, modes)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    #[test]
    fn each_coordinate_is_held_by_its_own_frequency_alone() {
        let energy = StrainEnergy::of_superposed_strains([3.0, 5.0, 0.5].into_iter());
        let mut force = [0.0; 3];
        let value = energy.add_quadratic(&[2.0, -1.0, 4.0], &mut force);
        assert_eq!((value, force), (0.5 * (36.0 + 25.0 + 4.0), [18.0, -25.0, 1.0]));
        // Neither room nor work for terms of higher order.
        assert_eq!((energy.cubic_terms().count(), energy.quartic_terms().count()), (0, 0));
        let q = [2.0, -1.0, 4.0];
        assert_eq!([energy.add_cubic(&q, &mut force), energy.add_quartic(&q, &mut force)], [0.0; 2]);
        assert_eq!(force, [18.0, -25.0, 1.0]);
        let chosen = energy.select(&[0, 2]);
        assert_eq!(chosen, StrainEnergy::of_superposed_strains([3.0, 0.5].into_iter()));
        let swapped = DMatrix::from_row_slice(3, 2, &[0.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
        assert_eq!(energy.combine(&swapped), StrainEnergy::of_superposed_strains([0.5, 3.0].into_iter()));
    }
}

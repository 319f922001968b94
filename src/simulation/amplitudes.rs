//! The structure's coordinates as amplitudes of its free modes, in which they swing one by one.
//!
//! With q = Qz, each mode's z̈ = −ω²z − 2ζωż + … becomes ċ = λc + … for the complex amplitude
//! c = ż − λ̄z with λ = −ζω + iω√(1 − ζ²): the form in which the exponential integrator takes it. The real part
//! stands in the place of q̇, the imaginary part in that of q.

use std::ops::Range;

use nalgebra::DMatrix;

use crate::dynamics::{FreeModes, StateLayout};

/// The transformation between coordinates and amplitudes.
#[derive(Clone, Debug)]
pub struct Amplitudes {
    coordinates: Range<usize>,
    rates: Range<usize>,
    /// `None` where there is nothing to transform.
    modes: Option<FreeModes>,
    scratch: [Vec<f64>; 2],
}

impl Amplitudes {
    /// For states of a layout.
    pub fn new(layout: &StateLayout, modes: Option<FreeModes>) -> Self {
        let zeros = || vec![0.0; layout.modes()];
        Amplitudes {
            coordinates: layout.coordinates(),
            rates: layout.coordinate_rates(),
            modes,
            scratch: [zeros(), zeros()],
        }
    }

    /// Replaces coordinates and their rates by amplitudes, in a state or in a rate of change of one.
    pub fn enter(&mut self, state: &mut [f64]) {
        let Some(modes) = &self.modes else { return };
        let [z, z_dot] = &mut self.scratch;
        multiply(&modes.inverse, &state[self.coordinates.clone()], z);
        multiply(&modes.inverse, &state[self.rates.clone()], z_dot);
        for mode in 0..z.len() {
            state[self.coordinates.start + mode] = modes.frequency[mode] * z[mode];
            state[self.rates.start + mode] = z_dot[mode] + modes.decay[mode] * z[mode];
        }
    }

    /// Replaces amplitudes by coordinates and their rates.
    pub fn leave(&mut self, state: &mut [f64]) {
        let Some(modes) = &self.modes else { return };
        let [z, z_dot] = &mut self.scratch;
        for mode in 0..z.len() {
            z[mode] = state[self.coordinates.start + mode] / modes.frequency[mode];
            z_dot[mode] = state[self.rates.start + mode] - modes.decay[mode] * z[mode];
        }
        multiply(&modes.shapes, z, &mut state[self.coordinates.clone()]);
        multiply(&modes.shapes, z_dot, &mut state[self.rates.clone()]);
    }

    /// Writes λ of every mode into the linear part, a vector of the state's layout.
    pub fn write_linear_part(&self, linear: &mut [f64]) {
        let Some(modes) = &self.modes else { return };
        linear[self.coordinates.clone()].copy_from_slice(&modes.frequency);
        for (linear, decay) in linear[self.rates.clone()].iter_mut().zip(&modes.decay) {
            *linear = -decay;
        }
    }
}

/// product = matrix · vector, column by column.
fn multiply(matrix: &DMatrix<f64>, vector: &[f64], product: &mut [f64]) {
    product.fill(0.0);
    for (column, &factor) in matrix.as_slice().chunks_exact(product.len().max(1)).zip(vector) {
        for (sum, entry) in product.iter_mut().zip(column) {
            *sum += entry * factor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_come_back_from_their_amplitudes_which_turn_and_decay() {
        let layout = StateLayout::new(2, 0, 0, 0);
        let shapes = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, -1.0, 3.0]);
        let inverse = shapes.clone().try_inverse().unwrap();
        let modes =
            FreeModes { shapes: shapes.clone(), inverse, decay: vec![0.5, 3.0], frequency: vec![7.0, 20.0] };
        let mut amplitudes = Amplitudes::new(&layout, Some(modes.clone()));
        let mut state: Vec<f64> = (0..layout.len()).map(|i| libm::sin(i as f64)).collect();
        let before = state.clone();

        // q̈ of the linear oscillators at this state.
        let [q, q_dot] = [layout.coordinates(), layout.coordinate_rates()]
            .map(|range| nalgebra::DVector::from_column_slice(&before[range]));
        let (z, z_dot) = (&modes.inverse * &q, &modes.inverse * &q_dot);
        let z_ddot = nalgebra::DVector::from_fn(2, |k, _| {
            let (decay, frequency) = (modes.decay[k], modes.frequency[k]);
            -(decay * decay + frequency * frequency) * z[k] - 2.0 * decay * z_dot[k]
        });
        let mut rate = vec![0.0; layout.len()];
        rate[layout.coordinates()].copy_from_slice(q_dot.as_slice());
        rate[layout.coordinate_rates()].copy_from_slice((&shapes * z_ddot).as_slice());

        let mut linear = vec![0.0; layout.len()];
        amplitudes.write_linear_part(&mut linear);
        amplitudes.enter(&mut state);
        amplitudes.enter(&mut rate);
        for mode in 0..2 {
            let (im, re) = (layout.coordinates().start + mode, layout.coordinate_rates().start + mode);
            let turned = [
                linear[re] * state[re] - linear[im] * state[im],
                linear[im] * state[re] + linear[re] * state[im],
            ];
            assert!((rate[re] - turned[0]).abs() < 1e-12 && (rate[im] - turned[1]).abs() < 1e-12);
        }
        amplitudes.leave(&mut state);
        assert!(state.iter().zip(&before).all(|(after, before)| (after - before).abs() < 1e-14));
    }
}

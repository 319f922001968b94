//! The structure's coordinates as amplitudes of its free modes, in which they swing one by one.
//!
//! [theory: integration.amplitudes]
//!
//! With q = Qz, each mode's z̈ = −ω²z − 2ζωż + … becomes ċ = λc + … for the complex amplitude
//! c = ż − λ̄z with λ = −ζω + iω√(1 − ζ²): the form in which the exponential integrator takes it. The real part
//! stands in the place of q̇, the imaginary part in that of q.

use std::ops::Range;

use nalgebra::DMatrix;
use pulp::{Arch, Simd, WithSimd};

use crate::equations::StateLayout;
use crate::math::{AlignedNumbers, Columns, zeros};

use super::free_modes::FreeModes;

/// The transformation between coordinates and amplitudes.
#[derive(Clone, Debug)]
pub struct Amplitudes {
    coordinates: Range<usize>,
    rates: Range<usize>,
    /// `None` where there is nothing to transform.
    modes: Option<Modes>,
    arch: Arch,
}

/// What turns [q; q̇] into amplitudes, their imaginary parts first, and back.
#[derive(Clone, Debug)]
struct Modes {
    free: FreeModes,
    enter: Columns,
    leave: Columns,
    scratch: AlignedNumbers,
}

impl Amplitudes {
    /// For states of a layout.
    pub fn new(layout: &StateLayout, modes: Option<FreeModes>) -> Self {
        let (coordinates, rates) = (layout.coordinates(), layout.coordinate_rates());
        Amplitudes { coordinates, rates, modes: modes.map(Modes::new), arch: Arch::new() }
    }

    /// q and q̇, or their amplitudes, in a state.
    pub fn range(&self) -> Range<usize> {
        self.coordinates.start..self.rates.end
    }

    /// Replaces coordinates and their rates by amplitudes, in a state or in a rate of change of one.
    pub fn enter(&mut self, state: &mut [f64]) {
        let (range, arch) = (self.range(), self.arch);
        if let Some(Modes { enter, scratch, .. }) = &mut self.modes {
            arch.dispatch(Transform { matrix: enter, numbers: &mut state[range], scratch });
        }
    }

    /// Replaces amplitudes by coordinates and their rates.
    pub fn leave(&mut self, state: &mut [f64]) {
        let (range, arch) = (self.range(), self.arch);
        if let Some(Modes { leave, scratch, .. }) = &mut self.modes {
            arch.dispatch(Transform { matrix: leave, numbers: &mut state[range], scratch });
        }
    }

    /// Writes λ of every mode into the linear part, a vector of the state's layout.
    pub fn write_linear_part(&self, linear: &mut [f64]) {
        let Some(modes) = &self.modes else { return };
        linear[self.coordinates.clone()].copy_from_slice(&modes.free.frequency);
        for (linear, decay) in linear[self.rates.clone()].iter_mut().zip(&modes.free.decay) {
            *linear = -decay;
        }
    }
}

impl Modes {
    fn new(free: FreeModes) -> Self {
        let n = free.decay.len();
        let FreeModes { shapes, inverse, decay, frequency } = &free;
        let blocks = |of_q: [&dyn Fn(usize, usize) -> f64; 2], of_rates: &DMatrix<f64>| {
            Columns::new(2 * n, 2 * n, |row, column| match (row < n, column < n) {
                (true, true) => of_q[0](row, column),
                (true, false) => 0.0,
                (false, true) => of_q[1](row - n, column),
                (false, false) => of_rates[(row - n, column - n)],
            })
        };
        // c = ż + ζωz + i ω√(1 − ζ²) z with z = Q⁻¹q.
        let enter = blocks(
            [&|mode, q| frequency[mode] * inverse[(mode, q)], &|mode, q| decay[mode] * inverse[(mode, q)]],
            inverse,
        );
        let leave = blocks(
            [&|q, mode| shapes[(q, mode)] / frequency[mode], &|q, mode| {
                -shapes[(q, mode)] * decay[mode] / frequency[mode]
            }],
            shapes,
        );
        let scratch = zeros(enter.room());
        Modes { enter, leave, scratch, free }
    }
}

/// numbers = matrix · numbers.
struct Transform<'a> {
    matrix: &'a Columns,
    numbers: &'a mut [f64],
    scratch: &'a mut [f64],
}

impl WithSimd for Transform<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Transform { matrix, numbers, scratch } = self;
        matrix.times(simd, numbers, scratch);
        numbers.copy_from_slice(&scratch[..numbers.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strips::InflowLayout;

    #[test]
    fn coordinates_come_back_from_their_amplitudes_which_turn_and_decay() {
        let layout = StateLayout::new(2, InflowLayout::new(0, 0, 0));
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

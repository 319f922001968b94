//! A stable system in which what matters least to its response is left out [theory: linearisation.balanced].

use nalgebra::{DMatrix, SVD};

use super::gramians;
use super::schur::Block;
use super::system::System;

/// Hankel singular values below this part of the largest are rounding.
const LEAST: f64 = 1e-12;

/// Accuracy of singular values, and cap on the iterations.
const ACCURACY: f64 = 1e-15;
const MAX_ITERATIONS: usize = 100_000;

/// A stable system in balanced coordinates, in which every state is moved by inputs as much as outputs show it.
pub struct Balance {
    /// Hankel singular values, largest first, that are more than rounding.
    pub hankel: Vec<f64>,
    /// The columns that are coordinates' directions, x ≈ T z.
    directions: DMatrix<f64>,
    /// z = Wᵀ x.
    measures: DMatrix<f64>,
}

impl Balance {
    /// Of a system whose A is as in a Schur form with these blocks; none where it has no Gramians or their singular values are
    /// not found.
    pub fn of(blocks: &[Block], System([t, b, c]): &System) -> Option<Self> {
        let moved = gramians::factor(&gramians::of_inputs(t, blocks, b)?);
        let shown = gramians::factor(&gramians::of_outputs(t, blocks, c)?);
        if moved.ncols() == 0 || shown.ncols() == 0 {
            let nothing = DMatrix::zeros(t.nrows(), 0);
            return Some(Balance { hankel: Vec::new(), directions: nothing.clone(), measures: nothing });
        }
        let SVD { u, v_t, singular_values } =
            SVD::try_new(shown.transpose() * &moved, true, true, ACCURACY, MAX_ITERATIONS)?;
        let least = LEAST * singular_values[0];
        let hankel: Vec<f64> = singular_values.iter().copied().take_while(|value| *value > least).collect();
        let mut directions = moved * v_t?.rows(0, hankel.len()).transpose();
        let mut measures = shown * u?.columns(0, hankel.len());
        for matrix in [&mut directions, &mut measures] {
            for (mut column, value) in matrix.column_iter_mut().zip(&hankel) {
                column /= value.sqrt();
            }
        }
        Some(Balance { hankel, directions, measures })
    }

    /// The system, measured in whatever way, with so many states, no more than there are Hankel singular values.
    pub fn truncated(&self, System([a, b, c]): &System, states: usize) -> System {
        let directions = self.directions.columns(0, states);
        let measures = self.measures.columns(0, states).transpose();
        System([&measures * (a * directions), measures * b, c * directions])
    }

    /// What the response is wrong by at most when only so many states are left: twice the sum of the others' singular values.
    pub fn bound(&self, states: usize) -> f64 {
        2.0 * self.hankel[states..].iter().sum::<f64>()
    }
}

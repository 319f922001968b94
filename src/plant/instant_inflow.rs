//! The linearised motion with a wake that takes no time: at rest in its own coordinates while it still follows accelerations, or without
//! any inflow.
//!
//! [theory: linearisation.residualised, linearisation.static-margin]

use nalgebra::DMatrix;

use super::linearisation::{StateMatrix, Unknown};
use super::wake_blocks::WakeBlocks;

impl StateMatrix {
    /// How many of the unknowns are motion; the others, behind them, are the wake's.
    pub(crate) fn motion_count(&self) -> usize {
        let is_wake = |unknown: &Unknown| matches!(unknown, Unknown::Inflow { .. });
        self.unknowns.iter().position(is_wake).unwrap_or(self.unknowns.len())
    }

    /// The motion alone, with ẋ = (1 + B D⁻² C)⁻¹ (F − B D⁻¹ C) x; none where the wake finds no rest or then leaves no motion.
    pub(crate) fn with_instant_inflow(&self) -> Option<StateMatrix> {
        let Parts { motion, wake_on_motion, blocks, lag } = self.parts()?;
        let held = DMatrix::identity(motion.nrows(), motion.nrows()) + &wake_on_motion * blocks.divide(&lag);
        self.of_motion(held.lu().solve(&(motion - wake_on_motion * lag))?)
    }

    /// The motion alone without inflow, λ = 0, as after a long time in which nothing is accelerated: ẋ = (F − B D⁻¹ C) x; none where the
    /// wake finds no rest.
    pub(crate) fn without_inflow(&self) -> Option<StateMatrix> {
        let Parts { motion, wake_on_motion, lag, .. } = self.parts()?;
        self.of_motion(motion - wake_on_motion * lag)
    }

    fn parts(&self) -> Option<Parts> {
        let motion = self.motion_count();
        if motion == 0 {
            return None;
        }
        let wake = self.unknowns.len() - motion;
        let part = |from: (usize, usize), size: (usize, usize)| self.matrix.view(from, size).into_owned();
        let blocks = WakeBlocks::of(&part((motion, motion), (wake, wake)));
        let lag = blocks.divide(&part((motion, 0), (wake, motion)));
        let wake_on_motion = part((0, motion), (motion, wake));
        Some(Parts { motion: part((0, 0), (motion, motion)), wake_on_motion, blocks, lag })
    }

    fn of_motion(&self, matrix: DMatrix<f64>) -> Option<StateMatrix> {
        let unknowns = self.unknowns[..matrix.nrows()].to_vec();
        matrix.iter().all(|entry| entry.is_finite()).then_some(StateMatrix { unknowns, matrix })
    }
}

/// F, B, D and G = D⁻¹ C.
struct Parts {
    motion: DMatrix<f64>,
    wake_on_motion: DMatrix<f64>,
    blocks: WakeBlocks,
    lag: DMatrix<f64>,
}

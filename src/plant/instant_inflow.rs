//! The linearised motion with an inflow that follows at once: the wake has come to rest in its own coordinates, while it still
//! follows accelerations.
//!
//! [theory: linearisation.residualised]

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
        let StateMatrix { unknowns, matrix } = self;
        let motion = self.motion_count();
        let wake = unknowns.len() - motion;
        if motion == 0 {
            return None;
        }
        let part = |from: (usize, usize), size: (usize, usize)| matrix.view(from, size).into_owned();
        let wake_on_motion = part((0, motion), (motion, wake));
        let blocks = WakeBlocks::of(&part((motion, motion), (wake, wake)));
        let inflow = blocks.divide(&part((motion, 0), (wake, motion)));
        let held = DMatrix::identity(motion, motion) + &wake_on_motion * blocks.divide(&inflow);
        let quick = part((0, 0), (motion, motion)) - wake_on_motion * inflow;
        let matrix = held.lu().solve(&quick).filter(|matrix| matrix.iter().all(|entry| entry.is_finite()))?;
        Some(StateMatrix { unknowns: unknowns[..motion].to_vec(), matrix })
    }
}

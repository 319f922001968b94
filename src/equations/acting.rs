//! What can act on the aircraft of some equations.

use nalgebra::Vector3;

use crate::aircraft::Control;

use super::controls::Controls;
use super::of_motion::EquationsOfMotion;

impl EquationsOfMotion {
    /// What moves the flaps, in the order of [`Controls::angles`].
    pub fn controls(&self) -> &[Control] {
        &self.controls
    }

    /// In what proportion each engine has the thrust of trims.
    pub(crate) fn trim_shares(&self) -> &[f64] {
        self.engines.trim_shares()
    }

    /// Number of engines.
    pub fn engine_count(&self) -> usize {
        self.engines.len()
    }

    /// All controls neutral, no thrust, in still air.
    pub fn neutral_controls(&self) -> Controls {
        Controls {
            angles: vec![0.0; self.controls.len()],
            thrust: vec![0.0; self.engines.len()],
            wind: Vector3::zeros(),
            wind_rate: Vector3::zeros(),
            air_travel: Vector3::zeros(),
        }
    }
}

//! The air around the aircraft: the standard atmosphere, or that of a wind tunnel, which may stand still.

use crate::aerodynamics::Air;
use crate::aircraft::Support;

use super::controls::Controls;
use super::equations::EquationsOfMotion;
use super::workspace::Workspace;

/// Slower air around a clamped aircraft does not stream, m/s.
const STILL_AIR: f64 = 1.0;

impl EquationsOfMotion {
    /// The air around O.
    pub fn air(&self, state: &[f64]) -> Air {
        self.tunnel_air.unwrap_or_else(|| Air::at(self.altitude(state)))
    }

    /// The first lifting strip that met the air from behind at the last evaluation. Where a clamped aircraft swings in
    /// still air none does: nothing lifts there.
    pub fn reversed_strip(&self, state: &[f64], controls: &Controls, workspace: &Workspace) -> Option<usize> {
        let in_still_air =
            || self.support() == Support::Clamped && self.airspeed(state, controls) < STILL_AIR;
        workspace.reversed_strip().filter(|_| !in_still_air())
    }
}

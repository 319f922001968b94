//! What lags behind the inputs at an instant: where surfaces are, and what engines give [theory: actuators.command].

use crate::devices::{Holding, Surface};

/// The state of actuators and engines; only that of those that lag is of account.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Acting {
    /// One per control.
    pub surfaces: Vec<Surface>,
    /// N, one per engine.
    pub thrusts: Vec<f64>,
}

/// What an actuator does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActuatorReading {
    /// Of the surface, rad/s.
    pub rate: f64,
    /// What holds it back.
    pub holding: Holding,
}

impl ActuatorReading {
    /// Free and at rest.
    pub(super) const AT_REST: ActuatorReading = ActuatorReading { rate: 0.0, holding: Holding::None };
}

impl Acting {
    /// Takes that of another instant, without allocating.
    pub fn take_from(&mut self, other: &Acting) {
        self.surfaces.copy_from_slice(&other.surfaces);
        self.thrusts.copy_from_slice(&other.thrusts);
    }
}

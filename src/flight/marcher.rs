//! What marching a plant needs besides the plant [theory: integration.stages, integration.error].

use crate::equations::Workspace;
use crate::plant::{Plant, Trim};

use super::amplitudes::Amplitudes;
use super::integrator::{ErrorScale, Integrator};

/// Scratch memory and integrator for one plant.
#[derive(Clone, Debug)]
pub(super) struct Marcher {
    pub workspace: Workspace,
    pub integrator: Integrator,
    /// At which the integrator's linear part was taken, m/s.
    pub reference_airspeed: f64,
}

impl Marcher {
    /// Marches about a trim of the plant with a relative tolerance.
    pub fn new(plant: &Plant, trim: &Trim, tolerance: f64) -> Self {
        let amplitudes = Amplitudes::new(plant.layout(), plant.free_modes(trim));
        Marcher {
            workspace: plant.workspace(),
            integrator: Integrator::new(plant.layout(), error_scale(plant, tolerance), amplitudes),
            reference_airspeed: 0.0,
        }
    }

    /// Takes the wake's linear part at the given airspeed.
    pub fn take_reference_airspeed(&mut self, plant: &Plant, airspeed: f64) {
        if airspeed != self.reference_airspeed {
            self.reference_airspeed = airspeed;
            self.integrator.set_inflow_linear_part(|linear| plant.write_wake_decay(airspeed, linear));
        }
    }
}

/// Magnitudes below which errors are absolute: 10 m and 1 m/s of O, 0.1 rad/s, 0.1 m and 1 m/s of the most
/// moving strip of any mode, 1 m/s of inflow [theory: integration.error].
fn error_scale(plant: &Plant, tolerance: f64) -> ErrorScale {
    let metre = plant.metre_of_displacement();
    ErrorScale { tolerance, floors: [10.0, 1.0, 1.0, 0.1, 0.1 * metre, metre, 1.0] }
}

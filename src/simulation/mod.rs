//! A flight in time: the thing a user steps.

mod airframe;
mod amplitudes;
mod course;
mod error;
mod exponential;
mod flight;
mod inputs;
mod integrator;
mod moment;
mod outputs;
mod point;
mod settings;
mod snapshot;
mod spectrum;
mod steering;

pub use crate::dynamics::Fidelity;
pub use error::SimulationError;
pub use flight::{LONGEST_STEP, Simulation, TrimPoint};
pub use inputs::Inputs;
pub use moment::{LATEST, resolution};
pub use outputs::{AirData, Deflection, Outputs};
pub use settings::{InputReference, ModeSelection, Settings};

#[cfg(test)]
mod tests;

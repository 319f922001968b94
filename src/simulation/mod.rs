//! A flight in time: the thing a user steps.

mod error;
mod flight;
mod inputs;
mod outputs;
mod settings;

pub use error::SimulationError;
pub use flight::{Simulation, TrimPoint};
pub use inputs::Inputs;
pub use outputs::{AirData, Deflection, Outputs};
pub use settings::{Fidelity, InputReference, ModeSelection, Settings};

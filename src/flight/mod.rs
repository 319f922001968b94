//! A flight in time: the thing a user steps.

mod diagonal;
mod encounter;
mod error;
mod evaluation;
mod exponential;
mod inputs;
mod integrator;
mod moment;
mod neighbours;
mod point;
mod section_loads;
mod settings;
mod simulation;
mod snapshot;
mod steering;

pub use error::SimulationError;
pub use inputs::Inputs;
pub use moment::{LATEST, LONGEST_STEP, resolution};
pub use neighbours::Neighbours;
pub use settings::{InputReference, Settings};
pub use simulation::Simulation;

#[cfg(test)]
mod tests;

//! A flight in time: the thing a user steps.

mod acting;
mod actions;
mod channels;
mod continuous;
pub mod continuous_settings;
mod continuous_states;
mod diagonal;
mod encounter;
mod error;
mod evaluation;
mod exponential;
mod inputs;
mod instant;
mod integrator;
mod moment;
mod neighbours;
mod per_part;
mod point;
mod reading;
mod section_loads;
mod sensor_settings;
mod sensors;
mod settings;
mod simulation;
mod snapshot;
mod steering;

pub use acting::ActuatorReading;
pub use channels::{Channel, NoiseKind};
pub use continuous::ContinuousModel;
pub use continuous_states::ContinuousState;
pub(crate) use encounter::{Way, way};
pub use error::SimulationError;
pub use inputs::Inputs;
pub use instant::{Instant, Part, Parts};
pub use moment::{LATEST, LONGEST_STEP, resolution};
pub use neighbours::Neighbours;
pub use per_part::PerPart;
pub use sensor_settings::SensorSettings;
pub use settings::{InputReference, Settings};
pub use simulation::Simulation;

#[cfg(test)]
mod tests;

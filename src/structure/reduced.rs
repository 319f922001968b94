//! The reduced model: everything that the flight needs of an aircraft, and nothing else.

use serde::{Deserialize, Serialize};

use crate::aircraft::{Aircraft, Flap, Support};

use super::StructureError;

/// How a mode behaves under reflection in the plane y = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ModeFamily {
    /// Its own mirror image.
    Symmetric,
    /// The negative of its mirror image.
    Antisymmetric,
    /// The structure has no mirror plane.
    Unsymmetric,
}

/// A natural mode of the clamped structure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mode {
    /// Its family.
    pub family: ModeFamily,
    /// ω at nominal stiffness, rad/s.
    pub angular_frequency: f64,
}

/// Mode shapes at one point of the structure, row-major 3 × n each.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModeShapes {
    /// Ψᵘ: displacement per generalised coordinate, body axes.
    pub translation: Vec<f64>,
    /// Ψᵠ: rotation per generalised coordinate, body axes.
    pub rotation: Vec<f64>,
}

/// An aircraft reduced to its modes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedModel {
    /// Name for people.
    pub name: String,
    /// m/s², down.
    pub gravity: f64,
    /// Free flight or wind tunnel.
    pub support: Support,
    /// Default number of inflow states.
    pub inflow_states: usize,
    /// Lowest frequency first.
    pub modes: Vec<Mode>,
    /// Engines, in the order of the inputs.
    pub engines: Vec<ReducedEngine>,
    /// Named points.
    pub stations: Vec<ReducedStation>,
}

/// An engine with the mode shapes at the point where its thrust acts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedEngine {
    /// Its input is `thrust_<name>`.
    pub name: String,
    /// Undeformed point of action, body axes, m.
    pub position: [f64; 3],
    /// Unit vector of positive thrust.
    pub direction: [f64; 3],
    /// At the point of action.
    pub shapes: ModeShapes,
}

/// A named point with the mode shapes there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedStation {
    /// Its outputs are `deflection.<name>.*`.
    pub name: String,
    /// Undeformed position, body axes, m.
    pub position: [f64; 3],
    /// Axis about which the twist counts.
    pub twist_axis: [f64; 3],
    /// On the elastic axis.
    pub shapes: ModeShapes,
}

impl ReducedModel {
    /// Reduces an aircraft to its `mode_count` lowest modes.
    ///
    /// # Errors
    /// When the structure has no such modes.
    pub fn new(aircraft: &Aircraft, mode_count: usize) -> Result<Self, StructureError> {
        todo!()
    }

    /// The bytes that go into the FMU's `resources/`.
    pub fn to_bytes(&self) -> Vec<u8> {
        todo!()
    }

    /// Reads what [`to_bytes`](Self::to_bytes) wrote.
    ///
    /// # Errors
    /// When the bytes are damaged, foreign or of another version.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, StructureError> {
        todo!()
    }

    /// 128-bit content hash of the model: equal models, equal hashes.
    pub fn content_hash(&self) -> u128 {
        todo!()
    }
}

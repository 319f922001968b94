//! Controls: what a pilot or a control law moves, by the names of the aircraft file.

use serde::{Deserialize, Serialize};

use super::limits::Bounds;

/// An input that turns flaps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Control {
    /// Name of its input; of its outputs `surface.<name>` and, with a role, `trim.<name>`.
    pub name: String,
    /// What it is, for people, for example "Elevator deflection".
    pub description: String,
    /// What a positive angle does, in words, for example "nose-down".
    pub positive: String,
    /// Angles that trims should stay within, rad.
    pub limits: Bounds,
    /// What it holds in trims.
    pub role: Option<TrimRole>,
}

/// About which axis a control holds a trimmed aircraft; at most one of an aircraft has each role.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TrimRole {
    /// About y, in every flight: an elevator's.
    Pitch,
    /// About x, where the aircraft would roll: the ailerons'.
    Roll,
    /// About z, where the aircraft would yaw: a rudder's.
    Yaw,
}

impl TrimRole {
    /// All roles.
    pub const ALL: [TrimRole; 3] = [TrimRole::Pitch, TrimRole::Roll, TrimRole::Yaw];
}

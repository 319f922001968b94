//! A natural mode: its family, its frequency, its shape at a point [theory: structure.modes, structure.families].

use serde::{Deserialize, Serialize};

/// How a mode behaves under reflection in the plane y = 0 [theory: structure.families].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ModeFamily {
    /// Its own mirror image.
    Symmetric,
    /// The negative of its mirror image.
    Antisymmetric,
    /// The structure has no mirror plane.
    Unsymmetric,
}

/// A mode of the clamped structure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mode {
    /// Its family.
    pub family: ModeFamily,
    /// ω at nominal stiffness, rad/s.
    pub angular_frequency: f64,
    /// Whether it belongs to lower modes: a basis that ends right before it has one of a pair and not the other.
    ///
    /// [theory: structure.pairs]
    pub completes_a_pair: bool,
    /// Whether it is no natural mode but the shape that static loads give beside those.
    ///
    /// [theory: load-modes.shapes]
    pub of_loads: bool,
}

/// Mode shapes at one point of the structure, row-major 3 × n each [theory: structure.shapes].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModeShapes {
    /// Ψᵘ: displacement per generalised coordinate, body axes.
    pub translation: Vec<f64>,
    /// Ψᵠ: rotation per generalised coordinate, body axes.
    pub rotation: Vec<f64>,
}

/// Which modes are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// Those of all families together.
    All,
    /// Symmetric ones.
    Symmetric,
}

impl std::fmt::Display for ModeKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ModeKind::All => "modes",
            ModeKind::Symmetric => "symmetric modes",
        })
    }
}

//! A natural mode: its family, its frequency, its shape at a point [theory: structure.modes, structure.families].

use nalgebra::{DMatrix, Vector3};
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

impl ModeShapes {
    /// Those of its rows Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z that motion in the mirror plane has.
    pub(crate) const IN_PLANE: [usize; 3] = [0, 2, 4];

    /// Those that it has not.
    pub(crate) const ACROSS: [usize; 3] = [1, 3, 5];

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.translation.len() / 3
    }

    /// The rows Ψᵘ_x, Ψᵘ_y, Ψᵘ_z.
    pub fn translation_rows(&self) -> [&[f64]; 3] {
        rows(&self.translation)
    }

    /// The rows Ψᵠ_x, Ψᵠ_y, Ψᵠ_z.
    pub fn rotation_rows(&self) -> [&[f64]; 3] {
        rows(&self.rotation)
    }

    /// One of the six rows, those of displacement first.
    pub fn row(&self, row: usize) -> &[f64] {
        if row < 3 { self.translation_rows()[row] } else { self.rotation_rows()[row - 3] }
    }

    /// The same to be changed.
    pub(crate) fn row_mut(&mut self, row: usize) -> &mut [f64] {
        let n = self.modes();
        let (matrix, axis) =
            if row < 3 { (&mut self.translation, row) } else { (&mut self.rotation, row - 3) };
        &mut matrix[axis * n..][..n]
    }

    /// Displacement and rotation of one mode.
    pub fn of_mode(&self, mode: usize) -> [Vector3<f64>; 2] {
        [self.translation_rows(), self.rotation_rows()].map(|rows| Vector3::from(rows.map(|row| row[mode])))
    }

    /// Those of a choice of the modes.
    pub(super) fn select(&self, chosen: &[usize]) -> Self {
        let of_chosen = |rows: [&[f64]; 3]| {
            rows.into_iter().flat_map(|row| chosen.iter().map(move |&mode| row[mode])).collect()
        };
        ModeShapes {
            translation: of_chosen(self.translation_rows()),
            rotation: of_chosen(self.rotation_rows()),
        }
    }

    /// Those of coordinates with such shares in these, a column each.
    pub(super) fn combine(&self, shares: &DMatrix<f64>) -> Self {
        let combined = |rows: [&[f64]; 3]| {
            let sum =
                |row: &[f64], column: usize| shares.column(column).iter().zip(row).map(|(s, r)| s * r).sum();
            rows.into_iter().flat_map(|row| (0..shares.ncols()).map(move |column| sum(row, column))).collect()
        };
        ModeShapes {
            translation: combined(self.translation_rows()),
            rotation: combined(self.rotation_rows()),
        }
    }
}

/// The three rows of a matrix.
fn rows(matrix: &[f64]) -> [&[f64]; 3] {
    let n = matrix.len() / 3;
    [0, 1, 2].map(|axis| &matrix[axis * n..][..n])
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

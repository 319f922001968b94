//! The apparent mass of all strips as one symmetric product of rows [4.1; physics.md §4].
//!
//! πρb²Δy [(G_w − dG_Ω)ᵀ(G_m − dG_Ω) + (b²/8) G_ΩᵀG_Ω], summed over strips, is XᵀY with two rows per strip.
//! Rows are cut into lanes of four numbers and padded, so that the product runs on fixed-size blocks; each
//! entry is summed in the order of the strips whatever the width of the machine's vectors.

use nalgebra::Vector3;

/// Numbers that are computed side by side.
pub const LANES: usize = 4;

/// A group of numbers that are computed side by side.
pub type Lanes = [f64; LANES];

/// Lanes of the rigid-body part of a row: v and ω, padded.
const RIGID_LANES: usize = 2;

/// The rows X and Y of all strips.
#[derive(Clone, Debug)]
pub struct ApparentMass {
    modes: usize,
    /// Lanes per row.
    width: usize,
    /// Whether X and Y are the same but for their weights.
    symmetric: bool,
    rows: Vec<Lanes>,
    weighted: Vec<Lanes>,
}

impl ApparentMass {
    /// Room for the rows of `strips` strips.
    pub fn new(strips: usize, modes: usize, symmetric: bool) -> Self {
        let width = RIGID_LANES + modes.div_ceil(LANES);
        let rows = vec![[0.0; LANES]; 2 * strips * width];
        ApparentMass { modes, width, symmetric, weighted: rows.clone(), rows }
    }

    /// Has `write` fill the rows G_w − dG_Ω, G_Ω and, where it differs from the first, G_m − dG_Ω of a strip;
    /// `mass` is πρb²Δy, `inertia` b²/8 times that.
    pub fn add(
        &mut self,
        strip: usize,
        mass: f64,
        inertia: f64,
        write: impl FnOnce(&mut [Lanes], &mut [Lanes], Option<&mut [Lanes]>),
    ) {
        let range = 2 * strip * self.width..2 * (strip + 1) * self.width;
        let (heave, pitch) = self.rows[range.clone()].split_at_mut(self.width);
        let (weighted_heave, weighted_pitch) = self.weighted[range].split_at_mut(self.width);
        if self.symmetric {
            write(heave, pitch, None);
            weighted_heave.copy_from_slice(heave);
        } else {
            write(heave, pitch, Some(weighted_heave));
        }
        scale(weighted_heave, mass);
        for (weighted, pitch) in weighted_pitch.iter_mut().zip(pitch) {
            *weighted = pitch.map(|value| value * inertia);
        }
    }

    /// Fills a row: direction of a force, its moment about O, its work on each generalised coordinate.
    pub fn write_row(
        row: &mut [Lanes],
        force: &Vector3<f64>,
        moment: &Vector3<f64>,
        work: impl Iterator<Item = Lanes>,
    ) {
        row[0] = [force.x, force.y, force.z, moment.x];
        row[1] = [moment.y, moment.z, 0.0, 0.0];
        for (lanes, work) in row[RIGID_LANES..].iter_mut().zip(work) {
            *lanes = work;
        }
    }

    /// Adds XᵀY to a row-major mass matrix on ν; of a symmetric one only the lower triangle.
    pub fn add_to(&self, mass: &mut [f64]) {
        for row_block in 0..self.width {
            let columns = if self.symmetric { row_block + 1 } else { self.width };
            for column_block in 0..columns {
                let block = self.block(row_block, column_block);
                self.scatter(row_block, column_block, &block, mass);
            }
        }
    }

    /// One 4 × 4 block of XᵀY.
    fn block(&self, row_block: usize, column_block: usize) -> [Lanes; LANES] {
        let mut sums = [[0.0; LANES]; LANES];
        for (row, weighted) in self.rows.chunks_exact(self.width).zip(self.weighted.chunks_exact(self.width))
        {
            let (x, y) = (&row[row_block], &weighted[column_block]);
            for (sums, x) in sums.iter_mut().zip(x) {
                for (sum, y) in sums.iter_mut().zip(y) {
                    *sum += x * y;
                }
            }
        }
        sums
    }

    /// Adds a block to the matrix, leaving out the padding.
    fn scatter(&self, row_block: usize, column_block: usize, block: &[Lanes; LANES], mass: &mut [f64]) {
        let size = 6 + self.modes;
        for (i, sums) in block.iter().enumerate() {
            for (j, sum) in sums.iter().enumerate() {
                if let (Some(row), Some(column)) =
                    (self.unknown(row_block * LANES + i), self.unknown(column_block * LANES + j))
                {
                    mass[row * size + column] += sum;
                }
            }
        }
    }

    /// The component of ν at a place in a padded row.
    fn unknown(&self, place: usize) -> Option<usize> {
        match place {
            0..6 => Some(place),
            6..8 => None,
            _ => (place - 2 < 6 + self.modes).then_some(place - 2),
        }
    }
}

/// A row of numbers as whole lanes, the rest zero.
pub fn padded(row: &[f64]) -> impl Iterator<Item = Lanes> {
    row.chunks(LANES).map(|chunk| std::array::from_fn(|i| chunk.get(i).copied().unwrap_or(0.0)))
}

fn scale(row: &mut [Lanes], factor: f64) {
    for lanes in row {
        *lanes = lanes.map(|value| value * factor);
    }
}
